//! Data that no values of the parameters describe.

use asperity_core::short;

use crate::distance::{LARGEST_DEVIATIONS, LARGEST_RMS, distance, rms};
use crate::likely_unit::likely_unit;
use crate::problem::Problem;
use crate::remark::Remark;
use crate::{Data, FitError, Observation};

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
