//! One integral: a law over the heights at one separation, the input of every method; the points at
//! which times are taken, and what a method returns.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Asperity, Law, Model, Part, Quantity, Scene, Surface, Tolerance};
use asperity_quadrature::{QuadratureError, Sampler, reach};
use xtask::figures::models::{NOMINAL_AREA, interface};

/// 1/√(2π).
const INV_SQRT_2PI: f64 = 0.398_942_280_401_432_7;
/// Densities below exp(-CUT) of their largest value are left out, as in the engine.
const CUT: f64 = 46.0;

/// The quantities that are one integral of one law; the others follow from these.
pub const INTEGRALS: [Quantity; 4] =
    [Quantity::Force, Quantity::Area, Quantity::Stiffness, Quantity::Tangent];

/// A model's quantity in a scene at one separation, with its law.
#[derive(Debug, Clone)]
pub struct Problem {
    /// The model.
    pub model: Model,
    /// The quantity.
    pub quantity: Quantity,
    /// The scene.
    pub scene: Scene,
    /// d/σ_z.
    pub separation: f64,
    /// The law behind the quantity; of the force for a tangent.
    pub law: Arc<Law>,
}

/// Whether a quantity is a slope of the force. The integrand then has one more factor, and the
/// jumps of the law need no treatment.
#[must_use]
pub fn is_slope(model: &Model, quantity: Quantity) -> bool {
    match quantity {
        Quantity::Tangent => true,
        Quantity::Stiffness => !model.validity().angles,
        _ => false,
    }
}

/// The quantity whose law is integrated: the force for a slope.
#[must_use]
pub fn integrated(model: &Model, quantity: Quantity) -> Quantity {
    if is_slope(model, quantity) { Quantity::Force } else { quantity }
}

/// The law behind a quantity.
///
/// # Errors
/// When the model refuses the asperity.
pub fn law_behind(
    model: &Model,
    quantity: Quantity,
    asperity: &Asperity,
    tolerance: f64,
) -> Result<Law> {
    Ok(model.law(asperity, integrated(model, quantity), Tolerance::new(tolerance)?)?)
}

/// The tightest tolerance of a model, to which its law is tabulated.
#[must_use]
pub fn tightest(model: &Model) -> f64 {
    if model.validity().angles { 1e-11 } else { 1e-13 }
}

impl Problem {
    /// A problem with the tightest tolerance of its model.
    ///
    /// # Errors
    /// When the model refuses the asperity.
    pub fn new(model: &Model, quantity: Quantity, scene: Scene, separation: f64) -> Result<Self> {
        let law = law_behind(model, quantity, &scene.asperity()?, tightest(model))?;
        Ok(Self { model: model.clone(), quantity, scene, separation, law: Arc::new(law) })
    }

    /// Interference unit over σ_z.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.law.interference_unit / self.std()
    }

    /// σ_z \[m\].
    #[must_use]
    pub fn std(&self) -> f64 {
        self.scene.surface.asperity_height_std
    }

    /// Whether the integrand has the factor of a slope.
    #[must_use]
    pub fn slope(&self) -> bool {
        is_slope(&self.model, self.quantity)
    }

    /// The law over its unit at x = w over the interference unit: the parts of one sign, or all.
    #[must_use]
    pub fn law_at(&self, x: f64, sign: Option<f64>) -> f64 {
        let wanted = |part: &&Part| {
            part.range.contains(&x) && sign.is_none_or(|sign| sign * part.sign > 0.0)
        };
        self.law.parts.iter().filter(wanted).map(|part| part.sign * part_at(part, x)).sum()
    }

    /// The range of t = (z - d)/σ_z in which the scaled integrand matters, with the law's kinks
    /// and, below d = 0, the peak of the density between.
    #[must_use]
    pub fn breaks(&self) -> Vec<f64> {
        let s = self.separation;
        let (low, high) = ((-s - (2.0 * CUT).sqrt()).max(0.0), reach(s));
        let scale = self.scale();
        let inside = self.law.kinks().into_iter().map(|x| x * scale).chain([-s]);
        let mut breaks: Vec<f64> = inside.filter(|t| *t > low && *t < high).collect();
        breaks.extend([low, high]);
        breaks.sort_by(f64::total_cmp);
        breaks
    }

    /// The density at s + t over its scale, exp(-s²/2) for s > 0, and the factor of a slope.
    #[must_use]
    pub fn weight(&self, t: f64) -> f64 {
        let s = self.separation;
        let exponent = if s >= 0.0 { t * (s + 0.5 * t) } else { 0.5 * (s + t) * (s + t) };
        let weight = (-exponent).exp() * INV_SQRT_2PI;
        if self.slope() { weight * (s + t) } else { weight }
    }

    /// The plain integrand at height z \[m\], without scaling, as in a script.
    #[must_use]
    pub fn plain_integrand(&self, z: f64) -> f64 {
        let std = self.std();
        let (interference, zeta) = (z - self.separation * std, z / std);
        if interference <= 0.0 {
            return 0.0;
        }
        let density = (-0.5 * zeta * zeta).exp() * INV_SQRT_2PI;
        let density = if self.slope() { density * zeta } else { density };
        self.law_at(interference / self.law.interference_unit, None) * density / std
    }

    /// An integral in SI units.
    #[must_use]
    pub fn in_units(&self, integral: f64) -> f64 {
        let unit = self.scene.asperities() * self.law.value_unit;
        if self.slope() { unit * integral / self.std() } else { unit * integral }
    }
}

/// NaN, at which every method fails, where the part cannot be sampled.
fn part_at(part: &Part, x: f64) -> f64 {
    let mut value = [0.0];
    let sampled = part.form.sample(&[x], &mut value);
    if sampled.is_ok() { value[0] } else { f64::NAN }
}

/// w_c/σ_z at which times are taken.
const SCALES: [f64; 7] = [3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0, 3.0];
/// d/σ_z at which times are taken.
const SEPARATIONS: [f64; 8] = [-1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0];

/// The paper's asperity on surfaces of different roughness, one for each w_c/σ_z: the law is the
/// same on all.
///
/// # Errors
/// Only if the paper's asperity is refused.
fn scenes() -> Result<Vec<Scene>> {
    let radius = 3.6e-4;
    let scene = |std: f64| Scene::new(interface(), Surface::new(radius, 1e8, std), NOMINAL_AREA);
    let critical = scene(1e-6).asperity()?.critical_interference()?;
    Ok(SCALES.iter().map(|scale| scene(critical / scale)).collect())
}

/// The points at which times are taken, in an order that branch predictors cannot learn.
///
/// # Errors
/// What the model refuses.
pub fn points(model: &Model, quantity: Quantity) -> Result<Vec<Arc<Problem>>> {
    let scenes = scenes()?;
    let first = Problem::new(model, quantity, scenes[0].clone(), SEPARATIONS[0])?;
    let count = scenes.len() * SEPARATIONS.len();
    let point = |k: usize| {
        let scene = scenes[k / SEPARATIONS.len()].clone();
        let separation = SEPARATIONS[k % SEPARATIONS.len()];
        Arc::new(Problem { scene, separation, ..first.clone() })
    };
    // 23 and 56 have no common factor, so every point occurs once.
    Ok((0..count).map(|k| point(k * 23 % count)).collect())
}

/// The result of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// In SI units.
    pub value: f64,
    /// Whether the value is divided by its scale, exp(-s²/2) for s > 0.
    pub scaled: bool,
}

/// The reason for a missing number, as it stands in a table.
pub type Failure = &'static str;

/// The method reports that it missed its tolerance.
pub const NOT_CONVERGED: Failure = "not-converged";
/// A value was infinite or NaN.
pub const NOT_FINITE: Failure = "not-finite";
/// The result is 0 for a value other than 0.
pub const ZERO: Failure = "zero";

/// The reason for which a rule has no number.
pub fn failure(error: QuadratureError) -> Failure {
    match error {
        QuadratureError::NotConverged { .. } => NOT_CONVERGED,
        _ => NOT_FINITE,
    }
}

/// A prepared problem: one-time work is done.
pub type Job = Box<dyn Fn() -> Result<Outcome, Failure> + Send + Sync>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_points_are_the_whole_grid_each_once() -> Result<()> {
        let points = points(&"jg".parse()?, Quantity::Force)?;
        let critical = points[0].scene.asperity()?.critical_interference()?;
        let mut seen: Vec<String> =
            points.iter().map(|p| format!("{:.1e} {}", critical / p.std(), p.separation)).collect();
        seen.sort();
        seen.dedup();
        assert!(seen.len() == 56, "{}", seen.len());
        assert!(seen.contains(&"3.0e-3 -1".into()) && seen.contains(&"3.0e0 6".into()));
        Ok(())
    }
}
