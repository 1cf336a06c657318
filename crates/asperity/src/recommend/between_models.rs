//! Models compared with each other.

use crate::{
    At, Check, Contact, ContactError, ContactModel, Evaluation, Finding, Model, Quantity, Request,
    Scene, Severity,
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

/// The finding that makes a model invalid at these separations or loads.
pub(super) fn outside(model: &Model, scene: &Scene, places: &[At]) -> Option<Finding> {
    let found = Check::answers(model, scene, places).into_iter();
    found.filter(|finding| finding.severity < Severity::Note).find(Finding::is_of_model)
}

/// The finding that contacts merge at one of these separations or loads, where no model of
/// independent asperities is valid.
pub(super) fn merging(model: &Model, scene: &Scene, places: &[At]) -> Option<Finding> {
    Check::answers(model, scene, places).into_iter().find(|finding| finding.code == "crowded")
}

/// Parts of the law of an asperity; 0 for a model without one.
pub(super) fn regimes(model: &Model, scene: &Scene, request: &Request) -> usize {
    let law = |model: &dyn crate::AsperityModel| {
        model.force(&scene.asperity().ok()?, request.tolerance).ok()
    };
    model.equal().asperity_model().and_then(law).map_or(0, |law| law.parts.len())
}
