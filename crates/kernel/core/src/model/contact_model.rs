//! Models: the laws of one asperity, to be written, and contact models, to be called.

use std::borrow::Cow;

use crate::law::contact_radii;
use crate::request::quantity::LEAK;
use crate::request::quantity_table::Derivation;
use crate::{
    Asperity, Contact, ContactError, Described, Law, Quantity, Request, Response, Scene, Tolerance,
};

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

/// The law of a model for a quantity; `id` is the name of the model in errors.
///
/// # Errors
/// The errors of [`ContactModel::law`](crate::ContactModel::law).
fn law_of(
    (model, id): (&dyn AsperityModel, &str),
    asperity: &Asperity,
    quantity: Quantity,
    tolerance: Tolerance,
) -> Result<Law, ContactError> {
    let unsupported = |what| Err(ContactError::Unsupported { model: id.into(), what });
    let lacking = || ContactError::NoLaw { model: id.into(), quantity };
    match (quantity, quantity.derivation()) {
        (Quantity::Force, _) => model.force(asperity, tolerance),
        (Quantity::Area, _) => model.area(asperity, tolerance),
        (Quantity::Stiffness, _) => model.stiffness(asperity, tolerance)?.ok_or_else(lacking),
        (Quantity::Contacts, _) => model.contacts(asperity, tolerance),
        (Quantity::ContactRadiusSum, _) => model.contact_radius(asperity, tolerance),
        (_, Derivation::Map) => {
            let what = "which follows from a map of the gap; use boundary elements";
            unsupported(format!("{quantity}, {what}"))
        }
        (_, Derivation::Seal) => unsupported(LEAK.into()),
        (_, Derivation::Bodies) => unsupported(format!(
            "{quantity} of flat surfaces; [curvature] in the scene describes curved bodies"
        )),
        (_, Derivation::Flow) => {
            unsupported(format!("{quantity}, which follows from the film alone"))
        }
        (_, Derivation::Gap) => unsupported(format!(
            "{quantity}, which needs the gas of [gap]: ask the scene for an answer"
        )),
        _ => Err(lacking()),
    }
}

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
        let law = |own: &Asperity| law_of((model, self.id()), own, quantity, tolerance);
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
