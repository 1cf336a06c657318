//! I(s, c) = ∫₀^∞ q(t/c) φ(s + t) dt for many s and many scales c: nothing to prepare for a scale.

use std::sync::OnceLock;
use std::sync::atomic::Ordering;

use crate::gaussian::Moments;
use crate::rules::{Rules, Task};
use crate::segment::Segment;
use crate::{Density, QuadratureError};

/// Scales from 2^-64 to 2^64 have rules, four for each octave: 12 nodes instead of the 8 that
/// [`crate::ShiftedGaussian`] needs at 1e-10.
const OCTAVES: u64 = 64;
/// Below this s a change of scale moves the peak too far.
const LOWEST: f64 = -8.0;

/// The integral of one density against φ(s + t), for all s and all scales.
///
/// A change of scale multiplies the integrand by an entire function of t, as a change of s does: a
/// rule made at one scale serves its neighbours. Rules are built on demand.
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
    /// Those of [`crate::discretise`].
    pub fn at(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        let Some((segment, stretch)) = self.segment(s, scale)? else {
            let (sums, error) = self.task.directly(s, scale)?;
            return Ok(Moments::new(&sums, 1.0, s, error));
        };
        Ok(Moments::new(&segment.sums(s, stretch), 1.0 + stretch, s, segment.error[0]))
    }

    /// I(s, c) alone, with `slope` and its size left at 0.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    #[inline]
    pub fn value(&self, s: f64, scale: f64) -> Result<Moments, QuadratureError> {
        let Some((segment, stretch)) = self.segment(s, scale)? else { return self.at(s, scale) };
        let (value, size) = segment.value(s, stretch);
        let ratio = 1.0 + stretch;
        Ok(Moments::of_value(ratio * value, ratio * size, s, segment.error[0]))
    }

    /// Nodes of the rule that serves s and a scale; 0 where each evaluation integrates anew.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn nodes(&self, s: f64, scale: f64) -> Result<usize, QuadratureError> {
        Ok(self.segment(s, scale)?.map_or(0, |(segment, _)| segment.nodes()))
    }

    /// How often the density has been sampled so far, over all rules built.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.task.evaluations.load(Ordering::Relaxed)
    }

    /// The rule and c/c₀ - 1; none where there are none, or where one would be too coarse.
    #[inline]
    fn segment(&self, s: f64, scale: f64) -> Result<Option<(&Segment, f64)>, QuadratureError> {
        // The two highest bits of the mantissa tell the quarter of the octave.
        let quarter = scale.to_bits() >> 50;
        let index = quarter.wrapping_sub(4 * (1023 - OCTAVES)) as usize;
        let Some(row) = self.rows.get(index).filter(|_| s >= LOWEST) else { return Ok(None) };
        let low = f64::from_bits(quarter << 50);
        let centre = low + 0.125 * f64::from_bits((quarter >> 2) << 52);
        let rules = row.get_or_init(|| {
            let high = f64::from_bits((quarter + 1) << 50);
            Box::new(Rules::new(centre, (low / centre - 1.0, high / centre - 1.0)))
        });
        let segment = rules.at(s, &self.task)?;
        let wanted = self.task.tolerance.max(2e-13);
        let good = segment.filter(|segment| segment.error[0] <= wanted);
        Ok(good.map(|segment| (segment, (scale - centre) / centre)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShiftedGaussian;
    use crate::gaussian::tests::power;

    #[test]
    fn agrees_with_rules_made_for_the_scale() {
        for tolerance in [1e-4, 1e-13] {
            let any = AnyScale::new(power(1.425), tolerance);
            for k in 0..60 {
                let scale = 1e-6 * 1.9f64.powi(k);
                let exact = ShiftedGaussian::new(power(1.425), scale, 1e-14);
                for s in [-70.0, -8.5, -7.99, -3.2, -1e-3, 0.0, 0.2, 3.0, 44.0, 1e7] {
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
            assert_eq!(any.nodes(1.0, scale).unwrap(), 0);
            // ∫ (t/c) φ(1 + t) dt = (φ(1) - Q(1))/c, times √e.
            let exact = 0.083_315_470_587_686_3 * 0.5f64.exp() / scale;
            assert!((any.value(1.0, scale).unwrap().value / exact - 1.0).abs() < 1e-13);
        }
    }
}
