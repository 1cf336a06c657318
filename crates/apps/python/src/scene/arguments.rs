//! Keys and numbers of a scene from Python.

use std::collections::BTreeMap;

use asperity_scene::SceneInput;
use pyo3::prelude::*;

use crate::convert::numbers::argument;
use crate::convert::{Object, value_error};

/// The value of a key or an option: a text, a number, a list, or keys of its own, as of a second
/// surface.
#[derive(FromPyObject)]
pub(crate) enum KeyValue {
    Text(String),
    Flag(bool),
    Whole(i64),
    Number(f64),
    List(Vec<KeyValue>),
    Keys(BTreeMap<String, KeyValue>),
}

impl From<KeyValue> for asperity_scene::OptionValue {
    fn from(value: KeyValue) -> Self {
        match value {
            KeyValue::Text(text) => text.into(),
            KeyValue::Flag(flag) => flag.into(),
            KeyValue::Whole(number) => number.into(),
            KeyValue::Number(number) => number.into(),
            KeyValue::List(list) => Self::Array(list.into_iter().map(Self::from).collect()),
            KeyValue::Keys(keys) => keys_of(keys).into(),
        }
    }
}

/// Keys with their values.
pub(crate) fn keys_of(given: impl IntoIterator<Item = (String, KeyValue)>) -> asperity_scene::Keys {
    given.into_iter().map(|(name, value)| (name, value.into())).collect()
}

/// Heights as the value of their key: a name, a skewness, or a table of heights [m] and densities
/// [1/m].
pub(crate) fn heights_key(given: &Object<'_>) -> PyResult<asperity_scene::OptionValue> {
    if let Ok((heights, densities)) = given.extract::<(Vec<f64>, Vec<f64>)>() {
        let columns = [("height_m", heights), ("density_per_m", densities)];
        let column = |(name, column): (&str, Vec<f64>)| (name.into(), column.into());
        return Ok(asperity_scene::Keys::from_iter(columns.map(column)).into());
    }
    Ok(argument::<KeyValue>("heights", given)?.into())
}

/// The inputs of these names of a scene; an error for an unknown name, or for numbers beside
/// others that determine them.
pub(crate) fn inputs<'n>(
    file: &asperity_scene::SceneFile,
    names: impl Iterator<Item = &'n String>,
) -> PyResult<Vec<SceneInput>> {
    file.inputs(names.map(String::as_str)).map_err(value_error)
}
