//! Laws and compiled scenes, each built once however many methods and points ask for it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use anyhow::Result;
use asperity::{Compiled, Model, Quantity, Request, Scene, Tolerance};

use super::problem::is_slope;

/// What has been built, by all that it depends on.
#[derive(Debug, Default)]
pub struct Laws(Mutex<HashMap<String, Arc<Compiled>>>);

impl Laws {
    /// The compiled scene; laws are shared between scenes of the same asperity.
    ///
    /// # Errors
    /// Those of [`asperity::ContactModel::compile`].
    pub fn compiled(
        &self,
        model: &Model,
        quantity: Quantity,
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Arc<Compiled>> {
        let key = format!("{} {scene:?}", law_key(model, quantity, scene, tolerance)?);
        self.find_or(key, || Ok(self.law(model, quantity, scene, tolerance)?.on(scene)?))
    }

    /// Some compiled scene of the same asperity: its law is built.
    ///
    /// # Errors
    /// Those of [`asperity::ContactModel::compile`].
    pub fn law(
        &self,
        model: &Model,
        quantity: Quantity,
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Arc<Compiled>> {
        self.find_or(law_key(model, quantity, scene, tolerance)?, || {
            // All that comes of one law, so that it is built once for all.
            let same = |other: &Quantity| law_of(model, *other) == law_of(model, quantity);
            let quantities = Quantity::ALL.into_iter().filter(same);
            let request = Request::new(quantities).within(Tolerance::new(tolerance)?);
            Ok(model.compile(scene, &request)?)
        })
    }

    /// What is there, or what is made; should two threads make the same, what came first stays.
    fn find_or(
        &self,
        key: String,
        make: impl FnOnce() -> Result<Compiled>,
    ) -> Result<Arc<Compiled>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let made = Arc::new(make()?);
        let mut shelf = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(shelf.entry(key).or_insert(made).clone())
    }
}

/// The quantity whose law a quantity comes of.
fn law_of(model: &Model, quantity: Quantity) -> Quantity {
    if is_slope(model, quantity) { Quantity::Force } else { quantity }
}

/// What a law depends on.
fn law_key(model: &Model, quantity: Quantity, scene: &Scene, tolerance: f64) -> Result<String> {
    let law = law_of(model, quantity);
    Ok(format!("{model} {law} {tolerance:e} {:?}", scene.asperity()?))
}
