//! Boundary elements on the scan of a scene.

use std::ops::ControlFlow;

use asperity::bem::{Bem, BemError, BoundaryElements, Continuation, LoadCase, Progress, Solution};
use asperity::{Code, ContactError, ContactModel, Finding, Findings, Quantity, Request};
use asperity_scene::SceneFile;

use crate::leak::Leaking;
use crate::models::once;
use crate::{AnswerError, Cell, Sheet, Watch};

/// An area that is pressure over hardness, up to rounding.
const ROUNDED: f64 = 1.0 + 1e-12;

/// A number of a solution on a nominal area.
type Number = fn(&Solution, f64) -> Cell;
/// Columns of every solution.
const COLUMNS: [(&str, Number); 10] = [
    ("load_N", |found, area| (pressure(found) * area).into()),
    ("pressure_Pa", |found, _| pressure(found).into()),
    ("area_fraction", |found, _| found.area.into()),
    ("area_fraction_pixels", |found, _| found.pixel_area.into()),
    ("plastic_fraction", |found, _| found.plastic_area.into()),
    ("mean_gap_m", |found, _| found.mean_gap.into()),
    ("mean_open_gap_m", |found, _| found.mean_open_gap.into()),
    ("patches", |found, _| (found.patches.len() as f64).into()),
    ("iterations", |found, _| (found.iterations as f64).into()),
    ("residual", |found, _| found.residual.into()),
];

/// The mean pressure, exactly as given.
fn pressure(solution: &Solution) -> f64 {
    match solution.given {
        LoadCase::MeanPressure(pressure) => pressure,
        _ => solution.mean_pressure,
    }
}

/// What is solved on the scan of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Press<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// The model of its scan.
    pub bem: &'a Bem,
    /// Loads or gaps.
    pub given: &'a [LoadCase],
    /// Quantities besides what every solution has.
    pub quantities: &'a [Quantity],
    /// Whether [`solve`](Self::solve) adds the same on half the grid.
    pub refine: bool,
    /// Whether [`solve`](Self::solve) keeps the solutions.
    pub keep: bool,
}

/// A load or gap that was solved.
#[derive(Debug)]
pub struct Pressed {
    /// Its row, under [`Press::heads`].
    pub cells: Vec<Cell>,
    /// The notes of the solution and of what follows from it.
    pub notes: Vec<Finding>,
    /// The solution.
    pub solution: Solution,
}

/// The cells of each solution, `None` without one, the solutions that are kept, and the findings.
type Solved = (Vec<Option<Vec<Cell>>>, Vec<Solution>, Findings);

impl<'a> Press<'a> {
    /// Loads or gaps on the scan of a scene, and solutions that are not kept.
    #[must_use]
    pub fn new(
        file: &'a SceneFile,
        bem: &'a Bem,
        given: &'a [LoadCase],
        quantities: &'a [Quantity],
    ) -> Self {
        Self { file, bem, given, quantities, refine: false, keep: false }
    }

    /// The columns of a solved load or gap.
    #[must_use]
    pub fn heads(&self) -> Vec<String> {
        let quantities = self.quantities().into_iter().map(Quantity::column);
        let all = COLUMNS.iter().map(|(head, _)| (*head).into()).chain(quantities);
        all.chain(self.leaking().iter().flat_map(Leaking::heads)).collect()
    }

    /// The seal whose leak is asked for, if the scene has one.
    fn leaking(&self) -> Option<Leaking> {
        Leaking::of(self.file, self.quantities).ok().flatten()
    }

    /// The quantities asked for, each once, without those that every solution has.
    fn quantities(&self) -> Vec<Quantity> {
        let mut all = self.quantities.to_vec();
        all.retain(|quantity| {
            let is_own = |(head, _): &(&str, Number)| *head == quantity.column();
            *quantity != Quantity::Leak && !COLUMNS.iter().any(is_own)
        });
        once(&all)
    }

    /// Solves the loads or gaps in turn, each passed on with its place among those given; a value
    /// that is missing has its reason.
    pub fn each(
        &self,
        elements: &BoundaryElements,
        progress: impl FnMut(&Progress) -> ControlFlow<()>,
        mut deliver: impl FnMut(usize, Result<Pressed, BemError>),
    ) {
        let (quantities, scene) = (self.quantities(), &self.file.scene);
        let leaking = self.leaking();
        let pressed = |solution: Solution| {
            let numbers = COLUMNS.iter().map(|(_, number)| number(&solution, scene.nominal_area));
            let summary = elements.summary(&solution, &quantities);
            let values =
                quantities.iter().map(|quantity| match summary.evaluate(*quantity, scene) {
                    Ok(value) => value.map(|value| value.value()).into(),
                    Err(reason) => Cell::Blank(Some(reason.into())),
                });
            let leaked = leaking.as_ref().map(|seal| seal.leak(elements, &solution));
            let (leaks, findings) = leaked.unwrap_or_default();
            let cells = numbers.chain(values).chain(leaks).collect();
            let notes = solution.notes.iter().cloned().chain(summary.finding()).chain(findings);
            Pressed { cells, notes: notes.collect(), solution }
        };
        elements.solve_each(self.given, progress, |index, solution| {
            deliver(index, solution.map(pressed));
        });
    }

    /// Fills a sheet with a row for each load or gap, and returns the solutions, if they are kept.
    /// Where the work is stopped, the rows are those solved by then.
    ///
    /// # Errors
    /// Quantities that boundary elements or the scene lack, a grid that cannot be halved, and
    /// where no load is solved.
    pub fn solve(
        &self,
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Result<Vec<Solution>, AnswerError> {
        sheet.heads = self.heads();
        // Refuses what boundary elements or the scene lack before anything is solved.
        Leaking::of(self.file, self.quantities)?;
        self.bem.compile(&self.file.scene, &Request::new(self.quantities()))?;
        // Before the hours of the whole grid.
        let half = self.refine.then(|| half_grid(self.bem)).transpose()?;
        let (whole, kept, mut found) = self.rows(self.bem, sheet, watch)?;
        let half = half.filter(|_| !watch.is_stopped());
        let half = half.map(|half| self.rows(&half, sheet, watch)).transpose()?;
        let half = half.map(|(rows, _, of_half)| {
            // What the whole grid is too coarse for, half of it is, too.
            let known: Vec<Code> = found.iter().map(|one| one.code).collect();
            let new: Vec<Finding> =
                of_half.into_iter().filter(|one| !known.contains(&one.code)).collect();
            found.extend(new);
            rows
        });
        sheet.extend(self.file.accepted(found));
        let width = sheet.heads.len();
        if half.is_some() {
            let of_half = |name: &String| format!("{name}_half_grid");
            let names: Vec<String> = of_grid(&sheet.heads).map(of_half).collect();
            sheet.heads.extend(names);
        }
        sheet.heads.push("boundary".into());
        let solved = whole.iter().any(Option::is_some);
        for (k, row) in whole.into_iter().enumerate() {
            // Loads without a result are blank; those that were not reached are left out.
            if row.is_none() && (watch.is_stopped() || !solved) {
                continue;
            }
            let mut cells = row.unwrap_or_default();
            cells.resize(width, Cell::BLANK);
            if let Some(half) = &half {
                cells.extend(half[k].iter().flat_map(|cells| of_grid(cells)).cloned());
            }
            cells.resize(sheet.heads.len() - 1, Cell::BLANK);
            cells.push(self.bem.continuation().name().into());
            sheet.rows.push(cells);
        }
        if sheet.rows.is_empty() && !watch.is_stopped() {
            return Err("no load was solved".into());
        }
        Ok(kept)
    }

    /// The loads or gaps on a grid.
    fn rows(
        &self,
        bem: &Bem,
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Result<Solved, ContactError> {
        let [rows, columns] = bem.map().shape();
        let elements = bem.elements(&self.file.scene.interface)?;
        let mut answers: Vec<Option<Vec<Cell>>> = vec![None; self.given.len()];
        let mut kept: Vec<Option<Solution>> = vec![None; self.given.len()];
        let (mut found, mut errors, mut lacks) = (Vec::<Finding>::new(), vec![], vec![]);
        let progress = |progress: &Progress| {
            watch.step(&format!(
                "bem: {} of {} on {rows} x {columns} pixels, iteration {}, residual {:.0e}",
                progress.done + 1,
                self.given.len(),
                progress.iterations,
                progress.residual
            ))
        };
        let hardness = elements.limit();
        let (mut least, mut below) = (0, 0);
        self.each(&elements, progress, |index, pressed| match pressed {
            Ok(Pressed { cells, notes, solution }) => {
                let carries =
                    |hardness| solution.area <= ROUNDED * solution.mean_pressure / hardness;
                least += usize::from(hardness.is_some_and(carries));
                below += usize::from(solution.mean_gap < 0.0 && solution.plastic_area > 0.0);
                found.extend(notes);
                lacks.extend(self.quantities().iter().zip(&cells[COLUMNS.len()..]).filter_map(
                    |(quantity, cell)| Some(format!("no {quantity}: {}", cell.reason()?)),
                ));
                answers[index] = Some(cells);
                kept[index] = self.keep.then_some(solution);
            }
            Err(BemError::Cancelled) => {}
            Err(error) => errors.push(error.to_string()),
        });
        let of_all = |count: usize| format!("{count} of {} rows", self.given.len());
        if least > 0 {
            sheet.result(format!("area_fraction is pressure over hardness in {}, the least that carries the load: the pixels in contact (area_fraction_pixels), corrected for their edges, cover less; refine the grid", of_all(least)));
        }
        if below > 0 {
            sheet.result(format!("mean_gap is below 0 in {} by the imprint of pixels at the hardness; mean_open_gap is the mean gap of the pixels out of contact", of_all(below)));
        }
        let solved: Vec<&Vec<Cell>> = answers.iter().flatten().collect();
        let texts = self.leaking().into_iter().flat_map(|seal| seal.results(&solved));
        texts.for_each(|text| sheet.result(text));
        errors.append(&mut lacks);
        once(&errors).iter().for_each(|text| sheet.warn(Code::NoValue, text));
        let grid = format!("{rows} x {columns} pixels");
        let kept = kept.into_iter().flatten().collect();
        Ok((answers, kept, found.into_iter().map(|one| one.from_origin(grid.clone())).collect()))
    }
}

/// The cells of a row that depend on the grid: without the load and the pressure, which are given,
/// and the last two of [`COLUMNS`], which are about the solver.
fn of_grid<T>(row: &[T]) -> impl Iterator<Item = &T> {
    row[2..COLUMNS.len() - 2].iter().chain(&row[COLUMNS.len()..])
}

/// Every second pixel, to tell how much depends on the grid.
///
/// # Errors
/// A grid that cannot be halved, with the remedy.
fn half_grid(bem: &Bem) -> Result<Bem, AnswerError> {
    let how = match bem.continuation() {
        Continuation::Periodic => "resample the period to such a grid (a crop is not periodic)",
        _ => "crop the scan",
    };
    let refused = |error| {
        format!("to refine, rows and columns must be even; {how}, or do not refine: {error}").into()
    };
    bem.half_grid().map_err(refused)
}
