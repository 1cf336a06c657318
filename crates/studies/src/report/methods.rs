//! The compared methods. Each turns a problem into a job that can be repeated.

use std::sync::Arc;

use anyhow::Result;
use asperity_quadrature::{Point, TanhSinh, gauss_kronrod, legendre};

use super::ours::{self, Laws};
use super::problem::{Failure, Job, NOT_FINITE, Outcome, Problem, failure};

/// The setting of a method in one row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Setting {
    /// A relative tolerance.
    Tolerance(f64),
    /// A number of points on each panel.
    Points(usize),
    /// No setting.
    Fixed,
}

/// A method of this process.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Polynomials in the separation, built once per scene.
    Compiled,
    /// The same without a compiled scene: polynomials in separation and scale serve every scene.
    Rule,
    /// Adaptive. This and the next two are scaled against underflow and split at the kinks.
    GaussKronrod,
    /// Levels until two in a row agree.
    TanhSinh,
    /// A fixed rule between kinks.
    Split,
    /// A fixed rule on a fixed range above the separation, in plain doubles and in metres, not
    /// split at the kinks of the law: common in published scripts, like the next two.
    Legendre64,
    /// Equal steps.
    Trapezoid,
    /// Equal steps, parabolas.
    Simpson,
}

/// All methods of this process, with their names in tables and their descriptions.
pub const METHODS: [(Method, &str, &str); 8] = [
    (Method::Compiled, "compiled", "ours, scene compiled: per evaluation"),
    (Method::Rule, "rule", "ours, law built, scene not compiled (as in `Sweep`)"),
    (Method::GaussKronrod, "gauss-kronrod", "adaptive, 21 points, scaled, split at the kinks"),
    (Method::TanhSinh, "tanh-sinh", "levels until they agree, scaled, split at the kinks"),
    (Method::Split, "gauss-legendre-split", "16 to 128 points between kinks, scaled"),
    (Method::Legendre64, "gauss-legendre-64", "64 points on [d, d+8σ], plain doubles"),
    (Method::Trapezoid, "trapezoid-1001", "1001 points on [d, d+6σ], plain doubles"),
    (Method::Simpson, "simpson", "composite, 200 intervals on [d, d+6σ], plain doubles"),
];

/// The tolerance on the hard cases, of methods that have one.
pub const HARD_TOLERANCE: f64 = 1e-10;
/// Largest number of evaluations for one integral.
const LIMIT: usize = 20_000;

impl Method {
    /// The settings, row by row, for these tolerances and numbers of points.
    #[must_use]
    pub fn settings(self, tolerances: &[f64], points: &[usize]) -> Vec<Setting> {
        match self {
            Self::Split => points.iter().copied().map(Setting::Points).collect(),
            Self::Legendre64 | Self::Trapezoid | Self::Simpson => vec![Setting::Fixed],
            _ => tolerances.iter().copied().map(Setting::Tolerance).collect(),
        }
    }

    /// Prepares a problem.
    ///
    /// # Errors
    /// What the library refuses.
    pub fn prepare(self, laws: &Laws, problem: &Arc<Problem>, setting: Setting) -> Result<Job> {
        match (self, setting) {
            (Self::Compiled, Setting::Tolerance(t)) => ours::compiled(laws, problem, t),
            (Self::Rule, Setting::Tolerance(t)) => ours::rule(laws, problem, t),
            (_, Setting::Fixed) => Ok(self.plain(problem)),
            _ => Ok(self.classical(problem, setting)),
        }
    }

    /// Parts of different sign are integrated separately, so that a tolerance relative to each can
    /// be met where they cancel.
    fn classical(self, problem: &Arc<Problem>, setting: Setting) -> Job {
        let problem = problem.clone();
        let has = |sign: f64| problem.law.parts.iter().any(|part| part.sign * sign > 0.0);
        let signs = match self == Self::GaussKronrod && has(1.0) && has(-1.0) {
            true => vec![Some(1.0), Some(-1.0)],
            false => vec![None],
        };
        Box::new(move || {
            let (breaks, scale) = (problem.breaks(), problem.scale());
            let (mut sum, mut evaluations) = (0.0, 0);
            for sign in &signs {
                let integrand = |t: f64| problem.law_at(t / scale, *sign) * problem.weight(t);
                let (value, count) = between(&breaks, self, setting, integrand)?;
                sum += value;
                evaluations += count;
            }
            let value = problem.in_units(sum);
            Ok(Outcome { value, scaled: true, evaluations: Some(evaluations) })
        })
    }

    /// The method of a script: one rule on a fixed range, plain doubles.
    fn plain(self, problem: &Arc<Problem>) -> Job {
        let legendre = legendre(64);
        let (sigmas, rule) = match self {
            Self::Trapezoid => (6.0, equal_steps(1000, |_| 1.0)),
            Self::Simpson => {
                (6.0, equal_steps(200, |k| if k % 2 == 1 { 4.0 / 3.0 } else { 2.0 / 3.0 }))
            }
            _ => {
                let nodes = legendre.nodes.iter().zip(&legendre.weights);
                (8.0, nodes.map(|(x, w)| (*x, *w)).collect())
            }
        };
        let problem = problem.clone();
        Box::new(move || {
            let (start, width) = (problem.separation * problem.std(), sigmas * problem.std());
            let terms = rule.iter().map(|(x, w)| w * problem.plain_integrand(start + width * x));
            let value = problem.in_units(width * terms.sum::<f64>());
            let found = Outcome { value, scaled: false, evaluations: Some(rule.len()) };
            if value.is_finite() { Ok(found) } else { Err(NOT_FINITE) }
        })
    }
}

/// The integral between breaks, and the evaluations of its integrand.
fn between(
    breaks: &[f64],
    method: Method,
    setting: Setting,
    integrand: impl Fn(f64) -> f64,
) -> Result<(f64, usize), Failure> {
    if let (Method::GaussKronrod, Setting::Tolerance(tolerance)) = (method, setting) {
        let found = gauss_kronrod(integrand, breaks, tolerance, LIMIT).map_err(failure)?;
        return Ok((found.value, found.evaluations));
    }
    let (mut sum, mut count) = (0.0, 0);
    for ends in breaks.windows(2).filter(|ends| ends[1] > ends[0]) {
        let (value, evaluations) = match setting {
            Setting::Tolerance(tolerance) => {
                let at = |point: Point| integrand(point.x);
                let found = TanhSinh::shared().integrate(ends[0], ends[1], tolerance, 0.0, at);
                (found.value, found.evaluations)
            }
            Setting::Points(points) => {
                let (rule, width) = (legendre(points), ends[1] - ends[0]);
                let nodes = rule.nodes.iter().zip(&rule.weights);
                let terms = nodes.map(|(x, w)| width * w * integrand(ends[0] + width * x));
                (terms.sum(), rule.nodes.len())
            }
            Setting::Fixed => (f64::NAN, 0),
        };
        sum += value;
        count += evaluations;
    }
    Ok((sum, count))
}

/// Points of [0, 1] with their weights, half as large at the ends.
fn equal_steps(steps: u32, weight: impl Fn(u32) -> f64) -> Vec<(f64, f64)> {
    let count = f64::from(steps);
    let ends = |k| if k == 0 || k == steps { 0.5 } else { 1.0 };
    (0..=steps).map(|k| (f64::from(k) / count, ends(k) * weight(k) / count)).collect()
}
