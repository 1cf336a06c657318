//! A solved case with the results of boundary elements and of the models.

use serde::Serialize;

/// One surface, one material and one load.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct EvidenceCase {
    /// m₀ m₄/m₂².
    pub alpha: f64,
    /// ψ = √(σ_z/w_c); 0 for elastic cases.
    pub plasticity_index: f64,
    /// p/(E g), with the root mean square gradient g.
    pub load: f64,
    /// Boundary elements: the mean of several surfaces.
    pub bem: EvidenceRow,
    /// Results of the models, by id.
    #[serde(skip)]
    pub models: Vec<(String, EvidenceRow)>,
}

/// Dimensionless results; `None` if not available.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// Real over nominal area.
    pub area_fraction: Option<f64>,
    /// Smallest and largest value of the surfaces.
    pub area_span: Option<[f64; 2]>,
    /// -dp/d(gap) √m₀/E.
    pub stiffness: Option<f64>,
    /// Smallest and largest value of the surfaces.
    pub stiffness_span: Option<[f64; 2]>,
}
