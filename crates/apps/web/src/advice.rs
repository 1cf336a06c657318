//! The answer at a load as the page shows it, with what stands behind it.

use asperity::{At, Best, BestContact, Code, Compared, Described, Model};
use asperity_answer::{Basis, NO_EVIDENCE, basis};
use asperity_scene::{SceneFile, Unknown};
use serde_json::{Value, json};

use crate::answer::{Column, Known, Row, quantities};
use crate::labels::{raised, term};
use crate::shown::{interval, percent, shown};
use crate::span::Load;

/// The first line: units and names of the columns behind the separation. Models are held against
/// the answer in the first two, area and stiffness.
const FIRST: [(&str, Compared); 3] =
    [("%", Compared::Area), ("N/m", Compared::Stiffness), ("N/m", Compared::UnloadingStiffness)];
/// The column of the peak pressure of curved bodies, which stands for the plasticity index.
const PEAK: usize = 4;
/// The model that is the answer.
pub(crate) const BEST: &str = Best::<Model>::ID;

/// How far a row is from the answer in area and stiffness: `+3 %, −2 %`. None for the answer, and
/// where that is known within ranges.
fn against(best: &Row, row: &Row) -> Option<String> {
    let off = |column: usize| {
        let known = best.value(column).filter(|known| !known.ranged)?;
        Some(row.value(column)?.value / known.value - 1.0)
    };
    let off = [off(1), off(2)];
    let is_known = off != [None; 2] && row.model != best.model;
    is_known.then(|| off.map(|off| off.map_or("–".into(), percent)).join(", "))
}

/// A row as shown, with how far it is from the answer, and why it is out of the range of its model,
/// if it is.
pub(crate) fn shown_row(best: &Row, row: &Row, columns: &[Column]) -> Value {
    let cells = columns.iter().zip(&row.cells).map(|(column, found)| column.cell(found));
    json!({
        "model": row.model,
        "cells": cells.collect::<Value>(),
        "reason": row.reason,
        "mark": row.mark,
        "outside": row.outside,
        "against": against(best, row),
    })
}

/// The answer on the scene, the first of these, by its row, and what stands behind it.
pub(crate) fn answer(
    row: &Row,
    (file, scenes, columns): (&SceneFile, &[SceneFile], &[Column]),
    contact: Option<&BestContact<Model>>,
    load: &Load,
) -> Value {
    let indices = scenes.iter().map(|file| file.scene.plasticity_index().ok());
    let index = indices.collect::<Option<Vec<f64>>>().map(|all| {
        let end = |of: fn(f64, f64) -> f64| all.iter().copied().fold(all[0], of);
        let index = Known::new(all[0], false);
        if all.len() > 1 { index.between([end(f64::min), end(f64::max)]) } else { index }
    });
    // An elastic model is not valid where they do.
    let yields = |best: &BestContact<Model>| {
        let invalid = best.others(load.at).into_iter().filter_map(|other| other.outside);
        invalid.map(|why| why.code).any(|code| code == Code::Yields)
    };
    let yields = match contact.is_some_and(yields) {
        _ if index.is_none() => "no hardness: elastic",
        true => "contacts yield",
        false => "hardly any contact yields",
    };
    let is_flat = file.shape().is_none();
    let of_index = Column::new(["plasticity_index", "", "plasticity index"], String::new());
    let first = FIRST.iter().zip(&columns[1..]).enumerate().map(|(k, ((unit, of), column))| {
        let by = match row.value(k + 1) {
            Some(Known { solved: true, .. }) => "on this scan".into(),
            Some(Known { ends: None, .. }) => "no interval".into(),
            _ => String::new(),
        };
        let unit = if is_flat { unit } else { column.unit };
        part([of.label(), unit], column, row.value(k + 1).copied(), by)
    });
    let index = match columns.get(PEAK).filter(|_| !is_flat) {
        Some(peak) => part([peak.label, peak.unit], peak, row.value(PEAK).copied(), "".into()),
        None => part([of_index.label, ""], &of_index, index, yields.into()),
    };
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
    let spread = |one: Unknown| {
        let factor = (one.ends[1] / one.ends[0]).sqrt();
        format!("{} within a factor of {factor:.1}", term(&one.name))
    };
    let spreads: Vec<String> = file.unknowns().into_iter().map(spread).collect();
    let widest = match &spreads[..] {
        [] => String::new(),
        spreads => format!("; wide by {}", spreads.join(", ")),
    };
    let (models, mut behind) =
        contact.map_or_else(Default::default, |contact| by(contact, scenes, load.at));
    let usual = asperity::usual_reference(&file.scene);
    if !is_flat {
        behind.by = format!("{usual}, {NO_EVIDENCE}");
    }
    let models = if is_flat { models } else { usual.into() };
    json!({
        "first": first,
        "row": shown_row(row, row, columns),
        "head": crate::answer::head(columns, true),
        "model": models,
        "basis": raised(&(behind.by + &widest)),
        "also": raised(&behind.also),
        "surface": surface,
        "spoken": format!("At {}: {said}", load.text),
    })
}

/// The models behind the first line, and what stands behind them.
fn by(contact: &BestContact<Model>, scenes: &[SceneFile], at: At) -> (String, Basis) {
    let mut models: Vec<&str> =
        FIRST.iter().filter_map(|(_, of)| Some(contact.by(*of, at)?.id())).collect();
    models.dedup();
    (models.join(", "), basis(contact, &quantities(&scenes[0]), at))
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
    use asperity::{At, Quantity, Request};
    use asperity_answer::{
        Cell, Export, Inquiry, Nodes, Sheet, Silent, Subject, TableFormat, UnitSystem,
        column_of_end,
    };

    use super::*;
    use crate::Desk;

    const SEAL: &str = include_str!("../../../answer/scene/examples/lapped-seal.toml");
    const JOINT: &str = include_str!("../../../answer/scene/examples/bolted-joint.toml");

    /// The joint of an alloy softer than those that were solved.
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
    fn an_answer_is_that_of_best_and_models_are_held_against_it() {
        let found = page_at(SEAL, "1 MPa", json!([]));
        let (answer, ke) = (&found["answer"], row(&found, "ke"));
        assert_eq!(answer["first"][0]["by"], "0.028 to 0.0306");
        let file = asperity_scene::parse(SEAL, std::path::Path::new(".")).unwrap();
        let best = file.best().on(&file.scene, asperity::Tolerance::default()).unwrap();
        let wanted = best.known(Compared::Area, At::Pressure(1e6)).unwrap();
        let [lower, upper] = wanted.ends.unwrap();
        let area = &answer["first"][0];
        for (end, wanted) in [("digits", wanted.value), ("lower", lower), ("upper", upper)] {
            assert_eq!(area[end].as_str().unwrap().parse(), Ok(wanted), "{end}");
        }
        let own: f64 = ke["cells"][1]["digits"].as_str().unwrap().parse().unwrap();
        let against = ke["against"].as_str().unwrap();
        assert!(against.starts_with(&percent(own / wanted.value - 1.0)), "{against}");
        let by = best.by(Compared::Area, At::Pressure(1e6)).unwrap().id();
        assert!(answer["model"].as_str().unwrap().starts_with(by), "{answer}");
    }

    /// The page, `answer`, `curve --model best` and `export --model best` have one number, to the
    /// last digit, on the example scenes under light and heavy loads.
    #[test]
    fn every_way_to_an_answer_gives_the_same_digits() {
        let examples = std::path::Path::new(concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../answer/scene/examples"
        ));
        let paths = std::fs::read_dir(examples).unwrap().map(|entry| entry.unwrap().path());
        let scenes = paths.map(|path| (std::fs::read_to_string(&path).unwrap(), path));
        for (text, path) in scenes.chain([(GROUND.into(), "ground".into())]) {
            let file = asperity_scene::parse(&text, examples).unwrap();
            let modulus = file.scene.interface.equivalent_modulus;
            let pressures = [3e-6, 1e-5, 1e-4, 3e-4, 1e-3].map(|share| (share * modulus).round());
            let at = pressures.map(At::Pressure);
            let quantities =
                [Quantity::AreaFraction, Quantity::Tangent, Quantity::UnloadingStiffness];
            let tolerance = asperity::Tolerance::default();
            let best = file.model(BEST).unwrap();
            let [mut answered, mut drawn, mut table] = [0; 3].map(|_| Sheet::default());
            asperity_answer::Answer::new(&file, &quantities, at, tolerance)
                .answer(&file, &mut answered)
                .unwrap();
            let request = Request::new(quantities).at(at);
            let fill = |file: &SceneFile, sheet: &mut Sheet| {
                let best = vec![file.model(BEST)?];
                Inquiry::new(file, best, request.clone()).answer(sheet, &Silent)
            };
            asperity_answer::with_ranges(&file, &mut drawn, fill).unwrap();
            let export = Export {
                subject: Subject { file: &file, name: "", model: &best, tolerance },
                nodes: Nodes::Loads(&at),
                format: TableFormat::Csv,
                units: UnitSystem::SI,
                conductance: false,
            };
            let mut desk = Desk::default();
            call(&mut desk, json!({ "call": "show", "text": text }));
            // Without a mean gap, as of worn heights, there is no table.
            let is_exported = export.answer(&mut table, &Silent).is_ok();
            for (k, pressure) in pressures.iter().enumerate() {
                let of =
                    |sheet: &Sheet, head: &str| sheet.rows[k][sheet.column(head).unwrap()].number();
                let load = json!({ "text": format!("{pressure} Pa") });
                let asked = json!({ "call": "answer", "models": [], "load": load, "solved": [] });
                let page = call(&mut desk, asked);
                for (cell, quantity) in (1..).zip(quantities) {
                    let cell = &page["answer"]["row"]["cells"][cell];
                    for (key, end) in
                        [("digits", None), ("lower", Some("lower")), ("upper", Some("upper"))]
                    {
                        let head = quantity.column();
                        let head = end.map_or(head.clone(), |end| column_of_end(&head, end));
                        let wanted = of(&answered, &head);
                        assert_eq!(of(&drawn, &head), wanted, "{path:?} {head} {pressure}");
                        let shown = cell[key].as_str().map(|text| text.parse::<f64>().unwrap());
                        // Models that are ready for many loads, as the page has them, round
                        // otherwise.
                        let is_same = match (shown, wanted) {
                            (Some(a), Some(b)) => (a / b - 1.0).abs() < 1e-13,
                            _ => shown == wanted,
                        };
                        assert!(is_same, "{path:?} {head} {pressure}: {shown:?} {wanted:?}");
                    }
                }
                if is_exported {
                    // From the closest place on.
                    let row = &table.rows[pressures.len() - 1 - k];
                    let exported: Vec<_> = row.iter().map(Cell::number).collect();
                    let of = |head| of(&drawn, head);
                    let tangent = of("tangent_N_per_m").map(|of| of / file.scene.nominal_area);
                    let wanted = [of("separation_m"), of("pressure_Pa"), tangent];
                    assert_eq!(exported, wanted, "{path:?} {pressure}");
                }
            }
            assert!(is_exported != path.ends_with("worn-pin.toml"), "{path:?}");
        }
    }

    #[test]
    fn beyond_what_was_solved_answers_have_no_interval() {
        let answer = &page_at(&joint(), "1 MPa", json!([]))["answer"];
        assert_eq!(answer["first"][0]["by"], "no interval");
        assert!(answer["first"].as_array().unwrap().iter().all(|part| part["lower"].is_null()));
    }

    #[test]
    fn what_was_solved_at_the_load_answers_unless_it_is_doubtful() {
        let solved = |pressure: f64, notes: Value| {
            let values = json!({ "area-fraction": "0.01", "tangent": "1e10" });
            json!([{ "pressure": pressure, "values": values, "notes": notes }])
        };
        let by = |text, solved| page_at(text, "1 MPa", solved)["answer"]["first"][0]["by"].clone();
        assert_eq!(by(SEAL, solved(1e6, json!([]))), "on this scan");
        assert_eq!(by(SEAL, solved(2e6, json!([]))), "0.028 to 0.0306");
        assert_eq!(by(SEAL, solved(1e6, json!(["few-patches"]))), "0.028 to 0.0306");
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
}
