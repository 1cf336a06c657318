//! I(s) = ∫ q(w) g(d + w) dw, d = s σ_z, for each kind of heights g.

use std::sync::{Arc, LazyLock, OnceLock};

use asperity_quadrature::{
    Cells, Column, ColumnAccuracy, Curvature, Density, Moments, Nearby, Overlap, QuadratureError,
    ShiftedGaussian, Weight,
};

use crate::engine::onset::Onset;
use crate::heights::OtherHeights;
use crate::{HeightDistribution, Law, Scene};

/// The integral of one density over one kind of heights, for all s: I(s), and -dI/ds by the
/// dimensionless s.
#[derive(Debug)]
pub(crate) struct HeightIntegral {
    /// The onset of the density.
    onset: Onset,
    over: HeightKind,
}

/// The same, with s counted from the onset of the density.
#[derive(Debug)]
enum HeightKind {
    Gaussian(Gaussian),
    Exponential(Exponential),
    Other(Other),
}

impl HeightIntegral {
    /// Of a density over the x of a law.
    pub(crate) fn new(density: Density, law: &Law, scene: &Scene, tolerance: f64) -> Self {
        let height_std = scene.surface.asperity_height_std;
        let interference_unit = law.interference_unit;
        let scale = interference_unit / height_std;
        let over = match &scene.heights {
            HeightDistribution::Gaussian => {
                let integral = ShiftedGaussian::new(density.clone(), scale, tolerance);
                HeightKind::Gaussian(Gaussian { integral, density, scale, tolerance })
            }
            HeightDistribution::Exponential => HeightKind::Exponential(Exponential {
                density: density.clone(),
                scale,
                below: OverlapIntegral::new(Overlap::new(density, scale, tolerance)),
                finer: OnceLock::new(),
                above: OnceLock::new(),
                tolerance,
            }),
            HeightDistribution::Weibull(heights) => HeightKind::Other(Other {
                integral: OverlapIntegral::new(Overlap::new(density, scale, tolerance)),
                height_std: 1.0,
                error: heights.sampled.heights().error(),
                heights: heights.sampled.clone(),
                tolerance,
            }),
            HeightDistribution::Other(heights) => HeightKind::Other(Other {
                integral: OverlapIntegral::new(Overlap::new(density, interference_unit, tolerance)),
                height_std,
                heights: heights.clone(),
                tolerance,
                error: heights.heights().error(),
            }),
        };
        Self { onset: Onset(law.onset * scale), over }
    }

    /// Terms of the polynomial for s; `None` where there is none.
    pub(crate) fn terms(&self, s: f64) -> Result<Option<usize>, QuadratureError> {
        match &self.over {
            HeightKind::Gaussian(heights) => {
                heights.integral.terms(self.onset.shifted(s)).map(Some)
            }
            _ => Ok(None),
        }
    }

    /// Number of samples of the density for rules.
    pub(crate) fn samples(&self) -> usize {
        match &self.over {
            HeightKind::Gaussian(heights) => heights.integral.evaluations(),
            _ => 0,
        }
    }

    /// I(s), without the slope if that saves work.
    #[inline(always)]
    pub(crate) fn value(&self, s: f64) -> Result<Moments, QuadratureError> {
        match &self.over {
            HeightKind::Gaussian(heights) if !self.onset.is_nonzero() => heights.integral.value(s),
            _ => self.answer(s, Extent { slope: false, many: true }),
        }
    }

    /// Plain numbers at each s, with its onset as the shift of the column; `None` for other than
    /// Gaussian heights, or if any s is refused.
    pub(crate) fn fill(
        &self,
        s: &[f64],
        column: Column,
        out: &mut [f64],
    ) -> Option<ColumnAccuracy> {
        let HeightKind::Gaussian(Gaussian { integral, .. }) = &self.over else { return None };
        integral.fill(s, Column { shift: self.onset.0, ..column }, out).ok()
    }

    /// [`value`](Self::value), or with `slopes` [`at`](Self::at), at each s into `out`, which is as
    /// long: `None` for heights where that saves nothing, or if any s is refused.
    pub(crate) fn run(&self, s: &[f64], slopes: bool, out: &mut [Moments]) -> Option<()> {
        let HeightKind::Gaussian(_) = &self.over else { return None };
        for (s, out) in s.iter().zip(out) {
            *out = if slopes { self.at(*s) } else { self.value(*s) }.ok()?;
        }
        Some(())
    }

    /// d²I/ds², for Gaussian heights.
    pub(crate) fn curvature(&self, s: f64) -> Option<Result<Curvature, QuadratureError>> {
        let HeightKind::Gaussian(Gaussian { integral, .. }) = &self.over else { return None };
        let found = integral.curvature(self.onset.shifted(s));
        Some(found.map(|found| self.onset.widened_curvature(s, found)))
    }

    /// I(s) and -dI/ds, from what is prepared for many s.
    #[inline(always)]
    pub(crate) fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        match &self.over {
            HeightKind::Gaussian(heights) if !self.onset.is_nonzero() => heights.at(s),
            _ => self.answer(s, Extent { slope: true, many: true }),
        }
    }

    /// I(s) to the tolerance, and -dI/ds with whatever error it has, as the bound is relative to
    /// the sizes: to guide a search, prepared for `many` s. Without a slope (NaN), signs and bounds
    /// remain.
    pub(crate) fn guide(&self, s: f64, many: bool) -> Result<Moments, QuadratureError> {
        let extent = Extent { slope: true, many };
        let found = match &self.over {
            HeightKind::Exponential(integral) if self.onset.shifted(s) < 0.0 => {
                let weight = EXPONENTIAL.as_ref().map_err(Clone::clone)?;
                let found =
                    integral.by_parts(&integral.below, weight, self.onset.shifted(s), extent);
                found.map(|found| self.onset.widened(s, found))
            }
            _ => self.answer(s, extent),
        };
        found.or_else(|_| Ok(Moments { slope: f64::NAN, ..self.value(s)? }))
    }

    /// I(s), and -dI/ds if `slope` is set, without preparation for other s.
    pub(crate) fn once(&self, s: f64, slope: bool) -> Result<Moments, QuadratureError> {
        self.answer(s, Extent { slope, many: false })
    }

    #[inline(never)]
    fn answer(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let seen = self.onset.shifted(s);
        let integrate = |extent: Extent| match &self.over {
            HeightKind::Gaussian(heights) if extent.slope => heights.at(seen),
            HeightKind::Gaussian(heights) => heights.integral.at(seen),
            HeightKind::Exponential(integral) => integral.at(seen, extent),
            HeightKind::Other(integral) => integral.at(seen, extent),
        };
        if extent.slope || !self.onset.is_nonzero() {
            return Ok(self.onset.widened(s, integrate(extent)?));
        }
        // The slope bounds the effect of a rounded s on the value: a rough one suffices.
        let found = integrate(Extent { slope: true, ..extent });
        let found = found.or_else(|_| integrate(Extent { slope: false, many: false }))?;
        Ok(self.onset.widened(s, found))
    }
}

/// The extent of a request to an integral.
#[derive(Debug, Clone, Copy)]
struct Extent {
    slope: bool,
    /// Whether requests at other s will follow.
    many: bool,
}

/// Below this s a slope is a small difference of large integrals: with a finer law and a finer
/// integral by [`FINER_BELOW`], enough digits are left down to about s = -64.
pub(crate) const SLOPES_CANCEL: f64 = -8.0;
const FINER_BELOW: f64 = 0.01;
/// No law that is sampled is better than this.
const FINEST_LAW: f64 = 1e-13;

/// `found`, an integral at s with its slope, or a finer integral if its slope misses the tolerance
/// and the finer one meets it.
#[inline(always)]
pub(crate) fn with_slope_within(
    found: Moments,
    density: impl Fn() -> Density,
    (scale, s): (f64, f64),
    tolerance: f64,
) -> Moments {
    if s >= SLOPES_CANCEL || found.slope_within(s, tolerance).is_ok() {
        return found;
    }
    finer(&density(), (scale, s), tolerance).unwrap_or(found)
}

#[cold]
fn finer(density: &Density, (scale, s): (f64, f64), tolerance: f64) -> Option<Moments> {
    let finer = FINER_BELOW * tolerance;
    let made = Nearby::new(&density.finer(finer), scale, s, finer).map(|made| made.at(s));
    // Farther down, derivatives of the law are averaged instead: those of samples err by as much
    // more than the samples as s is deep.
    let derived = || {
        let weight = GAUSSIAN.as_ref().map_err(Clone::clone)?;
        let finer = (0.1 * tolerance / (1.0 - s)).max(FINEST_LAW);
        let own = if density.knows_slope() { 0.0 } else { finer * (1.0 - s) };
        let made = Overlap::new(density.finer(finer), scale, tolerance).at(weight, s, true)?;
        Ok::<_, QuadratureError>(Moments { error: made.error + own, ..made })
    };
    let within = |made: &Moments| made.slope_within(s, tolerance).is_ok();
    made.ok().filter(within).or_else(|| derived().ok().filter(within))
}

/// exp(-z²/2)/√(2π).
static GAUSSIAN: LazyLock<Result<Arc<Weight>, QuadratureError>> = LazyLock::new(|| {
    let ln = |z: f64| -0.5 * z * z - 0.5 * (2.0 * std::f64::consts::PI).ln();
    let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
    Weight::new("the Gaussian density", ln, everywhere, &[], 0.0).map(Arc::new)
});

/// The integral over Gaussian heights.
#[derive(Debug)]
struct Gaussian {
    integral: ShiftedGaussian,
    density: Density,
    scale: f64,
    tolerance: f64,
}

impl Gaussian {
    #[inline(always)]
    fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let found = self.integral.at(s)?;
        let Self { density, scale, tolerance, .. } = self;
        Ok(with_slope_within(found, || density.clone(), (*scale, s), *tolerance))
    }
}

/// An integral over heights with any density, directly or by its cells.
#[derive(Debug)]
pub(crate) struct OverlapIntegral {
    overlap: Arc<Overlap>,
    cells: OnceLock<Cells>,
}

impl OverlapIntegral {
    fn new(overlap: Overlap) -> Self {
        Self { overlap: Arc::new(overlap), cells: OnceLock::new() }
    }

    fn at(&self, weight: &Arc<Weight>, d: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let Extent { slope, many } = extent;
        if many {
            let make = || Cells::new(self.overlap.clone(), weight.clone());
            self.cells.get_or_init(make).at(d, slope)
        } else {
            self.overlap.at(weight, d, slope)
        }
    }
}

/// exp(-ζ) on ζ ≥ 0.
static EXPONENTIAL: LazyLock<Result<Arc<Weight>, QuadratureError>> = LazyLock::new(|| {
    let ln = |z: f64| if z < 0.0 { f64::NEG_INFINITY } else { -z };
    Weight::new("the exponential density", ln, (0.0, f64::INFINITY), &[], 0.0).map(Arc::new)
});

/// Tolerance of an integral over that of its slope, a difference of two integrals far below 0: a
/// separation of a thousand σ_z takes away as much.
const FINER: f64 = 1e-3;

/// Exponential heights: for s ≥ 0 one integral serves all s, I(s) = I(0) exp(-s).
#[derive(Debug)]
pub(crate) struct Exponential {
    density: Density,
    scale: f64,
    below: OverlapIntegral,
    /// For slopes that are small differences of the values of `below`.
    finer: OnceLock<OverlapIntegral>,
    above: OnceLock<Result<Moments, QuadratureError>>,
    tolerance: f64,
}

impl Exponential {
    fn at(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
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
    fn by_parts(
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

/// Any other heights: in metres, or in units of σ_z.
#[derive(Debug)]
pub(crate) struct Other {
    integral: OverlapIntegral,
    /// σ_z in the unit of the heights.
    height_std: f64,
    heights: Arc<OtherHeights>,
    error: f64,
    tolerance: f64,
}

impl Other {
    fn at(&self, s: f64, extent: Extent) -> Result<Moments, QuadratureError> {
        let found = self.integral.at(&self.heights.weight()?, s * self.height_std, extent)?;
        let error = found.error + self.error;
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

#[cfg(feature = "statrs")]
#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, Power, StandardisedHeights, Surface};
    use statrs::distribution::Normal;

    /// ∫ t g(s + t) dt far below is the mean of z - s.
    fn linear(heights: HeightDistribution, s: f64) -> [Moments; 2] {
        let law = Law::in_units(1.0, 1.0).elastic(0.0..f64::INFINITY, [Power::new(1.0, 1.0)]);
        let (interface, surface) = (Interface::new(1.0, 0.3, 1.0), Surface::new(1.0, 1.0, 1.0));
        let mut scene = Scene::new(interface, surface, 1.0);
        scene.heights = heights;
        let integral = HeightIntegral::new(law.density(), &law, &scene, 1e-13);
        [integral.at(s).unwrap(), integral.once(s, true).unwrap()]
    }

    #[test]
    fn no_heights_are_missed_from_far_below_them() {
        let normal = Normal::new(0.0, 1.0).unwrap();
        let normal = StandardisedHeights::new("normal", normal, 1.0).unwrap();
        let normal = HeightDistribution::other(normal);
        for s in [-10.0, -100.0, -1e3, -1e4, -1e6] {
            for (heights, mean) in [(&normal, 0.0), (&HeightDistribution::Exponential, 1.0)] {
                for found in linear(heights.clone(), s) {
                    let scale = found.ln_scale.exp();
                    let error = (found.value * scale / (mean - s) - 1.0).abs();
                    assert!(error < found.error && found.error < 1e-12, "{s}: {found:?}");
                    assert!((found.slope * scale - 1.0).abs() < 1e-13, "{s}: {found:?}");
                }
            }
        }
    }
}
