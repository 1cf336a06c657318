//! Numbers from Python: floats, texts with a unit, and arrays.

use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyList, PyString, PyTuple};

use crate::convert::{Object, value_error};

/// A number, also a NumPy scalar; none for arrays and booleans.
pub(crate) fn scalar(number: &Object<'_>) -> Option<f64> {
    // Python would convert True to 1.
    if number.is_instance_of::<PyBool>() {
        return None;
    }
    if number.is_exact_instance_of::<PyFloat>() || number.cast::<PyUntypedArray>().is_err() {
        return number.extract().ok();
    }
    None
}

/// An argument `name` of `owner` as a number in SI units, from a number or a text with a unit that
/// fits the key of this name in scene files.
pub(crate) fn number(owner: &str, name: &str, given: &Object<'_>) -> PyResult<f64> {
    let has_unit = asperity_inputs::unit_of(name).is_some();
    if let Some(text) = given.cast::<PyString>().ok().filter(|_| has_unit) {
        let read = |text: &str| asperity_inputs::quantity_of(name, text);
        return with_unit(text.to_str()?, read).map_err(|error| {
            PyTypeError::new_err(format!("{owner}: {name}: {}", error.value(given.py())))
        });
    }
    scalar(given).ok_or_else(|| {
        let shown = given.repr().map_or_else(|_| String::new(), |shown| shown.to_string());
        no_number(owner, name, &shown)
    })
}

/// An argument of the package's function; a `TypeError` has its name.
pub(crate) fn argument<'a, 'py, T: FromPyObject<'a, 'py, Error = PyErr>>(
    name: &str,
    given: &'a Object<'py>,
) -> PyResult<T> {
    given.extract().map_err(|error: PyErr| match error.is_instance_of::<PyTypeError>(given.py()) {
        true => PyTypeError::new_err(format!("argument '{name}': {}", error.value(given.py()))),
        false => error,
    })
}

/// The error about an argument that is no number.
pub(crate) fn no_number(owner: &str, name: &str, shown: &str) -> PyErr {
    let needed = asperity_inputs::unit_of(name)
        .map_or(String::new(), |unit| format!(" in {unit}, or a text with a unit"));
    PyTypeError::new_err(format!("{owner}: {name} is {shown}: give a number{needed}"))
}

/// A text with a unit, as "2 kN", as `read` reads it.
fn with_unit(text: &str, read: impl Fn(&str) -> Result<f64, String>) -> PyResult<f64> {
    if text.trim().parse::<f64>().is_ok() {
        let advice = "give a number, or a text with its unit";
        return Err(PyTypeError::new_err(format!("{text:?} has no unit: {advice}")));
    }
    read(text).map_err(PyTypeError::new_err)
}

/// Texts with a unit, "100 nm" or a sequence of them, as numbers in an SI unit; none for numbers.
pub(crate) fn texts_in_si<'py>(numbers: &Object<'py>, si: &str) -> PyResult<Option<Object<'py>>> {
    let py = numbers.py();
    let read = |text: &Bound<'_, PyString>| {
        with_unit(text.to_str()?, |text| asperity_inputs::quantity(text, si))
    };
    if let Ok(text) = numbers.cast::<PyString>() {
        return Ok(Some(PyFloat::new(py, read(text)?).into_any()));
    }
    if !numbers.is_instance_of::<PyTuple>() && !numbers.is_instance_of::<PyList>() {
        return Ok(None);
    }
    let items = numbers.try_iter()?.collect::<PyResult<Vec<_>>>()?;
    if !items.iter().any(|item| item.is_instance_of::<PyString>()) {
        return Ok(None);
    }
    let each = |item: &Object<'_>| match item.cast::<PyString>() {
        Ok(text) => read(text),
        Err(_) => {
            let shown = item.repr()?;
            let advice = "give every value a unit, or no value";
            Err(PyTypeError::new_err(format!("{shown} has no unit: {advice}")))
        }
    };
    let read = items.iter().map(each).collect::<PyResult<Vec<f64>>>()?;
    Ok(Some(PyTuple::new(py, read)?.into_any()))
}

/// Texts with a unit as numbers in an SI unit; numbers as they are.
#[pyfunction]
pub(crate) fn in_si<'py>(numbers: Object<'py>, si: &str) -> PyResult<Object<'py>> {
    Ok(texts_in_si(&numbers, si)?.unwrap_or(numbers))
}

/// A contiguous array of doubles. Masked arrays, whose masks would be lost, and complex numbers,
/// booleans and texts are refused.
#[pyfunction]
pub(crate) fn floats<'py>(
    values: &Object<'py>,
    name: &str,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let numpy = values.py().import("numpy")?;
    if numpy.getattr("ma")?.call_method1("isMaskedArray", (values,))?.extract()? {
        return Err(value_error(format!(
            "{name} is a masked array: an array without a mask was required; use its filled() or compressed()"
        )));
    }
    let array = numpy.call_method1("asarray", (values,))?;
    let kind = array.getattr("dtype")?;
    if !matches!(kind.getattr("kind")?.extract()?, "f" | "i" | "u") {
        return Err(PyTypeError::new_err(format!(
            "{name} has values of type {kind}: real numbers were required"
        )));
    }
    // ascontiguousarray returns one dimension for a scalar.
    let made = numpy.call_method1("ascontiguousarray", (&array, "float64"))?;
    Ok(made.call_method1("reshape", (array.getattr("shape")?,))?.extract()?)
}

/// The largest magnitude of finite numbers; 0 without any.
pub(crate) fn largest_magnitude(numbers: &[f64]) -> f64 {
    // Bits of magnitudes are ordered as these, and integers are compared side by side.
    let infinite = f64::INFINITY.to_bits();
    let bits = numbers.iter().map(|x| x.abs().to_bits());
    f64::from_bits(bits.map(|bits| if bits < infinite { bits } else { 0 }).max().unwrap_or(0))
}
