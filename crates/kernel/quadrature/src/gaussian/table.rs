//! The integral at one scale as short polynomials on equal steps of s: the fastest way to many
//! values, in any order.

use std::cmp::Ordering;
use std::sync::{LazyLock, OnceLock};

use fearless_simd::{Simd, SimdBase, SimdSplit, f64x4};

use super::column::{ArrayAccuracy, ROUNDED, ScaledIntegral};
use super::moments::Moments;
use crate::chebyshev::polynomial::powers;
use crate::{chebyshev_roots, chebyshev_terms};

/// Steps in a unit of s, each with its polynomial. Ranges of the rules end at multiples of 1/2, so
/// that each step lies in one range.
pub(crate) const STEPS: usize = 32;
/// The table extends from minus this to this s.
const REACH: f64 = 16.0;
/// Units of s in the table.
const UNITS: usize = 2 * REACH as usize;
/// Coefficients of a polynomial: they fill one line of the cache.
const TERMS: usize = 8;
/// Samples of a polynomial: the two terms that it does not keep bound its truncation.
const POINTS: usize = TERMS + 2;
/// Adding 1.5 · 2⁵² rounds to a whole number, in the lowest bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// Where the condition varies more on a step, none stands for all.
pub(crate) const VARIED: f64 = 1.5;

/// The coefficients of a polynomial of x from -1/2 to 1/2, those of the powers 0, 4, 2, 6, 1, 5, 3
/// and 7: they are evaluated side by side.
pub(crate) type Step = [f64; TERMS];

/// The value or the slope on one unit of s.
#[derive(Debug)]
pub(crate) struct Unit {
    /// NaN where values are better computed one by one.
    steps: [Step; STEPS],
    accuracies: [StepAccuracy; STEPS],
}

/// What holds for all numbers of a step.
#[derive(Debug, Clone, Copy)]
struct StepAccuracy {
    error: f64,
    condition: f64,
    /// The largest ratio of the slope to the value, as sizes.
    steepness: f64,
}

impl Unit {
    const NONE: Self = Self {
        steps: [[f64::NAN; TERMS]; STEPS],
        accuracies: [StepAccuracy { error: 0.0, condition: 1.0, steepness: 0.0 }; STEPS],
    };
}

/// A unit that has not been made.
pub(crate) static NOT_MADE: Unit = Unit::NONE;

/// The integral and its slope at s; none where it is refused.
type Integral<'i> = dyn Fn(f64) -> Option<Moments> + 'i;

/// The units of values and of slopes, made when they are first needed.
#[derive(Debug)]
pub(crate) struct StepTable([[OnceLock<Box<Unit>>; UNITS]; 2]);

impl Default for StepTable {
    fn default() -> Self {
        Self([const { [const { OnceLock::new() }; UNITS] }; 2])
    }
}

/// The index of the step of each s + shift, and where on it from -1/2 to 1/2 that is.
#[inline(always)]
pub(crate) fn locate<S: Simd>(_: S, s: &[f64], shift: f64, steps: &mut [u32], x: &mut [f64]) {
    for ((s, step), x) in s.iter().zip(steps).zip(x) {
        let seen = s + shift;
        let scaled = seen * STEPS as f64;
        let whole = (scaled - 0.5) + WHOLE;
        *x = scaled - ((whole - WHOLE) + 0.5);
        let index = (whole.to_bits() as u32).wrapping_add(REACH as u32 * STEPS as u32);
        *step = if seen.abs() < REACH { index } else { NOWHERE };
    }
}

/// The index where there is no step.
const NOWHERE: u32 = (UNITS * STEPS) as u32;
/// Indices of units: a power of two, so that none is beyond them.
pub(crate) const INDICES: usize = 64;

#[inline(always)]
pub(crate) fn unit(step: u32) -> usize {
    step as usize / STEPS % INDICES
}

impl Unit {
    /// The polynomial of a step at x.
    #[inline(always)]
    pub(crate) fn at<S: Simd>(&self, simd: S, step: u32, x: f64) -> f64 {
        let (even, odd) = self.steps[step as usize % STEPS].split_at(TERMS / 2);
        let fours = f64x4::from_slice(simd, even) + f64x4::from_slice(simd, odd) * x;
        let square = x * x;
        let (low, high) = fours.split();
        let [low, high]: [f64; 2] = (low + high * square).into();
        low + high * (square * square)
    }

    /// Bounds for the steps of this unit that have been `used`, with the rounding of s + shift.
    pub(crate) fn accuracy(
        &self,
        unit: usize,
        used: &[bool],
        column: ScaledIntegral,
    ) -> ArrayAccuracy {
        let mut all = ArrayAccuracy::NONE;
        for (k, known) in self.accuracies.iter().enumerate().filter(|(k, _)| used[*k]) {
            let seen = centre(unit * STEPS + k);
            let rounding = column.rounding(seen.abs() + 1.0, known.steepness);
            let error = known.error + rounding * known.condition;
            let lowest = seen - 0.5 / STEPS as f64;
            all =
                all.and(ArrayAccuracy { error, condition: known.condition, normal: true, lowest });
        }
        all
    }
}

impl StepTable {
    /// A unit of values or slopes, made if need be; none outside of the table.
    pub(crate) fn unit(&self, unit: usize, slope: bool, integral: &Integral<'_>) -> Option<&Unit> {
        let cell = self.0[usize::from(slope)].get(unit)?;
        Some(cell.get_or_init(|| Box::new(Unit::new(unit, slope, integral))))
    }
}

/// The s in the middle of a step.
fn centre(step: usize) -> f64 {
    (step as f64 + 0.5) / STEPS as f64 - REACH
}

impl Unit {
    fn new(unit: usize, slope: bool, integral: &Integral<'_>) -> Self {
        let mut made = Self::NONE;
        let known = made.steps.iter_mut().zip(&mut made.accuracies).enumerate();
        for (k, (step, accuracy)) in known {
            if let Some(found) = through(centre(unit * STEPS + k), slope, integral) {
                (*step, *accuracy) = found;
            }
        }
        made
    }
}

/// Samples on a step, and what makes polynomials of them.
struct Sampling {
    /// Inside of -1 to 1.
    points: [f64; POINTS],
    /// The rows that turn samples there into Chebyshev's terms.
    terms: [[f64; POINTS]; POINTS],
    /// Chebyshev's polynomials of 2x as powers of x.
    powers: [Step; TERMS],
}

static SAMPLING: LazyLock<Sampling> = LazyLock::new(|| {
    let mut points = [0.0; POINTS];
    points.iter_mut().zip(chebyshev_roots(POINTS)).for_each(|(point, root)| *point = root);
    let mut terms = [[0.0; POINTS]; POINTS];
    for k in 0..POINTS {
        let column = chebyshev_terms(&unit_vector::<POINTS>(k));
        terms.iter_mut().zip(column).for_each(|(row, term)| row[k] = term);
    }
    let powers = std::array::from_fn(|k| {
        let powers = powers(&unit_vector::<TERMS>(k));
        std::array::from_fn(|i| powers[i] * f64::from(1u32 << i))
    });
    Sampling { points, terms, powers }
});

fn unit_vector<const N: usize>(k: usize) -> [f64; N] {
    std::array::from_fn(|i| f64::from(u8::from(i == k)))
}

/// The polynomial of the step around `centre`, if it is as good as its samples, which are normal
/// numbers of one sign.
fn through(centre: f64, slope: bool, integral: &Integral<'_>) -> Option<(Step, StepAccuracy)> {
    let Sampling { points, terms, powers } = &*SAMPLING;
    let column = ScaledIntegral { shift: 0.0, slope, factor: 1.0 };
    let mut samples = [0.0; POINTS];
    let mut known = StepAccuracy { error: 0.0, condition: 1.0, steepness: 0.0 };
    let (mut least, mut mildest) = (f64::INFINITY, f64::INFINITY);
    for (sample, point) in samples.iter_mut().zip(points) {
        let s = centre + 0.5 * point / STEPS as f64;
        let moments = integral(s)?;
        let (number, accuracy) = column.number(s, &moments);
        if !accuracy.normal {
            return None;
        }
        *sample = number;
        known.error = known.error.max(accuracy.error);
        known.condition = known.condition.max(accuracy.condition);
        known.steepness = known.steepness.max(moments.sizes[1] / moments.sizes[0]);
        least = least.min(number.abs());
        mildest = mildest.min(accuracy.condition);
    }
    let term = |row: &[f64; POINTS]| -> f64 { row.iter().zip(&samples).map(|(r, f)| r * f).sum() };
    let truncation = terms[TERMS..].iter().map(|row| term(row).abs()).sum::<f64>() / least;
    let one_sign = samples.iter().all(|sample| sample * samples[0] > 0.0);
    if !one_sign
        || known.condition > VARIED * mildest
        || truncation.partial_cmp(&known.error) != Some(Ordering::Less)
    {
        return None;
    }
    let mut step = [0.0; TERMS];
    for (row, powers) in terms.iter().zip(powers) {
        let term = term(row);
        step.iter_mut().zip(powers).for_each(|(sum, power)| *sum += term * power);
    }
    // The rounding of each sample may add up to twice its own in between.
    let rounding = 2.0 * (0.5 * centre.max(0.0) * centre + ROUNDED) * f64::EPSILON;
    // Samples stand within the step: its ends may cancel a little more.
    let ends = 1.0 + 0.02 * (known.condition / mildest - 1.0);
    known.condition *= ends;
    known.error = known.error * ends + truncation + rounding;
    Some(([0, 4, 2, 6, 1, 5, 3, 7].map(|k| step[k]), known))
}
