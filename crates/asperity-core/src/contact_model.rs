//! A model to be named, swapped and put on a scene.

use std::fmt;

use crate::compiled::Compiled;
use crate::few::few;
use crate::{
    Asperity, AsperityModel, Claims, Contact, ContactError, Law, Quantity, Request, Response,
    Scene, Source, Tolerance, Warning,
};

/// A model of rough surfaces in contact: to be named, swapped and asked.
///
/// Every [`AsperityModel`] is one. A model that is no average over heights (a closed form, a
/// whole-surface theory, a table) implements this trait itself, and a [`Contact`].
pub trait ContactModel: fmt::Debug + Send + Sync {
    /// Its names, and where the model comes from.
    fn source(&self) -> &Source;

    /// Short name in lower case: `ke`.
    fn id(&self) -> &str {
        self.source().id
    }

    /// The acronym: `KE`.
    fn name(&self) -> &str {
        self.source().name
    }

    /// What the model says of itself.
    fn claims(&self) -> Claims {
        Claims::default()
    }

    /// What a user of these options should know.
    fn notes(&self) -> Vec<Warning> {
        vec![]
    }

    /// The laws of one asperity behind it, if there are any.
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        None
    }

    /// Prepares a scene for many evaluations of the request's quantities, and of nothing else.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing.
    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError>;

    /// Answers a request, row by row.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is out of range or missing. What fails in one row
    /// alone stands in that row of the answer.
    fn solve(&self, scene: &Scene, request: &Request) -> Result<Response, ContactError> {
        Ok(self.compile(scene, request)?.respond(request))
    }
}

impl dyn ContactModel + '_ {
    /// The law of one asperity for a quantity.
    ///
    /// # Errors
    /// [`ContactError::NoLaw`] where the model has none, and those of [`AsperityModel::law`].
    pub fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Law, ContactError> {
        let law = match self.asperity_model() {
            Some(model) => model.law(asperity, quantity, tolerance)?,
            None => None,
        };
        law.ok_or_else(|| ContactError::NoLaw { model: self.name().into(), quantity })
    }
}

impl<M: AsperityModel> ContactModel for M {
    fn source(&self) -> &Source {
        AsperityModel::source(self)
    }

    fn id(&self) -> &str {
        AsperityModel::id(self)
    }

    fn name(&self) -> &str {
        AsperityModel::name(self)
    }

    fn claims(&self) -> Claims {
        AsperityModel::claims(self)
    }

    fn notes(&self) -> Vec<Warning> {
        AsperityModel::notes(self)
    }

    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        Some(self)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        Ok(Box::new(Compiled::new(self, scene, request)?))
    }

    fn solve(&self, scene: &Scene, request: &Request) -> Result<Response, ContactError> {
        match few(self, scene, request)? {
            Some(answer) => Ok(answer),
            None => Ok(Compiled::new(self, scene, request)?.respond(request)),
        }
    }
}
