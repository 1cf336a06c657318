//! The answer at a load as the page shows it, and the model to use there.

use asperity::{
    At, Code, ContactError, CorrectedRow, Scene, Separation, SeparationUnit, Severity,
    usual_reference,
};
use asperity_answer::{Cell, Recommend, Sheet, unranked};
use asperity_scene::SceneFile;
use serde_json::{Value, json};

use crate::answer::{Column, Known, Row, Source, quantities};
use crate::labels::{symbols, term};
use crate::message::Solved;
use crate::refusal::Refusal;
use crate::shown::{interval, percent, shown};
use crate::span::Load;

/// The first line: units and names of the columns behind the separation. Models are held against
/// the answer in the first two, area and stiffness.
const FIRST: [(&str, &str); 3] =
    [("%", "real area"), ("N/m", "first-loading stiffness"), ("N/m", "unloading stiffness")];
/// The model that shows whether contacts yield, as it ignores that.
pub(crate) const ELASTIC: &str = "gw";

/// What is known at a load from the best source: boundary elements on this scan, those on solved
/// surfaces like this one, or a model.
pub(crate) struct Best {
    /// By column.
    values: Vec<Option<Known>>,
    source: Source,
    /// The model, which fills what a better source does not have.
    model: String,
    /// The source in a sentence.
    basis: String,
}

/// The model of the answer: the usual one or, where adhesion matters, the one of its range.
pub(crate) fn answering(file: &SceneFile, at: At) -> &'static str {
    if file.scene.adhesion_parameter().is_none_or(|theta| theta >= Scene::HIDES_ADHESION) {
        return usual_reference(&file.scene);
    }
    let fits = |id: &&str| {
        let found = file.model(id).map(|model| file.findings_at(&model, &[at]));
        found.is_ok_and(|found| found.iter().all(|one| one.code != Code::Tabor))
    };
    ["dmt", "jkr"].into_iter().find(fits).unwrap_or("jkr")
}

impl Best {
    /// From the row of a model on a scene, its correction by the evidence, and what was solved on
    /// this scan at this load.
    pub(crate) fn new(
        (file, columns): (&SceneFile, &[Column]),
        row: &Row,
        corrected: Result<CorrectedRow, ContactError>,
        solved: Option<&Solved>,
    ) -> Self {
        let values = (0..columns.len()).map(|column| row.value(column).copied()).collect();
        let (model, basis) = (row.model.clone(), String::new());
        let mut best = Self { values, source: Source::Model, model, basis };
        let unknowns = file.unknowns();
        match corrected {
            _ if !unknowns.is_empty() => {
                let names =
                    unknowns.iter().map(|one| term(&one.name)).collect::<Vec<_>>().join(", ");
                best.basis =
                    symbols(&format!("Ranges by {}, for the ranges of {names}.", best.model));
            }
            Ok(row) => best.take_evidence(file, &row),
            Err(reason) => {
                let why = symbols(&reason.to_string());
                best.basis = format!("Values by {}: {why}.", best.model);
            }
        }
        let Some(solved) = solved else { return best };
        let codes = solved.notes.iter().filter_map(|name| Code::named(name).ok()).collect();
        best.basis = match unranked(&[codes]) {
            None => "Boundary elements on this scan at this load.".into(),
            Some([why, _]) if best.source == Source::Model => {
                format!("Boundary elements on this scan at this load, uncertain: {why}.")
            }
            // The mean of many surfaces is better known than one with few contacts.
            Some(_) => return best,
        };
        best.take(Source::Solved, solved.row(columns).cells.into_iter().map(Result::ok));
        best
    }

    /// Values of a better source.
    fn take(&mut self, source: Source, values: impl Iterator<Item = Option<Known>>) {
        self.source = source;
        for (known, better) in self.values.iter_mut().zip(values) {
            *known = better.or(*known);
        }
    }

    fn take_evidence(&mut self, file: &SceneFile, row: &CorrectedRow) {
        let known = |[value, lower, upper]: [f64; 3]| {
            Known::new(value, Some([lower, upper]), Source::Evidence)
        };
        let metres = |s: Separation| {
            let found =
                s.measured_in(SeparationUnit::Metres, file.spec.separation_from, &file.scene);
            found.ok().map(|found| found.value)
        };
        let gap = row
            .separation()
            .ok()
            .and_then(|of| Some(known([metres(of.value)?, metres(of.lower)?, metres(of.upper)?])));
        let values = quantities(file).into_iter().map(|quantity| {
            row.value(quantity).ok().map(|of| known([of.value, of.lower, of.upper]))
        });
        self.take(Source::Evidence, [gap].into_iter().chain(values));
        let lighter = match row.is_extrapolated() {
            true => "; the load is below the lightest solved one, whose ratios are used",
            false => "",
        };
        let basis = symbols(&row.basis());
        self.basis = format!(
            "From surfaces like this one ({basis}); 9 of 10 lie in the intervals{lighter}."
        );
    }

    /// A value of the best source.
    fn value(&self, column: usize) -> Option<&Known> {
        self.values.get(column)?.as_ref().filter(|known| known.source == self.source)
    }

    /// How far a row is from the answer in area and stiffness: `+3 %, −2 %`. None for the model
    /// whose values are the answer, and where these have ranges.
    fn against(&self, row: &Row) -> Option<String> {
        let off = |column: usize| {
            let known = self.value(column).filter(|known| !known.has_range())?;
            Some(row.value(column)?.value / known.value - 1.0)
        };
        let off = [off(1), off(2)];
        if off == [None; 2] || (self.source == Source::Model && row.model == self.model) {
            return None;
        }
        Some(off.map(|off| off.map_or("–".into(), percent)).join(", "))
    }
}

/// A row as shown, with how far it is from the answer, and why it is out of the range of its model,
/// if it is.
pub(crate) fn shown_row(best: &Best, row: &Row, columns: &[Column]) -> Value {
    let cells = columns.iter().zip(&row.cells).map(|(column, found)| column.cell(found));
    json!({
        "model": row.model,
        "cells": cells.collect::<Value>(),
        "reason": row.reason,
        "mark": row.mark,
        "outside": row.outside,
        "against": best.against(row),
    })
}

/// Columns of a recommendation, with their names on the page.
const COMPARED: [(&str, &str); 4] = [
    ("area_deviation", "area, from the reference"),
    ("area_off_bem", "area, from boundary elements"),
    ("stiffness_off_bem", "stiffness, from boundary elements"),
    ("simplest", "the simplest near the reference"),
];

/// The model to use at a load and how far each is, as `asperity recommend` has them.
pub(crate) fn recommend(file: &SceneFile, at: At) -> Result<Value, Refusal> {
    let mut sheet = Sheet::default();
    let advice = Recommend::at([at]).answer(file, &mut sheet)?;
    let columns = COMPARED.iter().filter_map(|(head, name)| Some((sheet.column(head)?, *name)));
    let columns: Vec<(usize, &str)> = columns.collect();
    let text = |cell: &Cell| cell.number().map_or_else(|| cell.text().into(), percent);
    let rows = sheet.rows.iter().map(|row| {
        let cells: Value = columns.iter().map(|(k, _)| text(&row[*k])).collect();
        json!({ "model": row[0].text(), "cells": cells })
    });
    Ok(json!({
        "model": advice.model_to_use(),
        "verdict": advice.verdict(),
        "head": columns.iter().map(|(_, name)| *name).collect::<Value>(),
        "rows": rows.collect::<Value>(),
    }))
}

/// The answer on the scene, the first of these, and at the ends of its ranges beside the rows of
/// the shown models; the elastic model shows whether contacts yield.
pub(crate) fn answer(
    best: &Best,
    (scenes, columns): (&[SceneFile], &[Column]),
    load: &Load,
    elastic: &Row,
) -> Value {
    let cells = columns.iter().enumerate().map(|(k, column)| match best.value(k) {
        Some(known) => column.known(known),
        // A value of the model has its place in the row of the model.
        None => json!({ "quantity": column.id, "shown": "no evidence" }),
    });
    let mut indices = scenes.iter().map(|file| file.scene.plasticity_index().ok());
    let index = indices.next().flatten().map(|index| Known::new(index, None, Source::Model));
    let index = index.and_then(|index| index.within(indices));
    let yields = match elastic.yields {
        _ if index.is_none() => "no hardness: elastic",
        None => "nothing yields",
        Some(Severity::Note) => "a few contacts yield",
        Some(_) => "contacts yield",
    };
    let of_index = Column::new(["plasticity_index", "", "plasticity index"], String::new());
    let first = FIRST.iter().zip(&columns[1..]).zip(&best.values[1..]);
    let first = first.map(|(((unit, name), column), known)| {
        let by = match known.map(|known| known.source) {
            None => format!("{} has none", best.model),
            Some(Source::Model) if best.source == Source::Model => format!("by {}", best.model),
            Some(Source::Model) => format!("by {}; no evidence", best.model),
            Some(Source::Evidence) => String::new(),
            Some(Source::Solved) => "on this scan".into(),
        };
        part([name, unit], column, *known, by)
    });
    let index = part([of_index.label, ""], &of_index, index, yields.into());
    let first: Vec<Value> = first.chain([index]).collect();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_string();
    let said = first.iter().map(|part| {
        let range = if scenes.len() > 1 { format!(", {}", text(&part["by"])) } else { "".into() };
        format!("{} {}{range}", text(&part["name"]), text(&part["shown"]))
    });
    let said = said.collect::<Vec<_>>().join(if scenes.len() > 1 { "; " } else { ", " });
    let surface = match scenes {
        [file] => format!("Sq {}", shown(file.scene.surface.moments().m0.sqrt(), "m")),
        _ => "known within ranges".into(),
    };
    json!({
        "source": best.source,
        "first": first,
        "row": { "model": "answer", "cells": cells.collect::<Value>() },
        "basis": best.basis,
        "surface": surface,
        "spoken": format!("At {}: {said}", load.text),
    })
}

/// A part of the first line, with what stands below it behind its range.
fn part([name, unit]: [&str; 2], column: &Column, known: Option<Known>, by: String) -> Value {
    let Some(known) = known else { return json!({ "name": name, "shown": "–", "by": by }) };
    let (shown, range) = interval(known.value, known.ends, unit);
    let mut part = column.known(&known);
    let below: Vec<String> = [range, by].into_iter().filter(|text| !text.is_empty()).collect();
    (part["name"], part["shown"], part["by"]) =
        (name.into(), shown.into(), below.join(", ").into());
    part
}

#[cfg(test)]
mod tests {
    use asperity::At;

    use super::*;
    use crate::Desk;

    const SEAL: &str = include_str!("../../../answer/scene/examples/lapped-seal.toml");
    const JOINT: &str = include_str!("../../../answer/scene/examples/bolted-joint.toml");

    /// The joint of an alloy so soft that no like surface was solved.
    fn joint() -> String {
        JOINT.replace("107 HV", "37 HV")
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

    const GROUND: &str = "nominal_area = 1e-4\n[interface]\nequivalent_modulus = 115e9\n\
        poissons_ratio = 0.3\nhardness = 2e9\n[surface]\nra = 8e-7\nfinish = \"ground\"\n";

    fn call(desk: &mut Desk, message: Value) -> Value {
        let answer: Value = serde_json::from_str(&desk.call(&message.to_string())).unwrap();
        answer["ok"].clone()
    }

    /// Every object with the digits of a number.
    fn numbers<'v>(value: &'v Value, found: &mut Vec<&'v Value>) {
        match value {
            Value::Object(fields) if fields.get("digits").is_some_and(Value::is_string) => {
                found.push(value);
            }
            Value::Object(fields) => fields.values().for_each(|value| numbers(value, found)),
            Value::Array(items) => items.iter().for_each(|value| numbers(value, found)),
            _ => {}
        }
    }

    #[test]
    fn an_answer_is_the_corrected_value_and_models_are_held_against_it() {
        let found = page_at(SEAL, "1 MPa", json!([]));
        let (answer, ke) = (&found["answer"], row(&found, "ke"));
        assert_eq!(answer["source"], "evidence");
        let file = [asperity_scene::parse(SEAL, std::path::Path::new(".")).unwrap()];
        let corrected = crate::answer::compile(&file, "ke").unwrap();
        let corrected = corrected[0].corrected(&file[0]).unwrap();
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
        let against = ke["against"].as_str().unwrap();
        assert!(against.starts_with(&percent(own / wanted.value - 1.0)), "{against}");
    }

    #[test]
    fn the_model_to_use_is_the_verdict_of_the_program() {
        // Few models, which are quick.
        let text = include_str!("../../../answer/scene/examples/elastomer-on-glass.toml");
        let file = asperity_scene::parse(text, std::path::Path::new(".")).unwrap();
        for (load, wanted) in [(0.05, json!("gw")), (100.0, Value::Null)] {
            let mut desk = Desk::default();
            call(&mut desk, json!({ "call": "show", "text": text }));
            let load_keys = json!({ "text": format!("{load} N") });
            let found = call(&mut desk, json!({ "call": "recommend", "load": load_keys }));
            let mut sheet = Sheet::default();
            let program = Recommend::at([At::Load(load)]).answer(&file, &mut sheet).unwrap();
            assert_eq!((&found["model"], &found["verdict"]), (&wanted, &json!(program.verdict())));
            let rows = found["rows"].as_array().unwrap();
            assert_eq!(rows.len(), sheet.rows.len());
            let width = found["head"].as_array().unwrap().len();
            assert!(rows.iter().all(|row| row["cells"].as_array().unwrap().len() == width));
        }
    }

    #[test]
    fn without_evidence_the_recommended_model_answers() {
        let found = page_at(&joint(), "1 MPa", json!([]));
        let answer = &found["answer"];
        assert_eq!(answer["source"], "model");
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
    }

    #[test]
    fn every_number_of_an_answer_has_its_ends() {
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": GROUND }));
        assert_eq!((&shown["way"], &shown["error"]), (&json!("finish"), &Value::Null));
        let slope = &shown["numbers"][1];
        assert_eq!(slope["name"], "mean slope");
        assert!(slope["shown"].as_str().unwrap().contains(" to "), "{slope}");
        let models = ["gw", "ke", "persson"];
        let load = json!({ "position": 0.6, "unit": "Pa" });
        let asked = json!({ "call": "answer", "models": models, "load": load });
        let found = call(&mut desk, asked);
        let mut all = vec![];
        numbers(&found, &mut all);
        assert!(all.len() > 20, "{found}");
        for number in all {
            let [value, lower, upper] = ["digits", "lower", "upper"]
                .map(|key| number[key].as_str().unwrap().parse::<f64>().unwrap());
            assert!(lower <= value && value <= upper, "{number}");
            let text = format!("{}{}{}", number["shown"], number["by"], number["says"]);
            assert!(text.contains(" to "), "{number}");
        }
        assert!(found["answer"]["spoken"].as_str().unwrap().contains(" to "));
        assert_eq!(found["rows"][1]["model"], "ke");
    }

    #[test]
    fn curves_have_their_ends_and_tables_are_those_of_the_middle() {
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": GROUND }));
        let curves = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        let rows = curves["ke"].as_str().unwrap();
        let head = shown["head"].as_str().unwrap();
        let of = |name: &str| -> Vec<f64> {
            let place = head.split(',').position(|known| known == name).unwrap();
            rows.lines().map(|line| line.split(',').nth(place).unwrap().parse().unwrap()).collect()
        };
        let [own, lower, upper] =
            ["area_fraction", "area_fraction_lower", "area_fraction_upper"].map(of);
        assert_eq!((own.len(), lower.len(), upper.len()), (200, 200, 200));
        assert!((0..200).all(|k| lower[k] <= own[k] && own[k] <= upper[k]));
        let load = json!({ "text": "1 MPa" });
        let drawn = json!({ "call": "draw", "rows": [rows], "view": "tangent", "load": load, "solved": [] });
        assert!(call(&mut desk, drawn).as_str().unwrap().starts_with("<svg"));
        let export = json!({ "call": "export", "model": "ke", "form": "csv", "units": "SI" });
        assert!(call(&mut desk, export)["text"].is_string());
    }
}
