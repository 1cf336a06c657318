//! The starts of the search for the least squares, the same in every run.

use crate::FitError;
use crate::problem::{Minimum, Problem, squares};

/// Samples of the bounds for each free parameter, from which starts are chosen.
const SAMPLES: usize = 16;
/// Evaluations for each free parameter before a search from one start gives up.
pub(crate) const PATIENCE: usize = 150;
/// Coordinates of a minimum and of a coarse search for it differ by less.
const SAME: f64 = 0.01;
/// Minima whose sums of squares differ by less fit the data equally well.
const EQUAL: f64 = 1e-6;

/// The minimum with the least squares: searched from the start given, from the best `more` samples
/// within the bounds and, if there are more, from a body so hard that it does not yield, each with
/// so many evaluations for a free parameter.
pub(crate) fn search(
    problem: &Problem<'_>,
    more: usize,
    patience: usize,
) -> Result<Minimum, FitError> {
    let given = problem.start();
    let mut starts = vec![given.clone()];
    starts.extend(samples(problem, more)?);
    if more > 0 {
        starts.extend(elastic(problem, &given, patience)?);
    }
    let mut minima: Vec<Minimum> = vec![];
    for start in &starts {
        let _ = (problem.count)([1, 0]);
        // A start without values leads nowhere.
        if problem.predicted(start).is_ok() {
            let all: Vec<usize> = (0..start.len()).collect();
            let found = problem.minimise(start, &all, (patience, problem.coarse()))?;
            if !problem.forward.is_slow() {
                minima.push(found);
            } else if minima.iter().all(|known| known.is_far_from(&found, SAME)) {
                minima.push(problem.minimise_all(&found.coordinates, patience)?);
            }
        }
    }
    minima.retain(|minimum| problem.predicted(&minimum.coordinates).is_ok());
    // The first of equals, which is nearest to the start given.
    let best = minima.iter().map(|minimum| minimum.squares).fold(f64::INFINITY, f64::min);
    let least = best * (1.0 + EQUAL) + problem.met();
    minima.into_iter().find(|minimum| minimum.squares <= least).ok_or_else(|| {
        let reason = problem.predicted(&given).err();
        let reason = reason.unwrap_or(asperity_core::ContactError::NoMeanPlane);
        FitError::NoStart { model: problem.model.id().into(), reason }
    })
}

/// The least squares with a free strength near its upper bound: elastic data have a flat minimum
/// there, which a ridge parts from other starts.
fn elastic(
    problem: &Problem<'_>,
    given: &[f64],
    patience: usize,
) -> Result<Option<Vec<f64>>, FitError> {
    let is_strength =
        |k: &usize| ["hardness", "yield_strength"].contains(&&*problem.parameters[*k].name);
    let (strengths, others): (Vec<usize>, Vec<usize>) = (0..given.len()).partition(is_strength);
    if strengths.is_empty() || others.is_empty() {
        return Ok(None);
    }
    // A model may have no value for the hardest bodies.
    let start = [0.95, 0.8, 0.65].into_iter().find_map(|share| {
        let mut start = given.to_vec();
        for k in &strengths {
            let [low, high] = problem.parameters[*k].range();
            start[*k] = low + share * (high - low);
        }
        problem.predicted(&start).is_ok().then_some(start)
    });
    let found = start
        .map(|start| problem.minimise(&start, &others, (patience, problem.coarse())))
        .transpose()?;
    Ok(found.map(|minimum| minimum.coordinates))
}

/// The samples with the least squares: of one parameter the local minima of even steps, of several
/// the best of a low-discrepancy sequence.
fn samples(problem: &Problem<'_>, most: usize) -> Result<Vec<Vec<f64>>, FitError> {
    if most == 0 {
        return Ok(vec![]);
    }
    let count = SAMPLES * problem.parameters.len();
    let place = |k: usize| -> Vec<f64> {
        let shares = shares(k, count, problem.parameters.len());
        let coordinate = |(parameter, share): (&crate::Parameter, f64)| {
            let [low, high] = parameter.range();
            low + (high - low) * share
        };
        problem.parameters.iter().zip(shares).map(coordinate).collect()
    };
    let places: Vec<Vec<f64>> = (0..count).map(place).collect();
    let sizes = places.iter().map(|place| Ok(squares(&problem.residuals(place)?)));
    let sizes: Vec<f64> = sizes.collect::<Result<_, FitError>>()?;
    let size = |k: usize| sizes.get(k).copied().unwrap_or(f64::INFINITY);
    let is_local = |k: &usize| {
        problem.parameters.len() > 1
            || size(*k) <= size(k + 1) && size(*k) <= size(k.wrapping_sub(1))
    };
    let mut order: Vec<usize> = (0..count).filter(is_local).collect();
    order.sort_by(|a, b| size(*a).total_cmp(&size(*b)));
    Ok(order.into_iter().take(most).map(|k| places[k].clone()).collect())
}

/// Point k of `count` in the unit cube: even steps in one dimension, otherwise Roberts' additive
/// sequence of the powers of the root of x^(n+1) = x + 1.
fn shares(k: usize, count: usize, dimensions: usize) -> Vec<f64> {
    if dimensions == 1 {
        return vec![(k as f64 + 0.5) / count as f64];
    }
    let mut root = 2.0f64;
    for _ in 0..60 {
        root = (1.0 + root).powf(1.0 / (dimensions as f64 + 1.0));
    }
    let share = |power: usize| (0.5 + k as f64 * root.powi(-(power as i32))).fract();
    (1..=dimensions).map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_fill_the_cube_evenly() {
        assert_eq!(shares(0, 2, 1), [0.25]);
        // No quarter of the square and no eighth of the cube is left empty.
        for dimensions in [2, 3] {
            let mut cells = std::collections::BTreeSet::new();
            for k in 0..16 * dimensions {
                let shares = shares(k, 0, dimensions);
                cells.insert(shares.iter().map(|share| (2.0 * share) as u8).collect::<Vec<_>>());
            }
            assert_eq!(cells.len(), 1 << dimensions);
        }
    }
}
