//! Answers that no contact has, though a formula gives a number.

use asperity::{At, Check, Model, Severity};
use asperity_inputs::SceneFile;

use crate::dialect::PAGE;

/// Why the real over nominal area of a model at a load is that of no contact; nothing for a scene
/// with an error, of which it may be a consequence.
pub(crate) fn impossible(
    file: &SceneFile,
    model: &Model,
    at: At,
    area_fraction: Option<f64>,
) -> Option<String> {
    let pressure = at.pressure(&file.scene)?;
    let found = Check::impossible(model, &file.scene, pressure, area_fraction?)?;
    let valid = file.findings().at_least(Severity::Error).is_empty();
    valid.then(|| found.say(&PAGE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::Compiled;

    fn marks(text: &str, id: &str, at: At) -> Option<String> {
        let file = asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        Compiled::new(&file, id).unwrap().row(&file, id, at).0.mark
    }

    #[test]
    fn a_load_beyond_full_contact_has_a_mark_and_a_usual_one_none() {
        let text = asperity_inputs::template();
        let found = marks(text, "persson-fudge", At::Load(1e30)).unwrap();
        assert!(found.contains("nominal area is 1e34 Pa, above the hardness (2e9 Pa)"), "{found}");
        for id in ["gw", "ke", "persson-fudge"] {
            assert_eq!(marks(text, id, At::Load(100.0)), None);
        }
    }

    #[test]
    fn more_area_than_there_is_has_a_mark() {
        let text = include_str!("../../asperity-inputs/examples/elastomer-on-glass.toml");
        let found = marks(text, "gw", At::Pressure(1.5e6)).unwrap();
        assert!(
            found.contains("real over nominal area is") && found.contains("above 1"),
            "{found}"
        );
        let heavy = marks(text, "persson", At::Pressure(1e7)).unwrap();
        assert!(heavy.contains("above the equivalent modulus (2.667e6 Pa)"), "{heavy}");
        assert_eq!(marks(text, "gw", At::Pressure(1e4)), None);
    }

    #[test]
    fn a_load_is_not_blamed_for_a_wrong_unit_of_a_field() {
        let text = asperity_inputs::template().replacen("210e9", "210", 1);
        assert_eq!(marks(&text, "gw", At::Load(100.0)), None);
    }
}
