//! A text as the page shows it: fields, findings, models and numbers of its scene.

use std::collections::BTreeMap;

use asperity::{Body, Described, Dialect, HARDNESS_OVER_YIELD, Model, shortest_digits};
use asperity_inputs::{BODY, Field, HandedFiles, Key, Material, SceneFile, parse_handed};

use crate::dialect::{PAGE, model_name, said, symbols};
use crate::message::{MaterialShown, ModelShown, NumberShown, Shown};
use crate::model_sentence::model_sentence;
use crate::refusal::Refusal;
use crate::shown::shown;
use crate::{answer, dialect, fields, press, surface_keys};

/// The longest text of a scene, in bytes, as for scene files.
const MOST_TEXT: usize = 1 << 20;

/// Reads a text; the scene is missing where it has an error.
pub(crate) fn read(text: &str, files: &HandedFiles) -> (Shown, Option<SceneFile>) {
    let mut found = Shown {
        fields: BTreeMap::new(),
        way: "asperities",
        files: vec![],
        error: None,
        findings: vec![],
        numbers: vec![],
        models: vec![],
        usual: "",
        views: answer::views(None),
        scan: None,
    };
    if text.len() > MOST_TEXT {
        let reason = format!("the scene file is longer than {MOST_TEXT} bytes: shorten the text");
        found.error = Some(Refusal::at("the scene file", reason));
        return (found, None);
    }
    found.fields = fields::fields(text);
    found.way = surface_keys::way(&found.fields);
    found.files = fields::files(text);
    let file = match parse_handed(text, files) {
        Ok(file) => file,
        Err(error) => {
            found.error = Some(Refusal::of(error, &found.fields));
            return (found, None);
        }
    };
    if let Ok(check) = file.check(None) {
        found.numbers = check.numbers.iter().map(number).collect();
    }
    let findings = file.warnings.iter().cloned().chain(file.findings()).collect();
    found.findings = dialect::findings(&file.accepted(findings), &file);
    (found.models, found.views) = (models(&file), answer::views(Some(&file)));
    found.usual = asperity::usual_reference(&file.scene);
    found.scan = press::scan(&file);
    (found, Some(file))
}

/// The models of a scene, those that it does not allow with the reason.
fn models(file: &SceneFile) -> Vec<ModelShown> {
    let (allowed, left_out) = file.models_beside_bem();
    let shown = |model: &Model, reason: Option<String>| {
        ModelShown {
            id: model.id().into(),
            name: model_name(model).into(),
            about: model_sentence(model),
            // Averages over contact angles take seconds to prepare.
            slow: model.validity().angles,
            whole: model.asperity_model().is_none(),
            reason,
        }
    };
    let mut all: Vec<ModelShown> = allowed.iter().map(|model| shown(model, None)).collect();
    all.extend(left_out.iter().filter_map(|left_out| {
        Some(shown(&left_out.id.parse().ok()?, Some(said(&left_out.reason.marked()))))
    }));
    all
}

pub(crate) fn material(material: &'static Material) -> MaterialShown {
    let body = &material.body;
    let number = |field: &Field<Body>| {
        let Key { symbol, unit, .. } = Key::find("body", field.name)?;
        let value = (field.get)(body)?;
        Some(format!("{symbol} {}", shown(value, &unit.replace("ohm", "Ω"))))
    };
    let mut shown = BODY.iter().filter_map(number).collect::<Vec<_>>().join(", ");
    if let (None, Some(strength)) = (body.hardness, body.yield_strength) {
        let hardness = self::shown(HARDNESS_OVER_YIELD * strength, "Pa");
        shown += &format!(
            "; hardness {hardness} ({HARDNESS_OVER_YIELD} times the yield strength; metals that \
             harden are harder: a measured hardness is better)"
        );
    }
    MaterialShown { id: &material.id, name: &material.name, shown, source: &material.source }
}

pub(crate) fn number(number: &asperity::DerivedNumber) -> NumberShown {
    NumberShown {
        name: PAGE.term(number.name),
        digits: shortest_digits(number.value),
        shown: shown(number.value, number.unit),
        meaning: symbols(&number.meaning),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_has_fields_models_and_files_and_a_wrong_one_its_error() {
        let (found, file) = read(asperity_inputs::template(), &HandedFiles::new());
        assert!(file.is_some() && found.error.is_none());
        assert!(found.models.iter().any(|model| model.id == "at" && model.slow));
        let gw = found.models.iter().find(|model| model.id == "gw").unwrap();
        let slow = found.models.iter().filter(|model| model.slow).map(|model| model.id.as_str());
        let known = ["gao", "at", "at-additive", "at-overlap"];
        assert!(slow.clone().count() > 1 && slow.clone().all(|id| known.contains(&id)));
        assert!(!gw.slow && gw.reason.is_none() && gw.about.contains("(1966)"));
        let (found, file) = read("[surface]\nfile = \"a.x3p\"\n", &HandedFiles::new());
        assert!(file.is_none() && found.error.is_some());
        assert_eq!((found.way, found.files), ("scan", vec!["a.x3p".to_string()]));
        let (found, _) = read(&"#".repeat(MOST_TEXT + 1), &HandedFiles::new());
        assert!(found.error.unwrap().message.contains("longer than"));
    }

    #[test]
    fn materials_are_shown_with_their_numbers_and_source() {
        let all: Vec<_> = asperity_inputs::materials().iter().map(material).collect();
        assert!(all.len() >= 25);
        assert!(all.iter().all(|one| one.shown.starts_with("E ") && !one.source.is_empty()));
        let copper = all.iter().find(|one| one.id == "copper-hot-rolled").unwrap();
        let hardness = "; hardness 193.2 MPa (2.8 times the yield strength; ";
        assert!(copper.shown.contains(hardness), "{}", copper.shown);
    }
}
