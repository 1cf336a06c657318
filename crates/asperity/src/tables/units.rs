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

/// What a system is made of. Both ways numbers are changed by powers of ten above 1, which are
/// exact.
struct Units {
    /// Lengths in a metre.
    per_metre: f64,
    /// The pressure \[Pa\].
    pascals: f64,
    /// The conductance \[W/(m² K)\].
    watts: f64,
    length: &'static str,
    pressure: &'static str,
    conductance: &'static str,
    /// Comments on conversion; nothing for SI.
    converted: Option<[&'static str; 2]>,
}

const SI: Units = Units {
    per_metre: 1.0,
    pascals: 1.0,
    watts: 1.0,
    length: "m",
    pressure: "Pa",
    conductance: "W/(m2 K)",
    converted: None,
};

const MM_TONNE_S: Units = Units {
    per_metre: 1e3,
    pascals: 1e6,
    watts: 1e3,
    length: "mm",
    pressure: "MPa",
    conductance: "mW/(mm2 K)",
    converted: Some([
        "units: mm, N, MPa (tonne, s), converted from SI: 1 m = 1e3 mm, 1 Pa = 1e-6 MPa",
        "1 W/(m2 K) = 1e-3 mW/(mm2 K): power is in mW (N mm/s), as conductivities in mW/(mm K) are",
    ]),
};

impl UnitSystem {
    fn units(self) -> &'static Units {
        match self {
            Self::Si => &SI,
            Self::MmTonneS => &MM_TONNE_S,
        }
    }

    /// A length given in metres.
    pub(crate) fn length(self, metres: f64) -> f64 {
        metres * self.units().per_metre
    }

    /// An area given in m².
    pub(crate) fn area(self, square_metres: f64) -> f64 {
        square_metres * self.units().per_metre.powi(2)
    }

    /// A pressure given in Pa.
    pub(crate) fn pressure(self, pascals: f64) -> f64 {
        pascals / self.units().pascals
    }

    /// A pressure over a length, given in Pa/m.
    pub(crate) fn slope(self, pascals_per_metre: f64) -> f64 {
        pascals_per_metre / (self.units().pascals * self.units().per_metre)
    }

    /// A conductance given in W/(m² K).
    pub(crate) fn conductance(self, watts: f64) -> f64 {
        watts / self.units().watts
    }

    /// The unit of lengths.
    pub(crate) fn of_length(self) -> &'static str {
        self.units().length
    }

    /// The unit of pressures.
    pub(crate) fn of_pressure(self) -> &'static str {
        self.units().pressure
    }

    /// The unit of conductances.
    pub(crate) fn of_conductance(self) -> &'static str {
        self.units().conductance
    }

    /// The comment on conversion of lengths and pressures; empty for SI.
    pub(crate) fn conversion(self, comment: &str) -> String {
        let line = |[lengths, _]: [&str; 2]| format!("{comment} {lengths}\n");
        self.units().converted.map(line).unwrap_or_default()
    }

    /// The comment on conversion of conductances; empty for SI.
    pub(crate) fn conductance_conversion(self, comment: &str) -> String {
        let line = |[_, conductances]: [&str; 2]| format!("{comment} {conductances}\n");
        self.units().converted.map(line).unwrap_or_default()
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
