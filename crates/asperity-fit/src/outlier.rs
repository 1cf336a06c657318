//! A line of the data that the others contradict.

use asperity_core::short;

use crate::forward::Forward;
use crate::likely_unit::unit_of_value;
use crate::misfit::mean_square;
use crate::problem::{Minimum, Problem};
use crate::{FitError, Observation};

/// No line is doubted where the residuals are smaller (root mean square): as logarithms, and as
/// multiples of the standard deviations.
const SMALL: [f64; 2] = [0.05, 5.0];
/// A line is an outlier if the fit to the others leaves less than this share of the misfit,
const SHARE: f64 = 0.2;
/// or than this share, where the others have one value more than parameters, which agree easily,
const SHARE_OF_FEW: f64 = 0.02;
/// and is this far from the line: as a logarithm, and in standard deviations.
const FAR: [f64; 2] = [0.4, 10.0];
/// Lines agree no better than values are computed.
const ACCURACY: f64 = 1e-8;
/// The lines of the largest residuals are tried, at most this many.
const MOST: usize = 10;
/// Evaluations for each free parameter before the search without a line gives up.
const PATIENCE: usize = 60;

/// The data without one line, and the fit to these.
struct Without {
    row: usize,
    /// Root mean square of the residuals of the other lines.
    misfit: f64,
    best: Minimum,
}

/// A sentence about the line without which the misfit is far smaller.
pub(crate) fn outlier(
    problem: &Problem<'_>,
    best: &Minimum,
    residuals: &[f64],
) -> Result<Option<String>, FitError> {
    let kind = usize::from(problem.data.has_std());
    let misfit = mean_square(residuals);
    if misfit.is_nan() || misfit < SMALL[kind] {
        return Ok(None);
    }
    let mut order: Vec<(usize, f64)> =
        problem.data.iter().zip(residuals).map(|(one, r)| (one.row, r.abs())).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut rows: Vec<usize> = vec![];
    for (row, _) in order {
        if rows.len() < MOST && !rows.contains(&row) {
            rows.push(row);
        }
    }
    let mut found: Option<Without> = None;
    for row in rows {
        let others = problem.data.iter().filter(|one| one.row != row).count();
        let is_few = others < problem.parameters.len() + 2;
        let share = if is_few { SHARE_OF_FEW } else { SHARE };
        let least = found.as_ref().map_or(share * misfit, |found| found.misfit);
        found = without(problem, best, row)?.filter(|one| one.misfit < least).or(found);
    }
    let Some(found) = found else { return Ok(None) };
    let all = problem.residuals(&found.best.coordinates)?;
    let line = problem.data.iter().zip(&all).filter(|(one, _)| one.row == found.row);
    let worst = line.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let Some((one, residual)) = worst.filter(|(_, residual)| residual.abs() > FAR[kind]) else {
        return Ok(None);
    };
    let (position, column) = (problem.data.position(one), one.measured.column());
    let lines = position.split_whitespace().next().unwrap_or_default();
    let (far, agree) = (residual.abs(), found.misfit.max(ACCURACY));
    // Residuals of shares and logarithms are differences.
    let is_difference = |one: &Observation| one.measured.is_difference();
    let by = match (kind, is_difference(one)) {
        (0, true) => rounded(far),
        (0, false) => format!("a factor of {}", rounded(far.exp())),
        _ => format!("{} standard deviations", rounded(far)),
    };
    let agree = match kind {
        0 if problem.data.iter().all(is_difference) => rounded(agree),
        0 => format!("{} %", rounded(100.0 * agree)),
        _ => format!("{} standard deviations", rounded(agree)),
    };
    let predicted = match one.std {
        Some(std) => one.value + residual * std,
        None if is_difference(one) => one.value + residual,
        None => one.value * residual.exp(),
    };
    let advice = unit_of_value(one, predicted).unwrap_or("check or remove it".into());
    let (place, at) = one.place();
    let [value, at] = [one.value, at].map(short);
    Ok(Some(format!(
        "{position} ({column} = {value} at {place} = {at}) deviates by {by} from a fit to the other {lines}s, which agree within {agree} (root mean square); {advice}"
    )))
}

/// A number of two digits.
pub(crate) fn rounded(value: f64) -> String {
    short(format!("{value:.1e}").parse().unwrap_or(value))
}

/// The fit without a line; `None` where the others are too few to contradict it.
fn without(problem: &Problem<'_>, best: &Minimum, row: usize) -> Result<Option<Without>, FitError> {
    let others = problem.data.iter().filter(|one| one.row != row).copied().collect();
    let data = problem.data.with(others);
    if data.len() < problem.parameters.len() + 1 {
        return Ok(None);
    }
    let Ok(forward) = Forward::new(problem.model, &data) else { return Ok(None) };
    let other = Problem { data: &data, forward: &forward, ..*problem };
    let all: Vec<usize> = (0..problem.parameters.len()).collect();
    let given: Vec<f64> = problem.parameters.iter().map(|p| p.coordinate(p.start)).collect();
    // The line may have drawn the fit to a bound, from which a search does not return.
    let mut minima = vec![];
    for start in [&best.coordinates, &given] {
        minima.push(other.minimise(start, &all, PATIENCE)?);
    }
    let best = minima.into_iter().min_by(|a, b| a.squares.total_cmp(&b.squares));
    Ok(best.map(|best| {
        let misfit = (best.squares / data.len() as f64).sqrt();
        Without { row, misfit, best }
    }))
}
