//! The measured density of asperity heights.

use serde::Serialize;

/// A density of heights, linear between its points and 0 outside; its integral is 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeightDensity {
    /// Heights \[m\] above the mean of the asperity heights, ascending.
    pub heights_m: Vec<f64>,
    /// Density at these heights \[1/m\]; 0 at the first and the last.
    pub density_per_m: Vec<f64>,
}
