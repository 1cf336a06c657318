//! A model applied to a scene for a few places: integrals are made for each place, and nothing is
//! prepared for others.

use std::sync::{Arc, Mutex, PoisonError};

use crate::engine::arrays::FillReport;
use crate::engine::averages::{all_places_of_load, place, place_of_pull_off};
use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::compiled::Compiled;
use crate::engine::list::{answer_alone, shares_at};
use crate::engine::prepared::Facts;
use crate::request::separation::Place;
use crate::response::Response;
use crate::{
    At, Contact, ContactError, Evaluation, Finding, Plan, Quantity, Request, Scene, Separation,
    Share,
};

/// Loads whose places are kept: more than few are asked of tables.
const KEPT: usize = 64;

/// The averages of a model's laws over the heights of a scene, place by place.
#[derive(Debug)]
pub(crate) struct Alone {
    facts: Arc<Facts>,
    scene: Scene,
    /// The bits of loads \[N\] and their places, so that a load is inverted once.
    found: Mutex<Vec<(u64, Place)>>,
}

impl Alone {
    /// # Errors
    /// A scene that is refused for every place.
    pub(crate) fn new(facts: Arc<Facts>, scene: &Scene) -> Result<Self, ContactError> {
        let alone = Self { facts, scene: scene.clone(), found: Mutex::default() };
        alone.integrals(None)?;
        Ok(alone)
    }

    fn integrals(&self, known: Option<Place>) -> Result<CaseIntegrals<'_>, ContactError> {
        let Facts { laws, tolerance, .. } = &*self.facts;
        Ok(CaseIntegrals::alone(&self.scene, laws, *tolerance)?.knowing(known))
    }

    /// The integrals for a place; of a load that is asked for again, the place is known.
    fn at(&self, at: &At) -> Result<CaseIntegrals<'_>, ContactError> {
        let Some(load) = at.load(&self.scene).map(f64::to_bits) else {
            return self.integrals(None);
        };
        let found = || self.found.lock().unwrap_or_else(PoisonError::into_inner);
        let known = found().iter().find(|(known, _)| *known == load).map(|(_, place)| *place);
        let mut integrals = self.integrals(known)?;
        // A load that is refused is refused again, with its reason.
        let Ok(place) = place(&mut integrals, at) else { return Ok(integrals) };
        if known.is_none() && found().len() < KEPT {
            found().push((load, place));
        }
        Ok(integrals.knowing(Some(place)))
    }
}

impl Contact for Alone {
    fn model(&self) -> &str {
        &self.facts.model
    }

    fn scene(&self) -> &Scene {
        &self.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.facts.quantities
    }

    fn is_adhesive(&self) -> bool {
        self.facts.laws.adhesive
    }

    fn notes(&self) -> &[Finding] {
        &self.facts.notes
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        if !self.facts.quantities.contains(&quantity) {
            return Err(ContactError::NotRequested { quantity });
        }
        let mut response = self.respond(&Request::new([quantity]).at([at]));
        response.columns.remove(0).rows.remove(0).map_err(|error| *error)
    }

    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        self.on(&self.scene)?.fill(quantities, separations, columns)
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let found = all_places_of_load(&mut self.integrals(None)?, load)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        let at = At::Load(load);
        Ok(Separation::sigmas(place(&mut self.at(&at)?, &at)?.s))
    }

    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Ok(place_of_pull_off(&mut self.integrals(None)?)?.map(Separation::sigmas))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        shares_at(&self.facts, &mut self.at(&at)?, quantity, &at)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        Compiled::moved(&self.facts, scene)
    }

    fn second_derivative_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.on(&self.scene)?.second_derivative_at(quantity, at)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        self.on(&self.scene)?.plan(request)
    }

    fn respond(&self, request: &Request) -> Response {
        answer_alone(&self.facts, &self.scene, request, |at| self.at(at))
    }
}
