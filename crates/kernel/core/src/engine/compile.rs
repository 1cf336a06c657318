//! Models that average the laws of asperities over heights, as contact models.

use crate::engine::alone::Alone;
use crate::engine::list::is_short;
use crate::engine::prepared::{Facts, Prepared};
use crate::{AsperityModel, Contact, ContactError, ContactModel, Request, Scene};

/// A model that averages laws of asperities over heights, on a scene: `prepared` for many places
/// ([`ContactModel::compile`]), or as the places of the request suggest ([`ContactModel::contact`]).
///
/// # Errors
/// The errors of [`ContactModel::compile`].
pub fn contact_of_laws(
    model: &dyn ContactModel,
    scene: &Scene,
    request: &Request,
    prepared: bool,
) -> Result<Box<dyn Contact>, ContactError> {
    let scene = model.scene_of(scene)?;
    let facts = Facts::new(model, &scene, request)?;
    Ok(match prepared || !is_short(request, &scene) {
        true => Box::new(Prepared::new(facts, &scene)?),
        false => Box::new(Alone::new(facts, &scene)?),
    })
}

impl<M: AsperityModel> ContactModel for M {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        Some(self)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, true)
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, false)
    }
}
