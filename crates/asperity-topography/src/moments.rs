//! Spectral moments of profiles, from differences of neighbouring points.

use asperity_core::ProfileMoments;

use crate::Topography;

/// The spectral moments of a surface and what they are made of.
///
/// ```text
/// m₂ = ⟨((z₁ - z₀)/dx)²⟩        m₄ = ⟨((z₂ - 2 z₁ + z₀)/dx²)²⟩
/// ```
///
/// over all neighbours that are both (all three) there, along rows and along columns; m₂ and m₄
/// are the mean of the two directions. A wave of length L is seen with a slope smaller by
/// (L/(π dx)) sin(π dx/L) and a curvature smaller by its square: 1.6 % and 3.3 % at ten points to
/// the wave. This is McCool's way of taking the moments from a sampled profile. \[recalled\]
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Moments {
    /// m₀, m₂ and m₄ of profiles, averaged over both directions.
    pub profile: ProfileMoments,
    /// ⟨z_x²⟩, ⟨z_xx²⟩ \[1/m²\] along rows.
    pub along_rows: [f64; 2],
    /// ⟨z_y²⟩, ⟨z_yy²⟩ \[1/m²\] along columns; a profile has none.
    pub along_columns: Option<[f64; 2]>,
    /// Areal moments; a profile has none.
    pub areal: Option<ArealMoments>,
}

/// Moments of the gradient and the Laplacian: 2 m₂ and (8/3) m₄ where a surface is isotropic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ArealMoments {
    /// ⟨z_x²⟩ + ⟨z_y²⟩.
    pub m2: f64,
    /// ⟨(z_xx + z_yy)²⟩ \[1/m²\].
    pub m4: f64,
}
