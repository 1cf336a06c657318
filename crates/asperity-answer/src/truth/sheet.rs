//! Models beside boundary elements on the scan of a scene, as a sheet.

use std::mem::discriminant;

use asperity::bem::{Bem, BemError};
use asperity::{ContactError, Described, Finding, Findings, Model};
use asperity_inputs::SceneFile;

use super::{ContactState, Truth, beside_table, compare_with_bem, summary};
use crate::bem::half_grid;
use crate::models::{self, by_reason, grouped};
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
    let of_scan = Model::new(bem.clone());
    let other = file.other_joint(models.iter().chain([&of_scan]));
    sheet.extend(file.accepted(other.into_iter().collect()));
    let solved = Truths::solve(file, bem, &models, pressures, refine, watch)?;
    let errors = solved.failed.iter().map(|(_, error)| error);
    let errors = errors.filter(|error| !matches!(error, BemError::Cancelled));
    errors.for_each(|error| sheet.warn("unsolved", error.to_string()));
    let found = &solved.found;
    if found.is_empty() {
        return match watch.is_stopped() {
            true => Ok(()),
            false => Err(format!("{name}: no load was solved").into()),
        };
    }
    sheet.report(file, solved.findings());
    // What a model never has is no fault of the scene.
    let never = |(_, why): &(&str, &ContactError)| matches!(why, ContactError::Unsupported { .. });
    let (unsupported, missing): (Vec<_>, Vec<_>) = solved.missing().into_iter().partition(never);
    by_reason(missing).into_iter().for_each(|text| sheet.warn("no-value", text));
    by_reason(unsupported).into_iter().for_each(|text| sheet.note("no-value", text));
    sheet.note("nearest", summary(found, &solved.half));
    for line in beside_table(file, found) {
        sheet.note("evidence", line);
    }
    for mut row in solved.rows(file.scene.nominal_area) {
        row.push(bem.continuation().name().into());
        sheet.rows.push(row);
    }
    let mut states = found.iter().flat_map(|truth| &truth.models).map(|(_, state)| *state);
    if !models.is_empty() && states.all(|state| state == ContactState::default()) {
        let text = format!("{name}: no model has a result");
        sheet.findings.push(Finding::refusal("no-result", "", f64::NAN).fact(text));
    }
    Ok(())
}

/// A scan at several pressures, compared with models.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Truths {
    /// The solved pressures, in their order.
    pub found: Vec<Truth>,
    /// The same on half the grid, where that is asked for and solved.
    pub half: Vec<Option<Truth>>,
    /// The places of the other pressures, with the reasons.
    pub failed: Vec<(usize, BemError)>,
}

impl Truths {
    /// Solves the scan at mean pressures \[Pa\], and half the grid to `refine`; `watch` may stop
    /// the work.
    ///
    /// # Errors
    /// Those of [`compare_with_bem`], and a grid that cannot be halved.
    pub fn solve(
        file: &SceneFile,
        bem: &Bem,
        models: &[Model],
        pressures: &[f64],
        refine: bool,
        watch: &dyn Watch,
    ) -> Result<Self, AnswerError> {
        let solve = |bem: &Bem, models: &[Model]| {
            compare_with_bem(&file.scene, bem, pressures, models, |progress| {
                let all = 3 * pressures.len();
                watch.step(&format!("boundary elements: contact {} of {all}", progress.done + 1))
            })
        };
        let half = refine.then(|| half_grid(bem)).transpose()?;
        let found = solve(bem, models)?;
        let half = match half.filter(|_| !watch.is_stopped()) {
            Some(half) => solve(&half, &[])?.into_iter().map(Result::ok).collect(),
            None => vec![None; found.len()],
        };
        let mut all = Self::default();
        for (place, (found, half)) in found.into_iter().zip(half).enumerate() {
            match found {
                Ok(found) => {
                    all.found.push(found);
                    all.half.push(half);
                }
                Err(error) => all.failed.push((place, error)),
            }
        }
        Ok(all)
    }

    /// Limits of the solutions, and of models whose contacts merge or have more than the nominal
    /// area.
    #[must_use]
    pub fn findings(&self) -> Findings {
        let of_truth = |truth: &Truth| {
            let refused = truth.refused.iter().map(|(_, why)| why.clone());
            let merging = truth.merging.iter().cloned();
            truth.notes.iter().cloned().chain(refused).chain(merging).collect::<Vec<_>>()
        };
        self.found.iter().flat_map(of_truth).collect::<Findings>().by_cause()
    }

    /// What models lack, by their ids: one reason per model and kind, as others differ only in the
    /// load.
    #[must_use]
    pub fn missing(&self) -> Vec<(&str, &ContactError)> {
        let missing = self.found.iter().flat_map(|truth| &truth.missing);
        let kinds = grouped(missing.map(|(model, why)| ((model.id(), discriminant(why)), why)));
        kinds.into_iter().map(|((id, _), whys)| (id, whys[0])).collect()
    }

    /// The [rows](Truth::rows) of all pressures on a nominal area \[m^2\].
    #[must_use]
    pub fn rows(&self, area: f64) -> Vec<Vec<Cell>> {
        let both = self.found.iter().zip(&self.half);
        both.flat_map(|(truth, half)| truth.rows(half.as_ref(), area)).collect()
    }
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
