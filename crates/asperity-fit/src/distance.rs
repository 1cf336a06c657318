//! How far fitted values are from the data.

use crate::problem::squares;
use crate::{Data, Observation};

/// Data are not described where the root mean square of ln(fitted/measured) is above this.
pub(crate) const LARGEST_RMS: f64 = 1.0;
/// Differences, of separations, are not described beyond this many standard deviations.
pub(crate) const LARGEST_DEVIATIONS: f64 = 30.0;

/// Root mean square of the logarithms of fitted over measured values.
pub(crate) fn rms(data: &Data, values: &[f64]) -> Option<f64> {
    let ratios = data.iter().zip(values).filter(|(one, _)| !one.measured.is_difference());
    let ratios: Vec<f64> = ratios.map(|(one, value)| (value / one.value).ln()).collect();
    let finite: Vec<f64> = ratios.into_iter().filter(|ratio| ratio.is_finite()).collect();
    (!finite.is_empty()).then(|| mean_square(&finite))
}

/// The square root of the mean of the squares.
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
