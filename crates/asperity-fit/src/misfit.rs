//! Data that no values of the parameters describe.

use asperity_core::short;

use crate::likely_unit::likely_unit;
use crate::problem::{Problem, squares};
use crate::remark::Remark;
use crate::{Data, FitError, Observation};

/// Data are not described where the root mean square of ln(fitted/measured) is above this.
const LARGEST_RMS: f64 = 1.0;
/// Differences, of separations, are not described beyond this many standard deviations.
const LARGEST_DEVIATIONS: f64 = 30.0;

/// Root mean square of the logarithms of fitted over measured values.
pub(crate) fn rms(data: &Data, values: &[f64]) -> Option<f64> {
    let ratios = data.iter().zip(values).filter(|(one, _)| !one.measured.is_difference());
    let ratios: Vec<f64> = ratios.map(|(one, value)| (value / one.value).ln()).collect();
    let finite: Vec<f64> = ratios.into_iter().filter(|ratio| ratio.is_finite()).collect();
    (!finite.is_empty()).then(|| mean_square(&finite))
}

pub(crate) fn mean_square(values: &[f64]) -> f64 {
    (squares(values) / values.len() as f64).sqrt()
}

/// The misfit in multiples of the largest with which data count as described: infinite where values
/// are 0 that are not 0 in the data.
pub(crate) fn distance(data: &Data, values: &[f64]) -> f64 {
    let of = |is_difference: bool, share: &dyn Fn(&Observation, f64) -> f64| {
        let some = data.iter().zip(values);
        let some = some.filter(|(one, _)| one.measured.is_difference() == is_difference);
        let shares: Vec<f64> = some.map(|(one, value)| share(one, *value)).collect();
        match shares.iter().any(|share| !share.is_finite()) {
            true => f64::INFINITY,
            false if shares.is_empty() => 0.0,
            false => mean_square(&shares),
        }
    };
    let logarithm = |one: &Observation, value: f64| (value / one.value).ln() / LARGEST_RMS;
    let deviations = |one: &Observation, value: f64| {
        one.std.map_or(0.0, |std| (value - one.value) / std / LARGEST_DEVIATIONS)
    };
    of(false, &logarithm).max(of(true, &deviations))
}

/// A sentence about data that are not described by the fitted values, with the line or the unit
/// that explains them.
pub(crate) fn misfit(
    problem: &Problem<'_>,
    values: &[f64],
    outlier: Option<&str>,
    limits: &[Remark],
) -> Result<Option<String>, FitError> {
    let far = distance(problem.data, values);
    if far <= 1.0 {
        return Ok(None);
    }
    let unit = || likely_unit(problem, far);
    let advice = match outlier.map_or_else(unit, |outlier| Ok(Some(outlier.into())))? {
        Some(advice) => advice,
        None => {
            let check = "check the columns and their units, and the other numbers of the scene";
            let limits = limits.iter().map(|limit| limit.sentence.as_str());
            limits.chain([check]).collect::<Vec<_>>().join("; ")
        }
    };
    let without_contact = data_without_contact(problem.data, values);
    let size = match (without_contact, rms(problem.data, values)) {
        (Some(place), _) => format!(": without contact at {place}"),
        (None, Some(rms)) if rms > LARGEST_RMS => {
            let factor = short(rms.exp());
            format!(": fitted values deviate by a factor of {factor} (root mean square)")
        }
        _ => {
            let deviations = short(LARGEST_DEVIATIONS * far);
            format!(
                ": fitted values deviate by {deviations} standard deviations (root mean square)"
            )
        }
    };
    Ok(Some(format!("no values within the bounds describe the data{size}; {advice}")))
}

/// The first place at which the fitted value is 0 and the measured one is not.
fn data_without_contact(data: &Data, values: &[f64]) -> Option<String> {
    let is_0 = |(one, value): &(&Observation, &f64)| {
        !one.measured.is_difference() && (*value / one.value).ln().is_infinite()
    };
    let (one, _) = data.iter().zip(values).find(is_0)?;
    let (column, value) = one.place();
    Some(format!("{column} = {}", short(value)))
}
