//! One Gauss rule that serves a short range of s.

use crate::compress::Recurrence;
use crate::{Density, Discretised, QuadratureError, discretise};

/// Numbers handled together.
const LANES: usize = 4;
type Lane = [f64; LANES];
/// exp(-L) of the integrand's peak is left out beyond the window: 1e-20.
pub(crate) const CUT: f64 = 46.0;
/// Node counts that are tried, cheapest first. Multiples of four, for vector registers.
const LADDER: [usize; 6] = [4, 8, 12, 16, 20, 24];
/// Rounding of the sums themselves, measured against 40-digit references.
pub(crate) const ROUNDING: f64 = 5e-15;
pub(crate) const INV_SQRT_2PI: f64 = 0.398_942_280_401_432_7;

/// Where exp(-(s t + t²/2)) falls to 1e-20 of its largest value on t ≥ 0: no rule looks beyond.
#[must_use]
pub fn reach(s: f64) -> f64 {
    if s >= 0.0 {
        // Not √(s²+2L) - s, which cancels for large s.
        2.0 * CUT / (s + (s * s + 2.0 * CUT).sqrt())
    } else {
        (2.0 * CUT).sqrt() - s
    }
}

/// The window of t that carries the integral for s in [low, high].
pub(crate) fn window(low: f64, high: f64) -> (f64, f64) {
    ((-high - (2.0 * CUT).sqrt()).max(0.0), reach(low))
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

/// Sums of one evaluation, all times exp(max(s,0)²/2).
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sums {
    pub(crate) value: f64,
    /// -d/ds.
    pub(crate) slope: f64,
    /// Of the absolute values of the terms of `value` and of `slope`.
    pub(crate) sizes: [f64; 2],
}

impl Sums {
    /// Adds a weighted exponential whose point is t = z - s.
    pub(crate) fn add(&mut self, term: f64, z: f64) {
        self.value += term;
        self.slope += term * z;
        self.sizes[0] += term.abs();
        self.sizes[1] += (term * z).abs();
    }

    /// The larger error of value and slope against `exact`, relative to the sizes there.
    pub(crate) fn error(&self, exact: &Self) -> f64 {
        let [value, slope] = exact.sizes;
        ((self.value - exact.value) / value).abs().max(((self.slope - exact.slope) / slope).abs())
    }
}

/// exp(-(s t + t²/2)) or, for s < 0, exp(-(s + t)²/2), over √(2π): never overflows.
pub(crate) fn weight(s: f64, t: f64) -> f64 {
    let exponent = if s >= 0.0 { t * (s + 0.5 * t) } else { 0.5 * (s + t) * (s + t) };
    (-exponent).exp() * INV_SQRT_2PI
}

/// The density times φ(s + t) as point masses in t, for one s.
pub(crate) fn masses(
    density: &Density,
    scale: f64,
    s: f64,
    window: (f64, f64),
    tolerance: f64,
) -> Result<Discretised, QuadratureError> {
    let edges: Vec<f64> = edges(s, window).iter().map(|t| t / scale).collect();
    let range = (window.0 / scale, window.1 / scale);
    let mut masses =
        discretise(density, range, &edges, &|x| weight(s, x * scale) * scale, tolerance)?;
    masses.points.iter_mut().for_each(|x| *x *= scale);
    Ok(masses)
}

/// Sums over point masses whose weight was made at `centre`, evaluated at `s`.
pub(crate) fn sums(nodes: &[f64], weights: &[f64], centre: f64, s: f64) -> Sums {
    let delta = s - centre;
    let shift = if s < 0.0 { 0.5 * (s + centre) } else { 0.0 };
    let mut sums = Sums::default();
    for (t, w) in nodes.iter().zip(weights) {
        sums.add(w * (-delta * (t + shift)).exp(), s + t);
    }
    sums
}

/// A rule for s in [low, high], which does not straddle 0.
#[derive(Debug)]
pub(crate) struct Segment {
    centre: f64,
    /// Nodes and weights in fours, filled up with weights of 0; weights of one sign first.
    lanes: Vec<(Lane, Lane)>,
    /// Whether all weights are positive: the value then is its own size.
    positive: bool,
    /// Error of value and slope relative to their sizes, measured at both ends against the point
    /// masses.
    pub(crate) error: f64,
    pub(crate) evaluations: usize,
}

impl Segment {
    pub(crate) fn new(
        density: &Density,
        scale: f64,
        (low, high): (f64, f64),
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let centre = 0.5 * (low + high);
        let fine =
            masses(density, scale, centre, window(low, high), 1e-15_f64.max(0.01 * tolerance))?;
        let Discretised { points, masses, error, evaluations } = fine;
        let mut segment = Self { centre, lanes: vec![], positive: true, error: 0.0, evaluations };
        let total: f64 = masses.iter().map(|m| m.abs()).sum();
        if points.is_empty() {
            return Ok(segment);
        }
        let [plus, minus] = [1.0, -1.0].map(|sign| of_sign(&points, &masses, sign));
        segment.positive = minus.is_none();
        // Just inside the ends, so that neither changes the sign convention at 0.
        let ends = [low + 1e-9 * (high - low), high - 1e-9 * (high - low)];
        let exact = ends.map(|s| sums(&points, &masses, centre, s));
        // What no number of nodes mends: the masses' own error, and the density's.
        let known = error / total + ROUNDING + density.relative_error();
        for n in LADDER {
            segment.lanes.clear();
            for (recurrence, sign) in [(&plus, 1.0), (&minus, -1.0)] {
                let Some(recurrence) = recurrence else { continue };
                let rule = recurrence.rule(n);
                for (t, w) in rule.nodes.chunks(LANES).zip(rule.weights.chunks(LANES)) {
                    let (mut nodes, mut weights) = ([0.0; LANES], [0.0; LANES]);
                    nodes[..t.len()].copy_from_slice(t);
                    weights[..w.len()].copy_from_slice(w);
                    segment.lanes.push((nodes, weights.map(|w| sign * w)));
                }
            }
            let measured =
                ends.iter().zip(&exact).map(|(s, e)| segment.sums(*s).error(e)).fold(0.0, f64::max);
            segment.error = 2.0 * measured + known;
            if 2.0 * measured < (0.5 * tolerance - known).max(ROUNDING) {
                break;
            }
        }
        Ok(segment)
    }

    pub(crate) fn nodes(&self) -> usize {
        LANES * self.lanes.len()
    }

    /// Weighted exponentials of each four, with the four's nodes.
    #[inline(always)]
    fn terms(&self, s: f64) -> impl Iterator<Item = (Lane, Lane)> {
        let delta = s - self.centre;
        let shift = if s < 0.0 { 0.5 * (s + self.centre) } else { 0.0 };
        self.lanes.iter().map(move |(nodes, weights)| {
            // A branch-free exp of our own, four at a time, was measured no faster without AVX2.
            let mut terms = nodes.map(|t| (-delta * (t + shift)).exp());
            for k in 0..LANES {
                terms[k] *= weights[k];
            }
            (*nodes, terms)
        })
    }

    pub(crate) fn sums(&self, s: f64) -> Sums {
        let mut sums = Sums::default();
        for (nodes, terms) in self.terms(s) {
            for (t, term) in nodes.iter().zip(terms) {
                sums.add(term, s + t);
            }
        }
        sums
    }

    /// The value and its size alone: half the work of all sums.
    #[inline]
    pub(crate) fn value(&self, s: f64) -> (f64, f64) {
        let sum = |lane: Lane| (lane[0] + lane[1]) + (lane[2] + lane[3]);
        let mut value = [0.0; LANES];
        if self.positive {
            for (_, terms) in self.terms(s) {
                for k in 0..LANES {
                    value[k] += terms[k];
                }
            }
            let value = sum(value);
            return (value, value);
        }
        let mut size = [0.0; LANES];
        for (_, terms) in self.terms(s) {
            for k in 0..LANES {
                value[k] += terms[k];
                size[k] += terms[k].abs();
            }
        }
        (sum(value), sum(size))
    }
}

/// The orthogonal polynomials of the masses of one sign: a Gauss rule wants them positive.
fn of_sign(points: &[f64], masses: &[f64], sign: f64) -> Option<Recurrence> {
    let (points, masses): (Vec<f64>, Vec<f64>) =
        points.iter().zip(masses).map(|(x, m)| (*x, sign * m)).filter(|(_, m)| *m > 0.0).unzip();
    let largest = LADDER[LADDER.len() - 1];
    (!points.is_empty()).then(|| Recurrence::new(&points, &masses, largest))
}
