//! One of the two bodies in contact.

use serde::{Deserialize, Serialize};

use crate::ContactError;
use crate::error::{positive, require};

/// Hardness over yield strength when only one of them is known (Tabor's ratio, as the JG and KE
/// papers use it). \[seen\]
pub const HARDNESS_OVER_YIELD: f64 = 2.8;

/// One elastic-plastic body.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Body {
    /// Young's modulus \[Pa\], > 0.
    pub youngs_modulus: f64,
    /// Poisson's ratio, in (-1, 0.5].
    pub poissons_ratio: f64,
    /// Hardness \[Pa\]; 2.8 times the yield strength if not given. Without either, the body never
    /// yields: only the elastic models (GW, Persson, DMT, JKR) apply.
    #[serde(default)]
    pub hardness: Option<f64>,
    /// Yield strength \[Pa\]; the hardness over 2.8 if not given.
    #[serde(default)]
    pub yield_strength: Option<f64>,
    /// E_t \[Pa\], the slope of stress over strain beyond yielding, at least 0 and below E; used
    /// by Ghaednia's law only.
    #[serde(default)]
    pub tangent_modulus: Option<f64>,
    /// Thermal conductivity k \[W/(m K)\]; used by the thermal conductance only.
    #[serde(default)]
    pub thermal_conductivity: Option<f64>,
    /// Electrical resistivity ρ \[Ω m\]; used by the electrical conductance only.
    #[serde(default)]
    pub electrical_resistivity: Option<f64>,
}

impl Body {
    /// A body with this hardness.
    #[must_use]
    pub fn new(youngs_modulus: f64, poissons_ratio: f64, hardness: f64) -> Self {
        Self { hardness: Some(hardness), ..Self::elastic(youngs_modulus, poissons_ratio) }
    }

    /// A body with this yield strength \[Pa\]; the hardness follows.
    #[must_use]
    pub fn yielding(youngs_modulus: f64, poissons_ratio: f64, yield_strength: f64) -> Self {
        let yield_strength = Some(yield_strength);
        Self { yield_strength, ..Self::elastic(youngs_modulus, poissons_ratio) }
    }

    /// A body that never yields, such as rubber: for GW, Persson, DMT and JKR only.
    #[must_use]
    pub fn elastic(youngs_modulus: f64, poissons_ratio: f64) -> Self {
        Self {
            youngs_modulus,
            poissons_ratio,
            hardness: None,
            yield_strength: None,
            tangent_modulus: None,
            thermal_conductivity: None,
            electrical_resistivity: None,
        }
    }

    /// Checks every field; returns hardness and yield strength \[Pa\], if there is either.
    pub(super) fn check(&self) -> Result<(Option<f64>, Option<f64>), ContactError> {
        positive("youngs_modulus", self.youngs_modulus)?;
        poissons_ratio(self.poissons_ratio)?;
        check_tangent_modulus(self.tangent_modulus, self.youngs_modulus)?;
        check_conduction(self.thermal_conductivity, self.electrical_resistivity)?;
        hardness_and_yield(self.hardness, self.yield_strength)
    }

    /// (1-ν²)/E and (2-ν)/G with G = E/(2(1+ν)).
    pub(super) fn compliances(&self) -> (f64, f64) {
        let (e, nu) = (self.youngs_modulus, self.poissons_ratio);
        ((1.0 - nu * nu) / e, (2.0 - nu) * 2.0 * (1.0 + nu) / e)
    }
}

pub(super) fn poissons_ratio(value: f64) -> Result<f64, ContactError> {
    let required = "a number above -1 and at most 0.5";
    require(value > -1.0 && value <= 0.5, "poissons_ratio", value, required)
}

/// E_t is at least 0 and below Young's modulus \[Pa\].
pub(super) fn check_tangent_modulus(
    tangent: Option<f64>,
    youngs_modulus: f64,
) -> Result<(), ContactError> {
    let required = "at least 0 and less than Young's modulus";
    let holds = |value: f64| (0.0..youngs_modulus).contains(&value);
    tangent.map_or(Ok(()), |e| require(holds(e), "tangent_modulus", e, required).map(drop))
}

pub(super) fn check_conduction(
    conductivity: Option<f64>,
    resistivity: Option<f64>,
) -> Result<(), ContactError> {
    conductivity.map(|k| positive("thermal_conductivity", k)).transpose()?;
    resistivity.map(|rho| positive("electrical_resistivity", rho)).transpose()?;
    Ok(())
}

/// Each is derived from the other if only one is given.
pub(super) fn hardness_and_yield(
    hardness: Option<f64>,
    yield_strength: Option<f64>,
) -> Result<(Option<f64>, Option<f64>), ContactError> {
    let hardness = hardness.map(|h| positive("hardness", h)).transpose()?;
    let yield_strength = yield_strength.map(|y| positive("yield_strength", y)).transpose()?;
    let by_yield = yield_strength.map(|y| y * HARDNESS_OVER_YIELD);
    let by_hardness = hardness.map(|h| h / HARDNESS_OVER_YIELD);
    Ok((hardness.or(by_yield), yield_strength.or(by_hardness)))
}
