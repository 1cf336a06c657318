//! Models beside the evidence: the number of contacts, and what adhesion adds to answers by solved
//! surfaces, which do not adhere.

use super::model::Answering;
use crate::check::{LEAST_TABOR, MOST_TABOR};
use crate::recommended::{DMT, JKR};
use asperity_core::{At, Contact, Quantity, Request, Scene, short};

/// The model without adhesion that both extend.
const PLAIN: &str = "gw";
/// A relative change of the area that intervals do not count.
const MATTERS: f64 = 0.05;

/// A quantity of a scene by one model.
#[derive(Debug)]
pub(super) struct ByModel {
    contact: Box<dyn Contact>,
    quantity: Quantity,
}

impl ByModel {
    /// None where the model refuses the scene.
    pub(super) fn new<M: Answering>(id: &str, quantity: Quantity, scene: &Scene) -> Option<Self> {
        // With the force law, which finds the separation of a load.
        let asked = Request::new([quantity]).at([At::Pressure(1.0)]);
        Some(Self { contact: id.parse::<M>().ok()?.contact(scene, &asked).ok()?, quantity })
    }

    /// The value at a mean pressure \[Pa\], if it is known.
    pub(super) fn at(&self, pressure: f64) -> Option<f64> {
        Some(self.contact.evaluate(self.quantity, At::Pressure(pressure)).ok()?.value())
    }
}

/// A model with adhesion beside the same without, on a scene that has a work of adhesion.
#[derive(Debug)]
pub(super) struct Adhesion {
    id: &'static str,
    adhering: ByModel,
    plain: ByModel,
}

impl Adhesion {
    /// None without a work of adhesion.
    pub(super) fn on<M: Answering>(scene: &Scene) -> Option<Self> {
        let tabor = scene.asperity().ok()?.tabor_parameter()?;
        // Between their limits the nearer model.
        let id = if tabor * tabor > LEAST_TABOR * MOST_TABOR { JKR } else { DMT };
        let area = |id| ByModel::new::<M>(id, Quantity::Area, scene);
        Some(Self { id, adhering: area(id)?, plain: area(PLAIN)? })
    }

    /// By how much it changes the area at a mean pressure \[Pa\], if that matters.
    pub(super) fn effect_on_area(&self, pressure: f64) -> Option<String> {
        let ratio = self.adhering.at(pressure)? / self.plain.at(pressure)?;
        let (times, id) = (short(ratio), self.id);
        let text =
            format!("adhesion, which is left out, makes the area {times} times as large by {id}");
        ((ratio - 1.0).abs() > MATTERS).then_some(text)
    }
}
