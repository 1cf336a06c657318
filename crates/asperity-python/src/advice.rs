//! Which model does a scene need?

use pyo3::prelude::*;

use asperity::ContactError;

use crate::engine::{Engine, asperity_separation, quantities, request, tolerance};
use crate::scene::Scene;

/// One model against the reference: deviations by quantity, or why there are none.
type Row = (String, Vec<(String, f64)>, Option<String>);

/// A text, the simplest model's id, and every model against the reference.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "called from one place, by the package itself")]
pub(crate) fn recommend(
    py: Python<'_>,
    scene: &Scene,
    reference: &Engine,
    names: Vec<String>,
    separations: Vec<f64>,
    in_metres: bool,
    within: f64,
    rtol: f64,
) -> PyResult<(String, String, Vec<Row>)> {
    let (model, file) = (reference.0.on(&scene.0)?, &scene.0);
    let request = request(&quantities(&names)?, tolerance(rtol)?)
        .at(separations.iter().map(|s| asperity_separation(file, *s, in_metres)));
    let advice = py.detach(|| asperity::recommend(&file.scene, &request, &model, within));
    let advice = advice.map_err(|error| reference.0.raise(py, "", &error))?;
    let row = |comparison: &asperity::Comparison| {
        let id = comparison.model.id().to_string();
        match &comparison.deviations {
            Ok(all) => (id, all.iter().map(|(q, d)| (q.to_string(), *d)).collect(), None),
            Err(refusal) => (id, vec![], Some(ContactError::to_string(refusal))),
        }
    };
    let rows = advice.comparisons.iter().map(row).collect();
    Ok((advice.to_string(), advice.simplest.id().into(), rows))
}
