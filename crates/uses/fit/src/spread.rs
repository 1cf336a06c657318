//! How well the data fix the parameters: covariance, 95 % intervals and their profiles.

use nalgebra::{DMatrix, DVector, SVD};
use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use crate::FitError;
use crate::problem::{Minimum, NO_VALUE, Problem};

/// Singular values below this share of the largest, or this many times the errors of the
/// derivatives, are 0.
const RANK: f64 = 1e-7;
const ERRORS: f64 = 20.0;
/// Derivatives beyond this are differences to missing values.
const NO_SLOPE: f64 = 1e12;
/// The coverage of an interval.
const COVERAGE: f64 = 0.95;
/// The relative deviation from a parabola beyond which the profile is followed.
const CURVED: f64 = 0.05;
/// Relative accuracy of the end of an interval followed by the profile.
const END: f64 = 1e-3;
/// Evaluations for each free parameter at a point of a profile.
const PATIENCE: usize = 40;

/// The linear algebra of the derivatives at a minimum.
pub(crate) struct Spread {
    /// Orthonormal directions, those the data fix best first.
    directions: DMatrix<f64>,
    singular: DVector<f64>,
    /// Smaller singular values are 0.
    least: f64,
    /// Variance of the residuals; `None` where as many parameters as values leave it unknown.
    variance: Option<f64>,
    /// The quantile of the residuals' distribution.
    quantile: f64,
}

/// The interval of a parameter as coordinates; an end that the data do not fix within the bounds is
/// none.
pub(crate) type Interval = [Option<f64>; 2];

impl Spread {
    /// The spread at a minimum; `None` if the derivatives are not finite.
    pub(crate) fn new(problem: &Problem<'_>, minimum: &Minimum) -> Result<Option<Self>, FitError> {
        let count = problem.parameters.len();
        let all: Vec<usize> = (0..count).collect();
        let jacobian = problem.jacobian(&minimum.coordinates, &all, None)?;
        // Missing values stand as huge residuals.
        if !jacobian.iter().all(|slope| slope.abs() < NO_SLOPE) {
            return Ok(None);
        }
        let found = SVD::try_new(jacobian, false, true, f64::EPSILON, 10_000);
        let Some((singular, Some(directions))) = found.map(|svd| (svd.singular_values, svd.v_t))
        else {
            return Ok(None);
        };
        let least = RANK.max(ERRORS * problem.slope_error()) * singular.max();
        let rank = singular.iter().filter(|s| **s > least).count();
        let freedom = problem.data.len().saturating_sub(rank);
        let (variance, quantile) = if problem.data.has_std() {
            (Some(1.0), Normal::standard().inverse_cdf(0.5 + 0.5 * COVERAGE))
        } else {
            let student = StudentsT::new(0.0, 1.0, freedom.max(1) as f64).ok();
            let quantile = student.map_or(f64::NAN, |t| t.inverse_cdf(0.5 + 0.5 * COVERAGE));
            ((freedom > 0).then(|| minimum.squares / freedom as f64), quantile)
        };
        let directions = directions.transpose();
        Ok(Some(Self { directions, singular, least, variance, quantile }))
    }

    fn is_fixed(&self, direction: usize) -> bool {
        self.singular[direction] > self.least
    }

    /// The number of combinations of the parameters that the data fix.
    pub(crate) fn rank(&self) -> usize {
        (0..self.singular.len()).filter(|k| self.is_fixed(*k)).count()
    }

    /// The condition number of the derivatives; `None` for combinations without effect.
    pub(crate) fn condition(&self) -> Option<f64> {
        let condition = self.singular.max() / self.singular.min();
        (self.rank() == self.singular.len()).then_some(condition)
    }

    /// The directions in which the data do not change, as columns.
    pub(crate) fn free_directions(&self) -> DMatrix<f64> {
        let free: Vec<usize> = (0..self.singular.len()).filter(|k| !self.is_fixed(*k)).collect();
        self.directions.select_columns(&free)
    }

    /// Whether the data fix a parameter by itself.
    pub(crate) fn fixes(&self, place: usize) -> bool {
        self.free_directions().row(place).iter().all(|share| share.abs() < 1e-4)
    }

    /// The covariance of two parameters over the variance of the residuals.
    fn covariance(&self, a: usize, b: usize) -> f64 {
        let part = |k: usize| {
            self.directions[(a, k)] * self.directions[(b, k)]
                / (self.singular[k] * self.singular[k])
        };
        (0..self.singular.len()).filter(|k| self.is_fixed(*k)).map(part).sum()
    }

    /// The correlation of two parameters that the data fix.
    pub(crate) fn correlation(&self, a: usize, b: usize) -> Option<f64> {
        if a == b {
            return Some(1.0);
        }
        let scale = (self.covariance(a, a) * self.covariance(b, b)).sqrt();
        let found = self.covariance(a, b) / scale;
        (self.fixes(a) && self.fixes(b) && found.is_finite()).then(|| found.clamp(-1.0, 1.0))
    }

    /// The 95 % interval of a parameter: quadratic where that is right, otherwise where the least
    /// squares of all other parameters exceed the minimum by as much.
    pub(crate) fn interval(
        &self,
        problem: &Problem<'_>,
        minimum: &Minimum,
        place: usize,
    ) -> Result<Interval, FitError> {
        let Some(variance) = self.variance.filter(|_| self.fixes(place)) else {
            return Ok([None, None]);
        };
        let half = self.quantile * (variance * self.covariance(place, place)).sqrt();
        let middle = minimum.coordinates[place];
        if !half.is_finite() {
            return Ok([None, None]);
        }
        // Residuals at the accuracy of the values have no profile.
        if half < 1e-7f64.max(1e3 * problem.accuracy()) {
            return Ok([Some(middle - half), Some(middle + half)]);
        }
        let target = variance * self.quantile * self.quantile;
        let profile = Profile { problem, minimum, place, target };
        Ok([profile.end(-half)?, profile.end(half)?])
    }
}

/// The least squares of all other parameters against one.
struct Profile<'a, 'f> {
    problem: &'a Problem<'f>,
    minimum: &'a Minimum,
    place: usize,
    /// Rise of the sum of squares at the ends of the interval.
    target: f64,
}

impl Profile<'_, '_> {
    /// The square root of the rise at a distance from the minimum over that at the interval's ends,
    /// which is linear for a parabola; and the place of the other parameters there.
    fn rise(&self, distance: f64, start: &[f64]) -> Result<(f64, Vec<f64>), FitError> {
        let mut moved = start.to_vec();
        moved[self.place] = self.minimum.coordinates[self.place] + distance;
        let others: Vec<usize> = (0..moved.len()).filter(|k| *k != self.place).collect();
        let found = self.problem.minimise(&moved, &others, (PATIENCE, self.problem.coarse()))?;
        let rise = ((found.squares - self.minimum.squares).max(0.0) / self.target).sqrt();
        Ok((rise, found.coordinates))
    }

    /// The end of the interval on the side of `half`, where a parabola has it.
    fn end(&self, half: f64) -> Result<Option<f64>, FitError> {
        let middle = self.minimum.coordinates[self.place];
        let [low, high] = self.problem.parameters[self.place].range();
        let most = if half < 0.0 { low - middle } else { high - middle };
        let within =
            |distance: f64| if half < 0.0 { distance.max(most) } else { distance.min(most) };
        let mut far = within(half);
        // 0 at a bound.
        if far.abs() < 1e-9 * half.abs() {
            return Ok(None);
        }
        let (mut near, mut near_rise) = (0.0, 0.0);
        let (mut rise, mut place) = self.rise(far, &self.minimum.coordinates)?;
        if far.to_bits() == half.to_bits() && (rise - 1.0).abs() < CURVED {
            return Ok(Some(middle + half));
        }
        // Outwards until the rise is enough, or the bound.
        for _ in 0..40 {
            if rise >= 1.0 {
                break;
            }
            if far.to_bits() == most.to_bits() {
                return Ok(None);
            }
            (near, near_rise) = (far, rise);
            let factor = (1.05 / rise.max(0.3)).clamp(1.1, 3.0);
            far = within(far * factor);
            (rise, place) = self.rise(far, &place)?;
        }
        if rise < 1.0 {
            return Ok(None);
        }
        // Regula falsi, with a bisection where it stalls.
        for step in 0..40 {
            if (far - near).abs() < END * far.abs() || (rise - 1.0).abs() < END {
                break;
            }
            let share = (1.0 - near_rise) / (rise - near_rise);
            let share = if step % 3 == 2 { 0.5 } else { share.clamp(0.02, 0.98) };
            let next = near + share * (far - near);
            let (found, others) = self.rise(next, &place)?;
            if (found - 1.0).abs() < END {
                (far, rise) = (next, found);
            } else if found < 1.0 {
                (near, near_rise) = (next, found);
            } else {
                (far, rise, place) = (next, found, others);
            }
        }
        // Where values end, an interval has no end within the bounds either.
        let is_missing = rise * self.target.sqrt() >= 0.5 * NO_VALUE;
        Ok((!is_missing).then_some(middle + far))
    }
}
