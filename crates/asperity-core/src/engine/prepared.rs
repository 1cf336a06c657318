//! A model of one asperity on one scene, prepared for many separations: integrals are built when
//! first needed, and shared by all threads.

use std::sync::Arc;

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, all_parts};
use crate::engine::channel::{Channel, Units};
use crate::engine::inverse::force_at::Falls;
use crate::engine::laws::{Laws, any_load};
use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::{AsperityModel, At, ContactError, Finding, Law, Quantity, Request, Scene, Tolerance};

/// The part of a request that does not depend on the surface.
#[derive(Debug)]
pub(crate) struct Facts {
    pub(crate) model: String,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) laws: Laws,
    pub(crate) notes: Vec<Finding>,
    pub(crate) tolerance: Tolerance,
}

impl Facts {
    /// # Errors
    /// For inputs that are missing, and those of [`Laws::new`].
    pub(crate) fn new(
        model: &dyn AsperityModel,
        scene: &Scene,
        request: &Request,
    ) -> Result<Self, ContactError> {
        let Request { quantities, at, tolerance, .. } = request;
        let asperity = scene.asperity()?;
        contact_radii::check(quantities, &scene.interface)?;
        Ok(Self {
            model: model.name().into(),
            quantities: quantities.clone(),
            laws: Laws::new(model, asperity, quantities, any_load(at), *tolerance)?,
            notes: model.notes(),
            tolerance: *tolerance,
        })
    }
}

/// The integrals of the laws on one scene.
#[derive(Debug)]
pub(crate) struct Prepared {
    pub(crate) facts: Arc<Facts>,
    pub(crate) scene: Scene,
    pub(crate) channels: Vec<Channel>,
}

impl Prepared {
    pub(crate) fn new(facts: Arc<Facts>, scene: &Scene) -> Result<Self, ContactError> {
        let channel = |(base, law): &(Quantity, Arc<Law>)| {
            Channel::new(*base, law.clone(), scene, facts.tolerance)
        };
        let channels = facts.laws.laws.iter().map(channel).collect::<Result<_, _>>()?;
        Ok(Self { facts, scene: scene.clone(), channels })
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

    /// The law of a quantity that needs a single one.
    pub(crate) fn single_law(&self, quantity: Quantity) -> Option<Quantity> {
        let mut laws = self.laws_of(quantity);
        laws.next().filter(|_| laws.next().is_none())
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

    #[inline]
    fn tolerance(&self) -> Tolerance {
        self.facts.tolerance
    }

    #[inline]
    fn units(&self, base: Quantity) -> Result<Units, ContactError> {
        Ok(self.channel(base)?.units)
    }

    #[inline]
    fn integral(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<Moments, ContactError> {
        let total = &self.channel(base)?.total;
        let found = if slope { total.at(s) } else { total.value(s) };
        found.map_err(integral_failed(base, at))
    }

    #[inline(always)]
    fn settled(
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

    fn parts(
        &mut self,
        base: Quantity,
        (s, at): (f64, &At),
        slope: bool,
    ) -> Result<Vec<Moments>, ContactError> {
        let parts = self.channel(base)?.parts().iter();
        let integrals = parts.map(|part| if slope { part.at(s) } else { part.value(s) });
        all_parts(integrals, base, at)
    }

    fn rises_above(&self, s: f64) -> Result<bool, ContactError> {
        let falls = self.falls()?;
        Ok(falls.is_none_or(|falls| falls.hides_above(s)))
    }

    fn falls(&self) -> Result<Option<Arc<Falls>>, ContactError> {
        self.channel(Quantity::Force)?.falls(&self.facts.laws)
    }

    fn guide(&self, _: &Falls, s: f64) -> Result<Moments, ContactError> {
        let found = self.channel(Quantity::Force)?.total.guide(s, true);
        found.map_err(integral_failed(Quantity::Force, &s.into()))
    }

    #[inline]
    fn check_requested(&self, quantity: Quantity) -> Result<(), ContactError> {
        match self.facts.quantities.contains(&quantity) {
            true => Ok(()),
            false => Err(ContactError::NotRequested { quantity }),
        }
    }
}
