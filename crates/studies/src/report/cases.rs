//! The cases with a reference computed another way: `tests/reference`.

use std::sync::Arc;

use anyhow::{Context, Result};
use asperity::{HeightDistribution, Interface, Model, Quantity, Scene, Surface};
use rayon::prelude::*;
use serde::Deserialize;

use super::ours::Laws;
use super::problem::{Failure, NOT_FINITE, Outcome, Problem, ZERO, tightest};
use xtask::figures::report_csv::ORDINARY;
use xtask::folder::root;
use xtask::table::rows_of;

/// Ranges of d/σ_z and w_c/σ_z of the worst errors in `speed-vs-error`.
const HARD_GRID: ([f64; 2], [f64; 2]) = ([-3.0, 40.0], [1e-8, 1e4]);

/// A problem with its reference value.
#[derive(Debug, Clone)]
pub struct Case {
    /// The difficulty, or [`ORDINARY`].
    pub family: String,
    /// The name of its scene.
    pub name: String,
    /// The problem.
    pub problem: Arc<Problem>,
    /// The value, as a double; 0 where it underflows.
    value: f64,
    /// The value over its scale.
    scaled: f64,
    /// The integral of the law's absolute value, over the same scale: errors are relative to it.
    size: f64,
    /// w_c/σ_z.
    critical: f64,
}

impl Case {
    /// The error of a result, relative to the sum of sizes.
    ///
    /// # Errors
    /// When the result is not a number, or 0 for a value other than 0.
    pub fn error(&self, found: Result<Outcome, Failure>) -> Result<f64, Failure> {
        let found = found?;
        if !found.value.is_finite() {
            return Err(NOT_FINITE);
        }
        if found.value == 0.0 {
            return Err(ZERO);
        }
        // A plain result is compared with the reference as a double: it is one.
        let reference = if found.scaled { self.scaled } else { self.value };
        Ok((found.value / reference - 1.0).abs() * (self.scaled / self.size).abs())
    }

    /// Whether it belongs to the grid of the speed table.
    #[must_use]
    pub fn on_hard_grid(&self) -> bool {
        let within = |[low, high]: [f64; 2], x: f64| (low..=high).contains(&x);
        self.family != ORDINARY
            && !self.problem.exponential()
            && within(HARD_GRID.0, self.problem.separation)
            && within(HARD_GRID.1, self.critical)
    }
}

/// The numbers of a scene.
#[derive(Clone, Deserialize)]
struct Numbers {
    #[serde(flatten)]
    interface: Interface,
    #[serde(flatten)]
    surface: Surface,
    nominal_area: f64,
}

impl Numbers {
    fn scene(&self) -> Scene {
        Scene::new(self.interface, self.surface, self.nominal_area)
    }
}

/// A row of `hard_cases.csv`, or of `models.csv` or `models_scenes.csv`, which have fewer columns.
#[derive(Clone, Default, Deserialize)]
#[serde(default)]
struct CaseRow {
    family: String,
    case: String,
    #[serde(flatten)]
    numbers: Option<Numbers>,
    heights: String,
    model: String,
    quantity: String,
    separation_over_sigma: f64,
    value: f64,
    /// Digits of ln |value|; empty where the value has full precision.
    ln_value: String,
}

fn table(name: &str) -> Result<Vec<CaseRow>> {
    rows_of(&root().join("tests/reference").join(name))
}

/// The hard cases and the ordinary scenes of these pairs of model and quantity.
///
/// # Errors
/// A table that is missing or malformed.
pub fn read(laws: &Laws, pairs: &[(Model, Quantity)]) -> Result<Vec<Case>> {
    let scenes = table("models_scenes.csv")?;
    let rows = [table("hard_cases.csv")?, table("models.csv")?].concat();
    let case = |row: CaseRow| {
        // Rows of the lateral models with other options have other names and are left out.
        let wanted = |(model, quantity): &&(Model, Quantity)| {
            model.id() == row.model && quantity.to_string() == row.quantity
        };
        let pair = pairs.iter().find(wanted)?;
        let named = || scenes.iter().find(|named| named.case == row.case)?.numbers.as_ref();
        let numbers = row.numbers.as_ref().or_else(named);
        let numbers = numbers.with_context(|| format!("scene {:?} is in no table", row.case));
        Some(numbers.map(Numbers::scene).and_then(|scene| case(laws, &row, scene, pair)))
    };
    rows.into_par_iter().filter_map(case).collect()
}

fn case(
    laws: &Laws,
    row: &CaseRow,
    mut scene: Scene,
    (model, quantity): &(Model, Quantity),
) -> Result<Case> {
    if row.heights == "exponential" {
        scene.heights = HeightDistribution::Exponential;
    }
    let problem = Problem::new(model, *quantity, scene, row.separation_over_sigma)?;
    let compiled = laws.scene(&problem, tightest(model))?;
    let scaled = match row.ln_value.as_str() {
        "" => row.value * (-problem.ln_scale()).exp(),
        ln_value => row.value.signum() * over_scale(ln_value, &problem)?,
    };
    let family = if row.family.is_empty() { ORDINARY } else { &row.family };
    Ok(Case {
        family: family.into(),
        name: row.case.clone(),
        value: row.value,
        scaled,
        size: compiled.evaluate(*quantity, problem.separation)?.size,
        critical: problem.scene.asperity()?.critical_interference()? / problem.std(),
        problem: Arc::new(problem),
    })
}

/// exp of a logarithm in many digits, less the scale's. At s = 1e6 a logarithm in double
/// precision has no digit of the value, so integer part and fraction are treated separately.
fn over_scale(ln_value: &str, problem: &Problem) -> Result<f64> {
    let (sign, digits) = ln_value.strip_prefix('-').map_or((1.0, ln_value), |rest| (-1.0, rest));
    let (whole, fraction) = digits.split_once('.').context("a logarithm with a point")?;
    let whole = sign * whole.parse::<f64>()?;
    let fraction = sign * format!("0.{fraction}").parse::<f64>()?;
    let s = problem.separation.max(0.0);
    let (high, low) = if problem.exponential() {
        (s, 0.0)
    } else {
        // s² in two doubles.
        (0.5 * s * s, 0.5 * s.mul_add(s, -(s * s)))
    };
    Ok((whole + high + (fraction + low)).exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_relative_to_the_sum_of_sizes_and_failures_are_reported() -> Result<()> {
        let pairs = Quantity::ALL.map(|quantity| ("gw".parse(), quantity));
        let pairs = pairs.into_iter().map(|(model, quantity)| Ok((model?, quantity)));
        let cases = read(&Laws::default(), &pairs.collect::<Result<Vec<_>>>()?)?;
        assert!(cases.iter().any(Case::on_hard_grid) && cases.len() > 60, "{}", cases.len());
        let case = Case { scaled: 2.0, size: 8.0, value: 1.0, ..cases[0].clone() };
        let found = |value, scaled| Ok(Outcome { value, scaled, evaluations: None });
        assert_eq!(case.error(found(3.0, true)), Ok(0.125));
        assert_eq!(case.error(found(1.5, false)), Ok(0.125));
        assert_eq!(case.error(found(0.0, false)), Err(ZERO));
        assert_eq!(case.error(found(f64::NAN, true)), Err(NOT_FINITE));
        assert_eq!(case.error(Err("not-converged")), Err("not-converged"));
        Ok(())
    }
}
