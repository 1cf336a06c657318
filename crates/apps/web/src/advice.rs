//! The answer at a load as the page shows it, and how far models are from it.

use asperity::Severity;
use asperity_inputs::SceneFile;
use serde::Serialize;
use serde_json::{Value, json};

use crate::answer::{Column, Known, Row, Source};
use crate::best::Best;
use crate::shown::{interval, percent, shown};
use crate::span::Load;

/// The first line: units and names of the columns behind the separation. Models are held against
/// the answer in the first two, area and stiffness.
const FIRST: [(&str, &str); 3] =
    [("%", "real area"), ("N/m", "first-loading stiffness"), ("N/m", "unloading stiffness")];
/// A model farther than this from boundary elements is out of its range.
const FAR: f64 = 0.3;
/// The model that shows whether contacts yield, as it ignores that.
pub(crate) const ELASTIC: &str = "gw";

/// How far a row is from the answer in area and stiffness.
#[derive(Serialize)]
struct Against {
    words: String,
    short: String,
    /// The larger of the two.
    off: f64,
    /// Whether it has no stiffness.
    lacks: bool,
}

impl Against {
    /// None for the model whose values are the answer, and where these have ranges.
    fn of(best: &Best, row: &Row) -> Option<Self> {
        let off = |column: usize| {
            let known = best.value(column).filter(|known| !known.has_range())?;
            Some(row.value(column)?.value / known.value - 1.0)
        };
        let off = [off(1), off(2)];
        if off == [None; 2] || (best.source == Source::Model && row.model == best.model) {
            return None;
        }
        let [area, stiffness] = off.map(|off| off.map_or("–".into(), percent));
        Some(Self {
            words: format!("area {area}, stiffness {stiffness}"),
            short: format!("{area}, {stiffness}"),
            off: off.iter().flatten().fold(0.0, |most: f64, off| most.max(off.abs())),
            lacks: off[1].is_none(),
        })
    }
}

/// A row as shown, with how far it is from the answer, and why it is out of the range of its model,
/// if it is.
pub(crate) fn shown_row(best: &Best, row: &Row, columns: &[Column]) -> Value {
    let against = Against::of(best, row);
    let is_far = |of: &Against| best.source != Source::Model && of.off > FAR;
    let far = |_: &Against| format!("more than {} from the answer", percent(FAR));
    let far = against.as_ref().filter(|of| is_far(of)).map(far);
    let cells = columns.iter().zip(&row.cells).map(|(column, found)| column.cell(found));
    json!({
        "model": row.model,
        "cells": cells.collect::<Value>(),
        "reason": row.reason,
        "mark": row.mark,
        "outside": row.outside.clone().or(far),
        "against": against,
    })
}

/// Which of the shown models to use, by id, and how far it is from the answer: the nearest. One
/// that ignores yielding is near by chance, and has the next beside it.
fn model_to_use<'r>(best: &'r Best, rows: &'r [Row]) -> Option<(&'r str, String)> {
    if best.source == Source::Model {
        return Some((&best.model, "recommended; not compared here".into()));
    }
    let unmarked = rows.iter().filter(|row| row.mark.is_none());
    let mut near: Vec<_> =
        unmarked.filter_map(|row| Some((row, Against::of(best, row)?))).collect();
    // Models without a stiffness come last.
    near.sort_by(|(_, a), (_, b)| a.lacks.cmp(&b.lacks).then(a.off.total_cmp(&b.off)));
    let ignores = |row: &Row| row.yields.is_some_and(|severity| severity != Severity::Note);
    let (row, against) = near.first()?;
    let mut says = against.words.clone();
    if ignores(row) {
        says += ", by chance: it ignores yielding";
        if let Some((next, other)) = near.iter().find(|(row, _)| !ignores(row)) {
            says += &format!("; {} {}", next.model, other.short);
        }
    }
    Some((&row.model, says))
}

/// The answer on the scene, the first of these, and at the ends of its ranges beside the rows of
/// the shown models; the elastic model shows whether contacts yield.
pub(crate) fn answer(
    best: &Best,
    (scenes, columns): (&[SceneFile], &[Column]),
    load: &Load,
    rows: &[Row],
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
    let to_use = model_to_use(best, rows);
    let model = to_use.as_ref().map_or("", |(model, _)| model);
    let surface = match scenes {
        [file] => format!("Sq {}", shown(file.scene.surface.moments().m0.sqrt(), "m")),
        _ => "known within ranges".into(),
    };
    json!({
        "source": best.source,
        "first": first,
        "row": { "model": "answer", "cells": cells.collect::<Value>() },
        "use": to_use.as_ref().map(|(model, says)| json!({ "model": model, "says": says })),
        "basis": best.basis,
        "surface": surface,
        "spoken": format!("At {}: {said}; use {model}", load.text),
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

    const SEAL: &str = include_str!("../../../answer/inputs/examples/lapped-seal.toml");
    const JOINT: &str = include_str!("../../../answer/inputs/examples/bolted-joint.toml");

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
        let file = [asperity_inputs::parse(SEAL, std::path::Path::new(".")).unwrap()];
        let corrected = crate::answer::compile(&file, "ke").unwrap();
        let corrected = corrected[0].corrected(&file[0], "ke").unwrap();
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
    fn every_number_of_an_answer_has_its_ends() {
        let mut desk = Desk::default();
        let shown = call(&mut desk, json!({ "call": "show", "text": GROUND }));
        assert_eq!((&shown["way"], &shown["error"]), (&json!("finish"), &Value::Null));
        let slope = &shown["numbers"][1];
        assert_eq!(slope["name"], "surface mean slope");
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
        let basis = found["answer"]["basis"].as_str().unwrap();
        let words =
            "Ranges by ke, of a surface with rq within 1.2, mean slope within 4.4, bandwidth";
        assert!(basis.starts_with(words), "{basis}");
        assert_eq!(found["rows"][1]["model"], "ke");
    }

    #[test]
    fn curves_have_their_ends_and_single_numbers_are_refused() {
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
        let refused: Value = serde_json::from_str(&desk.call(&export.to_string())).unwrap();
        assert!(refused["error"]["message"].as_str().unwrap().contains("within ranges only"));
    }
}
