//! Checks of scenes and answers, and what is known best.

use std::collections::BTreeMap;

use asperity::{
    At, Check, Code, ContactError, ContactModel, Finding, Findings, Model, Quantity, Request,
    Severity,
};
use asperity_answer::{Answer, Cell, Sheet, check_sheet, lines, patch, solve, solved_contact};
use pyo3::prelude::*;

use crate::ask::asked::Asked;
use crate::ask::long::run_interruptible;
use crate::ask::rows::Rows;
use crate::convert::axis::Axis;
use crate::convert::{Quantities, refused, taken_in_the_middle, tolerance, value_error};
use crate::model::engine::{Engine, without};
use crate::scene::SceneFile;
use crate::tables::{Table, table, warn_of};

/// Derived numbers and findings of a scene and, at a place, of a model's answer.
#[pyfunction]
#[pyo3(signature = (scene, place=None))]
pub(crate) fn check<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    place: Option<(PyRef<'py, Engine>, Axis, f64)>,
) -> PyResult<Table<'py>> {
    let file = &scene.0;
    let checked = match place {
        None => file.check(None).map_err(refused)?,
        Some((engine, axis, number)) => {
            let model = engine.on(&file.middle().map_err(refused)?)?;
            let at = axis.at(number, file.spec.separation_from);
            match py.detach(|| file.check(Some((&model, at)))) {
                Ok(checked) => checked,
                Err(error) => explain(file, &error).ok_or_else(|| engine.raise(py, error))?,
            }
        }
    };
    table(py, &check_sheet(checked))
}

/// The check of the scene alone, if its warnings explain the refusal.
fn explain(file: &asperity_scene::SceneFile, error: &ContactError) -> Option<Check> {
    let mut checked = file.check(None).ok()?;
    checked.findings.iter().find(|found| found.severity < Severity::Note)?;
    let refusal = Finding::refusal(Code::NoValue, "answer", f64::NAN);
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
        let place = unit.of(found.separation, file.spec.separation_from, &file.scene)?;
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
            // Of a number with a range, one value is calculated with.
            found.extend(taken_in_the_middle(file));
            found
        }
        None => check_scenes(rows, model.validity().asperities),
    }
}

/// Findings of a scene and of the answers at places on it.
pub(crate) fn check_scene(
    engine: &Engine,
    model: &Model,
    file: &asperity_scene::SceneFile,
    places: impl IntoIterator<Item = At>,
) -> Findings {
    let mut found = file.findings().for_asperities(model.validity().asperities);
    // An exception of a user's law is raised by the answer.
    if !engine.is_written() {
        found.extend(file.judge(model, None, &places.into_iter().collect::<Vec<_>>()));
    }
    found
}

/// Each finding once, of the first scene that has it, with the number of such scenes.
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

/// What is solved for an answer: boundary elements at its loads, or solutions that were made, each
/// with its mean pressure [Pa], its values by the names of quantities, and the codes of its notes.
#[derive(FromPyObject)]
pub(crate) enum Solving {
    Now(bool),
    Done(Vec<(f64, BTreeMap<String, f64>)>, Vec<String>),
}

/// What stands behind an answer, and its lines as the program prints them.
type Behind = ([String; 3], Vec<Vec<String>>);

/// The patch of curved bodies under a load [N].
#[pyfunction]
pub(crate) fn profile<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    load: f64,
    model: &str,
    rtol: f64,
) -> PyResult<Table<'py>> {
    let (file, tolerance) = (&scene.0, tolerance(rtol)?);
    let [all, _] = py.detach(|| patch(file, model, load, tolerance)).map_err(value_error)?;
    table(py, &all)
}

/// What is known best about a scene under loads.
#[pyfunction]
pub(crate) fn best<'py>(
    py: Python<'py>,
    scene: &SceneFile,
    place: (Axis, Vec<f64>),
    quantities: Option<Quantities>,
    rtol: f64,
    solving: Solving,
) -> PyResult<(Table<'py>, Behind)> {
    let mut file = (*scene.0).clone();
    let (axis, numbers) = place;
    axis.check(&file)?;
    let at: Vec<At> =
        numbers.into_iter().map(|one| axis.at(one, file.spec.separation_from)).collect();
    file.solved = match solving {
        Solving::Now(false) => vec![],
        Solving::Now(true) => {
            run_interruptible(py, |stop| solve(&file, &at, stop))?.map_err(value_error)?
        }
        Solving::Done(rows, notes) => {
            let one = |(pressure, values): &(f64, BTreeMap<String, f64>)| {
                solved_contact(*pressure, |name| values.get(name).copied(), &notes)
            };
            rows.iter().map(one).collect()
        }
    };
    let asked = quantities.map_or_else(Vec::new, |names| names.0);
    let asked = Answer::new(&file, &asked, at, tolerance(rtol)?);
    let mut sheet = Sheet::default();
    let found = py.detach(|| asked.answer(&file, &mut sheet));
    let basis = found.map_err(|error| without(&sheet, error))?;
    warn_of(py, &file, &sheet)?;
    let told = lines(&file, &sheet);
    let texts = |row: &Vec<Cell>| row.iter().map(|cell| cell.text().to_string()).collect();
    let told = [told.heads.clone()].into_iter().chain(told.rows.iter().map(texts)).collect();
    Ok((table(py, &sheet)?, ([basis.by, basis.widest, basis.also], told)))
}
