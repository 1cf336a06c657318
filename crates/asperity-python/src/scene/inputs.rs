//! Numbers of a scene that `Scene.replace`, `Scene.vary` and `Space` change, by name.

use asperity_inputs::{SceneFile, SceneInput, key_of_input};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::error::value_error;
use crate::convert::numbers::texts_in_si;

/// The inputs of these names of a scene; an error for an unknown name, or for numbers beside
/// others that determine them.
pub(crate) fn inputs<'n>(
    file: &SceneFile,
    names: impl Iterator<Item = &'n String>,
) -> PyResult<Vec<SceneInput>> {
    file.inputs(names.map(String::as_str)).map_err(value_error)
}

/// The values of inputs by name, with numbers in SI units in the place of texts with a unit.
pub(crate) fn inputs_in_si<'py>(
    file: &SceneFile,
    given: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    inputs(file, given.keys().extract::<Vec<String>>()?.iter())?;
    let found = given.copy()?;
    for (name, value) in given {
        let unit = asperity_inputs::unit_of(key_of_input(name.extract()?));
        if let Some(read) = unit.map_or(Ok(None), |unit| texts_in_si(&value, unit))? {
            found.set_item(name, read)?;
        }
    }
    Ok(found)
}
