//! Any continuous distribution of statrs as a density of heights.

use std::fmt;

use statrs::distribution::Continuous;
use statrs::statistics::{Distribution, Max, Min};

use crate::error::positive;
use crate::{ContactError, Heights};

/// A statrs distribution, shifted and scaled to mean 0 and standard deviation 1: separations are
/// measured from the mean of the asperity heights, and the scale is the scene's
/// `asperity_height_std`.
#[derive(Clone)]
pub struct StandardisedHeights<D> {
    name: String,
    distribution: D,
    mean: f64,
    std: f64,
    support: (f64, f64),
}

/// Step of the slope's difference formula, in standard deviations: truncation and rounding of the
/// eighth-order formula are both near 1e-12 of |ln density| there.
const STEP: f64 = 0.03;

impl<D> StandardisedHeights<D>
where
    D: Continuous<f64, f64> + Distribution<f64> + Min<f64> + Max<f64> + Send + Sync,
{
    /// # Errors
    /// [`ContactError::OutOfRange`] when the distribution has no finite mean and standard deviation.
    pub fn new(name: impl Into<String>, distribution: D) -> Result<Self, ContactError> {
        let std = positive(
            "standard deviation of the heights",
            distribution.std_dev().unwrap_or(f64::NAN),
        )?;
        let mean = distribution.mean().unwrap_or(f64::NAN);
        if !mean.is_finite() {
            let (field, required) = ("mean of the heights", "a finite number");
            return Err(ContactError::OutOfRange { field, value: mean, required });
        }
        let support = ((distribution.min() - mean) / std, (distribution.max() - mean) / std);
        Ok(Self { name: name.into(), distribution, mean, std, support })
    }
}

impl<D> fmt::Debug for StandardisedHeights<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StandardisedHeights").field("name", &self.name).finish_non_exhaustive()
    }
}

impl<D> Heights for StandardisedHeights<D>
where
    D: Continuous<f64, f64> + Send + Sync,
{
    fn name(&self) -> &str {
        &self.name
    }

    fn ln_density(&self, height: f64) -> f64 {
        if height < self.support.0 || height > self.support.1 {
            return f64::NEG_INFINITY;
        }
        self.distribution.ln_pdf(self.mean + self.std * height) + self.std.ln()
    }

    fn ln_density_slope(&self, height: f64) -> f64 {
        // statrs gives no derivatives. The step shrinks towards the ends of the support.
        let room = (height - self.support.0).min(self.support.1 - height);
        let step = STEP.min(0.24 * room);
        let difference =
            |k: f64| self.ln_density(height + k * step) - self.ln_density(height - k * step);
        // Central difference of order 8.
        (0.8 * difference(1.0) - 0.2 * difference(2.0) + 4.0 / 105.0 * difference(3.0)
            - difference(4.0) / 280.0)
            / step
    }

    fn support(&self) -> (f64, f64) {
        self.support
    }

    fn error(&self) -> f64 {
        1e-11
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::distribution::{Cauchy, Normal, Weibull};

    #[test]
    fn a_shifted_normal_becomes_the_standard_one() {
        let heights = StandardisedHeights::new("normal", Normal::new(3.0, 0.2).unwrap()).unwrap();
        for z in [-4.0, 0.0, 0.5, 6.0] {
            let exact = -0.5 * z * z - 0.918_938_533_204_672_7;
            assert!((heights.ln_density(z) - exact).abs() < 1e-13);
            assert!((heights.ln_density_slope(z) + z).abs() < 1e-11 * (1.0 + z * z), "{z}");
        }
    }

    #[test]
    fn support_is_scaled_and_moments_are_required() {
        let weibull = StandardisedHeights::new("weibull", Weibull::new(3.0, 1.0).unwrap()).unwrap();
        let (low, high) = weibull.support();
        assert!((low + 2.752).abs() < 1e-2 && high.is_infinite());
        assert!(weibull.ln_density(low - 0.1) == f64::NEG_INFINITY);
        let error = StandardisedHeights::new("cauchy", Cauchy::new(0.0, 1.0).unwrap()).unwrap_err();
        assert!(error.to_string().starts_with("standard deviation of the heights"));
    }
}
