//! A sheet in three formats.

use std::io::{self, Write};

use asperity::shortest_digits;
use asperity_answer::{Cell, Sheet};
use clap::ValueEnum;
use serde::{Serialize, Serializer};

use asperity_answer::rounded;

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// Comma-separated values with all digits.
    Csv,
    /// One object for each row, with all digits; null for missing values.
    Json,
    /// Aligned columns with six digits.
    Table,
    /// A table on a terminal, csv in a file or a pipe.
    Auto,
    /// The texts of the first column, of a list of BibTeX entries.
    #[value(skip)]
    Bibtex,
}

/// Writes a sheet in a format.
pub fn write(sheet: &Sheet, format: Format, out: &mut dyn Write) -> io::Result<()> {
    match format {
        Format::Csv | Format::Auto => csv(sheet, out),
        Format::Json => json(sheet, out),
        Format::Table => aligned(sheet, out),
        Format::Bibtex => sheet.rows.iter().try_for_each(|row| writeln!(out, "{}", row[0].text())),
    }
}

/// Comma-separated values with all digits.
pub fn csv(sheet: &Sheet, out: &mut dyn Write) -> io::Result<()> {
    // Written at once: its writer would hide a closed pipe.
    let mut lines = vec![];
    let mut csv = csv::Writer::from_writer(&mut lines);
    csv.write_record(&sheet.heads)?;
    for row in &sheet.rows {
        csv.write_record(row.iter().map(|cell| text(cell, shortest_digits)))?;
    }
    drop(csv);
    out.write_all(&lines)
}

fn json(sheet: &Sheet, out: &mut dyn Write) -> io::Result<()> {
    for (k, cells) in sheet.rows.iter().enumerate() {
        out.write_all(if k == 0 { b"[\n" } else { b",\n" })?;
        serde_json::to_writer(&mut *out, &JsonRow { heads: &sheet.heads, cells })?;
    }
    out.write_all(if sheet.rows.is_empty() { b"[]\n" } else { b"\n]\n" })
}

fn aligned(sheet: &Sheet, out: &mut dyn Write) -> io::Result<()> {
    let texts = |row: &Vec<Cell>| row.iter().map(|c| text(c, rounded)).collect();
    let lines: Vec<Vec<String>> =
        std::iter::once(sheet.heads.clone()).chain(sheet.rows.iter().map(texts)).collect();
    let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max();
    let widths: Vec<usize> = (0..sheet.heads.len()).map(|k| width(k).unwrap_or(0)).collect();
    for line in &lines {
        let mut all = String::new();
        for (k, (cell, width)) in line.iter().zip(&widths).enumerate() {
            let gap = if k == 0 { "" } else { "  " };
            match sheet.rows.first().map(|row| &row[k]) {
                Some(Cell::Text(_)) | None => {
                    all += &format!("{gap}{cell:<width$}");
                }
                _ => all += &format!("{gap}{cell:>width$}"),
            }
        }
        writeln!(out, "{}", all.trim_end())?;
    }
    Ok(())
}

fn text(cell: &Cell, number: fn(f64) -> String) -> String {
    cell.number().map_or_else(|| cell.text().into(), number)
}

/// A row as an object with its keys in order.
struct JsonRow<'t> {
    heads: &'t [String],
    cells: &'t [Cell],
}

impl Serialize for JsonRow<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.heads.iter().zip(self.cells))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(format: Format) -> String {
        let mut sheet = Sheet::new(&["model", "force_N"]);
        sheet.rows.push(vec!["gw".into(), Cell::Number(1e-7 / 3.0)]);
        sheet.rows.push(vec!["a, \"b\"".into(), Cell::BLANK]);
        let mut out = vec![];
        write(&sheet, format, &mut out).unwrap();
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
