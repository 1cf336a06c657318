//! A model of one asperity averaged over the heights of a scene, for callers: prepared for many
//! places, whose values in plain arrays take a few nanoseconds each, or alone for few.

use asperity_quadrature::{ArrayAccuracy, ScaledIntegral, reach};

use crate::engine::alone::Alone;
use crate::engine::averages::{all_separations_of_load, separation_at, separation_of_pull_off};
use crate::engine::height_integral::SLOPES_CANCEL;
use crate::engine::prepared::{Channel, Facts, Prepared};
use crate::engine::row_integrals::RowIntegrals;
use crate::engine::{list, parallel};
use crate::error::integral_failed;
use crate::law::contact_radii;
use crate::model::contact::respond;
use crate::request::quantity_table::Derivation;
use crate::response::{Response, fill};
use crate::scene::place::LOWEST;
use crate::{
    AsperityModel, At, Contact, ContactEngine, ContactError, ContactModel, Evaluation, FillReport,
    HeightDistribution, Part, Plan, PlannedPart, Quantity, Request, Scene, Separation, Share, Step,
};

/// A model that averages laws of asperities over heights, on a scene: `prepared` for many places
/// ([`ContactModel::compile`]), or as the places of the request suggest
/// ([`ContactModel::contact`]).
///
/// # Errors
/// The errors of [`ContactModel::compile`].
pub fn contact_of_laws(
    model: &dyn ContactModel,
    scene: &Scene,
    request: &Request,
    prepared: bool,
) -> Result<Box<dyn Contact>, ContactError> {
    let scene = model.scene_of(scene)?;
    let facts = Facts::new(model, &scene, request)?;
    Ok(match prepared || !list::is_short(request, &scene) {
        true => Box::new(Prepared::new(facts, &scene)?),
        false => Box::new(Alone::new(facts, &scene)?),
    })
}

impl<M: AsperityModel> ContactModel for M {
    fn asperity_model(&self) -> Option<&dyn AsperityModel> {
        Some(self)
    }

    fn compile(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, true)
    }

    fn contact(&self, scene: &Scene, request: &Request) -> Result<Box<dyn Contact>, ContactError> {
        contact_of_laws(self, scene, request, false)
    }
}

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
        RowIntegrals::<_, 0>::new(&mut &*self, &[], &at)?.quantity(quantity)
    }

    fn force_and_tangent_at(&self, at: At) -> Result<(Evaluation, Evaluation), ContactError> {
        let mut averages = self;
        let mut row = RowIntegrals::<_, 1>::new(&mut averages, &[Quantity::Tangent], &at)?;
        Ok((row.quantity(Quantity::Force)?, row.quantity(Quantity::Tangent)?))
    }

    fn fill(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        let one = |quantity, at| self.evaluate_at(quantity, at);
        let many = |quantity, s: &[f64], values: &mut [f64]| multiple(self, quantity, s, values);
        fill::fill((many, one), quantities, separations, columns)
    }

    fn separations_at(&self, load: f64) -> Result<Vec<Separation>, ContactError> {
        let found = all_separations_of_load(&mut &*self, load)?;
        Ok(found.into_iter().map(Separation::sigmas).collect())
    }

    fn separation_at(&self, load: f64) -> Result<Separation, ContactError> {
        Ok(Separation::sigmas(separation_at(&mut &*self, &At::Load(load))?.s))
    }

    fn pull_off(&self) -> Result<Option<Separation>, ContactError> {
        Ok(separation_of_pull_off(&mut &*self)?.map(Separation::sigmas))
    }

    fn shares_at(&self, quantity: Quantity, at: At) -> Result<Vec<Share>, ContactError> {
        self.facts.check_requested(quantity)?;
        list::shares_at(&self.facts, &mut &*self, quantity, &at)
    }

    fn plan(&self, request: &Request) -> Result<Plan, ContactError> {
        plan(self, request)
    }

    fn on(&self, scene: &Scene) -> Result<Box<dyn Contact>, ContactError> {
        self.facts.on(scene)
    }

    fn respond(&self, request: &Request) -> Response {
        let columns = |places: &[At]| list::columns(self, &request.quantities, places);
        let answered = |places: &[At]| parallel::columns(places, parallel::MANY, columns);
        respond(self, request, answered, |quantity, at| list::behind(&mut &*self, quantity, at))
    }
}

/// The values, if the quantity is a multiple of an integral and every value is a normal number.
fn multiple(
    prepared: &Prepared,
    quantity: Quantity,
    separations: &[f64],
    values: &mut [f64],
) -> Option<FillReport> {
    prepared.facts.check_requested(quantity).ok()?;
    let (base, slope, factor) = factor(prepared, quantity)?;
    let channel = prepared.channel(base).ok()?;
    let column = ScaledIntegral { shift: 0.0, slope, factor: factor * channel.units.factor };
    if !column.factor.is_normal() {
        return None;
    }
    let ArrayAccuracy { error, condition, normal, lowest } =
        channel.total.fill(separations, column, values)?;
    // The factor is a product of two or three numbers.
    let report = FillReport { bound: error + f64::EPSILON, condition };
    // Near the lowest separation, rows are checked one by one; `lowest` includes the onset.
    let deep = lowest < 0.5 * LOWEST || slope && lowest < SLOPES_CANCEL;
    (normal && !deep).then_some(report)
}

/// The law, whether the slope is required, and the factor, for a multiple of an integral.
fn factor(prepared: &Prepared, quantity: Quantity) -> Option<(Quantity, bool, f64)> {
    let scene = &prepared.scene;
    match quantity.derivation() {
        Derivation::Integral => Some((quantity, false, 1.0)),
        Derivation::IntegralOrSlope(_) if prepared.facts.laws.own_stiffness => {
            Some((quantity, false, 1.0))
        }
        Derivation::IntegralOrSlope(of) | Derivation::Slope(of) => {
            Some((of, true, 1.0 / scene.surface.asperity_height_std))
        }
        Derivation::PerNominalArea(of) => {
            let (base, slope, total) = factor(prepared, of)?;
            Some((base, slope, total / scene.nominal_area))
        }
        Derivation::ContactRadii(..) => {
            let factor = contact_radii::factor(quantity, &scene.interface).ok()??;
            Some((quantity.origin(), false, factor))
        }
        _ => None,
    }
}

/// The plan for a request; builds what its rows need.
fn plan(prepared: &Prepared, request: &Request) -> Result<Plan, ContactError> {
    let mut averages = prepared;
    let places = request.at.iter().map(|at| Ok(separation_at(&mut averages, at)?.s));
    let places: Vec<f64> = places.collect::<Result<_, ContactError>>()?;
    let steps = prepared.channels.iter().map(|channel| step(prepared, channel, &places));
    let rows = || places.iter().zip(&request.at);
    let first = rows().min_by(|a, b| a.0.total_cmp(b.0));
    let last = rows().max_by(|a, b| a.0.total_cmp(b.0));
    Ok(Plan {
        model: prepared.facts.model.clone(),
        heights: prepared.scene.heights.name().into(),
        tolerance: prepared.facts.laws.tolerance.relative(),
        rows: places.len(),
        range: first.zip(last).map(|((_, first), (_, last))| (*first, *last)),
        steps: steps.collect::<Result<_, _>>()?,
    })
}

fn step(prepared: &Prepared, channel: &Channel, places: &[f64]) -> Result<Step, ContactError> {
    let law = channel.base;
    let needs_law = |q: &Quantity| prepared.laws_of(*q).any(|base| base == law);
    let quantities = prepared.facts.quantities.iter().copied().filter(needs_law).collect();
    let mut terms: Option<(usize, usize)> = None;
    let mut farthest: f64 = 0.0;
    for &s in places {
        let at = s.into();
        let failed = integral_failed(law, &at);
        channel.total.value(s).map_err(&failed)?;
        if let Some(n) = channel.total.terms(s).map_err(&failed)? {
            terms = Some(terms.map_or((n, n), |(least, most)| (least.min(n), most.max(n))));
        }
        farthest = farthest.max(reach(channel.units.onset.shifted(s)));
    }
    let method = match prepared.scene.heights {
        HeightDistribution::Gaussian => "polynomials in the separation",
        HeightDistribution::Exponential => {
            "one integral for all separations above 0, as exp(-d) is a factor"
        }
        HeightDistribution::Weibull(_) | HeightDistribution::Other(_) => {
            "panels that follow the heights; series in the separation between kinks, made where asked"
        }
    };
    let gaussian = matches!(prepared.scene.heights, HeightDistribution::Gaussian);
    // Beyond the reach, the Gaussian is below 1e-20 of its largest value.
    let out_of_reach = |part: &Part| gaussian && part.range.start * channel.units.scale > farthest;
    let planned = |part: &Part| PlannedPart {
        name: part.name.to_string(),
        form: part.form.describe().into(),
        dropped: out_of_reach(part).then_some(1e-20),
    };
    let parts = channel.law.parts.iter().map(planned).collect();
    Ok(Step { law, quantities, method, parts, terms, samples: channel.total.samples() })
}
