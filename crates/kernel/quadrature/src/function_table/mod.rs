//! A costly function of x > 0, tabulated once as Chebyshev series between its kinks.

mod cell;

use std::sync::{Arc, OnceLock};

use crate::{Estimate, QuadratureError, Sampler};
use cell::{PiecewiseSeries, Source};

/// Cells span a factor 64 each and cover x from 64^-21 to 64^21.
const CELLS: usize = 42;
const OCTAVES: i64 = 6;

/// The costly function, with an estimate of its own error.
type Function = dyn Fn(f64) -> Estimate + Send + Sync;

/// A function of x > 0 that is smooth in ln x between its kinks, where it may have fractional
/// powers of the distance. Cells are built when first needed, and shared by all threads.
pub struct FunctionTable {
    source: Source,
    cells: Box<[OnceLock<Result<PiecewiseSeries, QuadratureError>>]>,
}

impl FunctionTable {
    /// Tabulates `function`, whose kinks are listed, to `tolerance`, relative to its largest f(x)/x
    /// within a factor 64: between kinks that nearly meet, the function may be as small as its
    /// rounding.
    #[must_use]
    pub fn new(function: Arc<Function>, kinks: &[f64], tolerance: f64) -> Self {
        let mut kinks: Vec<f64> =
            kinks.iter().copied().filter(|k| k.is_finite() && *k > 0.0).collect();
        kinks.sort_by(f64::total_cmp);
        // Closer kinks are one: the strip between them carries nothing.
        kinks.dedup_by(|a, b| (*a - *b).abs() <= 1e-13 * *a);
        let cells = (0..CELLS).map(|_| OnceLock::new()).collect();
        Self { source: Source { function, kinks, tolerance }, cells }
    }

    /// The kinks, ascending.
    #[must_use]
    pub fn kinks(&self) -> &[f64] {
        &self.source.kinks
    }

    /// The value at x > 0.
    ///
    /// # Errors
    /// [`QuadratureError::NotConverged`] where the tolerance is missed, and
    /// [`QuadratureError::Refused`] for x outside 1e-37 ... 1e37.
    pub fn value(&self, x: f64) -> Result<f64, QuadratureError> {
        let (octave, cell) = self.cell(x);
        let Some(cell) = cell else {
            let reason = format!("x is {x:e}: the table covers 1e-37 to 1e37");
            return Err(QuadratureError::Refused { reason });
        };
        let build = || {
            let low = 2f64.powi((octave.div_euclid(OCTAVES) * OCTAVES) as i32);
            self.source.cell(low, 2f64.powi(OCTAVES as i32) * low)
        };
        cell.get_or_init(build).as_ref().map(|cell| cell.value(x)).map_err(Clone::clone)
    }

    /// The octave of x, and its cell, if there is one.
    fn cell(&self, x: f64) -> (i64, Option<&OnceLock<Result<PiecewiseSeries, QuadratureError>>>) {
        let octave = (x.to_bits() >> 52) as i64 - 1023;
        let index = octave.div_euclid(OCTAVES) + CELLS as i64 / 2;
        let cell = usize::try_from(index).ok().and_then(|i| self.cells.get(i));
        (octave, cell.filter(|_| x > 0.0))
    }
}

impl Sampler for FunctionTable {
    fn relative_error(&self, x: &[f64]) -> f64 {
        // The tolerance, and the largest error of the cells of x. Other cells do not count: the
        // digits of an answer must not depend on earlier questions.
        let cell = |x: &f64| self.cell(*x).1.and_then(OnceLock::get).and_then(|c| c.as_ref().ok());
        let largest = x.iter().filter_map(cell).map(|cell| cell.error).fold(0.0, f64::max);
        self.source.tolerance + 4.0 * largest
    }

    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        for (out, &x) in out.iter_mut().zip(x) {
            *out = self.value(x)?;
        }
        Ok(())
    }
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
        let table = FunctionTable::new(Arc::new(counted), &[1.0], 1e-14);
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
        // Zero up to 110, inside a cell; far above, noise that no series can represent.
        let table = FunctionTable::new(
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
    fn functions_that_miss_the_tolerance_are_refused() {
        let noise = exact(|x| x * (1.0 + 1e-3 * (1e9 * x).sin()));
        let unsure = Arc::new(|x: f64| Estimate { value: x, error: 1e-6 * x, evaluations: 1 });
        for function in [noise, unsure as Arc<Function>] {
            let error = FunctionTable::new(function, &[], 1e-11).value(1e9).unwrap_err();
            assert!(
                matches!(error, QuadratureError::NotConverged { reached, .. } if reached > 1e-7)
            );
        }
    }

    #[test]
    fn between_kinks_that_nearly_meet_rounding_does_not_matter() {
        // As just above the onset of a regime: between the kinks lies (x - 110)^1.5, with the
        // rounding of x.
        let kinks = [110.0, 110.0 * (1.0 + 1e-6)];
        let function = exact(|x| if x < 110.0 { x } else { x + (x - 110.0).powf(1.5) });
        for part in [function, exact(|x| if x < 110.0 { 0.0 } else { (x - 110.0).powf(1.5) })] {
            let table = FunctionTable::new(part, &kinks, 1e-13);
            for x in [110.0 * (1.0 + 5e-7), 200.0] {
                table.value(x).unwrap();
                assert!(table.relative_error(&[x]) < 6e-13);
            }
        }
    }
}
