//! I(s) and its neighbourhood for one s at one scale: for scenes that are asked for few values.

use super::moments::{DEEP, Moments};
use super::weight::{CUT, DEEPEST, HIGHEST, INV_SQRT_2PI, LOWEST, ROUNDING, Weight, masses};
use crate::{Density, Goal, QuadratureError};

/// As far from where the masses were made they still give a first digit: for s < 0 less, where the
/// error of the masses is worse than FIRST exp(-REACH²/2).
const REACH: f64 = 8.0;
const FIRST: f64 = 0.1;

/// The point masses of one integral, made for one s: exact there, and good enough to look for a
/// root nearby.
#[derive(Debug, Clone, Default)]
pub struct Nearby {
    from: f64,
    points: Vec<f64>,
    masses: Vec<f64>,
    /// Relative to the sizes, at `from`.
    error: f64,
    /// How often the density was sampled.
    evaluations: usize,
    reach: f64,
}

impl Nearby {
    /// Integrates `density(t/scale)` against φ(s + t) to a relative `tolerance`, without a rule.
    ///
    /// # Errors
    /// A refusal of the density, a sample that is not finite, or a missed tolerance;
    /// [`QuadratureError::OutOfRange`] unless s is finite and at most 1e9, `scale` positive and
    /// finite.
    pub fn new(
        density: &Density,
        scale: f64,
        s: f64,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let (near, far) = Weight::new(s, scale * density.begin()).window(CUT);
        Self::of(&density.unprepared((near / scale, far / scale)), scale, s, tolerance)
    }

    /// The same where the density may prepare itself, as it will be sampled again.
    pub(crate) fn of(
        density: &Density,
        scale: f64,
        s: f64,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        if !(s.is_finite() && s <= HIGHEST && scale > 0.0 && scale.is_finite()) {
            return Err(QuadratureError::OutOfRange { s, scale });
        }
        // Below 0, s + t is a difference of large numbers, and the weight is known no better; what
        // that makes of panels is worse, and nearly averages out.
        let rounding = f64::EPSILON * s.min(0.0).abs();
        let error = rounding + ROUNDING;
        let mut made = Self { from: s, error, reach: REACH, ..Self::default() };
        let weight = Weight::new(s, scale * density.begin());
        if weight.depth > DEEPEST {
            return Ok(made);
        }
        let noise = if s < LOWEST { 100.0 * rounding } else { weight.noise() };
        // Far below slopes are small differences, and wanted as well.
        let share = if s < DEEP { 0.1 / (1.0 - s) } else { 0.1 };
        let aim = noise.max(share * tolerance);
        if s < 0.0 {
            made.reach = (2.0 * (FIRST / aim).ln().max(0.0)).sqrt().min(REACH);
        }
        let goal = Goal { aim, refuse: (0.2 * tolerance).max(4.0 * aim) };
        let window = |depth| weight.window(depth);
        let found = masses(density, scale, (s, &window), &|t| weight.at(t), goal)?;
        let size: f64 = found.masses.iter().map(|mass| mass.abs()).sum();
        if size > 0.0 {
            made.error += 4.0 * found.error / size;
        }
        let x: Vec<f64> = found.points.iter().map(|t| t / scale).collect();
        made.error += density.relative_error(&x);
        let factor = INV_SQRT_2PI * (-weight.depth).exp();
        made.masses = found.masses.iter().map(|mass| factor * mass).collect();
        (made.points, made.evaluations) = (found.points, found.evaluations);
        Ok(made)
    }

    /// Where it is exact.
    #[must_use]
    pub fn from(&self) -> f64 {
        self.from
    }

    /// Whether [`at`](Self::at) is of use at s.
    #[must_use]
    pub fn serves(&self, s: f64) -> bool {
        (s < 0.0) == (self.from < 0.0) && (s - self.from).abs() <= self.reach
    }

    /// I and -dI/ds: to the bound where it was made, less well further away.
    #[must_use]
    pub fn at(&self, s: f64) -> Moments {
        // The difference of both exponents as a product: nothing large is subtracted.
        let (moved, middle) = (s - self.from, if s < 0.0 { 0.5 * (s + self.from) } else { 0.0 });
        let mut sums = [(0.0, 0.0); 2];
        for (t, mass) in self.points.iter().zip(&self.masses) {
            let mass = mass * (-moved * (t + middle)).exp();
            for (sum, term) in sums.iter_mut().zip([mass, mass * (s + t)]) {
                *sum = (sum.0 + term, sum.1 + term.abs());
            }
        }
        Moments::new(sums, s, self.error)
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
    use crate::gaussian::shifted::tests::power;

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
