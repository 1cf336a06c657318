//! The cases with a reference computed another way: `tests/reference`.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use anyhow::{Context, Result, bail};
use asperity::{HeightDistribution, Interface, Model, Quantity, Scene, Surface};
use rayon::prelude::*;

use super::laws::Laws;
use super::methods::{Failure, Outcome};
use super::problem::Problem;

/// The family of the scenes that are not hard.
pub const ORDINARY: &str = "ordinary";
/// Separations and w_c/σ_z over which the errors of `speed-vs-error` are the worst.
const HARD_GRID: ([f64; 2], [f64; 2]) = ([-3.0, 40.0], [1e-8, 1e4]);

/// A problem whose answer is known.
#[derive(Debug, Clone)]
pub struct Case {
    /// What makes it hard, or [`ORDINARY`].
    pub family: String,
    /// Its scene's name.
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
    /// The error of what a method found, relative to the sum of sizes.
    ///
    /// # Errors
    /// When it found no number, or 0 where the truth is not.
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
            // A plain double cannot be held to more than a double can say.
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
            && within(HARD_GRID.0, self.problem.separation)
            && within(HARD_GRID.1, self.critical)
    }
}

/// One row of a reference table before its law is built.
struct Row {
    family: String,
    name: String,
    scene: Scene,
    model: Model,
    quantity: Quantity,
    separation: f64,
    value: f64,
    /// Digits of ln |value|; where there are none, the value stands for itself.
    ln_value: String,
}

/// The hard cases and the ordinary scenes of these models and quantities.
///
/// # Errors
/// A table that is missing or is not what its head says.
pub fn read(laws: &Laws, models: &[Model], quantities: &[Quantity]) -> Result<Vec<Case>> {
    let mut rows = hard_rows()?;
    rows.extend(ordinary_rows()?);
    rows.retain(|row| {
        quantities.contains(&row.quantity) && models.iter().any(|m| m.id() == row.model.id())
    });
    rows.into_par_iter().map(|row| case(laws, row)).collect()
}

fn table(name: &str) -> Result<Vec<Vec<String>>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference").join(name);
    let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let cells = |line: &str| line.split(',').map(str::to_owned).collect::<Vec<_>>();
    Ok(text.lines().skip(1).map(cells).collect())
}

/// The scene in the nine columns from `equivalent_modulus` on.
fn scene(cells: &[String]) -> Result<Scene> {
    let numbers: Vec<f64> =
        cells.iter().map(|cell| cell.parse()).collect::<Result<_, _>>().context("a scene")?;
    let [modulus, shear, poisson, hardness, factor, radius, density, std, area] = numbers[..]
    else {
        bail!("a scene has {} numbers, 9 were required", numbers.len());
    };
    let mut interface = Interface::new(modulus, poisson, hardness);
    interface.equivalent_shear_modulus = Some(shear);
    interface.pressure_factor = Some(factor);
    Ok(Scene::new(interface, Surface::new(radius, density, std), area))
}

fn hard_rows() -> Result<Vec<Row>> {
    let read = |cells: &Vec<String>| -> Result<Row> {
        let mut scene = scene(&cells[2..11])?;
        match cells[11].as_str() {
            "gaussian" => {}
            "exponential" => scene.heights = HeightDistribution::Exponential,
            other => bail!("heights {other:?}"),
        }
        Ok(Row {
            family: cells[0].clone(),
            name: cells[1].clone(),
            scene,
            model: cells[12].parse()?,
            quantity: cells[13].parse().map_err(anyhow::Error::msg)?,
            separation: cells[14].parse()?,
            value: cells[15].parse()?,
            ln_value: cells[16].clone(),
        })
    };
    rows("hard_cases.csv", 20, read)
}

fn ordinary_rows() -> Result<Vec<Row>> {
    let scenes: Vec<(String, Scene)> =
        rows("models_scenes.csv", 10, |cells| Ok((cells[0].clone(), scene(&cells[1..10])?)))?;
    let read = |cells: &Vec<String>| -> Result<Option<Row>> {
        // Options of the lateral models that are no defaults stand in words of their own.
        let Ok(quantity) = cells[3].parse() else { return Ok(None) };
        let scene = scenes.iter().find(|(name, _)| *name == cells[0]).context("a scene's name")?;
        Ok(Some(Row {
            family: ORDINARY.into(),
            name: cells[0].clone(),
            scene: scene.1.clone(),
            model: cells[1].parse()?,
            quantity,
            separation: cells[2].parse()?,
            value: cells[4].parse()?,
            ln_value: String::new(),
        }))
    };
    Ok(rows("models.csv", 5, read)?.into_iter().flatten().collect())
}

fn rows<T>(name: &str, columns: usize, read: impl Fn(&Vec<String>) -> Result<T>) -> Result<Vec<T>> {
    let numbered = table(name)?.into_iter().enumerate();
    numbered
        .map(|(k, cells)| {
            let place = || format!("{name} line {}", k + 2);
            anyhow::ensure!(cells.len() >= columns, "{}: {} cells", place(), cells.len());
            read(&cells).with_context(place)
        })
        .collect()
}

/// The tightest tolerance that is promised for a model: its law is tabulated to it.
#[must_use]
pub fn tightest(model: &Model) -> f64 {
    if model.claims().angles { 1e-11 } else { 1e-13 }
}

fn case(laws: &Laws, row: Row) -> Result<Case> {
    let Row { family, name, scene, model, quantity, separation, value, ln_value } = row;
    let compiled = laws.compiled(&model, quantity, &scene, tightest(&model))?;
    let law = Arc::new(compiled.law(quantity)?.clone());
    let evaluation = compiled.evaluate(quantity, separation)?;
    let problem = Arc::new(Problem { model, quantity, scene, separation, law });
    let scaled = if ln_value.is_empty() {
        value * (-problem.ln_scale()).exp()
    } else {
        value.signum() * over_scale(&ln_value, &problem)?
    };
    let critical = problem.scene.asperity()?.critical_interference()? / problem.std();
    Ok(Case { family, name, problem, value, scaled, size: evaluation.size, critical })
}

/// exp of (a logarithm given in many digits, less that of the scale): at s = 1e6 a double's
/// logarithm holds no digit of the value, so whole and fraction are taken apart.
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
    fn errors_are_relative_to_the_sum_of_sizes_and_nothing_passes_for_an_answer() -> Result<()> {
        let cases = read(&Laws::default(), &["gw".parse()?], &Quantity::ALL)?;
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
