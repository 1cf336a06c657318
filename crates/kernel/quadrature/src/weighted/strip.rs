//! A part of a panel on which the law is smooth but for powers of the distance to one end.

use std::sync::OnceLock;

use super::panel::Panel;
use crate::chebyshev::extent;
use crate::chebyshev::lobatto::{self, NODES, Samples, lobatto};
use crate::discretise::panel::hidden;
use crate::rules::legendre::{INSET, legendre};
use crate::{Density, QuadratureError};

/// Points of the rule on a strip,
const POINTS: usize = 20;
/// and with the two next to its ends, at which laws of unknown form are sampled too.
const ALL: usize = POINTS + 2;
/// The share of a strip from 0 in which a law of unknown form is not sampled.
const NEXT_TO_ZERO: f64 = 1e-25;
/// The rounding of the Legendre series of the derivative of a law of unknown form.
const NOISE: f64 = 1e-11;

/// A density at one separation.
pub(crate) struct View<'a> {
    pub(crate) density: &'a Density,
    /// x = (z - d)/unit.
    pub(crate) d: f64,
    pub(crate) unit: f64,
    pub(crate) ln_scale: f64,
}

/// Places at a distance δ = span·v^power from an origin: powers of the distance become smooth in v.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Map {
    /// The origin in the law's x,
    pub(crate) x: f64,
    /// and in the panel's distances u.
    pub(crate) u: f64,
    /// Direction of δ in x: ±1.
    pub(crate) side: f64,
    pub(crate) span: f64,
    pub(crate) power: f64,
    /// Whether the law is smooth at the origin.
    pub(crate) smooth: bool,
}

impl Map {
    /// v^power, and its derivative.
    #[inline]
    fn share(&self, v: f64) -> (f64, f64) {
        if self.power.total_cmp(&5.0).is_eq() {
            let v4 = (v * v) * (v * v);
            (v * v4, 5.0 * v4)
        } else if self.power.total_cmp(&1.0).is_eq() {
            (v, 1.0)
        } else {
            let share = v.powf(self.power);
            (share, if share > 0.0 { self.power * share / v } else { 0.0 })
        }
    }

    /// v of a distance from the origin.
    pub(crate) fn v(&self, distance: f64) -> f64 {
        (distance / self.span).clamp(0.0, 1.0).powf(1.0 / self.power)
    }
}

/// Value and slope over one strip.
pub(crate) struct Strip<'a> {
    pub(crate) panel: &'a Panel,
    pub(crate) map: Map,
    pub(crate) range: (f64, f64),
    /// Ends in x, which select the active pieces (the points never do).
    pub(crate) ends: (f64, f64),
    /// The law's kinks below and above.
    kinks: (f64, f64),
    pub(crate) depth: u32,
    /// Number of halvings in a row that have not helped.
    pub(crate) stalled: u32,
    /// ∫ q g and ∫ q' g, over z and exp(`ln_scale`); q' is the derivative by z.
    pub(crate) sums: [f64; 2],
    pub(crate) sizes: [f64; 2],
    pub(crate) errors: [f64; 2],
    /// The rounding of the slope, which halving does not reduce.
    pub(crate) floor: f64,
    /// The error, without rounding, of a slope from interpolation in x.
    off: f64,
    /// Whether a sample of the law is not zero.
    pub(crate) nonzero: bool,
}

impl<'a> Strip<'a> {
    pub(crate) fn new(
        panel: &'a Panel,
        map: Map,
        range: (f64, f64),
        ends: (f64, f64),
        kinks: (f64, f64),
    ) -> Self {
        Self {
            panel,
            map,
            range,
            ends,
            kinks,
            depth: 0,
            stalled: 0,
            sums: [0.0; 2],
            sizes: [0.0; 2],
            errors: [0.0; 2],
            floor: 0.0,
            off: 0.0,
            nonzero: false,
        }
    }

    pub(crate) fn halves(&self) -> [Self; 2] {
        let (low, high) = self.range;
        let middle = 0.5 * (low + high);
        [(low, middle), (middle, high)].map(|range| Self {
            depth: self.depth + 1,
            ..Self::new(self.panel, self.map, range, self.ends, self.kinks)
        })
    }

    /// Samples the strip; returns the number of evaluations of the law.
    pub(crate) fn sample(&mut self, view: &View<'_>) -> Result<usize, QuadratureError> {
        let Map { x: x0, u: u0, side, span, .. } = self.map;
        let (low, high) = self.range;
        let width = high - low;
        let interpolation = interpolation();
        let known = view.density.has_slope(self.ends);
        // Some formulas are NaN next to 0, where the integral is negligible.
        let lowest = if known { self.ends.0 } else { self.ends.0.max(NEXT_TO_ZERO * self.ends.1) };
        let (mut x, mut dz, mut mass) = ([0.0; ALL], [0.0; ALL], [0.0; ALL]);
        for (k, place) in interpolation.places.iter().enumerate() {
            // Maps lead up or down, but laws are sampled upwards.
            let v = if side > 0.0 { low + width * place } else { high - width * place };
            let (share, by_v) = self.map.share(v);
            let distance = span * share;
            x[k] = (x0 + side * distance / view.unit).clamp(lowest, self.ends.1);
            dz[k] = span * by_v * width;
            if dz[k] > 0.0 {
                let u = (u0 + side * self.panel.side * distance).max(0.0);
                mass[k] = self.panel.weight(u, view.ln_scale) * dz[k];
            }
        }
        let used = if known { 1..POINTS + 1 } else { 0..ALL };
        let (mut scratch, mut q, mut slope) = ([0.0; ALL], [0.0; ALL], [0.0; ALL]);
        let (x, scratch) = (&x[used.clone()], &mut scratch[used.clone()]);
        let count = view.density.sample(self.ends, x, scratch, &mut q[used.clone()])?;
        if known {
            view.density.slope(self.ends, x, scratch, &mut slope[used]);
            slope.iter_mut().for_each(|slope| *slope /= view.unit);
        } else if self.map.smooth {
            let all: f64 =
                mass[1..].iter().zip(&legendre(POINTS).weights).map(|(m, w)| m * w).sum();
            let (first, last) = (x[0], x[x.len() - 1]);
            let found =
                Slopes::new(view.density, self.ends, (first, last), self.kinks, self.depth)?;
            for (slope, x) in slope.iter_mut().zip(x) {
                *slope = found.at(*x) / view.unit;
            }
            [self.floor, self.off] = [found.noise, found.off].map(|error| error / view.unit * all);
        } else {
            for (k, row) in (1..).zip(&interpolation.derivative) {
                slope[k] = if dz[k] > 0.0 { dot(row, &q) / dz[k] } else { 0.0 };
            }
        }
        self.nonzero = q.iter().any(|q| *q != 0.0);
        let times_mass =
            |f: &[f64; ALL]| -> [f64; POINTS] { std::array::from_fn(|j| f[j + 1] * mass[j + 1]) };
        let samples = [times_mass(&q), times_mass(&slope)];
        let rule = legendre(POINTS);
        for (n, samples) in samples.iter().enumerate() {
            let terms = samples.iter().zip(&rule.weights).map(|(f, w)| w * f);
            self.sums[n] = terms.clone().sum();
            self.sizes[n] = terms.map(f64::abs).sum();
            if !self.sizes[n].is_finite() {
                let value = self.sizes[n];
                return Err(QuadratureError::NotFinite { at: self.ends.0, value });
            }
        }
        self.errors = [rule.error(&samples[0]), 0.0];
        if known {
            self.errors[1] = rule.error(&samples[1]);
            return Ok(count);
        }
        let ends = [0, ALL - 1].map(|k| Some(q[k] * mass[k]));
        self.errors[0] += hidden(rule, &samples[0], ends);
        // The derivative of samples is noisy; a tail above the noise is an error. At a jump of the
        // law, the error is at most the jump times the change of the weight over the strip.
        let weights = mass.iter().zip(&dz).filter(|(_, dz)| **dz > 0.0).map(|(m, dz)| m / dz);
        let (q_range, g_range) = (extent(q.into_iter()), extent(weights));
        let largest = |(l, m): (f64, f64)| l.abs().max(m.abs());
        let second = extent(samples[1].into_iter());
        if rule.tail(&samples[1]) > NOISE * largest(second) {
            let jump = 4.0 * (q_range.1 - q_range.0) * (g_range.1 - g_range.0);
            self.errors[1] = rule.error(&samples[1]).min(jump);
        }
        if !self.map.smooth {
            self.floor = DERIVED * largest(q_range) * largest(g_range);
        }
        // A tail is an error if it is above the rounding of the samples.
        let off = if self.off > 1e2 * self.floor { 10.0 * self.off } else { 0.0 };
        self.errors[1] += self.floor + off;
        Ok(count)
    }
}

/// Interpolation through the points of a strip, those next to its ends included.
struct Interpolation {
    places: [f64; ALL],
    /// Row i: the derivative at point i+1.
    derivative: [[f64; ALL]; POINTS],
}

fn dot(row: &[f64; ALL], samples: &[f64; ALL]) -> f64 {
    row.iter().zip(samples).map(|(r, f)| r * f).sum()
}

fn interpolation() -> &'static Interpolation {
    static MADE: OnceLock<Interpolation> = OnceLock::new();
    MADE.get_or_init(|| {
        let mut places = [INSET; ALL];
        places[1..=POINTS].copy_from_slice(&legendre(POINTS).nodes);
        places[ALL - 1] = 1.0 - INSET;
        // Barycentric weights.
        let weight = |j: usize| {
            let others = (0..ALL).filter(|k| *k != j);
            others.map(|k| places[j] - places[k]).product::<f64>().recip()
        };
        let weights: [f64; ALL] = std::array::from_fn(weight);
        let mut derivative = [[0.0; ALL]; POINTS];
        for (row, i) in derivative.iter_mut().zip(1..) {
            for j in (0..ALL).filter(|j| *j != i) {
                row[j] = weights[j] / weights[i] / (places[i] - places[j]);
            }
            row[i] = -row.iter().sum::<f64>();
        }
        Interpolation { places, derivative }
    })
}

/// The rounding of the interpolating polynomial's derivative at its ends, in units of the largest
/// value over the interval.
pub(crate) const DERIVED: f64 = 4.0 * f64::EPSILON;
/// The share of the distance to the origin of powers below that is a large enough interval.
const ROOM: f64 = 0.25;

/// The derivative over an interval, from samples there. If a panel of a weight is so small that
/// neighbouring values of the density are equal, the interval is larger than the panel.
pub(crate) struct Slopes {
    low: f64,
    width: f64,
    by_place: Samples,
    /// Error by rounding.
    pub(crate) noise: f64,
    /// Error of the interpolation.
    pub(crate) off: f64,
}

impl Slopes {
    /// The length by which an interval between kinks is too short; 0 if it is not.
    pub(crate) fn missing(
        density: &Density,
        (from, to): (f64, f64),
        kinks: (f64, f64),
        halvings: u32,
    ) -> f64 {
        // Powers of the distance begin at the origin, or at the kink below.
        let origins = density.active(from, to).map(|piece| piece.origin.unwrap_or(kinks.0));
        let room = (from - origins.fold(f64::NEG_INFINITY, f64::max)).max(0.0);
        let missing = ROOM * 0.5f64.powi(halvings as i32) * room - (to - from);
        if missing.is_finite() {
            missing.clamp(0.0, (from - kinks.0) + (kinks.1 - to))
        } else {
            0.0
        }
    }

    /// Over `[from, to]` or more, between the kinks around it; `ends` select the pieces.
    pub(crate) fn new(
        density: &Density,
        ends: (f64, f64),
        (from, to): (f64, f64),
        kinks: (f64, f64),
        halvings: u32,
    ) -> Result<Self, QuadratureError> {
        let more = Self::missing(density, (from, to), kinks, halvings);
        let (below, above) = ((from - kinks.0).max(0.0), (kinks.1 - to).max(0.0));
        let below = (0.5 * more).max(more - above).min(below);
        let (low, width) = (from - below, to - from + more);
        let rule = lobatto();
        let x = rule.nodes.map(|node| (low + width * node).clamp(kinks.0, kinks.1));
        let (mut scratch, mut q) = ([0.0; NODES], [0.0; NODES]);
        density.sample(ends, &x, &mut scratch, &mut q)?;
        let largest = q.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
        Ok(Self {
            low,
            width,
            by_place: rule.derivative(&q).map(|slope| slope / width),
            noise: DERIVED * largest / width,
            off: rule.tail(&q) / width,
        })
    }

    /// The derivative at a place in the interval.
    pub(crate) fn at(&self, x: f64) -> f64 {
        lobatto::dot(&lobatto().basis((x - self.low) / self.width), &self.by_place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_of_a_strip_are_differentiated() {
        let made = interpolation();
        let samples = made.places.map(|x| (2.0 * x).exp());
        for (row, x) in made.derivative.iter().zip(&made.places[1..]) {
            assert!((dot(row, &samples) - 2.0 * (2.0 * x).exp()).abs() < 3e-12, "{x}");
        }
    }
}
