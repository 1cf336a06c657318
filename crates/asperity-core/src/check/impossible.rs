//! Answers that no contact has, though a formula gives a number.

use super::findings::{CROWDED, crowded};
use super::{Check, Scene};
use crate::finding::short;
use crate::recommended::WHOLE_SURFACE;
use crate::{At, ContactModel, Finding};

impl Check {
    /// The warning that a model's real area at a mean pressure is impossible: a load beyond full
    /// contact, or more area than the nominal one.
    #[must_use]
    pub fn impossible(
        model: &dyn ContactModel,
        scene: &Scene,
        pressure: f64,
        area_fraction: f64,
    ) -> Option<Finding> {
        let at = At::Pressure(pressure);
        beyond_full_contact(model, scene, at, [pressure, area_fraction])
            .or_else(|| Self::no_answer(model, pressure, area_fraction))
    }

    /// A warning where independent asperities of a model have so much area at a pressure that
    /// contacts merge.
    #[must_use]
    pub fn merging(model: &dyn ContactModel, pressure: f64, area_fraction: f64) -> Option<Finding> {
        let found = crowded(model, At::Pressure(pressure), area_fraction);
        found.filter(|_| model.validity().asperities)
    }

    /// A warning where a model's real area at a pressure exceeds the nominal area.
    #[must_use]
    pub fn no_answer(
        model: &dyn ContactModel,
        pressure: f64,
        area_fraction: f64,
    ) -> Option<Finding> {
        if area_fraction.is_nan() || area_fraction <= 1.0 {
            return None;
        }
        let found = Finding::warning("above-nominal", "area_fraction", area_fraction)
            .usual([0.0, CROWDED])
            .of_model(model.id())
            .at(At::Pressure(pressure))
            .fact(format!("the real area is {} times the nominal area", short(area_fraction)))
            .advice(format!(
                "check the units of modulus and load; at such loads use `{WHOLE_SURFACE}`"
            ));
        Some(found)
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
    let found = Finding::warning("beyond-full-contact", "pressure", value)
        .usual([0.0, limit])
        .unit("Pa")
        .of_model(model.id())
        .at(at)
        .fact(fact)
        .advice(advice);
    Some(found)
}
