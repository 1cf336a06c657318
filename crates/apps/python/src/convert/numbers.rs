//! Numbers from Python: floats, texts with a unit, and arrays.

use numpy::{PyArrayDyn, PyUntypedArray};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyString};

use crate::convert::Object;

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
    let key = asperity_scene::key_of_input(name);
    let has_unit = asperity_scene::unit_of(key).is_some();
    if let Some(text) = given.cast::<PyString>().ok().filter(|_| has_unit) {
        let read = |text: &str| asperity_scene::quantity_of(key, text);
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
    let needed = asperity_scene::unit_of(asperity_scene::key_of_input(name))
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

/// A text with a unit as a number in an SI unit; of a `key`, which may be a hardness.
#[pyfunction]
#[pyo3(signature = (text, si, key=""))]
pub(crate) fn quantity(text: &str, si: &str, key: &str) -> PyResult<f64> {
    with_unit(text, |text| match key {
        "" => asperity_scene::quantity(text, si),
        key => asperity_scene::quantity_of(key, text),
    })
}

/// Texts with a unit, "100 nm" or a sequence of them, as numbers of a key in its SI unit, by the
/// package; numbers are returned as they are.
pub(crate) fn in_si<'py>(numbers: &Object<'py>, si: &str, key: &str) -> PyResult<Object<'py>> {
    let package = numbers.py().import("asperity._arguments")?;
    package.getattr("in_si")?.call1((numbers, si, key))
}

/// A contiguous array of doubles, by the package.
pub(crate) fn floats<'py>(
    values: &Object<'py>,
    name: &str,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let package = values.py().import("asperity._arguments")?;
    Ok(package.getattr("floats")?.call1((values, name))?.extract()?)
}

/// The largest magnitude of finite numbers; 0 without any.
pub(crate) fn largest_magnitude(numbers: &[f64]) -> f64 {
    let magnitude = |x: f64| if x.abs() < f64::INFINITY { x.abs() } else { 0.0 };
    // Side by side: a single maximum would wait for the one before.
    let mut largest = [0.0; 16];
    let (chunks, rest) = numbers.as_chunks::<16>();
    for chunk in chunks {
        for (largest, x) in largest.iter_mut().zip(chunk) {
            let size = magnitude(*x);
            *largest = if size > *largest { size } else { *largest };
        }
    }
    let rest = rest.iter().map(|x| magnitude(*x));
    rest.chain(largest).fold(0.0, f64::max)
}
