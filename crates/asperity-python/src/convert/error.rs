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
    "An integral did not reach the requested tolerance; the message has the error it reached."
);
create_exception!(
    asperity,
    ContactWarning,
    PyUserWarning,
    "A warning about a scene or an answer: a number outside its usual range, a negative force, an area above the nominal one."
);

create_exception!(
    asperity,
    UnsupportedFormat,
    PyValueError,
    "A file of a scan in a format without a reader here."
);

/// A `ValueError` with the message of an error of the library.
pub(crate) fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// The exception of an error of the engine: `ValueError`, or `NotConverged`.
pub(crate) fn refused(error: ContactError) -> PyErr {
    match error {
        ContactError::Integral { source: QuadratureError::NotConverged { .. }, .. } => {
            NotConverged::new_err(error.to_string())
        }
        _ => value_error(error),
    }
}

/// Emits a `ContactWarning` at the line that calls the package, `above` frames of the package up.
pub(crate) fn warn(py: Python<'_>, message: impl std::fmt::Display, above: usize) -> PyResult<()> {
    py.import("asperity._warn")?.call_method1("warn", (message.to_string(), above)).map(drop)
}
