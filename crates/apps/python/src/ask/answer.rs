//! Evaluation of rows: on all cores and in order.

use std::ops::Range;

use asperity::{
    Contact, ContactError, ContactModel, Evaluation, Finding, Quantity, Request, Response,
    RowCheck, Sweep,
};
use pyo3::prelude::*;

use crate::ask::asked::{Asked, ROWS_PER_TASK};
use crate::ask::long::run_stretches;

/// Rows of one task on a single scene, where most rows are fast.
pub(crate) const ROWS_PER_TASK_ON_ONE_SCENE: usize = 256;

/// The number read from every evaluation: the value, its logarithm or the bound on its error.
pub(crate) type Aspect = fn(&Evaluation, Quantity) -> f64;

/// Columns in the order of the quantities, NaN for missing values; failed rows with the reasons,
/// ascending; and findings.
#[derive(Default)]
pub(crate) struct Answer {
    pub(crate) columns: Vec<Vec<f64>>,
    pub(crate) failures: Vec<(usize, ContactError)>,
    pub(crate) warnings: Vec<Finding>,
}

impl Answer {
    fn append(&mut self, next: Self) {
        self.columns.resize_with(next.columns.len(), Vec::new);
        self.columns.iter_mut().zip(next.columns).for_each(|(column, next)| column.extend(next));
        self.failures.extend(next.failures);
        self.warnings.extend(next.warnings);
    }
}

impl Asked {
    /// Evaluates all rows, for an aspect that may be the value; with `stop`, ends soon after the
    /// first failure.
    pub(crate) fn answer(
        &self,
        py: Python<'_>,
        (aspect, is_value): (Aspect, bool),
        stop: bool,
    ) -> PyResult<Answer> {
        let len = self.rows.len();
        let ends = |found: &Answer| stop && !found.failures.is_empty();
        let found = match self.rows.one_scene() {
            Some(scene) => {
                let few = len <= ROWS_PER_TASK_ON_ONE_SCENE;
                let contact = self.engine().run(py, || match few {
                    true => self.model.contact(scene, &self.request_at(0..len)),
                    false => self.model.compile(scene, &self.request_at(0..1)),
                })?;
                let run = |range: Range<usize>| {
                    let many = (is_value && !few).then(|| self.filled(&*contact, range.clone()));
                    many.flatten().unwrap_or_else(|| {
                        self.read(aspect, range.start, contact.respond(&self.request_at(range)))
                    })
                };
                run_stretches(py, (len, self.together(ROWS_PER_TASK_ON_ONE_SCENE)), run, ends)?
            }
            None if self.rows.are_curved() => {
                run_stretches(py, (len, 1), |range| self.alone(aspect, range.start), ends)?
            }
            None => {
                let sweep =
                    Sweep::new(&self.model, &self.request.quantities, self.request.tolerance);
                let run = |range| self.on_many(aspect, &sweep, range);
                run_stretches(py, (len, ROWS_PER_TASK), run, ends)?
            }
        };
        let mut answer = Answer::default();
        found.into_iter().for_each(|found| answer.append(found));
        Ok(answer)
    }

    fn request_at(&self, range: Range<usize>) -> Request {
        self.request.clone().at(range.map(|row| self.rows.at(row)))
    }

    /// The values of a row that shares nothing with others.
    fn alone(&self, aspect: Aspect, row: usize) -> Answer {
        let response = || {
            let file = self.rows.file_of(row)?;
            self.model_on(&file)?.solve(&file.scene, &self.request_at(row..row + 1))
        };
        let refused = |error| {
            let columns = vec![vec![f64::NAN]; self.request.quantities.len()];
            Answer { columns, failures: vec![(row, error)], warnings: vec![] }
        };
        response().map_or_else(refused, |found| self.read(aspect, row, found))
    }

    /// Many values at once; none if one of them needs a finding.
    fn filled(&self, contact: &dyn Contact, range: Range<usize>) -> Option<Answer> {
        let quantities = &self.request.quantities[..];
        let places = self.rows.sigmas(range, contact.scene())?;
        let (columns, cancels) = filled(contact, quantities, &places)?;
        let usual = |(quantity, column): (&Quantity, &Vec<f64>)| {
            let most = match quantity {
                Quantity::Area => contact.scene().nominal_area,
                Quantity::AreaFraction => 1.0,
                _ => f64::INFINITY,
            };
            column.iter().all(|value| *value > 0.0 && *value <= most)
        };
        let usual = !cancels && quantities.iter().zip(&columns).all(usual);
        usual.then(|| Answer { columns, ..Answer::default() })
    }

    /// The values of a response to rows from `first` on.
    fn read(&self, aspect: Aspect, first: usize, response: Response) -> Answer {
        let mut found = Answer { warnings: response.warnings, ..Answer::default() };
        for column in response.columns {
            let values = column.rows.into_iter().zip(first..).map(|(value, row)| match value {
                Ok(value) => aspect(&value, column.quantity),
                Err(error) => {
                    found.failures.push((row, *error));
                    f64::NAN
                }
            });
            found.columns.push(values.collect());
        }
        found.failures.sort_by_key(|(row, _)| *row);
        found.failures.dedup_by_key(|(row, _)| *row);
        found
    }

    fn on_many(&self, aspect: Aspect, sweep: &Sweep<'_>, range: Range<usize>) -> Answer {
        let quantities = &self.request.quantities;
        let mut found = Answer { columns: vec![vec![]; quantities.len()], ..Answer::default() };
        let mut check = RowCheck::new(self.model.validity().adhesive);
        for (row, case, answer) in self.rows.evaluate(range, |cases| sweep.evaluate_all(cases)) {
            match (answer, &case) {
                (Ok(values), Some(case)) => {
                    for (k, (quantity, value)) in quantities.iter().zip(values).enumerate() {
                        check.check(*quantity, Ok(&value), case.at, &case.scene, |_| None);
                        found.columns[k].push(aspect(&value, *quantity));
                    }
                }
                // Other quantities of a refused row may have values.
                _ => found.append(self.alone(aspect, row)),
            }
        }
        found.warnings.extend(check.finish(self.model.id()));
        found
    }
}

/// Columns of quantities at separations, multiples of σ_z from the mean of the asperity heights,
/// and whether values cancel; none if one of them needs more than a number.
pub(crate) fn filled(
    contact: &dyn Contact,
    quantities: &[Quantity],
    places: &[f64],
) -> Option<(Vec<Vec<f64>>, bool)> {
    let mut columns = vec![vec![0.0; places.len()]; quantities.len()];
    let mut out: Vec<&mut [f64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
    let absolute = quantities.iter().any(|quantity| quantity.is_absolute());
    let filled = (!absolute).then(|| contact.fill(quantities, places, &mut out).ok()).flatten()?;
    Some((columns, filled.cancels()))
}
