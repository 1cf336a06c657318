//! One cell of an integral over a weight: Chebyshev series in d.

use super::integral::SCALED;
use super::integrand::Sums;
use crate::Moments;
use crate::chebyshev::{chebyshev_sum, chebyshev_terms};

/// Terms of a series; its error is estimated from the last three.
pub(super) const TERMS: usize = 12;
const LAST: usize = 3;

/// The integral over a range of d.
#[derive(Debug)]
pub(super) struct Series {
    map: Map,
    /// Value, slope and their sizes, over exp(`ln_scale`); no sizes if they equal the values.
    terms: [Vec<f64>; 4],
    /// The logarithm of the scale at the lower end, and its slope.
    ln_scale: [f64; 2],
    /// The smallest sizes of value and slope, over their scale.
    least: [f64; 2],
    /// The integration errors of value and slope, and the bound.
    pub(super) reached: [f64; 2],
    pub(super) error: f64,
}

/// From d to v in [0, 1].
#[derive(Debug, Clone, Copy)]
pub(super) struct Map {
    low: f64,
    high: f64,
    spacing: Spacing,
}

#[derive(Debug, Clone, Copy)]
enum Spacing {
    Linear,
    /// The distance to the lower end is v².
    Low,
    /// The distance to the higher end is v².
    High,
}

impl Map {
    /// Over a range; `sharp` where breaks and kinks meet at its ends.
    pub(super) fn new((low, high): (f64, f64), sharp: [bool; 2]) -> Self {
        let spacing = match sharp {
            [true, false] => Spacing::Low,
            [false, true] => Spacing::High,
            _ => Spacing::Linear,
        };
        Self { low, high, spacing }
    }

    pub(super) fn d(&self, v: f64) -> f64 {
        let width = self.high - self.low;
        match self.spacing {
            Spacing::Linear => self.low + width * v,
            Spacing::Low => self.low + width * v * v,
            Spacing::High => self.high - width * v * v,
        }
    }

    fn v(&self, d: f64) -> f64 {
        let width = self.high - self.low;
        match self.spacing {
            Spacing::Linear => (d - self.low) / width,
            Spacing::Low => ((d - self.low) / width).sqrt(),
            Spacing::High => ((self.high - d) / width).sqrt(),
        }
    }
}

/// The integral at one d.
pub(super) type Sample = (f64, Sums);

/// The logarithm of the size of the integral at its d.
pub(super) fn ln_size((d, found): Sample) -> (f64, f64) {
    (d, found.sizes[0].ln() + found.ln_scale)
}

impl Series {
    /// The series through the integrals at the roots, and the last terms of value and of slope,
    /// relative to their smallest sizes.
    pub(super) fn through(map: Map, samples: &[Sample]) -> (Self, [f64; 2]) {
        // Far out, sizes are nearly exponentials of d.
        let ((d, from), (to, there)) = (ln_size(samples[0]), ln_size(samples[TERMS - 1]));
        let slope = (there - from) / (to - d);
        let ln_scale =
            if slope.is_finite() { [from + slope * (map.low - d), slope] } else { [0.0; 2] };
        let (terms, none) = (Default::default(), [0.0; 2]);
        let mut series = Self { map, terms, ln_scale, least: none, reached: none, error: 0.0 };
        let numbers: Vec<[f64; 4]> = samples.iter().map(|sample| series.numbers(sample)).collect();
        for n in [0, 1] {
            series.least[n] = numbers.iter().map(|f| f[n + 2]).fold(f64::INFINITY, f64::min);
            // Sizes are the values themselves if nothing changes sign.
            let same = |f: &[f64; 4]| (f[n] - f[n + 2]).abs() <= 1e-13 * f[n + 2];
            let wanted = if numbers.iter().all(same) { vec![n] } else { vec![n, n + 2] };
            for n in wanted {
                let samples: Vec<f64> = numbers.iter().map(|f| f[n]).collect();
                series.terms[n] = chebyshev_terms(&samples);
            }
        }
        let last = |n: usize| series.terms[n][TERMS - LAST..].iter().map(|t| t.abs()).sum();
        let left = [0, 1].map(|n| series.relative(n, last(n)));
        (series, left)
    }

    /// Value, slope and sizes of a sample, in the cell's scale.
    fn numbers(&self, (d, found): &Sample) -> [f64; 4] {
        let Sums { sums: [value, slope], sizes: [size, slope_size], ln_scale, .. } = *found;
        let scale = (ln_scale - self.ln_scale(*d)).exp();
        [value, slope, size, slope_size].map(|number| number * scale)
    }

    fn ln_scale(&self, d: f64) -> f64 {
        self.ln_scale[0] + self.ln_scale[1] * (d - self.map.low)
    }

    /// A deviation over the smallest size; infinite if NaN, as on ranges over which the scale
    /// overflows f64.
    fn relative(&self, n: usize, off: f64) -> f64 {
        let share = if off == 0.0 { 0.0 } else { off / self.least[n] };
        if share.is_nan() { f64::INFINITY } else { share }
    }

    /// The deviations from a sample.
    pub(super) fn off(&self, sample: &Sample) -> [f64; 2] {
        let y = 2.0 * self.map.v(sample.0) - 1.0;
        let numbers = self.numbers(sample);
        let off = |n: usize| (chebyshev_sum(&self.terms[n], y) - numbers[n]).abs();
        [0, 1].map(|n| self.relative(n, off(n)))
    }

    #[inline]
    pub(super) fn moments(&self, d: f64, slope: bool) -> Moments {
        let y = 2.0 * self.map.v(d) - 1.0;
        let ln = self.ln_scale(d);
        let (scale, ln_scale) = if ln.abs() < SCALED { (ln.exp(), 0.0) } else { (1.0, ln) };
        let sum = |n: usize| scale * chebyshev_sum(&self.terms[n], y);
        let size = |n: usize, f: f64| {
            if self.terms[n].is_empty() { f.abs() } else { sum(n).max(f.abs()) }
        };
        let (value, by_d) = (sum(0), if slope { sum(1) } else { 0.0 });
        let sizes = [size(2, value), if slope { size(3, by_d) } else { 0.0 }];
        Moments { value, slope: by_d, sizes, ln_scale, error: self.error }
    }
}
