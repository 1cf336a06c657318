//! A scene prepared for many evaluations.

use std::borrow::Cow;
use std::sync::OnceLock;

use asperity_quadrature::{Density, Moments, QuadratureError};

use crate::height_integral::HeightIntegral;
use crate::request::checked_separation;
use crate::{
    Asperity, ContactError, ContactModel, HeightDistribution, Law, Quantity, Regime, Request,
    Scene, StiffnessKind, Warning,
};

/// A value that may be too small for a plain number, with a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// The value over its scale, in SI units. The scale is exp(-s²/2) for Gaussian heights at a
    /// separation s > 0, exactly; the next field is its logarithm rounded to a double.
    pub scaled: f64,
    /// Logarithm of the scale, ≤ 0 or near it.
    pub ln_scale: f64,
    /// The integral of the law's absolute value, scaled alike: larger than the value where parts
    /// of different sign cancel.
    pub size: f64,
    /// Bound on the error of `scaled` relative to `size`.
    pub error: f64,
}

impl Evaluation {
    /// The value; 0 only where it is below the smallest number a double can hold.
    #[must_use]
    pub fn value(&self) -> f64 {
        self.scaled * self.ln_scale.exp()
    }

    /// The natural logarithm of the absolute value, also where the value itself underflows;
    /// -∞ where there is no contact at all.
    #[must_use]
    pub fn ln_value(&self) -> f64 {
        self.scaled.abs().ln() + self.ln_scale
    }

    /// Bound on the error relative to the value, the rounding of the scale's logarithm included:
    /// infinite where the value is 0 by cancellation.
    #[must_use]
    pub fn relative_error(&self) -> f64 {
        if self.size == 0.0 {
            return 0.0;
        }
        // Half a unit in the last place of the logarithm, and one each of exp and the product.
        let scale = (0.5 * self.ln_scale.abs() + 2.0) * f64::EPSILON;
        self.error * self.size / self.scaled.abs() + scale
    }
}

/// The share of one part of the law in a value.
#[derive(Debug, Clone, PartialEq)]
pub struct Share {
    /// Name of the part.
    pub name: Cow<'static, str>,
    /// Its regime.
    pub regime: Regime,
    /// Its signed integral over the total: shares sum to 1, and negative ones belong to parts
    /// that a model subtracts (all change sign where the total is negative).
    pub share: f64,
}

/// A model applied to a scene: integrals are built when first needed, and shared by all threads.
#[derive(Debug)]
pub struct Compiled {
    model: String,
    quantities: Vec<Quantity>,
    asperity: Asperity,
    channels: Vec<Channel>,
    /// For each quantity, which channel it comes of.
    sources: Vec<usize>,
    height_std: f64,
    separation_rounding: f64,
    warnings: Vec<Warning>,
    monotone: bool,
    heights: HeightDistribution,
}

/// The integral of one law.
#[derive(Debug)]
struct Channel {
    quantity: Quantity,
    law: Law,
    /// η A_n times the law's value unit.
    factor: f64,
    /// Interference unit over σ_z.
    scale: f64,
    heights: HeightDistribution,
    tolerance: f64,
    total: HeightIntegral,
    parts: OnceLock<Vec<HeightIntegral>>,
}

impl Compiled {
    pub(crate) fn new<M: ContactModel + ?Sized>(
        model: &M,
        scene: &Scene,
        request: &Request,
    ) -> Result<Self, ContactError> {
        let asperity = scene.asperity()?;
        let mut compiled = Self {
            model: model.name().into(),
            quantities: request.quantities.clone(),
            asperity,
            channels: vec![],
            sources: vec![],
            height_std: scene.surface.asperity_height_std,
            separation_rounding: request.separation_rounding,
            warnings: model.warnings(),
            monotone: model.claims().force_monotone,
            heights: scene.heights.clone(),
        };
        for &asked in &request.quantities {
            let quantity = law_of(asked, model.stiffness());
            let known = compiled.channels.iter().position(|c| c.quantity == quantity);
            compiled.sources.push(known.unwrap_or(compiled.channels.len()));
            if known.is_none() {
                let law = model.law(&asperity, quantity, request.tolerance)?;
                let tolerance = request.tolerance.relative();
                compiled.channels.push(Channel::new(quantity, law, scene, tolerance)?);
            }
        }
        Ok(compiled)
    }

    /// The same laws on another surface or with other heights: what a law has tabulated is shared,
    /// so that a sweep over roughness or density builds it once.
    ///
    /// # Errors
    /// [`ContactError::OtherAsperity`] when interface or asperity radius differ, which the law
    /// depends on, and the errors of [`Scene::asperity`].
    pub fn on(&self, scene: &Scene) -> Result<Self, ContactError> {
        if scene.asperity()? != self.asperity {
            return Err(ContactError::OtherAsperity);
        }
        let channels = self
            .channels
            .iter()
            .map(|c| Channel::new(c.quantity, c.law.clone(), scene, c.tolerance))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            model: self.model.clone(),
            quantities: self.quantities.clone(),
            asperity: self.asperity,
            channels,
            sources: self.sources.clone(),
            height_std: scene.surface.asperity_height_std,
            separation_rounding: self.separation_rounding,
            warnings: self.warnings.clone(),
            monotone: self.monotone,
            heights: scene.heights.clone(),
        })
    }

    /// The model's name.
    #[must_use]
    pub fn model(&self) -> &str {
        &self.model
    }

    /// Whether the model claims that its force never rises with the separation.
    pub(crate) fn monotone(&self) -> bool {
        self.monotone
    }

    /// What the model's options deserve to be warned of.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The quantities that were asked for.
    #[must_use]
    pub fn quantities(&self) -> &[Quantity] {
        &self.quantities
    }

    /// σ_z \[m\].
    #[must_use]
    pub fn asperity_height_std(&self) -> f64 {
        self.height_std
    }

    /// A quantity at a separation d/σ_z.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`], [`ContactError::OutOfRange`] for a separation that is not
    /// a number or outside -1e6 ... 1e9, and [`ContactError::Integral`].
    pub fn evaluate(
        &self,
        quantity: Quantity,
        separation: f64,
    ) -> Result<Evaluation, ContactError> {
        let channel = self.channel(quantity)?;
        let s = checked_separation(separation)?;
        // The slope is a tangent, or tells what a rounded separation does to the value.
        let needs_slope = quantity != channel.quantity || self.separation_rounding > 0.0;
        let total = &channel.total;
        let moments = if needs_slope { total.at(s) } else { total.value(s) };
        let moments = moments.map_err(failed(quantity, s))?;
        Ok(self.evaluation(channel, quantity, s, &moments))
    }

    /// The share of every part of the law in a quantity (in the force, for the tangent).
    ///
    /// # Errors
    /// Those of [`evaluate`](Self::evaluate).
    pub fn shares(&self, quantity: Quantity, separation: f64) -> Result<Vec<Share>, ContactError> {
        let channel = self.channel(quantity)?;
        let s = checked_separation(separation)?;
        let total = channel.total.at(s).map_err(failed(quantity, s))?;
        let mut shares = Vec::with_capacity(channel.law.parts.len());
        for (part, integral) in channel.law.parts.iter().zip(channel.parts()) {
            let moments = integral.at(s).map_err(failed(quantity, s))?;
            let value = moments.value * (moments.ln_scale - total.ln_scale).exp();
            let share = if value == 0.0 { 0.0 } else { value / total.value };
            shares.push(Share { name: part.name.clone(), regime: part.regime, share });
        }
        Ok(shares)
    }

    /// The law behind a quantity: the force law for the tangent.
    ///
    /// # Errors
    /// [`ContactError::NotRequested`].
    pub fn law(&self, quantity: Quantity) -> Result<&Law, ContactError> {
        Ok(&self.channel(quantity)?.law)
    }

    /// The law a quantity comes of, if it was asked for.
    pub(crate) fn law_behind(&self, quantity: Quantity) -> Option<Quantity> {
        self.channel(quantity).ok().map(|channel| channel.quantity)
    }

    /// The interference unit over σ_z.
    pub(crate) fn scale(&self, quantity: Quantity) -> Result<f64, ContactError> {
        Ok(self.channel(quantity)?.scale)
    }

    /// Nodes of the rule at a separation.
    pub(crate) fn nodes(&self, quantity: Quantity, s: f64) -> Result<Option<usize>, ContactError> {
        self.channel(quantity)?.total.nodes(s).map_err(failed(quantity, s))
    }

    /// How often the law has been sampled for rules.
    pub(crate) fn samples(&self, quantity: Quantity) -> Result<usize, ContactError> {
        Ok(self.channel(quantity)?.total.samples())
    }

    pub(crate) fn heights(&self) -> &HeightDistribution {
        &self.heights
    }

    fn evaluation(
        &self,
        channel: &Channel,
        quantity: Quantity,
        separation: f64,
        moments: &Moments,
    ) -> Evaluation {
        // A channel's own quantity is its integral; what else comes of it is a slope.
        let is_slope = quantity != channel.quantity;
        let (scaled, size) = if is_slope {
            (moments.slope / self.height_std, moments.sizes[1] / self.height_std)
        } else {
            (moments.value, moments.sizes[0])
        };
        let mut error = moments.error;
        if self.separation_rounding > 0.0 && moments.value != 0.0 {
            // d ln I/ds times the rounding of s; the slope's own is one more power of s, no more.
            let steepness = (moments.slope / moments.value).abs() + 1.0;
            error += self.separation_rounding * separation.abs() * steepness;
        }
        let factor = channel.factor;
        Evaluation {
            scaled: scaled * factor,
            ln_scale: moments.ln_scale,
            size: size * factor,
            error,
        }
    }

    fn channel(&self, quantity: Quantity) -> Result<&Channel, ContactError> {
        let place = self.quantities.iter().position(|q| *q == quantity);
        let channel = place.and_then(|k| self.channels.get(*self.sources.get(k)?));
        channel.ok_or(ContactError::NotRequested { quantity })
    }
}

/// The law a quantity is computed from.
fn law_of(quantity: Quantity, stiffness: StiffnessKind) -> Quantity {
    match (quantity, stiffness) {
        (Quantity::Tangent, _) | (Quantity::Stiffness, StiffnessKind::Tangent) => Quantity::Force,
        (quantity, _) => quantity,
    }
}

fn failed(quantity: Quantity, separation: f64) -> impl Fn(QuadratureError) -> ContactError {
    move |source| ContactError::Integral { quantity, separation, source }
}

impl Channel {
    fn new(
        quantity: Quantity,
        law: Law,
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Self, ContactError> {
        let scale = law.interference_unit / scene.surface.asperity_height_std;
        let total = HeightIntegral::new(law.density(), scale, &scene.heights, tolerance);
        let factor = scene.asperities() * law.value_unit;
        // Tangents are divided by σ_z.
        for scale in [factor, factor / scene.surface.asperity_height_std, scale] {
            if !(scale > 0.0 && scale.is_finite()) {
                return Err(ContactError::Scale { quantity, scale });
            }
        }
        Ok(Self {
            quantity,
            factor,
            law,
            scale,
            heights: scene.heights.clone(),
            tolerance,
            total,
            parts: OnceLock::new(),
        })
    }

    fn parts(&self) -> &[HeightIntegral] {
        self.parts.get_or_init(|| {
            let alone = |part: &crate::Part| Density { pieces: vec![part.piece()] };
            let integral =
                |part| HeightIntegral::new(alone(part), self.scale, &self.heights, self.tolerance);
            self.law.parts.iter().map(integral).collect()
        })
    }
}
