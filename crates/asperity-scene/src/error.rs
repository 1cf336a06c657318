//! Errors of scene files: where, what was found, what is needed.

use std::fmt;
use std::path::PathBuf;

use asperity::ContactError;

/// Where in a scene file (or in a file that it names) something stands.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Place {
    /// The file; `None` for text that came from no file.
    pub file: Option<PathBuf>,
    /// Its line, counted from 1, where one can be told.
    pub line: Option<usize>,
    /// The field, with its section: `surface.asperity_radius`, `body[2].hardness`.
    pub field: String,
}

impl Place {
    /// A field that stands in no file, as an option given by keyword.
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
            (Some(file), None) => write!(f, "{}: ", file.display())?,
            (None, Some(line)) => write!(f, "line {line}: ")?,
            (None, None) => {}
        }
        f.write_str(&self.field)
    }
}

/// Why a scene file was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SceneError {
    /// A file could not be read.
    #[error("{at} cannot be read: {reason}")]
    Unreadable {
        /// The file, and the field that names it.
        at: Box<Place>,
        /// The system's own words.
        reason: String,
    },
    /// A file could not be written, or no file can hold this value.
    #[error("{at} cannot be written: {reason}")]
    Unwritable {
        /// The file, or the field.
        at: Box<Place>,
        /// The reason, from the system for files.
        reason: String,
    },
    /// The text is not TOML, or not CSV.
    #[error("{at}: {reason}")]
    Syntax {
        /// Where.
        at: Box<Place>,
        /// The parser's own words.
        reason: String,
    },
    /// A key that its section does not have.
    #[error("{at} is not known{}: {allowed}", suggestion(.near))]
    UnknownKey {
        /// The key.
        at: Box<Place>,
        /// The nearest known key of the section, if one is near.
        near: Option<String>,
        /// What is allowed there.
        allowed: String,
    },
    /// A value of the wrong kind, out of its range, or not one of the words allowed.
    #[error("{at} is {found}{}: {needed} was required", suggestion(.near))]
    Value {
        /// The field.
        at: Box<Place>,
        /// What was found.
        found: String,
        /// The nearest word that is allowed, if one is near.
        near: Option<String>,
        /// What is needed.
        needed: String,
    },
    /// A field that is needed.
    #[error("{at} is missing: {needed}")]
    Missing {
        /// The field, at the line of its section.
        at: Box<Place>,
        /// Who needs it, or what it should be.
        needed: String,
    },
    /// Two fields that exclude each other.
    #[error("{at} and {} exclude each other: {needed} was required", place_without_file(.other))]
    Conflict {
        /// The one.
        at: Box<Place>,
        /// The other.
        other: Box<Place>,
        /// What is needed.
        needed: String,
    },
    /// A measured surface could not be read, or has no asperities.
    #[error("{at}: {reason}")]
    Measured {
        /// The field that names its file.
        at: Box<Place>,
        /// The file, what was found in it, and what was required.
        reason: String,
    },
    /// The scene was read, and the library refuses it.
    #[error("{at}: {source}")]
    Contact {
        /// The section.
        at: Box<Place>,
        /// The library's own words.
        source: ContactError,
    },
}

fn suggestion(near: &Option<String>) -> String {
    near.as_ref().map_or(String::new(), |near| format!(" (did you mean {near:?}?)"))
}

fn place_without_file(place: &Place) -> String {
    place.line.map_or_else(|| place.field.clone(), |line| format!("{} (line {line})", place.field))
}

impl SceneError {
    /// A value that was found, and what is needed in its stead.
    pub(crate) fn value(at: Box<Place>, found: impl fmt::Debug, needed: &str) -> Self {
        let (found, needed) = (format!("{found:?}"), needed.trim_end_matches(',').into());
        Self::Value { at, found, near: None, needed }
    }

    /// A refusal of the library, told of the field of the scene file that it concerns: `at` gives
    /// the place of a field's name.
    pub(crate) fn from_contact(source: ContactError, at: impl Fn(&str) -> Box<Place>) -> Self {
        match source {
            ContactError::OutOfRange { field, value, required } => {
                Self::value(at(field), value, required)
            }
            ContactError::Missing { field, needed_by } => {
                Self::Missing { at: at(field), needed: format!("{needed_by} needs it") }
            }
            source => Self::Contact { at: at(""), source },
        }
    }
}
