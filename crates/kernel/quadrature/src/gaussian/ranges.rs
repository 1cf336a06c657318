//! The rules of one density near one scale: one for each short range of s, built on demand.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use super::moments::Moments;
use super::nearby::Nearby;
use super::patch::{Argument, Patch};
use super::segment::Segment;
use super::weight::{HIGHEST, LOWEST};
use crate::{Density, QuadratureError};

/// Rules below zero, one for each unit.
const NEGATIVE: usize = 64;
/// Rules above zero, four for each octave of s + 4.5.
const POSITIVE: usize = 112;

/// The rule of one range of s, if it has been built.
type BuiltSegment = OnceLock<Result<Box<Segment>, QuadratureError>>;

/// What an integral is of, and how well it is wanted.
#[derive(Debug)]
pub(crate) struct Task {
    pub(crate) density: Density,
    pub(crate) tolerance: f64,
    /// Samples of the density so far.
    pub(crate) evaluations: AtomicUsize,
}

impl Task {
    pub(crate) fn new(density: Density, tolerance: f64) -> Self {
        Self { density, tolerance, evaluations: AtomicUsize::new(0) }
    }

    /// The integral at one s and one scale without a rule.
    pub(crate) fn directly(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        let made = Nearby::of(&self.density, scale, s, self.tolerance)?;
        self.evaluations.fetch_add(made.evaluations(), Ordering::Relaxed);
        Ok(made.at(s))
    }
}

/// Rules for one scale, or for all scales of a short range.
#[derive(Debug)]
pub(crate) struct Rules {
    scale: f64,
    inverse: f64,
    /// Scales are `scale` over 1 - stretch to 1 + stretch.
    stretch: f64,
    segments: Box<[BuiltSegment]>,
}

impl Rules {
    pub(crate) fn new(scale: f64, stretch: f64) -> Self {
        let segments = (0..SEGMENTS).map(|_| OnceLock::new()).collect();
        Self { scale, inverse: scale.recip(), stretch, segments }
    }

    /// For scales from `low` to `high`.
    pub(crate) fn between(low: f64, high: f64) -> Self {
        Self::new(2.0 / (low.recip() + high.recip()), (high - low) / (high + low))
    }

    #[inline]
    pub(crate) fn place(&self, s: f64, scale: f64) -> Argument {
        // Neither waits for the other.
        Argument::at_scale(s, scale * self.inverse, self.scale / scale)
    }

    /// The rule for a place, if it has been built: all there is to do, nearly always.
    #[inline(always)]
    pub(crate) fn ready(&self, place: Argument) -> Option<&Segment> {
        let built = self.segments.get(locate(place.key()))?.get()?;
        built.as_ref().ok().map(Box::as_ref)
    }

    /// The rule for a place, if there is one, built if need be.
    #[cold]
    pub(crate) fn at(
        &self,
        place: Argument,
        task: &Task,
    ) -> Result<Option<&Segment>, QuadratureError> {
        let index = locate(place.key());
        let Some(cell) = self.segments.get(index) else { return Ok(None) };
        match cell.get_or_init(|| self.build(index, task)) {
            Ok(segment) => Ok(Some(segment)),
            Err(error) => Err(error.clone()),
        }
    }

    fn build(&self, index: usize, task: &Task) -> Result<Box<Segment>, QuadratureError> {
        let patch = Patch::new(range(index), self.stretch);
        let segment = Segment::new(&task.density, self.scale, patch, task.tolerance)?;
        task.evaluations.fetch_add(segment.evaluations, Ordering::Relaxed);
        Ok(Box::new(segment))
    }
}

/// How many rules there are.
pub(crate) const SEGMENTS: usize = NEGATIVE + POSITIVE;

/// The index of the rule for s; [`SEGMENTS`] where there is none. Bits, not branches: it is found
/// for many s side by side.
#[inline(always)]
pub(crate) fn locate(s: f64) -> usize {
    // From 64 to 128 the highest six bits of the mantissa count the units.
    let below = ((s + 128.0).to_bits() >> 46).wrapping_sub(FIRST_BELOW);
    // The sum rounds -1e-20 up to the range above zero, whose rules have another scale.
    let below = below.min(NEGATIVE as u64 - 1);
    let above = ((s + OFFSET).to_bits() >> 50).wrapping_sub(FIRST).wrapping_add(NEGATIVE as u64);
    let index = if s < 0.0 { below } else { above };
    if (LOWEST..=HIGHEST).contains(&s) { index as usize } else { SEGMENTS }
}

const FIRST_BELOW: u64 = 64f64.to_bits() >> 46;
/// Ranges above zero are quarter octaves of s + OFFSET: as wide as the tilt of a rule allows.
const OFFSET: f64 = 4.5;
const FIRST: u64 = OFFSET.to_bits() >> 50;

fn range(index: usize) -> (f64, f64) {
    if index < NEGATIVE {
        let low = index as f64 - NEGATIVE as f64;
        return (low, low + 1.0);
    }
    let quarter = |k: usize| f64::from_bits((FIRST + k as u64) << 50) - OFFSET;
    let k = index - NEGATIVE;
    (quarter(k).max(0.0), quarter(k + 1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_s_falls_inside_its_range() {
        for k in -640..8000 {
            let s = f64::from(k) * 0.1;
            let (low, high) = range(locate(s));
            assert!(
                low <= s && s <= high && high - low <= 0.26 * (s.abs() + 5.0),
                "{s} {low} {high}"
            );
        }
        assert!(locate(HIGHEST) < SEGMENTS && locate(-1e-300) == NEGATIVE - 1);
        for nowhere in [-64.5, 2e9, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(locate(nowhere), SEGMENTS);
        }
        assert_eq!(locate(LOWEST), 0);
    }
}
