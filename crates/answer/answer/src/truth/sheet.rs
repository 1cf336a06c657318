//! Models beside boundary elements on the scan of a scene, as a sheet.

use std::mem::discriminant;

use asperity::bem::{Bem, BemError};
use asperity::{Code, Compared, ContactError, Described, Finding, Findings, Model, Quantity};
use asperity_scene::SceneFile;

use super::{ContactState, Truth, beside_table, compare_with_bem};
use crate::bem::half_grid;
use crate::models::{self, by_reason, grouped, once};
use crate::{AnswerError, Cell, Sheet, Watch};

/// The heads of the compared quantities and of their deviations, between the model and the
/// boundary.
const COLUMNS: [(Compared, [&str; 2]); 4] = [
    (Compared::Area, ["area_fraction", "area_deviation"]),
    (Compared::MeanGap, ["mean_gap_m", "mean_gap_deviation_over_sq"]),
    (Compared::Stiffness, ["stiffness_N_per_m", "stiffness_deviation"]),
    (
        Compared::UnloadingStiffness,
        ["unloading_stiffness_N_per_m", "unloading_stiffness_deviation"],
    ),
];

/// What is compared: area and mean gap, which are part of every solution, and the stiffnesses
/// behind the quantities named, by default that of first loading. A conductance deviates as the
/// unloading stiffness does.
///
/// # Errors
/// A quantity that is not compared.
pub fn compared(named: &[Quantity]) -> Result<Vec<Compared>, AnswerError> {
    let behind = |quantity: &Quantity| match quantity {
        Quantity::Stiffness => Ok(Compared::Stiffness),
        other => Compared::behind(*other).ok_or_else(|| {
            format!("{other} is not compared: choose tangent, unloading-stiffness or a conductance")
        }),
    };
    let named = if named.is_empty() { &[Quantity::Tangent] } else { named };
    let named: Vec<Compared> = named.iter().map(behind).collect::<Result<_, _>>()?;
    Ok(once(&[vec![Compared::Area, Compared::MeanGap], named].concat()))
}

/// Boundary elements beside the models named, or beside all, as by [`truth_of`].
///
/// # Errors
/// The errors of the models named and of [`truth_of`].
pub fn truth(
    of: (&SceneFile, &str, &Bem),
    models: &[String],
    pressures: &[f64],
    quantities: &[Compared],
    refine: bool,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Result<(), AnswerError> {
    let models = models::models(of.0, models, SceneFile::models_beside_bem, &[], sheet)?;
    truth_of(of, &models, pressures, quantities, refine, sheet, watch)
}

/// The compared quantities of boundary elements and of models at mean pressures \[Pa\], with the
/// deviations of the models; `refine` adds half the grid. Where the work is stopped, the rows are
/// those solved by then. `name` is that of the scene in messages.
///
/// # Errors
/// The errors of the scene, a grid that cannot be halved, and where no load is solved.
pub fn truth_of(
    (file, name, bem): (&SceneFile, &str, &Bem),
    models: &[Model],
    pressures: &[f64],
    quantities: &[Compared],
    refine: bool,
    sheet: &mut Sheet,
    watch: &dyn Watch,
) -> Result<(), AnswerError> {
    sheet.under(&[&heads(quantities), &["boundary"]]);
    let of_scan = Model::new(bem.clone());
    let other = file.other_joint(models.iter().chain([&of_scan]));
    sheet.extend(file.accepted(other.into_iter().collect()));
    let solved = Truths::solve(file, bem, models, pressures, quantities, refine, watch)?;
    let errors = solved.failed.iter().map(|(_, error)| error);
    let errors = errors.filter(|error| !matches!(error, BemError::Cancelled));
    errors.for_each(|error| sheet.warn(Code::NoValue, error.to_string()));
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
    by_reason(missing).into_iter().for_each(|text| sheet.warn(Code::NoValue, text));
    by_reason(unsupported).into_iter().for_each(|text| sheet.note(Code::NoValue, text));
    beside_table(file, found).into_iter().for_each(|line| sheet.result(line));
    for mut row in solved.rows(file.scene.nominal_area, quantities) {
        row.push(bem.continuation().name().into());
        sheet.rows.push(row);
    }
    let mut states = found.iter().flat_map(|truth| &truth.models).map(|(_, state)| state);
    if !models.is_empty() && states.all(ContactState::is_empty) {
        let text = format!("{name}: no model has a result");
        sheet.findings.push(Finding::refusal(Code::NoValue, "", f64::NAN).fact(text));
    }
    Ok(())
}

/// A scan at several pressures, compared with models.
#[derive(Debug, Clone, Default)]
#[non_exhaustive]
pub struct Truths {
    /// The solved pressures, in their order.
    pub found: Vec<Truth>,
    /// The places of the other pressures, with the reasons.
    pub failed: Vec<(usize, BemError)>,
}

impl Truths {
    /// Solves the scan at mean pressures \[Pa\], and half the grid to `refine`; `watch` may stop
    /// the work.
    ///
    /// # Errors
    /// The errors of [`compare_with_bem`], and a grid that cannot be halved.
    pub fn solve(
        file: &SceneFile,
        bem: &Bem,
        models: &[Model],
        pressures: &[f64],
        quantities: &[Compared],
        refine: bool,
        watch: &dyn Watch,
    ) -> Result<Self, AnswerError> {
        let solve = |bem: &Bem, models: &[Model]| {
            compare_with_bem(&file.scene, bem, pressures, models, quantities, |progress| {
                let (number, all) = (progress.done + 1, pressures.len());
                watch.step(&format!("boundary elements: contact {number} of {all}"))
            })
        };
        let half = refine.then(|| half_grid(bem)).transpose()?;
        let found = solve(bem, models)?;
        let half = half.filter(|_| !watch.is_stopped());
        let half = half.map_or(Ok(vec![]), |half| solve(&half, &[]))?;
        let mut half = half.into_iter().map(|half| half.ok().map(|truth| truth.bem));
        let mut all = Self::default();
        for (place, found) in found.into_iter().enumerate() {
            let half = half.next().flatten();
            match found {
                Ok(found) => all.found.push(Truth { half, ..found }),
                Err(error) => all.failed.push((place, error)),
            }
        }
        Ok(all)
    }

    /// Limits of the solutions, and of models whose contacts merge or have more than the nominal
    /// area.
    #[must_use]
    pub fn findings(&self) -> Findings {
        let all = self.found.iter().flat_map(|truth| truth.notes.iter().chain(&truth.crowded));
        all.cloned().collect::<Findings>().by_cause()
    }

    /// What models lack, by their ids: one reason per model and kind, as others differ only in the
    /// load.
    #[must_use]
    pub fn missing(&self) -> Vec<(&str, &ContactError)> {
        let missing = self.found.iter().flat_map(|truth| &truth.missing);
        let kinds = grouped(missing.map(|(id, why)| ((&**id, discriminant(why)), why)));
        kinds.into_iter().map(|((id, _), whys)| (id, whys[0])).collect()
    }

    /// Rows on a nominal area \[m^2\], under [`heads`]: of each pressure one by boundary elements,
    /// one on half the grid, if solved, and one by each model.
    #[must_use]
    pub fn rows(&self, area: f64, quantities: &[Compared]) -> Vec<Vec<Cell>> {
        let of_place = |truth: &Truth| {
            let models = truth.models.iter().map(|(model, state)| (model.id(), state));
            let half = truth.half.iter().map(|half| ("bem-half-grid", half));
            let all = [("bem", &truth.bem)].into_iter().chain(half).chain(models);
            let row = |(id, state): (&str, &ContactState)| {
                let off = truth.deviation(state);
                let pair = |of| [state, &off].map(|found| Cell::from(found.get(of).copied()));
                let place = [(truth.pressure * area).into(), truth.pressure.into(), id.into()];
                place.into_iter().chain(quantities.iter().flat_map(pair)).collect()
            };
            all.map(row).collect::<Vec<_>>()
        };
        self.found.iter().flat_map(of_place).collect()
    }
}

/// Load, pressure, model, and each quantity with its deviation.
#[must_use]
pub fn heads(quantities: &[Compared]) -> Vec<&'static str> {
    let column = |of: &Compared| COLUMNS.iter().find(|(quantity, _)| quantity == of);
    let numbers = quantities.iter().filter_map(column).flat_map(|(_, heads)| heads);
    ["load_N", "pressure_Pa", "model"].iter().chain(numbers).copied().collect()
}
