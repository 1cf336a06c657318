//! Errors of scene files: place, value found, value needed; and where numbers were written.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use asperity::fit::FitError;
use asperity::{ContactError, nearest_hint};

/// A place in a scene file or in a file that it names.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// The file; `None` for text without a file.
    pub file: Option<PathBuf>,
    /// The line, from 1, if known.
    pub line: Option<usize>,
    /// The field, with its section: `surface.asperity_radius`, `body[2].hardness`.
    pub field: String,
}

impl Place {
    /// A field outside any file, for example an option given by keyword.
    #[must_use]
    pub fn field(field: impl Into<String>) -> Self {
        Self { field: field.into(), ..Self::default() }
    }
}

impl fmt::Display for Place {
    /// `scene.toml:12: surface.m0`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (&self.file, self.line) {
            (Some(file), Some(line)) => write!(f, "{}:{line}: ", file.display())?,
            // The file as a whole.
            (Some(file), None) if self.field.is_empty() => {
                return write!(f, "{}", file.display());
            }
            (Some(file), None) => write!(f, "{}: ", file.display())?,
            (None, Some(line)) => write!(f, "line {line}: ")?,
            (None, None) => {}
        }
        f.write_str(&self.field)
    }
}

/// Where each number of a scene was written: in a line of a file, or as a keyword.
#[derive(Debug, Clone, Default)]
pub struct Provenance {
    pub(crate) file: Option<PathBuf>,
    /// The line of each key and of each section; none for keywords.
    pub(crate) lines: BTreeMap<String, usize>,
    /// The keys of numbers with a unit.
    pub(crate) stated: Vec<String>,
    /// The scans that the scene names.
    pub(crate) files: Vec<PathBuf>,
}

impl Provenance {
    /// The place of a key; a missing key has the line of its section.
    #[must_use]
    pub fn place(&self, path: &str) -> Place {
        let section = path.rsplit_once(['.', '[']).map_or("", |(section, _)| section);
        let line = self.lines.get(path).or_else(|| self.lines.get(section)).copied();
        // The top of a file is its first line.
        let line = line.or(self.lines.get("").copied());
        Place { file: self.file.clone(), line, field: path.into() }
    }

    /// Whether a number was given with its unit, by its path or its key in any section.
    #[must_use]
    pub fn is_stated(&self, key: &str) -> bool {
        self.stated.iter().any(|path| path == key || path.ends_with(&format!(".{key}")))
    }
}

/// An error in a scene file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A file that cannot be read or written, a text that is not TOML or CSV, a surface without
    /// asperities, a scene without a model; a key that its section does not have or needs, or a
    /// value of the wrong kind, out of its range, not one of the allowed names, in another
    /// notation, or beside a field that excludes it.
    #[error("{at}{link}{reason}")]
    Refused {
        /// The field, a missing one at the line of its section, or the field that names the file.
        at: Box<Place>,
        /// Between the field and the reason: ": ", " is ", " = " of a text that is no number, or a
        /// space.
        link: &'static str,
        /// The reason from the system, the parser or the library; or the value found, a similar
        /// name, and the value needed.
        reason: String,
    },
    /// A name that is no number of this scene, or a number that another one determines.
    #[error("{name} {reason}")]
    Input {
        /// The name.
        name: String,
        /// What is wrong with it, and what is required.
        reason: String,
    },
    /// Data or free parameters of a fit are refused, or it was interrupted.
    #[error(transparent)]
    Fit(#[from] FitError),
}

impl SceneError {
    /// The place that the error is about; none for the names and data of fits and sweeps.
    #[must_use]
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Refused { at, .. } => Some(at),
            Self::Input { .. } | Self::Fit(_) => None,
        }
    }

    /// What is wrong, to follow the name of the field, without the [place](Self::place).
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            Self::Refused { reason, .. } | Self::Input { reason, .. } => reason.clone(),
            Self::Fit(error) => error.to_string(),
        }
    }

    /// An error with its reason.
    pub(crate) fn refused(at: impl Into<Box<Place>>, reason: impl Into<String>) -> Self {
        Self::Refused { at: at.into(), link: ": ", reason: reason.into() }
    }

    /// An error for a value, with the value needed instead.
    pub(crate) fn value(at: impl Into<Box<Place>>, found: impl fmt::Debug, needed: &str) -> Self {
        let found = format!("{found:?}");
        let found = found.parse().map_or(found, asperity::written);
        Self::of_names(at, &found, None, needed)
    }

    /// The same with the most similar name, if the value is none of some names.
    pub(crate) fn of_names(
        at: impl Into<Box<Place>>,
        found: &str,
        near: Option<&str>,
        needed: &str,
    ) -> Self {
        Self::wrong(at, format!("{found}{}: {needed} was required", nearest_hint(near)))
    }

    /// A field that is wrong: the reason follows "is".
    pub(crate) fn wrong(at: impl Into<Box<Place>>, reason: String) -> Self {
        Self::Refused { at: at.into(), link: " is ", reason }
    }

    /// Two fields that exclude each other.
    pub(crate) fn conflict(at: Box<Place>, other: &Place, needed: &str) -> Self {
        let line = other.line.map_or(String::new(), |line| format!(" (line {line})"));
        let reason = format!("excludes {}{line}: {needed} was required", other.field);
        Self::Refused { at, link: " ", reason }
    }

    /// A missing field.
    pub(crate) fn missing(at: impl Into<Box<Place>>, needed: &str) -> Self {
        Self::wrong(at, format!("missing: {needed}"))
    }

    /// A number in another notation.
    pub(crate) fn notation(at: Box<Place>, found: &str, hint: &str) -> Self {
        Self::Refused { at, link: " = ", reason: format!("{found} {hint}") }
    }

    /// An error of the library at the field of the scene file; `at` gives the place of a field.
    pub(crate) fn from_contact(source: ContactError, at: impl Fn(&str) -> Box<Place>) -> Self {
        match source {
            ContactError::OutOfRange { field, value, required } => {
                Self::value(at(field), value, required)
            }
            ContactError::Missing { field, reason } => Self::missing(at(field), &reason),
            source => Self::refused(at(""), source.to_string()),
        }
    }
}
