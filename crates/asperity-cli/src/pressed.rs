//! Solution of several contacts of a scan, with rows and warnings.

use anyhow::Result;
use asperity::bem::{Bem, BemError, LoadCase, Solution};
use asperity::{Described, Findings, Quantity};

use crate::interrupt;
use crate::output::{once, progress};
use crate::scene::LoadedScene;

/// The row of a contact in a table.
pub struct Row {
    pub pressure: f64,
    pub area: f64,
    pub pixel_area: f64,
    pub plastic: f64,
    pub gap: f64,
    pub patches: usize,
    pub iterations: usize,
    pub residual: f64,
    /// Of the requested quantities; `None` without a value.
    pub values: Vec<Option<f64>>,
}

impl Row {
    fn new(solution: &Solution, values: Vec<Option<f64>>) -> Self {
        Self {
            values,
            // Exactly as given.
            pressure: match solution.given {
                LoadCase::MeanPressure(pressure) => pressure,
                _ => solution.mean_pressure,
            },
            area: solution.area,
            pixel_area: solution.pixel_area,
            plastic: solution.plastic_area,
            gap: solution.mean_gap,
            patches: solution.patches.len(),
            iterations: solution.iterations,
            residual: solution.residual,
        }
    }
}

/// The solution of a list of contacts.
pub struct Run<'a> {
    pub scene: &'a LoadedScene,
    pub given: &'a [LoadCase],
    pub quantities: &'a [Quantity],
    /// Pressures of the solved contacts, if kept.
    pub maps: Vec<Vec<f64>>,
    pub errors: Vec<String>,
    pub found: Findings,
}

impl Run<'_> {
    /// One row per load or gap; `None` without a solution, with the error in `errors`.
    pub fn solve(&mut self, bem: &Bem, keep: bool) -> Result<Vec<Option<Row>>> {
        let [rows, columns] = bem.map().shape();
        let elements = bem.elements(&self.scene.file.scene.interface)?;
        let bar = progress(bem.id());
        let mut answers: Vec<Option<Row>> = self.given.iter().map(|_| None).collect();
        let mut maps: Vec<Vec<f64>> = self.given.iter().map(|_| vec![]).collect();
        let (mut found, mut errors) = (vec![], vec![]);
        let mut lacks = vec![];
        let mut values = |solution: &Solution| -> Vec<Option<f64>> {
            let summary = elements.summary(solution, self.quantities);
            let mut value =
                |quantity: &Quantity| match summary.evaluate(*quantity, &self.scene.file.scene) {
                    Ok(found) => found.map(|found| found.value()),
                    Err(error) => {
                        lacks.push(format!("no {quantity}: {error}"));
                        None
                    }
                };
            self.quantities.iter().map(&mut value).collect()
        };
        let watch = interrupt::watch(|progress| {
            bar.set_message(format!(
                "bem: {} of {} on {rows} x {columns} pixels, iteration {}, residual {:.0e}",
                progress.done + 1,
                self.given.len(),
                progress.iterations,
                progress.residual
            ));
        });
        elements.solve_each(self.given, watch?, |index, solution| match solution {
            Ok(solution) => {
                found.extend(solution.notes.iter().cloned());
                answers[index] = Some(Row::new(&solution, values(&solution)));
                if keep {
                    maps[index] = solution.pressures;
                }
            }
            Err(BemError::Cancelled) => {}
            Err(error) => errors.push(error.to_string()),
        });
        drop(bar);
        maps.retain(|map| !map.is_empty());
        self.maps.extend(maps);
        errors.append(&mut lacks);
        self.errors.extend(once(&errors));
        let grid = format!("{rows} x {columns} pixels");
        self.found.extend(found.into_iter().map(|found| found.from_origin(grid.clone())));
        Ok(answers)
    }
}
