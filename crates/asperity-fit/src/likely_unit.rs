//! The units in which data may be written that no values of the parameters describe.

use asperity_core::short;

use crate::contacts::has_contacts;
use crate::distance::distance;
use crate::forward::Forward;
use crate::problem::{Problem, squares};
use crate::recorded::{Recorded, Rescaled};
use crate::search::{PATIENCE, search};
use crate::{FitError, Observation};

/// Another unit explains the misfit if it leaves less than this share of it, and less than this
/// share of the largest with which data count as described.
const SHARE: f64 = 0.2;
const EXPLAINED: f64 = 0.3;
/// Units explain the data alike whose misfits differ by less than this factor, or are this small.
const ALIKE: f64 = 1.5;
const ACCURACY: f64 = 1e-6;
/// Evaluations for a free parameter after which a unit is left out if it is farther than so many
/// times the largest distance that explains the data.
const FEW_STEPS: usize = 15;
const NEARLY: f64 = 3.0;
/// A value is near the predicted one within this difference of logarithms.
const NEAR: f64 = 0.2;

/// The column and the unit that explain the data best, or a column of places and one of values
/// with their units, where a fit has no contact in some row with one column alone.
pub(crate) fn likely_unit(problem: &Problem<'_>, here: f64) -> Result<Option<String>, FitError> {
    if falls_where_fits_rise(problem) {
        return Ok(None);
    }
    let most = if here.is_infinite() { 1.0 } else { EXPLAINED.min(SHARE * here) };
    let unit = match likely_units(problem, most)? {
        None => best_of(problem, single(problem), most, |_, _| true)?,
        units => units,
    };
    Ok(unit)
}

/// Whether measured values fall where those of the start rise, or rise where they fall: a factor
/// changes neither.
fn falls_where_fits_rise(problem: &Problem<'_>) -> bool {
    let Ok(values) = problem.predicted(&start(problem)) else { return false };
    let of = |(one, value): (&Observation, f64)| [one.value.ln(), value.ln()];
    let logs: Vec<[f64; 2]> = problem.data.iter().zip(values).map(of).collect();
    // Of quantities of one kind, so that their levels mean nothing.
    let one_kind = problem.data.iter().all(|one| one.measured == problem.data[0].measured);
    let mean = |k: usize| logs.iter().map(|pair| pair[k]).sum::<f64>() / logs.len() as f64;
    let means = [mean(0), mean(1)];
    one_kind && logs.iter().map(|[a, b]| (a - means[0]) * (b - means[1])).sum::<f64>() < 0.0
}

/// The unit, or the units of two columns, with which a fit leaves less than `most` and has contacts
/// in every row: stiffness rises nearly as the load, so that a factor on both changes the misfit
/// little.
pub(crate) fn likely_units(problem: &Problem<'_>, most: f64) -> Result<Option<String>, FitError> {
    match best_of(problem, single(problem), most, has_contacts)? {
        None => best_of(problem, pairs(problem), most, has_contacts),
        unit => Ok(unit),
    }
}

/// Each column in each of its other units.
fn single(problem: &Problem<'_>) -> Vec<Vec<Rescaled>> {
    let area = nominal_area(problem);
    let columns = Recorded::all(problem.data).into_iter();
    columns.flat_map(|column| Rescaled::all(column, area)).map(|one| vec![one]).collect()
}

/// Each column of places beside each of values, in their other units.
fn pairs(problem: &Problem<'_>) -> Vec<Vec<Rescaled>> {
    let all = single(problem).concat();
    let (places, values): (Vec<Rescaled>, _) = all.into_iter().partition(|one| one.is_place());
    places.iter().flat_map(|place| values.iter().map(|one| vec![*place, *one])).collect()
}

fn start(problem: &Problem<'_>) -> Vec<f64> {
    problem.parameters.iter().map(|p| p.coordinate(p.start)).collect()
}

fn nominal_area(problem: &Problem<'_>) -> Option<f64> {
    problem.at(&start(problem)).ok().map(|(scene, _)| scene.nominal_area)
}

/// The candidate that explains the data best, as a sentence; of several that explain them alike,
/// one of metric units with which the parameters stay nearest to their start.
fn best_of(
    problem: &Problem<'_>,
    candidates: Vec<Vec<Rescaled>>,
    most: f64,
    is_possible: impl Fn(&Problem<'_>, &[f64]) -> bool,
) -> Result<Option<String>, FitError> {
    let given = start(problem);
    // Separations in a wrong unit may leave no contact at the start, where a search cannot move.
    let has_separations = problem.data.iter().any(|one| one.measured.is_difference());
    let more_starts = usize::from(most >= 1.0 || has_separations);
    let mut found: Vec<(f64, f64, Vec<Rescaled>)> = vec![];
    for candidate in candidates {
        let scaled = |one: &Observation| candidate.iter().fold(*one, |one, unit| unit.apply(one));
        let data = problem.data.with(problem.data.iter().map(scaled).collect());
        let Ok(forward) = Forward::new(problem.model, &data) else { continue };
        let other = Problem { data: &data, forward: &forward, ..*problem };
        let searched = |patience: usize| match search(&other, more_starts, patience) {
            Ok(found) => Ok(other
                .predicted(&found.best.coordinates)
                .ok()
                .map(|values| (distance(&data, &values), found.best.coordinates))),
            Err(error @ FitError::Interrupted) => Err(error),
            Err(_) => Ok(None),
        };
        // Most units are far off after few steps.
        if searched(FEW_STEPS)?.is_none_or(|(distance, _)| distance > NEARLY * most) {
            continue;
        }
        let Some((distance, best)) = searched(PATIENCE)? else { continue };
        let change: Vec<f64> = best.iter().zip(&given).map(|(a, b)| a - b).collect();
        if distance < most && is_possible(&other, &best) {
            found.push((distance, squares(&change), candidate));
        }
    }
    let least = found.iter().map(|(distance, ..)| *distance).fold(f64::INFINITY, f64::min);
    found.retain(|(distance, ..)| *distance <= ALIKE * least + ACCURACY);
    let other = |units: &[Rescaled]| units.iter().any(Rescaled::is_other);
    let nearest = found.into_iter().min_by(|a, b| {
        let [first, second] = [a, b].map(|(.., units)| other(units));
        first.cmp(&second).then(a.1.total_cmp(&b.1))
    });
    let area = nominal_area(problem);
    Ok(nearest.map(|(.., units)| {
        let each: Vec<String> = units.iter().map(|one| one.sentence(problem.data, area)).collect();
        each.join(", and ")
    }))
}

/// The unit in which one value is near the predicted one.
pub(crate) fn unit_of_value(one: &Observation, predicted: f64) -> Option<String> {
    let column = Recorded::Measured(one.measured);
    let is_near = |factor: f64| (predicted / (factor * one.value)).ln().abs() < NEAR;
    let (unit, factor) = column.units(None).into_iter().find(|(_, factor)| is_near(*factor))?;
    let (si, [given, meant]) = (column.si(), [one.value, factor * one.value].map(short));
    let gap = if si.is_empty() { "" } else { " " };
    Some(format!("{given} looks like {unit}; {given} {unit} is {meant}{gap}{si}"))
}
