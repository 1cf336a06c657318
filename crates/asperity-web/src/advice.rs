//! Findings about a scene at a load, and which model to trust there.

use std::collections::BTreeMap;

use asperity::{
    At, Compared, Described, Finding, Findings, Quantity, Request, Severity, nearest_to_bem,
};
use asperity_answer::{Asked, unranked};
use asperity_inputs::SceneFile;

use crate::dialect::{quantity_name, said};
use crate::message::OnScreen;
use crate::press;
use crate::refusal::Refusal;

/// Largest deviation of a simpler model from the reference, as that of the program.
const WITHIN: f64 = 0.05;
/// What models are compared in with a solved contact.
const COMPARED: [Quantity; 3] =
    [Quantity::AreaFraction, Quantity::Tangent, Quantity::UnloadingStiffness];

impl OnScreen {
    /// Deviations of the models from boundary elements in a quantity, by id.
    fn deviations(&self, quantity: Quantity) -> Vec<(&str, Option<f64>)> {
        let name = quantity.to_string();
        let number = |values: &BTreeMap<String, String>| values.get(&name)?.parse::<f64>().ok();
        let Some(solved) = number(&self.bem).filter(|solved| *solved > 0.0) else {
            return vec![];
        };
        let off = |values| number(values).map(|value| value / solved - 1.0);
        self.models.iter().map(|(id, values)| (id.as_str(), off(values))).collect()
    }

    /// Which of these models to use, how far all are from boundary elements, a sentence a quantity,
    /// and why that is uncertain; `ignoring` are the models that ignore yielding here.
    fn sentences(&self, ignoring: &[&str]) -> Vec<String> {
        let here = "on this scan at this load";
        let (mut found, mut uses) = (vec![], vec![]);
        for quantity in COMPARED {
            let (off, name) = (self.deviations(quantity), quantity_name(quantity));
            let models = off.iter().map(|(id, off)| (*id, vec![*off]));
            let nearest = nearest_to_bem(&name, models, off.len());
            found.extend(nearest.map(|nearest| format!("{here}, {nearest}")));
            // The nearest of those that describe yielding where it matters.
            let off = off.into_iter().filter(|(id, _)| !ignoring.contains(id));
            let off = off.filter_map(|(id, off)| Some((id, off?.abs())));
            let best = off.min_by(|a, b| a.1.total_cmp(&b.1));
            uses.extend(best.map(|(id, _)| format!("{id} for {name}")));
        }
        if found.is_empty() {
            return found;
        }
        let codes = self.notes.iter().map(String::as_str).collect();
        match unranked(&[codes]) {
            Some(why) => found.push(format!("{here}, these deviations are uncertain: {why}")),
            None if uses.is_empty() => {}
            None => found.insert(0, format!("of the chosen models, use {}", uses.join(", "))),
        }
        if !ignoring.is_empty() {
            let ids = ignoring.join(", ");
            found.push(format!(
                "{ids}: yielding is ignored, and an agreement at this load is by chance"
            ));
        }
        found
    }
}

/// Findings about the scene and about these models at a load.
pub(crate) fn check(
    file: &SceneFile,
    models: &[(&str, Result<&Asked, &String>)],
    at: At,
) -> Findings {
    let of_scene = file.warnings.iter().cloned().chain(file.findings());
    let answering = models.iter().filter_map(|(_, asked)| asked.ok());
    let of_answers = answering.flat_map(|asked| {
        let [found, _] = asked.findings(file, &[at]);
        found
    });
    // The table of values marks it at each model.
    let unmarked = |found: &Finding| found.code != "beyond-full-contact";
    file.accepted(of_scene.chain(of_answers).filter(unmarked).collect())
}

/// Compares the models that the scene allows with boundary elements on its scan, if the load was
/// solved, and on surfaces like it; without either, with each other: sentences, the best evidence
/// first.
pub(crate) fn advise(
    file: &SceneFile,
    at: At,
    on_screen: Option<&OnScreen>,
) -> Result<Vec<String>, Refusal> {
    let (models, _) = file.models_beside_bem();
    let reference = file.model(asperity::usual_reference(&file.scene))?;
    let request = Request::new([Quantity::Area, Quantity::Tangent]).at([at]);
    let advice = file.recommend_among(models, &request, &reference, WITHIN)?;
    let mut summary = match on_screen {
        Some(solved) => solved.sentences(&ignoring_yielding(file, at, solved)),
        None => vec![],
    };
    let solved = !summary.is_empty();
    let names = [Quantity::AreaFraction, Quantity::Tangent].map(quantity_name);
    let names = [(Compared::Area, &*names[0]), (Compared::Stiffness, &*names[1])];
    let close = advice.evidence.iter().any(|place| place.expected.is_ok());
    let mut lines = advice.summary_named(&names);
    if let (false, Some(last)) = (close || solved, lines.last_mut()) {
        let scan = press::scan(file).is_some_and(|scan| scan["refused"].is_null());
        *last += match scan {
            true => "; solve this load by boundary elements",
            false => "; choose a scan or make a random surface, and solve this load",
        };
    }
    if close {
        lines.iter_mut().for_each(|line| line.insert_str(0, "on solved surfaces like this one, "));
    }
    if !close && !solved {
        let verdict = advice.verdict();
        let fitted = match reference.id() {
            "ke" => " (ke, fitted to finite elements of one asperity, is the reference)",
            _ => "",
        };
        summary.push(format!("{verdict}{fitted}"));
    }
    summary.extend(lines);
    Ok(summary.iter().map(|line| said(line)).collect())
}

/// The models on the page that ignore yielding where it matters.
fn ignoring_yielding<'m>(file: &SceneFile, at: At, solved: &'m OnScreen) -> Vec<&'m str> {
    let ignores = |id: &&str| {
        let found = file.model(id).map(|model| file.findings_at(&model, &[at]));
        let yields =
            |found: &Finding| found.code == "yields" && found.severity == Severity::Warning;
        found.is_ok_and(|found| found.iter().any(yields))
    };
    solved.models.iter().map(|(id, _)| id.as_str()).filter(ignores).collect()
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
        let bem = serde_json::json!({ "area-fraction": "0.1", "tangent": "1e8", "unloading-stiffness": "2e8" });
        let given = serde_json::json!({ "bem": bem, "notes": notes, "models": models });
        serde_json::from_value(given).unwrap()
    }

    #[test]
    fn a_solved_load_has_a_verdict_and_a_sentence_for_each_quantity() {
        let here = "on this scan at this load";
        let start = format!("{here}, nearest to boundary elements in");
        let found = on_screen(&["short"]).sentences(&["gw"]);
        assert_eq!(
            found,
            [
                "of the chosen models, use ke for real over nominal area, ke for tangent stiffness (first loading), ke for unloading stiffness".into(),
                format!("{start} real over nominal area are ke (13 % low), gw (40 % low)"),
                format!(
                    "{start} tangent stiffness (first loading) are gw (10 % low), ke (20 % high)"
                ),
                format!("{start} unloading stiffness is ke (less than 1 % off)"),
                "gw: yielding is ignored, and an agreement at this load is by chance".into(),
            ]
        );
        let all = on_screen(&[]).sentences(&[]);
        assert!(all.len() == 4 && all[0].contains("gw for tangent stiffness"), "{all:?}");
        let few = on_screen(&["few-pixels"]).sentences(&[]);
        let wanted = "these deviations are uncertain: too few pixels or patches are in contact";
        assert!(few.len() == 4 && few[3].contains(wanted), "{few:?}");
    }

    #[test]
    fn the_best_evidence_comes_first_and_models_are_compared_without_any() {
        let parse = |text: &str| asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        let (file, solved) = (parse(asperity_inputs::template()), on_screen(&[]));
        let advice = advise(&file, At::Pressure(1e8), Some(&solved)).unwrap();
        assert!(advice[0].starts_with("of the chosen models, use"), "{advice:?}");
        assert!(advice[0].contains("ke for tangent stiffness"), "{advice:?}");
        let [.., area, stiffness] = &advice[..] else { panic!() };
        let like = "on solved surfaces like this one, nearest to boundary elements in";
        assert!(area.starts_with(&format!("{like} real over nominal area are")), "{area}");
        assert!(stiffness.contains("in tangent stiffness (first loading) are"), "{stiffness}");
        let without = advise(&file, At::Pressure(1e8), None).unwrap();
        assert_eq!(without, [area.clone(), stiffness.clone()]);
        // The plasticity index of the bolted joint is above those that were solved.
        let joint = parse(include_str!("../../asperity-inputs/examples/bolted-joint.toml"));
        let [verdict, none] = &advise(&joint, At::Pressure(1e6), None).unwrap()[..] else {
            panic!()
        };
        assert!(verdict.contains("within 5 % of ke (ke, fitted"), "{verdict}");
        assert!(
            none.contains("plasticity index = ") && none.ends_with("solve this load"),
            "{none}"
        );
    }

    #[test]
    fn a_reference_is_not_compared_with_itself() {
        let text = include_str!("../../asperity-inputs/examples/elastomer-on-glass.toml");
        let file = asperity_inputs::parse(text, std::path::Path::new(".")).unwrap();
        let advice = advise(&file, At::Pressure(1e4), None).unwrap();
        let itself = advice.iter().any(|line| line.contains("% of gw; use gw"));
        let close = advice[0].starts_with("on solved surfaces");
        assert!(itself || close, "{advice:?}");
    }
}
