//! Median times of jobs, warmed up, in an order that no branch predictor learns.

use std::hint::black_box;
use std::time::{Duration, Instant};

use super::methods::Job;

/// How long to measure.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Times a batch is measured; the median counts.
    pub repeats: usize,
    /// Least duration of a batch.
    pub batch: Duration,
    /// A row ends after this long, with three batches at least.
    pub most: Duration,
}

impl Effort {
    /// For the committed figures.
    pub const FULL: Self =
        Self { repeats: 21, batch: Duration::from_micros(300), most: Duration::from_millis(60) };
    /// To see that it runs.
    pub const QUICK: Self =
        Self { repeats: 3, batch: Duration::from_micros(50), most: Duration::from_millis(5) };

    /// Median time of one call \[ns\].
    #[must_use]
    pub fn median_ns(&self, mut call: impl FnMut()) -> f64 {
        let time = |call: &mut dyn FnMut(), calls: u32| {
            let start = Instant::now();
            (0..calls).for_each(|_| call());
            start.elapsed()
        };
        let first = time(&mut call, 1);
        // What takes long needs no warming up.
        let once = if first > self.most { first } else { time(&mut call, 1) };
        let once = once.max(Duration::from_nanos(20));
        let calls = self.batch.as_nanos().div_ceil(once.as_nanos()).clamp(1, 1_000_000) as u32;
        let start = Instant::now();
        let mut batches = vec![];
        while batches.len() < self.repeats && (batches.len() < 3 || start.elapsed() < self.most) {
            batches.push(time(&mut call, calls).as_nanos() as f64 / f64::from(calls));
        }
        median(&mut batches)
    }

    /// Median time of one of these jobs \[ns\], all run in turn.
    #[must_use]
    pub fn of_jobs(&self, jobs: &[Job]) -> f64 {
        let all = || {
            for job in jobs {
                // Failures take their time like answers.
                let _ = black_box(black_box(job)());
            }
        };
        self.median_ns(all) / jobs.len().max(1) as f64
    }
}

fn median(numbers: &mut [f64]) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_call_that_sleeps_takes_as_long_as_it_sleeps() {
        let nap = Duration::from_millis(2);
        let found = Effort::QUICK.median_ns(|| std::thread::sleep(nap));
        assert!((2e6..2e7).contains(&found), "{found}");
        assert!(median(&mut [3.0, 1.0, 2.0]).total_cmp(&2.0).is_eq());
    }
}
