//! Paths, units and distances of points, as Python gives them.

use std::path::Path;

use asperity_topography::{Distance, LengthUnit, TopographyError};
use pyo3::exceptions::{PyFileNotFoundError, PyTypeError};
use pyo3::prelude::*;

use crate::convert::{Object, UnsupportedFormat, value_error};

/// The distance of points along a row and along a column: numbers, or texts with a unit.
pub(crate) struct Spacing([Distance; 2]);

impl<'py> FromPyObject<'_, 'py> for Spacing {
    type Error = PyErr;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(one) = distance(&given) {
            return one.map(|one| Self([one; 2]));
        }
        if let Ok((dx, dy)) = given.extract::<(Object<'_>, Object<'_>)>()
            && let (Ok(dx), Ok(dy)) = (distance(&dx), distance(&dy))
        {
            return Ok(Self([dx?, dy?]));
        }
        let shown = given.repr().map_or_else(|_| String::new(), |shown| shown.to_string());
        Err(PyTypeError::new_err(format!(
            "{shown} is no distance of points: a number, or two, in the unit of the heights, or texts with a unit, as \"10 nm\", was required"
        )))
    }
}

/// A number or a text; the inner error is about the text.
fn distance(given: &Object<'_>) -> PyResult<PyResult<Distance>> {
    if let Ok(number) = given.extract::<f64>() {
        return Ok(Ok(number.into()));
    }
    Ok(given.extract::<String>()?.parse().map_err(value_error))
}

impl Spacing {
    /// The numbers in this unit, which plain ones have.
    pub(crate) fn in_unit(self, unit: LengthUnit) -> [f64; 2] {
        self.0.map(|distance| distance.in_unit(unit))
    }
}

/// `UnsupportedFormat` for files in formats without a reader, `ValueError` for others.
pub(crate) fn unreadable(error: TopographyError) -> PyErr {
    let message = error.to_string();
    match error {
        TopographyError::File { source, .. }
            if matches!(*source, TopographyError::Format { .. }) =>
        {
            UnsupportedFormat::new_err(message)
        }
        _ => value_error(message),
    }
}

/// `FileNotFoundError` for a path without a file.
pub(crate) fn found(path: &Path) -> PyResult<()> {
    match path.try_exists() {
        Ok(false) => {
            let shown = path.display();
            Err(PyFileNotFoundError::new_err(format!("{shown}: no such file")))
        }
        _ => Ok(()),
    }
}

pub(crate) fn unit_of(name: &str) -> PyResult<LengthUnit> {
    name.parse().map_err(|error: TopographyError| value_error(error))
}
