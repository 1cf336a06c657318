//! Responses for a list of places: prepared and in runs, or row by row without preparation.

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, place, shares};
use crate::engine::case_integrals::CaseIntegrals;
use crate::engine::parallel;
use crate::engine::prepared::{Facts, Prepared};
use crate::engine::row::{LawIntegral, Row, cells};
use crate::request::separation::Place;
use crate::response::{Cell, respond};
use crate::{At, ContactError, HeightDistribution, Quantity, Request, Response, Scene, Share};

/// Rows of a run, whose integrals are made together and stay in the cache.
const ROWS_PER_RUN: usize = 256;
/// Rows too few for preparation: a rule costs about ten of them.
const FEW: usize = 4;
/// Series in the separation, for other heights, begin anew at every break of the density; each
/// costs as much as some thirty rows.
const FEW_BETWEEN_BREAKS: usize = 32;

/// Whether a request has too few rows for preparation to save time.
pub(crate) fn is_short(request: &Request, scene: &Scene) -> bool {
    let few = match &scene.heights {
        HeightDistribution::Weibull(_) => 2 * FEW_BETWEEN_BREAKS,
        HeightDistribution::Other(other) => {
            FEW_BETWEEN_BREAKS * (2 + other.heights().breaks().len())
        }
        HeightDistribution::Gaussian | HeightDistribution::Exponential => FEW,
    };
    request.at.len() <= few && !request.shares
}

/// The response to a request, row by row without preparation; `alone` makes the integrals of a row.
pub(crate) fn answer_alone<'s>(
    facts: &Facts,
    scene: &Scene,
    request: &Request,
    alone: impl Fn(&At) -> Result<CaseIntegrals<'s>, ContactError> + Sync + Send,
) -> Response {
    let columns = |places: &[At]| {
        let rows = places.iter().map(|at| match alone(at) {
            Ok(mut averages) => cells(&mut averages, &request.quantities, at),
            Err(error) => vec![Err(Box::new(error)); request.quantities.len()],
        });
        let mut columns = vec![Vec::with_capacity(places.len()); request.quantities.len()];
        for row in rows {
            columns.iter_mut().zip(row).for_each(|(column, cell)| column.push(cell));
        }
        columns
    };
    let cells = |places: &[At]| parallel::columns(places, (FEW + 1, FEW), columns);
    answer(facts, scene, request, cells, &alone)
}

/// The response to a request from prepared integrals.
pub(crate) fn answer_prepared(prepared: &Prepared, request: &Request) -> Response {
    let columns = |places: &[At]| columns(prepared, &request.quantities, places);
    let cells = |places: &[At]| parallel::columns(places, parallel::MANY, columns);
    answer(&prepared.facts, &prepared.scene, request, cells, |_: &At| Ok(prepared))
}

/// A response from its columns; its other parts come from `averages`.
fn answer<'s, A: Averages<'s>>(
    facts: &Facts,
    scene: &Scene,
    request: &Request,
    cells: impl Fn(&[At]) -> Vec<Vec<Cell>>,
    averages: impl Fn(&At) -> Result<A, ContactError>,
) -> Response {
    let value = |quantity, at: At| {
        let mut averages = averages(&at).ok()?;
        let mut row = Row::<_>::new(&mut averages, &[quantity], &at).ok()?;
        Some(row.unchecked(quantity).ok()?.value())
    };
    let signed = facts.laws.are_signed();
    let behind = |quantity, at| if signed { value(quantity, at) } else { None };
    let shares = |quantity, at: At| shares_at(facts, &mut averages(&at)?, quantity, &at);
    respond((&facts.model, scene, facts.laws.adhesive), request, cells, shares, behind)
}

/// The share of every part in a quantity that follows from a single law.
pub(crate) fn shares_at<'s>(
    facts: &Facts,
    averages: &mut impl Averages<'s>,
    quantity: Quantity,
    at: &At,
) -> Result<Vec<Share>, ContactError> {
    averages.check_requested(quantity)?;
    let mut laws = quantity.laws(facts.laws.own_stiffness);
    let (Some(base), None) = (laws.next(), laws.next()) else {
        let what = format!("shares of regimes in the {quantity}");
        return Err(ContactError::Unsupported { model: facts.model.clone(), what });
    };
    let Place { s, .. } = place(averages, at)?;
    shares(averages, base, (s, at))
}

/// The quantities at each place, column by column.
fn columns(prepared: &Prepared, quantities: &[Quantity], places: &[At]) -> Vec<Vec<Cell>> {
    let new = || Vec::with_capacity(places.len());
    let mut columns: Vec<Vec<Cell>> = quantities.iter().map(|_| new()).collect();
    let requested = quantities.iter().all(|q| (&prepared).check_requested(*q).is_ok());
    for run in places.chunks(ROWS_PER_RUN) {
        if requested && together(prepared, quantities, run, &mut columns).is_some() {
            continue;
        }
        for at in run {
            let row = cells(&mut &*prepared, quantities, at);
            columns.iter_mut().zip(row).for_each(|(column, cell)| column.push(cell));
        }
    }
    columns
}

/// The integrals of one law at each place of a run.
struct RunIntegrals {
    base: Quantity,
    moments: Vec<Moments>,
    factor: f64,
}

/// A run whose integrals are made together; `None`, with nothing done, if any is refused.
fn together(
    prepared: &Prepared,
    quantities: &[Quantity],
    run: &[At],
    columns: &mut [Vec<Cell>],
) -> Option<()> {
    let mut averages = prepared;
    let places: Vec<Place> =
        run.iter().map(|at| place(&mut averages, at).ok()).collect::<Option<_>>()?;
    let s: Vec<f64> = places.iter().map(|place| place.s).collect();
    let has_slope = quantities.iter().any(|quantity| quantity.is_slope())
        || places.iter().any(|place| place.rounding > 0.0);
    let mut made: Vec<RunIntegrals> = vec![];
    for base in quantities.iter().flat_map(|quantity| prepared.laws_of(*quantity)) {
        if made.iter().all(|made| made.base != base) {
            let mut moments = vec![Moments::NONE; s.len()];
            let channel = prepared.channel(base).ok()?;
            channel.total.run(&s, has_slope, &mut moments)?;
            made.push(RunIntegrals { base, moments, factor: channel.units.factor });
        }
    }
    for (k, (place, at)) in places.iter().zip(run).enumerate() {
        let known = made.iter().map(|made| {
            let RunIntegrals { base, factor, .. } = *made;
            LawIntegral { base, moments: made.moments[k], factor, has_slope }
        });
        let mut row = Row::<_>::with(&mut averages, (*place, at), has_slope, known);
        for (column, quantity) in columns.iter_mut().zip(quantities) {
            column.push(row.quantity(*quantity).map_err(Box::new));
        }
    }
    Some(())
}
