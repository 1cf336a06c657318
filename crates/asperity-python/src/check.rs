//! Scenes and answers that are looked at before they are believed.

use asperity::{
    Check, ContactError, ContactModel, Diagnostic, Diagnostics, Model, Quantity, Request, Severity,
};
use pyo3::prelude::*;

use crate::ask::rows::{Rows, View};
use crate::convert::axis::Axis;
use crate::convert::error::{refused, value_error};
use crate::convert::objects::object;
use crate::model::engine::{Engine, tolerance};
use crate::scene::SceneFile;

/// Numbers with unit and meaning, and findings, of a scene and, if a number is given, of the answer
/// there.
type Looked<'py> = (Vec<(String, f64, String, String)>, Bound<'py, PyAny>);

/// What follows from a scene and, for a model, from a place, with what is unusual about it.
#[pyfunction]
#[pyo3(signature = (scene, asked=None))]
pub(crate) fn check<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    asked: Option<(PyRef<'py, Engine>, Axis, f64)>,
) -> PyResult<Looked<'py>> {
    let file = &scene.0;
    let looked = match asked {
        None => file.check(None).map_err(refused)?,
        Some((engine, axis, number)) => {
            let (model, at) = (engine.on(file)?, axis.at(number, file.separation_from));
            match py.detach(|| file.check(Some((&model, at)))) {
                Ok(looked) => looked,
                Err(error) => explained(file, &error).ok_or_else(|| engine.raise(py, error))?,
            }
        }
    };
    let Check { numbers, findings, .. } = looked;
    let number =
        |n: asperity::DerivedNumber| (n.name.into(), n.value, n.unit.into(), n.meaning.into());
    Ok((numbers.into_iter().map(number).collect(), object(py, &findings)?))
}

/// The scene alone where its warnings or errors explain why there is no answer.
fn explained(file: &asperity_scene::SceneFile, error: &ContactError) -> Option<Check> {
    let mut looked = file.check(None).ok()?;
    looked.findings.iter().find(|found| found.severity < Severity::Note)?;
    let refused = Diagnostic::error("no-answer", "answer", f64::NAN);
    looked.extend([refused.fact("the model has no answer").advice(error.to_string())]);
    Some(looked)
}

/// The greatest tension that a model's surfaces hold [N], and the separation where they do.
#[pyfunction]
pub(crate) fn pull_off(
    py: Python<'_>,
    engine: &Engine,
    scene: &SceneFile,
    rtol: f64,
    unit: Axis,
) -> PyResult<Option<(f64, f64)>> {
    let (file, tolerance) = (&scene.0, tolerance(rtol)?);
    let model = engine.on(file)?;
    if !model.validity().adhesive {
        let name = model.name();
        return Err(value_error(format!(
            "{name} knows no adhesion: dmt or jkr-separation was required"
        )));
    }
    let found = py.detach(|| {
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        let Some(found) = asperity::pull_off(&*model.compile(&file.scene, &request)?)? else {
            return Ok(None);
        };
        let place = unit.of(found.separation, file.separation_from, &file.scene)?;
        Ok(Some((found.force.value(), place)))
    });
    found.map_err(|error| engine.raise(py, error))
}

/// Diagnostics of the scenes of rows and, where there is but one, of the answers.
#[pyfunction]
pub(crate) fn findings(py: Python<'_>, engine: &Engine, rows: Rows<'_>) -> PyResult<Vec<String>> {
    let rows = rows.view()?;
    let model = engine.on_all(&rows.files)?;
    let found = py.detach(|| rows.accepted(of_rows(engine, &model, &rows)));
    Ok(found.iter().map(ToString::to_string).collect())
}

/// What is unusual about the scenes of rows and, where there is but one, about the answers.
pub(crate) fn of_rows(engine: &Engine, model: &Model, rows: &View<'_>) -> Diagnostics {
    let mut found = of_scenes(rows, model.validity().asperities);
    // What a user's own law raises belongs to the answer.
    if let (Some(file), false) = (rows.one_file(), engine.is_written()) {
        // Of millions of rows the closest and the lightest are enough.
        let places: Vec<_> = rows.ends().map(|row| rows.at(row)).collect();
        found.extend(file.findings_at(model, &places));
    }
    found
}

/// Each finding once, of the first scene that shows it, with the number of scenes that do.
fn of_scenes(rows: &View<'_>, asperities: bool) -> Diagnostics {
    let mut found: Vec<(Diagnostic, usize)> = vec![];
    let count = rows.scenes();
    for scene in 0..count {
        for new in rows.findings(scene).for_asperities(asperities) {
            match found.iter_mut().find(|(f, _)| f.code == new.code && f.field == new.field) {
                Some((_, scenes)) => *scenes += 1,
                None => found.push((new, 1)),
            }
        }
    }
    let counted = |(found, scenes): (Diagnostic, usize)| match count {
        1 => found,
        _ => found.from_origin(format!("{scenes} of {count} scenes")),
    };
    found.into_iter().map(counted).collect()
}
