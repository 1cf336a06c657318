//! A table of values, with what there is to say about them.

use std::sync::{Arc, OnceLock};

use asperity::{Code, ContactError, Finding, Findings, Quantity};
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
    /// The columns whose answers have ends.
    pub(crate) with_ends: Vec<String>,
}

/// A name, a number in the unit of its column, or a blank with its reason.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A name or a word.
    Text(Arc<str>),
    /// A number.
    Number(f64),
    /// A number between the ends of an interval, which get columns of their own.
    Between(f64, [Option<f64>; 2]),
    /// No value; the reason, where it concerns this cell.
    Blank(Option<Arc<ContactError>>),
}

impl Cell {
    /// A blank without a reason of its own.
    pub const BLANK: Self = Self::Blank(None);

    /// The number, where the cell has one.
    #[must_use]
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) | Self::Between(number, _) => Some(*number),
            _ => None,
        }
    }

    /// The ends of an interval, where the cell has them.
    pub(crate) fn ends(&self) -> [Option<f64>; 2] {
        if let Self::Between(_, ends) = self { *ends } else { [None; 2] }
    }

    /// The number and the ends of its interval, converted.
    pub(crate) fn map(&self, of: impl Fn(f64) -> Option<f64>) -> Self {
        match (self, self.number().and_then(&of)) {
            (Self::Between(_, ends), Some(number)) => {
                Self::Between(number, ends.map(|end| of(end?)))
            }
            (_, number) => number.into(),
        }
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
            Self::Number(number) | Self::Between(number, _) => serializer.serialize_f64(*number),
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

    /// Gives the ends of intervals columns behind the columns of their answers.
    pub(crate) fn spread(&mut self) {
        for head in std::mem::take(&mut self.with_ends) {
            let Some(column) = self.column(&head) else { continue };
            let behind = column + 1..column + 1;
            self.heads.splice(behind.clone(), ENDS.map(|end| column_of_end(&head, end)));
            for row in &mut self.rows {
                let ends = row[column].ends().map(Cell::from);
                row[column] = row[column].number().map_or_else(|| row[column].clone(), Cell::from);
                row.splice(behind.clone(), ends);
            }
        }
    }

    /// Adds beside each stiffness the same over a nominal area \[m²\]:
    /// `tangent_per_area_N_per_m3`.
    pub fn add_per_area(&mut self, nominal_area: f64) {
        for column in (0..self.heads.len()).rev() {
            let Some(name) = self.heads[column].strip_suffix("_N_per_m") else { continue };
            let head = format!("{name}_per_area_N_per_m3");
            self.with_ends
                .extend(self.with_ends.contains(&self.heads[column]).then(|| head.clone()));
            self.heads.insert(column + 1, head);
            for row in &mut self.rows {
                let of_area = row[column].map(|value| Some(value / nominal_area));
                row.insert(column + 1, of_area);
            }
        }
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

/// The ends of an interval.
pub const ENDS: [&str; 2] = ["lower", "upper"];

/// The name of a column with an end of another, before the unit of that: `area_lower_m2`,
/// `separation_lower_m`.
#[must_use]
pub fn column_of_end(column: &str, end: &str) -> String {
    static UNITS: OnceLock<Vec<String>> = OnceLock::new();
    let unit = |quantity: Quantity| quantity.column().split_off(quantity.to_string().len());
    let own = [String::from("_N_per_m3")];
    let units = UNITS.get_or_init(|| Quantity::ALL.into_iter().map(unit).chain(own).collect());
    let units = units.iter().filter(|unit| column.ends_with(&***unit));
    let unit = units.max_by_key(|unit| unit.len()).map_or("", String::as_str);
    let (name, unit) = column.split_at(column.len() - unit.len());
    format!("{name}_{end}{unit}")
}

/// A note that is a sentence of its own.
pub(crate) fn note(code: Code, text: impl Into<String>) -> Finding {
    Finding::note(code, "", f64::NAN).fact(text.into())
}

/// A warning that is a sentence of its own.
pub(crate) fn warning(code: Code, text: impl Into<String>) -> Finding {
    Finding::warning(code, "", f64::NAN).fact(text.into())
}
