//! Skewed heights: the Weibull density with a given skewness.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::error::require;
use crate::heights::other::OtherHeights;
use crate::{ContactError, Heights};

/// 1/k at the ends of [`WeibullHeights::SKEWNESS`].
const SHAPES: [f64; 2] = [1.0 / 64.0, 1.0];

/// Weibull heights of a given skewness, with mean 0 and the standard deviation of the
/// scene, as for Gaussian heights; separations are measured from the mean.
///
/// ```text
/// φ(ζ) = s k t^(k-1) exp(-t^k),  t = m + s ζ ≥ 0,  m = Γ(1 + 1/k),  s² = Γ(1 + 2/k) - m²
/// skewness = (Γ(1 + 3/k) - 3 m s² - m³)/s³
/// ```
///
/// A one-parameter description of worn or machined surfaces: skewness below 0 for worn peaks,
/// above 0 for sharp peaks; at 2 the heights are exponential. Published for asymmetric asperity
/// heights \[recalled from memory\]; other densities of the same skewness differ in the upper tail,
/// which determines the contact. Error bounds refer to the density with [`shape`](Self::shape),
/// whose skewness equals the requested one to 1e-12. The asperities have this skewness, not
/// the Ssk of the surface, which includes the valleys.
///
/// ```
/// use asperity_core::WeibullHeights;
///
/// assert!((WeibullHeights::new(2.0)?.shape() - 1.0).abs() < 1e-10);
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Skewness")]
pub struct WeibullHeights {
    skewness: f64,
    #[serde(skip)]
    standard: Standard,
    /// Shared by scenes that share the heights.
    #[serde(skip)]
    pub(crate) sampled: Arc<OtherHeights>,
}

/// The form in a file.
#[derive(Deserialize)]
struct Skewness {
    skewness: f64,
}

impl WeibullHeights {
    /// Range of the skewness: Weibull densities have at least -1.14, and above 2 the density is
    /// infinite at the lowest asperity.
    pub const SKEWNESS: [f64; 2] = [-1.0, 2.0];

    /// Heights with this skewness.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] outside [`Self::SKEWNESS`].
    pub fn new(skewness: f64) -> Result<Self, ContactError> {
        let [least, most] = Self::SKEWNESS;
        let required = "a number from -1 to 2 (use a table of heights beyond)";
        require((least..=most).contains(&skewness), "skewness", skewness, required)?;
        let [mut from, mut to] = SHAPES;
        // The skewness rises with 1/k.
        loop {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                break;
            }
            let below = Standard::new(middle).skewness() < skewness;
            if below { from = middle } else { to = middle }
        }
        let standard = Standard::new(to);
        Ok(Self { skewness, standard, sampled: Arc::new(OtherHeights::new(standard)) })
    }

    /// The skewness.
    #[must_use]
    pub fn skewness(&self) -> f64 {
        self.skewness
    }

    /// Weibull's k.
    #[must_use]
    pub fn shape(&self) -> f64 {
        self.standard.shape
    }

    /// ln φ(ζ); -∞ below the lowest asperity.
    #[must_use]
    pub fn ln_density(&self, zeta: f64) -> f64 {
        self.standard.ln_density(zeta)
    }
}

impl TryFrom<Skewness> for WeibullHeights {
    type Error = ContactError;

    fn try_from(Skewness { skewness }: Skewness) -> Result<Self, ContactError> {
        Self::new(skewness)
    }
}

/// The density of ζ = z/σ_z: t^k = exp(k ln(1 + r ζ) + ln Γ(1 + u)/u) with r = s/m, u = 1/k.
#[derive(Debug, Clone, Copy)]
struct Standard {
    shape: f64,
    /// r.
    spread: f64,
    /// k ln m.
    ln_scale: f64,
}

impl Standard {
    fn new(inverse_shape: f64) -> Self {
        // 1 + u must be exact, as its rounding affects ln Γ near 1.
        let u = 1.0 + inverse_shape - 1.0;
        let spread = ln_square_over_mean(u).exp_m1().sqrt();
        Self { shape: 1.0 / u, spread, ln_scale: libm::lgamma(1.0 + u) / u }
    }

    fn skewness(self) -> f64 {
        let u = 1.0 / self.shape;
        // Γ(1 + 3/k)/m³ - 1.
        let third = (libm::lgamma(1.0 + 3.0 * u) - 3.0 * libm::lgamma(1.0 + u)).exp_m1();
        (third - 3.0 * self.spread * self.spread) / self.spread.powi(3)
    }
}

/// ln Γ(1 + 2u) - 2 ln Γ(1 + u), without cancellation: by the product for Γ it is
/// Σ ln(1 + (u/n)²/(1 + 2u/n)) over n ≥ 1, and the remainder is a second difference of Stirling's
/// series.
fn ln_square_over_mean(u: f64) -> f64 {
    const TERMS: u32 = 128;
    let term = |n: u32| {
        let share = u / f64::from(n);
        (share * share / (1.0 + 2.0 * share)).ln_1p()
    };
    let x = f64::from(TERMS + 1) + u;
    let second = (1.0 + (0.5 + (1.0 / 6.0 - (1.0 / 30.0) / (x * x)) / x) / x) / x;
    let fourth = (2.0 + (3.0 + 2.0 / x) / x) / x.powi(3);
    let sixth = (24.0 + 60.0 / x) / x.powi(5);
    let end = u * u * (second + u * u * (fourth / 12.0 + u * u * sixth / 360.0));
    (1..=TERMS).rev().map(term).fold(end, |sum, term| sum + term)
}

impl Heights for Standard {
    fn name(&self) -> &str {
        "weibull"
    }

    fn ln_density(&self, zeta: f64) -> f64 {
        let above = zeta - self.support().0;
        if above < 0.0 {
            return f64::NEG_INFINITY;
        }
        // Near the lowest asperity the distance from it must be exact.
        let near = self.spread * zeta < -0.5;
        let ln = if near { (self.spread * above).ln() } else { (self.spread * zeta).ln_1p() };
        let factor = (self.spread * self.shape).ln() + self.ln_scale;
        let power = if self.shape > 1.0 { (self.shape - 1.0) * ln } else { 0.0 };
        factor + power - (self.shape * ln + self.ln_scale).exp()
    }

    fn support(&self) -> (f64, f64) {
        (-1.0 / self.spread, f64::INFINITY)
    }

    /// Error in addition to the rounding of the logarithm, which the engine includes.
    fn error(&self) -> f64 {
        4.0 * f64::EPSILON
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::LN_2;

    #[test]
    fn moments_equal_the_requested_ones() {
        for skewness in [-1.0, -0.9, -0.3, 0.0, 0.4, 1.0, 1.9, 2.0] {
            let heights = WeibullHeights::new(skewness).unwrap();
            // Σ over equal probabilities, by the inverse of the distribution: t = (-ln p)^(1/k).
            // Substituted p = e^-e^y, so that the trapezoidal rule converges quickly.
            let h = 1.0 / 64.0;
            let mut moments = [0.0; 4];
            for i in -2400..400 {
                let y = f64::from(i) * h;
                let weight = h * (y - y.exp()).exp();
                let Standard { shape, spread, ln_scale } = heights.standard;
                let zeta = ((y - ln_scale) / shape).exp_m1() / spread;
                for (n, moment) in moments.iter_mut().enumerate() {
                    *moment += weight * zeta.powi(n as i32);
                }
            }
            for (found, wanted) in moments.into_iter().zip([1.0, 0.0, 1.0, skewness]) {
                assert!((found - wanted).abs() < 1e-10, "{skewness}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn variances_equal_mpmath() {
        // ln Γ(1 + 2u) - 2 ln Γ(1 + u).
        for (u, wanted) in [
            (0.015625, 0.000_392_644_409_698_071_03),
            (0.03125, 0.001_536_449_709_958_315_7),
            (0.1875, 0.045_567_915_244_960_53),
            (0.5, 0.241_564_475_270_490_44),
            (1.0, LN_2),
        ] {
            let error = (ln_square_over_mean(u) / wanted - 1.0).abs();
            // 128 terms accumulate some ulps.
            assert!(error < 4e-15, "{u}: {error:e}");
        }
    }

    #[test]
    fn skewness_out_of_range_is_refused() {
        for skewness in [-1.2, 2.5, f64::NAN, f64::INFINITY] {
            let error = WeibullHeights::new(skewness).unwrap_err().to_string();
            assert!(error.contains("skewness") && error.contains("-1 to 2"), "{error}");
        }
        let error = serde_json::from_str::<WeibullHeights>("{\"skewness\": 7.0}").unwrap_err();
        assert!(error.to_string().contains("-1 to 2"), "{error}");
        let again: WeibullHeights = serde_json::from_str("{\"skewness\": -0.5}").unwrap();
        assert_eq!(serde_json::to_string(&again).unwrap(), "{\"skewness\":-0.5}");
    }
}
