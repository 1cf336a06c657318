//! Boundary elements on the scan of a scene, load by load.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use asperity::bem::{BemError, BoundaryElements, LoadCase, Solution};
use asperity::{Quantity, Separation, SeparationUnit};
use asperity_inputs::SceneFile;
use serde::Serialize;

use crate::answer::{cell, quantities};
use crate::dialect::{FindingShown, PAGE};
use crate::map_readings::MapReadings;
use crate::message::{AnswerCell, SEPARATION, ScanShown};
use crate::picture;
use crate::random::MOST_PIXELS;
use crate::refusal::Refusal;
use crate::shown::shown;
use crate::span::Span;

/// What happens during a solution.
#[derive(Debug, Clone, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub(crate) enum Event {
    /// An iteration was made.
    Progress { index: usize, done: usize, count: usize, iterations: usize, text: String },
    /// A load was solved.
    Solved {
        index: usize,
        pressure: f64,
        load: String,
        /// Names of the cells and what they mean.
        head: Vec<(&'static str, String)>,
        cells: Vec<AnswerCell>,
        /// Values beside the curves, by view.
        points: BTreeMap<String, f64>,
        svg: String,
        /// The pressures of the picture.
        readings: MapReadings,
        notes: Vec<FindingShown>,
    },
    /// A load has no solution.
    Failed { index: usize, message: String },
}

/// The size of a scan, and why it cannot be solved here.
pub(crate) fn scan(file: &SceneFile) -> Option<ScanShown> {
    let scan = file.scan.as_deref()?;
    let [rows, columns] = [scan.rows(), scan.columns()];
    let large = rows.max(columns) > MOST_PIXELS;
    let refused = large.then(|| {
        format!(
            "the scan has {rows} x {columns} pixels, and the page solves at most {MOST_PIXELS} x {MOST_PIXELS}: use the program, asperity bem scene.toml"
        )
    });
    let refused = refused.or_else(|| file.bem(None, false).err().map(|error| error.to_string()));
    let area = file.scene.nominal_area;
    let of = |pressure: f64| (pressure, shown(pressure * area, "N"));
    let pressures = Span::of(&file.scene).solved().into_iter().map(of).collect();
    Some(ScanShown { rows, columns, refused, pressures })
}

/// Solves the contact of a scene's scan at mean pressures: the first before all others, and of
/// these the heaviest first.
pub(crate) fn press(
    file: &SceneFile,
    pressures: &[f64],
    mut happened: impl FnMut(&Event),
) -> Result<(), Refusal> {
    let bem = file.bem(None, false)?;
    if let Some(refused) = scan(file).and_then(|scan| scan.refused) {
        return Err(Refusal::at("surface.file", refused));
    }
    let interface = &file.scene.interface;
    let (elements, hardness) = (bem.elements(interface)?, bem.hardness(interface)?);
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let happened = std::cell::RefCell::new(&mut happened);
    let tell = |event: &Event| (happened.borrow_mut())(event);
    let solved = |index, solved| {
        tell(&match solved {
            Err(BemError::Cancelled) => return,
            Err(error) => Event::Failed { index, message: error.to_string() },
            Ok(solution) => match picture::contact(&bem, &solution, hardness) {
                Err(error) => Event::Failed { index, message: error.message },
                Ok(svg) => {
                    let map = (svg, MapReadings::of(&bem, &solution));
                    let pressure = pressures.get(index).copied().unwrap_or(solution.mean_pressure);
                    let others = others(&elements, &solution, file);
                    Event::solved(index, pressure, file, map, (solution, others))
                }
            },
        });
    };
    let (first, others) = given.split_at(given.len().min(1));
    for (before, part) in [(0, first), (first.len(), others)] {
        let watch = |progress: &asperity::bem::Progress| {
            tell(&Event::progress(progress, before, given.len()));
            ControlFlow::Continue(())
        };
        elements.solve_each(part, watch, |index, solution| solved(before + index, solution));
    }
    Ok(())
}

/// The other quantities of the models that a solved contact has, or why one is missing: among them
/// the stiffness on first loading, from two more solutions, and on unloading, with the contact
/// held.
fn others(elements: &BoundaryElements, solution: &Solution, file: &SceneFile) -> Vec<Found> {
    let mut all = quantities(file);
    all.retain(|quantity| *quantity != Quantity::AreaFraction);
    let summary = elements.summary(solution, &all);
    let found = |quantity: Quantity| match summary.evaluate(quantity, &file.scene) {
        Ok(value) => value.map(|value| (quantity, Ok(value.value()))),
        Err(error) => Some((quantity, Err(error.to_string()))),
    };
    all.into_iter().filter_map(found).collect()
}

/// A quantity with its value, or the reason why it is missing.
type Found = (Quantity, Result<f64, String>);

impl Event {
    /// Progress within a part of the loads, after `before` solved ones; `count` is the number of
    /// all.
    fn progress(progress: &asperity::bem::Progress, before: usize, count: usize) -> Self {
        let asperity::bem::Progress { index, done, iterations, residual, .. } = *progress;
        let (index, done) = (before + index, before + done);
        let mut text = format!("load {done} of {count} done; iteration {iterations}");
        // A first iteration has none.
        if residual.is_finite() {
            text += &format!(", residual {residual:.0e}");
        }
        Self::Progress { index, done, count, iterations, text }
    }

    fn solved(
        index: usize,
        pressure: f64,
        file: &SceneFile,
        (svg, readings): (String, MapReadings),
        (solution, others): (Solution, Vec<Found>),
    ) -> Self {
        // From the plane of the models' separations, so that both are in one picture.
        let gap = Separation::metres(solution.mean_gap).from_surface_mean();
        let from = file.separation_from;
        let separation = gap.measured_in(SeparationUnit::Metres, from, &file.scene);
        let separation = separation.map(|found| found.value).map_err(|error| error.marked());
        let load = pressure * file.scene.nominal_area;
        let shown = shown(load, "N");
        let area = solution.area;
        let mut points = BTreeMap::from([(Quantity::AreaFraction.to_string(), area)]);
        points.extend(separation.iter().map(|value| (SEPARATION.to_string(), *value)));
        let found = |(quantity, found): &Found| {
            found.as_ref().ok().map(|value| (quantity.to_string(), *value))
        };
        points.extend(others.iter().filter_map(found));
        let patches = solution.patches.len() as f64;
        let from = format!("The mean gap, measured from {from} as the models' separation.");
        // Quantity, unit, value, name and meaning.
        let own = [
            ("load", "N", Ok(load), "load", ""),
            ("pressure", "Pa", Ok(pressure), "pressure", "Mean pressure on the nominal area."),
            (
                "area-fraction",
                "",
                Ok(area),
                Quantity::AreaFraction.label(),
                "Real area of contact over the area of the scan.",
            ),
            (
                "mean-gap",
                "m",
                Ok(solution.mean_gap),
                "mean gap",
                "Distance of the mean planes of the two deformed surfaces.",
            ),
            (SEPARATION, "m", separation, "separation", &from),
            (
                "plastic-fraction",
                "",
                Ok(solution.plastic_area),
                "plastic share",
                "Share of the pixels that carry the hardness.",
            ),
            ("patches", "", Ok(patches), "patches", "Number of connected contacts."),
        ];
        let (mut head, mut cells) = (vec![], vec![]);
        for (quantity, unit, value, name, meaning) in own {
            head.push((name, meaning.to_string()));
            cells.push(cell(quantity, unit, value, None));
        }
        for (quantity, found) in others {
            head.push((quantity.label(), quantity.definition().into()));
            cells.push(cell(&quantity.to_string(), quantity.unit(), found, None));
        }
        let notes = solution.notes.iter().map(|note| PAGE.finding(note)).collect();
        Self::Solved { index, pressure, load: shown, head, cells, points, svg, readings, notes }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use asperity_inputs::{HandedFiles, parse_handed};

    use super::*;
    use crate::random::example;
    use crate::surface_keys::with_scan;

    fn pressed(text: &str, pressures: &[f64]) -> (SceneFile, Vec<Event>) {
        let keys = example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = with_scan(text, &keys.name()).unwrap();
        let file = parse_handed(&text, &files).unwrap();
        let mut events = vec![];
        press(&file, pressures, |event| events.push(event.clone())).unwrap();
        (file, events)
    }

    #[test]
    fn loads_are_solved_with_progress_as_the_library_solves_them() {
        let (file, events) = pressed(asperity_inputs::template(), &[1e8, 5e7, 4e8]);
        let (mut iterations, mut areas) = (0, vec![]);
        for event in events {
            match event {
                Event::Progress { count, done, text, .. } => {
                    assert!(text.starts_with("load ") && !text.contains("NaN"), "{text}");
                    assert_eq!(done, areas.len());
                    iterations += usize::from(count == 3);
                }
                Event::Solved { pressure, svg, cells, head, points, readings, .. } => {
                    let found = serde_json::to_value(readings).unwrap();
                    let [x, values] = ["x", "values"].map(|key| found[key].as_array().unwrap());
                    assert_eq!((x.len(), values.len()), (64, 64 * 64));
                    let touching = values.iter().filter(|value| *value != "no contact").count();
                    assert!(touching > 0 && touching < values.len(), "{touching}");
                    assert_eq!(x[0], "500 nm");
                    assert!(svg.contains("blank: no contact") && cells.len() == head.len());
                    areas.push((pressure, points["area-fraction"]));
                }
                Event::Failed { message, .. } => panic!("{message}"),
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
            let Some(Event::Solved { cells, points, .. }) = events.last() else {
                panic!("{plane}")
            };
            let of = |name: &str| -> f64 {
                let cell = cells.iter().find(|cell| cell.quantity == name).unwrap();
                cell.digits.as_deref().unwrap().parse().unwrap()
            };
            let offset = file.scene.mean_plane_offset();
            let above = if plane == "asperity-mean" { offset } else { 0.0 };
            assert!((of("separation") + above - of("mean-gap")).abs() < 1e-15 && offset > 1e-8);
            assert_eq!(points["separation"].to_bits(), of("separation").to_bits());
            gaps.push(of("mean-gap").to_bits());
        }
        assert_eq!(gaps[0], gaps[1]);
    }

    #[test]
    fn stiffnesses_are_slopes_of_load_over_gap_and_unloading_is_the_stiffer() {
        let (file, events) = pressed(asperity_inputs::template(), &[2e8, 1.9e8, 2.1e8]);
        let solved = |wanted: f64, name: &str| {
            events.iter().find_map(|event| match event {
                Event::Solved { pressure, cells, .. } if (pressure / wanted - 1.0).abs() < 1e-9 => {
                    let cell = cells.iter().find(|cell| cell.quantity == name)?;
                    cell.digits.as_deref()?.parse::<f64>().ok()
                }
                _ => None,
            })
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
