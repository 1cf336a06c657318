//! A model applied to a scene for a few places: integrals are made for each place, and nothing is
//! prepared for others.

use std::sync::{Arc, Mutex, PoisonError};

use crate::engine::averages::{all_separations_of_load, separation_at, separation_of_pull_off};
use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::list::{FEW, add_row, behind, empty, shares_at};
use crate::engine::parallel;
use crate::engine::prepared::Facts;
use crate::engine::row_integrals::{RowIntegrals, answers};
use crate::model::contact::respond;
use crate::response::Response;
use crate::scene::place::SeparationInSigma;
use crate::{
    At, Contact, ContactEngine, ContactError, Evaluation, FillReport, Plan, Quantity, Request,
    Scene, Separation, Share,
};

/// Loads whose separations are kept: more than few are asked of tables.
const KEPT: usize = 64;

/// The averages of a model's laws over the heights of a scene, place by place.
#[derive(Debug)]
pub(crate) struct Alone {
    facts: Arc<Facts>,
    scene: Scene,
    /// The bits of loads \[N\] and their separations, so that a load is inverted once.
    inverted: Mutex<Vec<(u64, SeparationInSigma)>>,
}

impl Alone {
    /// # Errors
    /// A scene that is refused for every place.
    pub(crate) fn new(facts: Arc<Facts>, scene: &Scene) -> Result<Self, ContactError> {
        let alone = Self { facts, scene: scene.clone(), inverted: Mutex::default() };
        alone.integrals()?;
        Ok(alone)
    }

    fn integrals(&self) -> Result<CaseIntegrals<'_>, ContactError> {
        CaseIntegrals::alone(&self.scene, &self.facts.laws)
    }

    /// The integrals for a place; a load that is asked for again is not inverted again.
    pub(crate) fn at(&self, at: &At) -> Result<CaseIntegrals<'_>, ContactError> {
        let Some(load) = at.load(&self.scene).map(f64::to_bits) else { return self.integrals() };
        let inverted = || self.inverted.lock().unwrap_or_else(PoisonError::into_inner);
        let found = inverted().iter().find(|(of, _)| *of == load).map(|(_, found)| *found);
        let mut integrals = self.integrals()?.after(found);
        // A load that is refused is refused again, with its reason.
        let Ok(separation) = separation_at(&mut integrals, at) else { return Ok(integrals) };
        if found.is_none() && inverted().len() < KEPT {
            inverted().push((load, separation));
        }
        Ok(integrals.after(Some(separation)))
    }
}

impl ContactEngine for Alone {
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

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.facts.check_requested(quantity)?;
        RowIntegrals::<_>::new(&mut self.at(&at)?, &[quantity], &at)?.quantity(quantity)
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
        let found = all_separations_of_load(&mut self.integrals()?, load)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        let at = At::Load(load);
        Ok(Separation::sigmas(separation_at(&mut self.at(&at)?, &at)?.s))
    }

    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Ok(separation_of_pull_off(&mut self.integrals()?)?.map(Separation::sigmas))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        shares_at(&self.facts, &mut self.at(&at)?, quantity, &at)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        self.facts.on(scene)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        self.on(&self.scene)?.plan(request)
    }

    fn respond(&self, request: &Request) -> Response {
        let columns = |places: &[At]| {
            let mut columns = empty(&request.quantities, places);
            for at in places {
                match self.at(at) {
                    Ok(mut averages) => {
                        let row = answers(&mut averages, &request.quantities, at, |_| Ok(()));
                        add_row(&mut columns, row, separation_at(&mut averages, at));
                    }
                    Err(error) => {
                        let row = vec![Err(Box::new(error.clone())); request.quantities.len()];
                        add_row(&mut columns, row, Err(error));
                    }
                }
            }
            columns
        };
        let answered = |places: &[At]| parallel::columns(places, (FEW + 1, FEW), columns);
        respond(self, request, answered, |quantity, at| {
            behind(&mut self.at(&at).ok()?, quantity, at)
        })
    }
}
