//! Plans of requests, and recommendations of models.

use std::collections::BTreeMap;

use asperity::{Comparison, ContactModel, EvidenceAt, Quantity, Request, Scene};
use asperity_inputs::LeftOut;
use pyo3::prelude::*;

use crate::ask::rows::Rows;
use crate::convert::error::value_error;
use crate::convert::objects::object;
use crate::convert::quantities::Quantities;
use crate::model::engine::Engine;

/// The single scene of rows, and their request.
fn scene_and_request<'r>(
    rows: &'r Rows,
    quantities: &Quantities,
    rtol: f64,
) -> PyResult<(&'r Scene, Request)> {
    let request = quantities.request(rtol)?;
    match rows.one_scene() {
        Some(scene) => Ok((scene, request.at((0..rows.len()).map(|row| rows.at(row))))),
        None => Err(value_error("many scenes were given: one scene was required")),
    }
}

/// The plan of rows on one scene: its text and its steps.
#[pyfunction]
pub(crate) fn plan<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows,
    quantities: Quantities,
    rtol: f64,
) -> PyResult<(String, Bound<'py, PyAny>)> {
    let (model, (scene, request)) =
        (engine.on_all(&rows.files)?, scene_and_request(&rows, &quantities, rtol)?);
    let plan = py.detach(|| model.compile(scene, &request)?.plan(&request));
    let plan = plan.map_err(|error| engine.raise(py, error))?;
    Ok((plan.to_string(), object(py, &plan)?))
}

/// A model's id, its deviations from the reference by quantity or the reason for none, and its
/// deviations from boundary elements.
type Row<'py> = (String, Vec<(String, f64)>, Option<String>, Option<Bound<'py, PyAny>>);

/// The evidence at a place: deviations by model, or the reason for none.
type Place<'py> = (BTreeMap<String, Bound<'py, PyAny>>, Option<String>);
/// A text, the simplest model's id, the evidence as sentences and place by place, and a row for
/// every model.
type Advice<'py> = (String, Option<String>, String, Vec<Place<'py>>, Vec<Row<'py>>);

/// Deviations from the reference of the models of a scene, or of the named models.
#[pyfunction]
pub(crate) fn recommend<'py>(
    py: Python<'py>,
    reference: &Engine,
    rows: Rows,
    quantities: Quantities,
    within: f64,
    rtol: f64,
    models: Option<Vec<String>>,
) -> PyResult<Advice<'py>> {
    let (model, (_, request)) =
        (reference.on_all(&rows.files)?, scene_and_request(&rows, &quantities, rtol)?);
    let file = &rows.files[0];
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
    let advice = py.detach(|| file.recommend_among(among, &request, &model, within));
    let advice = advice.map_err(|error| reference.raise(py, error))?;
    let row = |comparison: &Comparison| {
        let id = comparison.model.id().to_string();
        let named = |(quantity, deviation): &(Quantity, f64)| (quantity.to_string(), *deviation);
        let off = comparison.off.map(|off| object(py, &off)).transpose()?;
        Ok(match &comparison.deviations {
            Ok(all) => {
                let lacking = comparison.lacking.first().map(|(_, reason)| reason.to_string());
                (id, all.iter().map(named).collect(), lacking, off)
            }
            Err(refusal) => (id, vec![], Some(refusal.to_string()), off),
        })
    };
    let mut rows = advice.comparisons.iter().map(row).collect::<PyResult<Vec<_>>>()?;
    let refused = |model: LeftOut| (model.id, vec![], Some(model.reason.to_string()), None);
    rows.extend(left_out.into_iter().map(refused));
    let ids = || advice.comparisons.iter().map(|comparison| comparison.model.id());
    let place = |place: &EvidenceAt| match &place.expected {
        Err(reason) => Ok((BTreeMap::new(), Some(reason.to_string()))),
        Ok(_) => {
            let off = ids().filter_map(|id| Some((id.to_string(), place.deviation(id)?)));
            let off = off.map(|(id, off)| Ok((id, object(py, &off)?)));
            Ok((off.collect::<PyResult<_>>()?, None))
        }
    };
    let places = advice.evidence.iter().map(place).collect::<PyResult<_>>()?;
    let simplest = advice.simplest.as_ref().map(|model| model.id().to_string());
    let evidence = [advice.summary(), advice.expectations()].concat().join("\n");
    Ok((advice.to_string(), simplest, evidence, places, rows))
}
