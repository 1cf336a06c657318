//! The two ways to find asperities in a measured surface.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::TopographyError;
use crate::error::parse_name;

/// How asperities are found in a measured surface.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Estimator {
    /// From the spectral moments of profiles, after McCool:
    /// [`Surface::from_moments`](asperity_core::Surface::from_moments).
    #[default]
    Moments,
    /// From the summits of the surface: [`Topography::summits`](crate::Topography::summits).
    Summits,
}

impl fmt::Display for Estimator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl FromStr for Estimator {
    type Err = TopographyError;

    fn from_str(name: &str) -> Result<Self, TopographyError> {
        parse_name("estimator", name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for estimator in [Estimator::Moments, Estimator::Summits] {
            assert_eq!(estimator.to_string().parse::<Estimator>().unwrap(), estimator);
            let json = serde_json::to_string(&estimator).unwrap();
            assert_eq!(json, format!("\"{estimator}\""));
        }
        let error = "peaks".parse::<Estimator>().unwrap_err().to_string();
        assert_eq!(error, "estimator is \"peaks\": moments or summits was required");
    }
}
