//! The sum of the contact radii S = Σ √(Aᵢ/π), and what it says of joints.
//!
//! Exact for upright asperities whose contacts are circles:
//! ```text
//! unloading stiffness       2 E S         dF/dw = 2 E a where any elastic unloading begins   [derived]
//! tangential stiffness      8 G S         in stick, 1/G = (2-ν₁)/G₁ + (2-ν₂)/G₂ (Mindlin)    [seen]
//! thermal conductance       2 k S         k = 2k₁k₂/(k₁+k₂), contacts far from each other    [derived]
//! electrical conductance    2 S/ρ         ρ = (ρ₁+ρ₂)/2                                      [seen]
//! ```
//! Beside contacts that stick and are stretched (JKR) the first holds for motions so small that the
//! edges stay where they are; opening farther has a curve of its own (`jkr-separation`).
//!
//! The contacts constrict the flow each for itself: the constriction factor is 1.

use std::f64::consts::PI;

use crate::{AsperityModel, ContactError, Formula, Interface, Law, Power, Quantity};

/// What a unit of S brings.
pub(crate) fn per_radius(quantity: Quantity, interface: &Interface) -> Result<f64, ContactError> {
    let total = quantity.over_area().unwrap_or(quantity);
    let given = |field: &'static str, value: Option<f64>, of: &str| {
        let reason = format!("{quantity}{of} needs it");
        value.ok_or(ContactError::Missing { field, reason })
    };
    let bodies = " (that of the interface, or those of both bodies)";
    match total {
        Quantity::UnloadingStiffness => Ok(2.0 * interface.equivalent_modulus),
        Quantity::TangentialStiffness => {
            let shear = interface.equivalent_shear_modulus;
            Ok(8.0 * given("equivalent_shear_modulus", shear, "")?)
        }
        Quantity::ThermalConductance => {
            let conductivity = interface.thermal_conductivity;
            Ok(2.0 * given("thermal_conductivity", conductivity, bodies)?)
        }
        Quantity::ElectricalConductance => {
            let resistivity = interface.electrical_resistivity;
            Ok(2.0 / given("electrical_resistivity", resistivity, bodies)?)
        }
        _ => Ok(1.0),
    }
}

/// Refuses what the interface lacks an input for.
pub(crate) fn check(quantities: &[Quantity], interface: &Interface) -> Result<(), ContactError> {
    quantities.iter().try_for_each(|quantity| per_radius(*quantity, interface).map(drop))
}

/// The law a(w) of a contact's radius, from that of its area.
pub(crate) fn law(model: &dyn AsperityModel, area: &Law) -> Result<Law, ContactError> {
    let not_circles = |reason: &str| ContactError::Unsupported {
        model: model.name().into(),
        what: format!("sums of contact radii, as unloading and conductance need them: {reason}"),
    };
    if model.validity().angles {
        return Err(not_circles(
            "its contacts lie at all angles, and only those of upright asperities are circles whose radii follow from the area",
        ));
    }
    // As a function first, so that overlaps are refused in one place.
    let unit = (area.value_unit / PI).sqrt();
    let mut radii =
        area.map("radius of a circle", unit, |area| (area / PI).sqrt()).ok_or_else(|| {
            not_circles(
                "only models of equal, upright asperities have it, not those whose radii are spread (-random) or parts of whose area overlap",
            )
        })?;
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
