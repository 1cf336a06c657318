//! Units of length in files and options, and lengths with them.

use std::fmt;
use std::str::FromStr;

use asperity_core::units_of;
use serde::de::Error;
use serde::{Deserialize, Deserializer};

use crate::TopographyError;
use crate::error::unknown_name;
use crate::read::{quantities, unit_meaning};

/// The names of all units in ASCII.
const NAMES: &[&str] = &["m", "cm", "mm", "um", "nm", "angstrom", "pm"];

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LengthUnit {
    name: &'static str,
    metres: f64,
}

impl LengthUnit {
    /// m.
    pub const METRE: Self = Self { name: "m", metres: 1.0 };

    /// One of this unit in metres.
    #[must_use]
    pub fn metres(self) -> f64 {
        self.metres
    }
}

impl fmt::Display for LengthUnit {
    /// The name in ASCII.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name)
    }
}

impl FromStr for LengthUnit {
    type Err = TopographyError;

    /// The unit of a symbol or a name, as files have them: `µm`, `"Micrometer"`, `microns.`.
    fn from_str(text: &str) -> Result<Self, TopographyError> {
        let known = unit_meaning(text);
        let found = units_of("m").into_iter().find(|(name, _)| known == Some(name));
        found
            .map(|(name, metres)| Self { name, metres })
            .ok_or_else(|| unknown_name("unit", text, format!("one of {}", NAMES.join(", "))))
    }
}

impl<'de> Deserialize<'de> for LengthUnit {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(|_| D::Error::unknown_variant(&text, NAMES))
    }
}

/// A distance between neighbouring points: `0.5`, in the unit of the heights, or `10 nm`.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(try_from = "Given")]
pub struct Distance {
    /// As given.
    pub(crate) value: f64,
    /// `None` for the unit of the heights.
    pub(crate) unit: Option<LengthUnit>,
}

/// A number or a text.
#[derive(Deserialize)]
#[serde(untagged)]
pub(crate) enum Given {
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
    /// A length in m.
    pub(crate) fn metre(value: f64) -> Self {
        Self { value, unit: Some(LengthUnit::METRE) }
    }

    /// The number in this unit; heights are in it if the distance has no unit of its own.
    #[must_use]
    pub fn in_unit(self, unit: LengthUnit) -> f64 {
        match self.unit {
            Some(own) if own != unit => self.value * own.metres / unit.metres,
            _ => self.value,
        }
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
        let (numbers, unit) = quantities(text, ' ');
        match (&numbers[..], unit.map(str::parse).transpose()) {
            // A comma separates two distances.
            (&[value], Ok(unit)) if value > 0.0 && value.is_finite() && !text.contains(',') => {
                Ok(Self { value, unit })
            }
            _ => {
                let names = "a length above 0 in the unit of the heights, or with a unit (10 nm)";
                Err(unknown_name("pixel_size", text, names))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_spellings_of_units_are_read() {
        for name in ["um", "µm", "μm", " um ", "microns"] {
            let unit: LengthUnit = name.parse().unwrap();
            assert_eq!(
                (unit.to_string().as_str(), unit.metres().to_bits()),
                ("um", 1e-6f64.to_bits())
            );
        }
        for (name, metres) in [("angstrom", 1e-10_f64), ("Å", 1e-10), ("pm", 1e-12), ("cm", 1e-2)]
        {
            assert_eq!(name.parse::<LengthUnit>().unwrap().metres().to_bits(), metres.to_bits());
        }
        let refused = "furlong".parse::<LengthUnit>();
        assert!(
            matches!(refused, Err(TopographyError::UnknownName { field: "unit", .. })),
            "{refused:?}"
        );
        let unit: LengthUnit = serde_json::from_str("\"nm\"").unwrap();
        assert_eq!(unit.to_string(), "nm");
    }

    #[test]
    fn distances_have_the_unit_of_the_heights_or_their_own() {
        let of = |text: &str| text.parse::<Distance>().unwrap();
        let nm: LengthUnit = "nm".parse().unwrap();
        assert_eq!(of("0.5").in_unit(nm).to_bits(), 0.5f64.to_bits());
        for text in ["0.5um", " 0.5 um", "5e-7 m", "500 nm", "0.5 \u{b5}m"] {
            assert!((of(text).in_unit(nm) / 500.0 - 1.0).abs() < 1e-14, "{text}");
            assert!(of(text).unit.is_some() && of(&of(text).to_string()) == of(text), "{text}");
        }
        for text in ["", "um", "0", "-1 nm", "1e400", "nan", "1 mile", "1,5", "1 nm 2"] {
            let error = text.parse::<Distance>().unwrap_err().to_string();
            assert!(error.starts_with("pixel_size is \"") && error.contains("(10 nm)"), "{error}");
        }
    }
}
