//! Values of rows, the separations of loads, and shares.

use std::ops::Range;

use asperity::{
    At, Case, ContactError, ContactModel, Findings, Model, Request, Scene, Separation, Share, Sweep,
};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::ask::answer::{Aspect, Question, ROWS_PER_TASK, Source, evaluate_cases};
use crate::ask::long::{pool, run_stretches};
use crate::ask::rows::{Rows, View};
use crate::check::check_rows;
use crate::convert::axis::Axis;
use crate::convert::error::value_error;
use crate::model::engine::{Engine, request_of, tolerance};

pub(crate) type Column<'py, T> = Bound<'py, PyArray1<T>>;
/// Rows that failed, with their exceptions, ascending.
pub(crate) type Failures = Vec<(usize, Py<PyAny>)>;

pub(crate) fn failures(py: Python<'_>, failures: Vec<(usize, PyErr)>) -> Failures {
    let object = |(row, error): (usize, PyErr)| (row, error.into_value(py).into_any());
    failures.into_iter().map(object).collect()
}

/// Quantities of every row, NaN where a row fails, with the failures and the texts of findings.
///
/// `stop` ends the call at the first failure, `checked` adds the findings of the scenes, and
/// `threads` is one for each core, if none.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "only the package calls this function")]
pub(crate) fn answer<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows<'py>,
    names: Vec<String>,
    rtol: f64,
    aspect: Aspect,
    stop: bool,
    threads: Option<usize>,
    checked: bool,
) -> PyResult<(Vec<Column<'py, f64>>, Failures, Vec<String>)> {
    let rows = &rows.view()?;
    let model = engine.on_all(&rows.files)?;
    let request = request_of(&names, rtol)?;
    let question = Question { rows, source: Source::Model(&model), request, aspect };
    let answer = question.answer(py, threads, stop, |error| engine.raise(py, error))?;
    let found = py.detach(|| {
        let of_scenes =
            if checked { check_rows(engine, &model, rows) } else { Findings::default() };
        rows.accepted(of_scenes.into_iter().chain(answer.warnings).collect())
    });
    let texts = rows.mistaken_unit().into_iter().chain(found.iter().map(ToString::to_string));
    let columns = answer.columns.into_iter().map(|column| PyArray1::from_vec(py, column));
    Ok((columns.collect(), failures(py, answer.failures), texts.collect()))
}

/// The separations that carry the load or pressure of every row, in `unit` and from the scene's
/// plane: the largest, or `all`, ascending. `counts[i]` separations belong to row i, 0 if it fails.
#[pyfunction]
pub(crate) fn separations<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows<'py>,
    unit: Axis,
    rtol: f64,
    all: bool,
    stop: bool,
) -> PyResult<(Column<'py, f64>, Column<'py, i64>, Failures)> {
    let rows = &rows.view()?;
    let model = &engine.on_all(&rows.files)?;
    let request = &Request::new([asperity::Quantity::Force]).within(tolerance(rtol)?);
    let sweep = Sweep::new(model, &request.quantities, request.tolerance);
    // Preparing a contact pays for many rows only.
    let one = rows.one_scene().filter(|_| all || rows.len() > ROWS_PER_TASK);
    let one = one.map(|scene| py.detach(|| model.compile(scene, request)));
    let one = one.transpose().map_err(|error| engine.raise(py, error))?;
    let user = |row, scene: &Scene, found| unit.of(found, rows.datum(row), scene);
    let largest = |range: Range<usize>| {
        let found = evaluate_cases(rows, range, |cases| sweep.separations(cases)).into_iter();
        let each = |(row, case, found): (usize, Option<Case>, Result<f64, ContactError>)| {
            let found = found.map(Separation::sigmas);
            let in_unit = case.map(|case| found.clone().and_then(|s| user(row, &case.scene, s)));
            (row, in_unit.unwrap_or_else(|| found.map(|s| s.value)).map(|s| vec![s]))
        };
        found.map(each).collect()
    };
    let each = |range: Range<usize>| {
        let mut contacts = Contacts { rows, model, request, one: one.as_deref(), held: None };
        let mut found = |row: usize| {
            let contact = contacts.of(row)?;
            let load = match rows.at(row) {
                At::Load(load) => load,
                At::Pressure(pressure) => {
                    asperity::positive("pressure", pressure)? * contact.scene().nominal_area
                }
                at => return Err(contact.unsupported(&format!("the load at {at}"))),
            };
            let found = match all {
                true => contact.separations_at(load)?,
                false => vec![contact.separation_at(load)?],
            };
            found.into_iter().map(|s| user(row, contact.scene(), s)).collect()
        };
        range.map(|row| (row, found(row))).collect()
    };
    let run = |range| -> Vec<(usize, Result<Vec<f64>, ContactError>)> {
        if one.is_some() || all { each(range) } else { largest(range) }
    };
    let (mut values, mut counts, mut failed) = (vec![], vec![], vec![]);
    // All separations of a load take long: smaller run_stretches keep Ctrl-C responsive.
    let together = if all { ROWS_PER_TASK / 8 } else { ROWS_PER_TASK };
    run_stretches(py, &*pool(None)?, rows.len(), together, run, |found| {
        for (row, found) in found {
            counts.push(found.as_ref().map_or(0, Vec::len) as i64);
            match found {
                Ok(found) => values.extend(found),
                Err(error) => failed.push((row, engine.raise(py, error))),
            }
        }
        Ok(!stop || failed.is_empty())
    })?;
    let (values, counts) = (PyArray1::from_vec(py, values), PyArray1::from_vec(py, counts));
    Ok((values, counts, failures(py, failed)))
}

/// The share of every part of the law in a quantity of every row, by the part's name.
#[pyfunction]
pub(crate) fn shares<'py>(
    py: Python<'py>,
    engine: &Engine,
    rows: Rows<'py>,
    quantity: &str,
    rtol: f64,
) -> PyResult<Vec<(String, Column<'py, f64>)>> {
    let rows = &rows.view()?;
    let model = &engine.on_all(&rows.files)?;
    let quantity = quantity.parse().map_err(value_error)?;
    let request = &Request::new([quantity]).within(tolerance(rtol)?);
    let one = rows.one_scene().map(|scene| py.detach(|| model.compile(scene, request)));
    let one = one.transpose().map_err(|error| engine.raise(py, error))?;
    // Sorted by scene: a contact is compiled once per scene.
    let mut order: Vec<usize> = (0..rows.len()).collect();
    order.sort_by_key(|row| rows.place(*row));
    let run = |range: Range<usize>| -> Result<Vec<Vec<Share>>, ContactError> {
        let mut contacts = Contacts { rows, model, request, one: one.as_deref(), held: None };
        let one = |row: &usize| contacts.of(*row)?.shares_at(quantity, rows.at(*row));
        order[range].iter().map(one).collect()
    };
    let mut columns: Vec<(String, Vec<f64>)> = vec![];
    let mut places = order.iter();
    run_stretches(py, &*pool(None)?, rows.len(), ROWS_PER_TASK, run, |found| {
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
        Ok(true)
    })?;
    let columns = columns.into_iter();
    Ok(columns.map(|(name, column)| (name, PyArray1::from_vec(py, column))).collect())
}

/// Contacts of rows: a compiled one, or that of each scene, kept while rows stay on it.
struct Contacts<'a> {
    rows: &'a View<'a>,
    model: &'a Model,
    request: &'a Request,
    one: Option<&'a dyn asperity::Contact>,
    held: Option<(usize, Box<dyn asperity::Contact>)>,
}

impl Contacts<'_> {
    fn of(&mut self, row: usize) -> Result<&dyn asperity::Contact, ContactError> {
        if let Some(one) = self.one {
            return Ok(one);
        }
        let place = self.rows.place(row);
        let held = match self.held.take() {
            Some(held) if held.0 == place => held,
            _ => (place, self.model.compile(&self.rows.scene(row)?, self.request)?),
        };
        Ok(&*self.held.insert(held).1)
    }
}
