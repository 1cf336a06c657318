//! The common part of the lateral models: the part of a law for each regime.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use asperity_core::{Asperity, ContactError, Law, Part, Regime, Tolerance, Validity};

use crate::{
    AngleDensity, Displacement, ForceComponent, LateralOptions, NormalLaw, ObliqueSlip, Response,
    Stick, angle_average, angle_average_of_powers,
};

/// The validity of a lateral model: inclined contacts have no Hertz limit, and the force may fall.
#[must_use]
pub fn lateral_validity(valid_for: &'static str) -> Validity {
    let (force_monotone, hertz_limit) = (false, None);
    Validity { force_monotone, hertz_limit, angles: true, valid_for, ..Validity::default() }
}

/// The laws of a lateral model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LateralLaw {
    /// Of the force.
    Force,
    /// Of the area.
    Area,
    /// Of the average stiffness of the asperities.
    Stiffness,
}

/// An asperity with the constants that the parts of a lateral model need.
#[derive(Debug, Clone, Copy)]
pub struct Lateral {
    options: LateralOptions,
    pressure_factor: f64,
    area_exponent: f64,
    shear_ratio: f64,
    critical: f64,
    critical_force: f64,
    radius: f64,
}

impl Lateral {
    /// # Errors
    /// [`ContactError`] naming the option or input that is out of range or missing.
    pub fn new(
        options: LateralOptions,
        asperity: &Asperity,
        model: &str,
    ) -> Result<Self, ContactError> {
        options.check()?;
        Ok(Self {
            options,
            pressure_factor: asperity.pressure_factor,
            // S_y = H/2.8 unless S_y is given, as in JG.
            area_exponent: asperity_jg::area_exponent(asperity)?,
            shear_ratio: 4.0 * asperity.shear_modulus(model)? / asperity.equivalent_modulus,
            critical: asperity.critical_interference()?,
            critical_force: asperity.critical_force()?,
            radius: asperity.radius,
        })
    }

    /// s₀ = √(w_c/R), the reduction of the contact radius in the AT paper.
    #[must_use]
    pub fn radius_loss(&self) -> f64 {
        (self.critical / self.radius).sqrt()
    }

    /// The normal law of a regime, with this s₀.
    #[must_use]
    pub fn normal(&self, regime: Regime, radius_loss: f64) -> NormalLaw {
        let Self { pressure_factor, area_exponent, .. } = *self;
        NormalLaw { regime, pressure_factor, area_exponent, radius_loss }
    }

    /// A law without parts in the units F_c, π R w_c or F_c/w_c.
    #[must_use]
    pub fn law_in_units(&self, kind: LateralLaw) -> Law {
        let unit = match kind {
            LateralLaw::Force => self.critical_force,
            LateralLaw::Area => PI * self.radius * self.critical,
            LateralLaw::Stiffness => self.critical_force / self.critical,
        };
        Law::in_units(self.critical, unit)
    }

    /// Whether friction limits the tangential force of a part: with [`Stick::Unlimited`] only in
    /// the part of the AT paper's equation (23), which is Gao's elastic-plastic one and AT's ep2.
    #[must_use]
    pub fn stick(&self, of_equation_23: bool) -> Stick {
        if of_equation_23 { Stick::Clamped } else { self.options.stick }
    }

    /// The angle average of a regime over y in `range`, as a part of a law.
    #[must_use]
    pub fn part(
        &self,
        stick: Stick,
        normal: NormalLaw,
        range: Range<f64>,
        kind: LateralLaw,
        tolerance: Tolerance,
    ) -> Part {
        let LateralOptions { angle_density, displacement, force, .. } = self.options;
        let closed = |powers| angle_average_of_powers(powers, range.clone(), angle_density);
        let shear_ratio = self.shear_ratio;
        let slip = |response| {
            let slip = ObliqueSlip { normal, shear_ratio, displacement, stick, response };
            angle_average(Arc::new(slip), range.clone(), angle_density, tolerance.relative())
        };
        let normal_only = displacement == Displacement::None && force == ForceComponent::Size;
        let (form, kinks) = match kind {
            LateralLaw::Area => (closed(&normal.area_powers()), vec![range.end]),
            LateralLaw::Force if normal_only => (closed(&normal.load_powers()), vec![range.end]),
            LateralLaw::Force => slip(Response::Force(force)),
            LateralLaw::Stiffness => slip(Response::Stiffness),
        };
        // An upright contact leaves a regime at its end; at larger x inclined contacts are still in
        // it.
        let end = if angle_density == AngleDensity::Upright { range.end } else { f64::INFINITY };
        let inside = |x: &f64| *x > range.start && *x < end;
        Part {
            name: Cow::Owned(normal.regime.to_string()),
            regime: normal.regime,
            sign: 1.0,
            kinks: kinks.into_iter().filter(inside).collect(),
            range: range.start..end,
            form,
        }
    }
}
