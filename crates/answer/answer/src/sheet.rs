//! A table of values, with what there is to say about them.

use std::sync::Arc;

use asperity::{Code, ContactError, Finding, Findings};
use serde::{Serialize, Serializer};

/// Rows under the names of their columns, which end with the unit: `force_N`.
#[derive(Debug, Clone, Default)]
pub struct Sheet {
    /// Names of the columns.
    pub heads: Vec<String>,
    /// The rows, each with a cell for every column.
    pub rows: Vec<Vec<Cell>>,
    /// Results that no column has, a sentence each, such as the recommended model.
    pub results: Vec<String>,
    /// Findings, in the order in which they are to be read.
    pub findings: Vec<Finding>,
}

/// A name, a number in the unit of its column, or a blank with its reason.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A name or a word.
    Text(Arc<str>),
    /// A number.
    Number(f64),
    /// No value; the reason, where it concerns this cell.
    Blank(Option<Arc<ContactError>>),
}

impl Cell {
    /// A blank without a reason of its own.
    pub const BLANK: Self = Self::Blank(None);

    /// The number, where the cell has one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(number) = self { Some(*number) } else { None }
    }

    /// Why there is no value, where the cell says so.
    #[must_use]
    pub fn reason(&self) -> Option<&ContactError> {
        if let Self::Blank(reason) = self { reason.as_deref() } else { None }
    }

    /// The name or word, empty for numbers and blanks.
    #[must_use]
    pub fn text(&self) -> &str {
        if let Self::Text(text) = self { text } else { "" }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

impl From<f64> for Cell {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<Option<f64>> for Cell {
    fn from(number: Option<f64>) -> Self {
        number.map_or(Self::BLANK, Self::Number)
    }
}

impl Serialize for Cell {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Text(text) => serializer.serialize_str(text),
            Self::Number(number) => serializer.serialize_f64(*number),
            Self::Blank(_) => serializer.serialize_none(),
        }
    }
}

impl Sheet {
    /// Without rows, under these columns.
    #[must_use]
    pub fn new(heads: &[&str]) -> Self {
        let heads = heads.iter().map(ToString::to_string).collect();
        Self { heads, ..Self::default() }
    }

    /// Names the columns.
    pub fn under(&mut self, heads: &[&[&str]]) {
        self.heads = heads.concat().into_iter().map(String::from).collect();
    }

    /// The place of a column.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.heads.iter().position(|head| head == name)
    }

    /// Adds a row with names, then numbers, and blanks up to the last column.
    pub fn add<N: Into<Cell>>(&mut self, names: &[&str], numbers: impl IntoIterator<Item = N>) {
        let mut row: Vec<Cell> = names.iter().map(|name| Cell::from(*name)).collect();
        row.extend(numbers.into_iter().map(Into::into));
        row.resize(self.heads.len(), Cell::BLANK);
        self.rows.push(row);
    }

    /// Adds a result in a sentence, unless it stands there already.
    pub fn result(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !self.results.contains(&text) {
            self.results.push(text);
        }
    }

    /// Adds a note that is a sentence of its own, unless it stands there already.
    pub fn note(&mut self, code: Code, text: impl Into<String>) {
        self.add_once(note(code, text));
    }

    /// Adds a warning that is a sentence of its own, unless it stands there already.
    pub fn warn(&mut self, code: Code, text: impl Into<String>) {
        self.add_once(warning(code, text));
    }

    fn add_once(&mut self, new: Finding) {
        let is_new = |known: &Finding| known.to_string() != new.to_string();
        if self.findings.iter().all(is_new) {
            self.findings.push(new);
        }
    }

    /// Adds findings, most severe first, unless they stand there already.
    pub fn extend(&mut self, findings: Findings) {
        findings.into_iter().for_each(|found| self.add_once(found));
    }
}

/// A note that is a sentence of its own.
pub(crate) fn note(code: Code, text: impl Into<String>) -> Finding {
    Finding::note(code, "", f64::NAN).fact(text.into())
}

/// A warning that is a sentence of its own.
pub(crate) fn warning(code: Code, text: impl Into<String>) -> Finding {
    Finding::warning(code, "", f64::NAN).fact(text.into())
}
