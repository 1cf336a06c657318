//! Units of length in files and options, and lengths with them.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::TopographyError;
use crate::error::{excerpt, parse_name};

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

    /// The unit of a symbol, or of a name in English or German.
    fn from_str(name: &str) -> Result<Self, TopographyError> {
        let lower = name.trim().to_lowercase();
        let symbol = match lower.strip_suffix('s').unwrap_or(&lower) {
            "meter" | "metre" => "m",
            "centimeter" | "centimetre" => "cm",
            "millimeter" | "millimetre" => "mm",
            // The micro sign and the Greek letter mu are both in use.
            "\u{b5}m" | "\u{3bc}m" | "micron" => "um",
            "micrometer" | "micrometre" | "mikrometer" => "um",
            "nanometer" | "nanometre" => "nm",
            "\u{e5}ngstr\u{f6}m" | "\u{e5}" | "\u{212b}" => "angstrom",
            "picometer" | "picometre" => "pm",
            "a" if name.trim() == "A" => "angstrom",
            _ => name,
        };
        parse_name("unit", symbol)
    }
}

/// The unit in a name or symbol of a file: `µm`, `"Micrometer"`, `microns.`.
pub(crate) fn unit(text: &str) -> Option<LengthUnit> {
    text.trim().trim_matches(['"', '\'', '.']).parse().ok()
}

/// `10.00 µm` in metres; the decimal separator is a point or a comma.
pub(crate) fn length(text: &str) -> Option<f64> {
    let (number, unit) = quantity(text)?;
    let length = number * unit?.metres();
    (length.is_finite() && length > 0.0).then_some(length)
}

/// A number and the unit after it, if there is one: `3.7e-007 m`.
pub(crate) fn quantity(text: &str) -> Option<(f64, Option<LengthUnit>)> {
    let text = text.trim();
    let end = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E'));
    let (value, name) = text.split_at(end.unwrap_or(text.len()));
    let value = number(value)?;
    match name.trim() {
        "" => Some((value, None)),
        name => Some((value, Some(unit(name)?))),
    }
}

/// A finite number with a decimal point or comma.
fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let number = text.parse().or_else(|_| text.replacen(',', ".", 1).parse()).ok()?;
    f64::is_finite(number).then_some(number)
}

/// The unit in `x [mm]`, `x (mm)`, `x_mm`, `x / mm`, `x in mm`, `Lateral mm` or `mm`.
pub(crate) fn unit_in(name: &str) -> Option<LengthUnit> {
    let name = name.trim().trim_matches('"').trim_end_matches([']', ')']);
    let last = name.rsplit(['[', '(', '_', '/', ' ']).next()?;
    // A single letter is the name of a column, as in `a`.
    let bare = last.len() == name.len();
    unit(last).filter(|_| !bare || name.chars().count() > 1)
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
        // A comma separates two distances.
        let found = quantity(text).filter(|(value, _)| *value > 0.0 && !text.contains(','));
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
    fn units_are_found_in_names_of_columns() {
        for name in ["x [\u{b5}m]", "x_(microns)", "z_um", "Raw Micrometer", "y in \u{3bc}m", "um"]
        {
            assert_eq!(unit_in(name), Some(LengthUnit::Micrometre), "{name}");
        }
        for name in ["m", "a", "", "height", "y1", "[1/0"] {
            assert_eq!(unit_in(name), None, "{name}");
        }
        assert_eq!(unit_in("[mm]"), Some(LengthUnit::Millimetre));
    }

    #[test]
    fn lengths_have_a_number_and_a_unit() {
        assert_eq!(length("5678,9 nm").map(|length| (1e13 * length).round()), Some(56_789_000.0));
        assert_eq!(quantity("3.69862e-007 m"), Some((3.69862e-7, Some(LengthUnit::Metre))));
        assert_eq!(quantity("-2"), Some((-2.0, None)));
        for text in ["", "um", "nan um", "1e400 m", "-3 um", "3 V", "1,2,3 um", "7"] {
            assert_eq!(length(text), None, "{text}");
        }
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
