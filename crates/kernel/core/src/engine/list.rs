//! Responses for a list of places, prepared and in runs, and what they share with those of few
//! places.

use asperity_quadrature::Moments;

use crate::engine::averages::{Averages, separation_at, shares};
use crate::engine::prepared::{Facts, Prepared};
use crate::engine::row_integrals::{LawIntegral, RowIntegrals, answers};
use crate::response::Answered;
use crate::scene::place::SeparationInSigma;
use crate::{At, ContactError, Evaluation, OtherHeights, Quantity, Request, Scene, Share};

/// Rows of a run, whose integrals are made together and stay in the cache.
const ROWS_PER_RUN: usize = 256;
/// Rows too few for preparation: a rule costs about ten of them.
pub(crate) const FEW: usize = 4;
/// Series in the separation, for other heights, begin anew at every break of the density; each
/// costs as much as some thirty rows.
const FEW_BETWEEN_BREAKS: usize = 32;

/// Whether a request has too few rows for preparation to save time.
pub(crate) fn is_short(request: &Request, scene: &Scene) -> bool {
    let ranges = |heights: &OtherHeights| 2 + heights.heights().breaks().len();
    let sampled = scene.heights.sampled(1.0);
    let few = sampled.map_or(FEW, |(heights, _)| FEW_BETWEEN_BREAKS * ranges(heights));
    request.at.len() <= few
}

/// The value behind a logarithm or a share; `None` if it is not negative for any law.
pub(crate) fn behind<'s>(
    averages: &mut impl Averages<'s>,
    quantity: Quantity,
    at: At,
) -> Option<f64> {
    averages.laws().laws.iter().find(|(_, law)| law.is_signed())?;
    let mut row = RowIntegrals::<_>::new(averages, &[quantity], &at).ok()?;
    Some(row.quantity(quantity).ok()?.value())
}

/// The share of every part in a quantity that follows from a single law.
pub(crate) fn shares_at<'s>(
    facts: &Facts,
    averages: &mut impl Averages<'s>,
    quantity: Quantity,
    at: &At,
) -> Result<Vec<Share>, ContactError> {
    let mut laws = quantity.laws(facts.laws.own_stiffness);
    let (Some(base), None) = (laws.next(), laws.next()) else {
        let what = format!("shares of regimes in the {quantity}");
        return Err(ContactError::Unsupported { model: facts.model.clone(), what });
    };
    let s = separation_at(averages, at)?.s;
    shares(averages, base, (s, at))
}

/// A column for each quantity, and one for the separations.
pub(crate) fn empty(quantities: &[Quantity], places: &[At]) -> Vec<Vec<Answered>> {
    (0..=quantities.len()).map(|_| Vec::with_capacity(places.len())).collect()
}

/// Adds the quantities of a row, and its separation.
pub(crate) fn add_row(
    columns: &mut [Vec<Answered>],
    row: impl IntoIterator<Item = Answered>,
    separation: Result<SeparationInSigma, ContactError>,
) {
    let separation = separation.map(|found| Evaluation::absolute(found.s, 0.0)).map_err(Box::new);
    let row = row.into_iter().chain([separation]);
    columns.iter_mut().zip(row).for_each(|(column, answered)| column.push(answered));
}

/// The quantities at each place and the separations, column by column.
pub(crate) fn columns(
    prepared: &Prepared,
    quantities: &[Quantity],
    places: &[At],
) -> Vec<Vec<Answered>> {
    let mut columns = empty(quantities, places);
    let requested = quantities.iter().all(|q| prepared.facts.check_requested(*q).is_ok());
    for run in places.chunks(ROWS_PER_RUN) {
        if requested && together(prepared, quantities, run, &mut columns).is_some() {
            continue;
        }
        for at in run {
            let mut averages = prepared;
            let row = answers(&mut averages, quantities, at, |q| prepared.facts.check_requested(q));
            add_row(&mut columns, row, separation_at(&mut averages, at));
        }
    }
    columns
}

/// A run whose integrals are made together; `None`, with nothing done, if any is refused.
fn together(
    prepared: &Prepared,
    quantities: &[Quantity],
    run: &[At],
    columns: &mut [Vec<Answered>],
) -> Option<()> {
    let mut averages = prepared;
    let separations = run.iter().map(|at| separation_at(&mut averages, at).ok());
    let separations: Vec<SeparationInSigma> = separations.collect::<Option<_>>()?;
    let s: Vec<f64> = separations.iter().map(|separation| separation.s).collect();
    let has_slope = quantities.iter().any(|quantity| quantity.is_slope())
        || separations.iter().any(|separation| separation.rounding > 0.0);
    let mut made: Vec<(Quantity, f64, Vec<Moments>)> = vec![];
    for base in quantities.iter().flat_map(|quantity| prepared.laws_of(*quantity)) {
        if made.iter().all(|(known, ..)| *known != base) {
            let mut moments = vec![Moments::NONE; s.len()];
            let channel = prepared.channel(base).ok()?;
            channel.total.run(&s, has_slope, &mut moments)?;
            made.push((base, channel.units.factor, moments));
        }
    }
    for (k, (separation, at)) in separations.into_iter().zip(run).enumerate() {
        let batch = made.iter().map(|(base, factor, moments)| LawIntegral {
            base: *base,
            moments: moments[k],
            factor: *factor,
            has_slope,
        });
        let mut row = RowIntegrals::<_>::with(&mut averages, (separation, at), has_slope, batch);
        let row = quantities.iter().map(|q| row.quantity(*q).map_err(Box::new));
        add_row(columns, row, Ok(separation));
    }
    Some(())
}
