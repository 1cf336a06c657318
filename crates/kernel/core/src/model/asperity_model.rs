//! What to write for a model of one asperity: its laws.

use std::borrow::Cow;

use crate::law::contact_radii;
use crate::request::quantity_table::Derivation;
use crate::{Asperity, ContactError, Described, Law, Quantity, Scene, Tolerance};

/// The laws of one contact of an asperity that has several.
#[derive(Debug, Clone, Copy)]
pub struct OneContact<'m> {
    /// The model of the contact.
    pub model: &'m dyn AsperityModel,
    /// From a law of the contact to that of the asperity.
    pub sum: SumOfContacts,
}

/// See [`OneContact::sum`].
pub type SumOfContacts = fn(Law, &Asperity) -> Result<Law, ContactError>;

/// A model of one asperity, to be written: its averages over the heights, as a
/// [`ContactModel`](crate::ContactModel), come with it.
///
/// Write [`Described::citation`] and the laws of force and area; tangents, contacts, shares and
/// error bounds follow. See the example `own_model` of the crate `asperity`.
///
/// `tolerance` matters only where a law itself is approximated.
///
/// # Errors
/// Every law returns a [`ContactError`] when the asperity is outside the model's range or lacks an
/// input.
#[allow(clippy::missing_errors_doc, reason = "those of all laws are above")]
pub trait AsperityModel: Described {
    /// The scene over whose heights the laws are averaged: the given one, but for models of pairs,
    /// whose heights are the sums of those of two surfaces.
    fn averaged_over<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        Ok(Cow::Borrowed(scene))
    }

    /// The laws of one contact, where those that are averaged are sums over several.
    fn of_one_contact(&self) -> Option<OneContact<'_>> {
        None
    }

    /// The law of the normal force \[N\].
    fn force(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError>;

    /// The law of the contact area \[m²\].
    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError>;

    /// The law of the stiffness \[N/m\], where the model's paper defines another than -dF/dd.
    fn stiffness(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError> {
        let _ = (asperity, tolerance);
        Ok(None)
    }

    /// The law of the number of contacts: 1 from the onset of contact, unless overridden.
    fn contacts(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        if !self.validity().adhesive {
            return Ok(Law::counting(asperity.radius));
        }
        // Adhesion keeps contacts below w = 0, wherever there is an area.
        let area = self.area(asperity, tolerance)?;
        Ok(Law::counting(area.interference_unit).with_onset(area.onset))
    }

    /// The law of the contact radius √(A/π) \[m\]; an error where contacts are not circles.
    fn contact_radius(
        &self,
        asperity: &Asperity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        if self.validity().angles {
            return Err(contact_radii::refused(self.id(), contact_radii::INCLINED));
        }
        contact_radii::law(self.id(), &self.area(asperity, tolerance)?)
    }
}

impl dyn AsperityModel + '_ {
    /// The law whose average over the heights is this quantity.
    ///
    /// # Errors
    /// [`ContactError::NoLaw`] for a quantity that is derived from others,
    /// [`ContactError::Unsupported`] for one that no law has, and those of the law.
    pub fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        let law = match quantity.derivation() {
            Derivation::Integral(law) => Some(law(self, asperity, tolerance)?),
            Derivation::IntegralOrSlope(law, _) => law(self, asperity, tolerance)?,
            Derivation::Map => {
                let what = format!(
                    "{quantity}, which follows from a map of the gap; use boundary elements"
                );
                return Err(ContactError::Unsupported { model: self.id().into(), what });
            }
            Derivation::Flow | Derivation::Gap => {
                let what = format!("{quantity}, which follows from the film alone");
                return Err(ContactError::Unsupported { model: self.id().into(), what });
            }
            _ => None,
        };
        law.ok_or_else(|| ContactError::NoLaw { model: self.id().into(), quantity })
    }
}
