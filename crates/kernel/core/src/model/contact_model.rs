//! A contact model: named, swapped, applied to scenes.

use std::borrow::Cow;

use crate::model::asperity_model;
use crate::{
    Asperity, AsperityModel, Contact, ContactError, Described, Law, Quantity, Request, Response,
    Scene, Tolerance,
};

/// From a law of one contact to the law of an asperity that has several.
pub type SumOfContacts = fn(Law, &Asperity) -> Result<Law, ContactError>;

/// A model of rough surfaces in contact.
///
/// Every [`AsperityModel`] is one. A model that is not an average over heights (a closed form, a
/// theory of the whole surface, a table) implements this trait and
/// [`ContactEngine`](crate::ContactEngine).
pub trait ContactModel: Described {
    /// The laws of one contact that it averages over heights, if there are any.
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        None
    }

    /// For a model of pairs, whose asperities have several contacts: from the law of one contact
    /// to that which is averaged.
    fn sum_of_contacts(&self) -> Option<SumOfContacts> {
        None
    }

    /// The scene of a contact of this model on a scene, on which separations are counted: the given
    /// one, but for models of pairs, whose heights are the sums over two surfaces.
    ///
    /// # Errors
    /// [`ContactError`] naming what the model of pairs refuses.
    fn scene_of<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        Ok(Cow::Borrowed(scene))
    }

    /// The law of one asperity whose average over the heights is this quantity.
    ///
    /// # Errors
    /// [`ContactError::NoLaw`] for a quantity that is derived from others or that the model lacks,
    /// [`ContactError::Unsupported`] for one that no law has, and the errors of the law.
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        let Some(model) = self.asperity_model() else {
            return Err(ContactError::NoLaw { model: self.id().into(), quantity });
        };
        let law =
            |own: &Asperity| asperity_model::law((model, self.id()), own, quantity, tolerance);
        match self.sum_of_contacts() {
            Some(sum) => sum(law(&asperity.seen_by(model.validity().density))?, asperity),
            None => law(asperity),
        }
    }

    /// Prepares a scene for many evaluations of the requested quantities.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing.
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError>;

    /// Prepares a scene for the places of this request alone: no tables are made for others.
    ///
    /// # Errors
    /// The errors of [`compile`](Self::compile).
    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        self.compile(scene, request)
    }

    /// Answers a request, row by row.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing. The error of a single row
    /// stands in that row of the response.
    fn solve(&self, scene: &Scene, request: &Request) -> Result<Response, ContactError> {
        Ok(self.contact(scene, request)?.respond(request))
    }
}
