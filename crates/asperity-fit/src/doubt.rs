//! Doubts about a fit as findings: their codes, and which of them hides which.

use std::ops::Deref;

use asperity_core::{Finding, short};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// The search ended before it reached a minimum.
pub(crate) const NOT_CONVERGED: &str = "not-converged";
/// A measured value that no parameters within the bounds reach.
pub(crate) const UNREACHABLE: &str = "unreachable";
/// Data that the model does not describe, and what explains that.
pub(crate) const MISFIT: &str = "misfit";
/// Lines that the others contradict.
pub(crate) const OUTLIER: &str = "outlier";
/// Another stiffness that describes the data clearly better than the one given.
pub(crate) const OTHER_COLUMN: &str = "other-column";
/// Parameters that the data do not fix.
pub(crate) const UNDETERMINED: &str = "undetermined";
/// A parameter at a bound, or at the end of the range where values exist.
pub(crate) const LIMITS: &str = "limits";
/// Missing intervals, other minima, small standard deviations.
pub(crate) const NOTES: &str = "notes";

/// The codes in the order in which they are read.
const ORDER: [&str; 8] =
    [NOT_CONVERGED, UNREACHABLE, MISFIT, OUTLIER, OTHER_COLUMN, UNDETERMINED, LIMITS, NOTES];

/// Whether a finding leaves no meaning to another: of a misfit all that follow, which it names if
/// they explain it; limits where the nearest to an unreachable value names its place.
fn hides(code: &str, other: &str) -> bool {
    let place = |code: &str| ORDER.iter().position(|known| *known == code);
    match code {
        MISFIT => place(other) > place(MISFIT),
        UNREACHABLE => other == LIMITS,
        _ => false,
    }
}

/// What the user of a fit should know, as findings without a model: their fields are parameters or
/// columns. Their codes are `not-converged`, `unreachable`, `misfit`, `outlier`, `other-column`,
/// `undetermined`, `limits` and `notes`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Doubts(Vec<Finding>);

impl Doubts {
    pub(crate) fn new(mut found: Vec<Finding>) -> Self {
        found.sort_by_key(|one| ORDER.iter().position(|code| *code == one.code));
        Self(found)
    }

    /// The texts of the findings of one code.
    #[must_use]
    pub fn texts(&self, code: &str) -> Vec<String> {
        self.iter().filter(|one| one.code == code).map(Finding::message).collect()
    }

    /// Those that no other hides.
    pub fn shown(&self) -> impl Iterator<Item = &Finding> {
        self.iter().filter(|one| !self.iter().any(|other| hides(other.code, one.code)))
    }
}

impl Deref for Doubts {
    type Target = [Finding];

    fn deref(&self) -> &[Finding] {
        &self.0
    }
}

impl Serialize for Doubts {
    /// Writes the texts of each code: lists, or one text where there is at most one.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for code in [UNDETERMINED, UNREACHABLE, LIMITS, OUTLIER, OTHER_COLUMN, MISFIT, NOTES] {
            let (key, texts) = (code.replace('-', "_"), self.texts(code));
            match code {
                OUTLIER | OTHER_COLUMN | MISFIT => map.serialize_entry(&key, &texts.first())?,
                _ => map.serialize_entry(&key, &texts)?,
            }
        }
        map.end()
    }
}

/// A warning that is a sentence of its own.
pub(crate) fn doubt(code: &'static str, field: &str, value: f64, text: String) -> Finding {
    Finding::warning(code, field.to_string(), value).fact(text)
}

/// A number with its unit.
pub(crate) fn with_unit(value: f64, unit: &str) -> String {
    let gap = if unit.is_empty() { "" } else { " " };
    format!("{}{gap}{unit}", short(value))
}

/// A number of two digits.
pub(crate) fn rounded(value: f64) -> String {
    short(format!("{value:.1e}").parse().unwrap_or(value))
}

/// A number of things: `1 value`, `2 values`.
pub(crate) fn plural(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}

/// Names in a sentence.
pub(crate) fn list(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).into(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
