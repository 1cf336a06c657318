//! One Gauss rule that serves a short range of s, and of scales.

use crate::compress::Recurrence;
use crate::exponentials;
use crate::terms::{Exponent, Four, LANES, Place, Sums};
use crate::{Density, Discretised, Goal, QuadratureError, discretise};

/// exp(-L) of the largest weight is left out beyond the window: 1e-20.
pub(crate) const CUT: f64 = 46.0;
/// A density that grows by more than some 1e4 from where it counts to the end of the window needs
/// a wider one: up to this many times the exponent, where weights end to be numbers.
const WIDEST: f64 = 14.0;
/// The share of the window at its ends where little may be left,
const STRIP: f64 = 0.03;
/// and how little, at the least.
const LEFT: f64 = 2e-16;
/// Node counts that are tried, cheapest first. Multiples of four, for vector registers.
const LADDER: [usize; 6] = [4, 8, 12, 16, 20, 24];
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

/// The window of t that carries the integral for s in [low, high], at weights down to exp(-depth).
pub(crate) fn window((low, high): (f64, f64), depth: f64) -> (f64, f64) {
    ((-high - (2.0 * depth).sqrt()).max(0.0), cut(low, depth))
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

/// exp(-(s t + t²/2)) or, for s < 0, exp(-(s + t)²/2), over √(2π): never overflows.
pub(crate) fn weight(s: f64, t: f64) -> f64 {
    let exponent = if s >= 0.0 { t * (s + 0.5 * t) } else { 0.5 * (s + t) * (s + t) };
    (-exponent).exp() * INV_SQRT_2PI
}

/// Point masses on a window of `depth` that is wide enough for the density, their error with what
/// is left out beyond it.
pub(crate) fn masses(
    density: &Density,
    scale: f64,
    (s, window): (f64, &dyn Fn(f64) -> (f64, f64)),
    weight: &dyn Fn(f64) -> f64,
    goal: Goal,
) -> Result<Discretised, QuadratureError> {
    let (mut depth, mut evaluations) = (CUT, 0);
    loop {
        let (near, far) = window(depth);
        let mut found = masses_on(density, scale, (s, (near, far)), weight, goal)?;
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

/// The density times a weight of t as point masses in t. Panels suit φ(s + t) on the window.
fn masses_on(
    density: &Density,
    scale: f64,
    (s, window): (f64, (f64, f64)),
    weight: &dyn Fn(f64) -> f64,
    goal: Goal,
) -> Result<Discretised, QuadratureError> {
    let edges: Vec<f64> = edges(s, window).iter().map(|t| t / scale).collect();
    let range = (window.0 / scale, window.1 / scale);
    let mut masses = discretise(density, range, &edges, &|x| weight(x * scale) * scale, goal)?;
    masses.points.iter_mut().for_each(|x| *x *= scale);
    Ok(masses)
}

/// Where an integral is asked for, seen from where its masses were made.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Shift {
    /// s at which the masses were made,
    pub(crate) from: f64,
    /// and s at which the integral is asked for; not of opposite sign.
    pub(crate) s: f64,
    /// c/c₀ - 1: by how much the scale is larger than that of the masses.
    pub(crate) stretch: f64,
}

impl Shift {
    /// What turns the weight of a mass at t into that of t (1 + stretch) at s: both exponents'
    /// difference as a product, so that nothing large is subtracted.
    #[inline]
    pub(crate) fn exponent(&self) -> Exponent {
        let Self { from, s, stretch } = *self;
        if s < 0.0 {
            let half = 1.0 + 0.5 * stretch;
            Exponent { lead: stretch, offset: s - from, half, rate: 0.5 * (s + from) }
        } else {
            let half = stretch * (1.0 + 0.5 * stretch);
            Exponent { lead: 1.0, offset: 0.0, half, rate: (s - from) + s * stretch }
        }
    }

    #[inline]
    pub(crate) fn place(&self) -> Place {
        Place { s: self.s, ratio: 1.0 + self.stretch }
    }
}

/// Sums over point masses.
pub(crate) fn sums(points: &[f64], masses: &[f64], shift: Shift) -> Sums {
    let (exponent, place) = (shift.exponent(), shift.place());
    let mut sums = Sums::default();
    for (t, mass) in points.iter().zip(masses) {
        sums.add(mass * exponent.at(*t).exp(), place.s + place.ratio * t);
    }
    sums
}

/// A rule for s in a range that does not straddle 0, and for scales near one.
#[derive(Debug)]
pub(crate) struct Segment {
    centre: f64,
    /// Nodes and weights in fours, filled up with weights of 0; weights of one sign first.
    fours: Vec<Four>,
    /// Whether all weights are positive: the value then is its own size.
    positive: bool,
    /// Errors of Σ e zᵏ, k = 0 and 1, and k = 2, relative to their sizes, measured in the corners
    /// of the range against the point masses.
    pub(crate) error: [f64; 2],
    pub(crate) evaluations: usize,
}

/// The s and the stretches of the scale a rule is for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch {
    pub(crate) s: (f64, f64),
    pub(crate) stretch: (f64, f64),
}

impl Patch {
    /// Corners, just inside, so that none changes the sign convention at 0.
    fn corners(&self) -> Vec<(f64, f64)> {
        let (low, high) = self.s;
        let s = [low + 1e-9 * (high - low), high - 1e-9 * (high - low)];
        let (shrunk, stretched) = self.stretch;
        let mut corners = s.map(|s| (s, shrunk)).to_vec();
        if stretched > shrunk {
            corners.extend(s.map(|s| (s, stretched)));
        }
        corners
    }

    /// The window of t, at the scale of the masses, that carries all integrals of the patch.
    fn window(&self, depth: f64) -> (f64, f64) {
        let (near, far) = window(self.s, depth);
        (near / (1.0 + self.stretch.1), far / (1.0 + self.stretch.0))
    }
}

impl Segment {
    pub(crate) fn new(
        density: &Density,
        scale: f64,
        patch: Patch,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let centre = 0.5 * (patch.s.0 + patch.s.1);
        let corners = patch.corners();
        // Resolved where any corner has weight, not only where the centre has.
        let envelope = |t: f64| corners.iter().map(|(s, c)| weight(*s, t * (1.0 + c))).sum();
        let aim = 1e-15_f64.max(0.01 * tolerance);
        let goal = Goal { aim, refuse: (0.2 * tolerance).max(4.0 * aim) };
        let fine = masses(density, scale, (centre, &|depth| patch.window(depth)), &envelope, goal)?;
        let Discretised { points, mut masses, error, evaluations } = fine;
        let mut segment =
            Self { centre, fours: vec![], positive: true, error: [0.0; 2], evaluations };
        let total: f64 = masses.iter().map(|m| m.abs()).sum();
        for (mass, t) in masses.iter_mut().zip(&points) {
            *mass *= weight(centre, *t) / envelope(*t);
        }
        if points.is_empty() {
            return Ok(segment);
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| of_sign(&points, &masses, sign));
        segment.positive = minus.is_none();
        let shift = |(s, stretch)| Shift { from: centre, s, stretch };
        let corners: Vec<_> = corners.iter().copied().map(shift).collect();
        let exact: Vec<_> = corners.iter().map(|&c| sums(&points, &masses, c)).collect();
        // What no number of nodes mends: the masses' own error, and the density's.
        let x: Vec<f64> = points.iter().map(|t| t / scale).collect();
        let known = error / total + ROUNDING + density.relative_error(&x);
        for n in LADDER {
            segment.fours.clear();
            for (recurrence, sign) in [(&plus, 1.0), (&minus, -1.0)] {
                let Some(recurrence) = recurrence else { continue };
                let rule = recurrence.rule(n);
                for (t, w) in rule.nodes.chunks(LANES).zip(rule.weights.chunks(LANES)) {
                    let (mut nodes, mut weights) = ([0.0; LANES], [0.0; LANES]);
                    nodes[..t.len()].copy_from_slice(t);
                    weights[..w.len()].copy_from_slice(w);
                    segment.fours.push((nodes, weights.map(|w| sign * w)));
                }
            }
            let mut measured = [0.0f64; 3];
            for (corner, exact) in corners.iter().zip(&exact) {
                let sums = exponentials::sums(&segment.fours, &corner.exponent(), corner.place());
                for (k, measured) in measured.iter_mut().enumerate() {
                    let error = (sums.power[k] - exact.power[k]) / exact.size[k];
                    *measured = measured.max(error.abs());
                }
            }
            let measured = [measured[0].max(measured[1]), measured[2]].map(|m| 2.0 * m);
            segment.error = measured.map(|m| m + known);
            // A quarter is left even where the density itself is known no better than asked.
            if measured[0] < (0.5 * tolerance - known).max(0.25 * tolerance).max(ROUNDING) {
                break;
            }
        }
        Ok(segment)
    }

    pub(crate) fn nodes(&self) -> usize {
        LANES * self.fours.len()
    }

    #[inline]
    fn shift(&self, s: f64, stretch: f64) -> Shift {
        Shift { from: self.centre, s, stretch }
    }

    /// Value, slope and curvature.
    pub(crate) fn sums(&self, s: f64, stretch: f64) -> Sums {
        let shift = self.shift(s, stretch);
        exponentials::sums(&self.fours, &shift.exponent(), shift.place())
    }

    /// The value and its size alone: half the work of all sums.
    #[inline]
    pub(crate) fn value(&self, s: f64, stretch: f64) -> (f64, f64) {
        let exponent = self.shift(s, stretch).exponent();
        if self.positive {
            let value = exponentials::positive(&self.fours, &exponent);
            return (value, value);
        }
        exponentials::signed(&self.fours, &exponent)
    }
}

/// The orthogonal polynomials of the masses of one sign: a Gauss rule wants them positive.
fn of_sign(points: &[f64], masses: &[f64], sign: f64) -> Option<Recurrence> {
    let (points, masses): (Vec<f64>, Vec<f64>) =
        points.iter().zip(masses).map(|(x, m)| (*x, sign * m)).filter(|(_, m)| *m > 0.0).unzip();
    let largest = LADDER[LADDER.len() - 1];
    (!points.is_empty()).then(|| Recurrence::new(&points, &masses, largest))
}
