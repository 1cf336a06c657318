//! A scene as the arguments that make it: for text, comparison, pickling and tables of inputs.

use asperity_inputs::ModelOptions;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::records::{by_key, numbers};
use crate::scene::SceneFile;

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
