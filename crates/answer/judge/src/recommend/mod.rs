//! Which model does a scene need? The nearest to boundary elements or, without evidence, the
//! simplest that agrees with a reference model.

mod between_models;
mod evidence;
mod sentences;

use serde::Serialize;

use crate::evidence::{compile, compile_known};
use crate::{Compared, Ratio, SurfaceShape, Weighed};
use asperity_core::{ContactError, Finding, Quantity, Request, Scene};
use between_models::{Judge, answer, largest_deviation, regimes};
pub(crate) use evidence::evidence_of;
use evidence::farthest;
pub use evidence::{EvidenceAt, Expectation};

/// Deviations of one model from the reference.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Comparison<M> {
    /// The model.
    pub model: M,
    /// Largest relative deviation from the reference over all rows, for each requested quantity
    /// that the model has; or the error of the model, if it has none.
    pub deviations: Result<Vec<(Quantity, f64)>, ContactError>,
    /// The other quantities, if it has some, and why they have no value.
    pub lacking: Vec<(Quantity, ContactError)>,
    /// Parts of the model's laws, a measure of its complexity.
    pub regimes: usize,
    /// Why a model within the limit is not valid there; the reference may be invalid too.
    pub outside: Option<Finding>,
    /// The expected ratios to boundary elements farthest from 1, where there is evidence.
    pub off: Vec<(Compared, Ratio)>,
}

impl<M> Comparison<M> {
    /// The largest deviation of any quantity; infinite if one has no value.
    #[must_use]
    pub fn largest(&self) -> f64 {
        match &self.deviations {
            Ok(all) if self.lacking.is_empty() => all.iter().fold(0.0, |m: f64, (_, d)| m.max(*d)),
            _ => f64::INFINITY,
        }
    }

    /// The expected deviation from boundary elements in a quantity, relative to them, and half the
    /// width of its interval.
    #[must_use]
    pub fn off(&self, quantity: Compared) -> Option<[f64; 2]> {
        let (_, ratio) = self.off.iter().find(|(known, _)| *known == quantity)?;
        Some([ratio.deviation(quantity), ratio.half_width()])
    }
}

/// All models compared with a reference, and the simplest within a limit.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Recommendation<M> {
    /// The reference model.
    pub reference: M,
    /// Largest relative deviation allowed.
    pub within: f64,
    /// The first model of the comparisons that is within the limit and valid; otherwise the
    /// reference, if that is valid.
    pub simplest: Option<M>,
    /// Models from simplest to most complex: upright asperities of one radius, random asperities,
    /// no asperities, inclined contacts; then by number of parts of the force law and by year.
    pub comparisons: Vec<Comparison<M>>,
    /// The finding that contacts merge by the model to use, if they do.
    pub merging: Option<Finding>,
    /// The ids of the models nearest to boundary elements in the compared quantities, up to the
    /// first that is valid there, each with the reason why it is not; behind it the simplest valid
    /// one that is as near within the interval. Empty without evidence, and where mean gaps are
    /// compared (forces at separations).
    pub nearest: Vec<(String, Option<Finding>)>,
    /// The compared quantities of the request; [`summary`](Self::summary) and
    /// [`expectations`](Self::expectations) are about these only.
    #[serde(skip)]
    pub compared: Vec<Compared>,
    /// For each separation or load, and for 24 of them if there are more, the models relative to
    /// boundary elements, or why that is not known.
    pub evidence: Vec<EvidenceAt>,
}

impl<M: Weighed> Recommendation<M> {
    /// The model to use, as the [`verdict`](Self::verdict) names it: the nearest to boundary
    /// elements that is valid or the simplest that is as near, without evidence the simplest valid
    /// one within the limit of the reference. `None` where none is valid or contacts merge.
    #[must_use]
    pub fn model_to_use(&self) -> Option<&str> {
        if self.merging.is_some() {
            return None;
        }
        match self.nearest.last() {
            Some((id, outside)) => outside.is_none().then_some(id),
            None => {
                let simplest = self.simplest.as_ref()?.id();
                let is_compared = |found: &&Comparison<M>| found.model.id() == simplest;
                self.comparisons.iter().find(is_compared).map(|found| found.model.id())
            }
        }
    }

    /// Removes the evidence, for a surface that differs from the solved ones in a property that
    /// neither a [`Scene`] nor a [`SurfaceShape`] holds; the reason
    /// ([`ContactError::NoEvidence`]) names it.
    #[must_use]
    pub fn without_evidence(mut self, reason: &ContactError) -> Self {
        for place in &mut self.evidence {
            place.expected = Err(reason.clone());
            place.ratios.clear();
        }
        self.comparisons.iter_mut().for_each(|found| found.off.clear());
        self.nearest.clear();
        self
    }
}

/// Compares these models, such as models with options or of your own, with `reference` at the
/// separations and loads of the request. Recommends the simplest that deviates by at most `within`
/// in every requested quantity and is valid there: no model without yielding where asperities
/// yield; of two equally simple models, the first of the list.
///
/// The surface has this shape; without one, it is taken as isotropic and its heights must be
/// Gaussian to have evidence.
///
/// # Errors
/// [`ContactError::OutOfRange`] unless 0 < `within` ≤ 1 and there is at least one separation or
/// load; errors of the reference model.
pub fn recommend_among<M: Weighed>(
    models: Vec<M>,
    scene: &Scene,
    shape: Option<SurfaceShape>,
    request: &Request,
    reference: &M,
    within: f64,
) -> Result<Recommendation<M>, ContactError> {
    if !(within > 0.0 && within <= 1.0) {
        let required = "a share above 0 and at most 1 (5 % is 0.05)";
        return Err(ContactError::OutOfRange { field: "within", value: within, required });
    }
    if request.at.is_empty() {
        let (field, required) = ("number of separations and loads", "at least 1");
        return Err(ContactError::OutOfRange { field, value: 0.0, required });
    }
    let of_reference = compile(reference, scene, request, &request.quantities)?;
    let column = |quantity: &Quantity| answer(&*of_reference, *quantity, &request.at);
    let wanted: Vec<_> = request.quantities.iter().map(column).collect::<Result<_, _>>()?;
    let mut evidence = evidence_of(reference, &*of_reference, shape, request)?;
    let asked = Compared::for_request(&request.quantities);
    // All tables have the area and the stiffness.
    let mut beside = vec![Compared::Area, Compared::Stiffness];
    beside.extend(
        asked.contains(&Compared::UnloadingStiffness).then_some(Compared::UnloadingStiffness),
    );
    let (contacts, known) = Default::default();
    let judge = Judge { scene, places: &request.at, contacts, known };
    let compared = |model: M| {
        let regimes = regimes(&model, scene, request);
        let (contact, mut lacking, mut deviations) =
            match compile_known(&request.quantities, &[], |quantities| {
                compile(&model, scene, request, quantities)
            }) {
                Ok((contact, lacking)) => (Some(contact), lacking, Ok(vec![])),
                Err(error) => (None, vec![], Err(error)),
            };
        if let (Some(contact), Ok(deviations)) = (&contact, &mut deviations) {
            let lacks = |q: &Quantity| lacking.iter().any(|(lacking, _)| lacking == q);
            let columns = request.quantities.iter().zip(&wanted);
            let known: Vec<_> = columns.filter(|(quantity, _)| !lacks(quantity)).collect();
            for (&quantity, wanted) in known {
                match answer(&**contact, quantity, &request.at) {
                    Ok(found) => {
                        deviations.push((quantity, largest_deviation(quantity, &found, wanted)));
                    }
                    Err(error) => lacking.push((quantity, error)),
                }
            }
            for place in &mut evidence {
                place.add(&model, &**contact, &beside);
            }
        }
        if let (Ok([]), [(_, error), ..]) = (deviations.as_deref(), &lacking[..]) {
            deviations = Err(error.clone());
        }
        let off = farthest(&evidence, model.id());
        let id = model.id().to_string();
        judge.contacts.borrow_mut().extend(contact.map(|contact| (id, contact)));
        let mut found = Comparison { model, deviations, lacking, regimes, outside: None, off };
        if found.largest() <= within {
            found.outside = judge.outside(&found.model);
        }
        found
    };
    let mut comparisons: Vec<_> = models.into_iter().map(compared).collect();
    let kind = |model: &M| {
        let validity = model.validity();
        (validity.angles, !validity.asperities, model.equal().id() != model.id())
    };
    comparisons.sort_by_key(|found| (kind(&found.model), found.regimes));
    let is_near = |found: &&Comparison<M>| found.largest() <= within && found.outside.is_none();
    let near = comparisons.iter().find(is_near);
    if let Some(found) = near
        && let Some(contact) = judge.contacts.borrow().get(found.model.id())
    {
        for place in &mut evidence {
            place.add(&found.model, &**contact, &Compared::ALL);
        }
    }
    let itself = || judge.outside(reference).is_none().then(|| reference.clone());
    let simplest = near.map(|found| found.model.clone()).or_else(itself);
    let nearest = nearest(&comparisons, &asked, |model| judge.outside(model));
    let is_nearest =
        |found: &&Comparison<M>| nearest.last().is_some_and(|(id, _)| id == found.model.id());
    let named = comparisons.iter().find(is_nearest).map(|found| &found.model);
    let merging = named.or(simplest.as_ref());
    let merging = merging.and_then(|model| judge.merging(model));
    let (reference, compared) = (reference.clone(), asked);
    Ok(Recommendation {
        reference,
        within,
        simplest,
        merging,
        comparisons,
        nearest,
        compared,
        evidence,
    })
}

/// The models by their largest deviation from boundary elements in these quantities, up to the
/// first that is valid, and then the simplest valid one that is as near within the interval; none
/// where the mean gap is compared, in which models are not ranked.
fn nearest<M: Weighed>(
    comparisons: &[Comparison<M>],
    compared: &[Compared],
    outside: impl Fn(&M) -> Option<Finding>,
) -> Vec<(String, Option<Finding>)> {
    // The largest deviation, and half the width of its interval.
    let largest = |found: &Comparison<M>| -> Option<[f64; 2]> {
        let off = |of: &Compared| found.off(*of).map(|[off, half]| [off.abs(), half]);
        let all: Vec<[f64; 2]> = compared.iter().map(off).collect::<Option<_>>()?;
        all.into_iter().reduce(|a, b| if b[0] > a[0] { b } else { a })
    };
    let has_all = |found: &&Comparison<M>| found.deviations.is_ok() && found.lacking.is_empty();
    let known = comparisons.iter().filter(has_all);
    // From simplest to most complex.
    let known: Vec<([f64; 2], &M)> =
        known.filter_map(|found| Some((largest(found)?, &found.model))).collect();
    let mut near = known.clone();
    near.sort_by(|(a, _), (b, _)| a[0].total_cmp(&b[0]));
    let mut found = vec![];
    for ([off, half], model) in near {
        let why = outside(model);
        let is_valid = why.is_none();
        found.push((model.id().to_string(), why));
        if is_valid {
            let mut alike = known.iter().filter(|([other, _], _)| *other <= off + half);
            let simplest = alike.find(|(_, model)| outside(model).is_none());
            found.extend(simplest.map(|(_, model)| (model.id().to_string(), None)));
            break;
        }
    }
    found
}
