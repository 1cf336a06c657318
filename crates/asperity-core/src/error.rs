//! Errors: which field, what value, what was required.

use asperity_quadrature::QuadratureError;

use crate::Quantity;

/// Why a contact problem was refused or could not be answered.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
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
    /// A second derivative was asked for that does not come of the nodes.
    #[error(
        "no second derivative of the {quantity}: a quantity with a law of its own and Gaussian heights were required"
    )]
    NoSecondDerivative {
        /// The quantity.
        quantity: Quantity,
    },
    /// A compiled scene was moved to one with another interface or asperity radius.
    #[error(
        "the scene's interface or asperity_radius differs: the laws of the compiled scene depend on them, compile anew"
    )]
    OtherAsperity,
    /// A model from outside this project refused.
    #[error("{model}: {reason}")]
    Refused {
        /// The model.
        model: String,
        /// Its own words.
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
    /// No separation that is looked at carries this load.
    #[error(
        "load is {load:?} N: a load above 0 and at most {largest:e} N, the force at a separation of {separation:?} asperity_height_std, was required"
    )]
    OutOfReach {
        /// The load asked for \[N\].
        load: f64,
        /// The largest force \[N\].
        largest: f64,
        /// Where it is, over σ_z: the smallest separation that can be evaluated.
        separation: f64,
    },
    /// The integral could not be computed.
    #[error("{quantity} at separation {separation} (in asperity_height_std): {source}")]
    Integral {
        /// The quantity asked for.
        quantity: Quantity,
        /// Separation over the standard deviation of asperity heights.
        separation: f64,
        /// What the quadrature said.
        source: QuadratureError,
    },
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
