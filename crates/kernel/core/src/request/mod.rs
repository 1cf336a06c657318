//! The request: quantities, separations or loads, tolerance.

pub(crate) mod quantity;
pub(crate) mod quantity_table;
pub(crate) mod separation;

use serde::{Deserialize, Serialize};

use crate::error::require;
use crate::{At, ContactError, Quantity};

/// Quantities, the separations or loads at which they are wanted, and a tolerance.
///
/// Only the listed quantities are computed.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
#[non_exhaustive]
pub struct Request {
    /// Quantities to compute, in this order.
    pub quantities: Vec<Quantity>,
    /// Separations or loads, one for each row of the response.
    pub at: Vec<At>,
    /// Relative tolerance of every value.
    pub tolerance: Tolerance,
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

    /// With this tolerance.
    #[must_use]
    pub fn within(mut self, tolerance: Tolerance) -> Self {
        self.tolerance = tolerance;
        self
    }
}

/// A relative tolerance, from 1e-15 to 0.1.
///
/// The error of every value is below it, but for rounding: of places and of the logarithms of
/// heights that are not Gaussian, where the density is steep (some 1e-11 at eight standard
/// deviations), and of what underflows f64. Bounds include it. For a law with negative parts (AT as
/// printed) the error is relative to the integral of the law's absolute value.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(try_from = "f64")]
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

/// `count` ≥ 2 evenly spaced numbers from `first` to `last`, both included.
#[must_use]
pub fn linspace(first: f64, last: f64, count: usize) -> Vec<f64> {
    let steps = count.saturating_sub(1).max(1) as f64;
    let at = |k: usize| match k {
        // Rounding would take some ends beyond.
        end if end > 0 && end + 1 == count => last,
        _ => first + (last - first) * k as f64 / steps,
    };
    (0..count).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::linspace;

    #[test]
    fn no_number_lies_beyond_the_ends() {
        for last in [1.486_116_574_882_939e-8, 0.1, 1.0 / 3.0, 7e22] {
            for count in [2, 3, 51, 101, 1001] {
                let all = linspace(-last, last, count);
                assert!(all.iter().all(|x| x.abs() <= last), "{last} {count}");
                assert_eq!((all.len(), all[0], all[count - 1]), (count, -last, last));
            }
        }
        assert_eq!(linspace(1.0, 2.0, 1), [1.0]);
    }
}
