//! An integral over heights with any density.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::{Moments, Overlap, OverlapSeries, QuadratureError, Weight};

use crate::OtherHeights;

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

/// Any other heights: in metres, or in units of σ_z.
#[derive(Debug)]
pub(super) struct Other {
    pub(super) integral: OverlapIntegral,
    /// σ_z in the unit of the heights.
    pub(super) height_std: f64,
    pub(super) heights: Arc<OtherHeights>,
    pub(super) tolerance: f64,
}

impl Other {
    pub(super) fn at(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let found = self.integral.at(&self.heights.weight()?, s * self.height_std, extent)?;
        let error = found.error + self.heights.heights().error();
        // Far out, the logarithm of a density that falls as steeply as exp(-z^30) has no digits.
        if error.is_infinite() {
            let (asked, evaluations) = (self.tolerance, 0);
            return Err(QuadratureError::NotConverged { reached: error, asked, evaluations });
        }
        Ok(Moments {
            slope: found.slope * self.height_std,
            sizes: [found.sizes[0], found.sizes[1] * self.height_std],
            error,
            ..found
        })
    }
}
