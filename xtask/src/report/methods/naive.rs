//! What published scripts do: a fixed rule on a fixed range above the separation, in plain doubles,
//! in metres, blind to the kinks of the law.

use std::sync::Arc;

use anyhow::Result;
use asperity_quadrature::legendre;

use super::{Failure, Job, Kind, Method, Outcome, Setting};
use crate::report::laws::Laws;
use crate::report::problem::Problem;

pub(super) const METHODS: [Method; 3] = [
    Method {
        name: "gauss-legendre-64",
        what: "64 points on [d, d+8σ], plain doubles",
        kind: Kind::Fixed,
        prepare: gauss_legendre,
        count: None,
    },
    Method {
        name: "trapezoid-1001",
        what: "1001 points on [d, d+6σ], plain doubles",
        kind: Kind::Fixed,
        prepare: trapezoid,
        count: None,
    },
    Method {
        name: "simpson",
        what: "composite, 200 intervals on [d, d+6σ], plain doubles",
        kind: Kind::Fixed,
        prepare: simpson,
        count: None,
    },
];

/// Turns a weighted sum over [d, d + `sigmas` σ] into a job. `sum` gets the start and the width.
fn job(
    problem: &Arc<Problem>,
    sigmas: f64,
    evaluations: usize,
    sum: impl Fn(&Problem, f64, f64) -> f64 + Send + Sync + 'static,
) -> Job {
    let problem = problem.clone();
    Box::new(move || {
        let integral = sum(&problem, problem.plain_start(), sigmas * problem.std());
        let value = problem.in_units(integral);
        if !value.is_finite() {
            return Err(Failure::NotFinite);
        }
        Ok(Outcome { value, scaled: false, evaluations: Some(evaluations) })
    })
}

fn gauss_legendre(_: &Laws, problem: &Arc<Problem>, _: Setting) -> Result<Job> {
    let rule = legendre(64);
    Ok(job(problem, 8.0, 64, move |problem, start, width| {
        let terms = rule.nodes.iter().zip(&rule.weights);
        terms.map(|(x, w)| width * w * problem.plain_integrand(start + width * x)).sum()
    }))
}

fn trapezoid(_: &Laws, problem: &Arc<Problem>, _: Setting) -> Result<Job> {
    Ok(job(problem, 6.0, 1001, |problem, start, width| {
        let step = width / 1000.0;
        let inner: f64 =
            (1..1000).map(|k| problem.plain_integrand(start + f64::from(k) * step)).sum();
        let ends = problem.plain_integrand(start) + problem.plain_integrand(start + width);
        step * (inner + 0.5 * ends)
    }))
}

fn simpson(_: &Laws, problem: &Arc<Problem>, _: Setting) -> Result<Job> {
    Ok(job(problem, 6.0, 201, |problem, start, width| {
        let step = width / 200.0;
        let inner: f64 = (1..200)
            .map(|k| {
                let weight = if k % 2 == 1 { 4.0 } else { 2.0 };
                weight * problem.plain_integrand(start + f64::from(k) * step)
            })
            .sum();
        let ends = problem.plain_integrand(start) + problem.plain_integrand(start + width);
        step / 3.0 * (inner + ends)
    }))
}
