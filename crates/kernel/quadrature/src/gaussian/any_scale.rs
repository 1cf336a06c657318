//! I(s, c) = ∫₀^∞ q(t/c) φ(s + t) dt for many s and many scales c: nothing to prepare for a scale.

use std::sync::OnceLock;

use super::moments::Moments;
use super::patch::Argument;
use super::ranges::{Rules, Task};
use super::segment::Segment;
use crate::{Density, QuadratureError};

/// Scales from 2^-64 to 2^64 have rules, four for each octave: some 70 terms instead of the 12 that
/// [`crate::ShiftedGaussian`] needs at 1e-10.
const OCTAVES: u64 = 64;

/// The integral of one density against φ(s + t), for all s and all scales.
///
/// A change of scale does to the integral what a change of s does: a polynomial in both serves the
/// neighbours of a scale. They are built on demand.
#[derive(Debug)]
pub struct AnyScale {
    task: Task,
    rows: Box<[OnceLock<Box<Rules>>]>,
}

impl AnyScale {
    /// Prepares the integrals of `density(t/c)` to a relative `tolerance`; nothing is sampled
    /// before the first evaluation.
    #[must_use]
    pub fn new(density: Density, tolerance: f64) -> Self {
        let rows = (0..8 * OCTAVES).map(|_| OnceLock::new()).collect();
        Self { task: Task::new(density, tolerance), rows }
    }

    /// I(s, c) and -dI/ds at a finite s ≤ 1e9 and a positive, finite scale c.
    ///
    /// # Errors
    /// The errors of [`crate::ShiftedGaussian::at`].
    #[inline]
    pub fn at(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        match self.ready(s, scale) {
            Some((segment, place)) => Ok(Moments::new(segment.with_slope(place), s, segment.error)),
            None => self.anew(s, scale),
        }
    }

    /// I(s, c) alone; `slope` and its size may be left at 0.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at).
    #[inline]
    pub fn value(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        match self.ready(s, scale) {
            Some((segment, place)) => Ok(Moments::of_value(segment.value(place), s, segment.error)),
            None => self.anew(s, scale),
        }
    }

    /// The rule and the place seen from it, if it has been built and is good enough.
    #[inline]
    fn ready(&self, s: f64, scale: f64) -> Option<(&Segment, Argument)> {
        let rules = self.rows.get(row(scale))?.get()?;
        let place = rules.place(s, scale);
        let segment = rules.ready(place)?;
        (segment.error <= self.coarsest()).then_some((segment, place))
    }

    /// Rules that are coarser are not used.
    #[inline]
    fn coarsest(&self) -> f64 {
        self.task.tolerance.max(2e-13)
    }

    /// The rule, built if need be; none where there are none, or where one would be too coarse.
    #[cold]
    fn build(&self, s: f64, scale: f64) -> Result<Option<(&Segment, Argument)>, QuadratureError> {
        let Some(row) = self.rows.get(row(scale)) else { return Ok(None) };
        let rules = row.get_or_init(|| {
            let quarter = scale.to_bits() >> 50;
            let [low, high] = [quarter, quarter + 1].map(|quarter| f64::from_bits(quarter << 50));
            Box::new(Rules::between(low, high))
        });
        rules.at(rules.place(s, scale), &self.task)?;
        Ok(self.ready(s, scale))
    }

    /// I and -dI/ds from a rule that is to be built first or from none.
    #[cold]
    fn anew(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        match self.build(s, scale)? {
            Some((segment, place)) => Ok(Moments::new(segment.with_slope(place), s, segment.error)),
            None => self.task.directly(s, scale),
        }
    }
}

/// The row of a scale: the two highest bits of the mantissa are the quarter of the octave.
#[inline]
fn row(scale: f64) -> usize {
    (scale.to_bits() >> 50).wrapping_sub(4 * (1023 - OCTAVES)) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShiftedGaussian;
    use crate::gaussian::shifted::tests::power;

    #[test]
    fn agrees_with_rules_made_for_the_scale() {
        for tolerance in [1e-4, 1e-13] {
            let any = AnyScale::new(power(1.425), tolerance);
            for k in 0..60 {
                let scale = 1e-6 * 1.9f64.powi(k);
                let exact = ShiftedGaussian::new(power(1.425), scale, 1e-14);
                for s in [
                    -70.0, -8.5, -7.99, -3.2, -1e-3, -1e-15, -1e-20, -1e-300, 0.0, 0.2, 3.0, 44.0,
                    1e7,
                ] {
                    let (a, b) = (any.at(s, scale).unwrap(), exact.at(s).unwrap());
                    let error = (a.value / b.value - 1.0).abs();
                    assert!(error <= a.error + b.error, "{s} {scale} {error:e}");
                    // Far below, s + t is known no better than s is.
                    let reached = if s < -64.0 { 2e-12 } else { 2.0 * tolerance };
                    assert!(a.error < reached.max(2.0 * tolerance), "{s} {scale} {:e}", a.error);
                    let slope = (a.slope - b.slope).abs() / b.sizes[1];
                    assert!(
                        slope <= a.error + b.error,
                        "{s} {scale} {slope:e} {:e} {:e}",
                        a.error,
                        b.error
                    );
                    let value = any.value(s, scale).unwrap().value;
                    assert!((value / a.value - 1.0).abs() < 1e-15);
                }
            }
        }
    }

    #[test]
    fn scales_beyond_the_rules_are_integrated_directly() {
        let any = AnyScale::new(power(1.0), 1e-12);
        for scale in [1e-30, 1e30] {
            assert!(any.build(1.0, scale).unwrap().is_none());
            // ∫ (t/c) φ(1 + t) dt = (φ(1) - Q(1))/c, times √e.
            let exact = 0.083_315_470_587_686_3 * 0.5f64.exp() / scale;
            assert!((any.value(1.0, scale).unwrap().value / exact - 1.0).abs() < 1e-13);
        }
    }
}
