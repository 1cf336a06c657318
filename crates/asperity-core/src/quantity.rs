//! What can be asked of a contact, and how accurately.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::ContactError;

/// A quantity of the whole contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Normal contact force \[N\].
    Force,
    /// Real contact area \[m²\].
    Area,
    /// Stiffness \[N/m\] as the model's paper defines it: the tangent for the models of upright
    /// asperities, an average of asperity stiffnesses for Gao and AT.
    Stiffness,
    /// -dF/dd \[N/m\], jumps of the law included.
    Tangent,
}

impl Quantity {
    /// All quantities.
    pub const ALL: [Self; 4] = [Self::Force, Self::Area, Self::Stiffness, Self::Tangent];

    /// SI unit: `N`, `m2` or `N_per_m`, as in the heads of tables.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self {
            Self::Force => "N",
            Self::Area => "m2",
            Self::Stiffness | Self::Tangent => "N_per_m",
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Force => "force",
            Self::Area => "area",
            Self::Stiffness => "stiffness",
            Self::Tangent => "tangent",
        })
    }
}

/// A relative tolerance, from 1e-15 to 0.1.
///
/// The error of every value is below it; where a law has negative parts (the printed AT sum) it
/// is relative to the integral of the law's absolute value.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Serialize, Deserialize)]
#[serde(try_from = "f64", into = "f64")]
pub struct Tolerance(f64);

impl Tolerance {
    /// # Errors
    /// [`ContactError::OutOfRange`] unless 1e-15 ≤ `relative` ≤ 0.1.
    pub fn new(relative: f64) -> Result<Self, ContactError> {
        if (1e-15..=0.1).contains(&relative) {
            Ok(Self(relative))
        } else {
            let required = "a relative tolerance from 1e-15 to 0.1";
            Err(ContactError::OutOfRange { field: "tolerance", value: relative, required })
        }
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

impl FromStr for Quantity {
    type Err = String;

    /// Reads the names that [`Display`](fmt::Display) writes.
    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|q| q.to_string() == text).ok_or_else(|| {
            format!("{text:?} is no quantity: force, area, stiffness or tangent was required")
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_outside_their_range_are_refused_by_name() {
        for bad in [0.0, -1.0, 0.2, 1e-16, f64::NAN, f64::INFINITY] {
            let message = Tolerance::new(bad).unwrap_err().to_string();
            assert!(message.starts_with("tolerance is") && message.contains("1e-15"), "{message}");
        }
        assert!(serde_json::from_str::<Tolerance>("0").is_err());
    }

    #[test]
    fn names_read_back() {
        for quantity in Quantity::ALL {
            assert_eq!(quantity.to_string().parse(), Ok(quantity));
        }
        assert!("Force".parse::<Quantity>().is_err());
    }
}
