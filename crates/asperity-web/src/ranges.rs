//! The answers of a scene whose surface is known within ranges: those in the middle of the ranges
//! with the smallest and the largest at their ends.

use std::collections::BTreeMap;

use asperity::{At, ContactError, Quantity, Request, shortest_digits};
use asperity_answer::{AnswerError, Cell, Inquiry, Sheet, Silent, drawn_with_ranges, with_ranges};
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::dialect::said;
use crate::message::LoadKeys;
use crate::refusal::Refusal;
use crate::shown::interval;
use crate::{Desk, answer};

/// The desks of a scene in the middle of its ranges and at each combination of their ends.
pub(crate) struct Ranges {
    pub(crate) middle: Desk,
    ends: Vec<Desk>,
    /// The unknowns with the ratios of their ends.
    spreads: Vec<(&'static str, f64)>,
}

impl Ranges {
    /// The desks of a scene; none where its surface is known.
    pub(crate) fn of(file: &SceneFile) -> Result<Option<Self>, ContactError> {
        let spreads = file.spreads();
        if spreads.is_empty() {
            return Ok(None);
        }
        let (middle, ends) = file.corners()?;
        let ends = ends.into_iter().map(Desk::at_an_end).collect();
        Ok(Some(Self { middle: Desk::at_an_end(middle), ends, spreads }))
    }

    /// The values of models at a load and the answer there, each number with its ends.
    pub(crate) fn values(&mut self, models: &[String], load: &LoadKeys) -> Result<Value, Refusal> {
        let mut found = self.middle.values(models, load, &[])?;
        // The slider stands for another load at each end.
        let word = |key: &str| found["load"][key].as_str().unwrap_or_default().to_string();
        let same = LoadKeys { text: word("text"), unit: word("unit"), ..LoadKeys::default() };
        let ends = self.ends.iter_mut().map(|desk| desk.values(models, &same, &[]));
        let ends = ends.collect::<Result<Vec<_>, _>>()?;
        merge(&mut found, &ends.iter().collect::<Vec<_>>());
        for row in found["rows"].as_array_mut().into_iter().flatten() {
            // Its percentages are those of the middle alone.
            row["against"] = Value::Null;
        }
        let first = found["answer"]["first"].as_array().into_iter().flatten();
        let parts = first.filter_map(|part| {
            let word = |key: &str| part[key].as_str();
            Some(format!("{} {}, {}", word("name")?, word("shown")?, word("by")?))
        });
        let spoken = parts.collect::<Vec<_>>().join("; ");
        found["answer"]["spoken"] = format!("At {}: {spoken}", same.text).into();
        found["answer"]["surface"] = "known within ranges".into();
        let spread = |(name, ratio): &(&'static str, f64)| format!("`{name}` within {ratio:.1}");
        let spreads = self.spreads.iter().map(spread).collect::<Vec<_>>().join(", ");
        let model = found["answer"]["use"]["model"].as_str().unwrap_or_default().to_string();
        let basis = format!(
            "Ranges by {model}, of a surface with {spreads}; Rdq, or Rz with RSm, or a scan narrows them."
        );
        found["answer"]["basis"] = said(&basis).into();
        Ok(found)
    }
}

/// The rows of models at the loads of the picture, and those of the ends as further models.
pub(crate) fn curves(
    file: &SceneFile,
    ids: &[String],
    pressures: &[f64],
) -> Result<Value, Refusal> {
    let at = pressures.iter().map(|pressure| At::Pressure(*pressure));
    let request = Request::new(answer::quantities(file)).at(at);
    let head = answer::head(file);
    let of_model = |id: &String| {
        let fill = |file: &SceneFile, sheet: &mut Sheet| -> Result<(), AnswerError> {
            let models = vec![(id.clone(), file.model(id)?)];
            Inquiry::new(file, models, request.clone()).answer(sheet, &Silent)
        };
        let mut sheet = Sheet::default();
        with_ranges(file, &mut sheet, fill).ok()?;
        let sheet = drawn_with_ranges(file, &sheet);
        let columns: Vec<usize> = head.split(',').filter_map(|head| sheet.column(head)).collect();
        let text = |cell: &Cell| match cell.number() {
            Some(number) => shortest_digits(number),
            None => cell.text().into(),
        };
        let line = |row: &Vec<Cell>| {
            let cells: Vec<String> = columns.iter().map(|column| text(&row[*column])).collect();
            cells.join(",") + "\n"
        };
        Some((id.clone(), sheet.rows.iter().map(line).collect::<String>()))
    };
    Ok(json!(ids.iter().filter_map(of_model).collect::<BTreeMap<_, _>>()))
}

/// Adds the ends to every number of an answer, and takes away those that are missing at an end.
fn merge(found: &mut Value, ends: &[&Value]) {
    let number = |value: &Value| value["digits"].as_str()?.parse::<f64>().ok();
    if let Some(own) = number(found) {
        let name = found["quantity"].as_str().unwrap_or_default().to_string();
        let unit = match name.as_str() {
            answer::SEPARATION => "m",
            name => name.parse::<Quantity>().map_or("", Quantity::unit),
        };
        let all: Option<Vec<f64>> = ends.iter().map(|end| number(end)).collect();
        let fold = |all: &Vec<f64>, of: fn(f64, f64) -> f64| all.iter().copied().fold(own, of);
        match all.map(|all| [fold(&all, f64::min), fold(&all, f64::max)]) {
            Some([lower, upper]) => {
                let is_share = name == Quantity::AreaFraction.to_string();
                let unit = if is_share { "%" } else { unit };
                let (shown, range) = interval(own, Some([lower, upper]), unit);
                let [lower, upper] = [lower, upper].map(shortest_digits);
                (found["lower"], found["upper"]) = (lower.into(), upper.into());
                // Parts of the answer have a line below their value.
                match ["by", "says"].into_iter().find(|key| found[key].is_string()) {
                    Some(key) => {
                        let beside = found[key].as_str().unwrap_or_default();
                        found[key] = format!("{range}, {beside}").into();
                        found["shown"] = shown.into();
                    }
                    None => found["shown"] = format!("{shown} ({range})").into(),
                }
            }
            None => {
                *found =
                    json!({ "quantity": name, "name": found["name"], "shown": NO_RANGE, "by": "" })
            }
        }
        return;
    }
    match found {
        Value::Array(items) => {
            for (k, item) in items.iter_mut().enumerate() {
                merge(item, &ends.iter().map(|end| &end[k]).collect::<Vec<_>>());
            }
        }
        Value::Object(fields) => {
            for (key, field) in fields {
                merge(field, &ends.iter().map(|end| &end[key.as_str()]).collect::<Vec<_>>());
            }
        }
        _ => {}
    }
}

const NO_RANGE: &str = "no value at an end of the ranges of the surface";

#[cfg(test)]
mod tests {
    use super::*;

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
            "Ranges by ke, of a surface with rq within 1.1, mean slope within 4.2, bandwidth";
        assert!(basis.starts_with(words), "{basis}");
        assert_eq!(found["rows"][1]["model"], "ke");
    }

    #[test]
    fn curves_have_their_ends_and_single_numbers_are_refused() {
        let mut desk = Desk::default();
        call(&mut desk, json!({ "call": "show", "text": GROUND }));
        let curves = call(&mut desk, json!({ "call": "curve", "models": ["ke"] }));
        let rows = curves["ke"].as_str().unwrap();
        let of = |name: &str| -> Vec<f64> {
            let own = rows.lines().filter(|line| line.starts_with(&format!("{name},")));
            own.map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect()
        };
        let (own, lower, upper) = (of("ke"), of("ke lower"), of("ke upper"));
        assert_eq!((own.len(), lower.len(), upper.len()), (200, 200, 200));
        assert!((0..200).all(|k| lower[k] <= own[k] && own[k] <= upper[k]));
        let load = json!({ "text": "1 MPa" });
        let drawn = json!({ "call": "draw", "rows": [rows], "view": "tangent", "load": load, "solved": [] });
        assert!(call(&mut desk, drawn).as_str().unwrap().starts_with("<svg"));
        let findings = call(&mut desk, json!({ "call": "check", "models": ["ke"], "load": load }));
        assert!(findings.is_array());
        let export = json!({ "call": "export", "model": "ke", "form": "csv", "units": "SI" });
        let refused: Value = serde_json::from_str(&desk.call(&export.to_string())).unwrap();
        assert!(refused["error"]["message"].as_str().unwrap().contains("within ranges only"));
    }
}
