//! An integral over heights with any density.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::{Moments, Overlap, OverlapSeries, QuadratureError, Weight};

/// The extent of a request to an integral.
#[derive(Debug, Clone, Copy)]
pub(super) struct Extent {
    pub(super) slope: bool,
    /// Whether requests at other s will follow.
    pub(super) many: bool,
}

/// An integral over heights with any density, directly or by its cells.
#[derive(Debug)]
pub(super) struct OverlapIntegral {
    pub(super) overlap: Arc<Overlap>,
    cells: OnceLock<OverlapSeries>,
}

impl OverlapIntegral {
    pub(super) fn new(overlap: Overlap) -> Self {
        Self { overlap: Arc::new(overlap), cells: OnceLock::new() }
    }

    pub(super) fn at(
        &self,
        weight: &Arc<Weight>,
        d: f64,
        extent: Extent,
    ) -> Result<Moments, QuadratureError> {
        let Extent { slope, many } = extent;
        if many {
            let make = || OverlapSeries::new(self.overlap.clone(), weight.clone());
            self.cells.get_or_init(make).at(d, slope)
        } else {
            self.overlap.at(weight, d, slope)
        }
    }
}
