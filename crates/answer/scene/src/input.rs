//! Numbers of a scene that can be read and replaced, by the sections in which they are written.

use crate::keys::{BODIES, COUNTERFACE, Field, OF_PAIR, SECOND};
use crate::spec::{Bodies, SceneSpec, SurfaceSpec};

/// The numbers of the contact as a whole.
pub(crate) const SCENE: &[Field<SceneSpec>] = &[Field {
    name: "nominal_area",
    get: |of| Some(of.nominal_area),
    set: |of, value| of.nominal_area = value,
}];

/// The numbers of one rough surface beside those that describe it.
pub(crate) const OWN: &[Field<SurfaceSpec>] = &[
    Field {
        name: "mean_plane_offset",
        get: |of| of.mean_plane_offset,
        set: |of, value| of.mean_plane_offset = Some(value),
    },
    Field {
        name: "peklenik_number",
        get: |of| of.peklenik_number,
        set: |of, value| of.peklenik_number = Some(value),
    },
];

/// A number of a scene that can be read and replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SceneInput {
    pub(crate) of: Of,
    pub(crate) key: &'static str,
}

/// What a number describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Of {
    /// The contact as a whole.
    Scene,
    Interface,
    /// One body, by its index.
    Body(usize),
    /// Every body.
    Bodies,
    /// The first surface or the second.
    Surface(bool),
    Heights,
    Curvature,
    Gap,
    Seal,
}

impl SceneInput {
    /// Its name: that of its key, of a body or the second surface behind theirs.
    pub(crate) fn name(self) -> String {
        let before = match self.of {
            Of::Body(k) => BODIES[k],
            Of::Surface(true) => SECOND,
            _ => "",
        };
        format!("{before}{}", self.key)
    }

    /// The section of a scene file in which it is written.
    pub(crate) fn section(self, bodies: &Bodies) -> &'static str {
        match self.of {
            Of::Interface if bodies.list().is_empty() => "interface",
            Of::Scene | Of::Interface => "",
            Of::Body(0) => "body[1]",
            Of::Body(_) => "body[2]",
            Of::Bodies => "body",
            Of::Surface(second) => ["surface", COUNTERFACE][usize::from(second)],
            Of::Heights => "surface.heights",
            Of::Curvature => "curvature",
            Of::Gap => "gap",
            Of::Seal => "seal",
        }
    }

    /// Whether this number replaces another one.
    pub(crate) fn sets(self, other: Self) -> bool {
        let is_of_all = matches!((self.of, other.of), (Of::Bodies, Of::Body(_)));
        self == other || is_of_all && self.key == other.key
    }

    /// Whether a number has no meaning beside another one.
    pub(crate) fn excludes(self, other: Self) -> bool {
        match (self.of, other.of) {
            (Of::Bodies, Of::Body(_)) => self.key == other.key,
            (Of::Interface, Of::Body(_) | Of::Bodies) => {
                let is_elastic = ["youngs_modulus", "poissons_ratio"].contains(&other.key);
                is_elastic && !OF_PAIR.contains(&self.key)
            }
            _ => false,
        }
    }
}
