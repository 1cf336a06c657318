//! From a law's numbers to a scene's: its units, and where it begins.

use asperity_quadrature::Moments;

use crate::{ContactError, Law, Quantity, Scene};

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
        match [factor, factor / height_std].into_iter().find(|x| !held(x)) {
            Some(scale) => Err(ContactError::Scale { quantity: base, scale }),
            None if SCALES.contains(&scale) && (law.onset * scale).is_finite() => {
                Ok(Self { factor, scale, onset: Onset(law.onset * scale) })
            }
            None => Err(ContactError::OutOfRange {
                field: "the law's interference unit over asperity_height_std",
                value: scale,
                required: "1e-100 to 1e100",
            }),
        }
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
