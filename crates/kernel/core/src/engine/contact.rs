//! A model of one asperity averaged over the heights of a scene, for callers: prepared for many
//! places.

use crate::engine::averages::{
    all_separations_of_load, separation_of_load, separation_of_pull_off,
};
use crate::engine::plan::plan;
use crate::engine::prepared::Prepared;
use crate::engine::row_integrals::RowIntegrals;
use crate::engine::{arrays, list, parallel};
use crate::model::contact::respond;
use crate::response::{Response, fill};
use crate::{
    At, Contact, ContactEngine, ContactError, Evaluation, FillReport, Plan, Quantity, Request,
    Scene, Separation, Share,
};

impl ContactEngine for Prepared {
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
        RowIntegrals::<_, 0>::new(&mut &*self, &[], &at)?.unchecked(quantity)
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        let mut averages = self;
        let mut row = RowIntegrals::<_, 1>::new(&mut averages, &[Quantity::Tangent], &at)?;
        Ok((row.unchecked(Quantity::Force)?, row.unchecked(Quantity::Tangent)?))
    }

    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        let one = |quantity, at| self.evaluate_at(quantity, at);
        let many =
            |quantity, s: &[f64], values: &mut [f64]| arrays::multiple(self, quantity, s, values);
        fill::fill((many, one), quantities, separations, columns)
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let found = all_separations_of_load(&mut &*self, load)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        Ok(Separation::sigmas(separation_of_load(&mut &*self, ("load", load), 1.0)?.s))
    }

    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Ok(separation_of_pull_off(&mut &*self)?.map(Separation::sigmas))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        list::shares_at(&self.facts, &mut &*self, quantity, &at)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        plan(self, request)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        self.facts.on(scene)
    }

    fn respond_to(&self, request: &Request) -> Response {
        let columns = |places: &[At]| list::columns(self, &request.quantities, places);
        let answered = |places: &[At]| parallel::columns(places, parallel::MANY, columns);
        respond(self, request, answered, |quantity, at| list::behind(&mut &*self, quantity, at))
    }
}
