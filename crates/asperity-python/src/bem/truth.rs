//! Models of a scene compared with boundary elements on its scan.

use std::collections::BTreeMap;

use asperity::bem::{Bem, BemError};
use asperity::{Described, Findings, Model};
use asperity_answer::{Truth, Watch, beside_table, compare_with_bem, summary};
use pyo3::prelude::*;

use super::scan::Pressed;
use crate::ask::long::run_interruptible;
use crate::convert::{object, refused, value_error, warn};
use crate::scene::SceneFile;

/// Sentences about the nearest models, and beside solved surfaces.
type Sentences = (Option<String>, Vec<String>);
/// Rows, sentences, the reasons of missing models by id, the reasons of failed pressures by place,
/// and the boundary.
type Truths<'py> =
    (Bound<'py, PyAny>, Sentences, BTreeMap<String, String>, BTreeMap<usize, String>, &'static str);

/// Models of a scene compared with boundary elements on its scan.
#[pyfunction]
pub(crate) fn truth<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    pressures: Vec<f64>,
    elastic: bool,
    boundary: Option<&str>,
    models: Option<Vec<String>>,
    refine_and_mask: (bool, bool),
) -> PyResult<Truths<'py>> {
    let (refine, mask) = refine_and_mask;
    let scene = &*scene.0;
    let Pressed { bem, .. } = Pressed::of_scene(py, scene, boundary, elastic)?;
    let (models, left_out) = match models {
        None => scene.models_beside_bem(),
        Some(ids) => {
            let all = ids.iter().map(|id| scene.model(id));
            (all.collect::<Result<_, _>>().map_err(value_error)?, vec![])
        }
    };
    let mut failures = BTreeMap::new();
    let mut solved = |bem: &Bem, models: &[Model]| -> PyResult<Vec<Option<Truth>>> {
        let found = run_interruptible(py, |stop| {
            compare_with_bem(&scene.scene, bem, &pressures, models, |_| stop.step(""))
        })?;
        let found = found.map_err(refused)?.into_iter().enumerate();
        let kept = |(k, one): (usize, Result<Truth, BemError>)| match one {
            Err(error) if !mask => Err(value_error(error)),
            Err(error) => {
                failures.entry(k).or_insert(error.to_string());
                Ok(None)
            }
            Ok(one) => Ok(Some(one)),
        };
        found.map(kept).collect()
    };
    let found = solved(&bem, &models)?;
    let half = match refine {
        true => solved(&bem.half_grid().map_err(value_error)?, &[])?,
        false => vec![None; found.len()],
    };
    let (found, half): (Vec<Truth>, Vec<_>) =
        found.into_iter().zip(half).filter_map(|(found, half)| Some((found?, half))).unzip();
    let of_truth = |truth: &Truth| {
        let refused = truth.refused.iter().map(|(_, why)| why.clone());
        truth.notes.iter().cloned().chain(refused).collect::<Vec<_>>()
    };
    let notes: Findings = found.iter().flat_map(of_truth).collect();
    notes.by_cause().iter().try_for_each(|note| warn(py, note, 1))?;
    let mut refused: BTreeMap<String, String> =
        left_out.into_iter().map(|model| (model.id, model.reason.to_string())).collect();
    for (model, why) in found.iter().flat_map(|truth| &truth.missing) {
        if !refused.contains_key(model.id()) {
            warn(py, format!("{model}: {why}"), 1)?;
            refused.insert(model.id().into(), why.to_string());
        }
    }
    let area = scene.scene.nominal_area;
    let rows = found.iter().zip(&half).flat_map(|(one, half)| one.rows(half.as_ref(), area));
    let rows: Vec<_> = rows.collect();
    let nearest = (!models.is_empty() && !found.is_empty()).then(|| summary(&found));
    let sentences = (nearest, py.detach(|| beside_table(scene, &found)));
    Ok((object(py, &rows)?, sentences, refused, failures, bem.continuation().name()))
}
