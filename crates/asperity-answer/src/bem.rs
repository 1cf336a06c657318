//! Boundary elements on the scan of a scene.

use asperity::bem::{Bem, BemError, Continuation, Direction, Leak, LoadCase, Progress, Solution};
use asperity::{ContactError, ContactModel, Finding, Findings, Quantity, Request};
use asperity_inputs::SceneFile;

use crate::models::once;
use crate::{AnswerError, Cell, Sheet, Watch};

/// A number of a solution.
type Number = fn(&Solution) -> f64;
/// Columns of every solution behind its load and pressure.
const COLUMNS: [(&str, Number); 7] = [
    ("area_fraction", |found| found.area),
    ("area_fraction_pixels", |found| found.pixel_area),
    ("plastic_fraction", |found| found.plastic_area),
    ("mean_gap_m", |found| found.mean_gap),
    ("patches", |found| found.patches.len() as f64),
    ("iterations", |found| found.iterations as f64),
    ("residual", |found| found.residual),
];

/// What is solved on the scan of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Press<'a> {
    /// The scene.
    pub file: &'a SceneFile,
    /// The name of the scene in messages.
    pub name: &'a str,
    /// The model of its scan.
    pub bem: &'a Bem,
    /// Loads or gaps.
    pub given: &'a [LoadCase],
    /// Quantities besides those of every solution.
    pub quantities: &'a [Quantity],
    /// The fluid whose flow in both directions is asked for.
    pub leak: Option<Leak>,
    /// Whether the same is solved on half the grid.
    pub refine: bool,
    /// Whether the solutions are kept.
    pub keep: bool,
}

/// The hydraulic gap in each direction, and the column of the flow through it.
pub const FLOWS: [(Quantity, Direction, &str); 2] = [
    (Quantity::HydraulicGapX, Direction::X, "flow_x_m3_per_s"),
    (Quantity::HydraulicGapY, Direction::Y, "flow_y_m3_per_s"),
];

/// The cells of each solution, `None` without one, the solutions that are kept, and the findings.
type Solved = (Vec<Option<Vec<Cell>>>, Vec<Solution>, Findings);

impl Press<'_> {
    /// Fills a sheet with a row for each load or gap, and returns the solutions, if they are kept.
    /// Where the work is stopped, the rows are those solved by
    /// then.
    ///
    /// # Errors
    /// Quantities that boundary elements or the scene lack, a grid that cannot be halved, and
    /// where no load is solved.
    pub fn solve(
        &self,
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Result<Vec<Solution>, AnswerError> {
        sheet.under(&[&["load_N", "pressure_Pa"], &COLUMNS.map(|(head, _)| head)]);
        sheet.findings.extend(self.leak.and_then(|leak| leak.finding()));
        let flows = self.leak.map_or(&[][..], |_| &FLOWS);
        let mut quantities = self.quantities.to_vec();
        quantities.extend(flows.iter().map(|(gap, ..)| *gap));
        let mut quantities = once(&quantities);
        quantities.retain(|quantity| sheet.column(&quantity.column()).is_none());
        // Refuses what boundary elements or the scene lack before anything is solved.
        let request = Request::new(quantities.iter().copied());
        self.bem.compile(&self.file.scene, &request)?;
        // Before the hours of the whole grid.
        let half = self.refine.then(|| half_grid(self.bem)).transpose()?;
        let (whole, kept, mut found) = self.rows(self.bem, &quantities, sheet, watch)?;
        let half = half.filter(|_| !watch.is_stopped());
        let half = half.map(|half| self.rows(&half, &quantities, sheet, watch)).transpose()?;
        let half = half.map(|(rows, _, of_half)| {
            // What the whole grid is too coarse for, half of it is, too.
            let known: Vec<&str> = found.iter().map(|one| one.code).collect();
            let new: Vec<Finding> =
                of_half.into_iter().filter(|one| !known.contains(&one.code)).collect();
            found.extend(new);
            rows
        });
        sheet.extend(self.file.accepted(found));
        sheet.heads.extend(quantities.iter().map(|quantity| quantity.column()));
        sheet.heads.extend(flows.iter().map(|(.., head)| (*head).to_string()));
        let width = sheet.heads.len();
        if half.is_some() {
            let of_half = |name: &String| format!("{name}_half_grid");
            let names: Vec<String> = sheet.heads[2..].iter().map(of_half).collect();
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
                cells.extend(half[k].iter().flat_map(|cells| cells[2..].to_vec()));
            }
            cells.resize(sheet.heads.len() - 1, Cell::BLANK);
            cells.push(self.bem.continuation().name().into());
            sheet.rows.push(cells);
        }
        if sheet.rows.is_empty() && !watch.is_stopped() {
            return Err(format!("{}: no load was solved", self.name).into());
        }
        Ok(kept)
    }

    /// The loads or gaps on a grid.
    fn rows(
        &self,
        bem: &Bem,
        quantities: &[Quantity],
        sheet: &mut Sheet,
        watch: &dyn Watch,
    ) -> Result<Solved, ContactError> {
        let ([rows, columns], scene) = (bem.map().shape(), &self.file.scene);
        let elements = bem.elements(&scene.interface)?;
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
        elements.solve_each(self.given, progress, |index, solution| match solution {
            Ok(solution) => {
                found.extend(solution.notes.iter().cloned());
                let mut cells = cells(&solution, scene.nominal_area);
                let summary = elements.summary(&solution, quantities);
                found.extend(summary.sealed());
                for quantity in quantities {
                    let value = summary.evaluate(*quantity, scene).unwrap_or_else(|error| {
                        lacks.push(format!("no {quantity}: {error}"));
                        None
                    });
                    cells.push(value.map(|value| value.value()).into());
                }
                let flow = |leak: Leak, (gap, direction, _)| {
                    let (_, gap) = summary.gaps.iter().find(|(known, _)| *known == gap)?;
                    Some(leak.flow(*gap.as_ref().ok()?, bem.map(), direction))
                };
                let flows = self.leak.map(|leak| FLOWS.map(|one| Cell::from(flow(leak, one))));
                cells.extend(flows.into_iter().flatten());
                answers[index] = Some(cells);
                kept[index] = self.keep.then_some(solution);
            }
            Err(BemError::Cancelled) => {}
            Err(error) => errors.push(error.to_string()),
        });
        errors.append(&mut lacks);
        once(&errors).iter().for_each(|text| sheet.warn("unsolved", text));
        let grid = format!("{rows} x {columns} pixels");
        let kept = kept.into_iter().flatten().collect();
        Ok((answers, kept, found.into_iter().map(|one| one.from_origin(grid.clone())).collect()))
    }
}

/// The cells of load and pressure, exactly as given, and under [`COLUMNS`].
fn cells(solution: &Solution, nominal_area: f64) -> Vec<Cell> {
    let pressure = match solution.given {
        LoadCase::MeanPressure(pressure) => pressure,
        _ => solution.mean_pressure,
    };
    let others = COLUMNS.map(|(_, number)| number(solution));
    [pressure * nominal_area, pressure].into_iter().chain(others).map(Cell::from).collect()
}

/// Every second pixel, to tell how much depends on the grid.
///
/// # Errors
/// A grid that cannot be halved, with the remedy.
pub fn half_grid(bem: &Bem) -> Result<Bem, AnswerError> {
    let how = match bem.continuation() {
        Continuation::Periodic => "resample the period to such a grid (a crop is not periodic)",
        _ => "crop the scan",
    };
    let refused = |error| {
        format!("to refine, rows and columns must be even; {how}, or do not refine: {error}").into()
    };
    bem.half_grid().map_err(refused)
}
