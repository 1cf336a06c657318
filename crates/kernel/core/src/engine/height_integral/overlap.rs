//! Integrals over heights with any density, and over exponential ones.

use std::sync::{Arc, LazyLock, OnceLock};

use asperity_quadrature::{Density, Moments, Overlap, OverlapSeries, QuadratureError, Weight};

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
    overlap: Arc<Overlap>,
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

/// exp(-ζ) on ζ ≥ 0.
pub(super) static EXPONENTIAL: LazyLock<Result<Arc<Weight>, QuadratureError>> =
    LazyLock::new(|| {
        let ln = |z: f64| if z < 0.0 { f64::NEG_INFINITY } else { -z };
        Weight::new("the exponential density", ln, (0.0, f64::INFINITY), &[], 0.0).map(Arc::new)
    });

/// Tolerance of an integral over its slope's, a difference of two integrals far below 0: a
/// separation of a thousand σ_z takes away as much.
const FINER: f64 = 1e-3;

/// Exponential heights: for s ≥ 0 one integral serves all s, I(s) = I(0) exp(-s).
#[derive(Debug)]
pub(super) struct Exponential {
    density: Density,
    scale: f64,
    pub(super) below: OverlapIntegral,
    /// For slopes that are small differences of the values of `below`.
    finer: OnceLock<OverlapIntegral>,
    above: OnceLock<Result<Moments, QuadratureError>>,
    tolerance: f64,
}

impl Exponential {
    pub(super) fn new(density: Density, scale: f64, tolerance: f64) -> Self {
        let below = OverlapIntegral::new(Overlap::new(density.clone(), scale, tolerance));
        let (finer, above) = (OnceLock::new(), OnceLock::new());
        Self { density, scale, below, finer, above, tolerance }
    }

    pub(super) fn at(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let weight = EXPONENTIAL.as_ref().map_err(Clone::clone)?;
        if s < 0.0 {
            return self.below(weight, s, extent);
        }
        let at_zero = self.above.get_or_init(|| self.below.overlap.at(weight, 0.0, false));
        let Moments { value, sizes: [size, _], ln_scale, error, .. } =
            *at_zero.as_ref().map_err(Clone::clone)?;
        Ok(Moments { value, slope: value, sizes: [size; 2], ln_scale: ln_scale - s, error })
    }

    fn below(
        &self,
        weight: &Arc<Weight>,
        s: f64,
        extent: Extent,
    ) -> Result<Moments, QuadratureError> {
        if !extent.slope || self.density.knows_slope() {
            return self.below.at(weight, s, extent);
        }
        let found = self.by_parts(&self.below, weight, s, extent)?;
        if found.slope_within(s, self.tolerance).is_ok() {
            return Ok(found);
        }
        let finer = || Overlap::new(self.density.clone(), self.scale, FINER * self.tolerance);
        let finer = self.finer.get_or_init(|| OverlapIntegral::new(finer()));
        self.by_parts(finer, weight, s, extent)
    }

    /// The slope by parts: it includes the lowest asperity, at -s.
    pub(super) fn by_parts(
        &self,
        integral: &OverlapIntegral,
        weight: &Arc<Weight>,
        s: f64,
        extent: Extent,
    ) -> Result<Moments, QuadratureError> {
        let found = integral.at(weight, s, Extent { slope: false, ..extent })?;
        let lowest = self.density.value_at(-s / self.scale)? * (-found.ln_scale).exp();
        let sizes = [found.sizes[0], found.sizes[0] + lowest.abs()];
        Ok(Moments { slope: found.value - lowest, sizes, ..found })
    }
}
