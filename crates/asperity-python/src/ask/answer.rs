//! Evaluation of rows: on all cores, in order, and interruptible by Ctrl-C.

use std::ops::Range;
use std::sync::Arc;

use asperity::{
    At, Case, ContactError, ContactModel, Evaluation, Finding, Findings, Model, Quantity, Request,
    Response, RowCheck, Scene, Sweep,
};
use pyo3::prelude::*;
use rayon::prelude::*;

use crate::ask::long::{in_blocks, pool, run_stretches};
use crate::ask::rows::View;
use crate::convert::error::value_error;

/// Rows of one task: neighbours share integrals of their laws, and Ctrl-C waits for a task.
pub(crate) const ROWS_PER_TASK: usize = 16;
/// Rows of one task on a single scene, where most rows are fast.
const ROWS_PER_TASK_ON_ONE_SCENE: usize = 256;
/// Values of one task, where they go into plain arrays: fewer take less time than to wake a thread.
const VALUES_PER_TASK: usize = 16_384;
/// Fewer values are as fast one by one.
const FEW: usize = 16;

/// The number read from every evaluation.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Aspect {
    Value,
    Ln,
    Error,
}

impl Aspect {
    fn of(self, evaluation: &Evaluation, quantity: Quantity) -> f64 {
        match self {
            Self::Value => evaluation.value(),
            Self::Ln => evaluation.ln_value(),
            Self::Error => evaluation.bound(quantity),
        }
    }
}

impl<'py> FromPyObject<'_, 'py> for Aspect {
    type Error = PyErr;

    fn extract(name: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        match name.extract()? {
            "value" => Ok(Self::Value),
            "ln" => Ok(Self::Ln),
            "error" => Ok(Self::Error),
            other => Err(value_error(format!("{other:?} is no aspect of a value"))),
        }
    }
}

/// The source of the values: a compiled contact, or a model.
pub(crate) enum Source<'m> {
    Contact(Arc<dyn asperity::Contact>),
    Model(&'m Model),
}

/// Rows, the model or contact that evaluates them, and the request.
pub(crate) struct Question<'q> {
    pub(crate) rows: &'q View<'q>,
    pub(crate) source: Source<'q>,
    /// Quantities and tolerance.
    pub(crate) request: Request,
    pub(crate) aspect: Aspect,
}

/// Columns in the order of the quantities, NaN for missing values; failed rows with their
/// exceptions, ascending; and findings.
#[derive(Default)]
pub(crate) struct Answer {
    pub(crate) columns: Vec<Vec<f64>>,
    pub(crate) failures: Vec<(usize, PyErr)>,
    pub(crate) warnings: Findings,
}

/// Values, failures and findings of a task, row by row.
#[derive(Default)]
struct TaskValues {
    values: Vec<f64>,
    failures: Vec<(usize, ContactError)>,
    warnings: Vec<Finding>,
}

/// A row, its place and its scene.
struct RowCase<'h> {
    row: usize,
    at: At,
    scene: &'h Scene,
}

impl TaskValues {
    /// Adds the next value. Other quantities of a failed row may have values.
    fn push(
        &mut self,
        case: &RowCase<'_>,
        quantity: Quantity,
        value: Result<Evaluation, ContactError>,
        aspect: Aspect,
        check: &mut RowCheck,
    ) {
        let &RowCase { row, at, scene } = case;
        check.check(quantity, value.as_ref(), at, scene, |_| None);
        match value {
            Ok(value) => self.values.push(aspect.of(&value, quantity)),
            Err(error) => {
                self.values.push(f64::NAN);
                if self.failures.last().is_none_or(|(last, _)| *last != row) {
                    self.failures.push((row, error));
                }
            }
        }
    }
}

impl Question<'_> {
    /// Evaluates all rows; with `stop`, ends at the first failure.
    pub(crate) fn answer(
        &self,
        py: Python<'_>,
        threads: Option<usize>,
        stop: bool,
        raise: impl Fn(ContactError) -> PyErr + Copy,
    ) -> PyResult<Answer> {
        let (len, quantities) = (self.rows.len(), self.request.quantities.len());
        let mut answer = Answer::default();
        answer.columns.resize_with(quantities, || Vec::with_capacity(len));
        let mut take = |found: TaskValues| {
            if let [column] = &mut answer.columns[..] {
                column.extend_from_slice(&found.values);
            } else {
                for row in found.values.chunks_exact(quantities) {
                    answer.columns.iter_mut().zip(row).for_each(|(column, v)| column.push(*v));
                }
            }
            answer.warnings.extend(found.warnings);
            answer.failures.extend(found.failures.into_iter().map(|(row, e)| (row, raise(e))));
            Ok(!stop || answer.failures.is_empty())
        };
        let few = len <= ROWS_PER_TASK_ON_ONE_SCENE;
        let at = |range: Range<usize>| range.map(|row| self.rows.at(row));
        let request = |range| self.request.clone().at(at(range));
        match (&self.source, self.rows.one_scene()) {
            // Waking threads takes longer than a few rows.
            (Source::Contact(contact), _) if few => {
                take(py.detach(|| self.on_one(&**contact, 0..len)))?;
            }
            (Source::Model(model), Some(scene)) if few => {
                let response = py.detach(|| model.solve(scene, &request(0..len)));
                take(self.response_values(0, response.map_err(raise)?))?;
            }
            (Source::Contact(contact), _) => {
                let run = |range| self.on_one(&**contact, range);
                run_stretches(py, &*pool(threads)?, len, ROWS_PER_TASK_ON_ONE_SCENE, run, take)?;
            }
            (Source::Model(model), Some(scene)) => {
                let contact = py.detach(|| model.compile(scene, &request(0..1)));
                let contact = contact.map_err(raise)?;
                let run = |range| self.on_one(&*contact, range);
                run_stretches(py, &*pool(threads)?, len, ROWS_PER_TASK_ON_ONE_SCENE, run, take)?;
            }
            (Source::Model(model), None) => {
                let sweep = Sweep::new(*model, &self.request.quantities, self.request.tolerance);
                let run = |range| self.on_many(model, &sweep, range);
                run_stretches(py, &*pool(threads)?, len, ROWS_PER_TASK, run, take)?;
            }
        }
        Ok(answer)
    }

    /// The values of one quantity, without findings; false, with nothing of use in the column,
    /// if that is not possible for all rows.
    pub(crate) fn fill(
        &self,
        py: Python<'_>,
        contact: &dyn asperity::Contact,
        quantity: Quantity,
        column: &mut [f64],
    ) -> PyResult<bool> {
        if !self.rows.are_separations() || quantity.is_absolute() || column.len() < FEW {
            return Ok(false);
        }
        let fill = |start: usize, out: &mut [f64]| {
            let places = self.rows.sigmas(start..start + out.len(), contact.scene());
            places.is_some_and(|places| contact.fill(&[quantity], &places, &mut [out]).is_ok())
        };
        if column.len() <= VALUES_PER_TASK {
            return Ok(py.detach(|| fill(0, column)));
        }
        let (pool, mut filled) = (pool(None)?, true);
        in_blocks(py, column.len(), 2 * VALUES_PER_TASK, |range| {
            let start = range.start;
            let tasks = column[range].par_chunks_mut(VALUES_PER_TASK).enumerate();
            let task = |(k, out): (usize, &mut [f64])| fill(start + k * VALUES_PER_TASK, out);
            filled = py.detach(|| pool.install(|| tasks.map(task).all(|filled| filled)));
            Ok(filled)
        })?;
        Ok(filled)
    }

    fn on_one(&self, contact: &dyn asperity::Contact, range: Range<usize>) -> TaskValues {
        let (first, quantities) = (range.start, &self.request.quantities[..]);
        if !self.rows.are_separations() || quantities.iter().any(|q| q.is_absolute()) {
            let request = self.request.clone().at(range.map(|row| self.rows.at(row)));
            return self.response_values(first, contact.respond(&request));
        }
        if let Some(values) = self.fill_columns(contact, range.clone()) {
            return TaskValues { values, ..TaskValues::default() };
        }
        // Value by value: a response would hold more data than needed.
        let mut found = TaskValues::default();
        let mut check = RowCheck::new(contact.is_adhesive());
        for row in range {
            let at = self.rows.at(row);
            let case = RowCase { row, at, scene: contact.scene() };
            let mut push =
                |quantity, value| found.push(&case, quantity, value, self.aspect, &mut check);
            if let [Quantity::Force, Quantity::Tangent] = quantities
                && let Ok((force, tangent)) = contact.force_and_tangent_at(at)
            {
                push(Quantity::Force, Ok(force));
                push(Quantity::Tangent, Ok(tangent));
            } else {
                quantities.iter().for_each(|&q| push(q, contact.evaluate_at(q, at)));
            }
        }
        found.warnings = check.finish(contact.model());
        found
    }

    /// Many values at once; none if one of them needs a finding.
    fn fill_columns(
        &self,
        contact: &dyn asperity::Contact,
        range: Range<usize>,
    ) -> Option<Vec<f64>> {
        let quantities = &self.request.quantities[..];
        if self.aspect != Aspect::Value || self.rows.len() < FEW {
            return None;
        }
        let places = self.rows.sigmas(range, contact.scene())?;
        let mut columns = vec![vec![0.0; places.len()]; quantities.len()];
        let mut out: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let filled = contact.fill(quantities, &places, &mut out).ok()?;
        let usual = |(quantity, column): (&Quantity, &Vec<f64>)| {
            let most = match quantity {
                Quantity::Area => contact.scene().nominal_area,
                Quantity::AreaFraction => 1.0,
                _ => f64::INFINITY,
            };
            column.iter().all(|value| *value > 0.0 && *value <= most)
        };
        let usual = quantities.iter().zip(&columns).all(usual);
        if !usual || filled.cancels() {
            return None;
        }
        if let [_] = quantities {
            return columns.pop();
        }
        let rows = (0..places.len()).flat_map(|row| columns.iter().map(move |column| column[row]));
        Some(rows.collect())
    }

    /// The values of a response to rows from `first` on.
    fn response_values(&self, first: usize, response: Response) -> TaskValues {
        let count = response.columns.len();
        let values = vec![f64::NAN; response.at.len() * count];
        let mut found = TaskValues { values, ..TaskValues::default() };
        for (j, column) in response.columns.into_iter().enumerate() {
            for (k, row) in column.rows.into_iter().enumerate() {
                match row {
                    Ok(value) => {
                        found.values[k * count + j] = self.aspect.of(&value, column.quantity)
                    }
                    Err(error) => found.failures.push((first + k, *error)),
                }
            }
        }
        found.failures.sort_by_key(|(row, _)| *row);
        found.failures.dedup_by_key(|(row, _)| *row);
        found.warnings = response.warnings;
        found
    }

    fn on_many(&self, model: &Model, sweep: &Sweep<'_>, range: Range<usize>) -> TaskValues {
        let (mut found, quantities) = (TaskValues::default(), &self.request.quantities);
        let mut check = RowCheck::new(model.validity().adhesive);
        for (row, case, answer) in
            evaluate_cases(self.rows, range, |cases| sweep.evaluate_all(cases))
        {
            let Some(Case { scene, at, .. }) = case else {
                found.values.extend(quantities.iter().map(|_| f64::NAN));
                found.failures.extend(answer.err().map(|error| (row, error)));
                continue;
            };
            let case = RowCase { row, at, scene: &scene };
            let alone = || model.compile(&scene, &self.request.clone().at([at]));
            let alone = answer.as_ref().err().map(|_| alone());
            for (k, &quantity) in quantities.iter().enumerate() {
                let value = match (&answer, &alone) {
                    (Ok(values), _) => Ok(values[k]),
                    (_, Some(Ok(contact))) => contact.evaluate_at(quantity, at),
                    (Err(error), _) => Err(error.clone()),
                };
                found.push(&case, quantity, value, self.aspect, &mut check);
            }
        }
        found.warnings = check.finish(model.name());
        found
    }
}

/// Rows with their cases and the results of `evaluate`; no case if its scene is refused.
pub(crate) fn evaluate_cases<T>(
    rows: &View<'_>,
    range: Range<usize>,
    evaluate: impl FnOnce(&[Case]) -> Vec<Result<T, ContactError>>,
) -> Vec<(usize, Option<Case>, Result<T, ContactError>)> {
    let (mut places, mut cases, mut found) = (vec![], vec![], vec![]);
    for row in range {
        match rows.case(row) {
            Ok(case) => {
                places.push(row);
                cases.push(case);
            }
            Err(error) => found.push((row, None, Err(error))),
        }
    }
    let results = evaluate(&cases);
    let evaluated = places.into_iter().zip(cases).zip(results);
    found.extend(evaluated.map(|((row, case), result)| (row, Some(case), result)));
    found.sort_by_key(|(row, _, _)| *row);
    found
}
