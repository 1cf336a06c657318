//! The relative tolerance of a request.

use serde::{Deserialize, Serialize};

use crate::ContactError;
use crate::error::require;

/// A relative tolerance, from 1e-15 to 0.1.
///
/// The error of every value is below it, but for rounding: of places and of the logarithms of
/// heights that are not Gaussian, where the density is steep (some 1e-11 at eight standard
/// deviations), and of what underflows f64. Bounds include it. For a law with negative parts (AT as
/// printed) the error is relative to the integral of the law's absolute value.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(try_from = "f64", into = "f64")]
pub struct Tolerance(f64);

impl Tolerance {
    /// A tolerance from 1e-15 to 0.1.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] unless 1e-15 ≤ `relative` ≤ 0.1.
    pub fn new(relative: f64) -> Result<Self, ContactError> {
        let required = "a relative tolerance from 1e-15 to 0.1";
        require((1e-15..=0.1).contains(&relative), "tolerance", relative, required).map(Self)
    }

    /// The number.
    #[must_use]
    pub fn relative(self) -> f64 {
        self.0
    }
}

impl Default for Tolerance {
    /// 1e-10.
    fn default() -> Self {
        Self(1e-10)
    }
}

impl TryFrom<f64> for Tolerance {
    type Error = ContactError;
    fn try_from(relative: f64) -> Result<Self, ContactError> {
        Self::new(relative)
    }
}

impl From<Tolerance> for f64 {
    fn from(tolerance: Tolerance) -> Self {
        tolerance.0
    }
}
