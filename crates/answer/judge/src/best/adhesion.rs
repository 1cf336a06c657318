//! What adhesion adds to answers by solved surfaces, which do not adhere.

use super::model::Answering;
use crate::check::{LEAST_TABOR, MOST_TABOR};
use crate::recommended::{DMT, JKR};
use asperity_core::{At, Contact, Quantity, Request, Scene, short};

/// The model without adhesion that both extend.
const PLAIN: &str = "gw";
/// A relative change of the area that intervals do not count.
const MATTERS: f64 = 0.05;

/// A model with adhesion beside the same without, on a scene that has a work of adhesion.
#[derive(Debug)]
pub(super) struct Adhesion {
    id: &'static str,
    adhering: Box<dyn Contact>,
    plain: Box<dyn Contact>,
}

impl Adhesion {
    /// None without a work of adhesion.
    pub(super) fn on<M: Answering>(scene: &Scene) -> Option<Self> {
        let tabor = scene.asperity().ok()?.tabor_parameter()?;
        // Between their limits the nearer model.
        let id = if tabor * tabor > LEAST_TABOR * MOST_TABOR { JKR } else { DMT };
        let asked = Request::new([Quantity::Area]).at([At::Pressure(1.0)]);
        let contact = |id: &str| id.parse::<M>().ok()?.contact(scene, &asked).ok();
        Some(Self { id, adhering: contact(id)?, plain: contact(PLAIN)? })
    }

    /// By how much it changes the area at a mean pressure \[Pa\], if that matters.
    pub(super) fn effect_on_area(&self, pressure: f64) -> Option<String> {
        let area = |contact: &dyn Contact| {
            Some(contact.evaluate(Quantity::Area, At::Pressure(pressure)).ok()?.value())
        };
        let ratio = area(&*self.adhering)? / area(&*self.plain)?;
        let text = || {
            format!(
                "adhesion, which is left out, makes the area {} times as large by {}",
                short(ratio),
                self.id
            )
        };
        ((ratio - 1.0).abs() > MATTERS).then(text)
    }
}
