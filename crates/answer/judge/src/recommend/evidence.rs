//! The evidence at the separations and loads of a request.

use serde::Serialize;

use crate::evidence::Counted;
use crate::{Compared, Evidence, ExpectedContact, Ratio, SurfaceShape, Unlike, Weighed};
use asperity_core::{At, Contact, ContactError, Quantity, Request};

/// Most separations and loads that are compared with boundary elements.
const MOST: usize = 24;

/// Evidence for a separation or load.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct EvidenceAt {
    /// The separation or load.
    pub at: At,
    /// What boundary elements are expected to give, or why that is not known.
    pub expected: Result<ExpectedContact, ContactError>,
    /// Every model that has a value, relative to it.
    pub ratios: Vec<Expectation>,
}

/// The expected ratio of a quantity of a model to boundary elements.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Expectation {
    /// The id of the model.
    pub model: String,
    /// The quantity.
    pub quantity: Compared,
    /// The ratio and its interval.
    pub ratio: Ratio,
}

/// The quantities in which models are ranked; mean gaps are not relative.
const RELATIVE: [Compared; 3] = [Compared::Area, Compared::Stiffness, Compared::UnloadingStiffness];

impl EvidenceAt {
    /// The ratio of a quantity of a model, if it is known.
    #[must_use]
    pub fn ratio(&self, id: &str, quantity: Compared) -> Option<Ratio> {
        let wanted = |found: &&Expectation| found.model == id && found.quantity == quantity;
        self.ratios.iter().find(wanted).map(|found| found.ratio)
    }

    /// The ratios of a model in the relative quantities that are known here.
    #[must_use]
    pub fn relative(&self, id: &str) -> Vec<(Compared, Ratio)> {
        farthest(std::slice::from_ref(self), id)
    }

    /// Compares a model at this place.
    pub(super) fn add<M: Weighed>(
        &mut self,
        model: &M,
        contact: &dyn Contact,
        quantities: &[Compared],
    ) {
        let Ok(expected) = &self.expected else { return };
        if model.unlike() == Some(Unlike::Pairs) {
            return;
        }
        for &quantity in quantities {
            if self.ratio(model.id(), quantity).is_some() {
                continue;
            }
            let value = quantity.of_contact(contact, expected.pressure).ok();
            if let Some(ratio) = value.and_then(|value| expected.ratio(quantity, value)) {
                self.ratios.push(Expectation { model: model.id().into(), quantity, ratio });
            }
        }
    }
}

/// The ratios of a model farthest from 1 at these places, each quantity separately.
pub(super) fn farthest(places: &[EvidenceAt], id: &str) -> Vec<(Compared, Ratio)> {
    let farthest = |quantity: Compared| {
        let ratios = places.iter().filter_map(|place| place.ratio(id, quantity));
        let off = |ratio: &Ratio| ratio.deviation(quantity).abs();
        Some((quantity, ratios.max_by(|a, b| off(a).total_cmp(&off(b)))?))
    };
    RELATIVE.into_iter().filter_map(farthest).collect()
}

/// The evidence at the places of a request, and the reference relative to it. At separations, the
/// pressure is that of the reference.
pub(crate) fn evidence_of<M: Weighed>(
    reference: &M,
    contact: &dyn Contact,
    shape: Option<SurfaceShape>,
    request: &Request,
) -> Result<Vec<EvidenceAt>, ContactError> {
    let scene = contact.scene();
    let of_reference = |quantity| {
        let asked = Request::new([quantity]).within(request.tolerance);
        reference.compile(scene, &asked.at(request.at.iter().copied()))
    };
    let pressed = of_reference(Quantity::Pressure)?;
    let counted = Counted::on::<M>(scene)?;
    let expected = |at: At| {
        if let Some(unlike @ Unlike::Pairs) = reference.unlike() {
            let (model, reason) = (reference.id().into(), unlike.reason().into());
            return Err(ContactError::Refused { model, reason });
        }
        let pressure = match at.pressure(scene) {
            Some(pressure) => pressure,
            None => pressed.evaluate(Quantity::Pressure, at)?.value(),
        };
        Evidence::committed()?.expected(scene, shape, pressure, counted.at(pressure))
    };
    let place = |&at: &At| {
        let mut place = EvidenceAt { at, expected: expected(at), ratios: vec![] };
        place.add(reference, contact, &Compared::ALL);
        place
    };
    Ok(thinned(&request.at).into_iter().map(place).collect())
}

/// At most [`MOST`] of these places, from the first to the last.
fn thinned(places: &[At]) -> Vec<&At> {
    let last = places.len().saturating_sub(1);
    let kept = |k: usize| places.get(k * last / (MOST - 1));
    if last < MOST { places.iter().collect() } else { (0..MOST).filter_map(kept).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_places_are_thinned_from_end_to_end() {
        let places: Vec<At> = (0..401).map(|k| At::from(0.01 * f64::from(k))).collect();
        let some = thinned(&places);
        assert_eq!((some.len(), some[0], some[23]), (MOST, &places[0], &places[400]));
        assert_eq!(thinned(&places[..24]).len(), 24);
        assert_eq!(thinned(&places[..1]), [&places[0]]);
    }
}
