//! The compared methods. Each turns a problem into a job that can be repeated.

use std::sync::Arc;

use anyhow::Result;
use asperity_quadrature::{gauss_kronrod, legendre};

use super::ours::{self, Laws};
use super::problem::{Job, NOT_FINITE, Outcome, Problem, failure};

/// A method of this process.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Polynomials in the separation, built once per scene.
    Compiled,
    /// The same without a compiled scene: polynomials in separation and scale serve every scene.
    Rule,
    /// Adaptive, of 21 points, scaled against underflow and split at the kinks.
    GaussKronrod,
    /// 64 points on [d, d + 8σ], in plain doubles and in metres, not split at the kinks of the
    /// law: common in published scripts, like the next.
    Legendre64,
    /// Parabolas over 200 equal steps on [d, d + 6σ].
    Simpson,
}

/// All methods of this process, with their names in tables.
pub const METHODS: [(Method, &str); 5] = [
    (Method::Compiled, "compiled"),
    (Method::Rule, "rule"),
    (Method::GaussKronrod, "gauss-kronrod"),
    (Method::Legendre64, "gauss-legendre-64"),
    (Method::Simpson, "simpson"),
];

/// Largest number of evaluations for one integral.
const LIMIT: usize = 20_000;

impl Method {
    /// The tolerances of its rows of the table, of these; the rules of scripts have none.
    #[must_use]
    pub fn settings(self, tolerances: &[f64]) -> Vec<Option<f64>> {
        match self {
            Self::Legendre64 | Self::Simpson => vec![None],
            _ => tolerances.iter().copied().map(Some).collect(),
        }
    }

    /// Prepares a problem.
    ///
    /// # Errors
    /// What the library refuses.
    pub fn prepare(
        self,
        laws: &Laws,
        problem: &Arc<Problem>,
        tolerance: Option<f64>,
    ) -> Result<Job> {
        match (self, tolerance) {
            (Self::Compiled, Some(tolerance)) => ours::compiled(laws, problem, tolerance),
            (Self::Rule, Some(tolerance)) => ours::rule(laws, problem, tolerance),
            (_, Some(tolerance)) => Ok(adaptive(problem.clone(), tolerance)),
            (_, None) => Ok(self.plain(problem.clone())),
        }
    }

    /// The method of a script: one rule on a fixed range, plain doubles.
    fn plain(self, problem: Arc<Problem>) -> Job {
        let (sigmas, rule) = match self {
            Self::Simpson => (6.0, simpson(200)),
            _ => {
                let legendre = legendre(64);
                let nodes = legendre.nodes.iter().zip(&legendre.weights);
                (8.0, nodes.map(|(x, w)| (*x, *w)).collect())
            }
        };
        Box::new(move || {
            let (start, width) = (problem.separation * problem.std(), sigmas * problem.std());
            let terms = rule.iter().map(|(x, w)| w * problem.plain_integrand(start + width * x));
            let value = problem.in_units(width * terms.sum::<f64>());
            let found = Outcome { value, scaled: false };
            if value.is_finite() { Ok(found) } else { Err(NOT_FINITE) }
        })
    }
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
