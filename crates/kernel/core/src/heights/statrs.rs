//! Continuous distributions of statrs as heights.

use std::fmt;

use statrs::distribution::Continuous;
use statrs::statistics::{Distribution, Max, Min};

use crate::error::{positive, require};
use crate::{ContactError, Heights};

/// Bound on the relative error of statrs densities; the largest measured error is 3e-14, from the
/// logarithm of the gamma function.
const STATRS: f64 = 1e-13;

/// A statrs distribution, shifted to mean 0 and scaled to a standard deviation in metres:
/// separations are measured from the mean of the asperity heights.
///
/// The heights keep that standard deviation on every scene; the scene's `asperity_height_std` is
/// only its unit of separations. The engine finds kinks inside the support (`Laplace`,
/// `Triangular`).
#[derive(Clone)]
pub struct StandardisedHeights<D> {
    name: String,
    distribution: D,
    mean: f64,
    /// Standard deviation of the distribution over the heights' \[1/m\].
    scale: f64,
    ln_scale: f64,
    support: (f64, f64),
}

impl<D> StandardisedHeights<D>
where
    D: Continuous<f64, f64> + Distribution<f64> + Min<f64> + Max<f64> + Send + Sync,
{
    /// With the standard deviation `asperity_height_std` \[m\].
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a standard deviation that is not finite and above 0, and
    /// for a distribution without finite mean and standard deviation.
    pub fn new(
        name: impl Into<String>,
        distribution: D,
        asperity_height_std: f64,
    ) -> Result<Self, ContactError> {
        let wanted = positive("asperity_height_std", asperity_height_std)?;
        let std = positive(
            "standard deviation of the heights",
            distribution.std_dev().unwrap_or(f64::NAN),
        )?;
        let mean = distribution.mean().unwrap_or(f64::NAN);
        require(mean.is_finite(), "mean of the heights", mean, "a finite number")?;
        let scale = std / wanted;
        let support = ((distribution.min() - mean) / scale, (distribution.max() - mean) / scale);
        let ln_scale = scale.ln();
        Ok(Self { name: name.into(), distribution, mean, scale, ln_scale, support })
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

    fn ln_density(&self, z: f64) -> f64 {
        if z < self.support.0 || z > self.support.1 {
            return f64::NEG_INFINITY;
        }
        self.distribution.ln_pdf(self.mean + self.scale * z) + self.ln_scale
    }

    fn support(&self) -> (f64, f64) {
        self.support
    }

    fn error(&self) -> f64 {
        STATRS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use statrs::distribution::{Cauchy, Weibull};

    #[test]
    fn support_is_scaled_and_moments_are_required() {
        let new = |std| StandardisedHeights::new("weibull", Weibull::new(3.0, 1.0).unwrap(), std);
        let (low, high) = new(1e-6).unwrap().support();
        assert!((low + 2.752e-6).abs() < 1e-8 && high.is_infinite());
        assert!(new(1e-6).unwrap().ln_density(low - 1e-7) == f64::NEG_INFINITY);
        assert!(new(0.0).unwrap_err().to_string().starts_with("asperity_height_std is 0"));
        let cauchy = Cauchy::new(0.0, 1.0).unwrap();
        let error = StandardisedHeights::new("cauchy", cauchy, 1e-6).unwrap_err();
        assert!(error.to_string().starts_with("standard deviation"));
    }
}
