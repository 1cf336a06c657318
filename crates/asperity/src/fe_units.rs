//! The units that a table is written in.

use std::str::FromStr;

/// A system of units that finite-element models are made in. Forces are in N in all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum UnitSystem {
    /// m, Pa, W.
    #[default]
    Si,
    /// mm, N, MPa; with masses in tonnes and seconds, so that powers are in mW (N mm/s).
    MmTonneS,
}

impl UnitSystem {
    /// A length of so many metres.
    pub(crate) fn length(self, metres: f64) -> f64 {
        if self == Self::Si { metres } else { metres * 1e3 }
    }

    /// An area of so many m².
    pub(crate) fn area(self, square_metres: f64) -> f64 {
        if self == Self::Si { square_metres } else { square_metres * 1e6 }
    }

    /// A pressure of so many Pa.
    pub(crate) fn pressure(self, pascals: f64) -> f64 {
        if self == Self::Si { pascals } else { pascals / 1e6 }
    }

    /// A pressure over a length, of so many Pa/m.
    pub(crate) fn slope(self, pascals_per_metre: f64) -> f64 {
        if self == Self::Si { pascals_per_metre } else { pascals_per_metre / 1e9 }
    }

    /// A conductance of so many W/(m² K).
    pub(crate) fn conductance(self, watts: f64) -> f64 {
        if self == Self::Si { watts } else { watts / 1e3 }
    }

    /// What lengths are in.
    pub(crate) fn of_length(self) -> &'static str {
        if self == Self::Si { "m" } else { "mm" }
    }

    /// What pressures are in.
    pub(crate) fn of_pressure(self) -> &'static str {
        if self == Self::Si { "Pa" } else { "MPa" }
    }

    /// What conductances are in.
    pub(crate) fn of_conductance(self) -> &'static str {
        if self == Self::Si { "W/(m2 K)" } else { "mW/(mm2 K)" }
    }

    /// A comment that says what was converted; nothing for SI.
    pub(crate) fn told(self, comment: &str) -> String {
        if self == Self::Si {
            return String::new();
        }
        format!(
            "{comment} units: mm, N, MPa (tonne, s), converted from SI: 1 m = 1e3 mm, 1 Pa = 1e-6 MPa\n"
        )
    }
}

impl FromStr for UnitSystem {
    type Err = String;

    /// Reads `SI`, `mm-N-MPa` and, the same, `mm-tonne-s`, in any case.
    fn from_str(name: &str) -> Result<Self, String> {
        match name.trim().to_lowercase().as_str() {
            "si" => Ok(Self::Si),
            "mm-n-mpa" | "mm-tonne-s" => Ok(Self::MmTonneS),
            _ => Err(format!("{name:?} is none of SI, mm-N-MPa, mm-tonne-s")),
        }
    }
}
