//! Errors and warnings of the library as Python's.

use asperity::ContactError;
use asperity_quadrature::QuadratureError;
use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyUserWarning, PyValueError};
use pyo3::prelude::*;

create_exception!(
    asperity,
    NotConverged,
    PyRuntimeError,
    "An integral did not reach the tolerance that was asked for; the message says how far it came."
);
create_exception!(
    asperity,
    ContactWarning,
    PyUserWarning,
    "An answer stands, and deserves a word: a negative total, several separations for one load."
);

/// Any refusal of the library, in its own words.
pub(crate) fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A refusal of the engine: `ValueError`, or `NotConverged`.
pub(crate) fn refused(error: &ContactError) -> PyErr {
    refused_at("", error)
}

/// The same, saying where among many.
pub(crate) fn refused_at(place: &str, error: &ContactError) -> PyErr {
    let message = format!("{place}{error}");
    match error {
        ContactError::Integral { source: QuadratureError::NotConverged { .. }, .. } => {
            NotConverged::new_err(message)
        }
        _ => PyValueError::new_err(message),
    }
}

/// Warns in Python's way, at the line that called.
pub(crate) fn warn(py: Python<'_>, message: &str) -> PyResult<()> {
    let category = py.get_type::<ContactWarning>();
    py.import("warnings")?.call_method1("warn", (message, category, 1)).map(drop)
}
