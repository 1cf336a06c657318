//! One measured value, its place, and the names of its columns.

use std::fmt;

use asperity_core::{At, Quantity, Separation};

pub(crate) const LOAD: &str = "load_N";
pub(crate) const PRESSURE: &str = "pressure_Pa";
pub(crate) const SEPARATION: &str = "separation_m";
/// Approach since the first reading: a separation with the other sign and an unknown offset.
pub(crate) const CLOSURE: &str = "closure_m";
/// The end of the name of a column of standard deviations.
pub(crate) const STD: &str = "_std";

/// A column of a table of measurements; a missing number is none.
pub type DataColumn = (String, Vec<Option<f64>>);

/// Columns of measurements, as read from a file or given as arrays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeasuredTable {
    /// The columns, all of one length.
    pub columns: Vec<DataColumn>,
    /// The line of each row in its file, counted from 1; empty for arrays.
    pub lines: Vec<usize>,
}

/// Where a value stands: `line 5` of a file, or `row 4` of arrays, both counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Position {
    /// What a row is called: `line` or `row`.
    pub name: &'static str,
    /// Its number.
    pub number: usize,
}

impl Position {
    /// The position of a row, counted from 0; rows may have their lines.
    pub(crate) fn of(lines: &[usize], row: usize) -> Self {
        let name = if lines.is_empty() { "row" } else { "line" };
        Self { name, number: lines.get(row).copied().unwrap_or(row + 1) }
    }
}

impl fmt::Display for Position {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name, self.number)
    }
}

/// What a measured value is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Measured {
    /// A quantity of the contact.
    Quantity(Quantity),
    /// The reading of a separation \[m\] under a load.
    Separation,
}

impl Measured {
    /// The column of a table, unit included: `area_m2`, `separation_m`.
    #[must_use]
    pub fn column(self) -> String {
        match self {
            Self::Quantity(quantity) => quantity.column(),
            Self::Separation => SEPARATION.into(),
        }
    }

    /// Whether residuals are differences, for lack of a logarithm.
    pub(crate) fn is_difference(self) -> bool {
        match self {
            Self::Quantity(quantity) => quantity.is_absolute(),
            Self::Separation => true,
        }
    }
}

/// One measured value.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Observation {
    /// The row of the table, counted from 1.
    pub row: usize,
    /// The load, pressure, or reading of the separation.
    pub at: At,
    /// What was measured.
    pub measured: Measured,
    /// The value, in SI units.
    pub value: f64,
    /// Its standard deviation, if known.
    pub std: Option<f64>,
}

impl Observation {
    /// The column of the place (`load_N`, `pressure_Pa` or `separation_m`), and its number.
    #[must_use]
    pub fn place(&self) -> (&'static str, f64) {
        match self.at {
            At::Load(load) => (LOAD, load),
            At::Pressure(pressure) => (PRESSURE, pressure),
            At::Separation(reading) => (SEPARATION, reading.value),
            _ => (SEPARATION, f64::NAN),
        }
    }

    /// The same value at another number of its place.
    pub(crate) fn placed_at(self, number: f64) -> Self {
        let at = match self.at {
            At::Load(_) => At::Load(number),
            At::Pressure(_) => At::Pressure(number),
            At::Separation(reading) => Separation { value: number, ..reading }.into(),
            other => other,
        };
        Self { at, ..self }
    }
}
