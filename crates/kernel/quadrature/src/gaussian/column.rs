//! A column of plain numbers, and how good they are.

use super::moments::Moments;

/// Scales below the exponential of this are next to no normal numbers.
const LEAST: f64 = -700.0;

/// What a column of numbers holds: `factor` · I(s + shift), or `factor` · -dI/ds there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaledIntegral {
    /// Added to each s.
    pub shift: f64,
    /// Whether the slope -dI/ds is meant, and not the value.
    pub slope: bool,
    /// Finite and not 0.
    pub factor: f64,
}

/// How good all numbers of a column are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArrayAccuracy {
    /// Bound on the relative error of each number: the error of the integral, with the rounding of
    /// the sum s + shift, of the scale exp(-s²/2) and of the product with the factor.
    pub error: f64,
    /// Bound on the ratio of an integral of the absolute value to the integral itself, at most
    /// half more than the largest; 1 where nothing cancels.
    pub condition: f64,
    /// Whether all numbers and their scales are normal numbers; the bound holds only then.
    pub normal: bool,
    /// No s + shift is smaller. Slopes below -8 are small differences of large integrals: see
    /// [`Moments::slope_within`].
    pub lowest: f64,
}

impl ArrayAccuracy {
    /// Of a column without numbers.
    pub const NONE: Self = Self { error: 0.0, condition: 1.0, normal: true, lowest: f64::INFINITY };

    /// Of both columns.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            error: self.error.max(other.error),
            condition: self.condition.max(other.condition),
            normal: self.normal && other.normal,
            lowest: self.lowest.min(other.lowest),
        }
    }
}

impl ScaledIntegral {
    /// One number out of an integral at `seen` = s + shift.
    pub(crate) fn number(&self, seen: f64, moments: &Moments) -> (f64, ArrayAccuracy) {
        let [value, size] = match self.slope {
            true => [moments.slope, moments.sizes[1]],
            false => [moments.value, moments.sizes[0]],
        };
        let number = value * self.factor * moments.ln_scale.exp();
        let condition = if value >= size { 1.0 } else { size / value.abs() };
        let steepness = moments.sizes[1] / moments.sizes[0];
        let error = (moments.error + self.rounding(seen.abs(), steepness)) * condition
            + (0.5 * moments.ln_scale.abs() + ROUNDED) * f64::EPSILON;
        let normal = moments.ln_scale > LEAST && number.is_normal();
        (number, ArrayAccuracy { error, condition, normal, lowest: seen })
    }

    /// The relative error by the rounding of s + shift up to `largest` where the ratio of slope to
    /// value is at most `steepness`; the slope's own is one more power of s.
    pub(crate) fn rounding(&self, largest: f64, steepness: f64) -> f64 {
        if self.shift == 0.0 || steepness.is_nan() {
            return 0.0;
        }
        f64::EPSILON * (largest + 2.0 * self.shift.abs()) * (steepness + 1.0)
    }
}

/// The product of polynomial, scale and factor, in units of the last place.
pub(crate) const ROUNDED: f64 = 4.0;
