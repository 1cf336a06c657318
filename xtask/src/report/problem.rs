//! One integral: a law over the heights at one separation, the input of every method.

use std::sync::Arc;

use anyhow::Result;
use asperity::{Asperity, HeightDistribution, Law, Model, Part, Quantity, Scene, Tolerance};
use asperity_quadrature::{Sampler, reach};

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
    /// The law behind the quantity; that of the force for a tangent.
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

/// The quantity whose law is integrated: that of the force for a slope.
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

    /// Whether heights are exponential; otherwise they are Gaussian.
    #[must_use]
    pub fn exponential(&self) -> bool {
        matches!(self.scene.heights, HeightDistribution::Exponential)
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
        let (low, high) = match (self.exponential(), s >= 0.0) {
            (false, _) => ((-s - (2.0 * CUT).sqrt()).max(0.0), reach(s)),
            (true, true) => (0.0, CUT),
            (true, false) => (-s, CUT - s),
        };
        let scale = self.scale();
        let inside = self.law.kinks().into_iter().map(|x| x * scale).chain([-s]);
        let mut breaks: Vec<f64> = inside.filter(|t| *t > low && *t < high).collect();
        breaks.extend([low, high]);
        breaks.sort_by(f64::total_cmp);
        breaks
    }

    /// The density at s + t over its scale, exp(-s²/2) or exp(-s) for s > 0, and the factor of a
    /// slope.
    #[must_use]
    pub fn weight(&self, t: f64) -> f64 {
        let s = self.separation;
        if self.exponential() {
            return (-(t + s.min(0.0))).exp();
        }
        let exponent = if s >= 0.0 { t * (s + 0.5 * t) } else { 0.5 * (s + t) * (s + t) };
        let weight = (-exponent).exp() * INV_SQRT_2PI;
        if self.slope() { weight * (s + t) } else { weight }
    }

    /// The plain integrand at height z \[m\], without scaling, as in a script.
    #[must_use]
    pub fn plain_integrand(&self, z: f64) -> f64 {
        let std = self.std();
        let (interference, zeta) = (z - self.separation * std, z / std);
        if interference <= 0.0 || self.exponential() && zeta < 0.0 {
            return 0.0;
        }
        let density = match self.exponential() {
            true => (-zeta).exp(),
            false => (-0.5 * zeta * zeta).exp() * INV_SQRT_2PI,
        };
        let density = if self.slope() && !self.exponential() { density * zeta } else { density };
        self.law_at(interference / self.law.interference_unit, None) * density / std
    }

    /// Lower end of the plain integral \[m\].
    #[must_use]
    pub fn plain_start(&self) -> f64 {
        let start = self.separation * self.std();
        if self.exponential() { start.max(0.0) } else { start }
    }

    /// An integral in SI units. For exponential heights below d = 0, the surface moves with its
    /// lowest asperity, and the law's value there is subtracted from the slope.
    #[must_use]
    pub fn in_units(&self, integral: f64) -> f64 {
        let unit = self.scene.asperities() * self.law.value_unit;
        if !self.slope() {
            return unit * integral;
        }
        let lowest = if self.exponential() && self.separation < 0.0 {
            self.law_at(-self.separation / self.scale(), None)
        } else {
            0.0
        };
        unit * (integral - lowest) / self.std()
    }

    /// Logarithm of the scale, -max(s,0)²/2 or -max(s,0).
    #[must_use]
    pub fn ln_scale(&self) -> f64 {
        let s = self.separation.max(0.0);
        if self.exponential() { -s } else { -0.5 * s * s }
    }
}

/// NaN, at which every method fails, where the part cannot be sampled.
fn part_at(part: &Part, x: f64) -> f64 {
    let mut value = [0.0];
    let sampled = part.form.sample(&[x], &mut value);
    if sampled.is_ok() { value[0] } else { f64::NAN }
}
