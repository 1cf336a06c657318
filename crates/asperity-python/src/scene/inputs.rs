//! Numbers of a scene that `Scene.replace`, `Scene.vary` and `Space` change, by name.

use std::iter::once;

use asperity::ContactError;
use asperity_scene::SceneFile;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::error::value_error;
use crate::convert::numbers::texts_in_si;
use crate::records::{Interface, Record, Setter, Surface};

/// A number of a scene that can be replaced.
#[derive(Clone, Copy)]
pub(crate) enum Input {
    Interface(Setter<asperity::Interface>),
    Surface(Setter<asperity::Surface>),
    NominalArea,
    /// Radius and density follow from this and the next.
    PlasticityIndex,
    RoughnessParameter,
}

const ROUGHNESS: [(&str, Input); 2] = [
    ("plasticity_index", Input::PlasticityIndex),
    ("roughness_parameter", Input::RoughnessParameter),
];

/// Every input by its name in scene files.
fn all() -> impl Iterator<Item = (&'static str, Input)> {
    let interface = Interface::SETTERS.iter().map(|(name, set)| (*name, Input::Interface(*set)));
    let surface = Surface::SETTERS.iter().map(|(name, set)| (*name, Input::Surface(*set)));
    interface.chain(surface).chain(once(("nominal_area", Input::NominalArea))).chain(ROUGHNESS)
}

/// The inputs of these names; an error for an unknown name, or for radius or density beside the
/// inputs that determine them.
pub(crate) fn inputs<'n>(names: impl Iterator<Item = &'n String> + Clone) -> PyResult<Vec<Input>> {
    let given = |wanted: &str| names.clone().any(|name| name == wanted);
    let follows = ["asperity_radius", "asperity_density"].into_iter().find(|name| given(name));
    if let (true, Some(follows)) = (ROUGHNESS.iter().any(|(name, _)| given(name)), follows) {
        let others = ROUGHNESS.map(|(name, _)| name).join(" or ");
        return Err(value_error(format!(
            "{follows} is given beside {others}, which determine it: leave {follows} out"
        )));
    }
    let input = |name: &String| {
        let found = all().find(|(other, _)| other == name);
        found.map(|(_, input)| input).ok_or_else(|| {
            let names = all().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
            value_error(format!("{name} is not an input of a scene: one of {names} was required"))
        })
    };
    names.clone().map(input).collect()
}

/// The values of inputs by name, with numbers in SI units in the place of texts with a unit.
#[pyfunction]
pub(crate) fn inputs_in_si<'py>(given: Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
    inputs(given.keys().extract::<Vec<String>>()?.iter())?;
    let found = given.copy()?;
    for (name, value) in given {
        let unit = asperity_scene::unit_of(name.extract()?);
        if let Some(read) = unit.map_or(Ok(None), |unit| texts_in_si(&value, unit))? {
            found.set_item(name, read)?;
        }
    }
    Ok(found)
}

/// A scene with other numbers.
pub(crate) fn with_numbers(
    file: &SceneFile,
    numbers: impl IntoIterator<Item = (Input, f64)>,
) -> Result<SceneFile, ContactError> {
    let mut scene = file.scene.clone();
    let (mut index, mut parameter) = (None, None);
    for (input, value) in numbers {
        match input {
            Input::Interface(set) => set(&mut scene.interface, value),
            Input::Surface(set) => set(&mut scene.surface, value),
            Input::NominalArea => scene.nominal_area = value,
            Input::PlasticityIndex => index = Some(value),
            Input::RoughnessParameter => parameter = Some(value),
        }
    }
    if index.is_some() || parameter.is_some() {
        let index = index.map_or_else(|| file.scene.plasticity_index(), Ok)?;
        let parameter = parameter.unwrap_or_else(|| file.scene.surface.roughness_parameter());
        let height_std = scene.surface.asperity_height_std;
        scene.surface = asperity::Surface::from_plasticity_index(
            index,
            parameter,
            height_std,
            &scene.interface,
        )?;
    }
    file.with_numbers(scene.interface, scene.surface, scene.nominal_area)
}
