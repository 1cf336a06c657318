//! Laws and compiled scenes, each built once however many methods and points ask for it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use anyhow::Result;
use asperity::{Compiled, Model, Quantity, Request, Scene, Tolerance};

/// Compiled scenes by all that they depend on.
#[derive(Debug, Default)]
pub struct Laws {
    known: Mutex<HashMap<String, Arc<Compiled>>>,
}

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
        let whole = format!("{model} {quantity} {tolerance:e} {scene:?}");
        if let Some(known) = self.find(&whole) {
            return Ok(known);
        }
        let asperity = format!("{model} {quantity} {tolerance:e} {:?}", scene.asperity()?);
        let first = match self.find(&asperity) {
            Some(known) => known,
            None => {
                let request = Request::new([quantity]).within(Tolerance::new(tolerance)?);
                self.keep(asperity, model.compile(scene, &request)?)
            }
        };
        Ok(self.keep(whole, first.on(scene)?))
    }

    fn find(&self, key: &str) -> Option<Arc<Compiled>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).get(key).cloned()
    }

    /// Keeps what came first, should two threads have built the same.
    fn keep(&self, key: String, compiled: Compiled) -> Arc<Compiled> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.entry(key).or_insert_with(|| Arc::new(compiled)).clone()
    }
}
