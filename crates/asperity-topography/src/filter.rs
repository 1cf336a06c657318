//! The Gaussian filter of ISO 16610-21 (profiles) and 16610-61 (areal).

use crate::{Topography, TopographyError};

impl Topography {
    /// Roughness.
    ///
    /// # Errors
    /// [`TopographyError`].
    pub fn filter(self, _cutoff: f64) -> Result<Self, TopographyError> {
        Ok(self)
    }
}
