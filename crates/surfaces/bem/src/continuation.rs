//! How a scan continues beyond its edges.

use std::fmt;

use asperity_core::{Code, Finding};
use serde::{Deserialize, Serialize};

use crate::seam::{LARGEST_KINK, LARGEST_STEP};
use crate::{Boundary, HeightMap};

/// How a scan is pressed, besides its heights and the bodies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BemOptions {
    /// How it continues beyond its edges; by default as [`Continuation::of`] says.
    pub boundary: Option<Continuation>,
    /// Whether the hardness is ignored, so that pressures are unlimited.
    pub elastic: bool,
}

/// How a scan continues beyond its edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Continuation {
    /// Repeated as it is, with the steps at its edges: for a surface known to be periodic.
    Periodic,
    /// Its [periodic component](HeightMap::periodic_part) is repeated, without steps.
    PeriodicPart,
    /// A free half-space around the scan as it is.
    Free,
}

impl Continuation {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Periodic, Self::PeriodicPart, Self::Free];

    /// Its name in options and answers: `periodic`, `periodic-part`, `free`.
    #[must_use]
    pub fn name(self) -> &'static str {
        ["periodic", "periodic-part", "free"][self as usize]
    }

    /// The continuation of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|one| one.name() == name)
    }

    /// The default for a map not declared periodic: its periodic component if its edges do not
    /// [match](HeightMap::edges_meet), free if they do and its slopes do not, as of a ball or a
    /// cylinder that fills the map, and otherwise repetition.
    #[must_use]
    pub fn of(map: &HeightMap) -> Self {
        match map.edges_meet() {
            false => Self::PeriodicPart,
            true if map.seam_kink() > LARGEST_KINK => Self::Free,
            true => Self::Periodic,
        }
    }

    /// A note on this default of a map, where its edges do not match in height or slope.
    pub(crate) fn note(self, map: &HeightMap) -> Option<Finding> {
        match self {
            Self::Periodic => None,
            Self::PeriodicPart => {
                let step = map.seam_step();
                let found = Finding::note(Code::PeriodicPart, "seam_step", step)
                    .usual([0.0, LARGEST_STEP])
                    .fact(format!(
                        "the edges of the scan do not match (step {step:.1} times that between neighbours)"
                    ))
                    .advice(
                        "its periodic component is used; boundary \"periodic\", or periodic = true, uses the scan with this step, boundary \"free\" without repetition",
                    );
                Some(found)
            }
            Self::Free => {
                let kink = map.seam_kink();
                let found = Finding::note(Code::SingleBody, "seam_kink", kink)
                    .usual([0.0, LARGEST_KINK])
                    .fact(format!(
                        "the edges of the scan match, but its slope changes there {kink:.0} times as much as inside"
                    ))
                    .advice(
                        "the scan is taken as a single body (boundary \"free\"); boundary \"periodic\", or periodic = true, repeats it",
                    );
                Some(found)
            }
        }
    }

    /// The map that is pressed.
    #[must_use]
    pub fn applied(self, map: HeightMap) -> HeightMap {
        if self == Self::PeriodicPart { map.periodic_part() } else { map }
    }

    /// The boundary of the half-space.
    #[must_use]
    pub fn boundary(self) -> Boundary {
        match self {
            Self::Periodic | Self::PeriodicPart => Boundary::Periodic,
            Self::Free => Boundary::Free,
        }
    }
}

impl fmt::Display for Continuation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
