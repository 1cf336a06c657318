//! Units of length in files and options.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::TopographyError;
use crate::error::parse_name;

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

    fn from_str(name: &str) -> Result<Self, TopographyError> {
        parse_name(
            "unit",
            match name.trim() {
                // The micro sign and the Greek letter mu are both in use.
                "\u{b5}m" | "\u{3bc}m" | "micron" | "microns" => "um",
                "A" | "\u{c5}" | "\u{212b}" => "angstrom",
                name => name,
            },
        )
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
        let error = "furlong".parse::<LengthUnit>().unwrap_err().to_string();
        assert_eq!(
            error,
            "unit is \"furlong\": one of m, cm, mm, um, nm, angstrom, pm was required"
        );
        let json = serde_json::to_string(&LengthUnit::Nanometre).unwrap();
        assert_eq!(json, "\"nm\"");
        assert_eq!(serde_json::from_str::<LengthUnit>("\"um\"").unwrap(), LengthUnit::Micrometre);
    }
}
