//! One or two lines of the data that the others contradict.

use asperity_core::short;
use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::forward::Forward;
use crate::likely_unit::unit_of_value;
use crate::problem::{Minimum, Problem};
use crate::{Data, FitError, Observation};

/// Least distance of an outlier from a fit to the others.
const FAR: Distances = Distances { logarithm: 0.05, deviations: 6.0 };
/// Largest chance that normal errors, as large as those of the other lines, put one of all lines as
/// far from the fit as an outlier is: by Student's distribution.
const CHANCE: f64 = 2e-3;
/// Two lines are doubted among more than this many.
const LINES_FOR_TWO: usize = 6;
/// Lines agree no better than values are computed.
const ACCURACY: f64 = 1e-8;
/// The lines of the largest residuals are tried, at most this many.
const MOST: usize = 10;
/// Evaluations for each free parameter before the search without a line gives up.
const PATIENCE: usize = 60;

/// Distances of a line from a fit.
struct Distances {
    logarithm: f64,
    deviations: f64,
}

impl Distances {
    /// The one in which the residuals of the data are.
    fn of(&self, data: &Data) -> f64 {
        if data.has_std() { self.deviations } else { self.logarithm }
    }
}

/// A fit without some lines.
struct Without {
    rows: Vec<usize>,
    /// Root mean square of the residuals of the other lines.
    misfit: f64,
    /// The residuals of all lines.
    residuals: Vec<f64>,
    /// The degrees of freedom that the other lines leave, and the number of their values.
    freedom: usize,
    count: usize,
}

/// A sentence about the lines that the others contradict, at most two.
pub(crate) fn outlier(
    problem: &Problem<'_>,
    best: &Minimum,
    residuals: &[f64],
) -> Result<Option<String>, FitError> {
    let largest = residuals.iter().fold(0.0, |most: f64, residual| most.max(residual.abs()));
    // The line itself draws the fit, at most half of the way if it is one of several.
    if largest <= 0.5 * FAR.of(problem.data) || largest.is_nan() {
        return Ok(None);
    }
    let order = by_residual(problem, residuals);
    let mut alone: Vec<Without> = vec![];
    for row in order.iter().take(MOST) {
        alone.extend(without(problem, best, &[*row])?);
    }
    let found = contradicted(problem, &alone);
    let mut pairs: Vec<Without> = vec![];
    if order.len() > LINES_FOR_TWO {
        // Beside one outlier, the second is the line that is farthest from the fit to the others.
        for first in found.map_or(&alone[..], std::slice::from_ref) {
            let second = by_residual(problem, &first.residuals);
            let second = second.into_iter().find(|row| !first.rows.contains(row));
            let mut rows: Vec<usize> = first.rows.iter().copied().chain(second).collect();
            rows.sort_unstable();
            if pairs.iter().all(|pair| pair.rows != rows) {
                pairs.extend(without(problem, best, &rows)?);
            }
        }
    }
    let two = contradicted(problem, &pairs);
    Ok(two.or(found).map(|found| found.sentence(problem)))
}

/// The rows of the data, that of the largest residual first.
fn by_residual(problem: &Problem<'_>, residuals: &[f64]) -> Vec<usize> {
    let mut order: Vec<(usize, f64)> =
        problem.data.iter().zip(residuals).map(|(one, r)| (one.row, r.abs())).collect();
    order.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut rows: Vec<usize> = vec![];
    for (row, _) in order {
        if !rows.contains(&row) {
            rows.push(row);
        }
    }
    rows
}

/// The fit with the least misfit, if its other lines contradict those left out.
fn contradicted<'w>(problem: &Problem<'_>, fits: &'w [Without]) -> Option<&'w Without> {
    let is_outlier = |fit: &&Without| {
        let nearest = fit.worst(problem).iter().map(|(_, r)| r.abs()).fold(f64::INFINITY, f64::min);
        nearest > FAR.of(problem.data) && fit.chance(nearest) < CHANCE
    };
    fits.iter().filter(is_outlier).min_by(|a, b| a.misfit.total_cmp(&b.misfit))
}

impl Without {
    /// The value of each line left out that is farthest from the fit, with its residual.
    fn worst<'p>(&self, problem: &'p Problem<'_>) -> Vec<(&'p Observation, f64)> {
        let of = |row: &usize| {
            let line = problem.data.iter().zip(&self.residuals).filter(|(one, _)| one.row == *row);
            line.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(one, r)| (one, *r))
        };
        self.rows.iter().filter_map(of).collect()
    }

    /// The chance of a residual this large among lines that scatter as the others do.
    fn chance(&self, residual: f64) -> f64 {
        let (count, freedom) = (self.count as f64, self.freedom as f64);
        let scatter = self.misfit.max(ACCURACY) * (count / freedom).sqrt();
        let student = StudentsT::new(0.0, 1.0, freedom);
        student.map_or(1.0, |student| 2.0 * count * student.sf(residual / scatter))
    }

    fn sentence(&self, problem: &Problem<'_>) -> String {
        let has_std = problem.data.has_std();
        let is_difference = |one: &Observation| one.measured.is_difference();
        let agree = rounded(self.misfit.max(ACCURACY));
        let agree = match has_std {
            true => format!("{agree} standard deviations"),
            false if problem.data.iter().all(is_difference) => agree,
            false => format!("{} %", rounded(100.0 * self.misfit.max(ACCURACY))),
        };
        let (mut lines, mut sizes, mut units) = (vec![], vec![], vec![]);
        for (one, residual) in self.worst(problem) {
            let (position, column) = (problem.data.position(one), one.measured.column());
            let (place, at) = one.place();
            let [value, at] = [one.value, at].map(short);
            lines.push(format!("{position} ({column} = {value} at {place} = {at})"));
            let far = residual.abs();
            // Residuals of shares and logarithms are differences.
            sizes.push(match (has_std, is_difference(one)) {
                (false, true) => rounded(far),
                (false, false) => format!("a factor of {}", rounded(far.exp())),
                _ => format!("{} standard deviations", rounded(far)),
            });
            let predicted = match one.std {
                Some(std) => one.value + residual * std,
                None if is_difference(one) => one.value + residual,
                None => one.value * residual.exp(),
            };
            units.extend(unit_of_value(one, predicted));
        }
        let [deviates, remove] = match lines.len() == 1 {
            true => ["deviates", "check or remove it"],
            false => ["deviate", "check or remove them"],
        };
        let advice = if units.len() == lines.len() { units.join("; ") } else { remove.into() };
        let kind = problem.data.row_name();
        let [lines, sizes] = [lines, sizes].map(|texts| texts.join(" and "));
        format!(
            "{lines} {deviates} by {sizes} from a fit to the other {kind}s, which agree within {agree} (root mean square); {advice}"
        )
    }
}

/// A number of two digits.
pub(crate) fn rounded(value: f64) -> String {
    short(format!("{value:.1e}").parse().unwrap_or(value))
}

/// The fit without these rows; `None` where the others are too few to contradict them.
fn without(
    problem: &Problem<'_>,
    best: &Minimum,
    rows: &[usize],
) -> Result<Option<Without>, FitError> {
    let others = problem.data.iter().filter(|one| !rows.contains(&one.row)).copied().collect();
    let data = problem.data.with(others);
    let (count, parameters) = (data.len(), problem.parameters.len());
    if count < parameters + 1 {
        return Ok(None);
    }
    let Ok(forward) = Forward::new(problem.model, &data) else { return Ok(None) };
    let other = Problem { data: &data, forward: &forward, ..*problem };
    let all: Vec<usize> = (0..parameters).collect();
    let given: Vec<f64> = problem.parameters.iter().map(|p| p.coordinate(p.start)).collect();
    // The lines may have drawn the fit to a bound, from which a search does not return.
    let mut minima = vec![];
    for start in [&best.coordinates, &given] {
        minima.push(other.minimise(start, &all, PATIENCE)?);
    }
    let least = minima.into_iter().min_by(|a, b| a.squares.total_cmp(&b.squares));
    let Some(least) = least else { return Ok(None) };
    Ok(Some(Without {
        rows: rows.to_vec(),
        misfit: (least.squares / count as f64).sqrt(),
        residuals: problem.residuals(&least.coordinates)?,
        freedom: count - parameters,
        count,
    }))
}
