//! Requests: quantities, places and a tolerance.

pub(crate) mod quantity;
pub(crate) mod quantity_table;
pub(crate) mod separation;
pub(crate) mod tolerance;

use serde::{Deserialize, Serialize};

use crate::{At, Quantity, Tolerance};

/// Quantities, the places where they are wanted, and a tolerance.
///
/// Only the listed quantities are computed; shares are extra work and off by default.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[non_exhaustive]
pub struct Request {
    /// The quantities to compute, in this order.
    pub quantities: Vec<Quantity>,
    /// Separations or loads, one for each row of the answer.
    pub at: Vec<At>,
    /// Relative tolerance of every value.
    pub tolerance: Tolerance,
    /// Report the share of every part of the law in every value.
    pub shares: bool,
}

impl Request {
    /// A request for these quantities.
    #[must_use]
    pub fn new(quantities: impl IntoIterator<Item = Quantity>) -> Self {
        Self { quantities: quantities.into_iter().collect(), ..Self::default() }
    }

    /// At these separations or loads; plain numbers are separations d/σ_z from the mean of the
    /// asperity heights.
    #[must_use]
    pub fn at<T: Into<At>>(mut self, at: impl IntoIterator<Item = T>) -> Self {
        self.at = at.into_iter().map(Into::into).collect();
        self
    }

    /// Under these loads \[N\].
    #[must_use]
    pub fn at_loads(self, loads: impl IntoIterator<Item = f64>) -> Self {
        self.at(loads.into_iter().map(At::Load))
    }

    /// At separations in metres from the mean of the asperity heights.
    #[must_use]
    pub fn at_metres(self, separations: impl IntoIterator<Item = f64>) -> Self {
        self.at(separations.into_iter().map(At::metres))
    }

    /// To this tolerance.
    #[must_use]
    pub fn within(mut self, tolerance: Tolerance) -> Self {
        self.tolerance = tolerance;
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
