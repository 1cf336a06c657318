//! Plans of requests, and recommendations of models.

use std::collections::BTreeMap;

use asperity::{Comparison, ContactModel, EvidenceAt, Request, Scene};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

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
    let plan = asked.engine().run(py, || asked.model.compile(scene, &request)?.plan(&request))?;
    Ok((plan.to_string(), object(py, &plan)?))
}

/// What is known of a model: its id, the deviation of each quantity, why some or all have no value,
/// and the deviation from boundary elements.
type Compared<'py> = (String, Vec<(String, f64)>, Option<String>, Option<Bound<'py, PyAny>>);
/// The simplest model, all models, the evidence in sentences and place by place, and the text.
type Advice<'py> = (Option<String>, Vec<Compared<'py>>, String, Vec<Bound<'py, PyAny>>, String);

/// Deviations from the reference of the models of a scene, or of the named models.
#[pyfunction]
pub(crate) fn recommend<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    within: f64,
    models: Option<Vec<String>>,
) -> PyResult<Advice<'py>> {
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
    let advice =
        asked.engine().run(py, || file.recommend_among(among, &request, &asked.model, within))?;
    let compared = |found: &Comparison| -> PyResult<Compared<'py>> {
        let (all, lacking) = (&found.deviations, found.lacking.first().map(|(_, reason)| reason));
        let known = all.iter().flatten().map(|(quantity, off)| (quantity.to_string(), *off));
        let reason = all.as_ref().err().or(lacking).map(ToString::to_string);
        let off = found.off.as_ref().map(|off| object(py, off)).transpose()?;
        Ok((found.model.id().into(), known.collect(), reason, off))
    };
    let left_out = left_out.into_iter();
    let left_out = left_out.map(|one| Ok((one.id, vec![], Some(one.reason.to_string()), None)));
    let models = advice.comparisons.iter().map(compared).chain(left_out);
    let place = |place: &EvidenceAt| match &place.expected {
        Err(reason) => reason.to_string().into_bound_py_any(py),
        Ok(_) => {
            let ids = advice.comparisons.iter().map(|found| found.model.id());
            let off = ids.filter_map(|id| Some((id.to_string(), place.deviation(id)?)));
            object(py, &off.collect::<BTreeMap<_, _>>())
        }
    };
    let places = advice.evidence.iter().map(place).collect::<PyResult<_>>()?;
    let evidence = [advice.summary(), advice.expectations()].concat().join("\n");
    let simplest = advice.simplest.as_ref().map(|model| model.id().into());
    let text = advice.to_string().trim_end_matches('\n').into();
    Ok((simplest, models.collect::<PyResult<_>>()?, evidence, places, text))
}
