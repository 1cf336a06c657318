//! Errors of scans: place, value found, value required.

use std::fmt::Display;
use std::io;
use std::path::PathBuf;

use asperity_core::ContactError;
use serde::de::value::{self, StrDeserializer};
use serde::de::{DeserializeOwned, IntoDeserializer};

/// How a program converts a file of another format.
fn conversion(converter: Option<&str>) -> &'static str {
    match converter {
        Some("SurfaceTopography") => {
            "; SurfaceTopography (PyPI) converts it: python3 -c \"import SurfaceTopography as s; s.read_topography('FILE').to_gwy('FILE.gwy')\""
        }
        Some("Gwyddion") => "; Gwyddion reads it and saves it as .gwy",
        _ => "",
    }
}

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
    /// A size above the limit of this crate.
    #[error("{what} is {size}: at most {limit} was required")]
    TooLarge {
        /// The quantity, with its unit.
        what: &'static str,
        /// The size found.
        size: u64,
        /// The largest size accepted.
        limit: u64,
    },
    /// A binary file of unknown format.
    #[error(
        "the file is binary and of unknown format: text, .npy, .x3p, .sur, .gwy or .sdf was required"
    )]
    UnknownFormat,
    /// A file in the format of an instrument, without a reader.
    #[error(
        "the file is in the format {format}, which has no reader here{}",
        conversion(*converter)
    )]
    ForeignFormat {
        /// The name of the format.
        format: &'static str,
        /// The program that converts it, if one does.
        converter: Option<&'static str>,
    },
    /// A picture, which has colours and no heights.
    #[error(
        "the file is a picture ({format}): a map of heights was required, as csv or other text, .npy, .x3p, .sur, .gwy or .sdf"
    )]
    Picture {
        /// The name of the format.
        format: &'static str,
    },
    /// A row of a text file is longer or shorter than the first.
    #[error("line {line} has {found} numbers: {required} were required, as in the first row")]
    RowLength {
        /// The line number, from 1.
        line: usize,
        /// The number of values found.
        found: usize,
        /// The number of values in the first row.
        required: usize,
    },
    /// An invalid part of a file: a line of text, a field, a position.
    #[error("{place}: {found} was found, {required} was required")]
    Content {
        /// The line, the format and its field, or the coordinate.
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
    /// A pixel smaller than an atom: probably a length in metres given with another unit.
    #[error(
        "pixel_size is {value:e} {unit}, which is {metres:e} m and smaller than an atom; {value:e} looks like m, but pixel_size is in the unit of the heights"
    )]
    TinyPixel {
        /// The value given, in the unit.
        value: f64,
        /// The unit.
        unit: String,
        /// The value in metres.
        metres: f64,
    },
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
    /// The share of missing points is too large to fill.
    #[error(
        "the share of missing points is {share:.4}: at most {limit} was required; crop the scan"
    )]
    TooManyToFill {
        /// The share of missing points.
        share: f64,
        /// The largest share that is filled.
        limit: f64,
    },
    /// The equations of the filled heights have no solution of the required accuracy.
    #[error(
        "{points} missing points cannot be filled: heights of similar size around them were required"
    )]
    NotFilled {
        /// The number of missing points.
        points: usize,
    },
    /// An input lies outside its range.
    #[error("{field} is {value:?}: {required} was required")]
    OutOfRange {
        /// Name of the input.
        field: &'static str,
        /// The value given.
        value: f64,
        /// The values accepted and, if one fits, the unit of the value given.
        required: String,
    },
    /// The number of heights is not a multiple of the number of columns.
    #[error(
        "there are {heights} heights in rows of {columns}: a whole number of rows, at least one, was required"
    )]
    Shape {
        /// The number of heights.
        heights: usize,
        /// The number of columns.
        columns: usize,
    },
    /// A height is infinite or too large.
    #[error(
        "the height in row {row}, column {column} (from 0) is {value:e} m: a number of at most 1e9 m in size, or NaN for a missing point, was required"
    )]
    Height {
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// The height \[m\].
        value: f64,
    },
    /// Too few points or summits.
    #[error("there are {found} {what}: at least {required} were required")]
    TooFew {
        /// The objects counted.
        what: &'static str,
        /// The number found.
        found: usize,
        /// The smallest number accepted.
        required: usize,
    },
    /// All heights are equal.
    #[error("the {points} heights are all equal after levelling: a rough surface was required")]
    Flat {
        /// The number of heights.
        points: usize,
    },
    /// The points do not determine the plane or quadric to be removed.
    #[error(
        "the {points} points with a height do not determine the level {level}: points in at least two (plane) or three (quadratic) rows and columns were required"
    )]
    Level {
        /// The form to be fitted.
        level: String,
        /// The number of points with a height.
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
    /// Two scans whose points do not meet.
    #[error(
        "the scans are not aligned: the first has {first}, the second {second}; equal points and pixels were required"
    )]
    NotAligned {
        /// The points or pixels of the first.
        first: String,
        /// Those of the second.
        second: String,
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

impl TopographyError {
    /// Whether a file is in a format without a reader.
    #[must_use]
    pub fn is_format(&self) -> bool {
        matches!(self, Self::ForeignFormat { .. } | Self::Picture { .. } | Self::UnknownFormat)
    }
}

/// A value out of its range.
pub(crate) fn out_of_range(field: &'static str, value: f64, required: &str) -> TopographyError {
    TopographyError::OutOfRange { field, value, required: required.into() }
}

/// Refuses sizes above a limit of this crate.
pub(crate) fn at_most(what: &'static str, size: u64, limit: u64) -> Result<(), TopographyError> {
    if size > limit { Err(TopographyError::TooLarge { what, size, limit }) } else { Ok(()) }
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

/// A file that is not in the format that it seems to have.
pub(crate) fn damaged(format: &'static str, reason: impl Display) -> TopographyError {
    TopographyError::Damaged { format, reason: reason.to_string() }
}

/// A line of a text file that is not what was required, numbered from 1.
pub(crate) fn refuse_line(line: usize, found: &str, required: &str) -> TopographyError {
    let (place, found) = (format!("line {line}"), format!("{:?}", excerpt(found)));
    TopographyError::Content { place, found, required: required.to_owned() }
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
        let names = names.replace('`', "");
        TopographyError::UnknownName { field, found: excerpt(name), names }
    })
}

/// The first 60 characters of a text: a field of a file may have megabytes.
pub(crate) fn excerpt(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
