//! One value with a bound on its error.

use std::borrow::Cow;

use asperity_quadrature::Moments;
use serde::Serialize;

use crate::law::contact_radii;
use crate::request::quantity_table::Derivation;
use crate::scene::place::SeparationInSigma;
use crate::{ContactError, Quantity, Regime, Scene};

/// A value that may be too small for a plain number, with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Evaluation {
    /// The value over its scale, in SI units. The scale is exp(-s²/2) for Gaussian heights at a
    /// separation s > 0, exactly; the next field is its logarithm rounded to a double.
    pub scaled: f64,
    /// Logarithm of the scale, ≤ 0 or near it.
    pub ln_scale: f64,
    /// The integral of the law's absolute value, scaled alike: larger than the value where parts
    /// of different sign cancel. 1 for logarithms and shares.
    pub size: f64,
    /// Bound on the error of `scaled` relative to `size`.
    pub error: f64,
}

impl Evaluation {
    /// A plain value with a bound on its relative error.
    #[must_use]
    pub fn new(value: f64, relative_error: f64) -> Self {
        Self { scaled: value, ln_scale: 0.0, size: value.abs(), error: relative_error }
    }

    /// A value whose error is bounded as a difference: a logarithm or a share.
    #[must_use]
    pub fn absolute(value: f64, error: f64) -> Self {
        Self { scaled: value, ln_scale: 0.0, size: 1.0, error }
    }

    /// A quantity from the force \[N\] and the real area \[m²\] on a nominal area \[m²\], with a
    /// bound on their relative error; `None` for a quantity that needs more.
    #[must_use]
    pub fn of_totals(
        quantity: Quantity,
        (force, area): (f64, f64),
        nominal_area: f64,
        error: f64,
    ) -> Option<Self> {
        let of = |quantity| Self::of_totals(quantity, (force, area), nominal_area, error);
        match quantity.derivation() {
            Derivation::Integral => {
                let totals = [(Quantity::Force, force), (Quantity::Area, area)];
                let found = totals.into_iter().find(|(known, _)| *known == quantity);
                found.map(|(_, value)| Self::new(value, error))
            }
            Derivation::PerNominalArea(total) => {
                of(total).map(|total| Self::new(total.value() / nominal_area, error))
            }
            Derivation::Ratio(above, below) => {
                Some(Self::new(of(above)?.value() / of(below)?.value(), 2.0 * error))
            }
            Derivation::Logarithm(total) => {
                let value = of(total)?.value().ln();
                Some(Self::absolute(value, error * (1.0 + value.abs())))
            }
            _ => None,
        }
    }

    /// A stiffness or conductance of joints, per area or not, from the sum of the contact radii
    /// \[m\] with a bound on its relative error; `None` for another quantity. For contacts that are
    /// no circles, the sum is the stiffness at fixed contact over 2 E.
    ///
    /// # Errors
    /// [`ContactError::Missing`] for a property of the interface that the quantity needs.
    pub fn of_contact_radii(
        quantity: Quantity,
        sum: f64,
        scene: &Scene,
        error: f64,
    ) -> Result<Option<Self>, ContactError> {
        let per_area = matches!(quantity.derivation(), Derivation::PerNominalArea(_));
        let area = if per_area { scene.nominal_area } else { 1.0 };
        let factor = contact_radii::factor(quantity, &scene.interface)?;
        Ok(factor.map(|factor| Self::new(sum * factor / area, error)))
    }

    /// The value; 0 only where it is below the smallest number a double can hold.
    #[must_use]
    #[inline]
    pub fn value(&self) -> f64 {
        if self.ln_scale > LEAST {
            return self.scaled * self.ln_scale.exp();
        }
        // Half a scale at a time, so that only the value itself may be too small.
        let half = (0.5 * self.ln_scale).exp();
        (self.scaled * half) * half
    }

    /// The natural logarithm of the absolute value, also where the value itself underflows;
    /// -∞ where there is no contact at all.
    #[must_use]
    pub fn ln_value(&self) -> f64 {
        self.scaled.abs().ln() + self.ln_scale
    }

    /// Bound on the error relative to the value, the rounding of the scale's logarithm and of
    /// numbers near the smallest included: infinite where the value reads 0 and is none.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        if self.size == 0.0 {
            return 0.0;
        }
        let value = self.value().abs();
        let granular = if value < f64::MIN_POSITIVE { f64::from_bits(1) / value } else { 0.0 };
        self.unrounded() + granular
    }

    /// The bound where no value is too small.
    fn unrounded(&self) -> f64 {
        // Half a unit in the last place of the logarithm, and one each of exp and the products.
        self.cancelled() + (0.5 * self.ln_scale.abs() + 3.0) * f64::EPSILON
    }

    /// Deviation from a reference, also where both underflow: relative to the reference, but
    /// absolute for logarithms and shares. 0 within the sum of both bounds; `None` where it is no
    /// number.
    #[must_use]
    pub fn deviation(&self, reference: &Self, quantity: Quantity) -> Option<f64> {
        let of = |error: fn(&Self) -> f64| error(self) + error(reference);
        let (deviation, blurred) = if quantity.is_absolute() {
            (self.value() - reference.value(), of(|e| e.error * e.size))
        } else if self.scaled == 0.0 && reference.scaled == 0.0 {
            (0.0, 0.0)
        } else {
            let scales = (self.ln_scale - reference.ln_scale).exp();
            let mut ratio = self.scaled / reference.scaled * scales;
            if !ratio.is_finite() {
                let sign = self.scaled.signum() * reference.scaled.signum();
                ratio = sign * (self.ln_value() - reference.ln_value()).exp();
            }
            (ratio - 1.0, of(Self::unrounded))
        };
        let deviation = if deviation.abs() <= blurred { 0.0 } else { deviation };
        deviation.is_finite().then_some(deviation)
    }

    /// The bound as a quantity's errors are given: relative, but a difference for logarithms and
    /// shares.
    #[must_use]
    pub fn bound(&self, quantity: Quantity) -> f64 {
        if quantity.is_absolute() { self.error * self.size } else { self.relative_error() }
    }

    /// Condition number, ≥ 1: the integral of the absolute value over the absolute value of the
    /// integral. Near a zero crossing a relative error of an input grows by this factor.
    #[must_use]
    pub fn condition(&self) -> f64 {
        if self.size == 0.0 { 1.0 } else { self.size / self.scaled.abs() }
    }

    /// This value less another: the bound is one on the error relative to both together.
    #[must_use]
    pub fn less(&self, other: &Self) -> Self {
        let [own, others] = [self, other].map(Self::value);
        let size = own.abs() + others.abs();
        let of = |value: f64, error: f64| if value == 0.0 { 0.0 } else { value.abs() * error };
        let off = of(own, self.relative_error()) + of(others, other.relative_error());
        let error = if size > 0.0 { off / size + f64::EPSILON } else { 0.0 };
        Self { scaled: own - others, ln_scale: 0.0, size, error }
    }

    /// Bound on the absolute error of [`ln_value`](Self::ln_value).
    pub(crate) fn ln_error(&self) -> f64 {
        let relative = self.cancelled();
        let of_value = if relative < 1.0 { -(-relative).ln_1p() } else { f64::INFINITY };
        // The logarithms of scale and scaled value are each rounded, and so is their sum, which may
        // be much smaller than both; the scaled value is a product.
        let (scale, scaled) = (self.ln_scale.abs(), self.scaled.abs().ln());
        let rounded = 0.5 * scale + scaled.abs() + 0.5 * (self.ln_scale + scaled).abs() + 3.0;
        of_value + rounded * f64::EPSILON
    }

    /// The error relative to the scaled value.
    pub(crate) fn cancelled(&self) -> f64 {
        if self.size == 0.0 { 0.0 } else { self.error * self.size / self.scaled.abs() }
    }
}

impl From<Moments> for Evaluation {
    /// An integral as it is, without units.
    fn from(moments: Moments) -> Self {
        let Moments { value, ln_scale, sizes, error, .. } = moments;
        Self { scaled: value, ln_scale, size: sizes[0], error }
    }
}

/// Below this logarithm a scale is no normal double.
const LEAST: f64 = -700.0;

/// The share of one part of the law in a value.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Share {
    /// Name of the part.
    pub name: Cow<'static, str>,
    /// Its regime.
    pub regime: Regime,
    /// Its signed integral over the total: shares sum to 1, and negative ones belong to parts
    /// that a model subtracts (all change sign where the total is negative). Below 1e-20 it may
    /// read 0.
    pub share: f64,
}

impl Evaluation {
    /// The integral times a factor; `place` may be off by its rounding.
    #[inline]
    pub(crate) fn of_value(moments: &Moments, factor: f64, place: SeparationInSigma) -> Self {
        let [scaled, size] = [moments.value, moments.sizes[0]].map(|x| x * factor);
        Self { scaled, ln_scale: moments.ln_scale, size, error: moments.error }
            .moved(place, moments)
    }

    /// -dQ/dd, with σ_z \[m\].
    #[inline]
    pub(crate) fn of_slope(
        moments: &Moments,
        factor: f64,
        height_std: f64,
        place: SeparationInSigma,
    ) -> Self {
        let [scaled, size] = [moments.slope, moments.sizes[1]].map(|x| x / height_std * factor);
        Self { scaled, ln_scale: moments.ln_scale, size, error: moments.error }
            .moved(place, moments)
    }

    /// With the effect of the rounding of the separation in the bound.
    #[inline]
    fn moved(mut self, place: SeparationInSigma, moments: &Moments) -> Self {
        if place.rounding > 0.0 && moments.value != 0.0 {
            // d ln I/ds times the rounding of s; the slope's own is one more power of s, no more.
            // Far below 0 both are a power of the overlap over the overlap.
            let own = 1.0 / (1.0 + (-place.s).max(0.0));
            let steepness = (moments.slope / moments.value).abs() + own;
            self.error += place.rounding * steepness;
        }
        self
    }

    /// The evaluation, if its size is a number that a double holds: never an infinity, and no 0 for
    /// an integral that is none.
    #[inline]
    pub(crate) fn held(self, integral: f64, quantity: Quantity) -> Result<Self, ContactError> {
        let held = self.size < f64::INFINITY && (self.size > 0.0 || integral == 0.0);
        if held { Ok(self) } else { Err(ContactError::Scale { quantity, scale: self.size }) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: SeparationInSigma = SeparationInSigma { s: 0.0, rounding: 0.0 };

    fn moments(value: f64) -> Moments {
        Moments { value, slope: 0.0, sizes: [value, 0.0], ln_scale: 0.0, error: 0.0 }
    }

    #[test]
    fn what_a_double_cannot_hold_is_refused() {
        let large = moments(1e10);
        for (factor, held) in [(1e290, true), (1e300, false), (1e-300, true)] {
            let value = Evaluation::of_value(&large, factor, HERE).held(1e10, Quantity::Force);
            assert_eq!(value.is_ok(), held, "{value:?}");
        }
        let tiny = Evaluation::of_value(&moments(1e-30), 1e-300, HERE);
        let refused = tiny.held(1e-30, Quantity::Force);
        assert!(matches!(refused, Err(ContactError::Scale { .. })), "{refused:?}");
        let none = Evaluation::of_value(&moments(0.0), 1e-300, HERE);
        assert!(none.held(0.0, Quantity::Force).is_ok());
    }

    #[test]
    fn deviations_are_told_from_errors_and_outlive_underflow() {
        let new = |value| Evaluation::new(value, 1e-12);
        let (force, ln) = (Quantity::Force, Quantity::LnForce);
        assert_eq!(new(3.0).deviation(&new(2.0), force), Some(0.5));
        assert_eq!(new(3.0).deviation(&new(2.0), ln), Some(1.0));
        assert_eq!(new(1.0 + 1e-12).deviation(&new(1.0), force), Some(0.0));
        assert!(new(1.0 + 3e-12).deviation(&new(1.0), force).is_some_and(|d| d > 0.0));
        assert_eq!(new(0.0).deviation(&new(0.0), force), Some(0.0));
        assert_eq!(new(1.0).deviation(&new(0.0), force), None);
        let tail = |ln_scale| Evaluation { ln_scale, ..new(1.0) };
        let twice = tail(2.0f64.ln() - 5000.0).deviation(&tail(-5000.0), force).unwrap();
        assert!((twice - 1.0).abs() < 1e-12);
        assert_eq!(tail(-4000.0).deviation(&tail(-5000.0), force), None);
        assert_eq!(tail(-5000.0).deviation(&tail(-4000.0), force), Some(-1.0));
    }

    #[test]
    fn values_are_good_to_the_smallest_double_and_say_where_they_are_not() {
        // exp(-722) is subnormal; times 1e13 the value is not. ln(1e13) = 29.933606208922594.
        let small = Evaluation { scaled: 1e13, ln_scale: -722.0, size: 1e13, error: 1e-15 };
        let error = (small.value() / (-722.0f64 + 29.933_606_208_922_594).exp() - 1.0).abs();
        assert!(error < small.relative_error() && small.relative_error() < 1e-12, "{error:e}");
        let least = Evaluation { scaled: 1.0, ln_scale: -744.0, size: 1.0, error: 1e-15 };
        assert!(least.value() > 0.0 && least.relative_error() > 0.1);
        let gone = Evaluation { ln_scale: -800.0, ..least };
        assert!(gone.value() == 0.0 && gone.relative_error().is_infinite());
        assert!((gone.ln_value() + 800.0).abs() < 1e-12);
    }
}
