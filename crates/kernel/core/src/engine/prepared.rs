//! A model of one asperity on one scene, prepared for many separations: integrals are built when
//! first needed, and shared by all threads.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::Moments;

use crate::engine::averages::Averages;
use crate::engine::height_integral::{HeightIntegral, LawUnits};
use crate::engine::inverse::force_at::Falls;
use crate::engine::laws::{Laws, any_load};
use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::{At, Contact, ContactError, ContactModel, Law, Quantity, Request, Scene};

/// The part of a request that does not depend on the surface.
#[derive(Debug)]
pub(crate) struct Facts {
    pub(crate) model: String,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) laws: Laws,
}

impl Facts {
    /// # Errors
    /// For inputs that are missing, and the errors of [`Laws::new`].
    pub(crate) fn new(
        model: &dyn ContactModel,
        scene: &Scene,
        request: &Request,
    ) -> Result<Arc<Self>, ContactError> {
        let Request { quantities, at, tolerance, .. } = request;
        let asperity = scene.asperity()?;
        contact_radii::check(quantities, &scene.interface)?;
        Ok(Arc::new(Self {
            model: model.id().into(),
            quantities: quantities.clone(),
            laws: Laws::new(model, asperity, quantities, any_load(at), *tolerance)?,
        }))
    }

    /// The same laws on another scene.
    ///
    /// # Errors
    /// [`ContactError::OtherAsperity`] if its laws would be others.
    pub(crate) fn on(self: &Arc<Self>, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        if !self.laws.are_of(&scene.asperity()?) {
            return Err(ContactError::OtherAsperity);
        }
        contact_radii::check(&self.quantities, &scene.interface)?;
        Ok(Box::new(Prepared::new(self.clone(), scene)?))
    }

    #[inline]
    pub(crate) fn check_requested(&self, quantity: Quantity) -> Result<(), ContactError> {
        match self.quantities.contains(&quantity) {
            true => Ok(()),
            false => Err(ContactError::NotRequested { quantity }),
        }
    }
}

/// The integrals of the laws on one scene.
#[derive(Debug)]
pub(crate) struct Prepared {
    pub(crate) facts: Arc<Facts>,
    pub(crate) scene: Scene,
    pub(crate) channels: Vec<Channel>,
    falls: OnceLock<Result<Option<Arc<Falls>>, ContactError>>,
}

/// The integral of one law.
#[derive(Debug)]
pub(crate) struct Channel {
    /// The quantity of the law.
    pub(crate) base: Quantity,
    pub(crate) law: Arc<Law>,
    pub(crate) units: LawUnits,
    pub(crate) total: HeightIntegral,
    parts: OnceLock<Vec<HeightIntegral>>,
}

impl Prepared {
    pub(crate) fn new(facts: Arc<Facts>, scene: &Scene) -> Result<Self, ContactError> {
        let tolerance = facts.laws.tolerance.relative();
        let channel = |(base, law): &(Quantity, Arc<Law>)| {
            let units = LawUnits::new(*base, law, scene)?;
            let total = HeightIntegral::new(law.density(), law, scene, tolerance);
            Ok(Channel { base: *base, law: law.clone(), units, total, parts: OnceLock::new() })
        };
        let channels = facts.laws.laws.iter().map(channel).collect::<Result<_, _>>()?;
        Ok(Self { facts, scene: scene.clone(), channels, falls: OnceLock::new() })
    }

    /// The integral of the law for `base`.
    #[inline]
    pub(crate) fn channel(&self, base: Quantity) -> Result<&Channel, ContactError> {
        // An error is not made, and dropped, where there is none.
        match self.channels.iter().find(|channel| channel.base == base) {
            Some(channel) => Ok(channel),
            None => Err(ContactError::NotRequested { quantity: base }),
        }
    }

    /// The laws whose integrals a quantity needs.
    pub(crate) fn laws_of(&self, quantity: Quantity) -> impl Iterator<Item = Quantity> + use<> {
        quantity.laws(self.facts.laws.own_stiffness)
    }
}

impl<'p> Averages<'p> for &'p Prepared {
    #[inline]
    fn scene(&self) -> &'p Scene {
        &self.scene
    }

    #[inline]
    fn laws(&self) -> &'p Laws {
        &self.facts.laws
    }

    fn factor(&self, base: Quantity) -> Result<f64, ContactError> {
        Ok(self.channel(base)?.units.factor)
    }

    #[inline(always)]
    fn integral(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<(Moments, f64), ContactError> {
        let Channel { total, units, .. } = self.channel(base)?;
        match if slope { total.at(s) } else { total.value(s) } {
            Ok(moments) => Ok((moments, units.factor)),
            Err(error) => Err(integral_failed(base, at)(error)),
        }
    }

    fn rough_force(&mut self, s: f64) -> Result<Moments, ContactError> {
        let found = self.channel(Quantity::Force)?.total.rough(s);
        found.map_err(integral_failed(Quantity::Force, &s.into()))
    }

    #[inline(always)]
    fn settled(
        &mut self,
        base: Quantity,
        place: (f64, &At),
        slope: bool,
    ) -> Result<(Moments, f64), ContactError> {
        self.integral(base, place, slope)
    }

    fn parts(&mut self, base: Quantity, (s, at): (f64, &At)) -> Result<Vec<Moments>, ContactError> {
        let Channel { law, parts, .. } = self.channel(base)?;
        let tolerance = self.facts.laws.tolerance.relative();
        let of_parts = || {
            let parts = law.share_parts();
            let densities = parts.iter().map(|part| part.density());
            densities.map(|alone| HeightIntegral::new(alone, law, &self.scene, tolerance)).collect()
        };
        let values = parts.get_or_init(of_parts).iter().map(|part| part.value(s));
        values.collect::<Result<_, _>>().map_err(integral_failed(base, at))
    }

    fn rises_above(&self, s: f64) -> Result<bool, ContactError> {
        Ok(self.falls()?.is_none_or(|falls| falls.hides_above(s)))
    }

    fn falls(&self) -> Result<Option<Arc<Falls>>, ContactError> {
        self.falls.get_or_init(|| self.facts.laws.falls(&self.scene)).clone()
    }

    fn guide(&self, _: &Falls, s: f64) -> Result<Moments, ContactError> {
        let found = self.channel(Quantity::Force)?.total.guide(s, true);
        found.map_err(integral_failed(Quantity::Force, &s.into()))
    }
}
