//! A model of one asperity averaged over the heights of a scene.

use std::sync::Arc;

use asperity_quadrature::{Curvature, Moments};

use crate::engine::arrays;
use crate::engine::channel::{Channel, Laws, bases, failed};
use crate::engine::integrals::{AtPoint, Batch, Cached, Row};
use crate::engine::readings::Reading;
use crate::law::contact_radii;
use crate::request::separation::Place;
use crate::response::{Cell, Response, respond};
use crate::{
    Asperity, AsperityModel, At, Contact, ContactError, Diagnostic, Evaluation, FillReport, Plan,
    Quantity, Request, Scene, Separation, Share, Tolerance,
};

/// A law averaged over heights: integrals are built when first needed, and shared by all threads.
#[derive(Debug)]
pub(crate) struct Compiled {
    facts: Arc<Facts>,
    scene: Scene,
    channels: Vec<Channel>,
}

/// What does not depend on the surface.
#[derive(Debug)]
struct Facts {
    model: String,
    quantities: Vec<Quantity>,
    asperity: Asperity,
    own_stiffness: bool,
    monotone: bool,
    adhesive: bool,
    notes: Vec<Diagnostic>,
    tolerance: Tolerance,
}

impl Compiled {
    pub(crate) fn new(
        model: &dyn AsperityModel,
        scene: &Scene,
        request: &Request,
    ) -> Result<Self, ContactError> {
        let tolerance = request.tolerance;
        let by_load = request.at.iter().any(|at| !matches!(at, At::Separation(_)));
        let asperity = scene.asperity()?;
        contact_radii::check(&request.quantities, &scene.interface)?;
        let Laws { own_stiffness, monotone, adhesive, laws, .. } =
            Laws::new(model, asperity, &request.quantities, by_load, tolerance)?;
        let channel = |(base, law)| Channel::new(base, Arc::new(law), scene, tolerance);
        Ok(Self {
            facts: Arc::new(Facts {
                model: model.name().into(),
                quantities: request.quantities.clone(),
                asperity,
                own_stiffness,
                monotone,
                adhesive,
                notes: model.notes(),
                tolerance,
            }),
            scene: scene.clone(),
            channels: laws.into_iter().map(channel).collect::<Result<_, _>>()?,
        })
    }

    pub(crate) fn monotone(&self) -> bool {
        self.facts.monotone
    }

    pub(crate) fn adhesive(&self) -> bool {
        self.facts.adhesive
    }

    fn load(&self, field: &'static str, load: f64) -> Result<f64, ContactError> {
        crate::engine::inverse::check_load(field, load, self.facts.adhesive)
    }

    /// The integrals that a quantity comes of.
    pub(crate) fn bases(&self, quantity: Quantity) -> &'static [Quantity] {
        bases(quantity, self.facts.own_stiffness)
    }

    pub(crate) fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// The integral of the law for `base`, asked for as `quantity`.
    #[inline]
    pub(crate) fn channel(&self, base: Quantity) -> Result<&Channel, ContactError> {
        let found = self.channels.iter().find(|channel| channel.base == base);
        found.ok_or(ContactError::NotRequested { quantity: base })
    }

    #[inline]
    pub(crate) fn check_requested(&self, quantity: Quantity) -> Result<(), ContactError> {
        match self.facts.quantities.contains(&quantity) {
            true => Ok(()),
            false => Err(ContactError::NotRequested { quantity }),
        }
    }

    /// d/σ_z of what is asked, found for loads.
    #[inline]
    pub(crate) fn place(&self, at: At) -> Result<Place, ContactError> {
        match at {
            At::Separation(separation) => separation.place(&self.scene),
            At::Load(load) => self.place_of_load(self.load("load", load)?),
            At::Pressure(pressure) => {
                let pressure = self.load("pressure", pressure)?;
                self.place_of_load(pressure * self.scene.nominal_area)
            }
        }
    }

    #[inline]
    fn reading(&self, place: Place, at: At) -> Reading<'_> {
        let Facts { own_stiffness, tolerance, .. } = *self.facts;
        Reading { scene: &self.scene, own_stiffness, tolerance, place, at }
    }

    /// The quantities of the request at each place, each quantity together.
    fn columns(&self, quantities: &[Quantity], places: &[At]) -> Vec<Vec<Cell>> {
        let new = || Vec::with_capacity(places.len());
        let mut columns: Vec<Vec<Cell>> = quantities.iter().map(|_| new()).collect();
        let asked: Result<(), ContactError> =
            quantities.iter().try_for_each(|quantity| self.check_requested(*quantity));
        for run in places.chunks(TOGETHER) {
            let together = asked.is_ok() && self.together(quantities, run, &mut columns).is_some();
            if !together {
                run.iter().for_each(|at| self.one(quantities, *at, &mut columns));
            }
        }
        columns
    }

    /// A run whose integrals are taken together; none, and nothing done, where any is refused.
    fn together(
        &self,
        quantities: &[Quantity],
        run: &[At],
        columns: &mut [Vec<Cell>],
    ) -> Option<()> {
        let places: Vec<Place> =
            run.iter().map(|at| self.place(*at).ok()).collect::<Option<_>>()?;
        let s: Vec<f64> = places.iter().map(|place| place.s).collect();
        let slopes = sloped(quantities) || places.iter().any(|place| place.rounding > 0.0);
        let mut known: Vec<Batch> = vec![];
        for &base in quantities.iter().flat_map(|quantity| self.bases(*quantity)) {
            if known.iter().any(|known| known.base == base) {
                continue;
            }
            let channel = self.channel(base).ok()?;
            let mut moments = vec![Moments::NONE; s.len()];
            channel.total.run(&s, slopes, &mut moments)?;
            known.push(Batch { base, moments, factor: channel.units.factor });
        }
        for (column, quantity) in columns.iter_mut().zip(quantities) {
            column.extend(places.iter().zip(run).enumerate().map(|(row, (place, at))| {
                let here = AtPoint { compiled: self, s: place.s, at: *at };
                let mut integrals = Row { here, known: &known, row };
                self.reading(*place, *at).of(*quantity, &mut integrals).map_err(Box::new)
            }));
        }
        Some(())
    }

    /// One row by itself: what is refused, and why.
    fn one(&self, quantities: &[Quantity], at: At, columns: &mut [Vec<Cell>]) {
        let place = self.place(at);
        let s = place.as_ref().map_or(0.0, |place| place.s);
        let slopes = sloped(quantities) || place.as_ref().is_ok_and(|place| place.rounding > 0.0);
        let here = AtPoint { compiled: self, s, at };
        let mut once = Cached::new(here, slopes);
        for (column, quantity) in columns.iter_mut().zip(quantities) {
            let mut of = || {
                self.check_requested(*quantity)?;
                self.reading(place.clone()?, at).of(*quantity, &mut once)
            };
            column.push(of().map_err(Box::new));
        }
    }
}

/// Rows whose integrals are taken together: they stay in the fastest memory.
const TOGETHER: usize = 256;

fn sloped(quantities: &[Quantity]) -> bool {
    quantities.iter().any(|q| matches!(q, Quantity::Tangent | Quantity::Stiffness))
}

impl Contact for Compiled {
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
        self.facts.adhesive
    }

    fn notes(&self) -> &[Diagnostic] {
        &self.facts.notes
    }

    fn evaluate_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.check_requested(quantity)?;
        let place = self.place(at)?;
        let mut here = AtPoint { compiled: self, s: place.s, at };
        self.reading(place, at).of(quantity, &mut here)
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        let place = self.place(at)?;
        let here = AtPoint { compiled: self, s: place.s, at };
        let mut once = Cached::new(here, true);
        let reading = self.reading(place, at);
        let force = reading.of(Quantity::Force, &mut once)?;
        Ok((force, reading.of(Quantity::Tangent, &mut once)?))
    }

    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        arrays::check(quantities, separations, columns)?;
        self.filled(quantities, separations, columns)
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let found = self.all_places_of_load(self.load("load", load)?)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        let place = self.place_of_load(self.load("load", load)?)?;
        Ok(Separation::sigmas(place.s))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        self.check_requested(quantity)?;
        let [base] = self.bases(quantity) else {
            return Err(self.unsupported(&format!("shares of regimes in the {quantity}")));
        };
        self.shares_in(*base, self.place(at)?.s, at)
    }

    fn second_derivative_at(&self, quantity: Quantity, at: At) -> Result<Evaluation, ContactError> {
        self.check_requested(quantity)?;
        let place = self.place(at)?;
        let none = || self.unsupported(&format!("a second derivative of the {quantity}"));
        let [base] = self.bases(quantity) else { return Err(none()) };
        let channel = self.channel(*base)?;
        let curvature = (quantity == channel.base).then(|| channel.total.curvature(place.s));
        let curvature = curvature.flatten().ok_or_else(none)?;
        let Curvature { value, size, ln_scale, error } = curvature.map_err(failed(quantity, at))?;
        let integral = size;
        let height_std = self.scene.surface.asperity_height_std;
        // Divided twice, so that no square of a small number underflows.
        let [scaled, size] =
            [value, size].map(|x| x * channel.units.factor / height_std / height_std);
        Evaluation { scaled, ln_scale, size, error }.held(integral, quantity)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        self.planned(request)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        if scene.asperity()? != self.facts.asperity {
            return Err(ContactError::OtherAsperity);
        }
        contact_radii::check(&self.facts.quantities, &scene.interface)?;
        let moved = |c: &Channel| Channel::new(c.base, c.law.clone(), scene, self.facts.tolerance);
        let channels = self.channels.iter().map(moved).collect::<Result<_, _>>()?;
        Ok(Box::new(Self { facts: self.facts.clone(), scene: scene.clone(), channels }))
    }

    fn respond(&self, request: &Request) -> Response {
        let columns = |places: &[At]| self.columns(&request.quantities, places);
        let signed = self.channels.iter().any(|channel| channel.law.is_signed());
        let value = |base, at| {
            let place = self.place(at).ok()?;
            let mut here = AtPoint { compiled: self, s: place.s, at };
            Some(self.reading(place, at).of(base, &mut here).ok()?.value())
        };
        let behind = |base, at| if signed { value(base, at) } else { None };
        let cells = |places: &[At]| crate::engine::parallel::columns(places, columns);
        let shares = |quantity, at| self.shares_at(quantity, at);
        let named = (self.model(), &self.scene, self.is_adhesive());
        respond(named, request, cells, shares, behind)
    }
}

impl Compiled {
    pub(crate) fn shares_in(
        &self,
        base: Quantity,
        s: f64,
        at: At,
    ) -> Result<Vec<Share>, ContactError> {
        let channel = self.channel(base)?;
        let total = channel.total.value(s).map_err(failed(base, at))?;
        let mut shares = Vec::with_capacity(channel.law.parts.len());
        for (part, integral) in channel.law.parts.iter().zip(channel.parts()) {
            let moments = integral.value(s).map_err(failed(base, at))?;
            let value = moments.value * (moments.ln_scale - total.ln_scale).exp();
            let share = if value == 0.0 { 0.0 } else { value / total.value };
            shares.push(Share { name: part.name.clone(), regime: part.regime, share });
        }
        Ok(shares)
    }
}
