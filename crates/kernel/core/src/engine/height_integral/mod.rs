//! I(s) = ∫ q(w) g(d + w) dw, d = s σ_z, for each kind of heights g, and the units of q and its
//! onset.

mod overlap;
mod slope;

use std::sync::OnceLock;

use asperity_quadrature::{
    ArrayAccuracy, Density, Moments, Overlap, QuadratureError, ScaledIntegral, ShiftedGaussian,
};

use crate::error::require;
use crate::{ContactError, HeightDistribution, Law, Quantity, Scene};
use overlap::{EXPONENTIAL, Exponential, Extent, Other, OverlapIntegral};

use slope::FINER_BELOW;
pub(crate) use slope::{SLOPES_CANCEL, with_slope_within};

/// Range of scales w_c/σ_z: powers of others overflow f64, and no surface has them.
const SCALES: std::ops::RangeInclusive<f64> = 1e-100..=1e100;

/// The units of a law on a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LawUnits {
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// Interference unit over σ_z.
    pub(crate) scale: f64,
    /// The onset of the law.
    pub(crate) onset: Onset,
}

impl LawUnits {
    /// Refuses scenes whose numbers overflow f64.
    pub(crate) fn new(base: Quantity, law: &Law, scene: &Scene) -> Result<Self, ContactError> {
        let height_std = scene.surface.asperity_height_std;
        let factor = scene.asperities() * law.value_unit;
        let scale = law.interference_unit / height_std;
        // Tangents are divided by σ_z.
        let held = |x: &f64| *x > 0.0 && x.is_finite();
        if let Some(scale) = [factor, factor / height_std].into_iter().find(|x| !held(x)) {
            return Err(ContactError::Scale { quantity: base, scale });
        }
        let (onset, field) =
            (law.onset * scale, "the law's interference unit over asperity_height_std");
        let holds = SCALES.contains(&scale) && onset.is_finite();
        require(holds, field, scale, "1e-100 to 1e100")?;
        Ok(Self { factor, scale, onset: Onset(onset) })
    }
}

/// The onset w₀/σ_z of a law: below w = 0 if adhesion holds an asperity that is pulled away, above
/// 0 if the first contacts are lost.
///
/// With x counted from the onset w₀, and s too, the integral is the usual one:
/// ```text
/// ∫ q(w) g(d + w) dw = ∫₀^∞ q(w₀ + t) g(d + w₀ + t) dt
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Onset(pub(crate) f64);

impl Onset {
    /// Whether the onset is not at w = 0.
    #[inline]
    pub(crate) fn is_nonzero(self) -> bool {
        self.0 != 0.0
    }

    /// A separation, counted from the onset.
    #[inline]
    pub(crate) fn shifted(self, s: f64) -> f64 {
        s + self.0
    }

    /// Bound on the rounding of a separation counted from the onset.
    fn rounding(self, s: f64) -> f64 {
        f64::EPSILON * (self.shifted(s).abs() + 2.0 * self.0.abs())
    }

    /// The integrals at [`shifted`](Self::shifted), slope included, with the effect of its rounding
    /// in the bound.
    #[inline]
    pub(crate) fn widened(self, s: f64, mut moments: Moments) -> Moments {
        if self.is_nonzero() && moments.sizes[0] > 0.0 {
            // The slope's own slope is one more power of s.
            moments.error += self.rounding(s) * (moments.sizes[1] / moments.sizes[0] + 1.0);
        }
        moments
    }
}

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
        let over = match scene.heights.sampled(height_std) {
            Some((heights, height_std_there)) => {
                let unit = interference_unit / (height_std / height_std_there);
                HeightKind::Other(Other {
                    integral: OverlapIntegral::new(Overlap::new(density, unit, tolerance)),
                    height_std: height_std_there,
                    heights: heights.clone(),
                    tolerance,
                })
            }
            None if matches!(scene.heights, HeightDistribution::Exponential) => {
                HeightKind::Exponential(Exponential::new(density, scale, tolerance))
            }
            None => {
                let integral = ShiftedGaussian::new(density.clone(), scale, tolerance);
                let finer = OnceLock::new();
                HeightKind::Gaussian(Gaussian { integral, density, finer, scale, tolerance })
            }
        };
        Self { onset: Onset(law.onset * scale), over }
    }

    fn gaussian(&self) -> Option<&ShiftedGaussian> {
        match &self.over {
            HeightKind::Gaussian(Gaussian { integral, .. }) => Some(integral),
            HeightKind::Exponential(_) | HeightKind::Other(_) => None,
        }
    }

    /// Terms of the polynomial for s; `None` where there is none.
    pub(crate) fn terms(&self, s: f64) -> Result<Option<usize>, QuadratureError> {
        self.gaussian().map(|integral| integral.terms(self.onset.shifted(s))).transpose()
    }

    /// Number of samples of the density for rules.
    pub(crate) fn samples(&self) -> usize {
        self.gaussian().map_or(0, ShiftedGaussian::evaluations)
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
        column: ScaledIntegral,
        out: &mut [f64],
    ) -> Option<ArrayAccuracy> {
        self.gaussian()?.fill(s, ScaledIntegral { shift: self.onset.0, ..column }, out).ok()
    }

    /// [`value`](Self::value), or with `slopes` [`at`](Self::at), at each s into `out`, which is as
    /// long: `None` for heights where that saves nothing, or if any s is refused.
    pub(crate) fn run(&self, s: &[f64], slopes: bool, out: &mut [Moments]) -> Option<()> {
        self.gaussian()?;
        for (s, out) in s.iter().zip(out) {
            *out = if slopes { self.at(*s) } else { self.value(*s) }.ok()?;
        }
        Some(())
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
            HeightKind::Gaussian(_) => self.rough(s),
            HeightKind::Other(_) | HeightKind::Exponential(_) => self.answer(s, extent),
        };
        found.or_else(|_| Ok(Moments { slope: f64::NAN, ..self.value(s)? }))
    }

    /// I(s) to the tolerance, and -dI/ds, which over Gaussian heights may miss it far below 0, from
    /// what is prepared for many s.
    pub(crate) fn rough(&self, s: f64) -> Result<Moments, QuadratureError> {
        match &self.over {
            HeightKind::Gaussian(heights) => {
                let found = heights.integral.at(self.onset.shifted(s))?;
                Ok(self.onset.widened(s, found))
            }
            HeightKind::Exponential(_) | HeightKind::Other(_) => self.at(s),
        }
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

/// The integral over Gaussian heights.
#[derive(Debug)]
struct Gaussian {
    integral: ShiftedGaussian,
    density: Density,
    /// The density for slopes far below 0.
    finer: OnceLock<Density>,
    scale: f64,
    tolerance: f64,
}

impl Gaussian {
    #[inline(always)]
    fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let found = self.integral.at(s)?;
        Ok(with_slope_within(found, |to| self.finer(to), (self.scale, s), self.tolerance))
    }

    /// The density to a tolerance: one for all slopes but the deepest is made once.
    fn finer(&self, tolerance: f64) -> Density {
        let usual = FINER_BELOW * self.tolerance;
        match tolerance < usual {
            true => self.density.finer(tolerance),
            false => self.finer.get_or_init(|| self.density.finer(usual)).clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Heights, Interface, Power, Surface};

    #[derive(Debug)]
    struct Normal;

    impl Heights for Normal {
        fn name(&self) -> &str {
            "normal"
        }

        fn ln_density(&self, z: f64) -> f64 {
            -0.5 * (z * z + std::f64::consts::TAU.ln())
        }

        fn support(&self) -> (f64, f64) {
            (f64::NEG_INFINITY, f64::INFINITY)
        }
    }

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
        let normal = HeightDistribution::other(Normal);
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
