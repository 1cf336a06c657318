//! Options of the models, between Python and the scene files.

use std::collections::BTreeMap;

use asperity_scene::{ModelOptions, OptionValue, SceneFile};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::error::value_error;

/// Options by keyword: words, or dicts of numbers.
pub(crate) fn option_values(
    options: &Bound<'_, PyDict>,
) -> PyResult<BTreeMap<String, OptionValue>> {
    let value = |value: &Bound<'_, PyAny>| {
        Ok::<_, PyErr>(match value.cast::<PyString>() {
            Ok(word) => OptionValue::Word(word.to_str()?.into()),
            Err(_) => OptionValue::Numbers(value.extract()?),
        })
    };
    options.iter().map(|(name, v)| Ok((name.extract()?, value(&v)?))).collect()
}

/// Options as Python has them.
pub(crate) fn option_objects<'py>(
    py: Python<'py>,
    options: &BTreeMap<String, OptionValue>,
) -> PyResult<BTreeMap<String, Bound<'py, PyAny>>> {
    let object = |(name, value): (&String, &OptionValue)| {
        let object = match value {
            OptionValue::Word(word) => word.into_bound_py_any(py)?,
            OptionValue::Numbers(numbers) => numbers.into_bound_py_any(py)?,
        };
        Ok((name.clone(), object))
    };
    options.iter().map(object).collect()
}

/// The options of a scene, with what was given by keyword in their place.
pub(crate) fn with_options(
    scene: &SceneFile,
    given: &BTreeMap<String, OptionValue>,
) -> PyResult<ModelOptions> {
    let mut options = scene.options;
    given.iter().try_for_each(|(name, v)| options.set(name, v)).map_err(value_error)?;
    Ok(options)
}
