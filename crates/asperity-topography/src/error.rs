//! Errors: what was found, and what was required.

use std::io;
use std::path::PathBuf;

use asperity_core::ContactError;
use serde::de::value::{self, StrDeserializer};
use serde::de::{DeserializeOwned, IntoDeserializer};

use crate::{LengthUnit, Level};

/// Why a surface could not be read or measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TopographyError {
    /// An error in a file.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What was wrong.
        source: Box<TopographyError>,
    },
    /// The system could not read the file.
    #[error("cannot be read: {0}")]
    Io(#[from] io::Error),
    /// Larger than this crate accepts.
    #[error("{what} is {size}: at most {limit} was required")]
    TooLarge {
        /// What is too large, with its unit.
        what: &'static str,
        /// How large it is.
        size: u64,
        /// How large it may be.
        limit: u64,
    },
    /// No reader knows this file.
    #[error(
        "the format is not known: text (matrix, XYZ, profile), NumPy .npy, .x3p or Digital Surf .sur was required"
    )]
    UnknownFormat,
    /// A line of a text file.
    #[error("line {line}: {found:?} was found, {required} was required")]
    Line {
        /// Its number, from 1.
        line: usize,
        /// What stands there.
        found: String,
        /// What should.
        required: String,
    },
    /// A row of a text file is longer or shorter than the first.
    #[error("line {line} has {found} numbers: {required}, as the first row has, were required")]
    RowLength {
        /// Its number, from 1.
        line: usize,
        /// How many numbers it has.
        found: usize,
        /// How many the first row has.
        required: usize,
    },
    /// A field of a binary or XML file.
    #[error("{format} {field}: {found} was found, {required} was required")]
    Field {
        /// Name of the format.
        format: &'static str,
        /// Name of the field.
        field: &'static str,
        /// What stands there.
        found: String,
        /// What should.
        required: String,
    },
    /// Neither the file nor the options have the unit of the heights.
    #[error(
        "the file has no unit of its heights: give unit (\"nm\", \"um\", \"mm\", \"m\"; --unit on the command line)"
    )]
    UnitMissing,
    /// A cut-off outside the wavelengths of the scan.
    #[error("{field} is {value:?}: {required} was required")]
    Cutoff {
        /// What the cut-off is called.
        field: &'static str,
        /// What was given \[m\].
        value: f64,
        /// The lengths that would have been accepted, and the unit that would explain it.
        required: String,
    },
    /// Pixels smaller than atoms: a length in metres beside a unit.
    #[error(
        "pixel_size is {value:e} {unit}, which is {metres:e} m and less than an atom; {value:e} looks like m, but pixel_size is in the unit of the heights"
    )]
    TinyPixel {
        /// What was given, in the unit.
        value: f64,
        /// The unit.
        unit: LengthUnit,
        /// What that is.
        metres: f64,
    },
    /// Neither the file nor the options have the distance between points.
    #[error(
        "the file has no distance between its points: give pixel_size in the unit of the heights (--pixel-size on the command line)"
    )]
    PixelSizeMissing,
    /// An option and the file disagree.
    #[error(
        "{option} is {given}, but {in_file} in the file: leave the option out or correct the file"
    )]
    Contradiction {
        /// Name of the option.
        option: &'static str,
        /// What was given.
        given: String,
        /// The value in the file.
        in_file: String,
    },
    /// Too many points are missing.
    #[error(
        "the share of missing points is {share:.4}: at most max_missing = {limit} (--max-missing on the command line) was required"
    )]
    TooManyMissing {
        /// The share of missing points.
        share: f64,
        /// The largest that was allowed.
        limit: f64,
    },
    /// More points are missing than may be filled.
    #[error(
        "the share of missing points is {share:.4}: at most {limit} was required; filling more would invent the surface, crop the scan instead"
    )]
    TooManyToFill {
        /// The share of missing points.
        share: f64,
        /// The largest that is filled.
        limit: f64,
    },
    /// The equations of the filled heights were not solved.
    #[error(
        "{points} missing points could not be filled: heights of similar size around them were required"
    )]
    NotFilled {
        /// How many points are missing.
        points: usize,
    },
    /// An input lies outside its range.
    #[error("{field} is {value:?}: {required} was required")]
    OutOfRange {
        /// Name of the input.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What would have been accepted.
        required: &'static str,
    },
    /// The number of heights is not columns times rows.
    #[error(
        "there are {heights} heights in rows of {columns}: a whole number of rows, at least one, was required"
    )]
    Shape {
        /// How many heights.
        heights: usize,
        /// How many columns.
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
        /// What is counted.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many it takes.
        required: usize,
    },
    /// All heights are the same.
    #[error("the {points} heights are all equal after levelling: a rough surface was required")]
    Flat {
        /// How many heights there are.
        points: usize,
    },
    /// The points do not determine the plane or quadric to be removed.
    #[error(
        "the {points} points with a height do not determine the level {level}: points in at least two (plane) or three (quadratic) rows and columns were required"
    )]
    Level {
        /// What was to be fitted.
        level: Level,
        /// How many points there are.
        points: usize,
    },
    /// Summits need an areal scan.
    #[error(
        "a profile has no summits of 8 neighbours: an areal scan, or the estimator \"moments\", was required"
    )]
    SummitsOfProfile,
    /// Columns of points that do not lie on a regular grid.
    #[error("{field}: {found} was found, {required} was required")]
    Grid {
        /// Which coordinate.
        field: &'static str,
        /// What is wrong with it.
        found: String,
        /// What was required.
        required: String,
    },
    /// A name that is none of the known ones.
    #[error("{field} is {found:?}: {known} was required")]
    UnknownName {
        /// What was named.
        field: &'static str,
        /// The name.
        found: String,
        /// The known names.
        known: String,
    },
    /// Two surfaces of which one is known by its summits.
    #[error(
        "the estimator is \"summits\": \"moments\" was required for two surfaces, whose moments add up and whose summits do not"
    )]
    SummitsOfTwo,
    /// The moments are not those of an isotropic Gaussian surface.
    #[error("{0}; the estimator \"summits\" does not assume a Gaussian surface")]
    Moments(#[source] ContactError),
    /// The numbers of the asperities make no surface.
    #[error(transparent)]
    Contact(#[from] ContactError),
}

/// What a name stands for: serde has the lists.
pub(crate) fn named<T: DeserializeOwned>(
    field: &'static str,
    name: &str,
) -> Result<T, TopographyError> {
    let word: StrDeserializer<'_, value::Error> = name.trim().into_deserializer();
    T::deserialize(word).map_err(|error| {
        let error = error.to_string();
        let known = error.rsplit_once(", expected ").map_or(&*error, |(_, known)| known);
        let known = known.replace('`', "");
        TopographyError::UnknownName { field, found: excerpt(name), known }
    })
}

/// At most 60 characters of a text: a file may have megabytes in one field.
pub(crate) fn excerpt(text: &str) -> String {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
