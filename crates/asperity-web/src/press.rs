//! Boundary elements on the scan of a scene, load by load.

use std::cell::RefCell;
use std::ops::ControlFlow;

use asperity::bem::{BoundaryElements, LoadCase, Progress, Solution};
use asperity::{Quantity, Separation, SeparationUnit, short};
use asperity_inputs::SceneFile;
use asperity_topography::Topography;
use serde_json::{Value, json};

use crate::answer::{SEPARATION, cell, quantities};
use crate::dialect::PAGE;
use crate::map_readings::map_readings;
use crate::picture;
use crate::random::MOST_PIXELS;
use crate::refusal::Refusal;
use crate::shown::shown;
use crate::span::Span;

/// Meanings of numbers that models do not have.
const MEAN_GAP: &str = "Distance of the mean planes of the two deformed surfaces.";
const PLASTIC: &str = "Share of the pixels that carry the hardness.";

/// The size of a scan, why it cannot be solved here, whether filling its missing points helps, and
/// the mean pressures \[Pa\] over the range of the slider to solve it at, each with its load in
/// words.
pub(crate) fn scan(file: &SceneFile) -> Option<Value> {
    let scan = file.scan.as_deref()?;
    let [rows, columns] = [scan.rows(), scan.columns()];
    let (large, missing) = (rows.max(columns) > MOST_PIXELS, scan.missing_share());
    let fill = !large && missing > 0.0 && missing <= Topography::MOST_FILLED;
    let refused = match large {
        true => Some(format!(
            "the scan has {rows} x {columns} pixels, and the page solves at most {MOST_PIXELS} x {MOST_PIXELS}: use the program, asperity bem scene.toml"
        )),
        false if fill => Some(format!(
            "{} % of the points are missing, and boundary elements need all",
            short(100.0 * missing)
        )),
        false => file.bem(None, false).err().map(|error| error.to_string()),
    };
    let area = file.scene.nominal_area;
    let of = |pressure: f64| (pressure, shown(pressure * area, "N"));
    let pressures: Vec<_> = Span::of(&file.scene).solved().into_iter().map(of).collect();
    Some(json!({
        "rows": rows, "columns": columns, "refused": refused, "fill": fill, "pressures": pressures,
    }))
}

/// Solves the contact of a scene's scan at mean pressures: the first before all others, and of
/// these the heaviest first. Events are the progress, a load that is solved, and one that failed.
pub(crate) fn press(
    file: &SceneFile,
    pressures: &[f64],
    happened: impl FnMut(Value),
) -> Result<(), Refusal> {
    let bem = file.bem(None, false)?;
    if let Some(refused) = scan(file).as_ref().and_then(|scan| scan["refused"].as_str()) {
        return Err(Refusal::at("surface.file", refused));
    }
    let interface = &file.scene.interface;
    let (elements, hardness) = (bem.elements(interface)?, bem.hardness(interface)?);
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let happened = RefCell::new(happened);
    let tell = |event: Value| (happened.borrow_mut())(event);
    let event = |solution: Solution| -> Result<Value, Refusal> {
        let mut event = solved(file, &elements, &solution);
        let (svg, caption) = picture::contact(&bem, &solution, hardness)?;
        (event["svg"], event["caption"]) = (svg.into(), caption.into());
        event["readings"] = map_readings(&bem, &solution);
        Ok(event)
    };
    let failed = |error: Refusal| json!({ "event": "failed", "message": error.message });
    let (first, others) = given.split_at(given.len().min(1));
    for (before, part) in [(0, first), (first.len(), others)] {
        let watch = |progress: &Progress| {
            let Progress { done, iterations, residual, .. } = *progress;
            let (done, count) = (before + done, given.len());
            let mut text = format!("load {done} of {count} done; iteration {iterations}");
            // A first iteration has none.
            if residual.is_finite() {
                text += &format!(", residual {residual:.0e}");
            }
            tell(json!({ "event": "progress", "done": done, "count": count, "text": text }));
            ControlFlow::Continue(())
        };
        elements.solve_each(part, watch, |_, solution| {
            tell(solution.map_err(Refusal::from).and_then(&event).unwrap_or_else(failed));
        });
    }
    Ok(())
}

/// A load that was solved: its cells, with their names and what they mean. Among them are the other
/// quantities of the models that a solved contact has, or why one is missing: the stiffness on
/// first loading, from two more solutions, and on unloading, with the contact held.
fn solved(file: &SceneFile, elements: &BoundaryElements, solution: &Solution) -> Value {
    // Exactly as given.
    let pressure = match solution.given {
        LoadCase::MeanPressure(pressure) => pressure,
        _ => solution.mean_pressure,
    };
    // From the plane of the models' separations, so that both are in one picture.
    let gap = Separation::metres(solution.mean_gap).from_surface_mean();
    let from = file.separation_from;
    let separation = gap.measured_in(SeparationUnit::Metres, from, &file.scene);
    let separation = separation.map(|found| found.value).map_err(|error| error.marked());
    let load = pressure * file.scene.nominal_area;
    let [mean_gap, patches] = [solution.mean_gap, solution.patches.len() as f64];
    let [area, plastic] = [solution.area, solution.plastic_area];
    let label = Quantity::AreaFraction.label();
    let from = format!("The mean gap, measured from {from} as the models' separation.");
    // Quantity, unit, value, name and meaning.
    let own = [
        ("load", "N", Ok(load), "load", ""),
        ("pressure", "Pa", Ok(pressure), "pressure", "Mean pressure on the nominal area."),
        ("area-fraction", "", Ok(area), label, "Real area of contact over the area of the scan."),
        ("mean-gap", "m", Ok(mean_gap), "mean gap", MEAN_GAP),
        (SEPARATION, "m", separation, "separation", &from),
        ("plastic-fraction", "", Ok(plastic), "plastic share", PLASTIC),
        ("patches", "", Ok(patches), "patches", "Number of connected contacts."),
    ];
    let (mut head, mut cells) = (vec![], vec![]);
    for (quantity, unit, value, name, meaning) in own {
        head.push((name, meaning));
        cells.push(cell(quantity, unit, value));
    }
    let mut others = quantities(file);
    others.retain(|quantity| *quantity != Quantity::AreaFraction);
    let summary = elements.summary(solution, &others);
    for quantity in others {
        let found = summary.evaluate(quantity, &file.scene).map_err(|error| error.to_string());
        if let Some(value) = found.map(|value| value.map(|value| value.value())).transpose() {
            head.push((quantity.label(), quantity.definition()));
            cells.push(cell(&quantity.to_string(), quantity.unit(), value));
        }
    }
    let notes: Value = solution.notes.iter().map(|note| PAGE.finding(note)).collect();
    json!({
        "event": "solved", "pressure": pressure, "load": shown(load, "N"),
        "head": head, "cells": cells, "notes": notes,
    })
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use asperity_inputs::{HandedFiles, parse_handed};

    use super::*;
    use crate::random::example;
    use crate::surface_keys::with_scan;

    fn pressed(text: &str, pressures: &[f64]) -> (SceneFile, Vec<Value>) {
        let keys = example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let mut events = vec![];
        press(&file, pressures, |event| events.push(event)).unwrap();
        (file, events)
    }

    fn digits(event: &Value, name: &str) -> Option<f64> {
        let cell = event["cells"].as_array()?.iter().find(|cell| cell["quantity"] == name)?;
        cell["digits"].as_str()?.parse().ok()
    }

    #[test]
    fn loads_are_solved_with_progress_as_the_library_solves_them() {
        let (file, events) = pressed(asperity_inputs::template(), &[1e8, 5e7, 4e8]);
        let (mut iterations, mut areas) = (0, vec![]);
        for event in events {
            match event["event"].as_str().unwrap() {
                "progress" => {
                    let text = event["text"].as_str().unwrap();
                    assert!(text.starts_with("load ") && !text.contains("NaN"), "{text}");
                    assert_eq!(event["done"], areas.len());
                    iterations += usize::from(event["count"] == 3);
                }
                "solved" => {
                    let found = &event["readings"];
                    let [x, values] = ["x", "values"].map(|key| found[key].as_array().unwrap());
                    assert_eq!((x.len(), values.len()), (64, 64 * 64));
                    let touching = values.iter().filter(|value| *value != "no contact").count();
                    assert!(touching > 0 && touching < values.len(), "{touching}");
                    assert_eq!(x[0], "500 nm");
                    assert!(event["caption"].as_str().unwrap().contains("patches"));
                    let [head, cells] = ["head", "cells"].map(|key| event[key].as_array().unwrap());
                    assert_eq!(head.len(), cells.len());
                    let pressure = event["pressure"].as_f64().unwrap();
                    areas.push((pressure, digits(&event, "area-fraction").unwrap()));
                }
                _ => panic!("{event}"),
            }
        }
        assert!(iterations > 4, "{iterations}");
        let elements = file.bem(None, false).unwrap().elements(&file.scene.interface).unwrap();
        // The first one alone, then the others.
        let mut wanted = vec![];
        for part in [&[1e8][..], &[4e8, 5e7]] {
            let cases: Vec<LoadCase> = part.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
            let all = elements.solve_all(&cases, |_| ControlFlow::Continue(()));
            wanted.extend(part.iter().zip(all).map(|(p, s)| (*p, s.unwrap().area)));
        }
        assert_eq!(areas, wanted);
    }

    #[test]
    fn the_separation_has_the_plane_of_the_models_and_the_mean_gap_its_own() {
        let mut gaps = vec![];
        for plane in ["asperity-mean", "surface-mean"] {
            let wanted = format!("separation_from = \"{plane}\"");
            let text =
                asperity_inputs::template().replace("separation_from = \"asperity-mean\"", &wanted);
            let (file, events) = pressed(&text, &[2e8]);
            let of = |name: &str| digits(events.last().unwrap(), name).unwrap();
            let offset = file.scene.mean_plane_offset();
            let above = if plane == "asperity-mean" { offset } else { 0.0 };
            assert!((of("separation") + above - of("mean-gap")).abs() < 1e-15 && offset > 1e-8);
            gaps.push(of("mean-gap").to_bits());
        }
        assert_eq!(gaps[0], gaps[1]);
    }

    #[test]
    fn stiffnesses_are_slopes_of_load_over_gap_and_unloading_is_the_stiffer() {
        let (file, events) = pressed(asperity_inputs::template(), &[2e8, 1.9e8, 2.1e8]);
        let solved = |wanted: f64, name: &str| {
            let at = |event: &&Value| {
                event["pressure"].as_f64().is_some_and(|p| (p / wanted - 1.0).abs() < 1e-9)
            };
            digits(events.iter().find(at)?, name)
        };
        let of = |pressure, name| solved(pressure, name).unwrap();
        let slope = (2.1e8 - 1.9e8) * file.scene.nominal_area
            / (of(1.9e8, "mean-gap") - of(2.1e8, "mean-gap"));
        let tangent = of(2e8, "tangent");
        assert!((tangent / slope - 1.0).abs() < 0.02, "{tangent} {slope}");
        // Pixels at the hardness respond only on loading.
        assert!(of(2e8, "plastic-fraction") > 0.0);
        assert!(of(2e8, "unloading-stiffness") > tangent);
    }

    #[test]
    fn a_scene_without_a_scan_is_refused_with_what_to_do() {
        let file = asperity_inputs::parse(asperity_inputs::template(), Path::new(".")).unwrap();
        let refused = press(&file, &[1e6], |_| {}).unwrap_err();
        assert_eq!(refused.field.as_deref(), Some("surface.file"));
        assert!(refused.message.contains("file = \"scan.x3p\""), "{}", refused.message);
    }
}
