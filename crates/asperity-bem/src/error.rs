//! Errors: the field, what was found and what was required.

/// Why a contact could not be solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BemError {
    /// There are more or fewer heights than pixels.
    #[error("heights: {found} numbers were found, {rows} x {columns} were required")]
    Count {
        /// How many there are.
        found: usize,
        /// Rows of the map.
        rows: usize,
        /// Columns of the map.
        columns: usize,
    },
    /// The map has too few rows or columns.
    #[error("{field} is {found}: {required} was required")]
    Size {
        /// `rows` or `columns`.
        field: &'static str,
        /// How many there are.
        found: usize,
        /// How many there should be.
        required: &'static str,
    },
    /// A height is missing or infinite.
    #[error(
        "the height in row {row}, column {column} is {found}: a finite number was required (fill or cut off missing points first)"
    )]
    Height {
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// What stands there.
        found: f64,
    },
    /// An input is out of range.
    #[error("{field} is {found}: {required} was required")]
    OutOfRange {
        /// Name of the field.
        field: &'static str,
        /// What it is.
        found: f64,
        /// What it should be.
        required: &'static str,
    },
    /// The load exceeds that of a fully plastic contact.
    #[error(
        "mean pressure is {pressure:e} Pa: less than the hardness, {hardness:e} Pa, was required"
    )]
    CannotBeCarried {
        /// Mean pressure asked for \[Pa\].
        pressure: f64,
        /// Hardness \[Pa\].
        hardness: f64,
    },
    /// The gap exceeds the height of the highest point: there is no contact.
    #[error(
        "mean gap is {gap:e} m: less than the height of the highest point above the mean, {highest:e} m, was required (nothing touches)"
    )]
    NothingTouches {
        /// Mean gap asked for \[m\].
        gap: f64,
        /// Height of the highest point above the mean plane \[m\].
        highest: f64,
    },
    /// The iteration ended above the tolerance.
    #[error(
        "residual is {residual:e} after {iterations} iterations: at most {required:e} was required"
    )]
    NotConverged {
        /// Residual that was reached.
        residual: f64,
        /// Iterations that were made.
        iterations: usize,
        /// Residual that was asked for.
        required: f64,
    },
    /// Every pixel of a periodic map is in contact.
    #[error(
        "every pixel is in contact: the stiffness at fixed contact is infinite; use a smaller load or a free boundary"
    )]
    FullContact,
    /// No load with this mean gap was found.
    #[error(
        "mean gap {gap:e} m was not reached in {trials} trials: a larger one, or a load, was required"
    )]
    GapNotFound {
        /// Mean gap asked for \[m\].
        gap: f64,
        /// Loads that were tried.
        trials: usize,
    },
    /// The caller's progress function requested a stop, at this load or an earlier one.
    #[error("the solution was stopped by the caller")]
    Cancelled,
}
