//! A stiffness that explains the data, where the one that its column names does not.

use asperity_core::Quantity;

use crate::distance::rms;
use crate::forward::Forward;
use crate::outlier::rounded;
use crate::problem::{Minimum, Problem};
use crate::{FitError, Measured, Observation};

/// Stiffnesses that are taken for each other: on loading, and at the start of unloading.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::Stiffness];
/// No column is doubted where the root mean square of ln(fitted/measured) is smaller.
const SMALL: f64 = 0.05;
/// Another stiffness explains the data if it leaves less than this share of the misfit.
const SHARE: f64 = 0.2;
/// Evaluations for each free parameter before the search with another stiffness gives up.
const PATIENCE: usize = 60;

/// A sentence about a column of stiffnesses whose values are rather those of another one.
pub(crate) fn other_stiffness(
    problem: &Problem<'_>,
    best: &Minimum,
    values: &[f64],
) -> Result<Option<String>, FitError> {
    let Some(here) = rms(problem.data, values).filter(|rms| *rms > SMALL) else { return Ok(None) };
    let is_given = |quantity: &Quantity| {
        problem.data.iter().any(|one| one.measured == Measured::Quantity(*quantity))
    };
    let (given, others): (Vec<_>, Vec<_>) = STIFFNESSES.into_iter().partition(is_given);
    let (mut least, mut found) = (SHARE * here, None);
    for column in given {
        for &other in &others {
            if let Some(rms) = rms_as(problem, best, [column, other])?.filter(|rms| *rms < least) {
                (least, found) = (rms, Some([column, other].map(Quantity::column)));
            }
        }
    }
    Ok(found.map(|[column, other]| {
        let [here, there] = [here, least].map(|rms| rounded(100.0 * rms));
        format!(
            "{column} deviates by {here} % from the fit (root mean square), and by {there} % if it is {other}; name the column by the stiffness that was measured"
        )
    }))
}

/// The misfit with one stiffness taken for another; `None` where the model does not have it.
fn rms_as(
    problem: &Problem<'_>,
    best: &Minimum,
    [column, other]: [Quantity; 2],
) -> Result<Option<f64>, FitError> {
    let renamed = |one: &Observation| match one.measured == Measured::Quantity(column) {
        true => Observation { measured: Measured::Quantity(other), ..*one },
        false => *one,
    };
    let data = problem.data.with(problem.data.iter().map(renamed).collect());
    let Ok(forward) = Forward::new(problem.model, &data) else { return Ok(None) };
    let other = Problem { data: &data, forward: &forward, ..*problem };
    let all: Vec<usize> = (0..problem.parameters.len()).collect();
    let minimum = other.minimise(&best.coordinates, &all, PATIENCE)?;
    let values = other.predicted(&minimum.coordinates).ok();
    Ok(values.and_then(|values| rms(&data, &values)))
}
