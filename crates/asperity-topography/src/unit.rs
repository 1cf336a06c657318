//! Units of length, at the edge where files are read.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::TopographyError;

/// A unit of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub enum LengthUnit {
    /// m.
    Metre,
    /// cm.
    Centimetre,
    /// mm.
    Millimetre,
    /// µm, written `um`, `µm`, `micron` or `microns`.
    Micrometre,
    /// nm.
    Nanometre,
    /// Å, written `A`, `Å` or `angstrom`.
    Angstrom,
    /// pm.
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

    /// The name in ASCII.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Micrometre => "um",
            Self::Nanometre => "nm",
            Self::Angstrom => "angstrom",
            Self::Picometre => "pm",
        }
    }

    /// The unit of this name, if it is one.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Some(match name.trim() {
            "m" => Self::Metre,
            "cm" => Self::Centimetre,
            "mm" => Self::Millimetre,
            // Both the micro sign and the Greek letter are in use.
            "um" | "\u{b5}m" | "\u{3bc}m" | "micron" | "microns" => Self::Micrometre,
            "nm" => Self::Nanometre,
            "A" | "\u{c5}" | "\u{212b}" | "angstrom" => Self::Angstrom,
            "pm" => Self::Picometre,
            _ => return None,
        })
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for LengthUnit {
    type Err = TopographyError;

    fn from_str(name: &str) -> Result<Self, TopographyError> {
        Self::named(name).ok_or_else(|| TopographyError::UnknownName {
            field: "unit",
            found: name.to_owned(),
            known: "m, cm, mm, um, nm, angstrom, pm",
        })
    }
}

impl TryFrom<String> for LengthUnit {
    type Error = TopographyError;

    fn try_from(name: String) -> Result<Self, TopographyError> {
        name.parse()
    }
}

impl From<LengthUnit> for String {
    fn from(unit: LengthUnit) -> Self {
        unit.name().to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_read_as_people_write_them() {
        for name in ["um", "µm", "μm", " um "] {
            assert_eq!(name.parse::<LengthUnit>().unwrap(), LengthUnit::Micrometre);
        }
        let error = "furlong".parse::<LengthUnit>().unwrap_err().to_string();
        assert_eq!(
            error,
            "unit is \"furlong\": one of m, cm, mm, um, nm, angstrom, pm was required"
        );
        let json = serde_json::to_string(&LengthUnit::Nanometre).unwrap();
        assert_eq!(json, "\"nm\"");
        assert_eq!(serde_json::from_str::<LengthUnit>("\"µm\"").unwrap(), LengthUnit::Micrometre);
    }
}
