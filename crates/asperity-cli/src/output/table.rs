//! A table, and its three formats.

use std::io::{self, Write};
use std::rc::Rc;

use asperity::shortest_digits;
use asperity_answer::Sheet;
use clap::ValueEnum;
use serde::{Serialize, Serializer};

use crate::output::number::rounded;

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Comma-separated values with all digits.
    Csv,
    /// One object for each row, with all digits; null for missing values.
    Json,
    /// Aligned columns with six digits.
    Table,
}

/// Rows under the names of their columns, which end with the unit: `force_N`.
#[derive(Debug, Clone, Default)]
pub struct Table {
    pub head: Vec<String>,
    pub rows: Vec<Vec<Cell>>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Cell {
    Text(Rc<str>),
    Number(Option<f64>),
}

impl From<&Sheet> for Table {
    fn from(sheet: &Sheet) -> Self {
        let cell = |cell: &asperity_answer::Cell| match cell {
            asperity_answer::Cell::Text(text) => Cell::from(&**text),
            other => Cell::Number(other.number()),
        };
        let rows = sheet.rows.iter().map(|row| row.iter().map(cell).collect()).collect();
        Self { head: sheet.heads.clone(), rows }
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.into())
    }
}

impl Cell {
    /// The number, where the cell has one.
    pub fn number(&self) -> Option<f64> {
        if let Self::Number(number) = self { *number } else { None }
    }

    fn text(&self, number: fn(f64) -> String) -> String {
        match self {
            Self::Text(text) => text.to_string(),
            Self::Number(value) => value.map_or(String::new(), number),
        }
    }
}

impl Table {
    pub fn new(head: &[&str]) -> Self {
        Self { head: head.iter().map(ToString::to_string).collect(), rows: vec![] }
    }

    pub fn write(&self, format: Format, out: &mut dyn Write) -> io::Result<()> {
        match format {
            Format::Csv => self.csv(out),
            Format::Json => self.json(out),
            Format::Table => self.aligned(out),
        }
    }

    pub fn csv(&self, out: &mut dyn Write) -> io::Result<()> {
        writeln!(out, "{}", self.head.join(","))?;
        for row in &self.rows {
            let fields: Vec<String> =
                row.iter().map(|cell| quoted(cell.text(shortest_digits))).collect();
            writeln!(out, "{}", fields.join(","))?;
        }
        Ok(())
    }

    fn json(&self, out: &mut dyn Write) -> io::Result<()> {
        for (k, cells) in self.rows.iter().enumerate() {
            out.write_all(if k == 0 { b"[\n" } else { b",\n" })?;
            serde_json::to_writer(&mut *out, &Row { head: &self.head, cells })?;
        }
        out.write_all(if self.rows.is_empty() { b"[]\n" } else { b"\n]\n" })
    }

    fn aligned(&self, out: &mut dyn Write) -> io::Result<()> {
        let texts = |row: &Vec<Cell>| row.iter().map(|cell| cell.text(rounded)).collect();
        let lines: Vec<Vec<String>> =
            std::iter::once(self.head.clone()).chain(self.rows.iter().map(texts)).collect();
        let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max();
        let widths: Vec<usize> = (0..self.head.len()).map(|k| width(k).unwrap_or(0)).collect();
        for line in &lines {
            let mut text = String::new();
            for (k, (cell, width)) in line.iter().zip(&widths).enumerate() {
                let gap = if k == 0 { "" } else { "  " };
                match self.rows.first().map(|row| &row[k]) {
                    Some(Cell::Number(_)) => text += &format!("{gap}{cell:>width$}"),
                    _ => text += &format!("{gap}{cell:<width$}"),
                }
            }
            writeln!(out, "{}", text.trim_end())?;
        }
        Ok(())
    }
}

/// A field of a csv, in quotes where it must be.
fn quoted(text: String) -> String {
    match text.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text,
    }
}

/// A row as an object with its keys in order.
struct Row<'t> {
    head: &'t [String],
    cells: &'t [Cell],
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.head.iter().zip(self.cells))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(format: Format) -> String {
        let mut table = Table::new(&["model", "force_N"]);
        table.rows.push(vec!["gw".into(), Cell::Number(Some(1e-7 / 3.0))]);
        table.rows.push(vec!["a, \"b\"".into(), Cell::Number(None)]);
        let mut out = vec![];
        table.write(format, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn each_format_shows_values_and_gaps() {
        let csv = "model,force_N\ngw,3.3333333333333334e-8\n\"a, \"\"b\"\"\",\n";
        assert_eq!(text(Format::Csv), csv);
        let rows: serde_json::Value = serde_json::from_str(&text(Format::Json)).unwrap();
        assert_eq!(rows[0]["force_N"].as_f64(), Some(1e-7 / 3.0));
        assert!(rows[1]["force_N"].is_null() && rows[1]["model"] == "a, \"b\"");
        assert!(text(Format::Json).contains("{\"model\":\"gw\",\"force_N\":"));
        assert_eq!(text(Format::Table), "model      force_N\ngw      3.33333e-8\na, \"b\"\n");
    }
}
