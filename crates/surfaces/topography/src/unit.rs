//! Units of length in files and options, and lengths with them.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::TopographyError;
use crate::error::{excerpt, parse_name};
use crate::read::{quantities, unit_meaning};

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum LengthUnit {
    /// m.
    #[serde(rename = "m")]
    Metre,
    /// cm.
    #[serde(rename = "cm")]
    Centimetre,
    /// mm.
    #[serde(rename = "mm")]
    Millimetre,
    /// µm, written `um`; [`FromStr`] takes `µm`, `micron` and `microns` as well.
    #[serde(rename = "um")]
    Micrometre,
    /// nm.
    #[serde(rename = "nm")]
    Nanometre,
    /// Å, written `angstrom`; [`FromStr`] takes `A` and `Å` as well.
    #[serde(rename = "angstrom")]
    Angstrom,
    /// pm.
    #[serde(rename = "pm")]
    Picometre,
}

impl LengthUnit {
    /// One of this unit in metres.
    #[must_use]
    pub fn metres(self) -> f64 {
        match self {
            Self::Metre => 1.0,
            Self::Centimetre => 1e-2,
            Self::Millimetre => 1e-3,
            Self::Micrometre => 1e-6,
            Self::Nanometre => 1e-9,
            Self::Angstrom => 1e-10,
            Self::Picometre => 1e-12,
        }
    }
}

impl fmt::Display for LengthUnit {
    /// The name in ASCII.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

impl FromStr for LengthUnit {
    type Err = TopographyError;

    /// The unit of a symbol or a name, as files have them: `µm`, `"Micrometer"`, `microns.`.
    fn from_str(name: &str) -> Result<Self, TopographyError> {
        parse_name("unit", unit_meaning(name).unwrap_or(name))
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
    /// A length in m.
    pub(crate) fn metre(value: f64) -> Self {
        Self { value, unit: Some(LengthUnit::Metre) }
    }

    /// The number in this unit; heights are in it if the distance has no unit of its own.
    #[must_use]
    pub fn in_unit(self, unit: LengthUnit) -> f64 {
        match self.unit {
            Some(own) if own != unit => self.value * own.metres() / unit.metres(),
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
            _ => Err(TopographyError::UnknownName {
                field: "pixel_size",
                found: excerpt(text.trim()),
                names: "a length above 0 in the unit of the heights, or with a unit (10 nm)".into(),
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_spellings_of_units_are_read() {
        for name in ["um", "µm", "μm", " um ", "microns"] {
            assert_eq!(name.parse::<LengthUnit>().unwrap(), LengthUnit::Micrometre);
        }
        let refused = "furlong".parse::<LengthUnit>();
        assert!(
            matches!(refused, Err(TopographyError::UnknownName { field: "unit", .. })),
            "{refused:?}"
        );
        let json = serde_json::to_string(&LengthUnit::Nanometre).unwrap();
        assert_eq!(json, "\"nm\"");
        assert_eq!(serde_json::from_str::<LengthUnit>("\"um\"").unwrap(), LengthUnit::Micrometre);
    }

    #[test]
    fn distances_have_the_unit_of_the_heights_or_their_own() {
        let of = |text: &str| text.parse::<Distance>().unwrap();
        let nm = LengthUnit::Nanometre;
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
