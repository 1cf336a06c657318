//! Numbers of a scene that can be read and replaced, by the sections in which they are written.

use crate::keys::{Field, PREFIXES, joined};
use crate::spec::{Bodies, SceneSpec, SurfaceSpec};

/// The numbers of the contact as a whole.
pub(crate) const SCENE: &[Field<SceneSpec>] = &[Field {
    name: "nominal_area",
    get: |of| Some(of.nominal_area),
    set: |of, value| of.nominal_area = value,
}];

/// The numbers of two bodies together.
pub(crate) const OF_BOTH: &[Field<SceneSpec>] = &[Field {
    name: "work_of_adhesion",
    get: |of| match &of.bodies {
        Bodies::Each { work_of_adhesion, .. } => *work_of_adhesion,
        Bodies::Interface(_) => None,
    },
    set: |of, value| {
        if let Bodies::Each { work_of_adhesion, .. } = &mut of.bodies {
            *work_of_adhesion = Some(value);
        }
    },
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

/// The sections of each body; `body` is that of both.
pub(crate) const EACH: [&str; 2] = [PREFIXES[0].0, PREFIXES[1].0];

/// A number of a scene that can be read and replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SceneInput {
    /// The section of a scene file in which it is written; numbers that two bodies have together
    /// are written above them.
    pub(crate) section: &'static str,
    pub(crate) key: &'static str,
}

impl SceneInput {
    /// Its name: that of its key, of a body or the second surface behind theirs.
    pub(crate) fn name(self) -> String {
        let own = PREFIXES.iter().find(|(section, _)| *section == self.section);
        format!("{}{}", own.map_or("", |(_, before)| before), self.key)
    }

    /// Its key behind its section.
    pub(crate) fn path(self) -> String {
        joined(self.section, self.key)
    }

    /// Whether setting this number sets that one, too.
    pub(crate) fn sets(self, other: Self) -> bool {
        let is_of_all = self.section == "body" && EACH.contains(&other.section);
        self == other || is_of_all && self.key == other.key
    }
}
