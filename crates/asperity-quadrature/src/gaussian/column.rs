//! One integral at many s, as plain numbers: values of the same segment side by side.

use fearless_simd::{Level, Simd, dispatch};

use super::exponential::LEAST;
use super::patch::Place;
use super::ranges::{SEGMENTS, locate};
use super::shifted::ShiftedGaussian;
use crate::{Moments, QuadratureError};

/// Values that are sorted by segment together: they stay in the fastest memory.
const BATCH: usize = 2048;
/// Shorter runs in one segment, on average, are worth sorting.
const SHORT: usize = 32;

/// What a column of numbers holds: `factor` · I(s + shift), or `factor` · -dI/ds there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// Added to each s.
    pub shift: f64,
    /// Whether the slope -dI/ds is meant, and not the value.
    pub slope: bool,
    /// Finite and not 0.
    pub factor: f64,
}

/// How good all numbers of a column are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColumnAccuracy {
    /// Bound on the relative error of each number: that of the integral, with the rounding of the
    /// sum s + shift, of the scale exp(-s²/2) and of the product with the factor.
    pub error: f64,
    /// The largest ratio of an integral of the absolute value to the integral itself; 1 where
    /// nothing cancels.
    pub condition: f64,
    /// Whether all numbers and their scales are normal numbers; the bound holds only then.
    pub normal: bool,
    /// No s + shift is smaller. Slopes below -8 are small differences of large integrals: see
    /// [`Moments::slope_within`].
    pub lowest: f64,
}

impl ColumnAccuracy {
    /// Of a column without numbers.
    pub const NONE: Self = Self { error: 0.0, condition: 1.0, normal: true, lowest: f64::INFINITY };

    /// Of both columns.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            error: self.error.max(other.error),
            condition: self.condition.max(other.condition),
            normal: self.normal && other.normal,
            lowest: self.lowest.min(other.lowest),
        }
    }
}

impl ShiftedGaussian {
    /// Fills `out`, as long as `s`, with a column: fastest where neighbours in `s` are near each
    /// other, as in ascending order. Numbers are those of [`value`](Self::value) and
    /// [`at`](Self::at) within both bounds, the same on every processor.
    ///
    /// # Errors
    /// One s that is refused, by its index, and the reason; `out` then holds nothing of use.
    pub fn fill(
        &self,
        s: &[f64],
        column: Column,
        out: &mut [f64],
    ) -> Result<ColumnAccuracy, (usize, QuadratureError)> {
        let level = Level::new();
        let mut all = ColumnAccuracy::NONE;
        let mut buffers = Buffers::default();
        buffers.indices.resize(s.len().min(BATCH), 0);
        let batches = s.chunks(BATCH).zip(out.chunks_mut(BATCH));
        for (k, (s, out)) in batches.enumerate() {
            let indices = &mut buffers.indices[..s.len()];
            let changes = dispatch!(level, simd => locate_all(simd, s, column.shift, indices));
            let filled = if changes * SHORT <= s.len() {
                self.runs(level, indices, (s, column), out)
            } else {
                self.sorted(level, &mut buffers, (s, column), out)
            };
            all = all.and(filled.map_err(|(index, error)| (k * BATCH + index, error))?);
        }
        Ok(all)
    }

    /// Runs of values in the same segment, one after the other.
    fn runs(
        &self,
        level: Level,
        indices: &[u32],
        (s, column): (&[f64], Column),
        out: &mut [f64],
    ) -> Result<ColumnAccuracy, (usize, QuadratureError)> {
        let (mut all, mut from) = (ColumnAccuracy::NONE, 0);
        for run in indices.chunk_by(|a, b| a == b) {
            let range = from..from + run.len();
            let filled = self.run(level, (&s[range.clone()], column), &mut out[range]);
            all = all.and(filled.map_err(|(index, error)| (from + index, error))?);
            from += run.len();
        }
        Ok(all)
    }

    /// The same after sorting by segment.
    fn sorted(
        &self,
        level: Level,
        buffers: &mut Buffers,
        (s, column): (&[f64], Column),
        out: &mut [f64],
    ) -> Result<ColumnAccuracy, (usize, QuadratureError)> {
        let Buffers { indices, sorted, values } = buffers;
        let indices = &mut indices[..s.len()];
        sorted.resize(BATCH, 0.0);
        values.resize(BATCH, 0.0);
        // Where the next value of each segment goes.
        let mut next = [0u32; SEGMENTS + 1];
        indices.iter().for_each(|index| next[*index as usize] += 1);
        let mut total = 0;
        for next in &mut next {
            total += std::mem::replace(next, total);
        }
        for (place, s) in indices.iter_mut().zip(s) {
            let next = &mut next[*place as usize];
            *place = *next;
            *next += 1;
            sorted[*place as usize] = *s;
        }
        let (mut all, mut from) = (ColumnAccuracy::NONE, 0);
        for to in next.into_iter().map(|next| next as usize) {
            if to > from {
                let filled = self.run(level, (&sorted[from..to], column), &mut values[from..to]);
                let place = |index: usize| {
                    let wanted = (from + index) as u32;
                    indices.iter().position(|place| *place == wanted).unwrap_or(0)
                };
                all = all.and(filled.map_err(|(index, error)| (place(index), error))?);
            }
            from = to;
        }
        for (out, place) in out.iter_mut().zip(indices.iter()) {
            *out = values[*place as usize];
        }
        Ok(all)
    }

    /// Values in the same segment, or in none.
    fn run(
        &self,
        level: Level,
        (s, column): (&[f64], Column),
        out: &mut [f64],
    ) -> Result<ColumnAccuracy, (usize, QuadratureError)> {
        let segment = self.segment(Place::at(s[0] + column.shift)).map_err(|error| (0, error))?;
        if let Some(segment) = segment {
            return Ok(dispatch!(level, simd => segment.fill(simd, s, column, out)));
        }
        let mut all = ColumnAccuracy::NONE;
        for (k, (s, out)) in s.iter().zip(out).enumerate() {
            let seen = s + column.shift;
            let moments = self.at(seen).map_err(|error| (k, error))?;
            let (number, accuracy) = column.number(seen, &moments);
            *out = number;
            all = all.and(accuracy);
        }
        Ok(all)
    }
}

impl Column {
    /// One number out of an integral at `seen` = s + shift.
    fn number(&self, seen: f64, moments: &Moments) -> (f64, ColumnAccuracy) {
        let [value, size] = match self.slope {
            true => [moments.slope, moments.sizes[1]],
            false => [moments.value, moments.sizes[0]],
        };
        let number = value * self.factor * moments.ln_scale.exp();
        let condition = if value >= size { 1.0 } else { size / value.abs() };
        let steepness = moments.sizes[1] / moments.sizes[0];
        let error = (moments.error + self.rounding(seen.abs(), steepness)) * condition
            + (0.5 * moments.ln_scale.abs() + ROUNDED) * f64::EPSILON;
        let normal = moments.ln_scale > LEAST && number.is_normal();
        (number, ColumnAccuracy { error, condition, normal, lowest: seen })
    }

    /// The relative error by the rounding of s + shift up to `largest` where the ratio of slope to
    /// value is at most `steepness`; the slope's own is one more power of s.
    pub(crate) fn rounding(&self, largest: f64, steepness: f64) -> f64 {
        if self.shift == 0.0 || steepness.is_nan() {
            return 0.0;
        }
        f64::EPSILON * (largest + 2.0 * self.shift.abs()) * (steepness + 1.0)
    }
}

/// What batches are sorted in: where each value is, the values of s, and the numbers.
#[derive(Default)]
struct Buffers {
    indices: Vec<u32>,
    sorted: Vec<f64>,
    values: Vec<f64>,
}

/// The product of polynomial, scale and factor, in units of the last place.
pub(crate) const ROUNDED: f64 = 4.0;

/// Finds the segment of each value; returns how often it changes from one to the next.
#[inline(always)]
fn locate_all<S: Simd>(_: S, s: &[f64], shift: f64, indices: &mut [u32]) -> usize {
    for (index, s) in indices.iter_mut().zip(s) {
        *index = locate(s + shift) as u32;
    }
    indices.windows(2).map(|pair| usize::from(pair[0] != pair[1])).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Density;
    use crate::gaussian::shifted::tests::{both_signs, power};

    fn checked(density: &Density, s: &[f64], column: Column, tolerance: f64) -> ColumnAccuracy {
        let integral = ShiftedGaussian::new(density.clone(), 0.3, tolerance);
        let mut out = vec![f64::NAN; s.len()];
        let accuracy = integral.fill(s, column, &mut out).unwrap();
        let mut worst = ColumnAccuracy::NONE;
        for (s, out) in s.iter().zip(out) {
            let seen = s + column.shift;
            let (wanted, one) = column.number(seen, &integral.at(seen).unwrap());
            worst = worst.and(one);
            let off = (out / wanted - 1.0).abs();
            let rounding = (0.5 * seen.max(0.0) * seen + 8.0) * f64::EPSILON * one.condition;
            assert!(off <= rounding || !accuracy.normal, "{s} {column:?}: {out:e} {wanted:e}");
            assert!(one.error <= accuracy.error, "{s} {column:?}: {one:?} {accuracy:?}");
        }
        assert!(!accuracy.normal || accuracy.error <= 3.0 * worst.error, "{accuracy:?} {worst:?}");
        let share = accuracy.condition / worst.condition;
        assert!((share - 1.0).abs() < 1e-9, "{accuracy:?} {worst:?}");
        assert!(accuracy.lowest <= worst.lowest && accuracy.normal <= worst.normal);
        accuracy
    }

    #[test]
    fn columns_hold_the_values_of_one_at_a_time_in_any_order() {
        // Ascending, scrambled, from below the rules, a few only.
        let ordered: Vec<f64> = (0..5000).map(|k| -6.0 + 0.004 * f64::from(k)).collect();
        let scrambled: Vec<f64> = (0..5000).map(|k| ordered[k * 619 % 5000]).collect();
        let deep: Vec<f64> = (0..150).map(|k| -70.0 + 0.7 * f64::from(k * 67 % 150)).collect();
        let few = vec![-1e-300, 0.0, -1.0, 3.0, -64.0];
        for density in [power(1.425), both_signs(1.5), power(20.0)] {
            for s in [&ordered, &scrambled, &deep, &few] {
                for (slope, shift) in [(false, 0.0), (true, 0.0), (false, 0.25), (true, -0.1)] {
                    for tolerance in [1e-4, 1e-13] {
                        checked(&density, s, Column { shift, slope, factor: 3.7 }, tolerance);
                    }
                }
            }
        }
    }

    #[test]
    fn numbers_beyond_the_normal_ones_are_reported() {
        let column = |factor: f64| Column { shift: 0.0, slope: false, factor };
        let normal =
            |s: f64, factor: f64| checked(&power(1.0), &[0.0, s], column(factor), 1e-10).normal;
        assert!(normal(36.0, 1.0) && !normal(37.5, 1e250));
        assert!(!normal(36.0, 1e-300) && !normal(0.0, 1e308 * 9.0) && !normal(1e8, 1.0));
    }

    #[test]
    fn what_is_refused_in_a_column_is_named_by_its_index() {
        let integral = ShiftedGaussian::new(power(1.0), 1.0, 1e-10);
        let column = Column { shift: 0.0, slope: false, factor: 1.0 };
        let mut s: Vec<f64> = (0..3000).map(|k| f64::from(k * 619 % 3000) * 1e-3).collect();
        let mut out = vec![0.0; s.len()];
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2e9] {
            s[2500] = wrong;
            let (index, error) = integral.fill(&s, column, &mut out).unwrap_err();
            assert!(index == 2500 && error.to_string().starts_with(&format!("s is {wrong}")));
        }
    }
}
