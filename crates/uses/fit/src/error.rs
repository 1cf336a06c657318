//! Why a fit is refused.

use asperity_core::{ContactError, nearest_hint, short};

use crate::Position;

/// Why data or parameters are refused, or a fit ended.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// A column that is no load, separation or quantity.
    #[error("column {name:?} is not known{}: the columns are {known}, each also with _std", nearest_hint(.near.as_ref()))]
    UnknownColumn {
        /// The name of the column.
        name: String,
        /// The nearest known name, if one is near.
        near: Option<String>,
        /// All known names.
        known: String,
    },
    /// Columns that do not make a table of measurements.
    #[error("{column}: {reason}")]
    Column {
        /// The column.
        column: String,
        /// The reason, and what is required.
        reason: String,
    },
    /// A number of the data that is out of its range.
    #[error("{position}: {column} is {}: {required} was required", short(*.value))]
    Value {
        /// The line in its file, or the row, both counted from 1: `line 5`.
        position: Position,
        /// The column.
        column: String,
        /// The number given.
        value: f64,
        /// The numbers accepted.
        required: String,
    },
    /// Data that contradict each other or are too few.
    #[error("{0}")]
    Data(String),
    /// Bounds or a start that no fit can use.
    #[error("{parameter}: {reason}")]
    Parameter {
        /// The free parameter.
        parameter: String,
        /// The reason, and what is required.
        reason: String,
    },
    /// A model gives none of the data anywhere within the bounds.
    #[error("{model} has no value for the data at any start within the bounds, first: {reason}")]
    NoStart {
        /// The model's id.
        model: String,
        /// The reason at the start.
        reason: ContactError,
    },
    /// The caller stopped the fit.
    #[error("interrupted")]
    Interrupted,
}
