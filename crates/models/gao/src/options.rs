//! Options of the lateral models, with the density of the contact normals over angles.

use asperity_core::{ContactError, require};
use serde::{Deserialize, Serialize};

/// The density of the contact normals over u = |cos φ|, from 0 (grazing) to 1 (upright).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"upright\" or { a20 = -0.5, a21 = 1.0, b21 = 1.0 }"
)]
pub enum AngleDensity {
    /// All normals upright: u = 1.
    Upright,
    /// 4π ψ = 1 + a₂₀ P₂(cos φ) + (a₂₁ cos θ + b₂₁ sin θ) P₂¹(cos φ).
    ///
    /// A normal and its opposite belong to the same contact, so the density is folded to
    /// 1 + a₂₀ (3u² - 1)/2; the P₂¹ terms cancel in every law.
    #[serde(untagged)]
    Harmonic {
        /// a₂₀, from -1 to 2.
        a20: f64,
        /// a₂₁; changes no result.
        a21: f64,
        /// b₂₁; changes no result.
        b21: f64,
    },
}

impl Default for AngleDensity {
    /// The AT paper's: a₂₀ = -0.5, a₂₁ = b₂₁ = 1.
    fn default() -> Self {
        Self::Harmonic { a20: -0.5, a21: 1.0, b21: 1.0 }
    }
}

impl AngleDensity {
    /// # Errors
    /// [`ContactError::OutOfRange`] when the folded density would be negative, or an input is not
    /// finite.
    pub fn check(&self) -> Result<(), ContactError> {
        let Self::Harmonic { a20, a21, b21 } = *self else {
            return Ok(());
        };
        let required = "from -1 to 2, or the density is negative,";
        require((-1.0..=2.0).contains(&a20), "a20", a20, required)?;
        require(a21.is_finite(), "a21", a21, "a finite number")?;
        require(b21.is_finite(), "b21", b21, "a finite number").map(drop)
    }

    /// 4π ψ at polar angle φ and azimuth θ \[rad\], all terms included; 0 for upright normals,
    /// whose density is not a function.
    #[must_use]
    pub fn printed(&self, phi: f64, theta: f64) -> f64 {
        let Self::Harmonic { a20, a21, b21 } = *self else {
            return 0.0;
        };
        let (s, u) = phi.sin_cos();
        // P₂¹ = -3 cos φ sin φ.
        1.0 + 0.5 * a20 * (3.0 * u * u - 1.0)
            - 3.0 * u * s * (a21 * theta.cos() + b21 * theta.sin())
    }

    /// c₀ and c₂ of the folded density c₀ + c₂ u²; `None` for upright normals.
    #[must_use]
    pub fn folded(&self) -> Option<(f64, f64)> {
        match *self {
            Self::Upright => None,
            Self::Harmonic { a20, .. } => Some((1.0 - 0.5 * a20, 1.5 * a20)),
        }
    }
}

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

#[cfg(test)]
mod tests {
    use super::AngleDensity;

    #[test]
    fn the_folded_density_is_not_negative() {
        for (a20, ok) in [(-1.0, true), (2.0, true), (-1.01, false), (f64::NAN, false)] {
            assert_eq!(AngleDensity::Harmonic { a20, a21: 0.0, b21: 0.0 }.check().is_ok(), ok);
        }
    }
}
