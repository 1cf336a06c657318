//! Tables of numbers in a csv: the header, the rows, and how else to write what is refused.

use std::path::Path;

use crate::error::{Place, SceneError};
use crate::quantity::notation_hint;
use crate::text_file::shorten;

/// A csv whose first line names its columns. Empty lines and lines that begin with # are skipped.
/// Where semicolons or tabs separate the cells of the header, numbers may have decimal commas.
pub(crate) struct Cells<'t> {
    /// The names of the columns.
    pub(crate) head: Vec<&'t str>,
    /// The line and the cells of each row, one for each column.
    pub(crate) rows: Vec<(usize, Vec<&'t str>)>,
    path: &'t Path,
    delimiter: char,
}

impl<'t> Cells<'t> {
    /// The cells of a text; a header is `needed` like this.
    pub(crate) fn read(text: &'t str, path: &'t Path, needed: &str) -> Result<Self, SceneError> {
        // Of Excel, which begins with a mark, and of R, which writes names in quotes.
        let lines = (1..).zip(text.trim_start_matches('\u{feff}').lines());
        let mut lines = lines.filter(|(_, l)| !l.trim().is_empty() && !l.starts_with('#'));
        let (line, top) = lines.next().unwrap_or((1, ""));
        let delimiter = [';', '\t'].into_iter().find(|other| top.contains(*other)).unwrap_or(',');
        let cells = |line: &'t str| -> Vec<&str> {
            line.split(delimiter).map(|cell| cell.trim().trim_matches('"').trim()).collect()
        };
        let mut table = Self { head: cells(top), rows: vec![], path, delimiter };
        let is_value = |name: &&str| table.number(name).is_some() || notation_hint(name).is_some();
        if top.is_empty() || table.head.iter().all(is_value) {
            let found = table.head.join(",");
            return Err(SceneError::value(
                table.place(line, "the header"),
                shorten(&found),
                needed,
            ));
        }
        for (line, row) in lines {
            let (row, columns) = (cells(row), table.head.len());
            if row.len() == columns {
                table.rows.push((line, row));
                continue;
            }
            let reason = format!(
                "{} cells under a header of {columns} columns: one cell for each column was required (decimal commas need semicolons or tabs)",
                row.len()
            );
            return Err(table.syntax(line, reason));
        }
        match table.rows.is_empty() {
            true => {
                let at = Place { line: None, ..*table.place(line, "CSV") };
                Err(SceneError::refused(at, "no row of values under the header"))
            }
            false => Ok(table),
        }
    }

    /// The units below the names, if the first row has some and no numbers; they leave the rows.
    pub(crate) fn units(&mut self, is_unit: fn(&str) -> bool) -> Vec<&'t str> {
        let is_row = |row: &[&str]| {
            row.iter().any(|cell| is_unit(cell))
                && row.iter().all(|cell| self.number(cell).is_none())
        };
        match &self.rows[..] {
            [(_, row), _, ..] if is_row(row) => self.rows.remove(0).1,
            _ => vec![],
        }
    }

    /// The place of a cell.
    pub(crate) fn place(&self, line: usize, field: &str) -> Box<Place> {
        let (file, field) = (Some(self.path.to_path_buf()), field.into());
        Box::new(Place { file, line: Some(line), field })
    }

    /// The error about a line.
    pub(crate) fn syntax(&self, line: usize, reason: String) -> SceneError {
        SceneError::refused(self.place(line, "CSV"), reason)
    }

    /// A number; its comma is a decimal comma where commas do not separate cells.
    fn number(&self, text: &str) -> Option<f64> {
        text.parse().ok().or_else(|| {
            let is_decimal = self.delimiter != ',' && text.matches(',').count() == 1;
            let decimal = text.replace(',', ".").parse().ok();
            decimal.filter(|_| is_decimal && !text.contains('.'))
        })
    }

    /// The numbers of a column; `odd` is the advice about a text in a column that nobody reads.
    pub(crate) fn column(
        &self,
        k: usize,
        odd: Option<&str>,
    ) -> Result<Vec<Option<f64>>, SceneError> {
        let is_decimal = |cell: &&str| cell.contains(',') && self.number(cell).is_some();
        let has_commas = self.rows.iter().flat_map(|(_, row)| row).any(is_decimal);
        let number = |(line, row): &(usize, Vec<&str>)| {
            let given = row[k];
            let hint = match self.number(given) {
                _ if given.is_empty() => return Ok(None),
                // 1.500 may be 1,5 or 1500.
                _ if has_commas && given.contains('.') => {
                    "has a point where other cells have decimal commas; write a comma"
                }
                Some(value) if value.is_finite() => return Ok(Some(value)),
                _ => notation_hint(given).or(odd).unwrap_or("is not a finite number"),
            };
            let found = format!("\"{}\"", shorten(given).replace(char::is_control, " "));
            let at = self.place(*line, self.head[k]);
            Err(SceneError::notation(at, &found, hint))
        };
        self.rows.iter().map(number).collect()
    }
}
