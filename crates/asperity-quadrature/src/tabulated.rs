//! A costly function of x > 0, tabulated once as Chebyshev series between its kinks.

use std::fmt;
use std::sync::{Arc, OnceLock};

use crate::chebyshev::{chebyshev_roots, chebyshev_sum, chebyshev_terms};
use crate::{Estimate, QuadratureError, Sampler};

/// Coefficients of a series, or a third of them where those do.
const TERMS: usize = 24;
const FEW: usize = TERMS / 3;
/// Cells span a factor 64 each and cover x from 64^-21 to 64^21.
const CELLS: usize = 42;
const OCTAVES: i64 = 6;
/// Bisection ends here,
const DEEPEST: u32 = 24;
/// or where a cell has this many series: a noisy function is not worth more,
const MOST: usize = 40;
/// or where this many halvings in a row have not halved the tail.
const STALLED: u32 = 3;
/// What is reached then may be this many times the tolerance: noise, not a kink.
const REFUSED: f64 = 10.0;

/// The costly function, with an estimate of its own error.
type Function = dyn Fn(f64) -> Estimate + Send + Sync;

/// What has been tabulated of a cell, if anything.
type Cell = OnceLock<Result<Table, QuadratureError>>;

/// A function of x > 0 that is smooth in ln x between its kinks, where it may have fractional
/// powers of the distance. Cells are built when first needed, and shared by all threads.
pub struct Tabulated {
    function: Arc<Function>,
    kinks: Vec<f64>,
    tolerance: f64,
    cells: Box<[Cell]>,
}

impl fmt::Debug for Tabulated {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Tabulated").field("kinks", &self.kinks).finish_non_exhaustive()
    }
}

/// What the fits on the larger ranges around one have found.
#[derive(Debug, Clone, Copy)]
struct Parents {
    depth: u32,
    size: f64,
    tail: f64,
    stalled: u32,
}

impl Default for Parents {
    fn default() -> Self {
        Self { depth: 0, size: 0.0, tail: f64::INFINITY, stalled: 0 }
    }
}

/// How a cell's x becomes the variable v in [0, 1] of its series.
#[derive(Debug, Clone, Copy)]
enum Map {
    /// v linear in ln x.
    Log,
    /// ln(x/low) = width v⁴: powers of the distance to a kink on the left become smooth.
    Left,
    /// ln(high/x) = width v⁴: a kink on the right.
    Right,
}

/// A cell: its series, ascending, and the largest relative tail that was left.
#[derive(Debug, Default)]
struct Table {
    series: Vec<Series>,
    reached: f64,
}

#[derive(Debug)]
struct Series {
    low: f64,
    high: f64,
    map: Map,
    /// Range of v on which the series lives.
    range: (f64, f64),
    /// Ends of the map's own interval.
    ends: (f64, f64),
    /// Of f(x)/x: 8 or 24.
    terms: Vec<f64>,
}

impl Tabulated {
    /// Tabulates `function`, whose kinks are listed, to `tolerance`, relative to its largest f(x)/x
    /// within a factor 64: between kinks that nearly meet it may be too small to differ from
    /// rounding.
    #[must_use]
    pub fn new(function: Arc<Function>, kinks: &[f64], tolerance: f64) -> Self {
        let mut kinks: Vec<f64> =
            kinks.iter().copied().filter(|k| k.is_finite() && *k > 0.0).collect();
        kinks.sort_by(f64::total_cmp);
        // Kinks closer than this are one: the strip between them carries nothing.
        kinks.dedup_by(|a, b| (*a - *b).abs() <= 1e-13 * *a);
        let cells = (0..CELLS).map(|_| Cell::new()).collect();
        Self { function, kinks, tolerance, cells }
    }

    /// The kinks, ascending.
    #[must_use]
    pub fn kinks(&self) -> &[f64] {
        &self.kinks
    }

    /// The value at x > 0.
    ///
    /// # Errors
    /// What the function refuses; x outside 1e-37 ... 1e37.
    pub fn value(&self, x: f64) -> Result<f64, QuadratureError> {
        let (octave, cell) = self.cell(x);
        let Some(cell) = cell else {
            let reason = format!("tabulated from 1e-37 to 1e37, asked at {x:e}");
            return Err(QuadratureError::Refused { reason });
        };
        let Table { series, .. } = cell
            .get_or_init(|| {
                let low = 2f64.powi((octave.div_euclid(OCTAVES) * OCTAVES) as i32);
                self.build(low, 2f64.powi(OCTAVES as i32) * low)
            })
            .as_ref()
            .map_err(Clone::clone)?;
        let at = series.partition_point(|s| s.high <= x).min(series.len() - 1);
        Ok(x * series[at].value(x))
    }

    /// The octave of x, and its cell, if there is one.
    fn cell(&self, x: f64) -> (i64, Option<&Cell>) {
        let octave = (x.to_bits() >> 52) as i64 - 1023;
        let index = octave.div_euclid(OCTAVES) + CELLS as i64 / 2;
        let cell = usize::try_from(index).ok().and_then(|i| self.cells.get(i));
        (octave, cell.filter(|_| x > 0.0))
    }

    fn build(&self, low: f64, high: f64) -> Result<Table, QuadratureError> {
        let is_kink = |x: f64| self.kinks.iter().any(|k| (k - x).abs() <= 1e-13 * x);
        let inner = self.kinks.iter().copied().filter(|k| *k > low && *k < high);
        let mut ends: Vec<f64> = std::iter::once(low).chain(inner).chain([high]).collect();
        ends.dedup_by(|a, b| (*a - *b).abs() <= 1e-13 * *a);
        let mut first = Parents::default();
        for pair in ends.windows(2) {
            let middle = (pair[0] * pair[1]).sqrt();
            first.size = first.size.max(((self.function)(middle).value / middle).abs());
        }
        let mut table = Table::default();
        for pair in ends.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let mut fit = |ends, map| self.fit(ends, map, (0.0, 1.0), first, &mut table);
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
        table.series.sort_by(|a, b| a.low.total_cmp(&b.low));
        Ok(table)
    }

    fn fit(
        &self,
        ends: (f64, f64),
        map: Map,
        range: (f64, f64),
        parents: Parents,
        found: &mut Table,
    ) -> Result<(), QuadratureError> {
        let (mut evaluations, mut error) = (0, 0.0f64);
        let mut sample = |root: f64| {
            let x = map.x(ends, range.0 + (range.1 - range.0) * (0.5 + 0.5 * root));
            let found = (self.function)(x);
            evaluations += found.evaluations;
            error = error.max(found.error / x);
            found.value / x
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
        // Noise does not fall by halving, a kink does; neither is followed for ever.
        let stalled = if tail > 0.5 * parents.tail { parents.stalled + 1 } else { 0 };
        if tail <= self.tolerance * size
            || stalled >= STALLED
            || parents.depth >= DEEPEST
            || found.series.len() >= MOST
        {
            // A function that is zero throughout has neither size nor tail.
            let reached = if size > 0.0 { tail.max(error) / size } else { 0.0 };
            if reached > REFUSED * self.tolerance {
                let asked = self.tolerance;
                return Err(QuadratureError::NotConverged { reached, asked, evaluations });
            }
            found.reached = found.reached.max(reached);
            let (x0, x1) = (map.x(ends, range.0), map.x(ends, range.1));
            found.series.push(Series {
                low: x0.min(x1),
                high: x0.max(x1),
                map,
                range,
                ends,
                terms,
            });
            return Ok(());
        }
        let next = Parents { depth: parents.depth + 1, size, tail, stalled };
        let middle = 0.5 * (range.0 + range.1);
        self.fit(ends, map, (range.0, middle), next, found)?;
        self.fit(ends, map, (middle, range.1), next, found)
    }
}

impl Sampler for Tabulated {
    fn relative_error(&self, x: &[f64]) -> f64 {
        // The tolerance of what is tabulated, and what the tables used add to it: not all that
        // have been built, or digits would depend on what was asked before.
        let table = |x: &f64| self.cell(*x).1.and_then(Cell::get).and_then(|c| c.as_ref().ok());
        let reached = x.iter().filter_map(table).map(|table| table.reached).fold(0.0, f64::max);
        self.tolerance + 4.0 * reached
    }

    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, &x) in out.iter_mut().zip(x) {
            *out = self.value(x)?;
        }
        Ok(())
    }
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

impl Series {
    fn value(&self, x: f64) -> f64 {
        let v = self.map.v(self.ends, x);
        chebyshev_sum(&self.terms, 2.0 * (v - self.range.0) / (self.range.1 - self.range.0) - 1.0)
    }
}

/// The largest term, relative to the whole interval between kinks: where the function starts at
/// zero, its relative accuracy next to the kink is limited by the rounding of x. And the largest
/// of the last four: one or two can be small by accident.
fn size_and_tail(terms: &[f64], size: f64) -> (f64, f64) {
    let largest = |terms: &[f64]| terms.iter().fold(0.0, |m: f64, t| m.max(t.abs()));
    (largest(terms).max(size), largest(&terms[terms.len() - 4..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn follows_a_function_with_fractional_kinks_and_samples_only_where_asked() {
        let count = Arc::new(AtomicUsize::new(0));
        let counter = count.clone();
        let f = |x: f64| {
            x.powf(1.5) * (1.0 + x.powf(0.525)) + if x > 1.0 { (x - 1.0).powf(2.27) } else { 0.0 }
        };
        let counted = move |x: f64| {
            counter.fetch_add(1, Ordering::Relaxed);
            Estimate { value: f(x), error: 0.0, evaluations: 1 }
        };
        let table = Tabulated::new(Arc::new(counted), &[1.0], 1e-14);
        assert_eq!(count.load(Ordering::Relaxed), 0);
        for k in 0..500 {
            let x = 1e-6 * 1.05f64.powi(k);
            assert!((table.value(x).unwrap() / f(x) - 1.0).abs() < 1e-13, "{x}");
        }
        assert!(count.load(Ordering::Relaxed) < 800, "{count:?}");
        assert!(table.value(0.0).is_err() && table.value(f64::NAN).is_err());
    }

    fn exact(f: fn(f64) -> f64) -> Arc<Function> {
        Arc::new(move |x| Estimate { value: f(x), error: 0.0, evaluations: 1 })
    }

    #[test]
    fn the_error_is_a_number_and_depends_only_on_the_points() {
        // Zero up to 110, inside a cell; noise that no series follows far above.
        let table = Tabulated::new(
            exact(|x| match x {
                x if x < 110.0 => 0.0,
                x if x < 1e6 => x - 110.0,
                x => x * (1.0 + 1e-10 * (1e9 * x).sin()),
            }),
            &[110.0],
            1e-11,
        );
        assert!((table.value(200.0).unwrap() / 90.0 - 1.0).abs() < 1e-11);
        let before = table.relative_error(&[200.0]);
        assert!(before < 1e-10, "{before:e}");
        table.value(1e9).unwrap();
        assert!(table.relative_error(&[200.0]).to_bits() == before.to_bits());
        assert!(table.relative_error(&[200.0, 1e9]) > 1e-10);
    }

    #[test]
    fn what_misses_the_tolerance_is_refused() {
        let noise = exact(|x| x * (1.0 + 1e-3 * (1e9 * x).sin()));
        let unsure = Arc::new(|x: f64| Estimate { value: x, error: 1e-6 * x, evaluations: 1 });
        for function in [noise, unsure as Arc<Function>] {
            let error = Tabulated::new(function, &[], 1e-11).value(1e9).unwrap_err();
            assert!(
                matches!(error, QuadratureError::NotConverged { reached, .. } if reached > 1e-7)
            );
        }
    }

    #[test]
    fn between_kinks_that_nearly_meet_rounding_does_not_matter() {
        // As just above the beginning of a regime: what lies between is (x - 110)^1.5, with the
        // rounding of x.
        let kinks = [110.0, 110.0 * (1.0 + 1e-6)];
        let function = exact(|x| if x < 110.0 { x } else { x + (x - 110.0).powf(1.5) });
        for part in [function, exact(|x| if x < 110.0 { 0.0 } else { (x - 110.0).powf(1.5) })] {
            let table = Tabulated::new(part, &kinks, 1e-13);
            for x in [110.0 * (1.0 + 5e-7), 200.0] {
                table.value(x).unwrap();
                assert!(table.relative_error(&[x]) < 6e-13);
            }
        }
    }
}
