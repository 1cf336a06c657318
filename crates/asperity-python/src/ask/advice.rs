//! Checks of scenes and answers, plans of requests, and recommendations of models.

use std::collections::BTreeMap;

use asperity::{
    At, Check, Compared, Comparison, ContactError, ContactModel, EvidenceAt, Finding, Findings,
    Model, Quantity, Ratio, Request, Scene, Severity,
};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;

use crate::ask::asked::{Arguments, Asked};
use crate::ask::rows::Rows;
use crate::convert::axis::Axis;
use crate::convert::{Object, object, refused, tolerance, value_error};
use crate::model::engine::{Engine, Engines, models_among, raise_own};
use crate::scene::SceneFile;

/// Numbers with unit and meaning, and findings, of a scene and, at a place, of the answer.
type CheckResult<'py> = (Vec<CheckedNumber>, Object<'py>);
/// Name, value, ends, unit and meaning.
type CheckedNumber = (String, f64, Option<[f64; 2]>, String, String);

/// Derived numbers and findings of a scene and, at a place, of a model's answer.
#[pyfunction]
#[pyo3(signature = (scene, place=None))]
pub(crate) fn check<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    place: Option<(PyRef<'py, Engine>, Axis, f64)>,
) -> PyResult<CheckResult<'py>> {
    let file = &scene.0;
    let checked = match place {
        None => file.check(None).map_err(refused)?,
        Some((engine, axis, number)) => {
            let model = engine.on(&file.middle().map_err(refused)?)?;
            let at = axis.at(number, file.separation_from);
            match py.detach(|| file.check(Some((&model, at)))) {
                Ok(checked) => checked,
                Err(error) => explain(file, &error).ok_or_else(|| engine.raise(py, error))?,
            }
        }
    };
    let Check { numbers, findings, .. } = checked;
    let number = |n: asperity::DerivedNumber| {
        (n.name.into(), n.value, n.ends, n.unit.into(), n.meaning.into())
    };
    Ok((numbers.into_iter().map(number).collect(), object(py, &findings)?))
}

/// The check of the scene alone, if its warnings explain the refusal.
fn explain(file: &asperity_inputs::SceneFile, error: &ContactError) -> Option<Check> {
    let mut checked = file.check(None).ok()?;
    checked.findings.iter().find(|found| found.severity < Severity::Note)?;
    let refusal = Finding::refusal("no-result", "answer", f64::NAN);
    checked.extend([refusal.fact("the model has no answer").advice(error.to_string())]);
    Some(checked)
}

/// The pull-off force of a model with adhesion [N], below 0, and its separation; none without a
/// tensile force.
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
        let name = model.id();
        return Err(value_error(format!("{name} ignores adhesion: use dmt or jkr-separation")));
    }
    engine.run(py, || {
        let request = Request::new([Quantity::Force, Quantity::Tangent]).within(tolerance);
        let Some(found) = asperity::pull_off(&*model.compile(&file.scene, &request)?)? else {
            return Ok(None);
        };
        let place = unit.of(found.separation, file.separation_from, &file.scene)?;
        Ok(Some((found.force.value(), place)))
    })
}

/// Findings of the scenes of rows and, on a single scene, of the answers.
pub(crate) fn check_rows(asked: &Asked) -> Findings {
    let Asked { rows, model, .. } = asked;
    match rows.one_file() {
        // The smallest and the largest number suffice: there may be millions of rows.
        Some(file) => {
            let places = rows.ends().map(|row| rows.at(row));
            let mut found = check_scene(asked.engine(), model, file, places);
            found.extend(file.conduction_findings(&asked.request.quantities));
            found
        }
        None => check_scenes(rows, model.validity().asperities),
    }
}

/// Findings of a scene and of the answers at places on it.
pub(crate) fn check_scene(
    engine: &Engine,
    model: &Model,
    file: &asperity_inputs::SceneFile,
    places: impl IntoIterator<Item = At>,
) -> Findings {
    let mut found = file.findings().for_asperities(model.validity().asperities);
    // An exception of a user's law is raised by the answer.
    if !engine.is_written() {
        found.extend(file.findings_at(model, &places.into_iter().collect::<Vec<_>>()));
    }
    found
}

/// Each finding once, that of the first scene that has it, with the number of such scenes.
fn check_scenes(rows: &Rows, asperities: bool) -> Findings {
    let mut found: Vec<(Finding, usize)> = vec![];
    let count = rows.scenes();
    for scene in 0..count {
        // A refused scene has no findings: its rows have the reason.
        let Ok(file) = rows.scene_file(scene) else { continue };
        for new in file.findings().for_asperities(asperities) {
            match found.iter_mut().find(|(f, _)| f.code == new.code && f.field == new.field) {
                Some((_, scenes)) => *scenes += 1,
                None => found.push((new, 1)),
            }
        }
    }
    let counted = |(found, scenes): (Finding, usize)| match count {
        1 => found,
        _ => found.from_origin(format!("{scenes} of {count} scenes")),
    };
    found.into_iter().map(counted).collect()
}

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
pub(crate) fn plan<'py>(py: Python<'py>, asked: Arguments<'py>) -> PyResult<(String, Object<'py>)> {
    let asked = Asked::new(asked)?;
    let (scene, request) = scene_and_request(&asked)?;
    let plan = asked.engine().run(py, || asked.model.compile(scene, &request)?.plan(&request))?;
    Ok((plan.to_string(), object(py, &plan)?))
}

/// What is known of a model: its id, the deviation of each quantity, why some or all have no value,
/// and the deviation from boundary elements.
type Known<'py> = (String, Vec<(String, f64)>, Option<String>, Option<Object<'py>>);
/// The simplest model, all models, the evidence in sentences and place by place, and the text.
type Advice<'py> = (Option<String>, Vec<Known<'py>>, String, Vec<Object<'py>>, String);

/// Deviations from boundary elements by the name of the quantity, and half the widths of their
/// intervals.
fn by_name(off: &[(Compared, Ratio)]) -> BTreeMap<String, f64> {
    let each = |(quantity, ratio): &(Compared, Ratio)| {
        let name = quantity.name();
        [(name.into(), ratio.deviation(*quantity)), (format!("{name}_spread"), ratio.half_width())]
    };
    off.iter().flat_map(each).collect()
}

/// Deviations from the reference of the models of a scene, or of these.
#[pyfunction]
pub(crate) fn recommend<'py>(
    py: Python<'py>,
    asked: Arguments<'_>,
    within: f64,
    engines: Engines,
) -> PyResult<Advice<'py>> {
    let asked = Asked::new(asked)?;
    let ((_, request), file) = (scene_and_request(&asked)?, &asked.rows.files[0]);
    let (among, left_out) = models_among(file, &engines)?;
    let advice =
        asked.engine().run(py, || file.recommend_among(among, &request, &asked.model, within))?;
    let refusals = advice.comparisons.iter().flat_map(|found| {
        let lacking = found.lacking.iter().map(|(_, why)| why);
        found.deviations.as_ref().err().into_iter().chain(lacking)
    });
    raise_own(py, &engines, refusals)?;
    let compared = |found: &Comparison| -> PyResult<Known<'py>> {
        let (all, lacking) = (&found.deviations, found.lacking.first().map(|(_, reason)| reason));
        let known = all.iter().flatten().map(|(quantity, off)| (quantity.to_string(), *off));
        let reason = all.as_ref().err().or(lacking).map(ToString::to_string);
        let off = (!found.off.is_empty()).then(|| object(py, &by_name(&found.off))).transpose()?;
        Ok((found.model.id().into(), known.collect(), reason, off))
    };
    let left_out = left_out.into_iter();
    let left_out = left_out.map(|one| Ok((one.id, vec![], Some(one.reason.to_string()), None)));
    let models = advice.comparisons.iter().map(compared).chain(left_out);
    let place = |place: &EvidenceAt| match &place.expected {
        Err(reason) => reason.to_string().into_bound_py_any(py),
        Ok(_) => {
            let ids = advice.comparisons.iter().map(|found| found.model.id());
            let known = ids.map(|id| (id, by_name(&place.relative(id))));
            let off = known.filter(|(_, off)| !off.is_empty());
            object(py, &off.collect::<BTreeMap<_, _>>())
        }
    };
    let places = advice.evidence.iter().map(place).collect::<PyResult<_>>()?;
    let evidence = [advice.summary(), advice.expectations()].concat().join("\n");
    let simplest = advice.simplest.as_ref().map(|model| model.id().into());
    let text = advice.to_string().trim_end_matches('\n').into();
    Ok((simplest, models.collect::<PyResult<_>>()?, evidence, places, text))
}
