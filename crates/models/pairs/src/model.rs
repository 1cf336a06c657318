//! The laws of an asperity that meets those of another rough surface.

use std::borrow::Cow;
use std::f64::consts::PI;

use asperity_core::{
    Asperity, AsperityModel, ContactError, ContactModel, HeightDistribution, IsVariant, Law,
    OneContact, Scene, Tolerance, Variant,
};

use crate::integral::integral;

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

    /// The law of an asperity; `one` is that of one of its contacts.
    fn law(
        &self,
        asperity: &Asperity,
        one: impl Fn(&dyn AsperityModel, &Asperity) -> Result<Law, ContactError>,
    ) -> Result<Law, ContactError> {
        sum(
            one(self.0.laws(&HeightDistribution::Gaussian)?, &self.one_contact(asperity))?,
            asperity,
        )
    }

    /// An asperity as the law of one contact sees it: with a density if that depends on it.
    fn one_contact(&self, asperity: &Asperity) -> Asperity {
        let density = asperity.density.filter(|_| self.0.model().validity().density);
        Asperity { density, ..*asperity }
    }
}

/// The law of an asperity from that of one of its contacts.
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

impl IsVariant for AsperityPairs {
    fn of(&self) -> &Variant {
        &self.0
    }
}

impl AsperityModel for AsperityPairs {
    fn averaged_over<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        self.0.laws(&scene.heights)?;
        Ok(Cow::Owned(scene.of_contacts()?))
    }

    fn of_one_contact(&self) -> Option<OneContact<'_>> {
        Some(OneContact { model: self.0.model().asperity_model()?, sum })
    }

    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, |one, own| one.force(own, tolerance))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, |one, own| one.area(own, tolerance))
    }

    fn stiffness(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let laws = self.0.laws(&HeightDistribution::Gaussian)?;
        let one = laws.stiffness(&self.one_contact(asperity), tolerance)?;
        one.map(|one| sum(one, asperity)).transpose()
    }

    fn contacts(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.law(asperity, |one, own| one.contacts(own, tolerance))
    }

    fn contact_radius(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        self.law(asperity, |one, own| one.contact_radius(own, tolerance))
    }
}
