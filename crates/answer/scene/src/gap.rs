//! What fills the gap between the surfaces: the section `[gap]`.

use asperity::ContactError;
use asperity::joints::conductance::gap_conductance;
use serde::Serialize;

use crate::document::Document;
use crate::error::SceneError;

/// A gas or liquid in the gap between the surfaces.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Gas {
    /// Its thermal conductivity \[W/(m K)\], above 0.
    #[serde(rename = "gas_conductivity")]
    pub conductivity: f64,
    /// Its temperature-jump distance \[m\], 0 for a liquid.
    #[serde(rename = "gas_parameter")]
    pub parameter: f64,
}

/// The gas of the section `[gap]`.
pub(crate) fn gas(document: &Document<'_>) -> Result<Option<Gas>, SceneError> {
    if !document.has("gap") {
        return Ok(None);
    }
    let conductivity = document.needed_number("gap.gas_conductivity")?;
    let parameter = document.needed_number("gap.gas_parameter")?;
    Ok(Some(Gas { conductivity, parameter }))
}

impl Gas {
    /// Checks its numbers.
    pub(crate) fn check(&self) -> Result<(), ContactError> {
        let found = gap_conductance(self.conductivity, 1.0, self.parameter);
        found.map(drop).map_err(|error| match error {
            ContactError::OutOfRange { field: "thermal_conductivity", value, required } => {
                ContactError::OutOfRange { field: "gas_conductivity", value, required }
            }
            error => error,
        })
    }
}
