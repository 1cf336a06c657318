//! The table: times and errors of every method and setting.

use std::hint::black_box;
use std::sync::Arc;

use anyhow::{Result, ensure};
use asperity::{Model, Quantity};
use rayon::prelude::*;

use super::cases::{self, Case};
use super::methods::{METHODS, Method};
use super::ours::{self, Laws};
use super::problem::{
    Failure, INTEGRALS, Job, Problem, ZERO, integrated, is_slope, points, tightest,
};
use super::scipy::{Scipy, can_take};
use xtask::figures::report_csv::Row;

/// Loosest first.
const TOLERANCES: [f64; 7] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-13];

/// Every model with every integral.
pub fn pairs() -> Vec<(Model, Quantity)> {
    let of = |model: Model| INTEGRALS.map(|quantity| (model.clone(), quantity));
    Model::of_asperities().into_iter().flat_map(of).collect()
}

/// The worst of some errors: the largest, or a failure.
type Worst = Result<f64, Failure>;

/// Time \[ns\] and worst error of a setting.
type Measured = (Option<f64>, Worst);

/// The larger error; a failure is worse than any error, and the failure "zero" is an error of 1.
fn worse(a: Worst, b: Worst) -> Worst {
    let number = |worst: Worst| if worst == Err(ZERO) { Ok(1.0) } else { worst };
    Ok(number(a)?.max(number(b)?))
}

fn row(
    (model, quantity): &(Model, Quantity),
    method: &str,
    tolerance: Option<f64>,
    (time, worst): Measured,
) -> Row {
    Row {
        model: model.id().into(),
        quantity: quantity.to_string(),
        method: method.into(),
        tolerance: tolerance.map(|tolerance| format!("{tolerance:e}")).unwrap_or_default(),
        median_ns: time.map(significant).unwrap_or_default(),
        max_relative_error: worst.map_or_else(Into::into, |error| format!("{error:.1e}")),
    }
}

/// `speed-vs-error.csv`; with scipy's rows, and with times, if scipy is given.
///
/// # Errors
/// When the library refuses a case, or scipy's process fails.
pub fn write(pairs: &[(Model, Quantity)], scipy: Option<&Scipy>) -> Result<String> {
    let laws = Laws::default();
    let cases = cases::read(&laws, pairs)?;
    let run = Run { laws, cases, scipy };
    let mut csv = csv::Writer::from_writer(vec![]);
    for pair in pairs {
        if scipy.is_some() {
            eprintln!("{} {}", pair.0, pair.1);
        }
        run.rows(pair)?.iter().try_for_each(|row| csv.serialize(row))?;
    }
    Ok(String::from_utf8(csv.into_inner()?)?)
}

struct Run<'a> {
    laws: Laws,
    cases: Vec<Case>,
    scipy: Option<&'a Scipy>,
}

impl Run<'_> {
    /// The cases of the hard grid with the same integral. A stiffness that is the tangent has the
    /// cases of the tangent as well.
    fn grid(&self, (model, quantity): &(Model, Quantity)) -> Vec<&Case> {
        let integral = |quantity| (integrated(model, quantity), is_slope(model, quantity));
        let wanted = |case: &&Case| {
            let Problem { model: other, quantity: of_case, .. } = &*case.problem;
            integral(*of_case) == integral(*quantity) && other.id() == model.id()
        };
        self.cases.iter().filter(wanted).collect()
    }

    /// The rows of our methods, and of scipy for the laws that it can integrate.
    fn rows(&self, pair: &(Model, Quantity)) -> Result<Vec<Row>> {
        let (points, grid) = (points(&pair.0, pair.1)?, self.grid(pair));
        ensure!(!grid.is_empty(), "no hard case of {} {}", pair.0, pair.1);
        let mut rows = vec![];
        let tolerances: Vec<f64> =
            TOLERANCES.into_iter().filter(|t| *t >= tightest(&pair.0)).collect();
        for method in METHODS {
            let settings = tolerances.iter().copied().map(Some).collect();
            for tolerance in if method.1 { settings } else { vec![None] } {
                let found = self.own((method, tolerance), &points, &grid)?;
                rows.push(row(pair, method.0, tolerance, found));
            }
        }
        let can_take = points.iter().all(|point| can_take(point));
        for scipy in self.scipy.into_iter().filter(|_| can_take) {
            for &tolerance in &tolerances {
                let found = by_scipy(scipy, tolerance, &points, &grid)?;
                rows.push(row(pair, "scipy", Some(tolerance), found));
            }
        }
        Ok(rows)
    }

    fn own(
        &self,
        (method, tolerance): (Method, Option<f64>),
        points: &[Arc<Problem>],
        grid: &[&Case],
    ) -> Result<Measured> {
        let tolerance = tolerance.unwrap_or_default();
        let job = |problem: &Arc<Problem>| method.2(&self.laws, problem, tolerance);
        let jobs = points.iter().map(job).collect::<Result<Vec<Job>>>()?;
        // The time of a failure counts as well.
        let all = || {
            jobs.iter().for_each(|job| {
                let _ = black_box(black_box(job)());
            });
        };
        let time = self.scipy.map(|_| ours::median_ns(all) / jobs.len() as f64);
        let errors = grid.par_iter().map(|case| Ok(case.error(job(&case.problem)?())));
        let errors = errors.collect::<Result<Vec<Worst>>>()?;
        Ok((time, errors.into_iter().fold(Ok(0.0), worse)))
    }
}

fn by_scipy(
    scipy: &Scipy,
    tolerance: f64,
    points: &[Arc<Problem>],
    grid: &[&Case],
) -> Result<Measured> {
    let timed = points.iter().map(|point| (tolerance, 5, point.clone()));
    let errors = grid.iter().map(|case| (tolerance, 0, case.problem.clone()));
    let answers = scipy.run(&timed.chain(errors).collect::<Vec<_>>())?;
    let (timed, solved) = answers.split_at(points.len());
    let time = timed.iter().map(|(_, ns)| ns).sum::<f64>() / points.len() as f64;
    let errors = grid.iter().zip(solved).map(|(case, (found, _))| case.error(*found));
    Ok((Some(time), errors.fold(Ok(0.0), worse)))
}

/// A number to three significant digits.
fn significant(number: f64) -> String {
    let decimals = (2.0 - number.abs().max(1e-2).log10().floor()).max(0.0) as usize;
    format!("{number:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failure_is_worse_than_any_number_and_zero_is_an_error_of_one() {
        assert_eq!(worse(Ok(1e-3), Err(ZERO)), Ok(1.0));
        assert_eq!(worse(Ok(3.0), Err(ZERO)), Ok(3.0));
        assert_eq!(worse(Ok(3.0), Err("not-finite")), Err("not-finite"));
    }
}
