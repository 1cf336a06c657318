//! One measured value, and the names of its columns.

use asperity_core::{At, Quantity, Separation};

pub(crate) const LOAD: &str = "load_N";
pub(crate) const PRESSURE: &str = "pressure_Pa";
pub(crate) const SEPARATION: &str = "separation_m";

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

/// The position of a row, counted from 0, for messages: its line if that is known.
pub(crate) fn position(lines: &[usize], row: usize) -> String {
    let number = lines.get(row).copied().unwrap_or(row + 1);
    format!("{} {number}", row_name(lines))
}

/// What a row is called: a line where data have a file.
pub(crate) fn row_name(lines: &[usize]) -> &'static str {
    if lines.is_empty() { "row" } else { "line" }
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

impl Observation {
    /// The column of the place (`load_N`, `pressure_Pa` or `separation_m`), and its number.
    #[must_use]
    pub fn place(&self) -> (&'static str, f64) {
        let column = match self.at {
            At::Load(_) => LOAD,
            At::Pressure(_) => PRESSURE,
            _ => SEPARATION,
        };
        (column, number(self.at))
    }

    /// The same value at a load or reading that is larger by a factor.
    pub(crate) fn moved(self, factor: f64) -> Self {
        let at = match self.at {
            At::Load(load) => At::Load(load * factor),
            At::Pressure(pressure) => At::Pressure(pressure * factor),
            At::Separation(reading) => {
                Separation { value: reading.value * factor, ..reading }.into()
            }
            other => other,
        };
        Self { at, ..self }
    }
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

/// The number of a place.
pub(crate) fn number(at: At) -> f64 {
    match at {
        At::Load(x) | At::Pressure(x) | At::Separation(Separation { value: x, .. }) => x,
        _ => f64::NAN,
    }
}
