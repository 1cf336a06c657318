#![doc = include_str!("../README.md")]

mod antiderivative;
mod integral;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, Contact, ContactError, ContactModel, Described, HeightDistribution,
    Law, Request, Scene, SumOfContacts, Variant, Wraps, contact_of_laws,
};

use integral::integral;

/// A model of upright contacts between the asperities of two rough surfaces.
///
/// Its asperity has the radius R of the contacts, and the density of two like surfaces with as many
/// contacts.
#[derive(Debug, Clone)]
pub struct AsperityPairs(Variant);

impl AsperityPairs {
    /// The laws of `model` between two rough surfaces: `ke` becomes `ke-pairs`.
    #[must_use]
    pub fn new(model: impl ContactModel + 'static) -> Self {
        let differs = "between two rough surfaces, whose asperities meet beside their tops, as by Greenwood & Tripp (1970)";
        let what = "contacts between the asperities of two rough surfaces";
        let mut variant = Variant::new(model, "pairs", differs, what);
        variant.validity.density = true;
        // The force begins as the integral of Hertz' law.
        variant.validity.hertz_limit = None;
        Self(variant)
    }
}

/// The law of an asperity from the law of one of its contacts.
fn sum(one: Law, asperity: &Asperity) -> Result<Law, ContactError> {
    let density = asperity.density.ok_or_else(|| ContactError::Missing {
        field: "asperity_density",
        reason: "models of pairs need it".into(),
    })?;
    // 2π η (β₁ + β₂), with β₁ = β₂ = 2R.
    let contacts = 8.0 * PI * density * asperity.radius;
    let mut law = integral(one);
    law.value_unit *= contacts;
    Ok(law)
}

impl Wraps for AsperityPairs {
    fn inner(&self) -> &dyn Described {
        &self.0
    }
}

impl ContactModel for AsperityPairs {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        self.0.laws(&HeightDistribution::Gaussian).ok()
    }

    fn sum_of_contacts(&self) -> Option<SumOfContacts> {
        Some(sum)
    }

    fn scene_of<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        self.0.laws(&scene.heights)?;
        Ok(Cow::Owned(scene.of_contacts()?))
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, true)
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, false)
    }
}
