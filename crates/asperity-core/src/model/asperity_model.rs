//! What to write for a model of one asperity: its laws.

use crate::{Asperity, ContactError, Described, Law, Quantity, Tolerance};

/// A model of one asperity, to be written: its averages over the heights, as a
/// [`ContactModel`](crate::ContactModel), come with it.
///
/// Write [`Described::citation`], and `law` for force and area; tangents, contacts, shares and
/// error bounds follow. See the example `own_model` of the crate `asperity`.
pub trait AsperityModel: Described {
    /// The law of one asperity for force \[N\], area \[m²\] or, where the model's paper defines
    /// another stiffness than -dF/dd, stiffness \[N/m\]; `None` for a quantity without a law.
    ///
    /// `tolerance` matters only where the law itself is approximated.
    ///
    /// # Errors
    /// [`ContactError`] when the asperity is outside the model's range or lacks an input.
    fn law(
        &self,
        asperity: &Asperity,
        quantity: Quantity,
        tolerance: Tolerance,
    ) -> Result<Option<Law>, ContactError>;
}
