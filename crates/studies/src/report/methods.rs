//! The compared methods. Each turns a problem into a job that can be repeated.

use std::sync::Arc;

use anyhow::Result;
use asperity_quadrature::{gauss_kronrod, legendre};

use super::ours::{self, Laws};
use super::problem::{Job, NOT_FINITE, Outcome, Problem, failure};

/// A method of this process: its name in tables, whether it has a tolerance, and how it prepares a
/// problem.
pub type Method = (&'static str, bool, fn(&Laws, &Arc<Problem>, f64) -> Result<Job>);

/// All methods of this process. Polynomials in the separation, built once per scene, and those in
/// separation and scale that serve every scene; an adaptive rule of 21 points, scaled against
/// underflow and split at the kinks; and rules that are common in published scripts, in plain
/// doubles and in metres, not split at the kinks of the law: 64 points on [d, d + 8σ], and
/// parabolas over 200 equal steps on [d, d + 6σ].
pub const METHODS: [Method; 5] = [
    ("compiled", true, |laws, problem, tolerance| ours::compiled(laws, problem, tolerance)),
    ("rule", true, |laws, problem, tolerance| ours::rule(laws, problem, tolerance)),
    ("gauss-kronrod", true, |_, problem, tolerance| Ok(adaptive(problem.clone(), tolerance))),
    ("gauss-legendre-64", false, |_, problem, _| {
        let legendre = legendre(64);
        let nodes = legendre.nodes.iter().copied().zip(legendre.weights.iter().copied());
        Ok(plain(problem.clone(), 8.0, nodes.collect()))
    }),
    ("simpson", false, |_, problem, _| Ok(plain(problem.clone(), 6.0, simpson(200)))),
];

/// Largest number of evaluations for one integral.
const LIMIT: usize = 20_000;

/// The method of a script: one rule on a fixed range, plain doubles.
fn plain(problem: Arc<Problem>, sigmas: f64, rule: Vec<(f64, f64)>) -> Job {
    Box::new(move || {
        let (start, width) = (problem.separation * problem.std(), sigmas * problem.std());
        let terms = rule.iter().map(|(x, w)| w * problem.plain_integrand(start + width * x));
        let value = problem.in_units(width * terms.sum::<f64>());
        let found = Outcome { value, scaled: false };
        if value.is_finite() { Ok(found) } else { Err(NOT_FINITE) }
    })
}

/// Parts of different sign are integrated separately, so that a tolerance relative to each can be
/// met where they cancel.
fn adaptive(problem: Arc<Problem>, tolerance: f64) -> Job {
    let has = |sign: f64| problem.law.parts.iter().any(|part| part.sign * sign > 0.0);
    let signs = match has(1.0) && has(-1.0) {
        true => vec![Some(1.0), Some(-1.0)],
        false => vec![None],
    };
    Box::new(move || {
        let (breaks, scale) = (problem.breaks(), problem.scale());
        let mut sum = 0.0;
        for sign in &signs {
            let integrand = |t: f64| problem.law_at(t / scale, *sign) * problem.weight(t);
            sum += gauss_kronrod(integrand, &breaks, tolerance, LIMIT).map_err(failure)?.value;
        }
        Ok(Outcome { value: problem.in_units(sum), scaled: true })
    })
}

/// Simpson's points of [0, 1] with their weights.
fn simpson(steps: u32) -> Vec<(f64, f64)> {
    let count = f64::from(steps);
    let weight = |k| match k {
        end if end == 0 || end == steps => 1.0,
        odd if odd % 2 == 1 => 4.0,
        _ => 2.0,
    };
    (0..=steps).map(|k| (f64::from(k) / count, weight(k) / (3.0 * count))).collect()
}
