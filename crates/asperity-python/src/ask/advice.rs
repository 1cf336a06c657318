//! Plans of requests, and recommendations of models.

use std::collections::BTreeMap;

use asperity::{ContactModel, EvidenceAt, Request, Scene};
use asperity_inputs::LeftOut;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyTuple};

use crate::ask::asked::{Arguments, Asked};
use crate::convert::{object, value_error};

/// The single scene of rows, and the request at them.
fn scene_and_request(asked: &Asked) -> PyResult<(&Scene, Request)> {
    let Asked { rows, request, .. } = asked;
    match rows.one_scene() {
        Some(scene) => Ok((scene, request.clone().at((0..rows.len()).map(|row| rows.at(row))))),
        None => Err(value_error("many scenes were given: one scene was required")),
    }
}

/// The plan of rows on one scene: its text and its steps.
#[pyfunction]
pub(crate) fn plan<'py>(
    py: Python<'py>,
    asked: Arguments<'py>,
) -> PyResult<(String, Bound<'py, PyAny>)> {
    let asked = Asked::new(asked)?;
    let (scene, request) = scene_and_request(&asked)?;
    let plan = py.detach(|| asked.model.compile(scene, &request)?.plan(&request));
    let plan = plan.map_err(|error| asked.raise(py, error))?;
    Ok((plan.to_string(), object(py, &plan)?))
}

/// Deviations from the reference of the models of a scene, or of the named models: the fields of
/// the package's `Recommendation`.
#[pyfunction]
pub(crate) fn recommend<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    within: f64,
    models: Option<Vec<String>>,
) -> PyResult<Bound<'py, PyDict>> {
    let asked = Asked::new(asked)?;
    let ((_, request), file) = (scene_and_request(&asked)?, &asked.rows.files[0]);
    let (among, left_out) = match models {
        None => {
            let mut models = file.options.models();
            let ids: Vec<String> = models.iter().map(|model| model.id().into()).collect();
            // The evidence covers these models, too.
            let (mut others, mut left_out) = file.models_beside_bem();
            others.retain(|model| !ids.iter().any(|id| id == model.id()));
            left_out.retain(|model| !ids.contains(&model.id));
            models.extend(others);
            (models, left_out)
        }
        Some(ids) => {
            let models = ids.iter().map(|id| file.model(id).map_err(value_error));
            (models.collect::<PyResult<_>>()?, vec![])
        }
    };
    let advice = py.detach(|| file.recommend_among(among, &request, &asked.model, within));
    let advice = advice.map_err(|error| asked.raise(py, error))?;
    let [deviations, refused, off] = [(); 3].map(|()| PyDict::new(py));
    for found in &advice.comparisons {
        let (id, lacking) = (found.model.id(), found.lacking.first().map(|(_, reason)| reason));
        if let Some(all) = found.deviations.as_ref().ok().filter(|all| !all.is_empty()) {
            let all = all.iter().map(|(quantity, deviation)| (quantity.to_string(), *deviation));
            deviations.set_item(id, all.into_py_dict(py)?)?;
        }
        if let Some(reason) = found.deviations.as_ref().err().or(lacking) {
            refused.set_item(id, reason.to_string())?;
        }
        if let Some(deviation) = &found.off {
            off.set_item(id, object(py, deviation)?)?;
        }
    }
    for LeftOut { id, reason } in left_out {
        refused.set_item(id, reason.to_string())?;
    }
    let place = |place: &EvidenceAt| match &place.expected {
        Err(reason) => reason.to_string().into_bound_py_any(py),
        Ok(_) => {
            let ids = advice.comparisons.iter().map(|found| found.model.id());
            let off = ids.filter_map(|id| Some((id.to_string(), place.deviation(id)?)));
            object(py, &off.collect::<BTreeMap<_, _>>())
        }
    };
    let places = advice.evidence.iter().map(place).collect::<PyResult<Vec<_>>>()?;
    let found = PyDict::new(py);
    found.set_item("simplest", advice.simplest.as_ref().map(|model| model.id()))?;
    found.set_item("deviations", deviations)?;
    found.set_item("refused", refused)?;
    found.set_item("evidence", [advice.summary(), advice.expectations()].concat().join("\n"))?;
    found.set_item("evidence_at", PyTuple::new(py, places)?)?;
    found.set_item("off", off)?;
    found.set_item("text", advice.to_string().trim_end_matches('\n'))?;
    Ok(found)
}
