//! Errors: which field, what value, what was required.

use asperity_quadrature::QuadratureError;

use serde::Serialize;

use crate::{At, Quantity, Separation};

/// Why a contact problem was refused or could not be answered.
#[derive(Debug, Clone, PartialEq, thiserror::Error, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum ContactError {
    /// An input lies outside its range.
    #[error("{field} is {value:?}: {required} was required")]
    OutOfRange {
        /// Name of the input, as in the struct or the scene file.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What would have been accepted.
        required: &'static str,
    },
    /// A number in a table lies outside its range.
    #[error("row {row}: {field} is {value:?}: {required} was required")]
    InTable {
        /// The row, counted from 1.
        row: usize,
        /// Name of the column.
        field: &'static str,
        /// What was given.
        value: f64,
        /// What would have been accepted.
        required: &'static str,
    },
    /// An input that this model needs was not given.
    #[error("{field} is missing: {needed_by} needs it")]
    Missing {
        /// Name of the input.
        field: &'static str,
        /// Who needs it.
        needed_by: String,
    },
    /// A quantity was read from a response that was not asked for it.
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
    /// A model was asked for something it cannot tell.
    #[error("{model} cannot give {what}")]
    Unsupported {
        /// The model.
        model: String,
        /// What was asked for.
        what: String,
    },
    /// A ratio or a logarithm was asked for where nothing touches.
    #[error("{quantity} has no value at {at}: no asperity touches there")]
    NoValue {
        /// The quantity.
        quantity: Quantity,
        /// Where it was asked for.
        at: At,
    },
    /// A separation lies outside what can be evaluated.
    #[error(
        "separation is {separation}{}: -1e6 to 1e9 asperity_height_std from the mean of the asperity heights was required",
        in_sigmas(.separation, *.over_sigma)
    )]
    SeparationOutOfRange {
        /// As it was given.
        separation: Separation,
        /// d/σ_z from the mean of the asperity heights.
        over_sigma: f64,
    },
    /// A separation from the surface's mean plane was given where there is none.
    #[error(
        "separations from the mean plane of the surface: gaussian or tabulated heights, or a mean_plane_offset, was required, as no mean plane belongs to exponential and Weibull heights"
    )]
    NoMeanPlane,
    /// A compiled scene was moved to one with another interface or asperity radius.
    #[error(
        "the scene's interface or asperity_radius differs: the laws of the compiled scene depend on them, compile anew"
    )]
    OtherAsperity,
    /// A model, or what stands beside models, refuses for a reason of its own.
    #[error("{model}: {reason}")]
    Refused {
        /// The model.
        model: String,
        /// Its own words.
        reason: String,
    },
    /// A name that no quantity has.
    #[error("quantity {name:?} is not known{}: the quantities are {known}", suggestion(&.near.map(|near| near.to_string())))]
    UnknownQuantity {
        /// What was given.
        name: String,
        /// The nearest quantity, if one is near.
        near: Option<Quantity>,
        /// All known names.
        known: String,
    },
    /// A model was given an option that it does not have, or a value that none is.
    #[error("{model}: {reason}")]
    Option {
        /// The model's id.
        model: String,
        /// What was given, and what would have been accepted.
        reason: String,
    },
    /// A name that no model has.
    #[error("model {name:?} is not known{}: the models are {known}", suggestion(.near))]
    UnknownModel {
        /// What was given.
        name: String,
        /// The nearest known name, if one is near.
        near: Option<String>,
        /// All known names.
        known: String,
    },
    /// The scale of a quantity is beyond what a double can hold.
    #[error(
        "the scale of the {quantity} is {scale:e}: inputs that make it a finite number above 0 were required"
    )]
    Scale {
        /// The quantity.
        quantity: Quantity,
        /// η A_n times the law's value unit, in SI units.
        scale: f64,
    },
    /// The interference unit of a law and the heights have nothing to do with each other.
    #[error(
        "the law's interference unit over asperity_height_std is {ratio:e}: 1e-100 to 1e100 was required"
    )]
    Ratio {
        /// The unit over σ_z.
        ratio: f64,
    },
    /// No separation that is looked at carries this load, or holds this tension.
    #[error("load is {load:?} N: {} was required", reach(*.load, *.largest, *.at))]
    OutOfReach {
        /// The load asked for \[N\].
        load: f64,
        /// The largest force found, of tensions the lowest \[N\].
        largest: f64,
        /// Where it is.
        at: At,
    },
    /// The force varies so wildly between two separations that not all those that carry a load are
    /// found.
    #[error(
        "the separations that carry the load cannot be resolved between {from} and {to}: the force varies too much there"
    )]
    Unresolved {
        /// The lower separation.
        from: At,
        /// The higher one.
        to: At,
    },
    /// A load that is carried so far out that no separation is looked at: heights with a heavy tail.
    #[error(
        "load is {load:?} N: at least {smallest:e} N, the force at {at}, the largest that is looked at, was required"
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
        /// Where it was asked for.
        at: At,
        /// What the quadrature said.
        source: QuadratureError,
    },
}

fn reach(load: f64, largest: f64, at: At) -> String {
    match (load < 0.0, largest < 0.0) {
        (false, _) => {
            format!("a load above 0 and at most {largest:e} N, the largest force found, at {at},")
        }
        (true, true) => format!("a load from {largest:e} N, the greatest tension found, at {at},"),
        // So far below all that is held, the search ends where nothing is.
        (true, false) => {
            "a far smaller tension, such as surfaces hold (pull-off finds the greatest),".into()
        }
    }
}

fn in_sigmas(separation: &Separation, over_sigma: f64) -> String {
    if *separation == Separation::sigmas(separation.value) || over_sigma.is_nan() {
        return String::new();
    }
    format!(" ({over_sigma:?} asperity_height_std)")
}

fn suggestion(near: &Option<String>) -> String {
    near.as_ref().map_or(String::new(), |near| format!(" (did you mean {near:?}?)"))
}

/// `value` if it is finite and positive.
///
/// # Errors
/// [`ContactError::OutOfRange`] naming the field.
pub fn positive(field: &'static str, value: f64) -> Result<f64, ContactError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(ContactError::OutOfRange { field, value, required: "a finite number above 0" })
    }
}
