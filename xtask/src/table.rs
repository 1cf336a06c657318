//! Tables of numbers as csv text, and their comparison.

use anyhow::{Result, ensure};

/// Largest relative difference of committed and fresh numbers: compilers and processors differ by
/// less, changes of the physics by more.
pub const GUARD: f64 = 1e-7;

/// A csv with a head and rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    text: String,
    columns: usize,
}

/// One field of a row.
#[derive(Debug, Clone, Copy)]
pub enum Field<'a> {
    /// A text without commas.
    Word(&'a str),
    /// A number; written with 9 significant digits.
    Number(f64),
    /// Nothing: a gap in a curve.
    Gap,
}

impl Table {
    /// An empty table with these columns.
    #[must_use]
    pub fn new(columns: &[&str]) -> Self {
        Self { text: columns.join(",") + "\n", columns: columns.len() }
    }

    /// Adds a row.
    ///
    /// # Errors
    /// When the number of fields differs from that of the columns, or a number is not finite.
    pub fn push(&mut self, fields: &[Field]) -> Result<()> {
        ensure!(
            fields.len() == self.columns,
            "{} fields in a row of {}",
            fields.len(),
            self.columns
        );
        for (k, field) in fields.iter().enumerate() {
            if k > 0 {
                self.text.push(',');
            }
            match field {
                Field::Word(word) => self.text.push_str(word),
                Field::Number(x) => {
                    ensure!(x.is_finite(), "a number of the table is {x}");
                    self.text.push_str(&format!("{x:.8e}"));
                }
                Field::Gap => {}
            }
        }
        self.text.push('\n');
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
    let mut lines = (a.lines(), b.lines());
    loop {
        match (lines.0.next(), lines.1.next()) {
            (None, None) => return true,
            (Some(a), Some(b)) if line_agrees(a, b, &same) => {}
            _ => return false,
        }
    }
}

fn line_agrees(a: &str, b: &str, same: &impl Fn(f64, f64) -> bool) -> bool {
    let (a, b): (Vec<&str>, Vec<&str>) = (a.split(',').collect(), b.split(',').collect());
    a.len() == b.len()
        && a.iter().zip(&b).all(|(a, b)| {
            a == b
                || match (a.parse::<f64>(), b.parse::<f64>()) {
                    (Ok(a), Ok(b)) => same(a, b),
                    _ => false,
                }
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_nine_digits_and_gaps_are_empty() {
        let mut table = Table::new(&["curve", "x", "y"]);
        table.push(&[Field::Word("ke"), Field::Number(1.0 / 3.0), Field::Gap]).unwrap();
        assert!(table.push(&[Field::Number(f64::NAN), Field::Gap, Field::Gap]).is_err());
        assert!(table.push(&[Field::Gap]).is_err());
        assert!(table.into_text().starts_with("curve,x,y\nke,3.33333333e-1,\n"));
    }

    #[test]
    fn the_guard_accepts_rounding_only() {
        let text = "curve,x\nke,1.23456789e-5\n";
        for (other, same) in [
            ("curve,x\nke,1.2345678901e-5\n", true),
            ("curve,x\nke,1.23457912e-5\n", false),
            ("curve,x\ngw,1.23456789e-5\n", false),
            ("curve,x\nke,1.23456789e-5\nke,1\n", false),
            ("curve,x\nke,-1.23456789e-5\n", false),
        ] {
            assert_eq!(agree(text, other, GUARD), same, "{other}");
        }
    }
}
