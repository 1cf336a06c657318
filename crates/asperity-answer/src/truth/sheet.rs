//! Models beside boundary elements on the scan of a scene, as a sheet.

use std::mem::discriminant;

use asperity::bem::{Bem, BemError};
use asperity::{ContactError, Described, Finding, Model};
use asperity_inputs::SceneFile;

use super::{ContactState, Truth, beside_table, compare_with_bem, summary};
use crate::bem::half_grid;
use crate::models::{self, by_reason, grouped, once};
use crate::{AnswerError, Cell, Sheet, Watch};

/// A number of a contact, or its deviation.
type Number = fn(&ContactState) -> Option<f64>;
/// The columns between the model and the boundary.
const COLUMNS: [(&str, &str, Number); 3] = [
    ("area_fraction", "area_deviation", |state| state.area_fraction),
    ("mean_gap_m", "mean_gap_deviation_over_sq", |state| state.mean_gap),
    ("stiffness_N_per_m", "stiffness_deviation", |state| state.stiffness),
];

/// Area, gap and stiffness of boundary elements and of the models named, or of all, at mean
/// pressures \[Pa\], with the deviations of the models; `refine` adds half the grid. Where the work
/// is stopped, the rows are those solved by then. `name` is that of the scene in messages.
///
/// # Errors
/// Those of the scene, a grid that cannot be halved, and where no load is solved.
pub fn truth(
    (file, name, bem): (&SceneFile, &str, &Bem),
    models: &[String],
    pressures: &[f64],
    refine: bool,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Result<(), AnswerError> {
    let numbers: Vec<&str> = COLUMNS.iter().flat_map(|(of, off, _)| [*of, *off]).collect();
    sheet.under(&[&["load_N", "pressure_Pa", "model"], &numbers, &["boundary"]]);
    let models = models::models(file, models, SceneFile::models_beside_bem, &[], sheet)?;
    let models: Vec<Model> = models.into_iter().map(|(_, model)| model).collect();
    let solve = |bem: &Bem, models: &[Model]| {
        compare_with_bem(&file.scene, bem, pressures, models, |progress| {
            let all = 3 * pressures.len();
            watch.step(&format!("boundary elements: contact {} of {all}", progress.done + 1))
        })
    };
    let half = refine.then(|| half_grid(bem)).transpose()?;
    let found = solve(bem, &models)?;
    let half = match half.filter(|_| !watch.is_stopped()) {
        Some(half) => solve(&half, &[])?.into_iter().map(Result::ok).collect(),
        None => vec![None; found.len()],
    };
    let errors = found.iter().filter_map(|one| one.as_ref().err());
    let errors = errors.filter(|error| !matches!(error, BemError::Cancelled));
    for error in once(&errors.map(ToString::to_string).collect::<Vec<_>>()) {
        sheet.warn("unsolved", error);
    }
    let solved = found.into_iter().zip(half).filter_map(|(one, half)| Some((one.ok()?, half)));
    let (found, half): (Vec<Truth>, Vec<Option<Truth>>) = solved.unzip();
    if found.is_empty() {
        return match watch.is_stopped() {
            true => Ok(()),
            false => Err(format!("{name}: no load was solved").into()),
        };
    }
    let of_truth = |truth: &Truth| {
        let refused = truth.refused.iter().map(|(_, why)| why.clone());
        truth.notes.iter().cloned().chain(refused).collect::<Vec<_>>()
    };
    sheet.report(file, found.iter().flat_map(of_truth).collect());
    for text in by_reason(missing(&found)) {
        sheet.warn("no-value", text);
    }
    sheet.note("nearest", summary(&found));
    for line in beside_table(file, &found) {
        sheet.note("evidence", line);
    }
    for (truth, half) in found.iter().zip(&half) {
        for mut row in truth.rows(half.as_ref(), file.scene.nominal_area) {
            row.push(bem.continuation().name().into());
            sheet.rows.push(row);
        }
    }
    let mut states = found.iter().flat_map(|truth| &truth.models).map(|(_, state)| *state);
    if !models.is_empty() && states.all(|state| state == ContactState::default()) {
        let text = format!("{name}: no model has a result");
        sheet.findings.push(Finding::refusal("no-result", "", f64::NAN).fact(text));
    }
    Ok(())
}

/// One reason per model and kind: others differ only in the load.
fn missing(found: &[Truth]) -> Vec<(&str, &ContactError)> {
    let missing = found.iter().flat_map(|truth| &truth.missing);
    let kinds = grouped(missing.map(|(model, why)| ((model.id(), discriminant(why)), why)));
    kinds.into_iter().map(|((id, _), whys)| (id, whys[0])).collect()
}

impl Truth {
    /// Its rows on a nominal area \[m^2\], by boundary elements, on `half` the grid and by each
    /// model: load, pressure, model, and area, gap and stiffness, each with its deviation.
    #[must_use]
    pub fn rows(&self, half: Option<&Self>, area: f64) -> Vec<Vec<Cell>> {
        let models = self.models.iter().map(|(model, state)| (model.id(), state));
        let half = half.map(|half| ("bem-half-grid", &half.bem));
        let row = |(id, state): (&str, &ContactState)| {
            let off = self.deviation(state);
            let numbers = COLUMNS.iter().flat_map(|(.., of)| [of(state), of(&off)]);
            let place = [(self.pressure * area).into(), self.pressure.into(), id.into()];
            place.into_iter().chain(numbers.map(Cell::from)).collect()
        };
        [("bem", &self.bem)].into_iter().chain(half).chain(models).map(row).collect()
    }
}
