//! The time of a call: median over batches.

use std::time::{Duration, Instant};

use crate::figures::report_csv::median;

/// The measuring time of a row: a number of batches of a least duration, within a total time.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Largest number of batches.
    pub repeats: usize,
    /// Least duration of a batch.
    pub batch: Duration,
    /// Total time, after three batches.
    pub most: Duration,
}

impl Effort {
    /// Median time of one call \[ns\] over at least three batches, after two warm-up calls.
    #[must_use]
    pub fn median_ns(&self, mut call: impl FnMut()) -> f64 {
        let mut time = |calls: u32| {
            let start = Instant::now();
            (0..calls).for_each(|_| call());
            start.elapsed()
        };
        let once = time(1).min(time(1)).max(Duration::from_nanos(20));
        let calls = self.batch.as_nanos().div_ceil(once.as_nanos()).clamp(1, 1_000_000) as u32;
        let (start, mut batches) = (Instant::now(), vec![]);
        while batches.len() < self.repeats && (batches.len() < 3 || start.elapsed() < self.most) {
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
        let (batch, most) = (Duration::from_micros(50), Duration::from_millis(5));
        let found = Effort { repeats: 3, batch, most }.median_ns(|| std::thread::sleep(nap));
        assert!((2e6..2e7).contains(&found), "{found}");
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
    }
}
