//! Errors of scans: place, value found, value required.

use std::fmt::Display;
use std::io;
use std::path::PathBuf;

use asperity_core::{ContactError, written};
use serde::de::value::{self, StrDeserializer};
use serde::de::{DeserializeOwned, IntoDeserializer};

/// An error in reading or measuring a surface.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TopographyError {
    /// An error in a file.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// The error in it.
        source: Box<TopographyError>,
    },
    /// The system could not read the file.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// A file in a format that has no reader, or a picture, which has colours and no heights.
    #[error(
        "the file is {found}: text, .npy, .x3p, .sur, .gwy or .sdf with heights was required{advice}"
    )]
    Format {
        /// What the file is.
        found: String,
        /// How a program converts it, if one does.
        advice: &'static str,
    },
    /// An invalid part of a file or a surface: a line of text, a field, a number of points.
    #[error("{place}: {found}; required: {required}")]
    Content {
        /// The line, the format and its field, the coordinate, or what is counted.
        place: String,
        /// The value found.
        found: String,
        /// The value required.
        required: String,
    },
    /// A file that can be read in several ways.
    #[error("{place}: {found}; give {option}: {choices}")]
    Undecided {
        /// The line, table or column.
        place: String,
        /// What has several meanings.
        found: String,
        /// The option that decides.
        option: &'static str,
        /// Its values.
        choices: String,
    },
    /// A file whose parts do not fit together.
    #[error("the file is damaged or not in the format {format}: {reason}")]
    Damaged {
        /// The name of the format.
        format: &'static str,
        /// What does not fit.
        reason: String,
    },
    /// The unit of the heights is missing in the file and in the options.
    #[error(
        "the file does not state the unit of the heights: give unit (\"nm\", \"um\", \"mm\" or \"m\")"
    )]
    UnitMissing,
    /// The distance between points is missing in the file and in the options.
    #[error(
        "the file does not state the distance between points: give pixel_size, in the unit of the heights or with its own"
    )]
    PixelSizeMissing,
    /// An option and the file disagree.
    #[error(
        "{option} is {given}, but {in_file} in the file: leave the option out or correct the file"
    )]
    Contradiction {
        /// Name of the option.
        option: &'static str,
        /// The value given.
        given: String,
        /// The value in the file.
        in_file: String,
    },
    /// The share of missing points is above `max_missing`.
    #[error(
        "the share of missing points is {share:.4}: at most max_missing = {limit} was required"
    )]
    TooManyMissing {
        /// The share of missing points.
        share: f64,
        /// The largest share accepted.
        limit: f64,
    },
    /// An input lies outside its range.
    #[error("{field} is {}: {required} was required", written(*.value))]
    OutOfRange {
        /// Name of the input.
        field: &'static str,
        /// The value given.
        value: f64,
        /// The values accepted and, if one fits, the unit of the value given.
        required: String,
    },
    /// All heights are equal.
    #[error("the {points} heights are all equal after levelling: a rough surface was required")]
    Flat {
        /// The number of heights.
        points: usize,
    },
    /// Summits need an areal scan.
    #[error(
        "summits need 8 neighbours, which a profile does not have: an areal scan or the estimator \"moments\" was required"
    )]
    SummitsOfProfile,
    /// Outliers are replaced before a filter, which spreads them.
    #[error(
        "outliers of a filtered surface cannot be replaced, because a filter spreads them: despike before filter and smooth"
    )]
    Filtered,
    /// An unknown name: of an option or of a channel of the file.
    #[error("{field} is {found:?}: {names} was required")]
    UnknownName {
        /// The option or field.
        field: &'static str,
        /// The name.
        found: String,
        /// The names accepted.
        names: String,
    },
    /// Two surfaces, of which one is described by its summits.
    #[error(
        "the estimator is \"summits\": \"moments\" was required for two surfaces, because moments add and summits do not"
    )]
    SummitsOfTwo,
    /// Moments that no isotropic Gaussian surface has.
    #[error("{0}; the estimator \"summits\" does not assume a Gaussian surface")]
    Moments(#[source] ContactError),
    /// A surface in which an estimator finds no asperities.
    #[error("{0}")]
    NoAsperities(String),
    /// Asperity parameters out of range.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// A value out of its range.
pub(crate) fn out_of_range(field: &'static str, value: f64, required: &str) -> TopographyError {
    TopographyError::OutOfRange { field, value, required: required.into() }
}

/// Refuses sizes above a limit of this crate.
pub(crate) fn at_most(what: &'static str, size: u64, limit: u64) -> Result<(), TopographyError> {
    if size > limit { Err(refuse(what, size, format_args!("at most {limit}"))) } else { Ok(()) }
}

/// A part of a file that is not what was required.
pub(crate) fn refuse(
    place: impl Display,
    found: impl Display,
    required: impl Display,
) -> TopographyError {
    let found = excerpt(&found.to_string());
    TopographyError::Content { place: place.to_string(), found, required: required.to_string() }
}

/// A part of a file that an option has to decide.
pub(crate) fn undecided(
    place: String,
    found: String,
    option: &'static str,
    choices: &str,
) -> TopographyError {
    TopographyError::Undecided { place, found, option, choices: choices.to_owned() }
}

/// An unknown name of an option or a field.
pub(crate) fn unknown_name(
    field: &'static str,
    found: &str,
    names: impl Into<String>,
) -> TopographyError {
    TopographyError::UnknownName { field, found: excerpt(found.trim()), names: names.into() }
}

/// A file that is not in the format that it seems to have.
pub(crate) fn damaged(format: &'static str, reason: impl Display) -> TopographyError {
    TopographyError::Damaged { format, reason: reason.to_string() }
}

/// A line of a text file that is not what was required, numbered from 1.
pub(crate) fn refuse_line(line: usize, found: &str, required: &str) -> TopographyError {
    refuse(format_args!("line {line}"), format_args!("{:?}", excerpt(found)), required)
}

/// The names of an enum in text: those of serde.
macro_rules! named {
    ($type:ty, $field:literal) => {
        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                serde::Serialize::serialize(self, f)
            }
        }

        impl std::str::FromStr for $type {
            type Err = TopographyError;

            fn from_str(name: &str) -> Result<Self, TopographyError> {
                $crate::error::parse_name($field, name)
            }
        }
    };
}
pub(crate) use named;

/// The value of a name; serde has the lists of names.
pub(crate) fn parse_name<T: DeserializeOwned>(
    field: &'static str,
    name: &str,
) -> Result<T, TopographyError> {
    let word: StrDeserializer<'_, value::Error> = name.trim().into_deserializer();
    T::deserialize(word).map_err(|error| {
        let error = error.to_string();
        let names = error.rsplit_once(", expected ").map_or(&*error, |(_, names)| names);
        unknown_name(field, name, names.replace('`', ""))
    })
}

/// The first 60 characters of a text: a field of a file may have megabytes.
pub(crate) fn excerpt(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
