//! The hard cases with a reference computed another way: `tests/reference/hard_cases.csv`.

use std::ops::RangeInclusive;
use std::sync::Arc;

use anyhow::{Context, Result};
use asperity::{Interface, Model, Quantity, Scene, Surface};
use rayon::prelude::*;
use serde::Deserialize;

use super::ours::Laws;
use super::problem::{Failure, NOT_FINITE, Outcome, Problem, ZERO, tightest};
use xtask::folder::root;
use xtask::table::rows_of;

/// Ranges of d/σ_z and w_c/σ_z of the cases.
const SEPARATIONS: RangeInclusive<f64> = -3.0..=40.0;
const CRITICAL: RangeInclusive<f64> = 1e-8..=1e4;

/// A problem with its reference value.
#[derive(Debug, Clone)]
pub struct Case {
    /// The problem.
    pub problem: Arc<Problem>,
    /// The value, as a double; 0 where it underflows.
    value: f64,
    /// The value over its scale.
    scaled: f64,
    /// The integral of the law's absolute value, over the same scale: errors are relative to it.
    size: f64,
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
}

/// A row of the table.
#[derive(Clone, Deserialize)]
struct CaseRow {
    #[serde(flatten)]
    interface: Interface,
    #[serde(flatten)]
    surface: Surface,
    nominal_area: f64,
    heights: String,
    model: String,
    quantity: String,
    separation_over_sigma: f64,
    value: f64,
    ln_value: String,
}

/// The cases of these pairs of model and quantity with Gaussian heights.
///
/// # Errors
/// A table that is missing or malformed.
pub fn read(laws: &Laws, pairs: &[(Model, Quantity)]) -> Result<Vec<Case>> {
    let rows: Vec<CaseRow> = rows_of(&root().join("tests/reference/hard_cases.csv"))?;
    let case = |row: CaseRow| {
        // Rows of the lateral models with other options have other names and are left out.
        let wanted = |(model, quantity): &&(Model, Quantity)| {
            model.id() == row.model && quantity.to_string() == row.quantity
        };
        let is_inside =
            row.heights == "gaussian" && SEPARATIONS.contains(&row.separation_over_sigma);
        case(laws, &row, pairs.iter().filter(|_| is_inside).find(wanted)?).transpose()
    };
    rows.into_par_iter().filter_map(case).collect()
}

/// The case of a row; `None` outside the range of w_c/σ_z.
fn case(laws: &Laws, row: &CaseRow, (model, quantity): &(Model, Quantity)) -> Result<Option<Case>> {
    let scene = Scene::new(row.interface, row.surface, row.nominal_area);
    let problem = Problem::new(model, *quantity, scene, row.separation_over_sigma)?;
    if !CRITICAL.contains(&(problem.scene.asperity()?.critical_interference()? / problem.std())) {
        return Ok(None);
    }
    let compiled = laws.scene(&problem, tightest(model))?;
    Ok(Some(Case {
        value: row.value,
        scaled: row.value.signum() * over_scale(&row.ln_value, problem.separation)?,
        size: compiled.evaluate(*quantity, problem.separation)?.size,
        problem: Arc::new(problem),
    }))
}

/// exp of a logarithm in many digits, less the scale's. In double precision the logarithm of a far
/// tail has few digits of the value, so integer part and fraction are treated separately.
fn over_scale(ln_value: &str, separation: f64) -> Result<f64> {
    let (sign, digits) = ln_value.strip_prefix('-').map_or((1.0, ln_value), |rest| (-1.0, rest));
    let (whole, fraction) = digits.split_once('.').context("a logarithm with a point")?;
    let whole = sign * whole.parse::<f64>()?;
    let fraction = sign * format!("0.{fraction}").parse::<f64>()?;
    // s² in two doubles.
    let s = separation.max(0.0);
    let (high, low) = (0.5 * s * s, 0.5 * s.mul_add(s, -(s * s)));
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
        assert!(cases.len() > 10, "{}", cases.len());
        let case = Case { scaled: 2.0, size: 8.0, value: 1.0, ..cases[0].clone() };
        let found = |value, scaled| Ok(Outcome { value, scaled });
        assert_eq!(case.error(found(3.0, true)), Ok(0.125));
        assert_eq!(case.error(found(1.5, false)), Ok(0.125));
        assert_eq!(case.error(found(0.0, false)), Err(ZERO));
        assert_eq!(case.error(found(f64::NAN, true)), Err(NOT_FINITE));
        assert_eq!(case.error(Err("not-converged")), Err("not-converged"));
        Ok(())
    }
}
