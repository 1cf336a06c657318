//! One cell of a table: series between kinks, halved until they meet the tolerance.

use std::sync::Arc;

use super::Function;
use crate::QuadratureError;
use crate::chebyshev::{chebyshev_roots, chebyshev_sum, chebyshev_terms};

/// Coefficients of a series, or a third of them where those suffice.
const TERMS: usize = 24;
const FEW: usize = TERMS / 3;
/// Bisection ends at this depth,
const DEEPEST: u32 = 24;
/// at this number of series in a cell, as a noisy function is not worth more,
const MOST: usize = 40;
/// or after this number of halvings in a row that have not halved the tail.
const STALLED: u32 = 3;
/// The error may then be this many times the tolerance: noise, not a kink.
const REFUSED: f64 = 10.0;

/// The function to be tabulated, to a relative tolerance.
pub(super) struct Source {
    pub(super) function: Arc<Function>,
    /// Ascending.
    pub(super) kinks: Vec<f64>,
    pub(super) tolerance: f64,
}

/// The series of a cell, ascending, and their largest relative error.
#[derive(Debug, Default)]
pub(super) struct PiecewiseSeries {
    series: Vec<Series>,
    pub(super) error: f64,
}

impl PiecewiseSeries {
    pub(super) fn value(&self, x: f64) -> f64 {
        let at = self.series.partition_point(|s| s.high <= x).min(self.series.len() - 1);
        x * self.series[at].value(x)
    }
}

/// The fits on the larger ranges around a range.
#[derive(Debug, Clone, Copy)]
struct Parents {
    depth: u32,
    size: f64,
    tail: f64,
    stalled: u32,
}

impl Source {
    /// The cell from `low` to `high`.
    pub(super) fn cell(&self, low: f64, high: f64) -> Result<PiecewiseSeries, QuadratureError> {
        let is_kink = |x: f64| self.kinks.iter().any(|k| (k - x).abs() <= 1e-13 * x);
        let inner = self.kinks.iter().copied().filter(|k| *k > low && *k < high);
        let mut ends: Vec<f64> = std::iter::once(low).chain(inner).chain([high]).collect();
        ends.dedup_by(|a, b| (*a - *b).abs() <= 1e-13 * *a);
        let mut first = Parents { depth: 0, size: 0.0, tail: f64::INFINITY, stalled: 0 };
        for pair in ends.windows(2) {
            let middle = (pair[0] * pair[1]).sqrt();
            first.size = first.size.max(((self.function)(middle).value / middle).abs());
        }
        let mut cell = PiecewiseSeries::default();
        for pair in ends.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let mut fit = |ends, map| self.fit(ends, map, (0.0, 1.0), first, &mut cell);
            match (is_kink(a), is_kink(b)) {
                (false, false) => fit((a, b), Map::Log)?,
                (true, false) => fit((a, b), Map::Left)?,
                (false, true) => fit((a, b), Map::Right)?,
                (true, true) => {
                    let middle = (a * b).sqrt();
                    fit((a, middle), Map::Left)?;
                    fit((middle, b), Map::Right)?;
                }
            }
        }
        cell.series.sort_by(|a, b| a.low.total_cmp(&b.low));
        Ok(cell)
    }

    fn fit(
        &self,
        ends: (f64, f64),
        map: Map,
        range: (f64, f64),
        parents: Parents,
        cell: &mut PiecewiseSeries,
    ) -> Result<(), QuadratureError> {
        let (mut evaluations, mut error) = (0, 0.0f64);
        let mut sample = |root: f64| {
            let x = map.x(ends, range.0 + (range.1 - range.0) * (0.5 + 0.5 * root));
            let estimate = (self.function)(x);
            evaluations += estimate.evaluations;
            error = error.max(estimate.error / x);
            estimate.value / x
        };
        // Every third root is one of the polynomial of a third of the degree.
        let few: Vec<f64> = chebyshev_roots(FEW).map(&mut sample).collect();
        let mut terms = chebyshev_terms(&few);
        let (mut size, mut tail) = size_and_tail(&terms, parents.size);
        if tail > 0.1 * self.tolerance * size {
            let known = |k: usize| (k % 3 == 1).then(|| few[k / 3]);
            let all = chebyshev_roots(TERMS).enumerate();
            let all: Vec<f64> =
                all.map(|(k, root)| known(k).unwrap_or_else(|| sample(root))).collect();
            terms = chebyshev_terms(&all);
            (size, tail) = size_and_tail(&terms, parents.size);
        }
        // Halving shrinks the tail beside a kink, but not the tail of noise; both end.
        let stalled = if tail > 0.5 * parents.tail { parents.stalled + 1 } else { 0 };
        if tail <= self.tolerance * size
            || stalled >= STALLED
            || parents.depth >= DEEPEST
            || cell.series.len() >= MOST
        {
            // A function that is zero throughout has neither size nor tail.
            let reached = if size > 0.0 { tail.max(error) / size } else { 0.0 };
            if reached > REFUSED * self.tolerance {
                return Err(QuadratureError::missed(reached, self.tolerance, evaluations));
            }
            cell.error = cell.error.max(reached);
            cell.series.push(Series::new(map, ends, range, terms));
            return Ok(());
        }
        let next = Parents { depth: parents.depth + 1, size, tail, stalled };
        let middle = 0.5 * (range.0 + range.1);
        self.fit(ends, map, (range.0, middle), next, cell)?;
        self.fit(ends, map, (middle, range.1), next, cell)
    }
}

/// The largest term, at least `size`, and the largest of the last four, as one or two can be small
/// by accident. `size` is that of the whole interval between kinks: where the function starts at
/// zero, the rounding of x limits its relative accuracy next to the kink.
fn size_and_tail(terms: &[f64], size: f64) -> (f64, f64) {
    let largest = |terms: &[f64]| terms.iter().fold(0.0, |m: f64, t| m.max(t.abs()));
    (largest(terms).max(size), largest(&terms[terms.len() - 4..]))
}

/// The variable v in \[0, 1\] of a series, between two ends in x.
#[derive(Debug, Clone, Copy)]
enum Map {
    /// v linear in ln x.
    Log,
    /// ln(x/low) = width v⁴: powers of the distance to a kink on the left become smooth.
    Left,
    /// ln(high/x) = width v⁴: a kink on the right.
    Right,
}

impl Map {
    fn x(self, (low, high): (f64, f64), v: f64) -> f64 {
        let width = (high / low).ln();
        match self {
            Self::Log => low * (v * width).exp(),
            Self::Left => low * (v.powi(4) * width).exp(),
            Self::Right => high * (-v.powi(4) * width).exp(),
        }
    }

    fn v(self, (low, high): (f64, f64), x: f64) -> f64 {
        let width = (high / low).ln();
        let v = match self {
            Self::Log => (x / low).ln() / width,
            Self::Left => ((x / low).ln() / width).max(0.0).sqrt().sqrt(),
            Self::Right => ((high / x).ln() / width).max(0.0).sqrt().sqrt(),
        };
        v.clamp(0.0, 1.0)
    }
}

/// f(x)/x on a part of a map's interval.
#[derive(Debug)]
struct Series {
    low: f64,
    high: f64,
    map: Map,
    /// Ends of the map's interval.
    ends: (f64, f64),
    /// The part in v.
    range: (f64, f64),
    terms: Vec<f64>,
}

impl Series {
    fn new(map: Map, ends: (f64, f64), range: (f64, f64), terms: Vec<f64>) -> Self {
        let (a, b) = (map.x(ends, range.0), map.x(ends, range.1));
        Self { low: a.min(b), high: a.max(b), map, ends, range, terms }
    }

    fn value(&self, x: f64) -> f64 {
        let v = self.map.v(self.ends, x);
        chebyshev_sum(&self.terms, 2.0 * (v - self.range.0) / (self.range.1 - self.range.0) - 1.0)
    }
}
