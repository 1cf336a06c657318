//! The table of the report, `speed-vs-error.csv`, as it is read.

use serde::{Deserialize, Serialize};

/// A row of `speed-vs-error.csv`; a cell may be empty.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Row {
    /// The model's id.
    pub model: String,
    /// The quantity.
    pub quantity: String,
    /// The method.
    pub method: String,
    /// The tolerance, of a method that has one.
    pub tolerance: String,
    /// Median time of one evaluation \[ns\], if it was taken.
    pub median_ns: String,
    /// Worst error on the hard grid, or a failure.
    pub max_relative_error: String,
}

/// The median; `None` without numbers.
#[must_use]
pub fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied()
}

/// The machine, which the first line names.
#[must_use]
pub fn machine(csv: &str) -> Option<&str> {
    csv.lines().next()?.strip_prefix("# measured on ")
}
