//! Numbers as NumPy has them.

use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyList, PyString, PyTuple};

use crate::error::value_error;

/// A number, also one of NumPy's; no array.
pub(crate) fn scalar(number: &Bound<'_, PyAny>) -> Option<f64> {
    // True is no length.
    if number.is_instance_of::<PyBool>() {
        return None;
    }
    if number.is_exact_instance_of::<PyFloat>() || number.cast::<PyUntypedArray>().is_err() {
        return number.extract().ok();
    }
    None
}

/// Texts with a unit, as "100 nm" or a list of them, as numbers in an SI unit; none of numbers.
pub(crate) fn in_si<'py>(
    numbers: &Bound<'py, PyAny>,
    si: &str,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    let may_be = numbers.is_instance_of::<PyString>()
        || numbers.is_instance_of::<PyList>()
        || numbers.is_instance_of::<PyTuple>();
    if !may_be {
        return Ok(None);
    }
    let read = numbers.py().import("asperity._arguments")?.call_method1("in_si", (numbers, si))?;
    Ok((!read.is(numbers)).then_some(read))
}

/// A contiguous array of doubles. Masks, which would be lost, complex numbers, and truths and
/// texts, which NumPy would read as numbers, are refused.
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
    if !matches!(kind.getattr("kind")?.extract()?, "f" | "i" | "u") {
        return Err(PyTypeError::new_err(format!(
            "{name} has numbers of type {kind}: real ones were required"
        )));
    }
    // ascontiguousarray makes one dimension of none.
    let made = numpy.call_method1("ascontiguousarray", (&array, "float64"))?;
    Ok(made.call_method1("reshape", (array.getattr("shape")?,))?.extract()?)
}
