//! What fills the gap between the surfaces: the section `[gap]`.

use serde::Serialize;

/// A gas or liquid in the gap between the surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gas {
    /// Its thermal conductivity \[W/(m K)\], above 0.
    pub gas_conductivity: f64,
    /// Its temperature-jump distance \[m\], 0 for a liquid.
    pub gas_parameter: f64,
}
