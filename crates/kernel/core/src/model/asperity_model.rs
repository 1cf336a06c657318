//! What to write for a model of one asperity: its laws.

use crate::law::contact_radii;
use crate::request::quantity::LEAK;
use crate::request::quantity_table::Derivation;
use crate::{Asperity, ContactError, Described, Law, Quantity, Tolerance};

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
pub(crate) fn law(
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
        (_, Derivation::Flow | Derivation::Gap) => {
            unsupported(format!("{quantity}, which follows from the film alone"))
        }
        _ => Err(lacking()),
    }
}
