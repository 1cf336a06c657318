//! How asperity heights are spread.

use std::fmt;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

/// A density of heights over ζ = z/σ_z, the height in standard deviations.
pub trait Heights: fmt::Debug + Send + Sync {
    /// Name, for plans and tables.
    fn name(&self) -> &str;

    /// Natural logarithm of the density at ζ; -∞ outside the support.
    fn ln_density(&self, height: f64) -> f64;

    /// d(ln density)/dζ inside the support.
    fn ln_density_slope(&self, height: f64) -> f64;

    /// Smallest and largest height; may be infinite.
    fn support(&self) -> (f64, f64);

    /// Heights at which the density or its slope jumps, inside the support.
    fn breaks(&self) -> &[f64] {
        &[]
    }

    /// Relative error of density and slope, if they are themselves approximations.
    fn error(&self) -> f64 {
        0.0
    }
}

/// The heights of a scene.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum HeightDistribution {
    /// φ(ζ) = exp(-ζ²/2)/√(2π); separations are measured from the mean.
    #[default]
    Gaussian,
    /// exp(-ζ) on ζ ≥ 0; separations are measured from ζ = 0, the lowest asperity.
    Exponential,
    /// Any other density.
    #[serde(skip)]
    Other(Arc<dyn Heights>),
}

impl HeightDistribution {
    /// Any density as the heights of a scene.
    pub fn other(heights: impl Heights + 'static) -> Self {
        Self::Other(Arc::new(heights))
    }

    /// Name, for plans and tables.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Gaussian => "gaussian",
            Self::Exponential => "exponential",
            Self::Other(heights) => heights.name(),
        }
    }
}
