//! Models compared with each other.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::{Check, Weighed};
use asperity_core::{
    AsperityModel, At, Code, Contact, ContactError, Evaluation, Finding, Findings, Quantity,
    Request, Scene, Severity,
};

/// The values of one quantity.
pub(super) type Column = Vec<Evaluation>;

/// The column of a quantity.
pub(super) fn answer(
    contact: &dyn Contact,
    quantity: Quantity,
    places: &[At],
) -> Result<Column, ContactError> {
    places.iter().map(|at| contact.evaluate(quantity, *at)).collect()
}

/// The largest deviation of a quantity from the reference; infinite if one is not a number.
pub(super) fn largest_deviation(quantity: Quantity, found: &Column, wanted: &Column) -> f64 {
    let deviations = found.iter().zip(wanted).map(|(a, b)| a.deviation(b, quantity));
    deviations.fold(0.0, |most: f64, d| most.max(d.map_or(f64::INFINITY, f64::abs)))
}

/// Findings of models at separations or loads of a scene; each model is judged once.
pub(super) struct Judge<'s> {
    pub(super) scene: &'s Scene,
    pub(super) places: &'s [At],
    /// The models that were compiled, by their ids.
    pub(super) contacts: RefCell<BTreeMap<String, Box<dyn Contact>>>,
    pub(super) known: RefCell<BTreeMap<String, Findings>>,
}

impl Judge<'_> {
    fn find<M: Weighed>(
        &self,
        model: &M,
        is_wanted: impl FnMut(&&Finding) -> bool,
    ) -> Option<Finding> {
        let (mut known, contacts) = (self.known.borrow_mut(), self.contacts.borrow());
        let judged = || match contacts.get(model.id()) {
            Some(contact) => Check::answers_of(model, &**contact, self.places),
            None => Check::answers(model, self.scene, self.places),
        };
        known.entry(model.id().into()).or_insert_with(judged).iter().find(is_wanted).cloned()
    }

    /// The finding that makes a model invalid.
    pub(super) fn outside<M: Weighed>(&self, model: &M) -> Option<Finding> {
        self.find(model, |found| found.severity < Severity::Note && found.code.is_of_model())
    }

    /// The finding that contacts merge, where no model of independent asperities is valid.
    pub(super) fn merging<M: Weighed>(&self, model: &M) -> Option<Finding> {
        self.find(model, |found| found.code == Code::Crowded)
    }
}

/// Parts of the law of an asperity; 0 for a model without one.
pub(super) fn regimes<M: Weighed>(model: &M, scene: &Scene, request: &Request) -> usize {
    let law =
        |model: &dyn AsperityModel| model.force(&scene.asperity().ok()?, request.tolerance).ok();
    model.equal().asperity_model().and_then(law).map_or(0, |law| law.parts.len())
}
