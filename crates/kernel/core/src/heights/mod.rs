//! Distributions of asperity heights.

pub(crate) mod other;
pub(crate) mod table;
pub(crate) mod weibull;

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use self::other::{Heights, OtherHeights};
use crate::WeibullHeights;

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
    Other(Arc<OtherHeights>),
    /// Weibull's density, for skewed heights.
    #[serde(untagged)]
    Weibull(WeibullHeights),
}

impl HeightDistribution {
    /// Any density as the heights of a scene.
    pub fn other(heights: impl Heights + 'static) -> Self {
        Self::Other(Arc::new(OtherHeights::new(heights)))
    }

    /// Smallest and largest height \[m\], for this standard deviation \[m\]; may be infinite.
    #[must_use]
    pub fn support(&self, height_std: f64) -> (f64, f64) {
        match self {
            Self::Gaussian => (f64::NEG_INFINITY, f64::INFINITY),
            Self::Exponential => (0.0, f64::INFINITY),
            Self::Weibull(weibull) => {
                let (low, high) = weibull.sampled.heights().support();
                (low * height_std, high * height_std)
            }
            Self::Other(other) => other.heights().support(),
        }
    }

    /// The sampled density, and σ_z in the unit of its heights: 1, or this one \[m\]. `None` for
    /// Gaussian and exponential heights.
    pub(crate) fn sampled(&self, height_std: f64) -> Option<(&Arc<OtherHeights>, f64)> {
        match self {
            Self::Weibull(weibull) => Some((&weibull.sampled, 1.0)),
            Self::Other(other) => Some((other, height_std)),
            Self::Gaussian | Self::Exponential => None,
        }
    }

    /// Heights \[m\] inside the [support](Self::support) at which the density or its slope jumps.
    #[must_use]
    pub fn breaks(&self) -> &[f64] {
        self.sampled(1.0).map_or(&[], |(sampled, _)| sampled.heights().breaks())
    }

    /// Name, for plans and tables.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Gaussian => "gaussian",
            Self::Exponential => "exponential",
            Self::Weibull(_) => "weibull",
            Self::Other(other) => other.heights().name(),
        }
    }
}
