//! I(s) and its neighbourhood for one s at one scale: for scenes that are asked for few values.

use crate::gaussian::Moments;
use crate::segment::{self, Shift};
use crate::{Density, Goal, QuadratureError};

/// Below this s, s + t is a difference of large numbers.
const DEEP: f64 = -64.0;
/// As far from where the masses were made they still give a first digit.
const REACH: f64 = 8.0;

/// The point masses of one integral, made for one s: exact there, and good enough to look for a
/// root nearby.
#[derive(Debug, Clone)]
pub struct Nearby {
    from: f64,
    points: Vec<f64>,
    masses: Vec<f64>,
    /// Relative to the sizes, at `from`.
    error: f64,
    /// How often the density was sampled.
    evaluations: usize,
}

impl Nearby {
    /// Integrates `density(t/scale)` against φ(s + t) to a relative `tolerance`, without a rule.
    /// `scale` is positive and finite, s finite and at most 1e9.
    ///
    /// # Errors
    /// Those of [`crate::discretise`].
    pub fn new(
        density: &Density,
        scale: f64,
        s: f64,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let rounding = if s < DEEP { 100.0 * f64::EPSILON * s.abs() } else { 1e-15 };
        let aim = rounding.max(0.1 * tolerance);
        let goal = Goal { aim, refuse: 4.0 * aim };
        let window = |depth| segment::window((s, s), depth);
        let weight = |t: f64| segment::weight(s, t);
        let density = density.unprepared();
        let made = segment::masses(&density, scale, (s, &window), &weight, goal)?;
        let size: f64 = made.masses.iter().map(|mass| mass.abs()).sum();
        let x: Vec<f64> = made.points.iter().map(|t| t / scale).collect();
        let known = rounding + segment::ROUNDING + density.relative_error(&x);
        let error = known + if size > 0.0 { 4.0 * made.error / size } else { 0.0 };
        let evaluations = made.evaluations;
        Ok(Self { from: s, points: made.points, masses: made.masses, error, evaluations })
    }

    /// Where it is exact.
    #[must_use]
    pub fn from(&self) -> f64 {
        self.from
    }

    /// Whether [`at`](Self::at) tells anything of s.
    #[must_use]
    pub fn serves(&self, s: f64) -> bool {
        (s < 0.0) == (self.from < 0.0) && (s - self.from).abs() <= REACH
    }

    /// I and -dI/ds: to the bound where it was made, less well further away.
    #[must_use]
    pub fn at(&self, s: f64) -> Moments {
        let shift = Shift { from: self.from, s, stretch: 0.0 };
        Moments::new(&segment::sums(&self.points, &self.masses, shift), 1.0, s, self.error)
    }

    /// How often the density was sampled.
    #[must_use]
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ShiftedGaussian;
    use crate::gaussian::tests::power;

    #[test]
    fn exact_where_made_and_a_guide_nearby() {
        for (scale, s) in [(1e-3, 0.0), (0.3, -3.0), (10.0, 2.5), (1.0, 30.0)] {
            let nearby = Nearby::new(&power(1.425), scale, s, 1e-12).unwrap();
            let rule = ShiftedGaussian::new(power(1.425), scale, 1e-14);
            let (here, wanted) = (nearby.at(s), rule.at(s).unwrap());
            assert!((here.value / wanted.value - 1.0).abs() < here.error && here.error < 1e-11);
            let next = if s < 0.0 { s - 1.0 } else { s + 1.0 };
            assert!(nearby.serves(next));
            let ratio = nearby.at(next).value / rule.at(next).unwrap().value;
            assert!((ratio - 1.0).abs() < 1e-3, "{s}: {ratio}");
        }
        assert!(!Nearby::new(&power(1.0), 1.0, 1.0, 1e-6).unwrap().serves(-0.5));
    }
}
