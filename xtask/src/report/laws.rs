//! Laws, compiled scenes and rules, each built once however many methods and points ask for it.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

use anyhow::Result;
use asperity::{Compiled, Model, Quantity, Request, Scene, Tolerance};
use asperity_quadrature::AnyScale;

use super::problem::is_slope;

/// What has been built, by all that it depends on.
#[derive(Debug, Default)]
pub struct Laws {
    compiled: Shelf<Compiled>,
    rules: Shelf<AnyScale>,
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
        let law = law_key(model, quantity, scene, tolerance)?;
        self.compiled.find_or(format!("{law} {scene:?}"), || {
            let first = self.compiled.find_or(law, || {
                // All that comes of one law, so that it is built once for all.
                let same = |other: &Quantity| {
                    *other == quantity
                        || (is_slope(model, quantity) || quantity == Quantity::Force)
                            && (is_slope(model, *other) || *other == Quantity::Force)
                };
                let quantities = Quantity::ALL.into_iter().filter(same);
                let request = Request::new(quantities).within(Tolerance::new(tolerance)?);
                Ok(model.compile(scene, &request)?)
            })?;
            Ok(first.on(scene)?)
        })
    }

    /// The rules of a law for every scene of its asperity.
    ///
    /// # Errors
    /// Those of [`asperity::ContactModel::compile`].
    pub fn rules(
        &self,
        model: &Model,
        quantity: Quantity,
        scene: &Scene,
        tolerance: f64,
    ) -> Result<Arc<AnyScale>> {
        self.rules.find_or(law_key(model, quantity, scene, tolerance)?, || {
            let compiled = self.compiled(model, quantity, scene, tolerance)?;
            Ok(AnyScale::new(compiled.law(quantity)?.density(), tolerance))
        })
    }
}

/// What a law depends on.
fn law_key(model: &Model, quantity: Quantity, scene: &Scene, tolerance: f64) -> Result<String> {
    let law = if is_slope(model, quantity) { Quantity::Force } else { quantity };
    Ok(format!("{model} {law} {tolerance:e} {:?}", scene.asperity()?))
}

#[derive(Debug)]
struct Shelf<T>(Mutex<HashMap<String, Arc<T>>>);

impl<T> Default for Shelf<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> Shelf<T> {
    /// What is there, or what is made; should two threads make the same, what came first stays.
    fn find_or(&self, key: String, make: impl FnOnce() -> Result<T>) -> Result<Arc<T>> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner).get(&key).cloned();
        if let Some(known) = known {
            return Ok(known);
        }
        let made = Arc::new(make()?);
        let mut shelf = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        Ok(shelf.entry(key).or_insert(made).clone())
    }
}
