//! Numbers of a scene that `Scene.replace`, `Scene.vary` and `Space` change, by name.

use std::borrow::Cow;
use std::iter::once;

use asperity::ContactError;
use asperity_scene::SceneFile;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::convert::error::value_error;
use crate::convert::numbers::texts_in_si;
use crate::records::{Body, Interface, Record, Setter, Surface};

/// A number of a scene that can be replaced.
#[derive(Clone, Copy)]
pub(crate) enum Input {
    Interface(Setter<asperity::Interface>),
    Surface(Setter<asperity::Surface>),
    /// A number of one body, by its index.
    Body(usize, Setter<asperity::Body>),
    /// A number of every body.
    Bodies(Setter<asperity::Body>),
    /// One of the numbers from which the asperities follow.
    Roughness(usize),
    NominalArea,
    /// Radius and density follow from this and the next.
    PlasticityIndex,
    RoughnessParameter,
}

const ROUGHNESS: [(&str, Input); 2] = [
    ("plasticity_index", Input::PlasticityIndex),
    ("roughness_parameter", Input::RoughnessParameter),
];

/// The number of this key that is the same in all bodies.
const YOUNGS_MODULUS: &str = "youngs_modulus";

/// Every input of a scene by its name in scene files.
fn all(file: &SceneFile) -> Vec<(String, Input)> {
    let interface = Interface::SETTERS.iter().map(|(name, set)| (*name, Input::Interface(*set)));
    let surface = Surface::SETTERS.iter().map(|(name, set)| (*name, Input::Surface(*set)));
    let keys = file.roughness.iter().flat_map(|roughness| roughness.keys().iter().zip(0..));
    let described = keys.map(|(name, place)| (*name, Input::Roughness(place)));
    let of_body = |body: usize| {
        let name = move |key: &str| format!("body{}_{key}", body + 1);
        Body::SETTERS.iter().map(move |(key, set)| (name(key), Input::Body(body, *set)))
    };
    let modulus = |body: &asperity::Body| body.youngs_modulus.to_bits();
    let alike = file.bodies.windows(2).all(|two| modulus(&two[0]) == modulus(&two[1]));
    let of_all = Body::SETTERS.iter().filter(|(key, _)| *key == YOUNGS_MODULUS);
    let of_all = of_all.filter(|_| alike && !file.bodies.is_empty());
    // Radius and density beside the standard deviation of the surface heights come first.
    described
        .chain(interface)
        .chain(surface)
        .chain(once(("nominal_area", Input::NominalArea)))
        .chain(ROUGHNESS)
        .chain(of_all.map(|(key, set)| (*key, Input::Bodies(*set))))
        .map(|(name, input)| (name.to_string(), input))
        .chain((0..file.bodies.len()).flat_map(of_body))
        .collect()
}

/// The key in scene files of an input.
fn key(name: &str) -> &str {
    ["body1_", "body2_"].iter().find_map(|body| name.strip_prefix(body)).unwrap_or(name)
}

/// The inputs of these names of a scene; an error for an unknown name, or for numbers beside
/// others that determine them.
pub(crate) fn inputs<'n>(
    file: &SceneFile,
    names: impl Iterator<Item = &'n String>,
) -> PyResult<Vec<Input>> {
    let known = all(file);
    let input = |name: &'n String| {
        let found = known.iter().find(|(other, _)| other == name);
        found.map(|(_, input)| (name, *input)).ok_or_else(|| unknown(name, file, &known))
    };
    let found = names.map(input).collect::<PyResult<Vec<_>>>()?;
    for (name, follows) in &found {
        let cause = found.iter().find(|(_, cause)| cause.determines(name, follows));
        if let Some((cause, _)) = cause {
            return Err(value_error(format!(
                "{name} is given beside {cause}, which determines it: leave {name} out"
            )));
        }
    }
    Ok(found.into_iter().map(|(_, input)| input).collect())
}

/// The error about a name that is no input of a scene.
fn unknown(name: &str, file: &SceneFile, known: &[(String, Input)]) -> PyErr {
    let names: Vec<&str> = known.iter().map(|(name, _)| &**name).collect();
    let modulus = |body: &asperity::Body| body.youngs_modulus;
    let origin = match name {
        "m0" | "m2" | "m4" => "; m0, m2 and m4 need a surface that is given by them",
        "sq" | "spd" | "spc" => "; sq, spd and spc need a surface that is given by them",
        YOUNGS_MODULUS if !file.bodies.is_empty() => {
            let [a, b] = [file.bodies.first(), file.bodies.last()].map(|b| b.map_or(0.0, modulus));
            return value_error(format!(
                "youngs_modulus is {a:e} Pa of body 1 and {b:e} Pa of body 2: give body1_youngs_modulus or body2_youngs_modulus"
            ));
        }
        YOUNGS_MODULUS | "body1_youngs_modulus" | "body2_youngs_modulus" => {
            "; Young's modulus needs a scene that is given by its bodies"
        }
        _ => "",
    };
    let names = names.join(", ");
    value_error(format!(
        "{name} is not an input of this scene: one of {names} was required{origin}"
    ))
}

impl Input {
    /// Whether a number follows from this one, so that both together have no meaning.
    fn determines(&self, name: &str, other: &Self) -> bool {
        let of_pair = || matches!(name, "work_of_adhesion" | "pressure_factor");
        match (self, other) {
            (Self::PlasticityIndex | Self::RoughnessParameter, Self::Surface(_)) => {
                name != "asperity_height_std"
            }
            (Self::PlasticityIndex | Self::RoughnessParameter, Self::Roughness(_))
            | (Self::Roughness(_), Self::Surface(_)) => true,
            (Self::Body(..) | Self::Bodies(_), Self::Interface(_)) => !of_pair(),
            (Self::Bodies(_), Self::Body(..)) => name.ends_with(YOUNGS_MODULUS),
            _ => false,
        }
    }
}

/// The values of inputs by name, with numbers in SI units in the place of texts with a unit.
pub(crate) fn inputs_in_si<'py>(
    file: &SceneFile,
    given: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyDict>> {
    inputs(file, given.keys().extract::<Vec<String>>()?.iter())?;
    let found = given.copy()?;
    for (name, value) in given {
        let unit = asperity_scene::unit_of(key(name.extract()?));
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
    let (mut bodies, mut roughness) = (file.bodies.clone(), file.roughness.map(|r| r.numbers()));
    let numbers: Vec<(Input, f64)> = numbers.into_iter().collect();
    let (mut new_bodies, mut new_roughness) = (false, false);
    for (input, value) in &numbers {
        match input {
            Input::Body(place, set) => {
                bodies.get_mut(*place).into_iter().for_each(|b| set(b, *value))
            }
            Input::Bodies(set) => bodies.iter_mut().for_each(|body| set(body, *value)),
            Input::Roughness(place) => {
                let number = roughness.as_mut().and_then(|numbers| numbers.get_mut(*place));
                number.into_iter().for_each(|number| *number = *value);
            }
            _ => {}
        }
        new_bodies |= matches!(input, Input::Body(..) | Input::Bodies(_));
        new_roughness |= matches!(input, Input::Roughness(_));
    }
    let mut made = Cow::Borrowed(file);
    if new_bodies {
        made = Cow::Owned(made.with_bodies(bodies)?);
    }
    if let (true, Some(kind), Some(numbers)) = (new_roughness, file.roughness, roughness) {
        made = Cow::Owned(made.with_roughness(kind.with(numbers))?);
    }
    let file = &*made;
    let mut scene = file.scene.clone();
    let (mut index, mut parameter) = (None, None);
    for (input, value) in numbers {
        match input {
            Input::Body(..) | Input::Bodies(_) | Input::Roughness(_) => {}
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
