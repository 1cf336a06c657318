//! Errors: which field, what value, what was required.

use asperity_quadrature::QuadratureError;
use serde::Serialize;

use crate::{At, Quantity, Separation, nearest_hint, short, written};

/// Why a contact problem was refused or could not be answered.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ContactError {
    /// An input lies outside its range.
    #[error("{field} is {}: {required} was required", written(*.value))]
    OutOfRange {
        /// Name of the input, as in the struct or the scene file.
        field: &'static str,
        /// The value given.
        value: f64,
        /// The values accepted.
        required: &'static str,
    },
    /// A number in a table lies outside its range.
    #[error("row {row}: {field} is {}: {required} was required", written(*.value))]
    InTable {
        /// The row, counted from 1.
        row: usize,
        /// Name of the column.
        field: &'static str,
        /// The value given.
        value: f64,
        /// The values accepted.
        required: &'static str,
    },
    /// An input that this model needs was not given.
    #[error("{field} is missing: {reason}")]
    Missing {
        /// Name of the input.
        field: &'static str,
        /// Which model or quantity needs it, or what to set.
        reason: String,
    },
    /// A quantity was read that the request does not list.
    #[error("{quantity} was not requested: add it to the request's quantities")]
    NotRequested {
        /// The quantity.
        quantity: Quantity,
    },
    /// A model was asked for a law it does not have.
    #[error("{model} has no law for {quantity}")]
    NoLaw {
        /// The model.
        model: String,
        /// The quantity.
        quantity: Quantity,
    },
    /// The model does not provide this.
    #[error("{model} cannot give {what}")]
    Unsupported {
        /// The model.
        model: String,
        /// The quantity or service requested.
        what: String,
    },
    /// A ratio or a logarithm where no asperity is in contact.
    #[error("{quantity} has no value at {at}: no asperity is in contact there")]
    NoValue {
        /// The quantity.
        quantity: Quantity,
        /// The separation or load.
        at: At,
    },
    /// A separation outside the range that can be evaluated.
    #[error(
        "separation is {separation}{}: -1e6 to 1e9 asperity_height_std from the mean of the asperity heights was required",
        in_sigmas(.separation, *.over_sigma)
    )]
    SeparationOutOfRange {
        /// The separation as given.
        separation: Separation,
        /// d/σ_z from the mean of the asperity heights.
        over_sigma: f64,
    },
    /// A separation is no number, or is below the range of a table.
    #[error(
        "{field} is {separation}: {deepest} or more, the deepest separation of the table, was required"
    )]
    BelowTable {
        /// Name of the input.
        field: &'static str,
        /// The separation given.
        separation: Separation,
        /// The smallest of the table.
        deepest: Separation,
    },
    /// A separation from the mean plane of the surface, for heights without one.
    #[error(
        "separations from the mean plane of the surface need mean_plane_offset with exponential and Weibull heights"
    )]
    NoMeanPlane,
    /// A compiled scene was moved to one with a different interface or asperity radius.
    #[error(
        "interface or asperity_radius differs from the compiled scene, and its laws depend on them: compile the new scene"
    )]
    OtherAsperity,
    /// A model refuses the input, or a value of an option, for a reason of its own.
    #[error("{model}: {reason}")]
    Refused {
        /// The model.
        model: String,
        /// The reason.
        reason: String,
    },
    /// No surface that was solved by boundary elements is like the one of the scene.
    #[error("no boundary-element solution is close: {reason}")]
    NoEvidence {
        /// The property that differs, by its name.
        property: &'static str,
        /// What differs.
        reason: String,
    },
    /// An unknown name of a quantity or a model.
    #[error("{what} {name:?} is not known{}{help}", nearest_hint(.near.as_ref()))]
    UnknownName {
        /// `quantity` or `model`.
        what: &'static str,
        /// The value given.
        name: String,
        /// The nearest known name, if one is near.
        near: Option<String>,
        /// Where the known names are, to follow the text.
        help: String,
    },
    /// The scale of a quantity exceeds the range of f64.
    #[error(
        "the scale of the {quantity} is {scale:e}, outside the range of f64: check the units of the inputs"
    )]
    Scale {
        /// The quantity.
        quantity: Quantity,
        /// η A_n times the law's value unit, or that over σ_z for slopes, in SI units.
        scale: f64,
    },
    /// No separation carries this load or holds this tension.
    #[error("load is {} N{}", written(*.load), reach(*.load, *.largest, *.at))]
    OutOfReach {
        /// The load asked for \[N\].
        load: f64,
        /// The largest force found, of tensions the lowest \[N\].
        largest: f64,
        /// Where it is.
        at: At,
    },
    /// The force varies too much between two separations to find those that carry the load.
    #[error(
        "law or heights vary too much between {from} and {to} to find every separation that carries the load: request the largest separation alone, or declare the kinks of the law and the breaks of the heights"
    )]
    Unresolved {
        /// The lower separation.
        from: At,
        /// The upper separation.
        to: At,
    },
    /// A load so light that it is carried beyond the largest separation: heights with a heavy tail.
    #[error(
        "load is {} N: at least {} N, the force at the largest separation ({}), was required",
        written(*.load),
        short(*.smallest),
        .at.rounded()
    )]
    TooLight {
        /// The load asked for \[N\].
        load: f64,
        /// The force at the largest separation \[N\].
        smallest: f64,
        /// That separation.
        at: At,
    },
    /// The integral could not be computed.
    #[error("{quantity} at {at}: {source}")]
    Integral {
        /// The quantity asked for.
        quantity: Quantity,
        /// The separation or load.
        at: At,
        /// The reason given by the quadrature.
        source: QuadratureError,
    },
}

fn reach(load: f64, largest: f64, at: At) -> String {
    let (most, at) = (short(largest), at.rounded());
    match (load < 0.0, largest < 0.0) {
        (false, _) => format!(", above {most} N, the largest force of the model, at {at}"),
        (true, true) => format!(": the surfaces pull off at {most} N, at {at}"),
        // The tension is so large that the search ends where no asperity touches.
        (true, false) => ": a smaller tension, or a load above 0, was required".into(),
    }
}

fn in_sigmas(separation: &Separation, over_sigma: f64) -> String {
    if *separation == Separation::sigmas(separation.value) || over_sigma.is_nan() {
        return String::new();
    }
    format!(" ({} asperity_height_std)", written(over_sigma))
}

/// `value` if it is finite and positive.
///
/// # Errors
/// [`ContactError::OutOfRange`] naming the field.
pub fn positive(field: &'static str, value: f64) -> Result<f64, ContactError> {
    require(value.is_finite() && value > 0.0, field, value, "a finite number above 0")
}

/// `value` if it `holds` what was `required`.
///
/// # Errors
/// [`ContactError::OutOfRange`] naming the field.
pub fn require(
    holds: bool,
    field: &'static str,
    value: f64,
    required: &'static str,
) -> Result<f64, ContactError> {
    if holds { Ok(value) } else { Err(ContactError::OutOfRange { field, value, required }) }
}

/// The error of an integral for `quantity` at `at`.
pub fn integral_failed(quantity: Quantity, at: &At) -> impl Fn(QuadratureError) -> ContactError {
    move |source| ContactError::Integral { quantity, at: *at, source }
}
