//! Answers that no contact has, though a formula gives a number.

use asperity::{At, Check, Model, short};
use asperity_scene::SceneFile;

use crate::names::readable;
use crate::shown::shown;

/// Why the answer of a model at a load is impossible: a load that even a surface pressed flat does
/// not carry, a real area above the nominal one, or a mean contact pressure above the modulus.
pub(crate) fn impossible(
    file: &SceneFile,
    model: &Model,
    at: At,
    [area_fraction, mean_pressure]: [Option<f64>; 2],
) -> Option<String> {
    let scene = &file.scene;
    let pressure = at.pressure(scene)?;
    if let Some(reason) = beyond_full_contact(file, pressure) {
        return Some(reason);
    }
    if let Some(found) = area_fraction.and_then(|area| Check::no_answer(model, pressure, area)) {
        return Some(readable(&found.message()));
    }
    let modulus = scene.interface.equivalent_modulus;
    let ratio = mean_pressure.map(|mean| mean / modulus).filter(|ratio| *ratio > 1.0)?;
    Some(format!(
        "mean contact pressure is {} times the equivalent modulus: check the units of modulus and load",
        short(ratio)
    ))
}

/// Why no contact of the nominal area carries a mean pressure \[Pa\].
fn beyond_full_contact(file: &SceneFile, pressure: f64) -> Option<String> {
    let interface = &file.scene.interface;
    let hardness = interface.check().ok().and_then(|(hardness, ..)| hardness);
    let (limit, name, meaning) = match hardness {
        Some(hardness) => (hardness, "hardness", "more than a surface pressed flat carries"),
        None => (interface.equivalent_modulus, "equivalent modulus", "where strains are not small"),
    };
    (pressure > limit).then(|| {
        format!(
            "the load is {} on the nominal area, above the {name} ({}), {meaning}: check the units of load and nominal area",
            shown(pressure, "Pa"),
            shown(limit, "Pa")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Compiled;

    fn marks(text: &str, id: &str, at: At) -> Option<String> {
        let file = asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        Compiled::new(&file, id).unwrap().row(&file, id, at).0.mark
    }

    #[test]
    fn a_load_beyond_full_contact_has_a_mark_and_a_usual_one_none() {
        let text = asperity_scene::template();
        let found = marks(text, "persson-fudge", At::Load(1e30)).unwrap();
        assert!(
            found
                .starts_with("the load is 1e34 Pa on the nominal area, above the hardness (2 GPa)"),
            "{found}"
        );
        for id in ["gw", "ke", "persson-fudge"] {
            assert_eq!(marks(text, id, At::Load(100.0)), None);
        }
    }

    #[test]
    fn more_area_than_there_is_has_a_mark() {
        let text = include_str!("../../asperity-scene/examples/elastomer-on-glass.toml");
        let found = marks(text, "gw", At::Pressure(1.5e6)).unwrap();
        assert!(
            found.contains("real over nominal area is") && found.contains("above 1"),
            "{found}"
        );
        let heavy = marks(text, "persson", At::Pressure(1e7)).unwrap();
        assert!(heavy.contains("above the equivalent modulus (2.667 MPa)"), "{heavy}");
        assert_eq!(marks(text, "gw", At::Pressure(1e4)), None);
    }
}
