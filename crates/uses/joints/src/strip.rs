//! The parts of a table of unloading forces.

/// Terms in each direction.
pub(crate) const TERMS: usize = 8;

/// A range of closest approaches.
#[derive(Debug, Clone)]
pub(crate) struct Strip {
    /// Start of the range \[m\], and 2 over its length \[1/m\].
    pub(crate) from: f64,
    pub(crate) scale: f64,
    /// Ascending in u.
    pub(crate) cells: Vec<StripCell>,
}

/// Retreats from `from` to `to`.
#[derive(Debug, Clone)]
pub(crate) struct StripCell {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Coefficients of Tᵢ(c) Tⱼ(u), `terms[i][j]`.
    pub(crate) terms: [[f64; TERMS]; TERMS],
    /// Lower limit of the force \[N\]: 0, or minus infinity if the model has tensile forces.
    pub(crate) least: f64,
}
