//! Quantities from integrals, for single values, lists, loads and sweeps. The point and its
//! integrals are two types: merged into one, a value takes two to five nanoseconds more.

use asperity_quadrature::Moments;

use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::request::quantity_table::Derivation;
use crate::scene::place::SeparationInSigma;
use crate::{At, ContactError, Evaluation, Quantity, Regime, Scene, Tolerance};

/// The integrals at one place.
pub(crate) trait Integrals {
    /// The integral of the law for `base`, with its slope if that is set, and its factor.
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError>;

    /// The share of a regime in the force, and the sum of its parts' absolute shares.
    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError>;
}

/// A point of evaluation, with the inputs of quantities other than the integrals.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AtPoint<'s> {
    pub(crate) scene: &'s Scene,
    /// Whether the model has a law for the stiffness.
    pub(crate) own_stiffness: bool,
    pub(crate) tolerance: Tolerance,
    pub(crate) place: SeparationInSigma,
    /// In the caller's units, for errors.
    pub(crate) at: &'s At,
}

impl AtPoint<'_> {
    /// The quantity at this place.
    #[inline]
    pub(crate) fn of(
        &self,
        quantity: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        match quantity.derivation() {
            Derivation::Integral => self.value(quantity, integrals),
            Derivation::IntegralOrSlope(_) if self.own_stiffness => self.value(quantity, integrals),
            Derivation::IntegralOrSlope(of) | Derivation::Slope(of) => {
                self.slope(quantity, of, integrals)
            }
            Derivation::PerNominalArea(of) => self.total(of, self.scene.nominal_area, integrals),
            Derivation::ContactRadii(..) => self.total(quantity, 1.0, integrals),
            Derivation::Ratio(above, below) => self.ratio(quantity, (above, below), integrals),
            Derivation::Logarithm(of) => self.logarithm(quantity, of, integrals),
            Derivation::RegimeShare(regime) => self.share(quantity, regime, integrals),
            // Refused where laws are made.
            Derivation::Flow
            | Derivation::Gap
            | Derivation::Map
            | Derivation::Seal
            | Derivation::Bodies => Err(ContactError::NotRequested { quantity }),
        }
    }

    /// An integral, or a multiple of the sum of contact radii, over an area.
    #[inline(never)]
    fn total(
        &self,
        quantity: Quantity,
        area: f64,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let mut total = self.value(quantity.origin(), integrals)?;
        if let Some(factor) = contact_radii::factor(quantity, &self.scene.interface)? {
            let (scaled, size) = (total.scaled * factor, total.size * factor);
            total = Evaluation { scaled, size, ..total }.held(total.size, quantity)?;
        }
        Ok(Evaluation { scaled: total.scaled / area, size: total.size / area, ..total })
    }

    #[inline(always)]
    fn value(
        &self,
        base: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        // The slope bounds the effect of a rounded separation.
        let (moments, factor) = integrals.moments(base, self.place.rounding > 0.0)?;
        Evaluation::of_value(&moments, factor, self.place).held(moments.sizes[0], base)
    }

    #[inline(always)]
    fn slope(
        &self,
        quantity: Quantity,
        of: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let (moments, factor) = integrals.moments(of, true)?;
        let within = moments.slope_within(self.place.s, self.tolerance.relative());
        within.map_err(integral_failed(quantity, self.at))?;
        let height_std = self.scene.surface.asperity_height_std;
        Evaluation::of_slope(&moments, factor, height_std, self.place)
            .held(moments.sizes[1], quantity)
    }

    #[inline(never)]
    fn logarithm(
        &self,
        quantity: Quantity,
        of: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let of = self.value(of, integrals)?;
        let ln = self.number(quantity, of.ln_value())?;
        Ok(Evaluation::absolute(ln, of.ln_error()))
    }

    /// The ratio of the scaled values, which exists where both values underflow.
    #[inline(never)]
    fn ratio(
        &self,
        quantity: Quantity,
        (above, below): (Quantity, Quantity),
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let (above, below) = (self.value(above, integrals)?, self.value(below, integrals)?);
        let ratio = above.scaled / below.scaled * (above.ln_scale - below.ln_scale).exp();
        let ratio = self.number(quantity, ratio)?;
        // One scale for both cancels, however its logarithm is rounded.
        let scales = match above.ln_scale - below.ln_scale {
            0.0 => 0.0,
            moved => 0.5 * (above.ln_scale.abs() + below.ln_scale.abs() + moved.abs()),
        };
        let error = above.cancelled() + below.cancelled() + (scales + 4.0) * f64::EPSILON;
        Ok(Evaluation::new(ratio, error))
    }

    #[inline(never)]
    fn share(
        &self,
        quantity: Quantity,
        regime: Regime,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let force = self.value(Quantity::Force, integrals)?;
        self.number(quantity, force.ln_value())?;
        let (share, size) = integrals.share(regime)?;
        // Each part has the error of the tolerance, and so has the force that divides it.
        let error = self.tolerance.relative() + force.cancelled();
        // A force of unknown size has no shares.
        self.number(quantity, error)?;
        Ok(Evaluation::absolute(share, size * error))
    }

    /// Ratios and logarithms have no value without a contact.
    fn number(&self, quantity: Quantity, value: f64) -> Result<f64, ContactError> {
        match value.is_finite() {
            true => Ok(value),
            false => Err(ContactError::NoValue { quantity, at: *self.at }),
        }
    }
}
