//! Boundary elements on the scan of a scene, load by load.

use std::cell::RefCell;
use std::ops::ControlFlow;

use asperity::bem::{Bem, BoundaryElements, Direction, LoadCase, Progress, Solution};
use asperity::{ContactError, Quantity, Separation, SeparationUnit, short};
use asperity_answer::{Cell, Press, Pressed};
use asperity_plot::Map;
use asperity_scene::SceneFile;
use asperity_topography::Topography;
use serde_json::{Value, json};

use crate::answer::{Column, Known, quantities};
use crate::labels::finding;
use crate::picture;
use crate::random::MOST_PIXELS;
use crate::refusal::Refusal;
use crate::shown::{interval, shown};
use crate::span::Span;

/// Columns of a solution that are no quantities of models: head, unit, label and meaning.
const OWN: &str = include_str!("columns.txt");

/// The column of a head, if it is shown.
fn column(head: &str, file: &SceneFile) -> Option<Column> {
    let own = OWN.lines().find_map(|line| {
        let [own, unit, label, says] = line.split('|').collect::<Vec<_>>()[..] else { return None };
        (own == head).then(|| Column::new([own, unit, label], says.into()))
    });
    let quantity = Quantity::ALL.into_iter().find(|quantity| quantity.column() == head);
    let separation = Some(Column::separation(Some(file))).filter(|column| column.head == head);
    own.or(quantity.map(Column::from)).or(separation)
}

/// The size of a scan, why it cannot be solved here, whether filling its missing points helps, and
/// the mean pressures \[Pa\] over the range of the slider to solve it at, each with its load in
/// words.
pub(crate) fn scan(file: &SceneFile) -> Option<Value> {
    let scan = file.scan()?;
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
        false => file.bem().err().map(|error| error.to_string()),
    };
    let area = file.scene.nominal_area;
    let of = |pressure: f64| (pressure, shown(pressure * area, "N"));
    let pressures: Vec<_> = Span::of(file).solved().into_iter().map(of).collect();
    Some(json!({
        "rows": rows, "columns": columns, "refused": refused, "fill": fill, "pressures": pressures,
    }))
}

/// Solves the contact of a scene's scan at mean pressures, with `leaks` also the flow through its
/// gap and its seal: the first before all others, and of these the heaviest first. Events are the
/// progress, a load that is solved, one that failed, and at last the map of the flow at the first
/// load, which takes about twice as long as a solution.
pub(crate) fn press(
    file: &SceneFile,
    pressures: &[f64],
    leaks: bool,
    happened: impl FnMut(Value),
) -> Result<(), Refusal> {
    let bem = file.bem()?;
    if let Some(refused) = scan(file).as_ref().and_then(|scan| scan["refused"].as_str()) {
        return Err(Refusal::at("surface.file", refused));
    }
    let elements = bem.elements(&file.scene.interface)?;
    let mut quantities = quantities(file);
    let has_seal = file.spec.seal.is_some();
    let is_leak = |of: &Quantity| of.is_of_map() || has_seal && *of == Quantity::Leak;
    quantities.extend(Quantity::ALL.into_iter().filter(|of| leaks && is_leak(of)));
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let happened = RefCell::new(happened);
    let tell = |event: Value| (happened.borrow_mut())(event);
    let failed = |error: Refusal| json!({ "event": "failed", "message": error.message });
    let progress = |done: usize, what: &str| {
        let count = pressures.len();
        let text = format!("load {done} of {count} done; {what}");
        tell(json!({ "event": "progress", "done": done, "count": count, "text": text }));
    };
    let mut flowing = None;
    let (first, others) = given.split_at(given.len().min(1));
    for (before, given) in [(0, first), (first.len(), others)] {
        let press = Press::new(file, &bem, given, &quantities);
        let watch = |of: &Progress| {
            let mut what = format!("iteration {}", of.iterations);
            // A first iteration has none.
            if of.residual.is_finite() {
                what += &format!(", residual {:.0e}", of.residual);
            }
            progress(before + of.done, &what);
            ControlFlow::Continue(())
        };
        press.each(&elements, watch, |_, pressed| {
            let event = pressed.map_err(Refusal::from).and_then(|pressed| {
                let event = solved(&press, &pressed)?;
                let pressure = &event["pressure"];
                let kept = || leaks.then(|| (pressure.clone(), pressed.solution));
                flowing = flowing.take().or_else(kept);
                Ok(event)
            });
            tell(event.unwrap_or_else(failed));
        });
    }
    if let Some((pressure, solution)) = flowing {
        progress(given.len(), "the map of the flow");
        let map = flow(&bem, &elements, &solution);
        let event = |map| json!({ "event": "flow", "pressure": pressure, "map": map });
        tell(map.map_or_else(failed, event));
    }
    Ok(())
}

/// A load that was solved: its cells, with their names and what they mean, its notes and its map. A
/// quantity that boundary elements do not give has no cell.
fn solved(press: &Press<'_>, pressed: &Pressed) -> Result<Value, Refusal> {
    let (file, mut heads, mut row) = (press.file, press.heads(), pressed.cells.clone());
    // From the plane of the models' separations, so that both are in one picture.
    let gap = Separation::metres(pressed.solution.mean_gap).from_surface_mean();
    let separation =
        gap.measured_in(SeparationUnit::Metres, file.spec.separation_from, &file.scene);
    let none = |error: ContactError| Cell::Blank(Some(error.into()));
    heads.insert(2, "separation_m".into());
    row.insert(2, separation.map_or_else(none, |found| found.value.into()));
    let (mut columns, mut cells) = (vec![], vec![]);
    for (head, found) in heads.iter().zip(&row) {
        let found = match (found.number(), found.reason()) {
            (Some(value), _) => Ok(Known::new(value, true)),
            (_, Some(reason)) => Err(reason.to_string()),
            _ => continue,
        };
        // A liquid of a density has its flow in two units.
        let is_new = |new: &Column| columns.iter().all(|known: &Column| known.id != new.id);
        if let Some(column) = column(head, file).filter(is_new) {
            cells.push(column.cell(&found));
            columns.push(column);
        }
    }
    let notes: Value = pressed.notes.iter().map(finding).collect();
    Ok(json!({
        "event": "solved",
        "pressure": row[1],
        "load": shown(row[0].number().unwrap_or_default(), "N"),
        "head": columns,
        "cells": cells,
        "notes": notes,
        "maps": [contact(press, pressed)?],
    }))
}

/// The map of the contact pressures, with a line about it.
fn contact(press: &Press<'_>, Pressed { solution, .. }: &Pressed) -> Result<Value, Refusal> {
    let (heights, hardness) = (press.bem.map(), press.bem.hardness(&press.file.scene.interface)?);
    let mut caption = format!(
        "{}: {} in {} patches",
        shown(solution.mean_pressure, "Pa"),
        interval(solution.area, None, "%").0,
        solution.patches.len(),
    );
    if hardness.is_some() {
        caption += &format!(", {} plastic", interval(solution.plastic_area, None, "%").0);
    }
    let pressures = &solution.pressures;
    let map = Map {
        full: hardness.map_or("", |_| "plastic").into(),
        ..Map::of_pressures(pressures, heights.shape(), heights.pixel(), hardness)
    };
    picture::map(map, caption)
}

/// The map of the flow along x, with a line about it.
fn flow(bem: &Bem, elements: &BoundaryElements, solution: &Solution) -> Result<Value, Refusal> {
    let (heights, flux) = (bem.map(), elements.flux(solution, Direction::X)?);
    let what = match flux.iter().any(|flux| *flux > 0.0) {
        true => "flow from left to right through the gap",
        false => "no open path from left to right",
    };
    let caption = format!("{}: {what}", shown(solution.mean_pressure, "Pa"));
    picture::map(Map::of_flow(flux, heights.shape(), heights.pixel()), caption)
}

#[cfg(test)]
mod tests {
    use asperity_answer::{Sheet, Silent};
    use asperity_scene::{HandedFiles, parse_handed};

    use super::*;
    use crate::random::example;
    use crate::surface_keys::with_scan;

    fn pressed(text: &str, pressures: &[f64], leaks: bool) -> (SceneFile, Vec<Value>) {
        let keys = example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let mut events = vec![];
        press(&file, pressures, leaks, |event| events.push(event)).unwrap();
        (file, events)
    }

    fn digits(event: &Value, name: &str) -> Option<f64> {
        let cell = event["cells"].as_array()?.iter().find(|cell| cell["quantity"] == name)?;
        cell["digits"].as_str()?.parse().ok()
    }

    #[test]
    fn loads_are_solved_with_progress_as_the_library_solves_them() {
        let (file, events) = pressed(asperity_scene::template(), &[1e8, 5e7, 4e8], false);
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
                    let map = &event["maps"][0];
                    assert!(map["svg"].as_str().unwrap().starts_with("<svg"));
                    assert!(map["caption"].as_str().unwrap().contains("patches"));
                    let [head, cells] = ["head", "cells"].map(|key| event[key].as_array().unwrap());
                    assert_eq!(head.len(), cells.len());
                    let pressure = event["pressure"].as_f64().unwrap();
                    areas.push((pressure, digits(&event, "area-fraction").unwrap()));
                }
                _ => panic!("{event}"),
            }
        }
        assert!(iterations > 4, "{iterations}");
        let elements = file.bem().unwrap().elements(&file.scene.interface).unwrap();
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
                asperity_scene::template().replace("separation_from = \"asperity-mean\"", &wanted);
            let (file, events) = pressed(&text, &[2e8], false);
            let of = |name: &str| digits(events.last().unwrap(), name).unwrap();
            let offset = file.scene.mean_plane_offset();
            let above = if plane == "asperity-mean" { offset } else { 0.0 };
            assert!((of("separation") + above - of("mean-gap")).abs() < 1e-15 && offset > 1e-8);
            gaps.push(of("mean-gap").to_bits());
        }
        assert_eq!(gaps[0], gaps[1]);
    }

    const SEAL: &str = "\n[seal]\nwidth = 0.1\nlength = 0.002\nupstream_pressure = 1e6\n\
                        downstream_pressure = 0\n";

    #[test]
    fn leaks_are_those_of_the_program() {
        for fluid in ["gas = \"helium\"", "viscosity = 1e-3", "viscosity = 1e-3\ndensity = 1e3"] {
            let text = format!("{}{SEAL}{fluid}\n", asperity_scene::template());
            let (file, events) = pressed(&text, &[3e8], true);
            let [.., solved, _, map] = &events[..] else { panic!("{events:?}") };
            let bem = file.bem().unwrap();
            let given = [LoadCase::MeanPressure(3e8)];
            let all = ["effective-medium-gap", "hydraulic-gap-x", "hydraulic-gap-y", "leak"];
            let quantities = all.map(|name| name.parse().unwrap());
            let press = Press::new(&file, &bem, &given, &quantities);
            let mut sheet = Sheet::default();
            press.solve(&mut sheet, &Silent).unwrap();
            let flow = if fluid.contains("viscosity = 1e-3") && !fluid.contains("density") {
                "leak_x_m3_per_s"
            } else {
                "leak_x_kg_per_s"
            };
            for (name, head) in [
                ("effective-medium-gap", "effective_medium_gap_m"),
                ("hydraulic-gap-y", "hydraulic_gap_y_m"),
                ("leak-x", flow),
                ("tightest-gap-y", "tightest_gap_y_m"),
            ] {
                let wanted = sheet.rows[0][sheet.column(head).unwrap()].number().unwrap();
                let found = digits(solved, name).unwrap();
                let is_close = wanted > 0.0 && (found / wanted - 1.0).abs() < 1e-13;
                assert!(is_close, "{head}: {found} {wanted}");
            }
            assert_eq!((&map["event"], &map["pressure"]), (&json!("flow"), &solved["pressure"]));
            assert!(map["map"]["caption"].as_str().unwrap().contains("flow"));
        }
    }
}
