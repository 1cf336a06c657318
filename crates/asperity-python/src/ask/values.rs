//! Values of rows, the separations of loads, and shares.

use std::ops::Range;
use std::sync::Arc;

use asperity::{
    At, Case, Contact, ContactError, ContactModel, Evaluation, Findings, Model, Quantity, Request,
    Scene, Separation, Share, Sweep,
};
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::ask::answer::{Aspect, Question, ROWS_PER_TASK, evaluate_cases};
use crate::ask::long::run_stretches;
use crate::ask::rows::Rows;
use crate::check::check_rows;
use crate::convert::axis::Axis;
use crate::convert::error::value_error;
use crate::convert::quantities::Quantities;
use crate::model::engine::{Engine, tolerance};

/// Rows that failed, with their exceptions, ascending.
pub(crate) type Failures = Vec<(usize, Py<PyAny>)>;

pub(crate) fn failures(
    py: Python<'_>,
    engine: &Engine,
    failed: Vec<(usize, ContactError)>,
) -> Failures {
    let object = |(row, error)| (row, engine.raise(py, error).into_value(py).into_any());
    failed.into_iter().map(object).collect()
}

/// The model's name on these scenes; quantities of every row, NaN where a row fails, by name; the
/// failures, and the texts of findings.
///
/// `stop` ends the call at the first failure, `checked` adds the findings of the scenes, and
/// `threads` is one for each core, if none.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "only the package calls this function")]
pub(crate) fn answer<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows,
    quantities: Quantities,
    rtol: f64,
    aspect: &str,
    stop: bool,
    threads: Option<usize>,
    checked: bool,
) -> PyResult<(String, Bound<'py, PyDict>, Failures, Vec<String>)> {
    let (rows, model) = (&rows, &engine.on_all(&rows.files)?);
    let is_value = aspect == "value";
    let aspect: Aspect = match aspect {
        "ln" => |found, _| found.ln_value(),
        "error" => Evaluation::bound,
        _ => |found, _| found.value(),
    };
    let request = quantities.request(rtol)?;
    let question = Question { rows, model, request, aspect, is_value };
    let answer = question.answer(py, threads, stop, |error| engine.raise(py, error))?;
    let found = py.detach(|| {
        let of_scenes = if checked { check_rows(engine, model, rows) } else { Findings::default() };
        rows.accepted(of_scenes.into_iter().chain(answer.warnings).collect())
    });
    let texts = rows.mistaken_unit().into_iter().chain(found.iter().map(ToString::to_string));
    let columns = quantities.names().into_iter().zip(answer.columns);
    let columns = columns.map(|(name, column)| (name, PyArray1::from_vec(py, column)));
    let failures = failures(py, engine, answer.failures);
    Ok((model.name().into(), columns.into_py_dict(py)?, failures, texts.collect()))
}

/// The separations that carry the load or pressure of every row, in `unit` and from the scene's
/// plane: the largest, or a list of arrays with `all`, ascending; and the failed rows, with NaN.
#[pyfunction]
pub(crate) fn separations<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows,
    unit: Axis,
    rtol: f64,
    all: bool,
    stop: bool,
) -> PyResult<(Bound<'py, PyAny>, Failures)> {
    let (rows, model) = (&rows, &engine.on_all(&rows.files)?);
    let request = &Request::new([Quantity::Force]).within(tolerance(rtol)?);
    let contacts = Contacts::new(py, engine, rows, model, request)?;
    let in_unit = |row, scene: &Scene, found| unit.of(found, rows.datum(row), scene);
    // A separation or all of them at the load of a row.
    let one = |contact: &dyn Contact, row| {
        let found = contact.separation_at(load(contact, rows.at(row))?)?;
        in_unit(row, contact.scene(), found)
    };
    let every = |contact: &dyn Contact, row| {
        let found = contact.separations_at(load(contact, rows.at(row))?)?;
        found.into_iter().map(|found| in_unit(row, contact.scene(), found)).collect()
    };
    if all {
        let run = |range| contacts.each(range, every);
        let ends = |found: &Vec<Found<Vec<f64>>>| stop && found.iter().any(Result::is_err);
        // All separations of a load take long.
        let found = run_stretches(py, None, (rows.len(), ROWS_PER_TASK / 8), run, ends)?;
        let (found, failed) = split(py, engine, found, &vec![]);
        let found: Vec<_> = found.into_iter().map(|row| PyArray1::from_vec(py, row)).collect();
        return Ok((found.into_bound_py_any(py)?, failed));
    }
    let sweep = Sweep::new(model, &request.quantities, request.tolerance);
    let swept = |(row, case, found): (usize, Option<Case>, Result<f64, ContactError>)| match case {
        Some(case) => Ok(in_unit(row, &case.scene, Separation::sigmas(found?))?),
        None => Ok(found?),
    };
    let run = |range| match contacts.one {
        Some(_) => contacts.each(range, one),
        None => evaluate_cases(rows, range, |cases| sweep.separations(cases)).map(swept).collect(),
    };
    let ends = |found: &Vec<Found<f64>>| stop && found.iter().any(Result::is_err);
    let found = run_stretches(py, None, (rows.len(), ROWS_PER_TASK), run, ends)?;
    let (found, failed) = split(py, engine, found, &f64::NAN);
    Ok((PyArray1::from_vec(py, found).into_any(), failed))
}

/// What is found in a row; boxed, as there may be millions.
type Found<T> = Result<T, Box<ContactError>>;

/// The results of all rows, with `missing` for the failed ones, and these.
fn split<T: Clone>(
    py: Python<'_>,
    engine: &Engine,
    found: Vec<Vec<Found<T>>>,
    missing: &T,
) -> (Vec<T>, Failures) {
    let mut failed = vec![];
    let kept = found.into_iter().flatten().zip(0..).map(|(found, row)| {
        found.unwrap_or_else(|error| {
            failed.push((row, *error));
            missing.clone()
        })
    });
    (kept.collect(), failures(py, engine, failed))
}

/// The load at a place.
fn load(contact: &dyn Contact, at: At) -> Result<f64, ContactError> {
    match at {
        At::Load(load) => Ok(load),
        At::Pressure(pressure) => {
            Ok(asperity::positive("pressure", pressure)? * contact.scene().nominal_area)
        }
        at => Err(contact.unsupported(&format!("the load at {at}"))),
    }
}

/// The share of every part of the law in a quantity of every row, by the part's name.
#[pyfunction]
pub(crate) fn shares<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows,
    quantity: &str,
    rtol: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let (rows, model) = (&rows, &engine.on_all(&rows.files)?);
    let quantity = quantity.parse().map_err(value_error)?;
    let request = &Request::new([quantity]).within(tolerance(rtol)?);
    let contacts = Contacts::new(py, engine, rows, model, request)?;
    // Sorted by scene: a contact is compiled once per scene.
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|row| rows.place(*row));
    let one = |contact: &dyn Contact, row| contact.shares_at(quantity, rows.at(row));
    let run = |range: Range<usize>| -> Result<Vec<Vec<Share>>, Box<ContactError>> {
        contacts.each(order[range].iter().copied(), one).into_iter().collect()
    };
    let mut columns: Vec<(String, Vec<f64>)> = vec![];
    let mut places = order.iter();
    for found in run_stretches(py, None, (rows.len(), ROWS_PER_TASK), run, Result::is_err)? {
        let found = found.map_err(|error| engine.raise(py, *error))?;
        for (shares, row) in found.into_iter().zip(&mut places) {
            for Share { name, share, .. } in shares {
                let existing = columns.iter().position(|(column, _)| *column == name);
                let place = existing.unwrap_or_else(|| {
                    columns.push((name.into(), vec![0.0; rows.len()]));
                    columns.len() - 1
                });
                columns[place].1[*row] = share;
            }
        }
    }
    let columns = columns.into_iter();
    columns.map(|(name, column)| (name, PyArray1::from_vec(py, column))).into_py_dict(py)
}

/// Contacts of rows: that of a single scene, or of each scene, kept while rows stay on it.
#[derive(Clone)]
struct Contacts<'a> {
    rows: &'a Rows,
    model: &'a Model,
    request: &'a Request,
    one: Option<Arc<dyn Contact>>,
    held: Option<(usize, Arc<dyn Contact>)>,
}

impl<'a> Contacts<'a> {
    fn new(
        py: Python<'_>,
        engine: &Engine,
        rows: &'a Rows,
        model: &'a Model,
        request: &'a Request,
    ) -> PyResult<Self> {
        let one = rows.one_scene().map(|scene| {
            // Few rows are not worth a preparation.
            let few = (0..rows.len().min(ROWS_PER_TASK)).map(|row| rows.at(row));
            py.detach(|| model.contact(scene, &request.clone().at(few)))
        });
        let one = one.transpose().map_err(|error| engine.raise(py, error))?;
        Ok(Self { rows, model, request, one: one.map(Arc::from), held: None })
    }

    /// `of` a contact at each row of a stretch.
    fn each<T>(
        &self,
        rows: impl Iterator<Item = usize>,
        of: impl Fn(&dyn Contact, usize) -> Result<T, ContactError>,
    ) -> Vec<Found<T>> {
        let mut contacts = self.clone();
        rows.map(|row| Ok(contacts.of(row).and_then(|found| of(found, row))?)).collect()
    }

    fn of(&mut self, row: usize) -> Result<&dyn Contact, ContactError> {
        if let Some(one) = &self.one {
            return Ok(&**one);
        }
        let place = self.rows.place(row);
        let held = match self.held.take() {
            Some(held) if held.0 == place => held,
            _ => (place, self.model.compile(&self.rows.scene(row)?, self.request)?.into()),
        };
        Ok(&*self.held.insert(held).1)
    }
}
