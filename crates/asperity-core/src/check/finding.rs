//! What a look at a scene has found.

use std::borrow::Cow;
use std::fmt;

use serde::Serialize;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// The answer means nothing until this is mended.
    Error,
    /// The answer may be off by more than the models differ.
    Warning,
    /// Good to know.
    Note,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Error => "error",
            Self::Warning => "warning",
            Self::Note => "note",
        })
    }
}

/// The code of an area that holds few asperities.
pub(super) const FEW_ASPERITIES: &str = "few-asperities";

/// One finding: which number, how large, what was to be expected, and what follows.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Finding {
    /// What it is about, in lower case with dashes: `unusual-size`, `crowded`.
    pub code: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// The input or number that it is about, by its name in scene files.
    pub field: Cow<'static, str>,
    /// Its value, in SI units.
    pub value: f64,
    /// What is usual, from and to; where a bound is open it is 0 or infinite.
    pub usual: [f64; 2],
    /// All of it in a sentence: the consequence, and what to do.
    pub message: String,
}

impl Finding {
    /// A finding; `field` is the number's name in scene files, `usual` from and to.
    #[must_use]
    pub fn new(
        code: &'static str,
        severity: Severity,
        field: &'static str,
        value: f64,
        usual: [f64; 2],
        message: String,
    ) -> Self {
        Self { code, severity, field: field.into(), value, usual, message }
    }

    /// How many times what is usual its value is, above or below: 1 at the bound.
    #[must_use]
    pub fn excess(&self) -> f64 {
        (self.value / self.usual[1]).max(self.usual[0] / self.value)
    }

    /// Whether it is about asperities, of which [models of the whole surface](crate::Validity::asperities)
    /// know nothing.
    #[must_use]
    pub fn is_of_asperities(&self) -> bool {
        let shape = ["roughness_parameter", "height_std_over_radius"];
        self.code == FEW_ASPERITIES || shape.contains(&&*self.field)
    }

    /// Whether it says that a model is not made for what it is asked, where others may be.
    #[must_use]
    pub fn is_of_model(&self) -> bool {
        ["yields", "above-hardness", "fit-misses", "sticks", "tabor"].contains(&self.code)
    }

    /// The same finding of a field that stands in a section: `body[1].hardness`.
    #[must_use]
    pub fn within(mut self, section: &str) -> Self {
        let full = format!("{section}.{}", self.field);
        self.message = self.message.replacen(&*self.field, &full, 1);
        self.field = full.into();
        self
    }
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// A number for a sentence: four digits, plain where that is short.
pub(crate) fn short(x: f64) -> String {
    let four: f64 = format!("{x:.3e}").parse().unwrap_or(x);
    match four.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => format!("{four}"),
        _ => format!("{four:e}"),
    }
}
