//! A scene prepared for many evaluations.

use asperity_quadrature::{AnyScale, Curvature, Moments};

use crate::channel::{Channel, check_scales, failed, law_of};
use crate::evaluation::Units;
use crate::height_integral::HeightIntegral;
use crate::request::checked_separation;
use crate::{
    Asperity, ContactError, ContactModel, Evaluation, HeightDistribution, Interface, Law, Quantity,
    Request, Scene, Share, Warning,
};

/// A model applied to a scene: integrals are built when first needed, and shared by all threads.
#[derive(Debug)]
pub struct Compiled {
    model: String,
    quantities: Vec<Quantity>,
    asperity: Asperity,
    /// What the asperity was made of.
    interface: Interface,
    channels: Vec<Channel>,
    /// For each quantity, which channel it comes of.
    sources: Vec<usize>,
    height_std: f64,
    separation_rounding: f64,
    warnings: Vec<Warning>,
    monotone: bool,
    heights: HeightDistribution,
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
            interface: scene.interface,
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
        self.check_other(scene)?;
        let channels = self
            .channels
            .iter()
            .map(|c| Channel::new(c.quantity, c.law.clone(), scene, c.tolerance))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            model: self.model.clone(),
            quantities: self.quantities.clone(),
            asperity: self.asperity,
            interface: self.interface,
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
        self.evaluation(channel, quantity, s, &moments)
    }

    /// Force \[N\] and tangent -dF/dd \[N/m\] at a separation d/σ_z, in one pass over the same nodes:
    /// for codes that step in time.
    ///
    /// # Errors
    /// Those of [`evaluate`](Self::evaluate); either of the two must have been asked for.
    pub fn force_and_tangent(
        &self,
        separation: f64,
    ) -> Result<(Evaluation, Evaluation), ContactError> {
        let channel = self.channel(Quantity::Force).or_else(|_| self.channel(Quantity::Tangent))?;
        let s = checked_separation(separation)?;
        let moments = channel.total.at(s).map_err(failed(Quantity::Force, s))?;
        let of = |quantity| self.evaluation(channel, quantity, s, &moments);
        Ok((of(Quantity::Force)?, of(Quantity::Tangent)?))
    }

    /// A quantity on another scene of the same asperities, at its separation d/σ_z: another
    /// roughness, density, nominal area or kind of heights. Nothing is prepared for the scene.
    ///
    /// # Errors
    /// Those of [`on`](Self::on) and [`evaluate`](Self::evaluate).
    pub fn evaluate_on(
        &self,
        scene: &Scene,
        quantity: Quantity,
        separation: f64,
    ) -> Result<Evaluation, ContactError> {
        let channel = self.channel(quantity)?;
        let s = checked_separation(separation)?;
        self.check_other(scene)?;
        let law = &channel.law;
        let height_std = scene.surface.asperity_height_std;
        let units = Units { factor: scene.asperities() * law.value_unit, height_std };
        let scale = law.interference_unit / height_std;
        check_scales(quantity, units.factor, scale, height_std)?;
        let is_value = quantity == channel.quantity;
        let moments = if matches!(scene.heights, HeightDistribution::Gaussian) {
            let rules =
                channel.elsewhere.get_or_init(|| AnyScale::new(law.density(), channel.tolerance));
            if is_value { rules.value(s, scale) } else { rules.at(s, scale) }
        } else {
            HeightIntegral::new(law.density(), scale, &scene.heights, channel.tolerance).at(s)
        };
        let moments = moments.map_err(failed(quantity, s))?;
        if is_value {
            Evaluation::of_value(&moments, units).held(moments.sizes[0], quantity)
        } else {
            Evaluation::of_slope(&moments, units).held(moments.sizes[1], quantity)
        }
    }

    /// d²Q/dd² \[unit of Q over m²\] of a quantity that has a law of its own, from the nodes of its
    /// value; jumps and kinks of the law included.
    ///
    /// The derivative of the tangent is that of the force, negative: -d²F/dd².
    ///
    /// # Errors
    /// Those of [`evaluate`](Self::evaluate), and [`ContactError::NoSecondDerivative`] for
    /// tangents and for heights that are not Gaussian.
    pub fn second_derivative(
        &self,
        quantity: Quantity,
        separation: f64,
    ) -> Result<Evaluation, ContactError> {
        let channel = self.channel(quantity)?;
        let s = checked_separation(separation)?;
        let curvature =
            (quantity == channel.quantity).then(|| channel.total.curvature(s)).flatten();
        let Some(curvature) = curvature else {
            return Err(ContactError::NoSecondDerivative { quantity });
        };
        let Curvature { value, size, ln_scale, error } = curvature.map_err(failed(quantity, s))?;
        let integral = size;
        // Divided twice, so that no square of a small number underflows.
        let [scaled, size] =
            [value, size].map(|x| x * channel.factor / self.height_std / self.height_std);
        Evaluation { scaled, ln_scale, size, error }.held(integral, quantity)
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
    ) -> Result<Evaluation, ContactError> {
        let units = Units { factor: channel.factor, height_std: self.height_std };
        // A channel's own quantity is its integral; what else comes of it is a slope.
        let evaluation = if quantity == channel.quantity {
            Evaluation::of_value(moments, units).held(moments.sizes[0], quantity)?
        } else {
            Evaluation::of_slope(moments, units).held(moments.sizes[1], quantity)?
        };
        Ok(evaluation.with_rounding(self.separation_rounding, separation, moments))
    }

    /// Whether the laws hold on another scene.
    fn check_other(&self, scene: &Scene) -> Result<(), ContactError> {
        scene.check_surface()?;
        let same_radius = scene.surface.asperity_radius.to_bits() == self.asperity.radius.to_bits();
        if (same_radius && scene.interface == self.interface) || scene.asperity()? == self.asperity
        {
            return Ok(());
        }
        Err(ContactError::OtherAsperity)
    }

    fn channel(&self, quantity: Quantity) -> Result<&Channel, ContactError> {
        let place = self.quantities.iter().position(|q| *q == quantity);
        let channel = place.and_then(|k| self.channels.get(*self.sources.get(k)?));
        channel.ok_or(ContactError::NotRequested { quantity })
    }
}
