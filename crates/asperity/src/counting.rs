//! The number of asperities that touch, as the force of a law.

use crate::{
    Asperity, ContactError, ContactModel, Law, Power, Provenance, Quantity, Source, Tolerance,
};

/// Asperities that all answer 1: their force is the number of contacts.
#[derive(Debug)]
pub(crate) struct Counting;

impl ContactModel for Counting {
    fn source(&self) -> &Source {
        &Source {
            id: "contacts",
            name: "contacts",
            authors: "",
            year: 0,
            title: "",
            provenance: Provenance::Derived,
        }
    }

    fn law(&self, asperity: &Asperity, _: Quantity, _: Tolerance) -> Result<Law, ContactError> {
        let one = [Power::new(1.0, 0.0)];
        Ok(Law::in_units(asperity.radius, 1.0).elastic(0.0..f64::INFINITY, one))
    }
}
