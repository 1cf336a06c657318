//! One integral: groups far from the kinks of the density first, then strips, refined together.

use super::fit::FAINT;
use super::integrand::{Integrand, Sums};
use super::strip::{DERIVED, Slopes, Strip, View};
use super::tree::{Node, Parts};
use super::weight::{OCTAVES, Weight};
use crate::chebyshev::lobatto::{NODES, dot, lobatto};
use crate::{QuadratureError, WeightFault};

/// Rounding of a large logarithm of the weight, and of its places, in units of its last place: far
/// out, the logarithm grows with some power of the distance.
const LN_ROUNDING: f64 = 100.0;
/// A group counts as points if the powers of the density begin at least this number of its widths
/// away: the error of the interpolation is then below 1e-15.
const APART: f64 = 1.0;
/// The same for densities of unknown form, whose interpolation error is estimated.
const APART_ESTIMATED: f64 = 0.5;
/// The largest error of that interpolation.
const RESOLVED: f64 = 3e-14;
/// An octave with less than this share of the sum is negligible.
const NOTHING: f64 = 1e-17;
/// After this number of octaves that each add as much as the one before, the integral diverges.
const ENDLESS: usize = 64;
/// Bisection stops at this depth,
const DEEPEST: u32 = 50;
/// after this number of halvings in a row that did not help,
const STALLED: u32 = 4;
/// or at this number of samples of the density.
const MOST: usize = 200_000;

/// Sums of one integral, so far.
pub(crate) struct Run<'a> {
    pub(super) integrand: &'a Integrand,
    pub(super) weight: &'a Weight,
    pub(crate) view: View<'a>,
    /// The lower end of the integral.
    pub(super) start: f64,
    /// The sums so far, with errors that are not yet relative.
    pub(crate) found: Sums,
    /// Whether a sample of the density was not zero.
    pub(crate) nonzero: bool,
    /// Ends of the sampled ranges, if the error of the density depends on them.
    pub(crate) sampled: Vec<f64>,
    approximate: bool,
    /// Relative rounding of the weight, where its logarithm is large.
    pub(crate) noise: f64,
    pub(super) strips: Vec<Strip<'a>>,
}

impl<'a> Run<'a> {
    pub(crate) fn new(
        integrand: &'a Integrand,
        weight: &'a Weight,
        view: View<'a>,
        start: f64,
    ) -> Self {
        Self {
            integrand,
            weight,
            start,
            found: Sums::default(),
            nonzero: false,
            sampled: vec![],
            approximate: integrand.density.relative_error(&[]) > 0.0,
            noise: LN_ROUNDING * f64::EPSILON * view.ln_scale.abs(),
            view,
            strips: vec![],
        }
    }

    /// The bulk of the weight, and its tails as far as they matter.
    pub(crate) fn everything(&mut self) -> Result<(), QuadratureError> {
        self.group(self.weight.nodes.len() - 1)?;
        for side in [0, 1] {
            self.tail(side)?;
        }
        Ok(())
    }

    pub(super) fn x(&self, z: f64) -> f64 {
        (z - self.view.d) / self.view.unit
    }

    fn group(&mut self, place: usize) -> Result<(), QuadratureError> {
        let node = &self.weight.nodes[place];
        if node.high <= self.start {
            return Ok(());
        }
        // The weights of groups are not scaled.
        if let Some(weights) = node.weights.as_ref().filter(|_| self.view.ln_scale.abs() < FAINT)
            && self.as_points(node, weights)?
        {
            return Ok(());
        }
        match node.parts {
            Parts::Groups(left, right) => {
                self.group(left)?;
                self.group(right)
            }
            Parts::Panel(panel) => self.panel(&self.weight.panels[panel]),
        }
    }

    /// Adds a group as points and returns true, if the density is smooth enough over it.
    fn as_points(&mut self, node: &Node, weights: &[f64; NODES]) -> Result<bool, QuadratureError> {
        let (low, high) = (self.x(node.low), self.x(node.high));
        let kinks = &self.integrand.kinks;
        let above = kinks.partition_point(|kink| *kink <= low);
        if kinks.get(above).is_some_and(|kink| *kink < high) {
            return Ok(false);
        }
        let Some(kink) = above.checked_sub(1).map(|k| kinks[k]) else { return Ok(false) };
        let density = &self.integrand.density;
        let width = high - low;
        let (mut known, mut any) = (true, false);
        for piece in density.active(low, high) {
            any = true;
            let apart = match piece.origin {
                Some(origin) => low - origin >= APART * width,
                None => low - kink >= APART_ESTIMATED * width,
            };
            if !apart {
                return Ok(false);
            }
            known &= piece.origin.is_some();
        }
        if !any {
            return Ok(true);
        }
        let rule = lobatto();
        let x = rule.nodes.map(|v| low + width * v);
        let (mut scratch, mut q, mut slope) = ([0.0; NODES], [0.0; NODES], [0.0; NODES]);
        self.found.evaluations += density.sample((low, high), &x, &mut scratch, &mut q)?;
        let largest = q.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
        let mass: f64 = weights.iter().sum();
        let tail = rule.tail(&q);
        if !known && tail > RESOLVED * largest {
            return Ok(false);
        }
        let mut errors = [if known { 0.0 } else { tail * mass }, 0.0];
        if density.has_slope((low, high)) {
            density.slope((low, high), &x, &mut scratch, &mut slope);
            slope.iter_mut().for_each(|s| *s /= self.view.unit);
        } else {
            let around = (kink, kinks.get(above).copied().unwrap_or(f64::INFINITY));
            if Slopes::missing(density, (low, high), around, 0) > 0.0 {
                let found = Slopes::new(density, (low, high), (low, high), around, 0)?;
                if found.off > 32.0 * found.noise {
                    return Ok(false);
                }
                slope = x.map(|x| found.at(x) / self.view.unit);
                errors[1] = (found.noise + found.off) / self.view.unit * mass;
            } else {
                let length = node.high - node.low;
                slope = rule.derivative(&q).map(|slope| slope / length);
                errors[1] = DERIVED * largest * mass / length;
            }
        }
        let scale = (-self.view.ln_scale).exp();
        for (n, samples) in [q, slope].iter().enumerate() {
            let sum = scale * dot(weights, samples);
            let size = scale * dot(weights, &samples.map(f64::abs));
            let size = size.abs().max(sum.abs());
            self.found.sums[n] += sum;
            self.found.sizes[n] += size;
            self.found.errors[n] += scale * errors[n] + node.error * size;
            if !size.is_finite() {
                return Err(QuadratureError::NotFinite { at: low, value: size });
            }
        }
        self.nonzero |= largest > 0.0;
        self.add_sampled(&[low, high]);
        Ok(true)
    }

    pub(super) fn add_sampled(&mut self, x: &[f64]) {
        if self.approximate {
            self.sampled.extend_from_slice(x);
        }
    }

    pub(super) fn count(&mut self, strip: &Strip<'_>, sign: f64) {
        for n in [0, 1] {
            self.found.sizes[n] += sign * strip.sizes[n];
        }
    }

    /// Octave by octave, until they are negligible.
    fn tail(&mut self, side: usize) -> Result<(), QuadratureError> {
        let weight = self.weight;
        let Some(tail) = &weight.tails[side] else { return Ok(()) };
        let peak = weight.nodes[weight.nodes.len() - 1].peak;
        let last = self.integrand.density.pieces.iter().map(|p| p.to).fold(0.0, f64::max);
        let (mut nothing, mut as_much, mut before) = (0, 0, 0.0);
        for k in 0..OCTAVES {
            let panels = tail.octave(&weight.source, peak, k)?;
            let low = panels.first().map_or(0.0, |p| p.low);
            let high = panels.last().map_or(0.0, |p| p.high);
            if side == 0 && high <= self.start || side == 1 && self.x(low) >= last {
                return Ok(());
            }
            if high <= self.start {
                continue;
            }
            let so_far = self.found.sizes[0];
            for panel in panels {
                if panel.high > self.start {
                    self.panel(panel)?;
                }
            }
            let added = self.found.sizes[0] - so_far;
            nothing = if added <= NOTHING * self.found.sizes[0] { nothing + 1 } else { 0 };
            if nothing >= 2 && self.found.sizes[0] > 0.0 {
                return Ok(());
            }
            as_much = if added >= before && added > 0.0 { as_much + 1 } else { 0 };
            before = added;
            if as_much >= ENDLESS {
                break;
            }
        }
        if self.found.sizes[0] == 0.0 {
            return Ok(());
        }
        Err(weight.source.fault(WeightFault::Diverges))
    }

    /// Halves strips until the sum of their errors, with those of the slope if `slope` is true, is
    /// small; each strip is allowed its share.
    pub(crate) fn refine(&mut self, slope: bool) -> Result<(), QuadratureError> {
        let aim = (0.02 * self.integrand.tolerance).max(1e-15);
        let mut strips = std::mem::take(&mut self.strips);
        let count = strips.len().max(1) as f64;
        while let Some(strip) = strips.pop() {
            let allowed = [0, 1].map(|n| {
                let share = (aim / count).max(1e-17) * self.found.sizes[n];
                share.max(self.noise * strip.sizes[n])
            });
            let resolved = strip.errors[0] <= allowed[0]
                && (!slope || strip.errors[1] <= allowed[1] || strip.errors[1] <= strip.floor);
            let given_up = strip.depth >= DEEPEST
                || strip.stalled >= STALLED
                || self.found.evaluations >= MOST;
            if resolved || given_up {
                for n in [0, 1] {
                    self.found.sums[n] += strip.sums[n];
                    self.found.errors[n] += strip.errors[n] + strip.panel.error * strip.sizes[n];
                }
                continue;
            }
            self.count(&strip, -1.0);
            let mut halves = strip.halves();
            for half in &mut halves {
                self.found.evaluations += half.sample(&self.view)?;
                self.count(half, 1.0);
            }
            let excess = |strip: &Strip<'_>| {
                let over = |n: usize| strip.errors[n] / allowed[n].max(f64::MIN_POSITIVE);
                over(0).max(over(1))
            };
            let noisy = excess(&halves[0]) + excess(&halves[1]) > 0.75 * excess(&strip);
            for mut half in halves {
                half.stalled = if noisy { strip.stalled + 1 } else { 0 };
                strips.push(half);
            }
        }
        Ok(())
    }
}
