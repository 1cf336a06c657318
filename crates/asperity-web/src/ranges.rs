//! The answers of a scene whose surface is known within ranges: those in the middle of the ranges
//! with the smallest and the largest at their ends.

use std::collections::BTreeMap;

use asperity::{ContactError, Quantity, shortest_digits};
use asperity_inputs::SceneFile;
use serde_json::{Value, json};

use crate::message::LoadKeys;
use crate::refusal::Refusal;
use crate::shown::interval;
use crate::{Desk, answer};

/// The desks of a scene in the middle of its ranges and at each combination of their ends.
pub(crate) struct Ranges {
    pub(crate) middle: Desk,
    ends: Vec<Desk>,
}

impl Ranges {
    /// The desks of a scene; none where its surface is known.
    pub(crate) fn of(file: &SceneFile) -> Result<Option<Self>, ContactError> {
        if file.spreads().is_empty() {
            return Ok(None);
        }
        let (middle, ends) = file.corners()?;
        let ends = ends.into_iter().map(Desk::at_an_end).collect();
        Ok(Some(Self { middle: Desk::at_an_end(middle), ends }))
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
        let said = first.filter_map(|part| {
            let word = |key: &str| part[key].as_str();
            Some(format!("{} {}, {}", word("name")?, word("shown")?, word("by")?))
        });
        let said = said.collect::<Vec<_>>().join("; ");
        found["answer"]["spoken"] = format!("At {}: {said}", same.text).into();
        found["answer"]["surface"] = "known within ranges".into();
        Ok(found)
    }

    /// The rows of models at the loads of the picture, and those of the ends as further models.
    pub(crate) fn curves(
        &mut self,
        models: &[String],
        pressures: &[f64],
    ) -> Result<Value, Refusal> {
        let middle = self.middle.rows(models, pressures)?;
        let ends = self.ends.iter_mut().map(|desk| desk.rows(models, pressures));
        let ends = ends.collect::<Result<Vec<_>, _>>()?;
        let with_ends = |(id, own): (String, String)| {
            let texts: Option<Vec<&String>> = ends.iter().map(|end| end.get(&id)).collect();
            let texts: Vec<Vec<&str>> = texts?.iter().map(|text| text.lines().collect()).collect();
            let names = [id.clone(), format!("{id} lower"), format!("{id} upper")];
            let mut rows = [const { String::new() }; 3];
            for (k, line) in own.lines().enumerate() {
                let numbers =
                    |line: &&str| line.split(',').skip(1).map(|n| n.parse().ok()).collect();
                let own: Vec<Option<f64>> = numbers(&line);
                let others: Vec<Vec<Option<f64>>> =
                    texts.iter().filter_map(|lines| Some(numbers(lines.get(k)?))).collect();
                let all = own.iter().enumerate().map(|(column, own)| {
                    ends_of(*own, others.iter().map(|other| other.get(column).copied().flatten()))
                });
                let all: Vec<Option<[f64; 3]>> = all.collect();
                for (place, (text, name)) in rows.iter_mut().zip(&names).enumerate() {
                    let digits = |ends: &Option<[f64; 3]>| {
                        ends.map_or(String::new(), |ends| shortest_digits(ends[place]))
                    };
                    let cells: Vec<String> = all.iter().map(digits).collect();
                    *text += &format!("{name},{}\n", cells.join(","));
                }
            }
            Some((id, rows.concat()))
        };
        Ok(json!(middle.into_iter().filter_map(with_ends).collect::<BTreeMap<_, _>>()))
    }
}

/// A value with its smallest and largest; none if it is missing anywhere.
fn ends_of(own: Option<f64>, others: impl Iterator<Item = Option<f64>>) -> Option<[f64; 3]> {
    let own = own?;
    let mut all = others;
    all.try_fold([own; 3], |[own, lower, upper], other| {
        Some([own, lower.min(other?), upper.max(other?)])
    })
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
        match ends_of(Some(own), ends.iter().map(|end| number(end))) {
            Some([own, lower, upper]) => {
                let is_share = name == Quantity::AreaFraction.to_string();
                let unit = if is_share { "%" } else { unit };
                let (shown, range) = interval(own, Some([lower, upper]), unit);
                let [lower, upper] = [lower, upper].map(shortest_digits);
                (found["lower"], found["upper"]) = (lower.into(), upper.into());
                if let Some(by) = found["by"].as_str() {
                    (found["by"], found["shown"]) = (format!("{range}, {by}").into(), shown.into());
                } else {
                    found["shown"] = format!("{shown} ({range})").into();
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
