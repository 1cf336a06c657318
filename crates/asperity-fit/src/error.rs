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
    /// A column in another unit than the one of its name.
    #[error("column {name:?} is in {unit}: name it {column} and multiply its values by {}", short(*.factor))]
    ColumnUnit {
        /// The name of the column.
        name: String,
        /// The column in its SI unit.
        column: String,
        /// The unit of the name.
        unit: &'static str,
        /// The unit in SI units.
        factor: f64,
    },
    /// A stiffness per nominal area.
    #[error(
        "column {name:?} is per nominal area: name it {column} and multiply its values, in N/m per m2, by the nominal area{}",
        .nominal_area.map_or(String::new(), |area| format!(" of {} m2", short(area)))
    )]
    PerArea {
        /// The name of the column.
        name: String,
        /// The column of the stiffness.
        column: String,
        /// The nominal area \[m²\], if it is known.
        nominal_area: Option<f64>,
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
    /// A column that is shorter than others.
    #[error(
        "{column} has {found} {}: {required} were required, as in the other columns",
        if *.found == 1 { "value" } else { "values" }
    )]
    Length {
        /// The column.
        column: String,
        /// The number of its values.
        found: usize,
        /// The number of values of other columns.
        required: usize,
    },
    /// A value without a standard deviation beside others that have one.
    #[error(
        "{position} has no standard deviation of {column}, but {known} has one: give {column}_std in every {}, or in none",
        .position.name
    )]
    NoStd {
        /// The line in its file, or the row, both counted from 1: `line 5`.
        position: Position,
        /// The column.
        column: String,
        /// The value that has one, `line 2` or `area_m2 of line 2`.
        known: String,
    },
    /// A load and a pressure of one row that contradict each other.
    #[error(
        "{position}: load_N = {} and pressure_Pa = {} contradict each other: on the nominal area of {} m2 this pressure is a load of {} N; leave one of the two columns out, or correct the area",
        short(*.load), short(*.pressure), short(*.nominal_area), short(.pressure * .nominal_area)
    )]
    Loads {
        /// The line in its file, or the row, both counted from 1: `line 5`.
        position: Position,
        /// The load \[N\].
        load: f64,
        /// The pressure \[Pa\].
        pressure: f64,
        /// The nominal area \[m²\].
        nominal_area: f64,
    },
    /// Data without a load or separation, or without a quantity.
    #[error("the data have no {missing}: {needed}")]
    NoData {
        /// The missing part.
        missing: &'static str,
        /// The columns that are accepted.
        needed: String,
    },
    /// Fewer data than parameters.
    #[error(
        "{data} measured {} for {parameters} free parameters: at least as many values as free parameters were required",
        if *.data == 1 { "value" } else { "values" }
    )]
    TooFew {
        /// The number of measured values.
        data: usize,
        /// The number of free parameters.
        parameters: usize,
    },
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
    /// A model gives the data in another unit only.
    #[error("{model} has no value for the data within the bounds; {likely}")]
    Unit {
        /// The model's id.
        model: String,
        /// The columns and the units that explain the data.
        likely: String,
    },
    /// The caller stopped the fit.
    #[error("interrupted")]
    Interrupted,
}
