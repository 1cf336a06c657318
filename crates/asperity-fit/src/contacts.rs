//! Numbers of contacts of a fit.

use asperity_core::Quantity;

use crate::forward::Forward;
use crate::problem::Problem;
use crate::{Measured, Observation};

/// The number of contacts in each row; `None` for models that do not count them.
pub(crate) fn counts(problem: &Problem<'_>, coordinates: &[f64]) -> Option<Vec<f64>> {
    let measured = Measured::Quantity(Quantity::Contacts);
    let counted = |one: &Observation| Observation { measured, value: 1.0, std: None, ..*one };
    let data = problem.data.with(problem.data.iter().map(counted).collect());
    let forward = Forward::new(problem.model, &data).ok()?;
    Problem { data: &data, forward: &forward, ..*problem }.predicted(coordinates).ok()
}

/// Whether a fit has a contact in every row, or its model does not count them.
pub(crate) fn has_contacts(problem: &Problem<'_>, coordinates: &[f64]) -> bool {
    counts(problem, coordinates).is_none_or(|counts| counts.iter().all(|count| *count >= 1.0))
}
