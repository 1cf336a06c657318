//! A model of one asperity averaged over the heights of a scene, for callers.

use std::sync::Arc;

use asperity_quadrature::Curvature;

use crate::engine::arrays::{self, FillReport};
use crate::engine::averages::{
    Averages, all_places_of_load, place, place_of_load, place_of_pull_off,
};
use crate::engine::list::{answer_prepared, shares_at};
use crate::engine::plan::plan;
use crate::engine::prepared::{Facts, Prepared};
use crate::engine::row::Row;
use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::response::Response;
use crate::{
    AsperityModel, At, Contact, ContactError, Evaluation, Finding, Plan, Quantity, Request, Scene,
    Separation, Share,
};

/// The averages of a model's laws over the heights of a scene.
#[derive(Debug)]
pub(crate) struct Compiled(Prepared);

impl Compiled {
    pub(crate) fn new(
        model: &dyn AsperityModel,
        scene: &Scene,
        request: &Request,
    ) -> Result<Self, ContactError> {
        Prepared::new(Arc::new(Facts::new(model, scene, request)?), scene).map(Self)
    }

    /// The same laws on another scene.
    ///
    /// # Errors
    /// [`ContactError::OtherAsperity`] if its laws would be others.
    pub(crate) fn moved(
        facts: &Arc<Facts>,
        scene: &Scene,
    ) -> Result<Box<dyn Contact>, ContactError> {
        if scene.asperity()? != facts.laws.asperity {
            return Err(ContactError::OtherAsperity);
        }
        contact_radii::check(&facts.quantities, &scene.interface)?;
        Ok(Box::new(Self(Prepared::new(facts.clone(), scene)?)))
    }
}

impl Contact for Compiled {
    fn model(&self) -> &str {
        &self.0.facts.model
    }

    fn scene(&self) -> &Scene {
        &self.0.scene
    }

    fn quantities(&self) -> &[Quantity] {
        &self.0.facts.quantities
    }

    fn is_adhesive(&self) -> bool {
        self.0.facts.laws.adhesive
    }

    fn notes(&self) -> &[Finding] {
        &self.0.facts.notes
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        (&self.0).check_requested(quantity)?;
        Row::<_, 0>::new(&mut &self.0, &[], &at)?.unchecked(quantity)
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        let mut averages = &self.0;
        let mut row = Row::<_, 1>::new(&mut averages, &[Quantity::Tangent], &at)?;
        Ok((row.unchecked(Quantity::Force)?, row.unchecked(Quantity::Tangent)?))
    }

    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        arrays::fill(self, Some(&self.0), quantities, separations, columns)
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let found = all_places_of_load(&mut &self.0, load)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        let place = place_of_load(&mut &self.0, ("load", load), 1.0)?;
        Ok(Separation::sigmas(place.s))
    }

    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Ok(place_of_pull_off(&mut &self.0)?.map(Separation::sigmas))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        shares_at(&self.0.facts, &mut &self.0, quantity, &at)
    }

    fn second_derivative_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        (&self.0).check_requested(quantity)?;
        let place = place(&mut &self.0, &at)?;
        let none = || self.unsupported(&format!("a second derivative of the {quantity}"));
        if self.0.single_law(quantity) != Some(quantity) {
            return Err(none());
        }
        let channel = self.0.channel(quantity)?;
        let curvature = channel.total.curvature(place.s).ok_or_else(none)?;
        let Curvature { value, size, ln_scale, error } =
            curvature.map_err(integral_failed(quantity, &at))?;
        let integral = size;
        let height_std = self.0.scene.surface.asperity_height_std;
        // Divided twice, so that no square of a small number underflows.
        let [scaled, size] =
            [value, size].map(|x| x * channel.units.factor / height_std / height_std);
        Evaluation { scaled, ln_scale, size, error }.held(integral, quantity)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        plan(&self.0, request)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        Self::moved(&self.0.facts, scene)
    }

    fn respond(&self, request: &Request) -> Response {
        answer_prepared(&self.0, request)
    }
}
