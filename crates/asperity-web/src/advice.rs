//! Findings about a scene at a load, and which model to trust there.

use std::collections::BTreeMap;

use asperity::{At, Described, Diagnostics, Quantity, Request, Severity, nearest_to_bem, unranked};
use asperity_scene::SceneFile;
use serde::{Deserialize, Serialize};

use crate::names::{quantity_name, readable};
use crate::refusal::Refusal;

/// Largest deviation of a simpler model from the reference.
const WITHIN: f64 = 0.1;
/// What models are compared in with a solved contact.
const COMPARED: [Quantity; 3] =
    [Quantity::AreaFraction, Quantity::Tangent, Quantity::UnloadingStiffness];

/// Which model to trust, and on what evidence.
#[derive(Debug, Serialize)]
pub(crate) struct Advice {
    pub(crate) reference: String,
    pub(crate) simplest: Option<String>,
    /// Sentences: first about the contact that was solved, then the verdict.
    pub(crate) summary: Vec<String>,
}

/// What boundary elements and models give at the load of the page.
#[derive(Debug, Default, Deserialize)]
pub(crate) struct OnScreen {
    /// Values of boundary elements, by quantity.
    bem: BTreeMap<String, f64>,
    /// Codes of the notes of the solution.
    notes: Vec<String>,
    /// Values of the chosen models, by model and quantity, with all digits.
    models: Vec<(String, BTreeMap<String, String>)>,
}

impl OnScreen {
    /// How far the models are from boundary elements, a sentence a quantity, and why that is
    /// uncertain.
    fn sentences(&self) -> Vec<String> {
        let codes = self.notes.iter().map(String::as_str).collect();
        let reason = unranked(&[codes]).and_then(|text| text.split_once(": ")).map(|(_, text)| {
            let text = text.replace(" at every load", "");
            format!("on this scan at this load, these deviations are uncertain: {text}")
        });
        let of = |quantity: Quantity| {
            let name = quantity.to_string();
            let solved = *self.bem.get(&name).filter(|solved| **solved > 0.0)?;
            let off = |(id, values): &(String, BTreeMap<String, String>)| {
                let value = values.get(&name).and_then(|digits| digits.parse::<f64>().ok());
                (id.clone(), vec![value.map(|value| value / solved - 1.0)])
            };
            let all: Vec<(String, Vec<Option<f64>>)> = self.models.iter().map(off).collect();
            let models = all.iter().map(|(id, off)| (id.as_str(), off.clone()));
            let nearest = nearest_to_bem(&quantity_name(quantity), models, all.len())?;
            Some(format!("on this scan at this load, {nearest}"))
        };
        let found: Vec<String> = COMPARED.into_iter().filter_map(of).collect();
        let reason = reason.filter(|_| !found.is_empty());
        found.into_iter().chain(reason).collect()
    }
}

/// Findings about the scene and about these models at a load.
pub(crate) fn check(file: &SceneFile, ids: &[String], at: At) -> Result<Diagnostics, Refusal> {
    let mut found: Diagnostics = file.warnings.iter().cloned().chain(file.findings()).collect();
    let valid = !found.iter().any(|found| found.severity == Severity::Error);
    if valid {
        for id in ids {
            let model = file.model(id)?;
            found.extend(file.findings_at(&model, &[at]));
        }
    }
    Ok(file.accepted(found))
}

/// Compares the models that the scene allows with each other, with boundary elements on surfaces
/// like it and, if the load was solved, with boundary elements on its scan.
pub(crate) fn advise(
    file: &SceneFile,
    at: At,
    on_screen: Option<&OnScreen>,
) -> Result<Advice, Refusal> {
    let (models, _) = file.models_beside_bem();
    let reference = file.model(asperity::usual_reference(&file.scene))?;
    let request = Request::new([Quantity::Area, Quantity::Tangent]).at([at]);
    let advice = file.recommend_among(models, &request, &reference, WITHIN)?;
    let verdict = advice.verdict(|model| model.name().to_string());
    let solved = on_screen.map(OnScreen::sentences).unwrap_or_default();
    let expected = [verdict].into_iter().chain(advice.summary());
    Ok(Advice {
        reference: reference.id().into(),
        simplest: advice.simplest.as_ref().map(|model| model.id().into()),
        summary: solved.into_iter().chain(expected.map(|line| readable(&line))).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn on_screen(notes: &[&str]) -> OnScreen {
        let models = serde_json::json!([
            ["gw", { "area-fraction": "0.06", "tangent": "9e7" }],
            ["ke", { "area-fraction": "0.087", "tangent": "1.2e8", "unloading-stiffness": "2e8" }],
            ["gao", { "tangent": "" }],
        ]);
        let bem =
            serde_json::json!({ "area-fraction": 0.1, "tangent": 1e8, "unloading-stiffness": 2e8 });
        let given = serde_json::json!({ "bem": bem, "notes": notes, "models": models });
        serde_json::from_value(given).unwrap()
    }

    #[test]
    fn a_solved_load_has_a_sentence_for_each_quantity() {
        let start = "on this scan at this load, nearest to boundary elements in";
        assert_eq!(
            on_screen(&["short"]).sentences(),
            [
                format!("{start} real over nominal area are ke (13 % low), gw (40 % low)"),
                format!(
                    "{start} tangent stiffness (first loading) are gw (10 % low), ke (20 % high)"
                ),
                format!("{start} unloading stiffness are ke (less than 1 % off)"),
            ]
        );
        let few = on_screen(&["few-pixels"]).sentences();
        let wanted = "these deviations are uncertain: too few pixels or patches are in contact";
        assert!(few.len() == 4 && few[3].contains(wanted), "{few:?}");
    }

    #[test]
    fn advice_begins_with_what_was_solved_and_names_each_stiffness() {
        let file = asperity_scene::parse(asperity_scene::template(), std::path::Path::new("."));
        let (file, solved) = (file.unwrap(), on_screen(&[]));
        let advice = advise(&file, At::Pressure(1e6), Some(&solved)).unwrap();
        assert!(advice.summary[0].starts_with("on this scan"), "{:?}", advice.summary);
        assert!(advice.summary[3].contains("simplest"), "{:?}", advice.summary);
        let nearest = &advice.summary[4..];
        assert!(nearest[0].contains("in real over nominal area are"), "{nearest:?}");
        assert!(nearest[1].contains("in tangent stiffness (first loading) are"), "{nearest:?}");
        assert!(nearest.iter().all(|line| !line.contains("area_fraction")));
        assert_eq!(advise(&file, At::Pressure(1e6), None).unwrap().summary[0], advice.summary[3]);
    }
}
