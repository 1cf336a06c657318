//! Answers that are right and still deserve a word.

use std::fmt;

use crate::Quantity;

/// Something a user should know of an answer. The answer stands.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Warning {
    /// A total is negative because the model subtracts a part of its law (AT as printed).
    Negative {
        /// The model.
        model: String,
        /// The quantity.
        quantity: Quantity,
        /// At how many of the asked separations.
        count: usize,
        /// The first of these separations, over σ_z.
        separation: f64,
        /// The value there, in SI units.
        value: f64,
    },
    /// A value is below the smallest number a double can hold, and reads as 0; its logarithm is
    /// not lost.
    Underflow {
        /// The model.
        model: String,
        /// The quantity.
        quantity: Quantity,
        /// At how many of the asked separations.
        count: usize,
        /// The first of these separations, over σ_z.
        separation: f64,
        /// Natural logarithm of the absolute value there.
        ln_value: f64,
    },
    /// The asperities' contacts would cover more than there is: such a load or approach is beyond
    /// what asperities that do not feel each other can describe.
    AreaAboveNominal {
        /// The model.
        model: String,
        /// At how many of the asked separations.
        count: usize,
        /// The first of these separations, over σ_z.
        separation: f64,
        /// Real over nominal area there.
        fraction: f64,
    },
    /// No asperity is high enough to touch, so that ratios have no value.
    NoContact {
        /// The model.
        model: String,
        /// At how many of the asked separations.
        count: usize,
        /// The first of these separations, over σ_z.
        separation: f64,
    },
    /// The angle density that a model's paper prints is negative for some directions. No result
    /// depends on the terms that make it so.
    NegativeAngleDensity {
        /// The model.
        model: String,
        /// Its smallest value, 4π ψ.
        minimum: f64,
    },
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Negative { model, quantity, count, separation, value } => write!(
                f,
                "{model}: the {quantity} is negative at {count} of the separations, first at {separation} asperity_height_std ({value:.4e} {}): the model subtracts more than it adds there",
                quantity.unit()
            ),
            Self::Underflow { model, quantity, count, separation, ln_value } => write!(
                f,
                "{model}: the {quantity} is too small for a double at {count} of the separations, first at {separation} asperity_height_std, and reads 0 there: its natural logarithm is {ln_value:.6}"
            ),
            Self::AreaAboveNominal { model, count, separation, fraction } => write!(
                f,
                "{model}: the area is above the nominal area at {count} of the separations, first at {separation} asperity_height_std ({fraction:.4} times): asperities that do not feel each other cannot describe this"
            ),
            Self::NoContact { model, count, separation } => write!(
                f,
                "{model}: no asperity touches at {count} of the separations, first at {separation} asperity_height_std: shares and the mean pressure have no value there"
            ),
            Self::NegativeAngleDensity { model, minimum } => write!(
                f,
                "{model}: the angle density falls to 4 pi psi = {minimum:.5}; its a21 and b21 terms average out and change no result"
            ),
        }
    }
}
