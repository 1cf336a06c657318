//! Summits: points above their eight neighbours.

/// The summits of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Summits {
    /// Heights \[m\] above the mean plane.
    pub heights: Vec<f64>,
    /// Mean curvature \[1/m\] of each.
    pub curvatures: Vec<f64>,
    /// Area that was searched \[m²\].
    pub area: f64,
}
