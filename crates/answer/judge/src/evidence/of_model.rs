//! The compared quantities of a model.

use crate::evidence::case::Compared;
use asperity_core::{At, Contact, ContactError, Datum, Quantity, SeparationUnit};

impl Compared {
    /// The quantities of a contact that are compared; the mean gap is none.
    pub const QUANTITIES: [Quantity; 3] =
        [Quantity::Area, Quantity::Tangent, Quantity::UnloadingStiffness];

    /// The value of a model at a place: area over nominal area, stiffness \[N/m\], mean gap \[m\].
    ///
    /// # Errors
    /// Those of the contact, which must be compiled for the area, the tangent and the unloading
    /// stiffness.
    pub fn of_contact(self, contact: &dyn Contact, at: At) -> Result<f64, ContactError> {
        let Some(quantity) = self.quantity() else {
            return contact.separation_in(SeparationUnit::Metres, Datum::SurfaceMean, at);
        };
        let unit = if self == Self::Area { contact.scene().nominal_area } else { 1.0 };
        Ok(contact.evaluate(quantity, at)?.value() / unit)
    }

    /// The compared quantity from which a quantity at a load follows.
    #[must_use]
    pub fn behind(quantity: Quantity) -> Option<Self> {
        match quantity {
            Quantity::Area | Quantity::AreaFraction | Quantity::MeanPressure | Quantity::LnArea => {
                Some(Self::Area)
            }
            Quantity::Tangent => Some(Self::Stiffness),
            radii if radii.needs_circles() => Some(Self::UnloadingStiffness),
            _ => None,
        }
    }
}

/// Quantities that a model does not have, and why.
pub(crate) type Lacking = Vec<(Quantity, ContactError)>;

/// A contact compiled for those of the quantities that the model has, and why it lacks the others;
/// `compile` makes it for some of them. Without any, it is made for those `otherwise`.
///
/// # Errors
/// The errors of the model for all quantities, if it has none and there is nothing otherwise.
pub fn compile_known(
    quantities: &[Quantity],
    otherwise: &[Quantity],
    compile: impl Fn(&[Quantity]) -> Result<Box<dyn Contact>, ContactError>,
) -> Result<(Box<dyn Contact>, Lacking), ContactError> {
    let whole = match compile(quantities) {
        Ok(contact) => return Ok((contact, vec![])),
        Err(whole) => whole,
    };
    let refusal = |q: &Quantity| Some((*q, compile(&[*q]).err()?));
    let lacking: Lacking = quantities.iter().filter_map(refusal).collect();
    let mut had = quantities.to_vec();
    had.retain(|q| lacking.iter().all(|(lacks, _)| lacks != q));
    let had = if had.is_empty() { otherwise.to_vec() } else { had };
    match had.is_empty() {
        true => Err(whole),
        false => Ok((compile(&had).map_err(|_| whole)?, lacking)),
    }
}
