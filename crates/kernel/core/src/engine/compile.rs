//! Models that average the laws of asperities over heights, as contact models.

use crate::engine::alone::Alone;
use crate::engine::list::is_short;
use crate::engine::prepared::{Facts, Prepared};
use crate::{AsperityModel, Contact, ContactError, ContactModel, Request, Scene};

/// [`ContactModel::compile`] of a model that averages laws of asperities over heights.
///
/// # Errors
/// The errors of [`ContactModel::compile`].
pub fn compile_laws(
    model: &dyn ContactModel,
    scene: &Scene,
    request: &Request,
) -> Result<Box<dyn Contact>, ContactError> {
    let scene = model.scene_of(scene)?;
    Ok(Box::new(Prepared::new(Facts::new(model, &scene, request)?, &scene)?))
}

/// [`ContactModel::contact`] of such a model.
///
/// # Errors
/// The errors of [`ContactModel::compile`].
pub fn contact_of_laws(
    model: &dyn ContactModel,
    scene: &Scene,
    request: &Request,
) -> Result<Box<dyn Contact>, ContactError> {
    if !is_short(request, scene) {
        return compile_laws(model, scene, request);
    }
    let scene = model.scene_of(scene)?;
    Ok(Box::new(Alone::new(Facts::new(model, &scene, request)?, &scene)?))
}

impl<M: AsperityModel> ContactModel for M {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        Some(self)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        compile_laws(self, scene, request)
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request)
    }
}
