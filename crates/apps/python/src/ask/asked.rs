//! What the package asks: a model on rows, for quantities within a tolerance.

use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

use asperity::{Contact, ContactError, ContactModel, Model, Request};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::ask::long::run_stretches;
use crate::ask::rows::Rows;
use crate::convert::numbers::argument;
use crate::convert::{Object, Quantities};
use crate::model::engine::Engine;

/// Rows of one task: neighbours share integrals of their laws, and Ctrl-C waits for a task.
pub(crate) const ROWS_PER_TASK: usize = 16;

/// A model on the scenes of rows.
pub(crate) struct Asked {
    engine: Py<Engine>,
    pub(crate) rows: Rows,
    pub(crate) model: Model,
    /// Quantities and tolerance.
    pub(crate) request: Request,
}

/// What the contact of a scene is, or why it has none.
type Compiled = Result<Arc<dyn Contact>, ContactError>;
/// Rows that failed, with their exceptions, ascending.
pub(crate) type Failures = Vec<(usize, Py<PyAny>)>;
/// What is found in a row; boxed, as there may be millions.
pub(crate) type Found<T> = Result<T, Box<ContactError>>;
/// What is found in every row, none where one fails, and the failures.
pub(crate) type Split<T> = (Vec<Option<T>>, Vec<(usize, ContactError)>);

/// Engine, rows, quantities and tolerance, as the package passes them.
pub(crate) type Arguments<'py> = (Py<Engine>, Rows, Object<'py>, Object<'py>);

impl Asked {
    pub(crate) fn new((engine, rows, quantities, rtol): Arguments<'_>) -> PyResult<Self> {
        rows.check_axis()?;
        let model = engine.get().on_all(&rows.files)?;
        let quantities: Quantities = argument("quantities", &quantities)?;
        let request = quantities.request(argument("rtol", &rtol)?)?;
        Ok(Self { engine, rows, model, request })
    }

    pub(crate) fn engine(&self) -> &Engine {
        self.engine.get()
    }

    /// The model on the scene of a row: curved bodies have one of their own.
    pub(crate) fn model_on(
        &self,
        file: &asperity_scene::SceneFile,
    ) -> Result<Cow<'_, Model>, ContactError> {
        if file.shape().is_none() {
            return Ok(Cow::Borrowed(&self.model));
        }
        let refused = |reason: PyErr| {
            let model = self.model.id().into();
            ContactError::Refused { model, reason: reason.to_string() }
        };
        self.engine().on(file).map(Cow::Owned).map_err(refused)
    }

    /// Rows of one task on a single scene: curved bodies are solved row by row.
    pub(crate) fn together(&self, usual: usize) -> usize {
        if self.rows.are_curved() { 1 } else { usual }
    }

    pub(crate) fn raise(&self, py: Python<'_>, refusal: ContactError) -> PyErr {
        self.engine().raise(py, refusal)
    }

    pub(crate) fn failures(&self, py: Python<'_>, failed: Vec<(usize, ContactError)>) -> Failures {
        let object = |(row, error)| (row, self.raise(py, error).into_value(py).into_any());
        failed.into_iter().map(object).collect()
    }

    /// `of` a contact at each row; few rows of a single scene are not worth a preparation.
    pub(crate) fn each<T: Send>(
        &self,
        py: Python<'_>,
        together: usize,
        stop: bool,
        of: impl Fn(&dyn Contact, usize) -> Result<T, ContactError> + Sync,
    ) -> PyResult<Split<T>> {
        let (model, request) = (&self.model, &self.request);
        let one = self.rows.one_scene().map(|scene| {
            let few = (0..self.rows.len().min(ROWS_PER_TASK)).map(|row| self.rows.at(row));
            self.engine().run(py, || model.contact(scene, &request.clone().at(few)))
        });
        let one: Option<Arc<dyn Contact>> = one.transpose()?.map(Arc::from);
        let compiled = |row| match &one {
            Some(one) => Ok(one.clone()),
            None => {
                let file = self.rows.file_of(row)?;
                self.model_on(&file)?.compile(&file.scene, request).map(Arc::from)
            }
        };
        // Rows of one scene together, which is compiled once.
        let mut order: Vec<usize> = (0..self.rows.len()).collect();
        order.sort_by_key(|row| self.rows.place(*row));
        let run = |range: Range<usize>| {
            let mut held: Option<(usize, Compiled)> = None;
            let one = |&row: &usize| {
                let place = self.rows.place(row);
                let made = match held.take() {
                    Some((known, made)) if known == place => made,
                    _ => compiled(row),
                };
                let found = made.as_ref().map_err(Clone::clone).and_then(|made| of(&**made, row));
                held = Some((place, made));
                Ok(found?)
            };
            order[range].iter().map(one).collect()
        };
        let (found, mut failed) = split(py, (order.len(), together), stop, run)?;
        failed.iter_mut().for_each(|(row, _)| *row = order[*row]);
        failed.sort_by_key(|(row, _)| *row);
        let mut found: Vec<_> = order.into_iter().zip(found).collect();
        found.sort_by_key(|(row, _)| *row);
        Ok((found.into_iter().map(|(_, found)| found).collect(), failed))
    }
}

/// Runs stretches of `together` of `len` rows; with `stop`, ends soon after the first failure.
pub(crate) fn split<T: Send>(
    py: Python<'_>,
    (len, together): (usize, usize),
    stop: bool,
    run: impl Fn(Range<usize>) -> Vec<Found<T>> + Sync,
) -> PyResult<Split<T>> {
    let ends = |found: &Vec<Found<T>>| stop && found.iter().any(Result::is_err);
    let mut failed = vec![];
    let found = run_stretches(py, (len, together), run, ends)?.into_iter().flatten().zip(0..);
    let kept = found.map(|(found, row)| found.map_err(|error| failed.push((row, *error))).ok());
    Ok((kept.collect(), failed))
}

/// Columns as arrays by their names.
pub(crate) fn arrays<'py>(
    py: Python<'py>,
    columns: impl IntoIterator<Item = (impl ToString, Vec<f64>)>,
) -> PyResult<Bound<'py, PyDict>> {
    let columns = columns.into_iter();
    columns
        .map(|(name, column)| (name.to_string(), PyArray1::from_vec(py, column)))
        .into_py_dict(py)
}
