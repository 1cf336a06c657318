//! Errors: the field, the value found and the value required.

use asperity_core::{ContactError, shortest_digits};

/// The id of boundary elements as a model.
pub(crate) const ID: &str = "bem";

/// An error of a height map or of the solution of a contact.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BemError {
    /// There are more or fewer heights than pixels.
    #[error("heights: {found} numbers were found, {rows} x {columns} were required")]
    Count {
        /// The number found.
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
        /// The number found.
        found: usize,
        /// The number required.
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
        /// The value found.
        found: f64,
    },
    /// An input is out of range.
    #[error("{field} is {}: {required} was required", shortest_digits(*found))]
    OutOfRange {
        /// Name of the field.
        field: &'static str,
        /// The value found.
        found: f64,
        /// The values accepted.
        required: &'static str,
    },
    /// The load exceeds the load of a fully plastic contact.
    #[error(
        "mean pressure is {pressure:e} Pa: less than the hardness, {hardness:e} Pa, was required"
    )]
    CannotBeCarried {
        /// Mean pressure required \[Pa\].
        pressure: f64,
        /// Hardness \[Pa\].
        hardness: f64,
    },
    /// The gap exceeds the height of the highest point: there is no contact.
    #[error(
        "mean gap is {gap:e} m: less than the height of the highest point above the mean, {highest:e} m, was required (nothing touches)"
    )]
    NothingTouches {
        /// Mean gap required \[m\].
        gap: f64,
        /// Height of the highest point above the mean plane \[m\].
        highest: f64,
    },
    /// The iteration ended above the tolerance.
    #[error(
        "residual is {residual:e} after {iterations} iterations: at most {required:e} was required"
    )]
    NotConverged {
        /// Residual reached.
        residual: f64,
        /// Number of iterations.
        iterations: usize,
        /// Residual required.
        required: f64,
    },
    /// Every pixel of a periodic map is in contact.
    #[error(
        "every pixel is in contact: the stiffness at fixed contact is infinite; use a smaller load, or a free boundary if the map is periodic"
    )]
    FullContact,
    /// Every pixel is in contact at a neighbouring pressure, between which and another the slope of
    /// loading is a difference.
    #[error(
        "mean pressure is {pressure:e} Pa: every pixel is in contact at the neighbouring pressure {neighbour:e} Pa, from which the slope of loading follows; use a smaller load"
    )]
    FullContactBeside {
        /// Mean pressure \[Pa\].
        pressure: f64,
        /// The neighbouring pressure \[Pa\].
        neighbour: f64,
    },
    /// The gap does not fall between pressures to either side of this one.
    #[error(
        "mean pressure is {pressure:e} Pa: the mean gap does not fall between the neighbouring pressures, and the slope of loading is unknown; use another load"
    )]
    Slope {
        /// Mean pressure \[Pa\].
        pressure: f64,
    },
    /// Too many pixels are in contact, or the boundary is free, for
    /// [`solve_light`](crate::BoundaryElements::solve_light).
    #[error(
        "{pixels} pixels may be in contact: at most {most}, on a periodic map, was required for a light contact; use a smaller load or solve"
    )]
    NotLight {
        /// Number of pixels.
        pixels: usize,
        /// The most.
        most: usize,
    },
    /// No load with this mean gap was found.
    #[error(
        "mean gap {gap:e} m was not reached in {trials} trials: a larger one, or a load, was required"
    )]
    GapNotFound {
        /// Mean gap required \[m\].
        gap: f64,
        /// Number of loads tried.
        trials: usize,
    },
    /// The flows through both faces of the gap differ.
    #[error(
        "the flow is {inlet:e} through the inlet of the gap and {outlet:e} through its outlet, over that of an even gap as high as the largest: the same to 1e-6 was required"
    )]
    Unbalanced {
        /// Flow through the inlet.
        inlet: f64,
        /// Flow through the outlet.
        outlet: f64,
    },
    /// The caller's progress function requested a stop, at this load or an earlier one.
    #[error("the solution was stopped by the caller")]
    Cancelled,
}

/// An error of boundary elements as one of the model.
pub(crate) fn refused(error: BemError) -> ContactError {
    ContactError::Refused { model: ID.into(), reason: error.to_string() }
}
