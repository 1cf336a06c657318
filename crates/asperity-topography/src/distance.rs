//! A distance between points, in the unit of the heights or with a unit of its own.

use std::fmt;
use std::str::FromStr;

use serde::Deserialize;

use crate::error::excerpt;
use crate::read::units;
use crate::{LengthUnit, TopographyError};

/// A distance between neighbouring points: `0.5`, in the unit of the heights, or `10 nm`.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "Given")]
pub struct Distance {
    value: f64,
    /// `None` for the unit of the heights.
    unit: Option<LengthUnit>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Given {
    Number(f64),
    Text(String),
}

impl TryFrom<Given> for Distance {
    type Error = TopographyError;

    fn try_from(given: Given) -> Result<Self, TopographyError> {
        match given {
            Given::Number(value) => Ok(value.into()),
            Given::Text(text) => text.parse(),
        }
    }
}

impl Distance {
    /// The number in this unit; heights are in it if the distance has no unit of its own.
    #[must_use]
    pub fn in_unit(self, unit: LengthUnit) -> f64 {
        match self.unit {
            Some(own) if own != unit => self.value * own.metres() / unit.metres(),
            _ => self.value,
        }
    }

    /// The number as given.
    pub(crate) fn value(self) -> f64 {
        self.value
    }

    /// Whether it is in the unit of the heights.
    pub(crate) fn is_bare(self) -> bool {
        self.unit.is_none()
    }
}

impl From<f64> for Distance {
    /// A distance in the unit of the heights.
    fn from(value: f64) -> Self {
        Self { value, unit: None }
    }
}

impl fmt::Display for Distance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.unit {
            Some(unit) => write!(f, "{} {unit}", self.value),
            None => write!(f, "{}", self.value),
        }
    }
}

impl FromStr for Distance {
    type Err = TopographyError;

    fn from_str(text: &str) -> Result<Self, TopographyError> {
        // A comma separates two distances.
        let found = units::quantity(text).filter(|(value, _)| *value > 0.0 && !text.contains(','));
        let unknown = || TopographyError::UnknownName {
            field: "pixel_size",
            found: excerpt(text.trim()),
            names: "a length above 0 in the unit of the heights, or with a unit (10 nm)".into(),
        };
        found.map(|(value, unit)| Self { value, unit }).ok_or_else(unknown)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_have_the_unit_of_the_heights_or_their_own() {
        let of = |text: &str| text.parse::<Distance>().unwrap();
        let nm = LengthUnit::Nanometre;
        assert_eq!(of("0.5").in_unit(nm).to_bits(), 0.5f64.to_bits());
        for text in ["0.5um", " 0.5 um", "5e-7 m", "500 nm", "0.5 \u{b5}m"] {
            assert!((of(text).in_unit(nm) / 500.0 - 1.0).abs() < 1e-14, "{text}");
            assert!(!of(text).is_bare() && of(&of(text).to_string()) == of(text), "{text}");
        }
        for text in ["", "um", "0", "-1 nm", "1e400", "nan", "1 mile", "1,5", "1 nm 2"] {
            let error = text.parse::<Distance>().unwrap_err().to_string();
            assert!(error.starts_with("pixel_size is \"") && error.contains("(10 nm)"), "{error}");
        }
    }
}
