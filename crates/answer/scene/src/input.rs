//! Numbers of a scene that can be read and replaced.

use asperity::{Body, Interface};

use crate::curvature::Curvature;
use crate::keys::{BODIES, COUNTERFACE, Field, Key, OF_PAIR, SECOND, key_of_input};
use crate::spec::{Bodies, SceneSpec, SurfaceSpec};

/// A number of a scene that can be read and replaced.
#[derive(Debug, Clone, Copy)]
pub struct SceneInput(pub(crate) Input);

#[derive(Debug, Clone, Copy)]
pub(crate) enum Input {
    Interface(Field<Interface>),
    /// A number of one body, by its index.
    Body(usize, Field<Body>),
    /// A number of every body.
    Bodies(Field<Body>),
    /// A number that describes the first surface or the second, by its key.
    Surface(bool, &'static str),
    Curvature(Field<Curvature>),
    Scene(Number),
    Skewness,
}

/// A number of a scene by its name, with functions that read and set it.
pub(crate) type Number = (&'static str, fn(&SceneSpec) -> Option<f64>, fn(&mut SceneSpec, f64));

/// Numbers of a scene beside those of bodies and asperities.
pub(crate) const NUMBERS: [Number; 7] = [
    ("nominal_area", |s| Some(s.nominal_area), |s, x| s.nominal_area = x),
    (
        "mean_plane_offset",
        |s| s.surface.mean_plane_offset,
        |s, x| s.surface.mean_plane_offset = Some(x),
    ),
    ("peklenik_number", |s| s.surface.peklenik_number, |s, x| s.surface.peklenik_number = Some(x)),
    (
        "counterface_mean_plane_offset",
        |s| s.counterface.as_ref()?.mean_plane_offset,
        |s, x| of_second(s, |one| one.mean_plane_offset = Some(x)),
    ),
    (
        "counterface_peklenik_number",
        |s| s.counterface.as_ref()?.peklenik_number,
        |s, x| of_second(s, |one| one.peklenik_number = Some(x)),
    ),
    (
        "gas_conductivity",
        |s| Some(s.gas?.conductivity),
        |s, x| s.gas.iter_mut().for_each(|gas| gas.conductivity = x),
    ),
    (
        "gas_parameter",
        |s| Some(s.gas?.parameter),
        |s, x| s.gas.iter_mut().for_each(|gas| gas.parameter = x),
    ),
];

fn of_second(spec: &mut SceneSpec, set: impl Fn(&mut SurfaceSpec)) {
    spec.counterface.iter_mut().for_each(set);
}

impl SceneInput {
    /// Its name.
    pub(crate) fn name(self) -> String {
        self.0.name()
    }

    /// The section of a scene file in which it is written, and its key.
    pub(crate) fn place(self, bodies: &Bodies) -> (String, &'static str) {
        match self.0 {
            Input::Body(k, Field { name, .. }) => (format!("body[{}]", k + 1), name),
            Input::Bodies(Field { name, .. }) => ("body".into(), name),
            Input::Interface(Field { name, .. }) => {
                (if bodies.list().is_empty() { "interface" } else { "" }.into(), name)
            }
            Input::Surface(second, key) => {
                (if second { COUNTERFACE } else { "surface" }.into(), key)
            }
            Input::Curvature(Field { name, .. }) => ("curvature".into(), name),
            Input::Scene((name, ..)) => {
                let key = key_of_input(name);
                let section = Key::find("", key).map_or("", |key| key.section);
                (if key == name { section } else { COUNTERFACE }.into(), key)
            }
            Input::Skewness => ("surface.heights".into(), "skewness"),
        }
    }
}

impl Input {
    /// Its name: that of its key, of a body or the second surface behind theirs.
    pub(crate) fn name(&self) -> String {
        match self {
            Self::Interface(Field { name, .. }) => (*name).into(),
            Self::Bodies(Field { name, .. }) => (*name).into(),
            Self::Curvature(Field { name, .. }) => (*name).into(),
            Self::Body(k, Field { name, .. }) => format!("{}{name}", BODIES[*k]),
            Self::Surface(second, key) => format!("{}{key}", if *second { SECOND } else { "" }),
            Self::Scene((name, ..)) => (*name).into(),
            Self::Skewness => "skewness".into(),
        }
    }

    /// Whether this number replaces another one.
    pub(crate) fn sets(&self, other: &Self) -> bool {
        let is_of_all = matches!((self, other), (Self::Bodies(all), Self::Body(_, one)) if all.name == one.name);
        is_of_all || self.name() == other.name()
    }

    /// Whether a number has no meaning beside another one.
    pub(crate) fn excludes(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Bodies(all), Self::Body(_, one)) => all.name == one.name,
            (Self::Interface(own), Self::Body(_, body) | Self::Bodies(body)) => {
                let is_elastic = ["youngs_modulus", "poissons_ratio"].contains(&body.name);
                is_elastic && !OF_PAIR.contains(&own.name)
            }
            _ => false,
        }
    }
}
