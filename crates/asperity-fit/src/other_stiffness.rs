//! A stiffness that explains the data, where the one that its column names does not.

use asperity_core::Quantity;

use crate::distance::rms;
use crate::forward::Forward;
use crate::outlier::rounded;
use crate::problem::{Minimum, Problem};
use crate::ranking::bic;
use crate::{FitError, Measured, Observation};

/// Stiffnesses that are taken for each other: on loading, and at the start of unloading.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::Stiffness];
/// Largest share of the misfit that another stiffness leaves which explains the data: errors of the
/// model itself make smaller differences.
const SHARE: f64 = 0.6;
/// Least difference of the Bayesian criterion in favour of a stiffness that explains the data: odds
/// of 150 to 1, which the scatter of a few data does not give.
const CLEAR: f64 = 10.0;
/// Evaluations for each free parameter before the search with another stiffness gives up.
const PATIENCE: usize = 60;

/// A sentence about a column of stiffnesses whose values are rather those of another one.
pub(crate) fn other_stiffness(
    problem: &Problem<'_>,
    best: &Minimum,
    values: &[f64],
    rank: usize,
) -> Result<Option<String>, FitError> {
    let (data, Some(here)) = (problem.data, rms(problem.data, values)) else { return Ok(None) };
    let is_given =
        |quantity: &Quantity| data.iter().any(|one| one.measured == Measured::Quantity(*quantity));
    let (given, others): (Vec<_>, Vec<_>) = STIFFNESSES.into_iter().partition(is_given);
    let (mut least, mut found) = (SHARE * here, None);
    for column in given {
        for &other in &others {
            let Some((rms, squares)) = fitted_as(problem, best, [column, other])? else { continue };
            let gain = bic(data, best.squares, rank).zip(bic(data, squares, rank));
            if rms < least && gain.is_some_and(|(here, there)| here - there > CLEAR) {
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

/// The misfit and the sum of squares with one stiffness taken for another; `None` where the model
/// does not have it.
fn fitted_as(
    problem: &Problem<'_>,
    best: &Minimum,
    [column, other]: [Quantity; 2],
) -> Result<Option<(f64, f64)>, FitError> {
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
    Ok(values.and_then(|values| rms(&data, &values)).zip(Some(minimum.squares)))
}
