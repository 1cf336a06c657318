//! Values of rows, the separations of loads, and shares.

use std::ops::Range;
use std::sync::Arc;

use asperity::{
    At, Contact, ContactError, ContactModel, Findings, Model, Quantity, Request, Scene, Separation,
    Share, Sweep,
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
    aspect: Aspect,
    stop: bool,
    threads: Option<usize>,
    checked: bool,
) -> PyResult<(String, Bound<'py, PyDict>, Failures, Vec<String>)> {
    let (rows, model) = (&rows, &engine.on_all(&rows.files)?);
    let request = quantities.request(rtol)?;
    let question = Question { rows, model, request, aspect };
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

/// Separations of a stretch of rows, with their number for each row, and the failed rows.
#[derive(Default)]
struct Found {
    separations: Vec<f64>,
    counts: Vec<usize>,
    failures: Vec<(usize, ContactError)>,
}

impl Found {
    fn push(&mut self, row: usize, found: Result<Vec<f64>, ContactError>) {
        let found = found.unwrap_or_else(|error| {
            self.failures.push((row, error));
            vec![f64::NAN]
        });
        self.counts.push(found.len());
        self.separations.extend(found);
    }
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
    let sweep = Sweep::new(model, &request.quantities, request.tolerance);
    let in_unit = |row, scene: &Scene, found| unit.of(found, rows.datum(row), scene);
    let largest = |range: Range<usize>| {
        let mut found = Found::default();
        for (row, case, s) in evaluate_cases(rows, range, |cases| sweep.separations(cases)) {
            let in_unit = |s| match &case {
                Some(case) => in_unit(row, &case.scene, Separation::sigmas(s)),
                None => Ok(s),
            };
            found.push(row, s.and_then(in_unit).map(|s| vec![s]));
        }
        found
    };
    let each = |range: Range<usize>| {
        let (mut contacts, mut found) = (contacts.clone(), Found::default());
        for row in range {
            let separations = contacts.of(row).and_then(|contact| {
                let load = match rows.at(row) {
                    At::Load(load) => load,
                    At::Pressure(pressure) => {
                        asperity::positive("pressure", pressure)? * contact.scene().nominal_area
                    }
                    at => return Err(contact.unsupported(&format!("the load at {at}"))),
                };
                let all = match all {
                    true => contact.separations_at(load)?,
                    false => vec![contact.separation_at(load)?],
                };
                all.into_iter().map(|s| in_unit(row, contact.scene(), s)).collect()
            });
            found.push(row, separations);
        }
        found
    };
    // All separations of a load take long.
    let together = if all { ROWS_PER_TASK / 8 } else { ROWS_PER_TASK };
    let run = |range| if contacts.one.is_some() || all { each(range) } else { largest(range) };
    let ends = |found: &Found| stop && !found.failures.is_empty();
    let stretches = run_stretches(py, None, (rows.len(), together), run, ends)?;
    let (mut arrays, mut separations, mut failed) = (vec![], vec![], vec![]);
    for mut found in stretches {
        failed.append(&mut found.failures);
        if all {
            let mut rest = &found.separations[..];
            for count in found.counts {
                let (row, others) = rest.split_at(count);
                arrays.push(PyArray1::from_slice(py, row));
                rest = others;
            }
        } else {
            separations.append(&mut found.separations);
        }
    }
    let found = match all {
        true => arrays.into_bound_py_any(py)?,
        false => PyArray1::from_vec(py, separations).into_any(),
    };
    Ok((found, failures(py, engine, failed)))
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
    let run = |range: Range<usize>| -> Result<Vec<Vec<Share>>, ContactError> {
        let mut contacts = contacts.clone();
        let one = |row: &usize| contacts.of(*row)?.shares_at(quantity, rows.at(*row));
        order[range].iter().map(one).collect()
    };
    let mut columns: Vec<(String, Vec<f64>)> = vec![];
    let mut places = order.iter();
    for found in run_stretches(py, None, (rows.len(), ROWS_PER_TASK), run, Result::is_err)? {
        let found = found.map_err(|error| engine.raise(py, error))?;
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
