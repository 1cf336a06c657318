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

use crate::{Body, ContactError, Formula, Interface, Law, Power, Quantity};

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
    // The conversion as a function refuses overlaps.
    let unit = (area.value_unit / PI).sqrt();
    let overlap = "these need a model without overlapping parts of the area law";
    let mut radii = area
        .map("radius of a circle", unit, |area| (area / PI).sqrt())
        .ok_or_else(|| refused(model, overlap))?;
    for (radius, area) in radii.parts.iter_mut().zip(&area.parts) {
        // The root of one power is a power.
        if let Formula::Powers(powers) = &area.form
            && let [Power { coefficient, origin, exponent }] = powers[..]
            && coefficient >= 0.0
        {
            radius.form = [Power::from_origin(coefficient.sqrt(), origin, 0.5 * exponent)].into();
        }
    }
    Ok(radii)
}
