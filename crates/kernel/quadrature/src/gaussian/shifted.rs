//! I(s) = ∫₀^∞ q(t/c) φ(s + t) dt at one scale c for many s.

use std::sync::OnceLock;
use std::sync::atomic::Ordering;

use super::moments::Moments;
use super::patch::Argument;
use super::ranges::{Rules, Task};
use super::segment::Segment;
use super::table::StepTable;
use crate::{Density, QuadratureError};

/// The integral of one density at one scale c against φ(s + t), for all s.
#[derive(Debug)]
pub struct ShiftedGaussian {
    task: Task,
    scale: f64,
    rules: Rules,
    /// For arrays.
    table: OnceLock<Box<StepTable>>,
}

impl ShiftedGaussian {
    /// Prepares the integral of `density(t/scale)`; nothing is sampled before the first
    /// evaluation. `scale` must be positive and finite, `tolerance` is relative.
    #[must_use]
    pub fn new(density: Density, scale: f64, tolerance: f64) -> Self {
        let rules = Rules::new(scale, 0.0);
        Self { task: Task::new(density, tolerance), scale, rules, table: OnceLock::new() }
    }

    /// I(s) and -dI/ds at a finite s ≤ 1e9.
    ///
    /// # Errors
    /// A refusal of the density, a sample that is not finite, or a missed tolerance;
    /// [`QuadratureError::OutOfRange`] for any other s.
    #[inline(always)]
    pub fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let place = Argument::at(s);
        match self.rules.ready(place) {
            Some(segment) => Ok(Moments::new(segment.with_slope(place), s, segment.error)),
            None => self.anew(s),
        }
    }

    /// I(s) alone, with `slope` and its size left at 0: about half the work of [`at`](Self::at).
    ///
    /// # Errors
    /// The errors of [`at`](Self::at).
    #[inline(always)]
    pub fn value(&self, s: f64) -> Result<Moments, QuadratureError> {
        let place = Argument::at(s);
        match self.rules.ready(place) {
            Some(segment) => Ok(Moments::of_value(segment.value(place), s, segment.error)),
            None => {
                let Moments { value, sizes, error, .. } = self.anew(s)?;
                Ok(Moments::of_value((value, sizes[0]), s, error))
            }
        }
    }

    /// The same from a rule that is to be built first or from none.
    #[cold]
    fn anew(&self, s: f64) -> Result<Moments, QuadratureError> {
        let place = Argument::at(s);
        match self.rules.at(place, &self.task)? {
            Some(segment) => Ok(Moments::new(segment.with_slope(place), s, segment.error)),
            None => self.task.directly(s, self.scale),
        }
    }

    /// Polynomials for many values.
    pub(crate) fn table(&self) -> &StepTable {
        self.table.get_or_init(Box::default)
    }

    /// Terms of the polynomial that serves s; 0 where each evaluation integrates anew.
    ///
    /// # Errors
    /// The errors of [`at`](Self::at).
    pub fn terms(&self, s: f64) -> Result<usize, QuadratureError> {
        Ok(self.rules.at(Argument::at(s), &self.task)?.map_or(0, Segment::terms))
    }

    /// How often the density has been sampled so far, over all rules built.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.task.evaluations.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Piece;
    use crate::gaussian::weight::INV_SQRT_2PI;
    use std::sync::Arc;

    /// x^p.
    pub(crate) fn power(p: f64) -> Density {
        let sampler = move |x: &[f64], out: &mut [f64]| {
            for (out, x) in out.iter_mut().zip(x) {
                *out = x.powf(p);
            }
            Ok(())
        };
        let sampler = Arc::new(sampler);
        let piece = Piece {
            from: 0.0,
            to: f64::INFINITY,
            sign: 1.0,
            kinks: vec![],
            origin: Some(0.0),
            sampler,
        };
        Density { pieces: vec![piece] }
    }

    /// x^p up to 1, then as much less than nothing.
    pub(crate) fn both_signs(p: f64) -> Density {
        let [mut above, mut below] = [power(p), power(p)].map(|mut d| d.pieces.remove(0));
        (above.to, below.from, below.sign) = (1.0, 1.0, -1.0);
        Density { pieces: vec![above, below] }
    }

    #[test]
    fn separations_that_are_no_numbers_or_too_large_are_refused() {
        let integral = ShiftedGaussian::new(power(1.0), 1.0, 1e-10);
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2e9] {
            let error = integral.value(wrong).unwrap_err();
            assert!(error.to_string().starts_with(&format!("s is {wrong}")), "{error}");
            assert!(integral.at(wrong).is_err());
        }
    }

    #[test]
    fn slopes_far_below_are_refused_where_rounding_takes_their_digits() {
        let [fine, coarse] = [1e-10, 1e-4].map(|t| ShiftedGaussian::new(power(1.5), 1.0, t));
        let error = fine.at(-1e6).unwrap().slope_within(-1e6, 1e-10).unwrap_err();
        assert!(error.to_string().contains("1.0e-10 was asked"), "{error}");
        assert!(fine.value(-1e6).unwrap().error < 1e-7);
        // ∫ t^1.5 φ(s + t) dt is |s|^1.5 (1 + 3/(8 s²) + ..) there.
        for s in [-100.0, -500.0f64] {
            assert!(fine.at(s).unwrap().slope_within(s, 1e-10).is_ok());
            let exact = 1.5 * s.abs().sqrt() * (1.0 - 0.125 / (s * s));
            assert!((coarse.at(s).unwrap().slope / exact - 1.0).abs() < 1e-6, "{s}");
        }
    }

    #[test]
    fn what_grows_up_to_the_end_of_the_window_gets_a_wider_one() {
        // 19!!/2 at s = 0; 1e-9 of it lies beyond weights of 1e-20.
        let steep = ShiftedGaussian::new(power(20.0), 1.0, 1e-12).value(0.0).unwrap();
        assert!((steep.value / 327_364_537.5 - 1.0).abs() < steep.error && steep.error < 1e-12);
        // Nothing below t = 1: Q(51) exp(50²/2), by the continued fraction of Mills' ratio.
        let mut above = power(0.0);
        above.pieces[0].from = 1.0;
        let tail = ShiftedGaussian::new(above, 1.0, 1e-12).value(50.0).unwrap();
        let mills = (1..60).rev().fold(51.0, |below, k| 51.0 + f64::from(k) / below).recip();
        let exact = INV_SQRT_2PI * (-50.5f64).exp() * mills;
        assert!((tail.value / exact - 1.0).abs() < tail.error && tail.error < 1e-12);
    }

    #[test]
    fn direct_and_compiled_agree_at_the_seam() {
        let integral = ShiftedGaussian::new(power(1.5), 0.3, 1e-14);
        for s in [-64.0, -63.2] {
            let compiled = integral.at(s).unwrap();
            let direct = integral.task.directly(s, 0.3).unwrap();
            assert!((compiled.value / direct.value - 1.0).abs() < 1e-14);
            assert!((compiled.slope / direct.slope - 1.0).abs() < 2e-12, "{s}");
        }
    }

    #[test]
    fn looser_tolerances_need_fewer_terms_and_samples() {
        let [tight, loose] = [1e-13, 1e-4].map(|t| ShiftedGaussian::new(power(1.425), 1e-3, t));
        for s in [-3.0, 0.0, 2.0, 40.0] {
            assert!(loose.terms(s).unwrap() < tight.terms(s).unwrap());
            let (a, b) = (tight.at(s).unwrap(), loose.at(s).unwrap());
            assert!((a.value / b.value - 1.0).abs() < b.error && b.error < 1e-4);
        }
    }
}
