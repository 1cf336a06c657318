//! The onset of a law: below w = 0 if adhesion holds an asperity that is pulled away, above 0 if
//! the first contacts are lost.
//!
//! With x counted from the onset w₀, and s too, the integral is the usual one:
//! ```text
//! ∫ q(w) g(d + w) dw = ∫₀^∞ q(w₀ + t) g(d + w₀ + t) dt
//! ```

use asperity_quadrature::Moments;

/// w₀/σ_z.
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
