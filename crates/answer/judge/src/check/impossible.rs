//! Areas beyond the nominal one, and loads beyond full contact, for which a formula still gives
//! numbers.

use super::Check;
use super::findings::crowded;
use asperity_core::{At, Code, ContactModel, Finding, Scene, short};

impl Check {
    /// A warning where the contacts of a model have so much area at a pressure that they merge, or
    /// more than there is; theories of the whole surface only in that case.
    #[must_use]
    pub fn crowded(model: &dyn ContactModel, pressure: f64, area_fraction: f64) -> Option<Finding> {
        let found = crowded(model, At::Pressure(pressure), area_fraction);
        found.filter(|_| model.validity().asperities || area_fraction > 1.0)
    }
}

/// A warning for a load that no contact carries: a mean pressure above the hardness or, for elastic
/// bodies, a pressure on the real area above the equivalent modulus. Full contact of a soft body
/// below its modulus is possible.
pub(super) fn beyond_full_contact(
    model: &dyn ContactModel,
    scene: &Scene,
    at: At,
    [pressure, area_fraction]: [f64; 2],
) -> Option<Finding> {
    let (value, limit, names, advice) = match scene.interface.softer_hardness() {
        Some(hardness) => (
            pressure,
            hardness,
            ["nominal", "hardness"],
            "full contact carries no more; check the units of load and nominal area",
        ),
        None => (
            pressure / area_fraction,
            scene.interface.equivalent_modulus,
            ["real", "equivalent modulus"],
            "small strains do not hold; check the units of load, nominal area and modulus",
        ),
    };
    if value.is_nan() || value <= limit {
        return None;
    }
    let [area, name] = names;
    let fact = format!(
        "the mean pressure on the {area} area is {} Pa, above the {name} ({} Pa)",
        short(value),
        short(limit)
    );
    let found = Finding::warning(Code::BeyondFullContact, "pressure", value)
        .usual([0.0, limit])
        .unit("Pa")
        .of_model(model.id())
        .at(at)
        .fact(fact)
        .advice(advice);
    Some(found)
}
