//! An integral against the shifted Gaussian, and its derivatives, scaled against underflow.

use crate::QuadratureError;

/// Below this s slopes are small differences of large integrals, and are held to themselves.
pub(crate) const DEEP: f64 = -8.0;
/// Tolerances of slopes below this are wishes: rounding comes first.
const FINEST: f64 = 4e-12;

/// I(s) with its derivatives, scaled against underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// I(s) = value · exp(`ln_scale`).
    pub value: f64,
    /// -dI/ds = slope · exp(`ln_scale`).
    pub slope: f64,
    /// -max(s, 0)²/2.
    pub ln_scale: f64,
    /// Integrals of the absolute value, for value and slope: larger than those where the density
    /// changes its sign (and, for the slope, where s < 0).
    pub sizes: [f64; 2],
    /// Bound on the error of value and slope relative to `sizes`, for the s given (the rounding of
    /// s itself apart).
    pub error: f64,
}

impl Moments {
    /// No integral at all.
    pub const NONE: Self =
        Self { value: 0.0, slope: 0.0, ln_scale: 0.0, sizes: [0.0; 2], error: 0.0 };

    /// The sum with `factor` times another integral at the same s: what errs much, but is small,
    /// does not count much.
    #[must_use]
    pub fn plus(self, factor: f64, other: &Self) -> Self {
        let sizes = [0, 1].map(|k| [self.sizes[k], factor.abs() * other.sizes[k]]);
        let error = |[a, b]: [f64; 2]| {
            if a + b > 0.0 { (a * self.error + b * other.error) / (a + b) } else { 0.0 }
        };
        Self {
            value: self.value + factor * other.value,
            slope: self.slope + factor * other.slope,
            ln_scale: other.ln_scale,
            sizes: sizes.map(|[a, b]| a + b),
            error: error(sizes[0]).max(error(sizes[1])),
        }
    }

    /// Whether the slope at s is as good as a `tolerance`, relative to itself, if s < -8: there it
    /// is a small difference of large integrals, of which rounding leaves less and less (from
    /// s = -800 or so not 1e-10). Where it changes its sign, the usual slope of an integral of this
    /// size takes its place.
    ///
    /// # Errors
    /// [`QuadratureError::NotConverged`] where the slope misses it.
    #[inline]
    pub fn slope_within(&self, s: f64, tolerance: f64) -> Result<(), QuadratureError> {
        if s >= DEEP {
            return Ok(());
        }
        let usual = self.usual_slope(s);
        let (asked, error) = (tolerance.max(FINEST), self.error * self.sizes[1]);
        if error <= asked * usual {
            return Ok(());
        }
        Err(QuadratureError::missed(error / usual, asked, 0))
    }

    /// The slope, or if larger the slope of a linear density with an integral of this size; s < 0.
    fn usual_slope(&self, s: f64) -> f64 {
        self.slope.abs().max(self.sizes[0] / (1.0 - s))
    }

    /// These, with the slope of a finer integral at the same s < 0, whose value may be known less
    /// well: its size is the usual one, which the tolerance of slopes refers to.
    #[must_use]
    pub fn with_slope(self, finer: &Self, s: f64) -> Self {
        let size = finer.usual_slope(s);
        let error = self.error.max(finer.error * finer.sizes[1] / size);
        Self { slope: finer.slope, sizes: [self.sizes[0], size], error, ..self }
    }

    #[inline]
    pub(crate) fn new([value, slope]: [(f64, f64); 2], s: f64, error: f64) -> Self {
        let sizes = [value.1, slope.1];
        Self { value: value.0, slope: slope.0, ln_scale: ln_scale(s), sizes, error }
    }

    #[inline]
    pub(crate) fn of_value((value, size): (f64, f64), s: f64, error: f64) -> Self {
        Self { value, slope: 0.0, ln_scale: ln_scale(s), sizes: [size, 0.0], error }
    }
}

/// -max(s, 0)²/2.
#[inline]
pub(crate) fn ln_scale(s: f64) -> f64 {
    if s > 0.0 { -0.5 * s * s } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_err_as_their_large_parts_do() {
        let part = |value: f64, error: f64| Moments {
            value,
            slope: 0.5 * value,
            sizes: [value, value],
            error,
            ..Moments::NONE
        };
        let sum = Moments::NONE.plus(2.0, &part(1.0, 1e-12)).plus(-1.0, &part(1e-30, 1e-3));
        assert_eq!(sum, Moments { error: sum.error, ..part(2.0, 0.0) });
        assert!((sum.error / 1e-12 - 1.0).abs() < 1e-12, "{sum:?}");
        assert_eq!(Moments::NONE.plus(1.0, &Moments::NONE), Moments::NONE);
    }
}
