//! I(s) = ∫₀^∞ q(t/c) φ(s + t) dt at one scale c for many s.

use std::sync::atomic::Ordering;

use crate::rules::{Rules, Task};
use crate::segment::Segment;
use crate::terms::Sums;
use crate::{Density, QuadratureError};

/// I(s) with its derivatives, scaled against underflow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// I(s) = value · exp(`ln_scale`).
    pub value: f64,
    /// -dI/ds = slope · exp(`ln_scale`).
    pub slope: f64,
    /// -max(s, 0)²/2.
    pub ln_scale: f64,
    /// Integrals of the absolute value, for value and slope: larger than those where the density
    /// changes its sign (and, for the slope, where s < 0).
    pub sizes: [f64; 2],
    /// Bound on the error of value and slope relative to `sizes`, for the s given (the rounding of
    /// s itself apart).
    pub error: f64,
}

/// The second derivative d²I/ds² = value · exp(`ln_scale`).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// ∫ q(t/c) ((s+t)² - 1) φ(s+t) dt over its scale.
    pub value: f64,
    /// The same with |q| ((s+t)² + 1).
    pub size: f64,
    /// -max(s, 0)²/2.
    pub ln_scale: f64,
    /// Bound on the error of the value relative to `size`.
    pub error: f64,
}

/// The integral of one density at one scale c against φ(s + t), for all s.
#[derive(Debug)]
pub struct ShiftedGaussian {
    task: Task,
    scale: f64,
    rules: Rules,
}

impl ShiftedGaussian {
    /// Prepares the integral of `density(t/scale)`; nothing is sampled before the first
    /// evaluation. `scale` must be positive and finite, `tolerance` is relative.
    #[must_use]
    pub fn new(density: Density, scale: f64, tolerance: f64) -> Self {
        let rules = Rules::new(scale, (0.0, 0.0));
        Self { task: Task::new(density, tolerance), scale, rules }
    }

    /// I(s) and -dI/ds at a finite s ≤ 1e9.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn at(&self, s: f64) -> Result<Moments, QuadratureError> {
        let (sums, [error, _]) = self.sums(s)?;
        Ok(Moments::new(&sums, 1.0, s, error))
    }

    /// I(s) alone, with `slope` and its size left at 0: about half the work of [`at`](Self::at).
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    #[inline]
    pub fn value(&self, s: f64) -> Result<Moments, QuadratureError> {
        let Some(segment) = self.rules.at(s, &self.task)? else { return self.at(s) };
        let (value, size) = segment.value(s, 0.0);
        Ok(Moments::of_value(value, size, s, segment.error[0]))
    }

    /// d²I/ds², from the nodes of value and slope.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn curvature(&self, s: f64) -> Result<Curvature, QuadratureError> {
        let (sums, [_, error]) = self.sums(s)?;
        let value = sums.power[2] - sums.power[0];
        let size = sums.size[2] + sums.size[0];
        Ok(Curvature { value, size, ln_scale: ln_scale(s), error })
    }

    fn sums(&self, s: f64) -> Result<(Sums, [f64; 2]), QuadratureError> {
        match self.rules.at(s, &self.task)? {
            Some(segment) => Ok((segment.sums(s, 0.0), segment.error)),
            None => self.task.directly(s, self.scale).map(|(sums, error)| (sums, [error; 2])),
        }
    }

    /// Nodes of the rule that serves s; 0 where each evaluation integrates anew.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn nodes(&self, s: f64) -> Result<usize, QuadratureError> {
        Ok(self.rules.at(s, &self.task)?.map_or(0, Segment::nodes))
    }

    /// How often the density has been sampled so far, over all rules built.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.task.evaluations.load(Ordering::Relaxed)
    }
}

impl Moments {
    pub(crate) fn new(sums: &Sums, factor: f64, s: f64, error: f64) -> Self {
        Self {
            value: sums.power[0] * factor,
            slope: sums.power[1] * factor,
            sizes: [sums.size[0] * factor, sums.size[1] * factor],
            ln_scale: ln_scale(s),
            error,
        }
    }

    #[inline]
    pub(crate) fn of_value(value: f64, size: f64, s: f64, error: f64) -> Self {
        Self { value, slope: 0.0, ln_scale: ln_scale(s), sizes: [size, 0.0], error }
    }
}

/// -max(s, 0)²/2.
#[inline]
fn ln_scale(s: f64) -> f64 {
    if s > 0.0 { -0.5 * s * s } else { 0.0 }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::Piece;
    use crate::segment::INV_SQRT_2PI;
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

    #[test]
    fn linear_density_has_the_recurrence_of_parabolic_cylinders() {
        // F₁ = ∫ t φ = φ(s) - s Q(s), F₁' = -Q, F₁" = φ: 0.3989, 1/2 and 0.3989 at s = 0.
        let integral = ShiftedGaussian::new(power(1.0), 1.0, 1e-14);
        let at = integral.at(0.0).unwrap();
        assert!((at.value / INV_SQRT_2PI - 1.0).abs() < 1e-14);
        assert!((at.slope / 0.5 - 1.0).abs() < 1e-14);
        for s in [-30.0, -3.0, 0.0, 0.7, 4.0, 40.0, 1e3] {
            let second = integral.curvature(s).unwrap();
            // Scaled by exp(max(s, 0)²/2).
            let exact = INV_SQRT_2PI * if s < 0.0 { (-0.5f64 * s * s).exp() } else { 1.0 };
            assert!((second.value - exact).abs() < second.error * second.size, "{s}");
            assert!(second.error < 1e-13);
        }
    }

    #[test]
    fn the_second_derivative_lowers_a_power_by_two() {
        let [whole, lowered] = [3.425, 1.425].map(|p| ShiftedGaussian::new(power(p), 0.1, 1e-13));
        for s in [-20.0, -1.0, 0.0, 2.0, 17.0, 300.0] {
            let second = whole.curvature(s).unwrap();
            let exact = 3.425 * 2.425 * lowered.value(s).unwrap().value / 0.01;
            assert!((second.value - exact).abs() < second.error * second.size, "{s}");
            assert!(second.error < 1e-12);
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
            let (direct, _) = integral.task.directly(s, 0.3).unwrap();
            assert!((compiled.value / direct.power[0] - 1.0).abs() < 1e-14);
            assert!((compiled.slope / direct.power[1] - 1.0).abs() < 2e-12, "{s}");
        }
    }

    #[test]
    fn looser_tolerances_need_fewer_nodes_and_samples() {
        let [tight, loose] = [1e-13, 1e-4].map(|t| ShiftedGaussian::new(power(1.425), 1e-3, t));
        for s in [-3.0, 0.0, 2.0, 40.0] {
            assert!(loose.nodes(s).unwrap() < tight.nodes(s).unwrap());
            let (a, b) = (tight.at(s).unwrap(), loose.at(s).unwrap());
            assert!((a.value / b.value - 1.0).abs() < b.error && b.error < 1e-4);
        }
    }
}
