//! Heights, options and numbers of a scene from Python.

use std::collections::BTreeMap;

use asperity::{HeightDistribution, TabulatedHeights, WeibullHeights};
use asperity_inputs::{SceneInput, key_of_input};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;

use crate::convert::numbers::in_si;
use crate::convert::{Object, refused, value_error};

/// Heights: a name, a skewness, or a table of heights [m] and densities [1/m].
#[derive(FromPyObject, Serialize)]
#[serde(untagged)]
pub(crate) enum Heights {
    Name(String),
    Named(BTreeMap<String, f64>),
    Table(Vec<f64>, Vec<f64>),
}

/// The value of a key or an option: a text, a number, or keys of its own, as of a second surface.
#[derive(FromPyObject)]
pub(crate) enum KeyValue {
    Text(String),
    Number(f64),
    Keys(BTreeMap<String, KeyValue>),
}

impl From<KeyValue> for asperity_inputs::OptionValue {
    fn from(value: KeyValue) -> Self {
        match value {
            KeyValue::Text(text) => text.into(),
            KeyValue::Number(number) => number.into(),
            KeyValue::Keys(keys) => keys_of(keys).into(),
        }
    }
}

/// Keys with their values.
pub(crate) fn keys_of(given: BTreeMap<String, KeyValue>) -> asperity_inputs::Keys {
    given.into_iter().map(|(name, value)| (name, value.into())).collect()
}

impl Heights {
    /// The heights of a scene.
    pub(crate) fn in_file(file: &asperity_inputs::SceneFile) -> Self {
        match (&file.table, &file.scene.heights) {
            (None, HeightDistribution::Weibull(heights)) => {
                Self::Named([("skewness".into(), heights.skewness())].into())
            }
            (None, heights) => Self::Name(heights.name().into()),
            (Some(table), _) => {
                let (z, density) = table.points().iter().copied().unzip();
                Self::Table(z, density)
            }
        }
    }

    pub(crate) fn of(given: &Object<'_>) -> PyResult<Self> {
        given.extract().map_err(|_| {
            let shown = given.repr().map_or_else(|_| String::new(), |shown| shown.to_string());
            PyTypeError::new_err(format!("heights is {shown}: {HEIGHTS} was required"))
        })
    }

    pub(crate) fn put(self, file: &mut asperity_inputs::SceneFile) -> PyResult<()> {
        file.scene.heights = match self {
            Self::Name(name) if name == "gaussian" => HeightDistribution::Gaussian,
            Self::Name(name) if name == "exponential" => HeightDistribution::Exponential,
            Self::Name(name) => {
                return Err(value_error(format!("heights is {name:?}: {HEIGHTS} was required")));
            }
            Self::Named(named) => {
                let Some(skewness) = named.get("skewness").filter(|_| named.len() == 1) else {
                    let keys: Vec<&String> = named.keys().collect();
                    return Err(value_error(format!(
                        "heights has the keys {keys:?}: {HEIGHTS} was required"
                    )));
                };
                HeightDistribution::Weibull(WeibullHeights::new(*skewness).map_err(refused)?)
            }
            Self::Table(z, density) if z.len() != density.len() => {
                return Err(value_error(format!(
                    "heights is a table of {} heights and {} densities: equal numbers of both were required",
                    z.len(),
                    density.len()
                )));
            }
            Self::Table(z, density) => {
                let points: Vec<(f64, f64)> = z.into_iter().zip(density).collect();
                let table = TabulatedHeights::new("table", &points).map_err(refused)?;
                file.table = Some(table.clone());
                HeightDistribution::other(table)
            }
        };
        Ok(())
    }
}

const HEIGHTS: &str = "\"gaussian\", \"exponential\", {\"skewness\": value} or a table (heights [m], densities [1/m])";

/// The inputs of these names of a scene; an error for an unknown name, or for numbers beside
/// others that determine them.
pub(crate) fn inputs<'n>(
    file: &asperity_inputs::SceneFile,
    names: impl Iterator<Item = &'n String>,
) -> PyResult<Vec<SceneInput>> {
    file.inputs(names.map(String::as_str)).map_err(value_error)
}

/// The values of inputs by name, with numbers in SI units in the place of texts with a unit.
pub(crate) fn inputs_in_si<'py>(
    file: &asperity_inputs::SceneFile,
    given: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    inputs(file, given.keys().extract::<Vec<String>>()?.iter())?;
    let found = given.copy()?;
    for (name, value) in given {
        let unit = asperity_inputs::unit_of(key_of_input(name.extract()?));
        if let Some(unit) = unit {
            found.set_item(name, in_si(&value, unit)?)?;
        }
    }
    Ok(found)
}
