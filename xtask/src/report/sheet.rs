//! The csv texts read back: pictures and Markdown are made of them and of nothing else.

use anyhow::{Context, Result};

/// A csv in memory.
pub struct Sheet<'a> {
    head: Vec<&'a str>,
    rows: Vec<Vec<&'a str>>,
}

impl<'a> Sheet<'a> {
    /// Splits a csv of ours, which quotes nothing.
    #[must_use]
    pub fn new(csv: &'a str) -> Self {
        let mut lines = csv.lines().map(|line| line.split(',').collect::<Vec<_>>());
        Self { head: lines.next().unwrap_or_default(), rows: lines.collect() }
    }

    /// Names of the columns.
    #[must_use]
    pub fn head(&self) -> &[&'a str] {
        &self.head
    }

    /// Place of a column.
    ///
    /// # Errors
    /// When there is none of that name.
    pub fn column(&self, name: &str) -> Result<usize> {
        let place = self.head.iter().position(|known| *known == name);
        place.with_context(|| format!("no column {name:?} among {:?}", self.head))
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Vec<&'a str>] {
        &self.rows
    }

    /// What occurs in a column, each once, in order.
    ///
    /// # Errors
    /// When there is no such column.
    pub fn values(&self, name: &str) -> Result<Vec<&'a str>> {
        let column = self.column(name)?;
        let mut values: Vec<&str> = vec![];
        for row in &self.rows {
            if let Some(value) = row.get(column).filter(|value| !values.contains(value)) {
                values.push(value);
            }
        }
        Ok(values)
    }
}

/// The larger of two errors as they stand in a csv; a word is worse than any number.
#[must_use]
pub fn worse<'a>(a: &'a str, b: &'a str) -> &'a str {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(x), Ok(y)) => {
            if y > x {
                b
            } else {
                a
            }
        }
        (Ok(_), Err(_)) => b,
        _ => a,
    }
}
