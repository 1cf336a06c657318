//! One integral at many s, as plain numbers.

use fearless_simd::{Level, Simd, dispatch};

use super::column::{ArrayAccuracy, ScaledIntegral};
use super::shifted::ShiftedGaussian;
use super::table::{INDICES, NOT_MADE, STEPS, Unit, locate, unit};
use crate::QuadratureError;

/// Values that are found together: they stay in the fastest memory.
const BLOCK: usize = 512;

impl ShiftedGaussian {
    /// Fills `out`, as long as `s`, with a column. Numbers are those of [`value`](Self::value) and
    /// [`at`](Self::at) within both bounds, the same on every processor and in any order.
    ///
    /// # Errors
    /// One s that is refused, by its index, and the reason; `out` then holds nothing of use.
    pub fn fill(
        &self,
        s: &[f64],
        column: ScaledIntegral,
        out: &mut [f64],
    ) -> Result<ArrayAccuracy, (usize, QuadratureError)> {
        let mut all = ArrayAccuracy::NONE;
        let mut units = UsedUnits::NONE;
        let (mut steps, mut x) = ([0; BLOCK], [0.0; BLOCK]);
        let level = Level::new();
        let blocks = s.chunks(BLOCK).zip(out.chunks_mut(BLOCK));
        for (k, (s, out)) in blocks.enumerate() {
            let (steps, x) = (&mut steps[..s.len()], &mut x[..s.len()]);
            dispatch!(level, simd => locate(simd, s, column.shift, steps, x));
            if !dispatch!(level, simd => units.serve(simd, steps)) {
                units.make(steps, self, column);
            }
            if !dispatch!(level, simd => units.fill(simd, steps, x, column, out)) {
                let left = self.one_by_one(s, column, out);
                all = all.and(left.map_err(|(index, error)| (k * BLOCK + index, error))?);
            }
        }
        Ok(all.and(units.accuracy(column)))
    }

    /// The numbers where there is no normal one yet.
    fn one_by_one(
        &self,
        s: &[f64],
        column: ScaledIntegral,
        out: &mut [f64],
    ) -> Result<ArrayAccuracy, (usize, QuadratureError)> {
        let mut all = ArrayAccuracy::NONE;
        for (k, (s, out)) in s.iter().zip(out).enumerate().filter(|(_, (_, out))| !out.is_normal())
        {
            let seen = s + column.shift;
            let moments = self.at(seen).map_err(|error| (k, error))?;
            let (number, accuracy) = column.number(seen, &moments);
            *out = number;
            all = all.and(accuracy);
        }
        Ok(all)
    }
}

/// The units of a table that have been needed so far, and the steps.
struct UsedUnits<'t> {
    units: [&'t Unit; INDICES],
    used: [[bool; STEPS]; INDICES],
}

impl<'t> UsedUnits<'t> {
    const NONE: Self = Self { units: [&NOT_MADE; INDICES], used: [[false; STEPS]; INDICES] };

    /// The numbers of a column; whether all are normal.
    #[inline(always)]
    fn fill<S: Simd>(
        &mut self,
        simd: S,
        steps: &[u32],
        x: &[f64],
        column: ScaledIntegral,
        out: &mut [f64],
    ) -> bool {
        for ((out, step), x) in out.iter_mut().zip(steps).zip(x) {
            let index = unit(*step);
            self.used[index][*step as usize % STEPS] = true;
            *out = self.units[index].at(simd, *step, *x) * column.factor;
        }
        let normal = |out: f64| out.abs() >= f64::MIN_POSITIVE && out.abs() <= f64::MAX;
        out.iter().fold(true, |all, out| all & normal(*out))
    }

    /// Whether all units from the lowest to the highest of these steps have been made.
    #[inline(always)]
    fn serve<S: Simd>(&self, _: S, steps: &[u32]) -> bool {
        let low = steps.iter().fold(u32::MAX, |low, step| low.min(*step));
        let high = steps.iter().fold(0, |high, step| high.max(*step));
        (unit(low)..=unit(high)).all(|index| !std::ptr::eq(self.units[index], &NOT_MADE))
    }

    /// Makes the units of these steps.
    #[cold]
    fn make(&mut self, steps: &[u32], integral: &'t ShiftedGaussian, column: ScaledIntegral) {
        for index in steps.iter().map(|step| unit(*step)) {
            if std::ptr::eq(self.units[index], &NOT_MADE)
                && let Some(made) =
                    integral.table().unit(index, column.slope, &|s| integral.at(s).ok())
            {
                self.units[index] = made;
            }
        }
    }

    /// Bounds for all steps that have been used.
    fn accuracy(&self, column: ScaledIntegral) -> ArrayAccuracy {
        let units = self.units.iter().zip(&self.used).enumerate();
        let made = units.filter(|(_, (unit, _))| !std::ptr::eq(**unit, &NOT_MADE));
        made.fold(ArrayAccuracy::NONE, |all, (index, (unit, used))| {
            all.and(unit.accuracy(index, used, column))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Density;
    use crate::gaussian::shifted::tests::{both_signs, power};
    use crate::gaussian::table::VARIED;

    fn checked(
        density: &Density,
        s: &[f64],
        column: ScaledIntegral,
        tolerance: f64,
    ) -> ArrayAccuracy {
        let integral = ShiftedGaussian::new(density.clone(), 0.3, tolerance);
        let mut out = vec![f64::NAN; s.len()];
        let accuracy = integral.fill(s, column, &mut out).unwrap();
        let mut worst = ArrayAccuracy::NONE;
        for (s, out) in s.iter().zip(out) {
            let seen = s + column.shift;
            let (wanted, one) = column.number(seen, &integral.at(seen).unwrap());
            worst = worst.and(one);
            let off = (out / wanted - 1.0).abs();
            // Of samples and of the polynomial through them, which adds up to twice as much.
            let rounding = (1.5 * seen.max(0.0) * seen + 24.0) * f64::EPSILON * one.condition;
            // The term of exp(-s x) that a step leaves out first.
            let left = 4.0 * ((seen.max(0.0) + 2.0) / 128.0).powi(8) / 40_320.0;
            // A rounded s may belong to either of two rules.
            let seam = (2.0 * seen - (2.0 * seen).round()).abs() < 1e-12;
            let rules = if seam { one.error + accuracy.error } else { 0.0 };
            let allowed = rounding + left + rules;
            assert!(off <= allowed || !accuracy.normal, "{s} {column:?}: {out:e} {wanted:e}");
            assert!(seam || one.error <= accuracy.error, "{s} {column:?}: {one:?} {accuracy:?}");
        }
        assert!(!accuracy.normal || accuracy.error <= 3.0 * worst.error, "{accuracy:?} {worst:?}");
        let share = accuracy.condition / worst.condition;
        // The bound of the whole step where the worst value is.
        assert!((1.0..VARIED).contains(&share), "{accuracy:?} {worst:?}");
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
                        checked(
                            &density,
                            s,
                            ScaledIntegral { shift, slope, factor: 3.7 },
                            tolerance,
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn numbers_beyond_the_normal_ones_are_reported() {
        let column = |factor: f64| ScaledIntegral { shift: 0.0, slope: false, factor };
        let normal =
            |s: f64, factor: f64| checked(&power(1.0), &[0.0, s], column(factor), 1e-10).normal;
        assert!(normal(36.0, 1.0) && !normal(37.5, 1e250));
        assert!(!normal(36.0, 1e-300) && !normal(0.0, 1e308 * 9.0) && !normal(1e8, 1.0));
    }

    #[test]
    fn what_is_refused_in_a_column_is_named_by_its_index() {
        let integral = ShiftedGaussian::new(power(1.0), 1.0, 1e-10);
        let column = ScaledIntegral { shift: 0.0, slope: false, factor: 1.0 };
        let mut s: Vec<f64> = (0..3000).map(|k| f64::from(k * 619 % 3000) * 1e-3).collect();
        let mut out = vec![0.0; s.len()];
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2e9] {
            s[2500] = wrong;
            let (index, error) = integral.fill(&s, column, &mut out).unwrap_err();
            assert!(index == 2500 && error.to_string().starts_with(&format!("s is {wrong}")));
        }
    }
}
