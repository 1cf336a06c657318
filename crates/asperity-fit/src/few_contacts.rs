//! Fitted values with fewer contacts than one, which are no contact at all.

use asperity_core::short;

use crate::FitError;
use crate::contacts::counts;
use crate::likely_unit::likely_units;
use crate::problem::Problem;

/// Other units explain the data if they leave less than this share of the misfit: of fits with
/// contacts in some rows, and of those without.
const SHARE: [f64; 2] = [0.5, 1.5];

/// A sentence about a fit with fewer contacts than one in some row, if other units explain it.
pub(crate) fn few_contacts(
    problem: &Problem<'_>,
    coordinates: &[f64],
    here: f64,
) -> Result<Option<String>, FitError> {
    let Some(counts) = counts(problem, coordinates) else { return Ok(None) };
    let each = problem.data.iter().zip(&counts);
    let fewest = each.min_by(|a, b| a.1.total_cmp(b.1)).filter(|(_, count)| **count < 1.0);
    let Some((one, count)) = fewest else { return Ok(None) };
    let without = counts.iter().all(|count| *count < 1.0);
    let Some(units) = likely_units(problem, here * SHARE[usize::from(without)])? else {
        return Ok(None);
    };
    let (place, at) = one.place();
    let [count, at] = [*count, at].map(short);
    Ok(Some(format!(
        "the fit has {count} contacts at {place} = {at} ({}), where at least one was required; {units}",
        problem.data.position(one)
    )))
}
