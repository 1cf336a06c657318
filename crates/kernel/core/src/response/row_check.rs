//! Findings of rows, as they are answered.

use crate::finding::short;
use crate::{At, Code, ContactError, Evaluation, Finding, Quantity, Scene};

/// A condition number beyond this is reported.
pub(crate) const CANCELLED: f64 = 100.0;
/// The relative accuracy of inputs that the message on cancellation takes.
const ACCURACY: f64 = 1e-6;

/// What can be unusual about a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Oddity {
    Negative,
    Adhesion,
    Underflow,
    AreaAboveNominal,
    NoContact,
    Cancelled,
}

/// One cause, and the rows that show it.
#[derive(Debug, Clone, Copy)]
struct Seen {
    oddity: Oddity,
    quantity: Quantity,
    /// Another quantity that shows the same is not counted again.
    shown_by: Quantity,
    count: usize,
    at: At,
    value: f64,
}

/// Collects findings of the rows of one model; each cause once, whatever quantity shows it. Rows
/// without any take a few comparisons.
#[derive(Debug, Clone, Default)]
pub struct RowCheck {
    seen: Vec<Seen>,
    adhesive: bool,
}

impl RowCheck {
    /// For a model with or without adhesion.
    #[must_use]
    pub fn new(adhesive: bool) -> Self {
        Self { seen: vec![], adhesive }
    }

    /// Checks one value, or the reason why there is none. `behind` returns the value whose sign a
    /// logarithm or share hides, where it may be negative.
    pub fn check(
        &mut self,
        quantity: Quantity,
        row: Result<&Evaluation, &ContactError>,
        at: At,
        scene: &Scene,
        behind: impl FnOnce(Quantity) -> Option<f64>,
    ) {
        let adhesive = self.adhesive;
        let mut found = |oddity, of, value| self.count(oddity, of, quantity, at, value);
        let evaluation = match row {
            Ok(evaluation) => evaluation,
            Err(ContactError::NoValue { .. }) => {
                return found(Oddity::NoContact, Quantity::Contacts, 0.0);
            }
            Err(_) => return,
        };
        let (value, condition) = (evaluation.value(), evaluation.condition());
        let absolute = quantity.is_absolute();
        let (of, signed) = match absolute {
            true => (quantity.origin(), behind(quantity.origin()).unwrap_or(0.0)),
            false => (quantity, value),
        };
        // Of curved bodies, an approach and a separation may have either sign.
        if signed < 0.0 && !quantity.is_of_bodies() {
            found(if adhesive { Oddity::Adhesion } else { Oddity::Negative }, of, signed);
        }
        if value == 0.0 && evaluation.scaled != 0.0 && !absolute {
            found(Oddity::Underflow, quantity, evaluation.ln_value());
        }
        if condition > CANCELLED && !absolute && !adhesive {
            found(Oddity::Cancelled, quantity, condition);
        }
        let nominal = if quantity == Quantity::Area { scene.nominal_area } else { 1.0 };
        if matches!(quantity, Quantity::Area | Quantity::AreaFraction) && value > nominal {
            found(Oddity::AreaAboveNominal, Quantity::Area, value / nominal);
        }
    }

    fn count(&mut self, oddity: Oddity, of: Quantity, shown_by: Quantity, at: At, value: f64) {
        let cause = (oddity, of.origin());
        match self.seen.iter_mut().find(|seen| (seen.oddity, seen.quantity.origin()) == cause) {
            Some(seen) if seen.shown_by == shown_by => {
                seen.count += 1;
                let worst = matches!(oddity, Oddity::Cancelled | Oddity::AreaAboveNominal);
                if worst && value > seen.value {
                    (seen.at, seen.value) = (at, value);
                }
            }
            Some(_) => {}
            None => self.seen.push(Seen { oddity, quantity: of, shown_by, count: 1, at, value }),
        }
    }

    /// The findings, in the order in which they were found: several quantities with one oddity
    /// are one finding.
    #[must_use]
    pub fn finish(&self, model: &str) -> Vec<Finding> {
        let of_model = |found: Finding, s: &Seen| found.of_model(model).at(s.at).in_rows(s.count);
        let of = |oddity| self.seen.iter().filter(move |seen| seen.oddity == oddity);
        let leads = |seen: &&Seen| match seen.oddity {
            Oddity::Underflow => false,
            Oddity::Cancelled => of(seen.oddity).all(|other| other.value <= seen.value),
            Oddity::Negative => {
                of(seen.oddity).next().is_some_and(|first| first.quantity == seen.quantity)
            }
            _ => true,
        };
        let found = self.seen.iter().filter(leads);
        let found = found.map(|seen| of_model(seen.finding(of(seen.oddity)), seen));
        found.chain(self.underflow().map(|(found, most)| of_model(found, most))).collect()
    }

    /// All quantities that read 0, where most rows do.
    fn underflow(&self) -> Option<(Finding, &Seen)> {
        let small = || self.seen.iter().filter(|seen| seen.oddity == Oddity::Underflow);
        // The first of equal ones.
        let most = small().rev().max_by_key(|seen| seen.count)?;
        let each = |text: &dyn Fn(&Seen) -> String, by: &str| {
            small().map(text).collect::<Vec<_>>().join(by)
        };
        let names = each(&|seen| format!("{}", seen.quantity), ", ");
        let logarithms = each(&|seen| format!("{:.6} of {}", seen.value, seen.quantity), ", ");
        let (verb, values) = match small().count() {
            1 => ("is", "value is 0"),
            _ => ("are", "values are 0"),
        };
        let found = Finding::warning(Code::Underflow, "ln_value", most.value)
            .usual([f64::MIN_POSITIVE.ln(), f64::INFINITY])
            .fact(format!("{names} {verb} too small for f64"))
            .advice(format!(
                "the printed {values}, the surfaces hardly touch; natural logarithm {logarithms}"
            ));
        Some((found, most))
    }
}

impl Seen {
    /// With the others of its oddity, itself included.
    fn finding<'s>(&self, same: impl Iterator<Item = &'s Self>) -> Finding {
        let &Self { quantity, value, .. } = self;
        let one = |seen: &Self| {
            let (name, unit) = (seen.quantity, seen.quantity.unit());
            format!("{name} is negative ({:.4e} {unit})", seen.value).replace(" )", ")")
        };
        let negative = |code: Code, fact: String, advice: &'static str| {
            let found = Finding::warning(code, quantity.to_string(), value).unit(quantity.unit());
            found.of_quantity(quantity).fact(fact).advice(advice)
        };
        match self.oddity {
            Oddity::Negative => negative(
                Code::Negative,
                same.map(one).collect::<Vec<_>>().join(", "),
                "the negative part of this model's law exceeds the positive part; the value has no physical meaning",
            ),
            Oddity::Adhesion => negative(
                Code::Adhesion,
                one(self),
                match quantity.origin() {
                    Quantity::Force => "the surfaces attract each other there",
                    _ => {
                        "under a constant load, the surfaces snap together or part there; stable states have a positive tangent"
                    }
                },
            ),
            Oddity::AreaAboveNominal => Finding::warning(Code::AreaAboveNominal, "fraction", value)
                .usual([0.0, 1.0])
                .fact(format!("the real area is {} times the nominal area", short(value)))
                .advice("models of independent asperities do not hold there; use boundary elements or a theory of the whole surface"),
            Oddity::Cancelled => Finding::warning(Code::Cancelled, "condition", value)
                .usual([0.0, CANCELLED])
                .of_quantity(quantity)
                .fact(format!("positive and negative parts of the {quantity} cancel"))
                .advice(self.accuracy()),
            Oddity::NoContact | Oddity::Underflow => {
                Finding::warning(Code::NoContact, "contacts", value)
                    .usual([f64::MIN_POSITIVE, f64::INFINITY])
                    .fact("no asperity touches")
                    .advice("logarithms, shares and mean pressure are undefined there")
            }
        }
    }

    /// What a condition number means.
    fn accuracy(&self) -> String {
        let left = match ACCURACY * self.value {
            error if error < 1.0 => format!("a relative error of {error:.0e}"),
            _ => "no correct digit".into(),
        };
        let is_tangent = self.quantity == Quantity::Tangent;
        let turns = if is_tangent { "; the force has an extremum nearby" } else { "" };
        format!(
            "condition number {}, inputs with a relative error of {ACCURACY:e} leave {left}{turns}",
            short(self.value)
        )
    }
}
