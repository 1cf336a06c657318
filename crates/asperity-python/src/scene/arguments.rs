//! Heights, options and numbers of a scene from Python, and a scene as the arguments that make it.

use std::collections::BTreeMap;

use asperity::{HeightDistribution, TabulatedHeights, WeibullHeights};
use asperity_inputs::{ModelOptions, SceneInput, key_of_input};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde::Serialize;

use crate::convert::numbers::texts_in_si;
use crate::convert::{Object, refused, value_error};
use crate::records::{by_key, numbers};
use crate::scene::SceneFile;

/// Heights: a name, a skewness, or a table of heights [m] and densities [1/m].
#[derive(FromPyObject, Serialize)]
#[serde(untagged)]
pub(crate) enum Heights {
    Name(String),
    Named(BTreeMap<String, f64>),
    Table(Vec<f64>, Vec<f64>),
}

/// The value of an option: a name, a number, or named numbers.
#[derive(FromPyObject)]
pub(crate) enum OptionValue {
    Name(String),
    Number(f64),
    Numbers(BTreeMap<String, f64>),
}

impl From<OptionValue> for asperity_inputs::OptionValue {
    fn from(value: OptionValue) -> Self {
        match value {
            OptionValue::Name(name) => name.into(),
            OptionValue::Number(number) => number.into(),
            OptionValue::Numbers(numbers) => numbers.into(),
        }
    }
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
        if let Some(read) = unit.map_or(Ok(None), |unit| texts_in_si(&value, unit))? {
            found.set_item(name, read)?;
        }
    }
    Ok(found)
}

impl SceneFile {
    /// The arguments of this scene, in the order of the signature.
    pub(super) fn arguments<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let arguments = PyDict::new(py);
        arguments.set_item("interface", self.interface(py)?)?;
        arguments.set_item("surface", self.surface(py)?)?;
        arguments.set_item("nominal_area", self.nominal_area())?;
        arguments.set_item("heights", self.heights(py)?)?;
        arguments.set_item("separation_from", self.separation_from(py)?)?;
        arguments.set_item("mean_plane_offset", self.mean_plane_offset())?;
        arguments.set_item("options", self.options(py)?)?;
        Ok(arguments)
    }

    /// The arguments with dicts of numbers for the interface and the surface, and for the numbers
    /// from which these follow.
    pub(super) fn fields<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let fields = self.arguments(py)?;
        fields.set_item("interface", numbers(py, &self.0.scene.interface)?)?;
        fields.set_item("surface", numbers(py, &self.0.scene.surface)?)?;
        let bodies = self.0.bodies.iter().map(|body| numbers(py, body));
        let bodies = bodies.collect::<PyResult<Vec<_>>>()?;
        if !bodies.is_empty() {
            fields.set_item("bodies", bodies)?;
        }
        if let Some(roughness) = self.0.roughness {
            fields.set_item("roughness", by_key(py, roughness)?)?;
        }
        Ok(fields)
    }

    /// The arguments that differ from the defaults, as text; of a table of heights its size.
    pub(super) fn shown(&self, py: Python<'_>) -> PyResult<String> {
        let given = self.arguments(py)?;
        for (name, usual) in [("heights", "gaussian"), ("separation_from", "asperity-mean")] {
            if given.get_item(name)?.is_some_and(|value| value.eq(usual).unwrap_or(false)) {
                given.del_item(name)?;
            }
        }
        if self.0.options == ModelOptions::default() {
            given.del_item("options")?;
        }
        let given = given.iter().filter(|(_, value)| !value.is_none());
        let each = given.map(|(name, value)| Ok(format!("{name}={}", value.repr()?)));
        let text = format!("Scene({})", each.collect::<PyResult<Vec<_>>>()?.join(", "));
        Ok(match &self.0.table {
            None => text,
            Some(table) => {
                let points = format!("<table of {} points>", table.points().len());
                text.replace(&self.heights(py)?.repr()?.to_string(), &points)
            }
        })
    }
}
