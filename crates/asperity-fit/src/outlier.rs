//! One or two lines of the data that the others contradict.

use asperity_core::{Finding, short};
use statrs::distribution::{ContinuousCDF, StudentsT};

use crate::distance::distance;
use crate::doubt::{OUTLIER, doubt, rounded};
use crate::problem::{Minimum, Problem, squares};
use crate::{FitError, Observation};

/// Least distance of an outlier from a fit to the others: of logarithms, or in standard deviations.
const FAR: [f64; 2] = [0.05, 6.0];
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

/// A fit without some lines.
struct Without {
    rows: Vec<usize>,
    /// The value of each line left out that is farthest from the fit, with its residual.
    lines: Vec<(Observation, f64)>,
    /// All rows, that of the largest residual first.
    order: Vec<usize>,
    /// Root mean square of the residuals of the other lines.
    misfit: f64,
    /// Whether normal errors of all lines hardly put the lines left out where they are.
    is_clear: bool,
}

/// The lines that the others contradict, at most two.
pub(crate) fn contradicted_lines(
    problem: &Problem<'_>,
    best: &Minimum,
    (values, residuals): (&[f64], &[f64]),
) -> Result<Option<Finding>, FitError> {
    let far = FAR[usize::from(problem.data.has_std())];
    // The line itself draws the fit, at most half of the way if it is one of several.
    if residuals.iter().all(|residual| residual.abs() <= 0.5 * far) {
        return Ok(None);
    }
    let order = by_residual(problem, residuals);
    if distance(problem.data, values) > 1.0 && !are_far(problem, residuals, &order) {
        return Ok(None);
    }
    let mut alone: Vec<Without> = vec![];
    for row in order.iter().take(MOST) {
        alone.extend(without(problem, best, &[*row])?);
    }
    let found = clearest(&alone);
    let mut pairs: Vec<Without> = vec![];
    if order.len() > LINES_FOR_TWO {
        // Beside one outlier, the second is the line that is farthest from the fit to the others.
        for first in found.map_or(&alone[..], std::slice::from_ref) {
            let second = first.order.iter().find(|row| !first.rows.contains(row));
            let mut rows: Vec<usize> = first.rows.iter().chain(second).copied().collect();
            rows.sort_unstable();
            if pairs.iter().all(|pair| pair.rows != rows) {
                pairs.extend(without(problem, best, &rows)?);
            }
        }
    }
    Ok(clearest(&pairs).or(found).map(|found| found.finding(problem)))
}

/// Whether two rows may explain a misfit: outliers draw the fit at most half of the way, so that
/// they keep a quarter of the sum of squares.
fn are_far(problem: &Problem<'_>, residuals: &[f64], order: &[usize]) -> bool {
    let rows = &order[..order.len().min(2)];
    let each = problem.data.iter().zip(residuals);
    let of_rows: Vec<f64> =
        each.filter(|(one, _)| rows.contains(&one.row)).map(|(_, r)| *r).collect();
    squares(&of_rows) >= 0.25 * squares(residuals)
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

/// Of the fits whose other lines contradict those left out, that with the least misfit.
fn clearest(fits: &[Without]) -> Option<&Without> {
    fits.iter().filter(|fit| fit.is_clear).min_by(|a, b| a.misfit.total_cmp(&b.misfit))
}

/// The fit without these rows; `None` where the others are too few to contradict them.
fn without(
    problem: &Problem<'_>,
    best: &Minimum,
    rows: &[usize],
) -> Result<Option<Without>, FitError> {
    let others = |one: &Observation| (!rows.contains(&one.row)).then_some(*one);
    let count = problem.data.iter().filter_map(others).count();
    let freedom = count.saturating_sub(problem.parameters.len());
    if freedom == 0 {
        return Ok(None);
    }
    // The lines may have drawn the fit to a bound, from which a search does not return.
    let minima = problem.with(others, |other| {
        [&best.coordinates, &problem.start()].map(|start| other.minimise_all(start, PATIENCE))
    });
    let Some([one, other]) = minima else { return Ok(None) };
    let (one, other) = (one?, other?);
    let least = if other.squares < one.squares { other } else { one };
    let residuals = problem.residuals(&least.coordinates)?;
    let misfit = (least.squares / count as f64).sqrt();
    let farthest = |row: &usize| {
        let line = problem.data.iter().zip(&residuals).filter(|(one, _)| one.row == *row);
        line.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(one, r)| (*one, *r))
    };
    let lines: Vec<(Observation, f64)> = rows.iter().filter_map(farthest).collect();
    let nearest = lines.iter().map(|(_, r)| r.abs()).fold(f64::INFINITY, f64::min);
    let scatter = misfit.max(ACCURACY) * (count as f64 / freedom as f64).sqrt();
    let student = StudentsT::new(0.0, 1.0, freedom as f64);
    let chance = student.map_or(1.0, |t| 2.0 * count as f64 * t.sf(nearest / scatter));
    let far = FAR[usize::from(problem.data.has_std())];
    let is_clear = nearest > far && chance < CHANCE;
    let (rows, order) = (rows.to_vec(), by_residual(problem, &residuals));
    Ok(Some(Without { rows, lines, order, misfit, is_clear }))
}

impl Without {
    fn finding(&self, problem: &Problem<'_>) -> Finding {
        let (data, lines) = (problem.data, &self.lines);
        let (mut named, mut sizes) = (vec![], vec![]);
        for (one, residual) in lines {
            let ((place, at), column) = (one.place(), one.measured.column());
            let far = residual.abs();
            let [value, at] = [one.value, at].map(short);
            named.push(format!("{} ({column} = {value} at {place} = {at})", data.position(one)));
            // Residuals of shares and logarithms are differences.
            sizes.push(match (one.std, one.measured.is_difference()) {
                (Some(_), _) => format!("{} standard deviations", rounded(far)),
                (None, true) => rounded(far),
                (None, false) => format!("a factor of {}", rounded(far.exp())),
            });
        }
        let agree = self.misfit.max(ACCURACY);
        let agree = match data.has_std() {
            true => format!("{} standard deviations", rounded(agree)),
            false if data.iter().all(|one| one.measured.is_difference()) => rounded(agree),
            false => format!("{} %", rounded(100.0 * agree)),
        };
        let [deviate, remove] = match lines.len() {
            1 => ["deviates", "check or remove it"],
            _ => ["deviate", "check or remove them"],
        };
        let [named, sizes] = [named, sizes].map(|texts| texts.join(" and "));
        let (column, far) = lines.first().map_or((String::new(), f64::NAN), |(one, residual)| {
            (one.measured.column(), *residual)
        });
        let text = format!(
            "{named} {deviate} by {sizes} from a fit to the other {}s, which agree within {agree} (root mean square); {remove}",
            data.row_name()
        );
        doubt(OUTLIER, &column, far, text)
    }
}
