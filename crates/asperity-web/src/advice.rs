//! The answer at a load: values with their intervals and where they come from, how far models are
//! from them, and findings.

use std::collections::BTreeMap;

use asperity::{
    At, ContactError, Corrected, Finding, Findings, Scene, Separation, SeparationUnit, Severity,
    shortest_digits, usual_reference,
};
use asperity_answer::{Asked, unranked};
use asperity_inputs::SceneFile;
use serde::Serialize;
use serde_json::{Value, json};

use crate::answer::{self, SEPARATION, quantities};
use crate::dialect::{PAGE, said};
use crate::message::Solved;
use crate::shown::{interval, percent, shown};
use crate::span::Load;

/// The quantities in which models are held against the answer, with their short names.
const COMPARED: [(&str, &str); 2] = [("area-fraction", "area"), ("tangent", "stiffness")];
/// The quantities of the first line, with their units and names.
const FIRST: [(&str, &str, &str); 3] = [
    ("area-fraction", "%", "real area"),
    ("tangent", "N/m", "first-loading stiffness"),
    ("unloading-stiffness", "N/m", "unloading stiffness"),
];
/// A model farther than this from boundary elements is out of its range.
const FAR: f64 = 0.3;
/// Codes of findings that a load is out of the range of a model.
const OUTSIDE: [&str; 4] = ["beyond-fit", "fit-misses", "tabor", "above-hardness"];
/// The model that shows whether contacts yield, as it ignores that.
pub(crate) const ELASTIC: &str = "gw";

/// Where a value comes from, the better the later.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Source {
    /// The recommended model, without evidence.
    Model,
    /// Boundary elements on solved surfaces like this one.
    Evidence,
    /// Boundary elements on this scan at this load.
    Solved,
}

/// How far a model is from the answer.
#[derive(Debug, Serialize)]
pub(crate) struct Against {
    /// `area +11 %, stiffness −8 %`, and without the names.
    words: String,
    short: String,
    /// The larger of the two.
    off: f64,
    #[serde(skip)]
    pub(crate) outside: Option<String>,
}

#[derive(Debug, Clone, Copy)]
struct Known {
    value: f64,
    /// Ends of an interval that holds nine of ten surfaces.
    ends: Option<[f64; 2]>,
    source: Source,
}

/// What is known at a load, by quantity.
pub(crate) struct Answer {
    values: BTreeMap<String, Known>,
    source: Source,
    /// The recommended model.
    model: String,
    basis: String,
}

/// The model that is recommended where there is no evidence: of yielding, elastic or adhesive
/// asperities.
pub(crate) fn recommended(file: &SceneFile, at: At) -> String {
    let usual = usual_reference(&file.scene).to_string();
    if file.scene.adhesion_parameter().is_none_or(|theta| theta >= Scene::HIDES_ADHESION) {
        return usual;
    }
    let fits = |id: &&str| {
        let model = file.model(id).ok();
        model.is_some_and(|model| file.findings_at(&model, &[at]).iter().all(|f| f.code != "tabor"))
    };
    ["dmt", "jkr"].into_iter().find(fits).unwrap_or("jkr").into()
}

impl Answer {
    /// The answer from the row of the recommended model, its correction by the evidence, and what
    /// was solved on this scan at this load.
    pub(crate) fn new(
        file: &SceneFile,
        row: &Value,
        corrected: &Result<Corrected, ContactError>,
        load: &Load,
        solved: Option<&Solved>,
    ) -> Self {
        let model = row["model"].as_str().unwrap_or_default().to_string();
        let (mut values, mut source) = (BTreeMap::new(), Source::Model);
        values.extend(numbers(row).map(|(quantity, value)| {
            (quantity.to_string(), Known { value, ends: None, source: Source::Model })
        }));
        let evidence = corrected.as_ref().map_err(Clone::clone).and_then(|of| of.at(load.at));
        let mut basis = match &evidence {
            Ok(row) => {
                source = Source::Evidence;
                let lighter = match row.is_extrapolated() {
                    true => "; the load is below the lightest solved one, whose ratios are used",
                    false => "",
                };
                let basis = row.basis();
                let surfaces = basis.split("; ").last().unwrap_or_default();
                format!("From {surfaces} like this one; 9 of 10 lie in the intervals{lighter}.")
            }
            Err(reason) => {
                let reason = reason.marked();
                let why = reason.split_once(": ").map_or(&*reason, |(_, why)| why);
                let why = why.split_once("is close: ").map_or(why, |(_, why)| why);
                format!("No evidence here ({}): values by {model}.", said(why).replace('_', " "))
            }
        };
        if let Ok(row) = &evidence {
            let known = |[value, lower, upper]: [f64; 3]| Known {
                value,
                ends: Some([lower, upper]),
                source: Source::Evidence,
            };
            values.extend(quantities(file).into_iter().filter_map(|quantity| {
                let found = row.value(quantity).ok()?;
                Some((quantity.to_string(), known([found.value, found.lower, found.upper])))
            }));
            let metres = |s: Separation| {
                s.measured_in(SeparationUnit::Metres, file.separation_from, &file.scene).ok()
            };
            let gap = row.separation().ok().and_then(|found| {
                let [value, lower, upper] = [found.value, found.lower, found.upper].map(metres);
                Some([value?.value, lower?.value, upper?.value])
            });
            values.extend(gap.map(|gap| (SEPARATION.to_string(), known(gap))));
        }
        if let Some(solved) = solved {
            let codes = solved.notes.iter().map(String::as_str).collect();
            let doubt = unranked(&[codes]);
            if doubt.is_none() || source == Source::Model {
                source = Source::Solved;
                basis = match doubt {
                    Some(why) => {
                        let (why, _) = why.split_once("; ").unwrap_or((why, ""));
                        format!("Boundary elements on this scan at this load, uncertain: {why}.")
                    }
                    None => "Boundary elements on this scan at this load.".into(),
                };
                values.extend(numbers(&solved.row()).map(|(quantity, value)| {
                    (quantity.to_string(), Known { value, ends: None, source })
                }));
            }
        }
        Self { values, source, model, basis }
    }

    /// How far a row is from the answer, and whether it is outside of the range of its model; none
    /// where the answer is of that model.
    pub(crate) fn against(&self, row: &Value) -> Option<Against> {
        if self.source == Source::Model && row["model"].as_str() == Some(&self.model) {
            return None;
        }
        let found: BTreeMap<&str, f64> = numbers(row).collect();
        let off = |(quantity, name): (&str, &'static str)| {
            let known = self.values.get(quantity).filter(|known| known.source == self.source)?;
            Some((name, found.get(quantity)? / known.value - 1.0))
        };
        let off: Vec<(&str, f64)> = COMPARED.into_iter().filter_map(off).collect();
        let largest = off.iter().map(|(_, off)| off.abs()).reduce(f64::max)?;
        let words: Vec<_> =
            off.iter().map(|(name, off)| format!("{name} {}", percent(*off))).collect();
        let short = COMPARED.map(|(_, name)| {
            let known = off.iter().find(|(known, _)| *known == name);
            known.map_or("–".into(), |(_, off)| percent(*off))
        });
        let is_far = self.source != Source::Model && largest > FAR;
        Some(Against {
            words: words.join(", "),
            short: short.join(", "),
            off: largest,
            outside: is_far.then(|| format!("more than {} from the answer", percent(FAR))),
        })
    }

    /// Which of the shown models to use, by id, and how far it is from the answer: the nearest. One
    /// that ignores yielding is near by chance, and has the next beside it.
    fn model_to_use(&self, rows: &[Value], ignores: impl Fn(&str) -> bool) -> Value {
        if self.source == Source::Model {
            return json!({ "model": self.model, "says": "recommended; not compared here" });
        }
        let of = |row: &Value| {
            let Against { words, off, .. } = self.against(row).filter(|_| row["mark"].is_null())?;
            let lacks = !words.contains(COMPARED[1].1);
            Some((lacks, off, row["model"].as_str()?.to_string(), words))
        };
        let mut near: Vec<_> = rows.iter().filter_map(of).collect();
        near.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        let Some((.., best, words)) = near.first() else { return Value::Null };
        let next = near.iter().find(|(.., id, _)| !ignores(id));
        let says = match next {
            Some((.., id, other)) if id != best => {
                format!("{words}; ignores yielding, near by chance. {id}: {other}")
            }
            None => format!("{words}; ignores yielding, near by chance"),
            Some(_) => words.clone(),
        };
        json!({ "model": best, "says": says })
    }

    /// The answer as the page shows it, beside the rows of the shown models.
    pub(crate) fn shown(
        &self,
        file: &SceneFile,
        load: &Load,
        rows: &[Value],
        judged: &BTreeMap<String, Judged>,
    ) -> Value {
        let first: Vec<Value> = FIRST.iter().map(|part| self.first(*part)).collect();
        let cells: Vec<Value> =
            answer::columns(file).map(|(id, unit)| self.cell(&id, unit)).collect();
        let index = file.scene.plasticity_index().ok();
        let plasticity = match judged.get(ELASTIC).and_then(|of| of.yields) {
            _ if index.is_none() => "no hardness: elastic",
            None => "nothing yields",
            Some(Severity::Note) => "a few contacts yield",
            Some(_) => "contacts yield",
        };
        let ignores = |id: &str| judged.get(id).is_some_and(|of| of.yields > Some(Severity::Note));
        let to_use = self.model_to_use(rows, ignores);
        let said = |part: &Value| format!("{} {}", part["name"], part["shown"]).replace('"', "");
        let spoken = first.iter().map(said).collect::<Vec<_>>().join(", ");
        let spoken = match to_use["model"].as_str() {
            Some(id) => format!("At {}: {spoken}; use {id}", load.text),
            None => format!("At {}: {spoken}", load.text),
        };
        json!({
            "source": match self.source {
                Source::Model => "model",
                Source::Evidence => "evidence",
                Source::Solved => "solved",
            },
            "first": first,
            "row": { "model": "answer", "cells": cells },
            "plasticity": { "shown": index.map_or("–".into(), |x| short_index(x)), "says": plasticity },
            "use": to_use,
            "basis": self.basis,
            "surface": format!("Sq {}", shown(file.scene.surface.moments().m0.sqrt(), "m")),
            "spoken": spoken,
        })
    }

    fn first(&self, (quantity, unit, name): (&str, &str, &str)) -> Value {
        let Some(known) = self.values.get(quantity) else {
            let by = format!("{} has none", self.model);
            return json!({ "name": name, "quantity": quantity, "shown": "–", "by": by });
        };
        let (shown, range) = interval(known.value, known.ends, unit);
        let by = match known.source {
            Source::Model if self.source != Source::Model => {
                format!("by {}; no evidence", self.model)
            }
            Source::Model => format!("by {}", self.model),
            Source::Evidence => range,
            Source::Solved => "on this scan".into(),
        };
        let mut part = json!({
            "name": name, "quantity": quantity, "shown": shown, "by": by,
            "digits": shortest_digits(known.value),
        });
        known.add_ends(&mut part);
        part
    }

    /// The cell of a column; a value of the model has its place in the row of the model.
    fn cell(&self, quantity: &str, unit: &str) -> Value {
        match self.values.get(quantity).filter(|known| known.source == self.source) {
            Some(known) => {
                let mut cell = answer::cell(quantity, unit, Ok(known.value));
                known.add_ends(&mut cell);
                cell
            }
            None => json!({ "quantity": quantity, "shown": "no evidence" }),
        }
    }
}

impl Known {
    fn add_ends(&self, to: &mut Value) {
        if let Some(ends) = self.ends {
            let [lower, upper] = ends.map(shortest_digits);
            (to["lower"], to["upper"]) = (lower.into(), upper.into());
        }
    }
}

fn short_index(index: f64) -> String {
    if index < 10.0 { format!("{index:.1}") } else { format!("{index:.0}") }
}

/// The numbers of a row by quantity.
fn numbers(row: &Value) -> impl Iterator<Item = (&str, f64)> {
    let cells = row["cells"].as_array().into_iter().flatten();
    cells.filter_map(|cell| {
        Some((cell["quantity"].as_str()?, cell["digits"].as_str()?.parse().ok()?))
    })
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
        let is_outside =
            |found: &&Finding| OUTSIDE.contains(&found.code) && found.severity > Severity::Note;
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

    /// What the page is told about a scene at a load, with these solved values there.
    fn told(text: &str, load: &str, solved: Value) -> Value {
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
        let found = told(SEAL, "1 MPa", json!([]));
        let (answer, ke) = (&found["answer"], row(&found, "ke"));
        assert_eq!(answer["source"], "evidence");
        let file = asperity_inputs::parse(SEAL, std::path::Path::new(".")).unwrap();
        let corrected = answer::compile(&file, "ke").unwrap().corrected(&file, "ke").unwrap();
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
        let least = found["rows"]
            .as_array()
            .unwrap()
            .iter()
            .filter_map(|row| row["against"]["off"].as_f64());
        let to_use = row(&found, answer["use"]["model"].as_str().unwrap());
        assert!(to_use["against"]["off"].as_f64() <= least.reduce(f64::max), "{answer}");
    }

    #[test]
    fn without_evidence_the_recommended_model_answers() {
        let found = told(JOINT, "1 MPa", json!([]));
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
        let source = |text, solved| told(text, "1 MPa", solved)["answer"]["source"].clone();
        assert_eq!(source(SEAL, solved(1e6, json!([]))), "solved");
        assert_eq!(source(SEAL, solved(2e6, json!([]))), "evidence");
        assert_eq!(source(SEAL, solved(1e6, json!(["few-patches"]))), "evidence");
        let doubtful = told(JOINT, "1 MPa", solved(1e6, json!(["few-patches"])));
        assert_eq!(doubtful["answer"]["first"][0]["shown"], "1 %");
        assert!(
            doubtful["answer"]["basis"].as_str().unwrap().contains("uncertain: too few pixels")
        );
    }
}
