//! From integrals to quantities: the one way there is, for compiled scenes and for sweeps.

use asperity_quadrature::Moments;

use crate::engine::channel::failed;
use crate::law::contact_radii::per_radius;
use crate::request::separation::Place;
use crate::{At, ContactError, Evaluation, Quantity, Regime, Scene, Tolerance};

/// Where the integrals of one place come from.
pub(crate) trait Integrals {
    /// The integral of the law for `base` and what it is to be multiplied with; its slope too,
    /// where that is wanted.
    fn moments(&mut self, base: Quantity, slope: bool) -> Result<(Moments, f64), ContactError>;

    /// The share of a regime in the force, and the sum of its parts' absolute shares.
    fn share(&mut self, regime: Regime) -> Result<(f64, f64), ContactError>;
}

/// What a quantity is read from, the integrals apart.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reading<'s> {
    pub(crate) scene: &'s Scene,
    /// Whether the model has a law for the stiffness.
    pub(crate) own_stiffness: bool,
    pub(crate) tolerance: Tolerance,
    pub(crate) place: Place,
    /// As it was asked, for errors.
    pub(crate) at: At,
}

impl Reading<'_> {
    /// The quantity at this place.
    #[inline]
    pub(crate) fn of(
        &self,
        quantity: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        match quantity {
            Quantity::Force | Quantity::Area | Quantity::Contacts | Quantity::ContactRadiusSum => {
                self.value(quantity, integrals)
            }
            Quantity::Stiffness if self.own_stiffness => self.value(quantity, integrals),
            Quantity::Stiffness | Quantity::Tangent => self.slope(quantity, integrals),
            _ => self.derived(quantity, integrals),
        }
    }

    /// What follows from force, area and contact radii.
    fn derived(
        &self,
        quantity: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        match quantity {
            Quantity::AreaFraction => Ok(self.nominal(self.value(Quantity::Area, integrals)?)),
            Quantity::LnForce => self.logarithm(quantity, self.value(Quantity::Force, integrals)?),
            Quantity::LnArea => self.logarithm(quantity, self.value(Quantity::Area, integrals)?),
            Quantity::UnloadingStiffness
            | Quantity::TangentialStiffness
            | Quantity::ThermalConductance
            | Quantity::ElectricalConductance => {
                let factor = per_radius(quantity, &self.scene.interface)?;
                let radii = self.value(Quantity::ContactRadiusSum, integrals)?;
                let [scaled, size] = [radii.scaled, radii.size].map(|x| x * factor);
                Evaluation { scaled, size, ..radii }.held(radii.size, quantity)
            }
            Quantity::ThermalConductancePerArea | Quantity::ElectricalConductancePerArea => {
                let total = quantity.over_area().unwrap_or(quantity);
                Ok(self.nominal(self.derived(total, integrals)?))
            }
            Quantity::MeanPressure => {
                let force = self.value(Quantity::Force, integrals)?;
                self.ratio(quantity, force, self.value(Quantity::Area, integrals)?)
            }
            _ => match quantity.regime() {
                Some(regime) => self.share(quantity, regime, integrals),
                None => Ok(self.nominal(self.value(Quantity::Force, integrals)?)),
            },
        }
    }

    fn value(
        &self,
        base: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        // The slope tells what a rounded separation does to the value.
        let (moments, factor) = integrals.moments(base, self.place.rounding > 0.0)?;
        Evaluation::of_value(&moments, factor, self.place).held(moments.sizes[0], base)
    }

    fn slope(
        &self,
        quantity: Quantity,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let (moments, factor) = integrals.moments(Quantity::Force, true)?;
        let missed = moments.slope_within(self.place.s, self.tolerance.relative());
        missed.map_err(failed(quantity, self.at))?;
        let height_std = self.scene.surface.asperity_height_std;
        Evaluation::of_slope(&moments, factor, height_std, self.place)
            .held(moments.sizes[1], quantity)
    }

    /// Per nominal area.
    fn nominal(&self, mut evaluation: Evaluation) -> Evaluation {
        evaluation.scaled /= self.scene.nominal_area;
        evaluation.size /= self.scene.nominal_area;
        evaluation
    }

    fn logarithm(&self, quantity: Quantity, of: Evaluation) -> Result<Evaluation, ContactError> {
        let ln = self.number(quantity, of.ln_value())?;
        Ok(Evaluation::absolute(ln, of.cancelled() + 2.0 * f64::EPSILON * ln.abs()))
    }

    /// Of the scaled values, so that it has a value where both underflow.
    fn ratio(
        &self,
        quantity: Quantity,
        above: Evaluation,
        below: Evaluation,
    ) -> Result<Evaluation, ContactError> {
        let ratio = above.scaled / below.scaled * (above.ln_scale - below.ln_scale).exp();
        let ratio = self.number(quantity, ratio)?;
        let error = above.cancelled() + below.cancelled() + 4.0 * f64::EPSILON;
        Ok(Evaluation::new(ratio, error))
    }

    fn share(
        &self,
        quantity: Quantity,
        regime: Regime,
        integrals: &mut impl Integrals,
    ) -> Result<Evaluation, ContactError> {
        let force = self.value(Quantity::Force, integrals)?;
        self.number(quantity, force.ln_value())?;
        let (share, size) = integrals.share(regime)?;
        // Each part is as good as the tolerance, and so is what it is divided by.
        let error = size * (self.tolerance.relative() + force.cancelled());
        Ok(Evaluation::absolute(share, error))
    }

    /// Nothing touches where a ratio or a logarithm is no number.
    fn number(&self, quantity: Quantity, value: f64) -> Result<f64, ContactError> {
        match value.is_finite() {
            true => Ok(value),
            false => Err(ContactError::NoValue { quantity, at: self.at }),
        }
    }
}
