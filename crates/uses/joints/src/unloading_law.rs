//! The laws by which asperities unload.

use std::fmt;
use std::str::FromStr;

use asperity_core::{nearest_hint, nearest_name};

/// The unloading law of an asperity; the documentation of the crate gives equations and sources.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[non_exhaustive]
pub enum UnloadingLaw {
    /// As a Hertzian contact of the force and area at the closest approach.
    #[default]
    Hertz,
    /// Brake 2015: as a sphere of another radius; the area jumps at the start of unloading.
    Brake,
    /// Etsion, Kligerman & Kadin 2005: a fit to finite elements, for force and stiffness only.
    Etsion,
}

impl UnloadingLaw {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Hertz, Self::Brake, Self::Etsion];
}

impl fmt::Display for UnloadingLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Hertz => "hertz",
            Self::Brake => "brake",
            Self::Etsion => "etsion",
        })
    }
}

impl FromStr for UnloadingLaw {
    type Err = String;

    /// Reads the names that [`Display`](fmt::Display) writes, in any case.
    fn from_str(name: &str) -> Result<Self, String> {
        let wanted = name.trim().to_lowercase();
        let found = Self::ALL.into_iter().find(|law| law.to_string() == wanted);
        let names = Self::ALL.map(|law| law.to_string());
        let near = nearest_hint(nearest_name(&wanted, names.iter().map(String::as_str)));
        found.ok_or_else(|| format!("{name:?} is none of {}{near}", names.join(", ")))
    }
}
