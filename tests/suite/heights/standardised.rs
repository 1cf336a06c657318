//! Continuous distributions of statrs as heights, as anyone may write them.

use std::fmt;

use asperity::Heights;
use statrs::distribution::Continuous;
use statrs::statistics::{Distribution, Max, Min};

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
    /// With the standard deviation `asperity_height_std` \[m\]; that of the distribution is finite.
    pub fn new(name: &str, distribution: D, asperity_height_std: f64) -> Self {
        let mean = distribution.mean().unwrap();
        let scale = distribution.std_dev().unwrap() / asperity_height_std;
        let support = ((distribution.min() - mean) / scale, (distribution.max() - mean) / scale);
        let ln_scale = scale.ln();
        Self { name: name.into(), distribution, mean, scale, ln_scale, support }
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
