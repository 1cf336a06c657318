//! Boundary elements on the scan of a scene, load by load.

use std::ops::ControlFlow;

use asperity::bem::{BemError, LoadCase};
use asperity::{Diagnostic, shortest_digits};
use asperity_scene::{HandedFiles, SceneFile, parse_handed_scan};
use serde::Serialize;

use crate::message::{AnswerCell, ScanShown};
use crate::picture;
use crate::random::MOST_PIXELS;
use crate::refusal::Refusal;
use crate::shown::shown;

/// What happens during a solution.
#[derive(Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub(crate) enum Event {
    /// An iteration was made.
    Progress { index: usize, done: usize, count: usize, iterations: usize, residual: f64 },
    /// A load was solved.
    Solved {
        index: usize,
        pressure: f64,
        area: f64,
        gap: f64,
        load: String,
        cells: Vec<AnswerCell>,
        svg: String,
        notes: Vec<Diagnostic>,
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
    Some(ScanShown { rows, columns, refused })
}

/// Solves the contact of a scene's scan at mean pressures, the heaviest first.
pub(crate) fn press(
    text: &str,
    files: &HandedFiles,
    pressures: &[f64],
    mut happened: impl FnMut(&Event),
) -> Result<(), Refusal> {
    let file = parse_handed_scan(text, files)?;
    let bem = file.bem(None, false)?;
    if let Some(refused) = scan(&file).and_then(|scan| scan.refused) {
        return Err(Refusal::at("surface.file", refused));
    }
    let interface = &file.scene.interface;
    let (elements, hardness) = (bem.elements(interface)?, bem.hardness(interface)?);
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let happened = std::cell::RefCell::new(&mut happened);
    let tell = |event: &Event| (happened.borrow_mut())(event);
    let watch = |progress: &asperity::bem::Progress| {
        tell(&Event::Progress {
            index: progress.index,
            done: progress.done,
            count: given.len(),
            iterations: progress.iterations,
            residual: progress.residual,
        });
        ControlFlow::Continue(())
    };
    elements.solve_each(&given, watch, |index, solved| {
        let failed = |message: String| Event::Failed { index, message };
        tell(&match solved {
            Err(BemError::Cancelled) => return,
            Err(error) => failed(error.to_string()),
            Ok(solution) => match picture::contact(&bem, &solution, hardness) {
                Err(error) => failed(error.message),
                Ok(svg) => {
                    let pressure = pressures.get(index).copied().unwrap_or(solution.mean_pressure);
                    let load = pressure * file.scene.nominal_area;
                    let cell = |quantity: &str, unit: &str, value: f64| AnswerCell {
                        quantity: quantity.into(),
                        digits: Some(shortest_digits(value)),
                        bound: None,
                        shown: shown(value, unit),
                    };
                    let cells = vec![
                        cell("load", "N", load),
                        cell("pressure", "Pa", pressure),
                        cell("area-fraction", "", solution.area),
                        cell("separation", "m", solution.mean_gap),
                        cell("plastic-fraction", "", solution.plastic_area),
                        cell("patches", "", solution.patches.len() as f64),
                    ];
                    let (area, gap) = (solution.area, solution.mean_gap);
                    let (load, notes) = (shown(load, "N"), solution.notes);
                    Event::Solved { index, pressure, area, gap, load, cells, svg, notes }
                }
            },
        });
    });
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::example;

    fn scene(name: &str) -> String {
        asperity_scene::template()
            .replace("asperity_radius =", "# ")
            .replace("asperity_density =", "# ")
            .replace(
                "asperity_height_std = 1e-6            # m, of",
                &format!("file = \"{name}\"\nperiodic = true # "),
            )
    }

    #[test]
    fn loads_are_solved_with_progress_as_the_library_solves_them() {
        let keys = example();
        let files = HandedFiles::from([(keys.name(), keys.file().unwrap())]);
        let text = scene(&keys.name());
        let (mut iterations, mut areas) = (0, vec![]);
        press(&text, &files, &[1e8, 4e8], |event| match event {
            Event::Progress { count, .. } => iterations += usize::from(*count == 2),
            Event::Solved { pressure, area, svg, cells, .. } => {
                assert!(svg.contains("white: no contact") && cells.len() == 6);
                areas.push((*pressure, *area));
            }
            Event::Failed { message, .. } => panic!("{message}"),
        })
        .unwrap();
        assert!(iterations > 4, "{iterations}");
        let file = asperity_scene::parse_handed(&text, &files).unwrap();
        let elements = file.bem(None, false).unwrap().elements(&file.scene.interface).unwrap();
        let all = elements
            .solve_all(&[4e8, 1e8].map(LoadCase::MeanPressure), |_| ControlFlow::Continue(()));
        let wanted: Vec<(f64, f64)> =
            [4e8, 1e8].into_iter().zip(all).map(|(p, s)| (p, s.unwrap().area)).collect();
        assert_eq!(areas, wanted);
    }

    #[test]
    fn a_scene_without_a_scan_is_refused_with_what_to_do() {
        let refused = press(asperity_scene::template(), &HandedFiles::new(), &[1e6], |_| {});
        let refused = refused.unwrap_err();
        assert_eq!(refused.field.as_deref(), Some("surface.file"));
        assert!(refused.message.contains("file = \"scan.x3p\""), "{}", refused.message);
    }
}
