//! The answer at a load as the page shows it, how far models are from it, and findings.

use std::collections::BTreeMap;

use asperity::{At, Finding, Findings, Severity, shortest_digits};
use asperity_answer::Asked;
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::answer::{cell, columns};
use crate::best::{Best, Known, Source, numbers};
use crate::dialect::PAGE;
use crate::shown::{interval, percent, shown};
use crate::span::Load;

/// The first line: quantities with their units and names. Models are held against the answer in the
/// first two, area and stiffness.
const FIRST: [(&str, &str, &str); 3] = [
    ("area-fraction", "%", "real area"),
    ("tangent", "N/m", "first-loading stiffness"),
    ("unloading-stiffness", "N/m", "unloading stiffness"),
];
/// A model farther than this from boundary elements is out of its range.
const FAR: f64 = 0.3;
/// The model that shows whether contacts yield, as it ignores that.
pub(crate) const ELASTIC: &str = "gw";

/// How far a row is from the answer in area and stiffness, in percent.
struct Against([Option<f64>; 2]);

impl Against {
    /// None for the model whose values are the answer.
    fn of(best: &Best, row: &Value) -> Option<Self> {
        let found: BTreeMap<&str, f64> = numbers(row).collect();
        let off = |k: usize| {
            let (quantity, ..) = FIRST[k];
            Some(found.get(quantity)? / best.value(quantity)?.value - 1.0)
        };
        let is_own = best.source == Source::Model && row["model"] == best.model;
        let off = [off(0), off(1)];
        (!is_own && off != [None; 2]).then_some(Self(off))
    }

    /// The larger of the two.
    fn off(&self) -> f64 {
        self.0.iter().flatten().fold(0.0, |most: f64, off| most.max(off.abs()))
    }

    fn words(&self) -> String {
        let [area, stiffness] = self.parts();
        format!("area {area}, stiffness {stiffness}")
    }

    fn short(&self) -> String {
        self.parts().join(", ")
    }

    fn parts(&self) -> [String; 2] {
        self.0.map(|off| off.map_or("–".into(), percent))
    }
}

/// Adds to a row how far it is from the answer, and why it is out of the range of its model, if it
/// is.
pub(crate) fn hold_against(best: &Best, row: &mut Value, judged: Option<&Judged>) {
    let against = Against::of(best, row);
    let is_far = against.as_ref().is_some_and(|against| against.off() > FAR);
    let far = || format!("more than {} from the answer", percent(FAR));
    let far = (best.source != Source::Model && is_far).then(far);
    row["outside"] = judged.and_then(|of| of.outside.clone()).or(far).into();
    if let Some(against) = against {
        row["against"] = json!({ "words": against.words(), "short": against.short(), "off": against.off(), "lacks": against.0[1].is_none() });
    }
}

/// Which of the shown models to use, by id, and how far it is from the answer: the nearest. One
/// that ignores yielding is near by chance, and has the next beside it.
fn model_to_use(best: &Best, rows: &[Value], ignores: impl Fn(&str) -> bool) -> Value {
    if best.source == Source::Model {
        return json!({ "model": best.model, "says": "recommended; not compared here" });
    }
    let of = |row: &Value| {
        let against = Against::of(best, row).filter(|_| row["mark"].is_null())?;
        // Models without a stiffness come last.
        Some((against.0[1].is_none(), against, row["model"].as_str()?.to_string()))
    };
    let mut near: Vec<_> = rows.iter().filter_map(of).collect();
    near.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.off().total_cmp(&b.1.off())));
    let Some((_, against, id)) = near.first() else { return Value::Null };
    let mut says = against.words();
    if ignores(id) {
        says += ", by chance: it ignores yielding";
        if let Some((_, other, next)) = near.iter().find(|(.., id)| !ignores(id)) {
            says += &format!("; {next} {}", other.short());
        }
    }
    json!({ "model": id, "says": says })
}

/// The answer beside the rows of the shown models.
pub(crate) fn answer(
    best: &Best,
    file: &SceneFile,
    load: &Load,
    rows: &[Value],
    judged: &BTreeMap<String, Judged>,
) -> Value {
    let cells: Vec<Value> = columns(file)
        .map(|(quantity, unit)| match best.value(&quantity) {
            Some(known) => with_ends(cell(&quantity, unit, Ok(known.value)), known),
            // A value of the model has its place in the row of the model.
            None => json!({ "quantity": quantity, "shown": "no evidence" }),
        })
        .collect();
    let index = file.scene.plasticity_index().ok();
    let yields = |id: &str| judged.get(id).and_then(|of| of.yields);
    let plasticity = match yields(ELASTIC) {
        _ if index.is_none() => "no hardness: elastic",
        None => "nothing yields",
        Some(Severity::Note) => "a few contacts yield",
        Some(_) => "contacts yield",
    };
    let to_use = model_to_use(best, rows, |id| {
        yields(id).is_some_and(|severity| severity != Severity::Note)
    });
    let first = FIRST.map(|part| first(best, part));
    let said: Vec<String> =
        first.iter().map(|part| text(&part["name"]) + " " + &text(&part["shown"])).collect();
    let spoken = format!("At {}: {}; use {}", load.text, said.join(", "), text(&to_use["model"]));
    let decimals = index.map_or(0, |index| usize::from(index < 10.0));
    json!({
        "source": best.source,
        "first": first,
        "row": { "model": "answer", "cells": cells },
        "plasticity": {
            "digits": index.map(shortest_digits),
            "shown": index.map_or("–".into(), |index| format!("{index:.decimals$}")),
            "says": plasticity,
        },
        "use": to_use,
        "basis": best.basis,
        "surface": format!("Sq {}", shown(file.scene.surface.moments().m0.sqrt(), "m")),
        "spoken": spoken,
    })
}

/// A part of the first line.
fn first(best: &Best, (quantity, unit, name): (&str, &str, &str)) -> Value {
    let Some(known) = best.values.get(quantity) else {
        let by = format!("{} has none", best.model);
        return json!({ "name": name, "shown": "–", "by": by });
    };
    let (shown, range) = interval(known.value, known.ends, unit);
    let by = match known.source {
        Source::Model if best.source == Source::Model => format!("by {}", best.model),
        Source::Model => format!("by {}; no evidence", best.model),
        Source::Evidence => range,
        Source::Solved => "on this scan".into(),
    };
    let mut part = with_ends(cell(quantity, unit, Ok(known.value)), known);
    (part["name"], part["shown"], part["by"]) = (name.into(), shown.into(), by.into());
    part
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().into()
}

/// A cell with the ends of its interval.
fn with_ends(mut cell: Value, known: &Known) -> Value {
    if let Some(ends) = known.ends {
        let [lower, upper] = ends.map(shortest_digits);
        (cell["lower"], cell["upper"]) = (lower.into(), upper.into());
    }
    cell
}

/// What is known of a model at a load.
pub(crate) struct Judged {
    /// How it ignores yielding, if it does.
    yields: Option<Severity>,
    /// Why the load is out of its range.
    pub(crate) outside: Option<String>,
}

impl Judged {
    /// A model of a scene at a load.
    pub(crate) fn of(file: &SceneFile, asked: &Asked, at: At) -> Self {
        let [found, _] = asked.findings(file, &[at]);
        let yields = found.iter().find(|found| found.code == "yields").map(|found| found.severity);
        let is_outside = |found: &&Finding| {
            found.is_of_model() && found.code != "yields" && found.severity != Severity::Note
        };
        let outside = found.iter().find(is_outside).map(|found| found.say(&PAGE));
        Self { yields, outside }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Desk;

    const SEAL: &str = include_str!("../../asperity-inputs/examples/lapped-seal.toml");
    const JOINT: &str = include_str!("../../asperity-inputs/examples/bolted-joint.toml");

    /// The joint of an alloy so soft that no like surface was solved.
    fn joint() -> String {
        JOINT.replace("= 275e6", "= 140e6")
    }

    /// The answer of the page for a scene at a load, with values solved there.
    fn page_at(text: &str, load: &str, solved: Value) -> Value {
        let mut desk = Desk::default();
        let mut ask = |message: Value| -> Value {
            serde_json::from_str(&desk.call(&message.to_string())).unwrap()
        };
        ask(json!({ "call": "show", "text": text }));
        let models = ["gw", "ke", "jg", "persson-fudge"];
        let asked = json!({ "call": "answer", "models": models, "load": { "text": load }, "solved": solved });
        ask(asked)["ok"].clone()
    }

    fn row<'v>(told: &'v Value, id: &str) -> &'v Value {
        told["rows"].as_array().unwrap().iter().find(|row| row["model"] == id).unwrap()
    }

    #[test]
    fn an_answer_is_the_corrected_value_and_models_are_held_against_it() {
        let found = page_at(SEAL, "1 MPa", json!([]));
        let (answer, ke) = (&found["answer"], row(&found, "ke"));
        assert_eq!(answer["source"], "evidence");
        let file = asperity_inputs::parse(SEAL, std::path::Path::new(".")).unwrap();
        let corrected =
            crate::answer::compile(&file, "ke").unwrap().corrected(&file, "ke").unwrap();
        let wanted = corrected.at(At::Pressure(1e6)).unwrap();
        let wanted = wanted.value(asperity::Quantity::AreaFraction).unwrap();
        let area = &answer["first"][0];
        for (end, wanted) in
            [("digits", wanted.value), ("lower", wanted.lower), ("upper", wanted.upper)]
        {
            let found: f64 = area[end].as_str().unwrap().parse().unwrap();
            assert!((found / wanted - 1.0).abs() < 1e-12, "{end}: {found} {wanted}");
        }
        let own: f64 = ke["cells"][1]["digits"].as_str().unwrap().parse().unwrap();
        let words = ke["against"]["words"].as_str().unwrap();
        assert!(
            words.starts_with(&format!("area {}, stiffness ", percent(own / wanted.value - 1.0))),
            "{words}"
        );
        // The model to use is one of those shown, and the nearest.
        let rows = found["rows"].as_array().unwrap().iter();
        let known = |row: &&Value| !row["against"]["words"].to_string().contains('–');
        let least = rows.filter(known).filter_map(|row| row["against"]["off"].as_f64());
        let to_use = row(&found, answer["use"]["model"].as_str().unwrap());
        let (of_use, least) = (to_use["against"]["off"].as_f64().unwrap(), least.reduce(f64::min));
        assert!(of_use <= least.unwrap(), "{answer}");
    }

    #[test]
    fn without_evidence_the_recommended_model_answers() {
        let found = page_at(&joint(), "1 MPa", json!([]));
        let answer = &found["answer"];
        assert_eq!((&answer["source"], &answer["use"]["model"]), (&json!("model"), &json!("ke")));
        let basis = answer["basis"].as_str().unwrap();
        assert!(basis.starts_with("No evidence here (plasticity index = "), "{basis}");
        assert_eq!(answer["first"][1]["digits"], row(&found, "ke")["cells"][2]["digits"]);
        assert!(answer["first"][1]["lower"].is_null() && row(&found, "ke")["against"].is_null());
    }

    #[test]
    fn what_was_solved_at_the_load_answers_unless_it_is_doubtful() {
        let solved = |pressure: f64, notes: Value| {
            let values = json!({ "area-fraction": "0.01", "tangent": "1e10" });
            json!([{ "pressure": pressure, "values": values, "notes": notes }])
        };
        let source = |text, solved| page_at(text, "1 MPa", solved)["answer"]["source"].clone();
        assert_eq!(source(SEAL, solved(1e6, json!([]))), "solved");
        assert_eq!(source(SEAL, solved(2e6, json!([]))), "evidence");
        assert_eq!(source(SEAL, solved(1e6, json!(["few-patches"]))), "evidence");
        let doubtful = page_at(&joint(), "1 MPa", solved(1e6, json!(["few-patches"])));
        assert_eq!(doubtful["answer"]["first"][0]["shown"], "1 %");
        assert!(
            doubtful["answer"]["basis"].as_str().unwrap().contains("uncertain: too few pixels")
        );
    }
}
