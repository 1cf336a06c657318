//! The shifted Gaussian as a weight, and a density under it as point masses.

use crate::{Density, Goal, PointMasses, QuadratureError, discretise};

/// Below this s each evaluation integrates anew: rules would be needed for every unit of s.
pub(crate) const LOWEST: f64 = -64.0;
/// Beyond this s the window is so short that only the first power of the density counts, and
/// s² no longer fits a multiple of the height's rounding; nothing physical lies there.
pub(crate) const HIGHEST: f64 = 1e9;
/// exp(-L) of the largest weight is left out beyond the window: 1e-20.
pub(crate) const CUT: f64 = 46.0;
/// A density that grows by more than some 1e4 from where it counts to the end of the window needs
/// a wider one: up to this many times the exponent, where weights end to be numbers.
const WIDEST: f64 = 14.0;
/// exp(-this) is too small for a number.
pub(crate) const DEEPEST: f64 = 740.0;
/// The share of the window at its ends where little may be left,
const STRIP: f64 = 0.03;
/// and how little, at the least.
const LEFT: f64 = 2e-16;
/// Rounding of the sums themselves, measured against 40-digit references.
pub(crate) const ROUNDING: f64 = 5e-15;
pub(crate) const INV_SQRT_2PI: f64 = 0.398_942_280_401_432_7;

/// Where exp(-(s t + t²/2)) falls to 1e-20 of its largest value on t ≥ 0: no rule looks beyond.
#[must_use]
pub fn reach(s: f64) -> f64 {
    cut(s, CUT)
}

/// Where exp(-(s t + t²/2)) falls to exp(-`depth`) of its largest value on t ≥ 0.
fn cut(s: f64, depth: f64) -> f64 {
    if s >= 0.0 {
        // Not √(s²+2L) - s, which cancels for large s.
        2.0 * depth / (s + (s * s + 2.0 * depth).sqrt())
    } else {
        (2.0 * depth).sqrt() - s
    }
}

/// Panel ends that suit the shifted Gaussian on a window.
pub(crate) fn edges(s: f64, (low, high): (f64, f64)) -> Vec<f64> {
    if s >= 0.0 {
        [0.1, 0.25, 0.45, 0.7].iter().map(|share| share * high).collect()
    } else {
        let count = ((high - low) / 2.0).ceil();
        let mut ends: Vec<f64> =
            (1..count as usize).map(|k| low + (high - low) * k as f64 / count).collect();
        if low <= 0.0 {
            ends.insert(0, ends.first().map_or(high, |e| e / 3.0));
        }
        ends
    }
}

/// exp(-(s t + t²/2)) or, for s < 0, exp(-(s + t)²/2), over its largest value on t ≥ `from`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weight {
    s: f64,
    /// Where it is largest.
    peak: f64,
    /// Minus the logarithm of what it has been divided by.
    pub(crate) depth: f64,
}

impl Weight {
    pub(crate) fn new(s: f64, from: f64) -> Self {
        let peak = from.max(-s);
        let depth = if s < 0.0 { 0.5 * (s + peak) * (s + peak) } else { peak * (s + 0.5 * peak) };
        Self { s, peak, depth }
    }

    /// Nothing large is subtracted.
    pub(crate) fn at(&self, t: f64) -> f64 {
        (-(t - self.peak) * (self.s + 0.5 * (t + self.peak))).exp()
    }

    /// The window of t with weights down to exp(-`depth`).
    pub(crate) fn window(&self, depth: f64) -> (f64, f64) {
        let depth = self.depth + depth;
        ((-self.s - (2.0 * depth).sqrt()).max(0.0), cut(self.s, depth))
    }

    /// What rounding of t makes of weights: no panel is resolved better.
    pub(crate) fn noise(&self) -> f64 {
        1e-15_f64.max(10.0 * f64::EPSILON * self.depth)
    }
}

/// Point masses on a window of `depth` that is wide enough for the density, their error with what
/// is left out beyond it.
pub(crate) fn masses(
    density: &Density,
    scale: f64,
    (s, window): (f64, &dyn Fn(f64) -> (f64, f64)),
    weight: &dyn Fn(f64) -> f64,
    goal: Goal,
) -> Result<PointMasses, QuadratureError> {
    let (mut depth, mut evaluations) = (CUT, 0);
    loop {
        let (near, far) = window(depth);
        let edges: Vec<f64> = edges(s, (near, far)).iter().map(|t| t / scale).collect();
        let range = (near / scale, far / scale);
        let mut found = discretise(density, range, &edges, &|x| weight(x * scale) * scale, goal)?;
        found.points.iter_mut().for_each(|x| *x *= scale);
        found.evaluations += evaluations;
        let strip = STRIP * (far - near);
        let (mut left, mut total) = (0.0, 0.0);
        for (t, mass) in found.points.iter().zip(&found.masses) {
            total += mass.abs();
            if *t > far - strip || (near > 0.0 && *t < near + strip) {
                left += mass.abs();
            }
        }
        if left <= LEFT.max(0.01 * goal.aim) * total {
            return Ok(found);
        }
        if depth >= WIDEST * CUT {
            found.error += left;
            return Ok(found);
        }
        (depth, evaluations) = ((2.0 * depth).min(WIDEST * CUT), found.evaluations);
    }
}
