//! How many asperities of a scene touch: one count for every model that is compared with boundary
//! elements.

use super::model::Answering;
use crate::recommended::usual_reference;
use asperity_core::{At, Contact, ContactError, Quantity, Request, Scene};

/// Counts the asperities in contact at a load. Counts of models differ, by orders of magnitude with
/// rough asperities on asperities, and the scatter of a surface does not depend on the model.
#[derive(Debug)]
pub(crate) struct Counted(Option<Box<dyn Contact>>);

impl Counted {
    /// By the usual reference of the scene.
    pub(crate) fn on<M: Answering>(scene: &Scene) -> Result<Self, ContactError> {
        // With the force law, which finds the separation of a load.
        let asked = Request::new([Quantity::Contacts]).at([At::Pressure(1.0)]);
        Ok(Self(usual_reference(scene).parse::<M>()?.contact(scene, &asked).ok()))
    }

    /// Contacts at a mean pressure \[Pa\]; `None` if unknown.
    pub(crate) fn at(&self, pressure: f64) -> Option<f64> {
        let found = self.0.as_ref()?.evaluate(Quantity::Contacts, At::Pressure(pressure));
        Some(found.ok()?.value())
    }
}
