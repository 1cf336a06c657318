//! A table by columns, and its three forms.

use std::io::{self, Write};

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use crate::number::{exact, rounded};

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Format {
    /// Comma-separated, SI units, every digit.
    Csv,
    /// One object a row, SI units, every digit; null for what is missing or infinite.
    Json,
    /// Aligned, six digits, with units.
    Table,
}

/// Named columns of equal length.
#[derive(Debug, Clone, Default)]
pub struct Table {
    pub columns: Vec<Column>,
}

/// One column.
#[derive(Debug, Clone)]
pub struct Column {
    /// As in the head of a csv.
    pub name: String,
    /// Shown in aligned tables; may be empty.
    pub unit: &'static str,
    pub cells: Cells,
}

#[derive(Debug, Clone)]
pub enum Cells {
    Words(Vec<String>),
    /// `None` is an empty cell.
    Numbers(Vec<Option<f64>>),
}

impl Table {
    pub fn words(&mut self, name: &str, cells: Vec<String>) {
        self.columns.push(Column { name: name.into(), unit: "", cells: Cells::Words(cells) });
    }

    pub fn numbers(&mut self, name: &str, unit: &'static str, cells: Vec<Option<f64>>) {
        self.columns.push(Column { name: name.into(), unit, cells: Cells::Numbers(cells) });
    }

    /// Adds the rows of a table with the same columns.
    pub fn append(&mut self, other: Self) {
        if self.columns.is_empty() {
            *self = other;
            return;
        }
        for (mine, theirs) in self.columns.iter_mut().zip(other.columns) {
            match (&mut mine.cells, theirs.cells) {
                (Cells::Words(mine), Cells::Words(theirs)) => mine.extend(theirs),
                (Cells::Numbers(mine), Cells::Numbers(theirs)) => mine.extend(theirs),
                (Cells::Words(_), _) | (Cells::Numbers(_), _) => {}
            }
        }
    }

    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.cells.len())
    }

    pub fn write(&self, format: Format, out: &mut dyn Write) -> io::Result<()> {
        match format {
            Format::Csv => self.csv(out),
            Format::Json => self.json(out),
            Format::Table => self.aligned(out),
        }
    }

    fn csv(&self, out: &mut dyn Write) -> io::Result<()> {
        let names: Vec<String> = self.columns.iter().map(|c| field(&c.name)).collect();
        writeln!(out, "{}", names.join(","))?;
        for row in 0..self.rows() {
            for (k, column) in self.columns.iter().enumerate() {
                if k > 0 {
                    out.write_all(b",")?;
                }
                out.write_all(field(&column.cells.text(row, exact)).as_bytes())?;
            }
            out.write_all(b"\n")?;
        }
        Ok(())
    }

    fn json(&self, out: &mut dyn Write) -> io::Result<()> {
        out.write_all(b"[")?;
        for row in 0..self.rows() {
            out.write_all(if row == 0 { "\n" } else { ",\n" }.as_bytes())?;
            serde_json::to_writer(&mut *out, &Row { table: self, row })?;
        }
        out.write_all(b"\n]\n")
    }

    fn aligned(&self, out: &mut dyn Write) -> io::Result<()> {
        let columns: Vec<Vec<String>> = self
            .columns
            .iter()
            .map(|column| {
                let head = match column.unit {
                    "" => column.name.clone(),
                    unit => format!("{} [{unit}]", column.name),
                };
                let cells = (0..self.rows()).map(|row| column.cells.text(row, rounded));
                std::iter::once(head).chain(cells).collect()
            })
            .collect();
        let width = |texts: &Vec<String>| texts.iter().map(|t| t.chars().count()).max();
        let widths: Vec<usize> = columns.iter().map(|c| width(c).unwrap_or(0)).collect();
        for row in 0..=self.rows() {
            let mut line = String::new();
            for ((texts, column), width) in columns.iter().zip(&self.columns).zip(&widths) {
                let text = &texts[row];
                let gap = if line.is_empty() { "" } else { "  " };
                match column.cells {
                    Cells::Words(_) => line.push_str(&format!("{gap}{text:<width$}")),
                    Cells::Numbers(_) => line.push_str(&format!("{gap}{text:>width$}")),
                }
            }
            writeln!(out, "{}", line.trim_end())?;
        }
        Ok(())
    }
}

/// A field of a csv, in quotes where it must be.
fn field(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

impl Cells {
    fn len(&self) -> usize {
        match self {
            Self::Words(words) => words.len(),
            Self::Numbers(numbers) => numbers.len(),
        }
    }

    fn text(&self, row: usize, number: fn(f64) -> String) -> String {
        match self {
            Self::Words(words) => words[row].clone(),
            Self::Numbers(numbers) => numbers[row].map_or(String::new(), number),
        }
    }
}

struct Row<'a> {
    table: &'a Table,
    row: usize,
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.table.columns.len()))?;
        for column in &self.table.columns {
            match &column.cells {
                Cells::Words(words) => map.serialize_entry(&column.name, &words[self.row])?,
                Cells::Numbers(numbers) => {
                    let finite = numbers[self.row].filter(|x| x.is_finite());
                    map.serialize_entry(&column.name, &finite)?;
                }
            }
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(format: Format) -> String {
        let mut table = Table::default();
        table.words("model", vec!["gw".into(), "a, \"b\"".into()]);
        table.numbers("force", "N", vec![Some(1e-7 / 3.0), None]);
        let mut out = vec![];
        table.write(format, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn each_form_shows_what_is_there_and_what_is_missing() {
        assert_eq!(text(Format::Csv), "model,force\ngw,3.3333333333333334e-8\n\"a, \"\"b\"\"\",\n");
        let rows: serde_json::Value = serde_json::from_str(&text(Format::Json)).unwrap();
        assert_eq!(rows[0]["force"].as_f64(), Some(1e-7 / 3.0));
        assert!(rows[1]["force"].is_null() && rows[1]["model"] == "a, \"b\"");
        assert_eq!(text(Format::Table), "model    force [N]\ngw      3.33333e-8\na, \"b\"\n");
    }

    #[test]
    fn rows_are_appended_column_by_column() {
        let mut all = Table::default();
        for value in [1.0, 2.0] {
            let mut one = Table::default();
            one.numbers("x", "", vec![Some(value)]);
            all.append(one);
        }
        assert_eq!(all.rows(), 2);
    }
}
