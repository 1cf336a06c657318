//! Options of the lateral models.

use asperity_core::{ContactError, require};
use serde::{Deserialize, Serialize};

use crate::AngleDensity;

/// The tangential displacements ζ* and ξ* of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"vertical\" or \"none\" or { zeta = 0.1, xi = 0.1 }"
)]
pub enum Displacement {
    /// ζ* = ξ* = λ x: the vertical approach in the normal and in both tangential directions. The
    /// paper leaves the two open; this closure is derived.
    #[default]
    Vertical,
    /// ζ* = ξ* = 0: no tangential force. K_i keeps its tangential term.
    None,
    /// Given, dimensionless, ≥ 0.
    #[serde(untagged)]
    Given {
        /// ζ*.
        zeta: f64,
        /// ξ*.
        xi: f64,
    },
}

/// Whether tangential forces are limited by friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Stick {
    /// T ≤ μN in every regime.
    #[default]
    Clamped,
    /// The AT paper taken literally: T = 1.5 r ζ* s |sin θ| without limit in e, ep1 and p. Friction
    /// limits T in ep2 only (its equation 23), and in the elastic-plastic part of Gao.
    Unlimited,
}

/// The force that is summed over the contacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ForceComponent {
    /// The magnitude of the contact force, as in the paper.
    #[default]
    Size,
    /// The vertical component, N u + T s.
    Vertical,
}

/// Options of Gao and AT.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct LateralOptions {
    /// The density of the contact normals over angles.
    pub angle_density: AngleDensity,
    /// The tangential displacements.
    pub displacement: Displacement,
    /// Whether tangential forces are limited by friction.
    pub stick: Stick,
    /// The force that is summed.
    pub force: ForceComponent,
}

impl LateralOptions {
    /// Checks the ranges of the numbers.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] naming the number.
    pub fn check(&self) -> Result<(), ContactError> {
        self.angle_density.check()?;
        if let Displacement::Given { zeta, xi } = self.displacement {
            for (field, value) in [("zeta", zeta), ("xi", xi)] {
                let holds = value >= 0.0 && value.is_finite();
                require(holds, field, value, "a finite number, at least 0,")?;
            }
        }
        Ok(())
    }
}
