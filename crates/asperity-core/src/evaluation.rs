//! One value with what is known of it.

use std::borrow::Cow;

use asperity_quadrature::Moments;

use crate::{ContactError, Quantity, Regime};

/// A value that may be too small for a plain number, with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// The value over its scale, in SI units. The scale is exp(-s²/2) for Gaussian heights at a
    /// separation s > 0, exactly; the next field is its logarithm rounded to a double.
    pub scaled: f64,
    /// Logarithm of the scale, ≤ 0 or near it.
    pub ln_scale: f64,
    /// The integral of the law's absolute value, scaled alike: larger than the value where parts
    /// of different sign cancel.
    pub size: f64,
    /// Bound on the error of `scaled` relative to `size`.
    pub error: f64,
}

impl Evaluation {
    /// The value; 0 only where it is below the smallest number a double can hold.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.scaled * self.ln_scale.exp()
    }

    /// The natural logarithm of the absolute value, also where the value itself underflows;
    /// -∞ where there is no contact at all.
    #[must_use]
    pub fn ln_value(&self) -> f64 {
        self.scaled.abs().ln() + self.ln_scale
    }

    /// Bound on the error relative to the value, the rounding of the scale's logarithm included:
    /// infinite where the value is 0 by cancellation.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        if self.size == 0.0 {
            return 0.0;
        }
        // Half a unit in the last place of the logarithm, and one each of exp and the product.
        let scale = (0.5 * self.ln_scale.abs() + 2.0) * f64::EPSILON;
        self.error * self.size / self.scaled.abs() + scale
    }
}

/// The share of one part of the law in a value.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// Name of the part.
    pub name: Cow<'static, str>,
    /// Its regime.
    pub regime: Regime,
    /// Its signed integral over the total: shares sum to 1, and negative ones belong to parts
    /// that a model subtracts (all change sign where the total is negative).
    pub share: f64,
}

/// From an integral to a quantity of the whole contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    /// η A_n times the law's value unit.
    pub(crate) factor: f64,
    /// σ_z \[m\].
    pub(crate) height_std: f64,
}

impl Evaluation {
    /// The evaluation, if its size is a number that a double holds: never an infinity, and no 0 for
    /// an integral that is none.
    #[inline]
    pub(crate) fn held(self, integral: f64, quantity: Quantity) -> Result<Self, ContactError> {
        let held = self.size < f64::INFINITY && (self.size > 0.0 || integral == 0.0);
        if held { Ok(self) } else { Err(ContactError::Scale { quantity, scale: self.size }) }
    }

    pub(crate) fn of_value(moments: &Moments, units: Units) -> Self {
        let [scaled, size] = [moments.value, moments.sizes[0]].map(|x| x * units.factor);
        Self { scaled, ln_scale: moments.ln_scale, size, error: moments.error }
    }

    /// With what a relative rounding of the separation s does to it in the bound.
    pub(crate) fn with_rounding(mut self, rounding: f64, s: f64, moments: &Moments) -> Self {
        if rounding > 0.0 && moments.value != 0.0 {
            // d ln I/ds times the rounding of s; the slope's own is one more power of s, no more.
            let steepness = (moments.slope / moments.value).abs() + 1.0;
            self.error += rounding * s.abs() * steepness;
        }
        self
    }

    /// -dQ/dd.
    pub(crate) fn of_slope(moments: &Moments, units: Units) -> Self {
        let [scaled, size] =
            [moments.slope, moments.sizes[1]].map(|x| x / units.height_std * units.factor);
        Self { scaled, ln_scale: moments.ln_scale, size, error: moments.error }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moments(value: f64) -> Moments {
        Moments { value, slope: 0.0, sizes: [value, 0.0], ln_scale: 0.0, error: 0.0 }
    }

    #[test]
    fn what_a_double_cannot_hold_is_refused() {
        let large = moments(1e10);
        for (factor, held) in [(1e290, true), (1e300, false), (1e-300, true)] {
            let units = Units { factor, height_std: 1e-6 };
            let value = Evaluation::of_value(&large, units).held(1e10, Quantity::Force);
            assert_eq!(value.is_ok(), held, "{value:?}");
        }
        let units = Units { factor: 1e-300, height_std: 1.0 };
        let tiny = Evaluation::of_value(&moments(1e-30), units);
        let message = tiny.held(1e-30, Quantity::Force).unwrap_err().to_string();
        assert!(message.starts_with("the scale of the force is 0e0"), "{message}");
        let none = Evaluation::of_value(&moments(0.0), units);
        assert!(none.held(0.0, Quantity::Force).is_ok(), "no contact is no error");
    }
}
