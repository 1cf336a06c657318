//! The cases with a reference computed another way: `tests/reference`.

use std::sync::Arc;

use anyhow::{Context, Result, anyhow};
use asperity::{HeightDistribution, Interface, Model, Quantity, Scene, Surface};
use rayon::prelude::*;
use serde::Deserialize;
use serde::de::DeserializeOwned;

use super::ours::Laws;
use super::outcome::{Failure, Outcome};
use super::problem::{ContactState, Problem, law_behind, tightest};
use crate::figures::report_csv::ORDINARY;
use crate::folder::figures_folder;

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
            return Err(Failure::NotFinite);
        }
        if found.value == 0.0 {
            return Err(Failure::Zero);
        }
        let relative = if found.scaled {
            found.value / self.scaled - 1.0
        } else {
            // Compared with the reference as a double: the result is one.
            found.value / self.value - 1.0
        };
        Ok(relative.abs() * (self.scaled / self.size).abs())
    }

    /// Whether it belongs to the grid of the speed table.
    #[must_use]
    pub fn on_hard_grid(&self) -> bool {
        let within = |[low, high]: [f64; 2], x: f64| (low..=high).contains(&x);
        self.family != ORDINARY
            && !self.problem.exponential()
            && within(HARD_GRID.0, self.problem.contact_state.separation)
            && within(HARD_GRID.1, self.critical)
    }
}

/// The numbers of a scene.
#[derive(Deserialize)]
struct Numbers {
    equivalent_modulus: f64,
    equivalent_shear_modulus: f64,
    poissons_ratio: f64,
    hardness: f64,
    pressure_factor: f64,
    asperity_radius: f64,
    asperity_density: f64,
    asperity_height_std: f64,
    nominal_area: f64,
}

impl Numbers {
    fn scene(&self) -> Scene {
        let mut interface =
            Interface::new(self.equivalent_modulus, self.poissons_ratio, self.hardness);
        interface.equivalent_shear_modulus = Some(self.equivalent_shear_modulus);
        interface.pressure_factor = Some(self.pressure_factor);
        let surface =
            Surface::new(self.asperity_radius, self.asperity_density, self.asperity_height_std);
        Scene::new(interface, surface, self.nominal_area)
    }
}

/// A row of `hard_cases.csv`, or of `models.csv`, which has fewer columns.
#[derive(Deserialize)]
struct Row {
    #[serde(default)]
    family: String,
    case: String,
    #[serde(flatten)]
    numbers: Option<Numbers>,
    #[serde(default)]
    heights: String,
    model: String,
    quantity: String,
    separation_over_sigma: f64,
    value: f64,
    /// Digits of ln |value|; empty where the value has full precision.
    #[serde(default)]
    ln_value: String,
}

#[derive(Deserialize)]
struct Named {
    case: String,
    #[serde(flatten)]
    numbers: Numbers,
}

fn table<T: DeserializeOwned>(name: &str) -> Result<Vec<T>> {
    let path = figures_folder().with_file_name("tests").join("reference").join(name);
    let rows = csv::Reader::from_path(&path).and_then(|mut csv| csv.deserialize().collect());
    rows.with_context(|| path.display().to_string())
}

/// The hard cases and the ordinary scenes of these pairs of model and quantity.
///
/// # Errors
/// A table that is missing or malformed.
pub fn read(laws: &Laws, pairs: &[(Model, Quantity)]) -> Result<Vec<Case>> {
    let scenes: Vec<Named> = table("models_scenes.csv")?;
    let mut rows: Vec<Row> = table("hard_cases.csv")?;
    rows.extend(table::<Row>("models.csv")?);
    let cases = rows.into_par_iter().filter_map(|row| {
        // Rows of the lateral models with other options have other names and are left out.
        let wanted = |(model, quantity): &&(Model, Quantity)| {
            model.id() == row.model && quantity.to_string() == row.quantity
        };
        let (model, quantity) = pairs.iter().find(wanted)?;
        let named =
            || scenes.iter().find(|named| named.case == row.case).map(|n| n.numbers.scene());
        let Some(mut scene) = row.numbers.as_ref().map(Numbers::scene).or_else(named) else {
            return Some(Err(anyhow!("scene {:?} is in no table", row.case)));
        };
        if row.heights == "exponential" {
            scene.heights = HeightDistribution::Exponential;
        }
        Some(case(laws, row, scene, model.clone(), *quantity))
    });
    cases.collect()
}

fn case(laws: &Laws, row: Row, scene: Scene, model: Model, quantity: Quantity) -> Result<Case> {
    let Row { family, case: name, value, ln_value, separation_over_sigma: separation, .. } = row;
    let family = if family.is_empty() { ORDINARY.into() } else { family };
    let tolerance = tightest(&model);
    let contact_state = ContactState { model, quantity, scene, separation };
    let compiled = laws.scene(&contact_state, tolerance)?;
    let ContactState { model, scene, .. } = &contact_state;
    let law = Arc::new(law_behind(model, quantity, &scene.asperity()?, tolerance)?);
    let evaluation = compiled.evaluate(quantity, separation)?;
    let problem = Arc::new(Problem { contact_state, law });
    let scaled = if ln_value.is_empty() {
        value * (-problem.ln_scale()).exp()
    } else {
        value.signum() * over_scale(&ln_value, &problem)?
    };
    let critical = problem.contact_state.scene.asperity()?.critical_interference()? / problem.std();
    Ok(Case { family, name, problem, value, scaled, size: evaluation.size, critical })
}

/// exp of a logarithm in many digits, less that of the scale. At s = 1e6 a logarithm in double
/// precision has no digit of the value, so integer part and fraction are treated separately.
fn over_scale(ln_value: &str, problem: &Problem) -> Result<f64> {
    let (sign, digits) = ln_value.strip_prefix('-').map_or((1.0, ln_value), |rest| (-1.0, rest));
    let (whole, fraction) = digits.split_once('.').context("a logarithm with a point")?;
    let whole = sign * whole.parse::<f64>()?;
    let fraction = sign * format!("0.{fraction}").parse::<f64>()?;
    let s = problem.contact_state.separation.max(0.0);
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
        assert_eq!(case.error(found(0.0, false)), Err(Failure::Zero));
        assert_eq!(case.error(found(f64::NAN, true)), Err(Failure::NotFinite));
        assert_eq!(case.error(Err(Failure::NotConverged)), Err(Failure::NotConverged));
        Ok(())
    }
}
