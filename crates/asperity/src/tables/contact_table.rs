//! Pressure against separation as a table that a finite-element code can interpolate.

use crate::tables::format::Interpolation;

/// One node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactNode {
    /// d/σ_z, from the mean of the asperity heights.
    pub separation: f64,
    /// Force over nominal area \[Pa\].
    pub pressure: f64,
    /// -dp/dd \[Pa/m\], jumps of the law included.
    pub stiffness: f64,
}

/// Pressure and stiffness at nodes, and bounds of the error between them.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactTable {
    /// Ascending separations; pressure falls, all pressures and stiffnesses are positive.
    pub nodes: Vec<ContactNode>,
    /// How it is read between the nodes.
    pub interpolation: Interpolation,
    /// Bound of the relative error of the pressure between the nodes.
    pub pressure_error: f64,
    /// Bound of the relative error of the stiffness between the nodes.
    pub stiffness_error: f64,
    /// σ_z \[m\].
    pub asperity_height_std: f64,
}

impl ContactTable {
    /// The separation over σ_z at which the tangent of the last node reaches pressure 0: a table
    /// that ends there has no kink at the last node. The model's own pressure beyond the last node
    /// is below that node's.
    #[must_use]
    pub fn cut_off(&self) -> Option<f64> {
        let last = self.nodes.last()?;
        Some(last.separation + last.pressure / last.stiffness / self.asperity_height_std)
    }
}
