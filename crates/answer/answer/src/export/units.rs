//! The units that a table is written in.

use std::str::FromStr;

/// A system of units that finite-element models are made in. Forces are in N in all of them, and
/// numbers are changed by powers of ten above 1, which are exact both ways.
#[derive(Debug, Clone, Copy)]
pub struct UnitSystem {
    /// Lengths in a metre.
    pub(crate) per_metre: f64,
    /// The pressure \[Pa\].
    pub(crate) pascals: f64,
    /// The conductance \[W/(m² K)\].
    pub(crate) watts: f64,
    pub(crate) length: &'static str,
    pub(crate) pressure: &'static str,
    pub(crate) conductance: &'static str,
    /// Comments on conversion of lengths and of conductances; none for SI.
    converted: [&'static str; 2],
}

impl UnitSystem {
    /// m, Pa, W.
    pub const SI: Self = Self {
        per_metre: 1.0,
        pascals: 1.0,
        watts: 1.0,
        length: "m",
        pressure: "Pa",
        conductance: "W/(m2 K)",
        converted: [""; 2],
    };
    /// mm, N, MPa; with masses in tonnes and seconds, so that powers are in mW (N mm/s).
    pub const MM_TONNE_S: Self = Self {
        per_metre: 1e3,
        pascals: 1e6,
        watts: 1e3,
        length: "mm",
        pressure: "MPa",
        conductance: "mW/(mm2 K)",
        converted: [
            "units: mm, N, MPa (tonne, s), converted from SI: 1 m = 1e3 mm, 1 Pa = 1e-6 MPa",
            "1 W/(m2 K) = 1e-3 mW/(mm2 K): power is in mW (N mm/s), as conductivities in mW/(mm K) are",
        ],
    };

    /// A pressure over a length, given in Pa/m.
    pub(crate) fn slope(&self, pascals_per_metre: f64) -> f64 {
        pascals_per_metre / (self.pascals * self.per_metre)
    }

    /// The lines on conversion of lengths (0) and conductances (1) behind this sign of a comment.
    pub(crate) fn conversion(&self, of: usize, comment: &str) -> String {
        match self.converted[of] {
            "" => String::new(),
            line => format!("{comment} {line}\n"),
        }
    }
}

impl FromStr for UnitSystem {
    type Err = String;

    /// Reads `SI`, `mm-N-MPa` and, the same, `mm-tonne-s`, in any case.
    fn from_str(name: &str) -> Result<Self, String> {
        match name.trim().to_lowercase().as_str() {
            "si" => Ok(Self::SI),
            "mm-n-mpa" | "mm-tonne-s" => Ok(Self::MM_TONNE_S),
            _ => Err(format!("{name:?} is none of SI, mm-N-MPa, mm-tonne-s")),
        }
    }
}
