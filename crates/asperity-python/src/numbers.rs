//! Numbers as NumPy has them.

use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyFloat;

use crate::error::value_error;

/// A number, also one of NumPy's; no array.
pub(crate) fn scalar(number: &Bound<'_, PyAny>) -> Option<f64> {
    if number.is_exact_instance_of::<PyFloat>() || number.cast::<PyUntypedArray>().is_err() {
        return number.extract().ok();
    }
    None
}

/// A contiguous array of doubles. Masks, which would be lost, complex numbers, and texts, which
/// NumPy would read as numbers, are refused.
#[pyfunction]
pub(crate) fn floats<'py>(
    values: &Bound<'py, PyAny>,
    name: &str,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let numpy = values.py().import("numpy")?;
    if numpy.getattr("ma")?.call_method1("isMaskedArray", (values,))?.extract()? {
        return Err(value_error(format!(
            "{name} is a masked array: one without a mask was required, as of its filled() or compressed()"
        )));
    }
    let array = numpy.call_method1("asarray", (values,))?;
    let kind = array.getattr("dtype")?;
    if !matches!(kind.getattr("kind")?.extract()?, "f" | "i" | "u" | "b") {
        return Err(PyTypeError::new_err(format!(
            "{name} has numbers of type {kind}: real ones were required"
        )));
    }
    // ascontiguousarray makes one dimension of none.
    let made = numpy.call_method1("ascontiguousarray", (&array, "float64"))?;
    Ok(made.call_method1("reshape", (array.getattr("shape")?,))?.extract()?)
}
