//! The extent of a run: models, quantities, tolerances, times.

use std::path::PathBuf;
use std::time::{Duration, Instant};

use asperity::{Described, Model, Quantity};

use super::problem::{INTEGRALS, tightest};
use crate::figures::report_csv::median;
use crate::folder::{figures_folder, target_folder};

/// The extent of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// Every model and integral.
    Full,
    /// A few, in seconds, as a test of the whole run.
    Quick,
}

impl Scope {
    /// The pairs of model and quantity.
    #[must_use]
    pub fn pairs(self) -> Vec<(Model, Quantity)> {
        let (models, quantities) = match self {
            Self::Full => ("", &INTEGRALS[..]),
            Self::Quick => ("ke jg gao", &[Quantity::Force, Quantity::Tangent][..]),
        };
        let wanted =
            |model: &Model| models.is_empty() || models.split(' ').any(|id| id == model.id());
        let pairs = |model: Model| quantities.iter().map(move |q| (model.clone(), *q));
        Model::of_asperities().into_iter().filter(wanted).flat_map(pairs).collect()
    }

    /// Tolerances for a model, loosest first, down to its tightest.
    #[must_use]
    pub fn tolerances(self, model: &Model) -> Vec<f64> {
        let all: &[f64] = match self {
            Self::Full => &[1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-13],
            Self::Quick => &[1e-3, 1e-10],
        };
        all.iter().copied().filter(|tolerance| *tolerance >= tightest(model)).collect()
    }

    /// Numbers of points for a method that has them.
    #[must_use]
    pub fn points(self) -> &'static [usize] {
        if self == Self::Full { &[16, 32, 64, 128] } else { &[16, 128] }
    }

    /// The folder of its files.
    #[must_use]
    pub fn folder(self) -> PathBuf {
        if self == Self::Full { figures_folder() } else { target_folder().join("report") }
    }

    /// Median time of one call \[ns\] over at least three batches, after two warm-up calls.
    #[must_use]
    pub fn median_ns(self, mut call: impl FnMut()) -> f64 {
        // Most batches, their least duration, and the total time after three of them.
        let (most, batch, total) = if self == Self::Full { (21, 300, 60) } else { (3, 50, 5) };
        let (batch, total) = (Duration::from_micros(batch), Duration::from_millis(total));
        let mut time = |calls: u32| {
            let start = Instant::now();
            (0..calls).for_each(|_| call());
            start.elapsed()
        };
        let once = time(1).min(time(1)).max(Duration::from_nanos(20));
        let calls = batch.as_nanos().div_ceil(once.as_nanos()).clamp(1, 1_000_000) as u32;
        let (start, mut batches) = (Instant::now(), vec![]);
        while batches.len() < most && (batches.len() < 3 || start.elapsed() < total) {
            batches.push(time(calls).as_nanos() as f64 / f64::from(calls));
        }
        median(batches).unwrap_or(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_of_a_call_that_sleeps_is_the_time_it_sleeps() {
        let nap = Duration::from_millis(2);
        let found = Scope::Quick.median_ns(|| std::thread::sleep(nap));
        assert!((2e6..2e7).contains(&found), "{found}");
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    }
}
