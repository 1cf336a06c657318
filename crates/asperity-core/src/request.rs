//! What is asked of a scene.

use serde::{Deserialize, Serialize};

use crate::{ContactError, Quantity, Tolerance};

/// Quantities, separations and a tolerance.
///
/// Only what is listed is computed; bounds and shares are extra work and off unless asked for.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// What to compute, in this order.
    pub quantities: Vec<Quantity>,
    /// Separations d/σ_z, from the mean of the asperity heights.
    #[serde(default)]
    pub separations: Vec<f64>,
    /// Relative tolerance of every value.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Relative rounding error of the separations as given: 0 for exact multiples of σ_z, 2^-52
    /// when they were divided by σ_z. Bounds include what it does to the value.
    #[serde(default)]
    pub separation_rounding: f64,
    /// Report a bound on the error of every value.
    #[serde(default)]
    pub bounds: bool,
    /// Report the share of every regime in every value.
    #[serde(default)]
    pub shares: bool,
}

impl Request {
    /// Asks for these quantities.
    #[must_use]
    pub fn new(quantities: impl IntoIterator<Item = Quantity>) -> Self {
        Self {
            quantities: quantities.into_iter().collect(),
            separations: vec![],
            tolerance: Tolerance::default(),
            separation_rounding: 0.0,
            bounds: false,
            shares: false,
        }
    }

    /// At separations d/σ_z.
    #[must_use]
    pub fn at(mut self, separations: impl IntoIterator<Item = f64>) -> Self {
        self.separations = separations.into_iter().collect();
        self.separation_rounding = 0.0;
        self
    }

    /// At separations in metres, on a surface with this `asperity_height_std` \[m\].
    #[must_use]
    pub fn at_metres(
        mut self,
        separations: impl IntoIterator<Item = f64>,
        asperity_height_std: f64,
    ) -> Self {
        self.separations = separations.into_iter().map(|d| d / asperity_height_std).collect();
        self.separation_rounding = f64::EPSILON;
        self
    }

    /// To this tolerance.
    #[must_use]
    pub fn within(mut self, tolerance: Tolerance) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// With a bound on the error of every value.
    #[must_use]
    pub fn with_bounds(mut self) -> Self {
        self.bounds = true;
        self
    }

    /// With the share of every regime in every value.
    #[must_use]
    pub fn with_shares(mut self) -> Self {
        self.shares = true;
        self
    }
}

/// `count` ≥ 2 evenly spaced numbers from `first` to `last`, both included.
#[must_use]
pub fn linspace(first: f64, last: f64, count: usize) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|k| first + (last - first) * k as f64 / steps).collect()
}

/// `separation` if an integral can be given there.
pub(crate) fn checked_separation(separation: f64) -> Result<f64, ContactError> {
    if (-1e6..=1e9).contains(&separation) {
        Ok(separation)
    } else {
        let required = "a number of asperity_height_std from -1e6 to 1e9";
        Err(ContactError::OutOfRange { field: "separation", value: separation, required })
    }
}
