//! Errors and numbers of evaluations: the same in every run, whatever the machine does meanwhile.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Model, Quantity};
use rayon::prelude::*;

use super::cases::Case;
use super::laws::Laws;
use super::methods::{Failure, Method, Setting};
use super::problem::{Problem, is_slope};

/// The worst of some errors: the largest, or the word of a failure.
pub type Worst = Result<f64, Failure>;

/// The larger error; a failure is worse than any, and 0 for what is not 0 is an error of 1.
pub fn worse(a: Worst, b: Worst) -> Worst {
    let number = |worst: Worst| if worst == Err(Failure::Zero) { Ok(1.0) } else { worst };
    match (number(a), number(b)) {
        (Ok(a), Ok(b)) => Ok(a.max(b)),
        (Err(failure), _) | (_, Err(failure)) => Err(failure),
    }
}

/// The cases of the hard grid that ask for the same integral. A stiffness that is the tangent has
/// the tangent's cases beside its own.
#[must_use]
pub fn hard_grid<'a>(cases: &'a [Case], model: &Model, quantity: Quantity) -> Vec<&'a Case> {
    let same = |other: Quantity| {
        other == quantity || (is_slope(model, quantity) && is_slope(model, other))
    };
    let wanted = |case: &&Case| {
        case.on_hard_grid() && case.problem.model.id() == model.id() && same(case.problem.quantity)
    };
    cases.iter().filter(wanted).collect()
}

/// Worst error of a method over some cases.
///
/// # Errors
/// When a case cannot be made ready.
pub fn worst(laws: &Laws, method: &Method, setting: Setting, cases: &[&Case]) -> Result<Worst> {
    let error = |case: &&Case| Ok(case.error(method.prepare(laws, &case.problem, setting)?()));
    let errors = cases.par_iter().map(error).collect::<Result<Vec<Worst>>>()?;
    Ok(errors.into_iter().fold(Ok(0.0), worse))
}

/// Mean number of evaluations over some points; one without an answer counts nothing.
///
/// # Errors
/// When a point cannot be made ready.
pub fn evaluations(
    laws: &Laws,
    method: &Method,
    setting: Setting,
    points: &[Arc<Problem>],
) -> Result<Option<f64>> {
    let count = |point| method.evaluations(laws, point, setting);
    let counts = points.par_iter().map(count).collect::<Result<Vec<_>>>()?;
    Ok(mean(counts.into_iter().flatten()))
}

/// The mean, if there is anything.
#[must_use]
pub fn mean(counts: impl Iterator<Item = usize>) -> Option<f64> {
    let (count, sum) = counts.fold((0, 0), |(count, sum), n| (count + 1, sum + n));
    (count > 0).then(|| sum as f64 / f64::from(count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_worse_than_any_number_and_zero_is_an_error_of_one() {
        assert_eq!(worse(Ok(1e-3), Err(Failure::Zero)), Ok(1.0));
        assert_eq!(worse(Ok(3.0), Err(Failure::Zero)), Ok(3.0));
        assert_eq!(worse(Ok(3.0), Err(Failure::NotFinite)), Err(Failure::NotFinite));
    }
}
