//! A contact model: named, swapped, applied to scenes.

use std::borrow::Cow;

use crate::engine::alone::Alone;
use crate::engine::list::is_short;
use crate::engine::prepared::{Facts, Prepared};
use crate::{
    Asperity, AsperityModel, Contact, ContactError, Described, Law, Quantity, Request, Response,
    Scene, Tolerance,
};

/// A model of rough surfaces in contact.
///
/// Every [`AsperityModel`] is one. A model that is not an average over heights (a closed form, a
/// theory of the whole surface, a table) implements this trait and [`Contact`].
pub trait ContactModel: Described {
    /// The model of one asperity that it averages, if there is one.
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        None
    }

    /// Prepares a scene for many evaluations of the requested quantities.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing.
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError>;

    /// Prepares a scene for the places of this request alone: no tables are made for others.
    ///
    /// # Errors
    /// Those of [`compile`](Self::compile).
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

impl dyn ContactModel + '_ {
    /// The law of one asperity for a quantity.
    ///
    /// # Errors
    /// [`ContactError::NoLaw`] if the model has none, and those of the law.
    pub fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        match self.asperity_model() {
            Some(model) => model.law(asperity, quantity, tolerance),
            None => Err(ContactError::NoLaw { model: self.id().into(), quantity }),
        }
    }

    /// The scene of a contact of this model on a scene, on which separations are counted: see
    /// [`AsperityModel::averaged_over`].
    ///
    /// # Errors
    /// Those of [`AsperityModel::averaged_over`].
    pub fn averaged_over<'s>(&self, scene: &'s Scene) -> Result<Cow<'s, Scene>, ContactError> {
        self.asperity_model().map_or(Ok(Cow::Borrowed(scene)), |one| one.averaged_over(scene))
    }
}

impl<M: AsperityModel> ContactModel for M {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        Some(self)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        let scene = self.averaged_over(scene)?;
        Ok(Box::new(Prepared::new(Facts::new(self, &scene, request)?, &scene)?))
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        match is_short(request, scene) {
            true => {
                let scene = self.averaged_over(scene)?;
                Ok(Box::new(Alone::new(Facts::new(self, &scene, request)?, &scene)?))
            }
            false => self.compile(scene, request),
        }
    }
}
