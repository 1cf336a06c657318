//! Answers that are right and still deserve a word.

use std::fmt;

use serde::Serialize;

use crate::{At, ContactError, Evaluation, Quantity, Scene};

/// Something a user should know of an answer. The answer stands.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "code", rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Warning {
    /// A total is negative because the model subtracts a part of its law (AT as printed).
    Negative {
        /// The model.
        model: String,
        /// The quantity.
        quantity: Quantity,
        /// In how many rows.
        count: usize,
        /// Where first, as it was asked.
        at: At,
        /// The value there, in SI units.
        value: f64,
    },
    /// A value is negative because the surfaces attract each other.
    Adhesion {
        /// The model.
        model: String,
        /// The quantity.
        quantity: Quantity,
        /// In how many rows.
        count: usize,
        /// Where first, as it was asked.
        at: At,
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
        /// In how many rows.
        count: usize,
        /// Where first, as it was asked.
        at: At,
        /// Natural logarithm of the absolute value there.
        ln_value: f64,
    },
    /// The asperities' contacts would cover more than there is: such a load or approach is beyond
    /// what asperities that do not feel each other can describe.
    AreaAboveNominal {
        /// The model.
        model: String,
        /// In how many rows.
        count: usize,
        /// Where first, as it was asked.
        at: At,
        /// Real over nominal area there.
        fraction: f64,
    },
    /// No asperity is high enough to touch, so that ratios have no value.
    NoContact {
        /// The model.
        model: String,
        /// In how many rows.
        count: usize,
        /// Where first, as it was asked.
        at: At,
    },
    /// Parts of different sign cancel, as next to where a force crosses 0 or turns: what is left is
    /// known less well than what went in.
    Cancelled {
        /// The model.
        model: String,
        /// What they leave.
        quantity: Quantity,
        /// In how many rows.
        count: usize,
        /// Where worst, as it was asked.
        at: At,
        /// The [condition](Evaluation::condition) there.
        condition: f64,
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
            Self::Negative { model, quantity, count, at, value } => write!(
                f,
                "{model}: the {quantity} is negative in {}, first at {at} ({value:.4e} {}): the model subtracts more than it adds there",
                rows(*count),
                quantity.unit()
            ),
            Self::Adhesion { model, quantity, count, at, value } => {
                let why = match quantity.origin() {
                    Quantity::Force => "adhesion pulls the surfaces together there",
                    _ => {
                        "the pull of adhesion grows on approach there, and a dead load is not held: solve --all, or separations_at, shows every separation; the smallest is the one reached when pulling"
                    }
                };
                write!(
                    f,
                    "{model}: the {quantity} is negative in {}, first at {at} ({value:.4e} {}): {why}",
                    rows(*count),
                    quantity.unit()
                )
            }
            Self::Underflow { model, quantity, count, at, ln_value } => write!(
                f,
                "{model}: the {quantity} is too small for a double in {}, first at {at}, and reads 0 there: its natural logarithm is {ln_value:.6}",
                rows(*count)
            ),
            Self::AreaAboveNominal { model, count, at, fraction } => write!(
                f,
                "{model}: the area is above the nominal area in {}, first at {at} ({fraction:.4} times): asperities that do not feel each other cannot describe this",
                rows(*count)
            ),
            Self::NoContact { model, count, at } => write!(
                f,
                "{model}: no asperity touches in {}, first at {at}: logarithms, shares and the mean pressure have no value there",
                rows(*count)
            ),
            Self::Cancelled { model, quantity, count, at, condition } => {
                let known = match KNOWN * condition {
                    part if part < 1.0 => format!("only to {part:.0e} of itself"),
                    _ => "to no digit at all".into(),
                };
                let turns = match quantity {
                    Quantity::Tangent => {
                        ": the force turns near there, and a load says little of where"
                    }
                    _ => "",
                };
                write!(
                    f,
                    "{model}: parts of the {quantity} cancel in {}, most at {at}: inputs known to {KNOWN:e} of themselves give it {known} there{turns}",
                    rows(*count)
                )
            }
            Self::NegativeAngleDensity { model, minimum } => write!(
                f,
                "{model}: the angle density falls to 4 pi psi = {minimum:.5}; its a21 and b21 terms average out and change no result"
            ),
        }
    }
}

/// The sentence on conditioning takes an input that is known so well.
const KNOWN: f64 = 1e-6;
/// Conditions beyond this are told.
pub(crate) const CANCELLED: f64 = 100.0;

fn rows(count: usize) -> String {
    if count == 1 { "1 row".into() } else { format!("{count} rows") }
}

/// What is odd about values as they come: each cause once, whatever quantity shows it.
#[derive(Debug, Clone, Default)]
pub struct Warnings {
    seen: Vec<(Option<Quantity>, Warning)>,
    adhesive: bool,
}

impl Warnings {
    /// Of a model whose surfaces attract each other.
    #[must_use]
    pub fn of_adhesion() -> Self {
        Self { adhesive: true, ..Self::default() }
    }

    /// Looks at one value, or at why there is none. `behind` tells the value whose sign a logarithm
    /// or share hides, where it may be negative.
    pub fn look_at(
        &mut self,
        model: &str,
        quantity: Quantity,
        row: Result<&Evaluation, &ContactError>,
        at: At,
        scene: &Scene,
        behind: impl FnOnce(Quantity) -> Option<f64>,
    ) {
        let name = || model.to_string();
        let evaluation = match row {
            Ok(evaluation) => evaluation,
            Err(ContactError::NoValue { .. }) => {
                return self.count(quantity, Warning::NoContact { model: name(), count: 1, at });
            }
            Err(_) => return,
        };
        let value = evaluation.value();
        let (of, signed) = match quantity.is_absolute() {
            true => (quantity.origin(), behind(quantity.origin()).unwrap_or(0.0)),
            false => (quantity, value),
        };
        if signed < 0.0 {
            let (model, value) = (name(), signed);
            let new = match self.adhesive {
                true => Warning::Adhesion { model, quantity: of, count: 1, at, value },
                false => Warning::Negative { model, quantity: of, count: 1, at, value },
            };
            self.count(quantity, new);
        }
        if value == 0.0 && evaluation.scaled != 0.0 && !quantity.is_absolute() {
            let (model, ln_value) = (name(), evaluation.ln_value());
            self.count(quantity, Warning::Underflow { model, quantity, count: 1, at, ln_value });
        }
        let condition = evaluation.condition();
        if condition > CANCELLED && !quantity.is_absolute() && !self.adhesive {
            let model = name();
            self.count(quantity, Warning::Cancelled { model, quantity, count: 1, at, condition });
        }
        let nominal = if quantity == Quantity::Area { scene.nominal_area } else { 1.0 };
        if matches!(quantity, Quantity::Area | Quantity::AreaFraction) && value > nominal {
            let (model, fraction) = (name(), value / nominal);
            self.count(quantity, Warning::AreaAboveNominal { model, count: 1, at, fraction });
        }
    }

    /// Adds what was odd about the rows that follow.
    pub fn append(&mut self, following: impl IntoIterator<Item = Warning>) {
        for mut new in following {
            match self.seen.iter_mut().find(|(_, known)| known.cause() == new.cause()) {
                Some((_, known)) => known.add(&mut new),
                None => self.seen.push((None, new)),
            }
        }
    }

    /// What another quantity has shown is not counted again.
    fn count(&mut self, shown_by: Quantity, mut new: Warning) {
        match self.seen.iter_mut().find(|(_, known)| known.cause() == new.cause()) {
            Some((by, known)) if *by == Some(shown_by) => known.add(&mut new),
            Some(_) => {}
            None => self.seen.push((Some(shown_by), new)),
        }
    }

    /// All of it, in the order in which it was seen.
    #[must_use]
    pub fn into_vec(self) -> Vec<Warning> {
        self.seen.into_iter().map(|(_, warning)| warning).collect()
    }
}

impl Warning {
    /// In how many rows it was seen, where that is counted.
    fn rows(&mut self) -> Option<&mut usize> {
        match self {
            Self::Negative { count, .. }
            | Self::Adhesion { count, .. }
            | Self::Underflow { count, .. }
            | Self::AreaAboveNominal { count, .. }
            | Self::NoContact { count, .. }
            | Self::Cancelled { count, .. } => Some(count),
            Self::NegativeAngleDensity { .. } => None,
        }
    }

    fn add(&mut self, other: &mut Self) {
        if let (Some(count), Some(more)) = (self.rows(), other.rows()) {
            *count += *more;
        }
        if let (
            Self::Cancelled { at, condition, .. },
            Self::Cancelled { at: other, condition: worse, .. },
        ) = (self, other)
            && *worse > *condition
        {
            (*at, *condition) = (*other, *worse);
        }
    }

    /// What tells it from others.
    fn cause(&self) -> (std::mem::Discriminant<Self>, Option<Quantity>) {
        let quantity = match self {
            Self::Negative { quantity, .. }
            | Self::Adhesion { quantity, .. }
            | Self::Underflow { quantity, .. }
            | Self::Cancelled { quantity, .. } => Some(*quantity),
            _ => None,
        };
        (std::mem::discriminant(self), quantity.map(Quantity::origin))
    }
}
