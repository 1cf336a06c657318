//! The sum of the contact radii S = Σ √(Aᵢ/π), and the stiffnesses and conductances of joints.
//!
//! Exact for upright asperities whose contacts are circles:
//! ```text
//! unloading stiffness       2 E S         dF/dw = 2 E a where any elastic unloading begins   [derived]
//! tangential stiffness      8 G S         in stick, 1/G = (2-ν₁)/G₁ + (2-ν₂)/G₂ (Mindlin)    [seen]
//! thermal conductance       2 k S         k = 2k₁k₂/(k₁+k₂), contacts far from each other    [derived]
//! electrical conductance    2 S/ρ         ρ = (ρ₁+ρ₂)/2                                      [seen]
//! ```
//! For contacts with adhesion (JKR) the first holds for motions so small that the edges of the
//! contacts stay in place; farther opening has a law of its own (`jkr-separation`).
//!
//! Each contact constricts the flow alone: the constriction factor is 1.

use std::f64::consts::PI;
use std::sync::Arc;

use asperity_quadrature::{QuadratureError, Sampler};

use crate::{Body, ContactError, Formula, FunctionKey, Interface, Law, Part, Power, Quantity};

/// The factor of S in a stiffness or a conductance, 2 E, 8 G, 2 k or 2/ρ; `None` for another
/// quantity.
pub(crate) fn factor(
    quantity: Quantity,
    interface: &Interface,
) -> Result<Option<f64>, ContactError> {
    let Some((field, factor)) = quantity.interface_property() else { return Ok(None) };
    let known = Interface::NUMBERS.iter().find(|number| number.name == field);
    if let Some(value) = known.and_then(|number| (number.get)(interface)) {
        return Ok(Some(factor(value)));
    }
    let whose = match Body::NUMBERS.iter().any(|number| number.name == field) {
        true => " (that of the interface, or those of both bodies)",
        false => "",
    };
    Err(ContactError::Missing { field, reason: format!("{quantity}{whose} needs it") })
}

/// Refuses a quantity if the interface lacks an input for it.
pub(crate) fn check(quantities: &[Quantity], interface: &Interface) -> Result<(), ContactError> {
    quantities.iter().try_for_each(|quantity| factor(*quantity, interface).map(drop))
}

pub(crate) const INCLINED: &str = "contacts are inclined";

/// The error for contacts that are not circles, or whose area is an average.
pub(crate) fn refused(model: &str, reason: &str) -> ContactError {
    let what = format!("contact radii: {reason}");
    ContactError::Unsupported { model: model.into(), what }
}

/// The law a(w) of the contact radius, from the area law.
pub(crate) fn law(model: &str, area: &Law) -> Result<Law, ContactError> {
    let mut ends: Vec<(f64, f64)> =
        area.parts.iter().map(|part| (part.range.start, part.range.end)).collect();
    ends.sort_by(|a, b| a.0.total_cmp(&b.0));
    let apart = ends.windows(2).all(|pair| pair[0].1 <= pair[1].0);
    if !apart || area.is_signed() {
        let overlap = "these need a model without overlapping parts of the area law";
        return Err(refused(model, overlap));
    }
    let [area_unit, unit] = [area.value_unit, (area.value_unit / PI).sqrt()];
    let part = |part: &Part| Part { form: radius(&part.form, area_unit, unit), ..part.clone() };
    Ok(Law {
        value_unit: unit,
        parts: area.parts.iter().map(part).collect(),
        shares: None,
        ..*area
    })
}

/// The radius of circles of these areas, in these units.
fn radius(area: &Formula, area_unit: f64, unit: f64) -> Formula {
    // The root of one power is a power.
    if let Formula::Powers(powers) = area
        && let [Power { coefficient, origin, exponent }] = powers[..]
        && coefficient >= 0.0
    {
        return [Power::from_origin(coefficient.sqrt(), origin, 0.5 * exponent)].into();
    }
    let of = match area {
        Formula::Powers(powers) => Some(format!("{powers:?}")),
        // A function without a key is never shared.
        Formula::Function { key, .. } => key.as_ref().map(|key| format!("{key:?}")),
    };
    let form = Formula::sampled(Arc::new(Radius { area: area.clone(), area_unit, unit }));
    let name = "radius of a circle".into();
    match of {
        Some(of) => form.with_key(FunctionKey { name, of, parameters: vec![area_unit, unit] }),
        None => form,
    }
}

/// The radius of a circle by the formula of its area.
struct Radius {
    area: Formula,
    area_unit: f64,
    unit: f64,
}

impl Sampler for Radius {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        self.area.sample(x, out)?;
        out.iter_mut().for_each(|q| *q = (self.area_unit * *q / PI).sqrt() / self.unit);
        Ok(())
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        0.5 * self.area.relative_error(x)
    }
}
