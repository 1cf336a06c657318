//! Findings: refusals, warnings and notes about scans, scenes, laws and answers.

mod codes;
mod collection;

use std::borrow::Cow;
use std::fmt;

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

pub use self::codes::Code;
pub use self::collection::Findings;
pub(crate) use crate::text::short;
use crate::{At, Quantity};

/// Severity of a finding, the most severe first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// There is no value, for the reason in the finding.
    Refusal,
    /// Values may be off by more than the models differ.
    Warning,
    /// Information.
    Note,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.serialize(f)
    }
}

/// What to do about a finding, for which the program has a command, Python a function and the page
/// a button; each front end words it. [`Display`](fmt::Display) has words for every reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Advice {
    /// Use these models.
    UseModels(&'static str),
    /// Compare the statistics of the scan at several cut-offs.
    CompareCutOffs,
    /// Replace the outliers of the scan.
    Despike,
}

impl fmt::Display for Advice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UseModels(ids) => write!(f, "use {ids}"),
            Self::CompareCutOffs => f.write_str("compare several cut-offs"),
            Self::Despike => f.write_str("replace these points"),
        }
    }
}

/// Something unusual about an input, a scan, a law or an answer: the number, its usual range, the
/// consequence and the remedy. Values stand, whatever the severity; a refusal is the reason why
/// there is none.
///
/// The text is `origin: model: fact where: meaning; advice`, without parts that are not set; the
/// default fact is the number with its usual range. Front ends have [their own words](Self::worded)
/// for the field and for advice that differs from place to place.
///
/// ```
/// use asperity_core::{At, Code, Finding};
///
/// let found = Finding::warning(Code::FewContacts, "contacts", 12.0)
///     .usual([30.0, f64::INFINITY])
///     .of_model("ke")
///     .at(At::Load(1.0))
///     .advice("load more");
/// assert_eq!(found.to_string(), "ke: contacts is 12 at a load of 1 N (usual: at least 30): load more");
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Finding {
    /// Its kind.
    pub code: Code,
    /// Its severity.
    pub severity: Severity,
    /// The input or number concerned, by its name in scene files and tables.
    pub field: Cow<'static, str>,
    /// Its value, in SI units.
    pub value: f64,
    /// SI unit of the value; empty for pure numbers.
    pub unit: &'static str,
    /// The usual range; an open bound is 0 or infinite.
    pub usual: [f64; 2],
    /// The model, by its id.
    pub model: Option<String>,
    /// The quantity.
    pub quantity: Option<Quantity>,
    /// The law, or the part of one, by its name.
    pub law: Option<String>,
    /// The worst place or, if all places are equal, the first, in the caller's units.
    pub at: Option<At>,
    /// Number of rows with this finding.
    pub count: usize,
    /// Origin of the inputs: a line of a scene file, a grid.
    pub origin: Option<String>,
    /// Other models or bodies with the same, not more severe finding.
    pub also: Vec<String>,
    fact: Option<Cow<'static, str>>,
    meaning: Cow<'static, str>,
    advice: Option<Advice>,
    /// A unit that explains the value, in place of the advice: "210 looks like GPa; ..".
    pub likely_unit: Option<String>,
    implausible: bool,
}

impl Finding {
    /// The reason why there is no value.
    #[must_use]
    pub fn refusal(code: Code, field: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Self::new(Severity::Refusal, code, field.into(), value)
    }

    /// A finding that may put values off by more than the models differ.
    #[must_use]
    pub fn warning(code: Code, field: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Self::new(Severity::Warning, code, field.into(), value)
    }

    /// A finding for information.
    #[must_use]
    pub fn note(code: Code, field: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Self::new(Severity::Note, code, field.into(), value)
    }

    fn new(severity: Severity, code: Code, field: Cow<'static, str>, value: f64) -> Self {
        Self {
            code,
            severity,
            field,
            value,
            unit: "",
            usual: [0.0, f64::INFINITY],
            model: None,
            quantity: None,
            law: None,
            at: None,
            count: 1,
            origin: None,
            also: vec![],
            fact: None,
            meaning: "".into(),
            advice: None,
            likely_unit: None,
            implausible: false,
        }
    }

    /// Of an input that no surface or material has, most often by a wrong unit: findings about
    /// answers are then its consequences and are left out.
    #[must_use]
    pub fn implausible(self, implausible: bool) -> Self {
        Self { implausible, ..self }
    }

    /// Whether the input is [implausible](Self::implausible).
    #[must_use]
    pub fn is_implausible(&self) -> bool {
        self.implausible
    }

    /// With another severity.
    #[must_use]
    pub fn severity(self, severity: Severity) -> Self {
        Self { severity, ..self }
    }

    /// With the usual range of the value.
    #[must_use]
    pub fn usual(self, usual: [f64; 2]) -> Self {
        Self { usual, ..self }
    }

    /// With the SI unit of the value.
    #[must_use]
    pub fn unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }

    /// Of the answer of this model.
    #[must_use]
    pub fn of_model(self, model: impl Into<String>) -> Self {
        Self { model: Some(model.into()), ..self }
    }

    /// Of this quantity.
    #[must_use]
    pub fn of_quantity(self, quantity: Quantity) -> Self {
        Self { quantity: Some(quantity), ..self }
    }

    /// Of this law or part of a law.
    #[must_use]
    pub fn of_law(self, law: impl Into<String>) -> Self {
        Self { law: Some(law.into()), ..self }
    }

    /// At this place.
    #[must_use]
    pub fn at(self, at: At) -> Self {
        Self { at: Some(at), ..self }
    }

    /// With the number of rows; `at` is the worst or the first of them.
    #[must_use]
    pub fn in_rows(self, count: usize) -> Self {
        Self { count, ..self }
    }

    /// With the origin of the inputs: a line of a scene file, a grid.
    #[must_use]
    pub fn from_origin(self, origin: impl Into<String>) -> Self {
        Self { origin: Some(origin.into()), ..self }
    }

    /// With another first clause than "field is value unit (usual: range)".
    #[must_use]
    pub fn fact(self, fact: impl Into<Cow<'static, str>>) -> Self {
        Self { fact: Some(fact.into()), ..self }
    }

    /// With the meaning, and the remedy as far as it is the same everywhere.
    #[must_use]
    pub fn advice(self, meaning: impl Into<Cow<'static, str>>) -> Self {
        Self { meaning: meaning.into(), ..self }
    }

    /// With what to do, which each front end words.
    #[must_use]
    pub fn to_do(self, advice: Advice) -> Self {
        Self { advice: Some(advice), ..self }
    }

    /// With a unit that explains the value, in place of the advice: "210 looks like GPa; ..".
    #[must_use]
    pub fn likely_unit(self, hint: impl Into<String>) -> Self {
        Self { likely_unit: Some(hint.into()), ..self }
    }

    /// Without a likely unit, for a value that was given with its unit; `None` for a note, which
    /// then says nothing.
    #[must_use]
    pub fn with_stated_unit(mut self) -> Option<Self> {
        let guess = self.likely_unit.take();
        (guess.is_none() || self.severity < Severity::Note).then_some(self)
    }

    /// With the field prefixed by its section: `body[1].hardness`.
    #[must_use]
    pub fn within(self, section: &str) -> Self {
        Self { field: format!("{section}.{}", self.field).into(), ..self }
    }

    /// Ratio of the value to the bound of its usual range: 1 at the bound, infinite where no ratio
    /// exists.
    #[must_use]
    pub fn excess(&self) -> f64 {
        let [from, to] = self.usual;
        match self.value {
            value if value > to => value / to,
            value if value > 0.0 => (value / to).max(from / value),
            value if value < from || value.is_nan() => f64::INFINITY,
            _ => 0.0,
        }
    }

    /// Whether the finding concerns only asperities, which
    /// [models of the whole surface](crate::Validity::asperities) do not use.
    #[must_use]
    pub fn is_of_asperities(&self) -> bool {
        let shape = ["roughness_parameter", "height_std_over_radius"];
        self.code.is_of_asperities() || shape.contains(&&*self.field)
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.worded(&self.field, |advice| advice.to_string()))
    }
}

impl Finding {
    /// The whole text, with the name of its field and the advice in the words of a front end.
    #[must_use]
    pub fn worded(&self, field: &str, words: impl Fn(Advice) -> String) -> String {
        let before = self.origin.iter().chain(&self.model);
        let mut text: String = before.map(|part| format!("{part}: ")).collect();
        match &self.fact {
            Some(fact) => text += fact,
            None => {
                let space = if self.unit.is_empty() { "" } else { " " };
                text += &format!("{field} is {}{space}{}", short(self.value), self.unit);
            }
        }
        text += &match (&self.at, self.count) {
            (Some(at), 0 | 1) => format!(" at {at}"),
            (Some(at), count) => {
                let which = if self.excess().is_finite() { "worst" } else { "first" };
                format!(" in {count} rows, {which} at {at}")
            }
            (None, _) => String::new(),
        };
        if self.fact.is_none() {
            text += &self.range();
        }
        match (&self.likely_unit, &*self.meaning, self.advice) {
            (Some(unit), ..) => text += &format!(": {unit}"),
            (_, "", None) => {}
            (_, meaning, None) => text += &format!(": {meaning}"),
            (_, "", Some(advice)) => text += &format!(": {}", words(advice)),
            (_, meaning, Some(advice)) => text += &format!(": {meaning}; {}", words(advice)),
        }
        if !self.also.is_empty() {
            text += &format!(" (likewise {})", self.also.join(", "));
        }
        text
    }

    /// The usual range, where the value is outside of it.
    fn range(&self) -> String {
        match self.usual {
            [from, to] if (from..=to).contains(&self.value) => String::new(),
            [from, to] if from > 0.0 && to.is_finite() => {
                format!(" (usual: {} to {})", short(from), short(to))
            }
            [from, _] if from > 0.0 => format!(" (usual: at least {})", short(from)),
            [_, to] if to.is_finite() => format!(" (usual: at most {})", short(to)),
            _ => String::new(),
        }
    }
}

impl Serialize for Finding {
    /// Writes code, severity, field, value, usual and message, and if set unit, model, also (other
    /// models with the same finding), quantity, law, at, count and origin.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("code", &self.code)?;
        map.serialize_entry("severity", &self.severity)?;
        map.serialize_entry("field", &self.field)?;
        map.serialize_entry("value", &self.value)?;
        map.serialize_entry("usual", &self.usual)?;
        map.serialize_entry("message", &self.to_string())?;
        add(&mut map, "unit", Some(self.unit).filter(|unit| !unit.is_empty()))?;
        add(&mut map, "model", self.model.as_ref())?;
        add(&mut map, "also", Some(&self.also).filter(|also| !also.is_empty()))?;
        add(&mut map, "quantity", self.quantity)?;
        add(&mut map, "law", self.law.as_ref())?;
        add(&mut map, "at", self.at)?;
        add(&mut map, "count", self.at.map(|_| self.count))?;
        add(&mut map, "origin", self.origin.as_ref())?;
        map.end()
    }
}

fn add<M: SerializeMap>(
    map: &mut M,
    key: &str,
    value: Option<impl Serialize>,
) -> Result<(), M::Error> {
    value.map_or(Ok(()), |value| map.serialize_entry(key, &value))
}
