//! Values of one segment side by side, as many as the widest registers hold.

use fearless_simd::{Simd, SimdBase, f64x8};

use super::column::{Column, ColumnAccuracy, ROUNDED};
use super::exponential::{LEAST, exp};
use super::segment::Segment;

/// Values side by side: the widest register, four of the narrowest.
const LANES: usize = 8;

impl Segment {
    #[inline(always)]
    pub(crate) fn fill<S: Simd>(
        &self,
        simd: S,
        s: &[f64],
        column: Column,
        out: &mut [f64],
    ) -> ColumnAccuracy {
        let splat = |value: f64| f64x8::splat(simd, value);
        let mut seen = Extremes {
            exponent: splat(0.0),
            smallest: splat(f64::INFINITY),
            largest: splat(0.0),
            condition: splat(1.0),
        };
        let whole = s.len() / LANES * LANES;
        let (blocks, rest) = s.split_at(whole);
        let (filled, left) = out.split_at_mut(whole);
        for (s, out) in blocks.chunks_exact(LANES).zip(filled.chunks_exact_mut(LANES)) {
            let found = self.eight(simd, f64x8::from_slice(simd, s), column, &mut seen);
            found.store_slice(out);
        }
        if let Some(last) = rest.last() {
            let mut lanes = [*last; LANES];
            lanes[..rest.len()].copy_from_slice(rest);
            let found = self.eight(simd, f64x8::from_slice(simd, &lanes), column, &mut seen);
            found.store_slice(&mut lanes);
            left.copy_from_slice(&lanes[..rest.len()]);
        }
        self.accuracy(
            column,
            [seen.exponent.reduce_min(), seen.smallest.reduce_min()],
            [seen.largest.reduce_max(), seen.condition.reduce_max()],
        )
    }

    #[inline(always)]
    fn eight<S: Simd>(
        &self,
        simd: S,
        s: f64x8<S>,
        column: Column,
        seen: &mut Extremes<S>,
    ) -> f64x8<S> {
        let k = usize::from(column.slope);
        let s = s + column.shift;
        let (x, u) = self.patch.eight(s);
        let sum = self.power[k].eight(simd, u);
        let mut out = sum * column.factor;
        if self.tilt.is_some() || !self.patch.negative() {
            let above = s.max(f64x8::splat(simd, 0.0));
            let scale = above * -0.5 * above;
            let exponent = self.tilt.map_or(scale, |tilt| scale - tilt.eight(x));
            out *= exp(simd, exponent);
            seen.exponent = seen.exponent.min(exponent);
        }
        let size = out.abs();
        (seen.smallest, seen.largest) = (seen.smallest.min(size), seen.largest.max(size));
        let sizes = self.size.as_ref().unwrap_or(&self.power);
        let integral = match self.growth {
            Some(growth) if column.slope => Some(sizes[0].eight(simd, u) * growth[0]),
            _ if self.size.is_some() => Some(sizes[k].eight(simd, u)),
            _ => None,
        };
        if let Some(integral) = integral {
            seen.condition = seen.condition.max(integral / sum.abs());
        }
        out
    }

    /// From the least exponent and size, and from the largest size and condition.
    fn accuracy(
        &self,
        column: Column,
        [exponent, smallest]: [f64; 2],
        [largest, condition]: [f64; 2],
    ) -> ColumnAccuracy {
        let (lowest, highest) = self.patch.keys();
        // Of the square of s, and of its sum with the tilt.
        let share = if self.tilt.is_some() { 1.0 } else { 0.5 };
        let rounding = column.rounding(lowest.abs().max(highest.abs()), self.steepness);
        let error = (self.error[0] + rounding) * condition
            + (share * exponent.abs() + ROUNDED) * f64::EPSILON;
        let normal = exponent > LEAST && smallest >= f64::MIN_POSITIVE && largest <= f64::MAX;
        ColumnAccuracy { error, condition, normal, lowest }
    }
}

/// Extremes of each lane.
struct Extremes<S: Simd> {
    exponent: f64x8<S>,
    smallest: f64x8<S>,
    largest: f64x8<S>,
    condition: f64x8<S>,
}
