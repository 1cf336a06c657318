//! Tables of numbers as csv text and their comparison, and tables of texts as markdown.

use std::path::Path;

use anyhow::{Context, Result, ensure};
use csv::ReaderBuilder;
use serde::de::DeserializeOwned;

use crate::folder::read;

/// Largest relative difference of committed and fresh numbers: compilers and processors differ by
/// less, changes of the physics by more.
pub const GUARD: f64 = 1e-7;

/// A csv with a head and rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    text: String,
    columns: usize,
}

impl Table {
    /// An empty table with these columns.
    #[must_use]
    pub fn new(columns: &[&str]) -> Self {
        Self { text: columns.join(",") + "\n", columns: columns.len() }
    }

    /// Adds a row: words without commas, then numbers with 9 significant digits; `None` is a gap in
    /// a curve.
    ///
    /// # Errors
    /// When the number of fields differs from the number of columns, or a number is not finite.
    pub fn push(
        &mut self,
        words: &[&str],
        numbers: impl IntoIterator<Item = impl Into<Option<f64>>>,
    ) -> Result<()> {
        let mut fields: Vec<String> = words.iter().map(|word| (*word).to_owned()).collect();
        for number in numbers {
            let number = number.into();
            ensure!(number.is_none_or(f64::is_finite), "a number of the table is {number:?}");
            fields.push(number.map_or_else(String::new, |x| format!("{x:.8e}")));
        }
        let count = fields.len();
        ensure!(count == self.columns, "{count} fields in a row of {}", self.columns);
        self.text += &(fields.join(",") + "\n");
        Ok(())
    }

    /// The csv.
    #[must_use]
    pub fn into_text(self) -> String {
        self.text
    }
}

/// Whether two csv agree: equal texts, and numbers within the relative `tolerance`.
#[must_use]
pub fn agree(a: &str, b: &str, tolerance: f64) -> bool {
    agree_by(a, b, |a, b| (a - b).abs() <= tolerance * a.abs().max(b.abs()))
}

/// Whether two csv agree: equal texts, and numbers that are the `same`.
#[must_use]
pub fn agree_by(a: &str, b: &str, same: impl Fn(f64, f64) -> bool) -> bool {
    let field = |(a, b): (&str, &str)| {
        a == b || matches!((a.parse(), b.parse()), (Ok(a), Ok(b)) if same(a, b))
    };
    let line = |(a, b): (&str, &str)| {
        a.matches(',').count() == b.matches(',').count()
            && a.split(',').zip(b.split(',')).all(field)
    };
    a.lines().count() == b.lines().count() && a.lines().zip(b.lines()).all(line)
}

/// The rows of a csv; lines with `#` are comments.
///
/// # Errors
/// A csv with other columns.
pub fn rows<T: DeserializeOwned>(csv: &str) -> Result<Vec<T>> {
    let mut reader = ReaderBuilder::new().comment(Some(b'#')).from_reader(csv.as_bytes());
    Ok(reader.deserialize().collect::<Result<_, _>>()?)
}

/// The rows of a file, likewise.
///
/// # Errors
/// A file that cannot be read, or has other columns.
pub fn rows_of<T: DeserializeOwned>(path: &Path) -> Result<Vec<T>> {
    rows(&read(path)?).with_context(|| path.display().to_string())
}

/// The head of a markdown table, its last columns aligned to the right.
#[must_use]
pub fn markdown_head<T: AsRef<str>>(heads: &[T], right: usize) -> String {
    let (left, right) = ("---|".repeat(heads.len() - right), "---:|".repeat(right));
    format!("{}|{left}{right}\n", markdown_row(heads))
}

/// A row of a markdown table.
#[must_use]
pub fn markdown_row<T: AsRef<str>>(cells: &[T]) -> String {
    let mut row = String::from("|");
    for cell in cells.iter().map(AsRef::as_ref) {
        row += &format!("{}{cell} |", if cell.is_empty() { "" } else { " " });
    }
    row + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_nine_digits_and_gaps_are_empty() {
        let mut table = Table::new(&["curve", "x", "y"]);
        table.push(&["ke"], [Some(1.0 / 3.0), None]).unwrap();
        assert!(table.push(&["ke"], [f64::NAN, 1.0]).is_err());
        assert!(table.push(&["ke"], [1.0]).is_err());
        assert!(table.into_text().starts_with("curve,x,y\nke,3.33333333e-1,\n"));
    }
}
