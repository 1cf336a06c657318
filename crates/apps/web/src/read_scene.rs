//! A text as the page shows it: fields, findings, models and numbers of its scene.

use asperity::{Body, DerivedNumber, Described, Model};
use asperity_scene::{BODY, Field, HandedFiles, Key, Material, SceneFile, parse_handed};
use serde_json::{Value, json};

use crate::labels::{model_sentence, raised, term};
use crate::refusal::Refusal;
use crate::shown::{number, ranged, shown};
use crate::{answer, fields, labels, press, surface_keys};

/// Reads a text: the values of all keys as typed, how the surface is described, the files that it
/// names, and what its scene has. The scene is missing where the text has an error; its columns are
/// those of every scene then.
pub(crate) fn read(text: &str, files: &HandedFiles) -> (Value, Option<SceneFile>) {
    let typed = fields::fields(text);
    let mut found = json!({
        "way": surface_keys::way(&typed),
        "other": surface_keys::other_surface(&typed),
        "files": fields::files(text),
        "error": null, "findings": [], "numbers": [], "models": [], "usual": "", "scan": null,
    });
    let read = parse_handed(text, files).map_err(Refusal::from);
    found["fields"] = json!(typed);
    let columns = answer::columns(read.as_ref().ok());
    found["views"] = json!(columns);
    let derived = |of: &DerivedNumber| {
        let shown = ranged(of.value, of.ends, of.unit);
        number(&term(&of.name), shown, of.value, &raised(&of.meaning))
    };
    // A scene also needs numbers at all points of its ranges.
    let read = read.and_then(|file| Ok((file.check(None)?, file)));
    match read {
        Ok((check, file)) => {
            found["numbers"] = check.numbers.iter().map(derived).collect();
            let findings = file.warnings.iter().cloned().chain(file.findings()).collect();
            let findings = file.accepted(findings);
            // Values follow from a number that cannot be meant.
            found["implausible"] = findings.are_implausible().into();
            found["findings"] = findings.iter().map(labels::finding).collect();
            found["models"] = models(&file);
            // Of a csv of model, load, pressure and cells.
            found["head"] = answer::head(&columns, !file.unknowns().is_empty()).into();
            // The model that tables begin with.
            found["usual"] = asperity::usual_reference(&file.scene).into();
            found["scan"] = press::scan(&file).into();
            (found, Some(file))
        }
        Err(error) => {
            // Not a scene with an error, which is corrected in the page.
            if !fields::is_scene(text) {
                found["unreadable"] = error.message.clone().into();
            }
            found["error"] = json!(error);
            (found, None)
        }
    }
}

/// The models of a scene, those that it does not allow with the reason.
fn models(file: &SceneFile) -> Value {
    // Those in the middle of the ranges are those at their ends.
    let known = file.middle();
    let (allowed, left_out) = known.as_ref().unwrap_or(file).models_beside_bem();
    let shown = |model: &Model, reason: Option<String>| {
        json!({
            "id": model.id(),
            "about": model_sentence(model),
            // Averages over contact angles take seconds to prepare.
            "slow": model.validity().angles,
            "equal": model.equal().id(),
            "reason": reason,
        })
    };
    let left_out = left_out.iter().filter_map(|left_out| {
        Some(shown(&left_out.id.parse().ok()?, Some(raised(&left_out.reason.to_string()))))
    });
    allowed.iter().map(|model| shown(model, None)).chain(left_out).collect()
}

/// A material of the list, with its numbers and where they were read.
pub(crate) fn material(material: &Material) -> Value {
    let body = &material.body;
    let number = |field: &Field<Body>| {
        let unit = Key::find("body", field.name)?.unit.replace("ohm", "Ω");
        Some(format!("{} {}", term(field.name), shown((field.get)(body)?, &unit)))
    };
    let shown = BODY.iter().filter_map(number).collect::<Vec<_>>().join(", ");
    let Material { id, name, source, .. } = material;
    json!({ "id": id, "name": name, "shown": shown, "source": source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_has_fields_models_and_files_and_a_wrong_one_its_error() {
        let (found, file) = read(asperity_scene::template(), &HandedFiles::new());
        assert!(file.is_some() && found["error"].is_null());
        let models = found["models"].as_array().unwrap();
        assert!(models.iter().any(|model| model["id"] == "at" && model["slow"] == true));
        let gw = models.iter().find(|model| model["id"] == "gw").unwrap();
        let slow = models.iter().filter(|model| model["slow"] == true).map(|model| &model["id"]);
        let known = ["gao", "at", "at-additive", "at-overlap"];
        assert!(
            slow.clone().count() > 1
                && slow.clone().all(|id| known.iter().any(|known| id == known))
        );
        assert!(gw["slow"] == false && gw["reason"].is_null());
        assert!(gw["about"].as_str().unwrap().contains("(1966)"));
        let (found, file) = read("[surface]\nfile = \"a.x3p\"\n", &HandedFiles::new());
        assert!(file.is_none() && !found["error"].is_null());
        assert_eq!((&found["way"], &found["files"]), (&json!("scan"), &json!(["a.x3p"])));
        assert!(found["unreadable"].is_null());
        for text in ["[surface]\nm0 = \n", "\u{fffd}PNG", "a = 1\n", ""] {
            let (found, _) = read(text, &HandedFiles::new());
            assert!(found["unreadable"].is_string(), "{text}: {found}");
        }
    }

    #[test]
    fn materials_are_shown_with_their_numbers_and_source() {
        let all: Vec<_> = asperity_scene::materials().iter().map(material).collect();
        assert!(all.len() >= 25);
        let text = |one: &Value, key: &str| one[key].as_str().unwrap().to_string();
        assert!(all.iter().all(|one| text(one, "shown").starts_with("Young's modulus ")
            && !text(one, "source").is_empty()));
        let copper = all.iter().find(|one| one["id"] == "copper-hot-rolled").unwrap();
        assert!(text(copper, "shown").contains("539.4 MPa"), "{copper}");
    }
}
