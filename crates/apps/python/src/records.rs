//! The records of the package's `_records`: structs of the library from their numbers, and back.

use std::collections::BTreeMap;

use asperity::{Asperity, Body, ContactError, Interface, Plausible, ProfileMoments, Surface};
use asperity_scene::{BODY, Field, INTERFACE, Key, Roughness, SURFACE, Way};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyTuple};

use crate::convert::numbers::{no_number, number};
use crate::convert::{Object, refused, warn};

/// A struct of the library behind a class of the package.
pub(crate) trait Record: Sized + 'static {
    /// The name of the class.
    const CLASS: &'static str;
    const NUMBERS: &'static [Field<Self>];
    /// The struct to fill; its numbers are required.
    const BLANK: fn() -> Self;
    const CHECK: fn(&Self) -> Result<(), ContactError>;
}

impl Record for Body {
    const CLASS: &'static str = "Body";
    const NUMBERS: &'static [Field<Self>] = BODY;
    const BLANK: fn() -> Self = || Self::elastic(0.0, 0.0);
    const CHECK: fn(&Self) -> Result<(), ContactError> =
        |body| Interface::against_rigid(body).map(drop);
}

impl Record for Interface {
    const CLASS: &'static str = "Interface";
    const NUMBERS: &'static [Field<Self>] = INTERFACE;
    const BLANK: fn() -> Self = || Self::elastic(0.0, 0.0);
    const CHECK: fn(&Self) -> Result<(), ContactError> = |one| one.check().map(drop);
}

impl Record for Surface {
    const CLASS: &'static str = "Surface";
    const NUMBERS: &'static [Field<Self>] = SURFACE;
    const BLANK: fn() -> Self = || Self::new(0.0, 0.0, 0.0);
    const CHECK: fn(&Self) -> Result<(), ContactError> = Self::check;
}

/// The numbers of a record by their names, each with its value before it is given.
macro_rules! fields {
    ($($name:ident $blank:expr,)+) => {
        const NUMBERS: &'static [Field<Self>] = &[$(Field {
            name: stringify!($name),
            get: |of| Option::from(of.$name),
            set: |of, value| of.$name = value.into(),
        }),+];
        const BLANK: fn() -> Self = || Self { $($name: $blank),+ };
    };
}

impl Record for Asperity {
    const CLASS: &'static str = "Asperity";
    fields! {
        equivalent_modulus 0.0, equivalent_shear_modulus None, poissons_ratio 0.0, hardness None,
        yield_strength None, pressure_factor 0.0, radius 0.0, work_of_adhesion None,
        tangent_modulus None, density None,
    }
    const CHECK: fn(&Self) -> Result<(), ContactError> = |_| Ok(());
}

/// The numbers of a struct by name; None for those that it does not have.
fn numbers<'py, T: Record>(py: Python<'py>, of: &T) -> PyResult<Bound<'py, PyDict>> {
    T::NUMBERS.iter().map(|number| (number.name, (number.get)(of))).into_py_dict(py)
}

/// The struct of these numbers, also texts with a unit.
fn read<T: Record>(given: &Bound<'_, PyDict>) -> PyResult<T> {
    let mut found = T::BLANK();
    for Field { name, get, set } in T::NUMBERS {
        match given.get_item(name)?.filter(|value| !value.is_none()) {
            Some(value) => set(&mut found, number(T::CLASS, name, &value)?),
            None if get(&found).is_some() => return Err(no_number(T::CLASS, name, "None")),
            None => {}
        }
    }
    T::CHECK(&found).map_err(refused)?;
    Ok(found)
}

fn class<'py, T: Record>(py: Python<'py>) -> PyResult<Object<'py>> {
    py.import("asperity._records")?.getattr(T::CLASS)
}

/// The record of a struct.
pub(crate) fn record<'py, T: Record>(py: Python<'py>, of: &T) -> PyResult<Object<'py>> {
    class::<T>(py)?.call((), Some(&numbers(py, of)?))
}

/// The interface of the bodies from which it is made, if there are any.
pub(crate) fn interface<'py>(
    py: Python<'py>,
    interface: &Interface,
    bodies: &[Body],
) -> PyResult<Object<'py>> {
    let bodies = bodies.iter().map(|body| record(py, body)).collect::<PyResult<Vec<_>>>()?;
    let made = (numbers(py, interface)?, PyTuple::new(py, bodies)?);
    class::<Interface>(py)?.call_method1("_made", made)
}

/// The surface with the numbers from which it follows, if there are any.
pub(crate) fn surface<'py>(
    py: Python<'py>,
    surface: &Surface,
    roughness: Option<Roughness>,
) -> PyResult<Object<'py>> {
    let made = (numbers(py, surface)?, roughness.map(|one| by_key(py, one)).transpose()?);
    class::<Surface>(py)?.call_method1("_made", made)
}

/// The numbers of a roughness by their keys.
fn by_key(py: Python<'_>, roughness: Roughness) -> PyResult<Bound<'_, PyDict>> {
    roughness.by_key().into_py_dict(py)
}

/// An argument as the struct of the class; a `TypeError` for another type.
pub(crate) fn instance<T: Record>(name: &str, given: &Object<'_>) -> PyResult<T> {
    if given.is_instance(&class::<T>(given.py())?)? {
        return read(given.getattr("__dict__")?.cast()?);
    }
    let found = type_of(given);
    let advice = match (&*found, T::CLASS) {
        ("Body", "Interface") => ": Interface.between(first, second) makes one from two bodies",
        _ => "",
    };
    let wanted = T::CLASS;
    Err(PyTypeError::new_err(format!("{name} is of type {found}: {wanted} was required{advice}")))
}

/// The bodies from which an interface is made.
pub(crate) fn bodies(interface: &Object<'_>) -> PyResult<Vec<Body>> {
    interface.getattr("_origin")?.try_iter()?.map(|body| instance("body", &body?)).collect()
}

/// The keys of a surface: of the numbers from which it follows, or of its own.
pub(crate) fn surface_keys(surface: &Object<'_>) -> PyResult<BTreeMap<String, f64>> {
    let own = instance::<Surface>("surface", surface)?;
    let origin: Option<BTreeMap<String, f64>> = surface.getattr("_origin")?.extract()?;
    origin.map_or_else(|| numbers(surface.py(), &own)?.extract(), Ok)
}

/// Three named numbers of a surface, in any order.
fn roughness(given: &Bound<'_, PyDict>) -> PyResult<Roughness> {
    let names: Vec<String> = given.keys().extract()?;
    let is_of = |way: &Way| {
        names.len() == 3 && way.keys().iter().all(|key| names.iter().any(|name| name == key))
    };
    let described = Way::all().filter(|way| *way != Way::Asperities);
    let Some(way) = described.clone().find(is_of) else {
        let ways: Vec<String> = described.map(|way| way.keys().join(", ")).collect();
        let (names, ways) = (given.keys(), ways.join("; "));
        return Err(PyTypeError::new_err(format!(
            "Surface.of: {names} describe no surface: the numbers of one of these were required: {ways}"
        )));
    };
    let mut numbers = [f64::NAN; 3];
    for (found, name) in numbers.iter_mut().zip(way.keys()) {
        *found = number("Surface", name, &given.as_any().get_item(name)?)?;
    }
    Ok(Roughness { way, numbers })
}

/// The name of an object's type.
pub(crate) fn type_of(given: &Object<'_>) -> String {
    given.get_type().name().map_or_else(|_| String::new(), |name| name.to_string())
}

/// Name and unit of a number, whether it is required, and its text in the documentation.
type Described = (&'static str, &'static str, bool, String);

/// The numbers of the record of a section of scene files.
#[pyfunction]
pub(crate) fn numbers_of(section: &str) -> Vec<Described> {
    fn of<T: Record>(section: &str) -> Vec<Described> {
        let describe = |number: &Field<T>| {
            let required = (number.get)(&T::BLANK()).is_some();
            let (unit, texts) = Key::find(section, number.name)
                .map_or(("", ["", ""]), |key| (key.unit, [key.form[0], key.meaning]));
            let texts: Vec<&str> = texts.into_iter().filter(|text| !text.is_empty()).collect();
            (number.name, unit, required, texts.join(", "))
        };
        T::NUMBERS.iter().map(describe).collect()
    }
    match section {
        "body" => of::<Body>(section),
        "interface" => of::<Interface>(section),
        _ => of::<Surface>(section),
    }
}

/// The numbers of a record in SI units; an error if one is out of range.
#[pyfunction]
pub(crate) fn checked<'py>(kind: &str, given: &Bound<'py, PyDict>) -> PyResult<Bound<'py, PyDict>> {
    let py = given.py();
    match kind {
        "Body" => numbers(py, &read::<Body>(given)?),
        "Interface" => numbers(py, &read::<Interface>(given)?),
        "Surface" => numbers(py, &read::<Surface>(given)?),
        _ => numbers(py, &read::<Asperity>(given)?),
    }
}

/// The numbers of the interface of bodies, by the names of these; warns of unusual bodies.
#[pyfunction]
pub(crate) fn interface_of<'py>(
    bodies: &Bound<'py, PyDict>,
    work_of_adhesion: Option<&Object<'py>>,
) -> PyResult<Bound<'py, PyDict>> {
    let (py, names) = (bodies.py(), bodies.keys().extract::<Vec<String>>()?);
    let read = names.iter().zip(bodies.values()).map(|(name, body)| instance(name, &body));
    let bodies = read.collect::<PyResult<Vec<Body>>>()?;
    let mut found = asperity_scene::interface_of(&bodies).map_err(refused)?;
    // Findings of the interface appear in its scene.
    if found.findings().is_empty() {
        for (name, body) in names.iter().zip(&bodies) {
            body.findings().into_iter().try_for_each(|f| warn(py, &f.within(name), 2))?;
        }
    }
    let adhesion = work_of_adhesion.map(|given| number("Interface", "work_of_adhesion", given));
    found.work_of_adhesion = adhesion.transpose()?;
    numbers(py, &found)
}

/// The numbers of a surface that follows from three others, and these in SI units; those of a
/// plasticity index need the interface.
#[pyfunction]
pub(crate) fn surface_of<'py>(
    given: &Bound<'py, PyDict>,
    interface: Option<&Object<'py>>,
) -> PyResult<(Bound<'py, PyDict>, Option<Bound<'py, PyDict>>)> {
    let (py, roughness) = (given.py(), roughness(given)?);
    let interface = interface.map(|interface| instance("interface", interface)).transpose()?;
    let found = roughness.surface(&interface.unwrap_or_else(Interface::BLANK)).map_err(refused)?;
    let is_of_surface = roughness.way.is_of_surface();
    let origin = is_of_surface.then(|| by_key(py, roughness)).transpose()?;
    Ok((numbers(py, &found)?, origin))
}

/// The sums of the spectral moments of two surfaces.
#[pyfunction]
pub(crate) fn moments_of_both<'py>(
    one: &Object<'py>,
    other: &Object<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let moments = |given: &Object<'py>| -> PyResult<ProfileMoments> {
        let own = instance::<Surface>("surface", given)?;
        let origin: Option<Bound<'_, PyDict>> = given.getattr("_origin")?.extract()?;
        let roughness = origin.map(|origin| roughness(&origin)).transpose()?;
        Ok(roughness.map_or_else(|| own.moments(), |roughness| roughness.moments(&own)))
    };
    let other = instance::<Surface>("other", other).and_then(|_| moments(other))?;
    by_key(one.py(), Roughness::of_moments(moments(one)?.plus(&other)))
}

/// A number that follows from a surface or an asperity.
#[pyfunction]
pub(crate) fn derived(record: &Object<'_>, name: &str) -> PyResult<f64> {
    let surface = || instance::<Surface>("surface", record);
    let asperity = || instance::<Asperity>("asperity", record);
    match name {
        "roughness_parameter" => Ok(surface()?.roughness_parameter()),
        "mean_plane_offset" => Ok(surface()?.mean_plane_offset()),
        "critical_interference" => asperity()?.critical_interference().map_err(refused),
        _ => asperity()?.critical_force().map_err(refused),
    }
}

/// The materials of scene files: name in text, numbers and source, by their names.
#[pyfunction]
pub(crate) fn materials(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let all = PyDict::new(py);
    for material in asperity_scene::materials() {
        let body = record(py, &material.body)?;
        all.set_item(&material.id, (&material.name, body, &material.source))?;
    }
    Ok(all)
}

/// The body of a material.
#[pyfunction]
pub(crate) fn material<'py>(py: Python<'py>, name: &str) -> PyResult<Object<'py>> {
    let all = asperity_scene::materials();
    let found = all.iter().find(|material| material.id == name).ok_or_else(|| {
        let near = asperity::nearest_name(name, all.iter().map(|known| &*known.id));
        let near = asperity::nearest_hint(near);
        let needed = "a material of asperity.materials() was required";
        PyValueError::new_err(format!("material is {name:?}{near}: {needed}"))
    })?;
    record(py, &found.body)
}
