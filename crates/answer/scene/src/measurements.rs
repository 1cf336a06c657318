//! Tables of measurements: a csv whose columns are named as those of `asperity curve`.

use std::path::Path;

use asperity::fit::{DataColumn, MeasuredTable, is_column};

use crate::error::{Place, SceneError};
use crate::quantity::notation_hint;
use crate::text_file::{SAVE_AS_CSV, read_text, shorten};

/// The columns of a csv of numbers with a header, whose names may have units behind them
/// (`Load [kN]`); cells may be empty, and lines that begin with # are skipped. Where semicolons or
/// tabs separate the cells of the header, numbers may have decimal commas. The columns `model` and
/// `separation_over_sigma` of `asperity curve` are left out.
///
/// # Errors
/// [`SceneError`] with the file, the line, the column, the value found and the value needed.
pub fn read_measurements(path: impl AsRef<Path>) -> Result<MeasuredTable, SceneError> {
    let path = path.as_ref();
    let place = |field: &str| Place { file: Some(path.to_path_buf()), ..Place::field(field) };
    let text = read_text(path, SAVE_AS_CSV, || place("the data"))?;
    if text.lines().any(|line| ["[[body]]", "[surface]", "[interface]"].contains(&line.trim())) {
        let reason = "the file looks like a scene, not like measurements; give the scene first, then the measurements";
        return Err(SceneError::refused(place("CSV"), reason));
    }
    let needed = "a header, for example load_N,unloading_stiffness_N_per_m";
    let table = Cells::read(&text, path, needed)?;
    let mut columns: Vec<DataColumn> = vec![];
    for (k, name) in table.head.iter().enumerate() {
        if *name == "model" {
            let mut models: Vec<&str> = vec![];
            for (_, row) in table.rows.iter().filter(|(_, row)| !row[k].is_empty()) {
                models.extend(Some(row[k]).filter(|model| !models.contains(model)));
            }
            if let [first, second, ..] = models[..] {
                let needed = "the rows of one model, or data without this column";
                let found = format!("{first} and {second}");
                return Err(SceneError::value(place("model"), found, needed));
            }
        } else {
            let odd = "is no number, and no fit reads this column; remove it";
            let numbers = table.column(k, Some(odd).filter(|_| !is_column(name)))?;
            columns.push((name.to_string(), numbers));
        }
    }
    columns.retain(|(name, _)| name != "separation_over_sigma");
    Ok(MeasuredTable { columns, lines: table.rows.iter().map(|(line, _)| *line).collect() })
}

/// A csv whose first line names its columns. Empty lines and lines that begin with # are skipped.
/// Where semicolons or tabs separate the cells of the header, numbers may have decimal commas.
struct Cells<'t> {
    /// The names of the columns.
    head: Vec<&'t str>,
    /// The line and the cells of each row, one for each column.
    rows: Vec<(usize, Vec<&'t str>)>,
    path: &'t Path,
    delimiter: char,
}

impl<'t> Cells<'t> {
    /// The cells of a text; a header is `needed` like this.
    fn read(text: &'t str, path: &'t Path, needed: &str) -> Result<Self, SceneError> {
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

    /// The place of a cell.
    fn place(&self, line: usize, field: &str) -> Box<Place> {
        let (file, field) = (Some(self.path.to_path_buf()), field.into());
        Box::new(Place { file, line: Some(line), field })
    }

    /// The error about a line.
    fn syntax(&self, line: usize, reason: String) -> SceneError {
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
    fn column(&self, k: usize, odd: Option<&str>) -> Result<Vec<Option<f64>>, SceneError> {
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

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn read(text: &str) -> Result<Vec<DataColumn>, String> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("data.csv");
        fs::write(&path, text).unwrap();
        let cut = |error: SceneError| error.to_string().split("data.csv").last().unwrap().into();
        read_measurements(&path).map(|table| table.columns).map_err(cut)
    }

    #[test]
    fn columns_have_gaps_and_those_of_models_are_left_out() {
        let text = "\u{feff}model, load_N,area_m2\n# by hand\nke, 1,2e-9\nke,3,\n";
        let columns = read(text).unwrap();
        let wanted = [("load_N", [Some(1.0), Some(3.0)]), ("area_m2", [Some(2e-9), None])];
        assert_eq!(columns, wanted.map(|(name, values)| (name.to_string(), values.to_vec())));
    }

    #[test]
    fn rows_have_the_lines_of_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("data.csv");
        fs::write(&path, "# by hand\n\nload_N,area_m2\n1,2\n# again\n3,4\n").unwrap();
        assert_eq!(read_measurements(&path).unwrap().lines, [4, 6]);
    }

    #[test]
    fn semicolons_and_tabs_separate_numbers_with_decimal_commas() {
        let wanted = [("load_N", [Some(1500.5), Some(3.0)]), ("area_m2", [Some(2e-9), None])];
        let wanted = wanted.map(|(name, values)| (name.to_string(), values.to_vec()));
        for text in [
            "# made by hand\nload_N;area_m2\n1500,5;2e-9\n3;\n",
            "load_N; area_m2\r\n1500,5; 0,2e-8\r\n3,0;\r\n",
            "load_N\tarea_m2\n1500,5\t2,0E-9\n3\t\n",
        ] {
            assert_eq!(read(text).unwrap(), wanted, "{text:?}");
        }
        assert_eq!(read("load_N;area_m2\n1.500;2e-9\n").unwrap()[0].1, [Some(1.5)]);
        assert_eq!(read("load_N;area_m2\n1,5e6;3e8\n").unwrap()[0].1, [Some(1.5e6)]);
    }

    #[test]
    fn files_that_are_no_text_are_unreadable() {
        let folder = tempfile::tempdir().unwrap();
        for bytes in [
            &b"PK\x03\x04\x14\x00"[..],
            b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
            b"\xff\xfel\0o\0",
            b"l\0o\0a\0d\0",
            b"load_N,area_\xb5m2\n1,2\n",
        ] {
            let path = folder.path().join("data.xlsx");
            fs::write(&path, bytes).unwrap();
            let refused = read_measurements(&path);
            assert!(matches!(refused, Err(SceneError::Refused { .. })), "{refused:?}");
        }
        let refused = read_measurements("none.csv");
        assert!(matches!(refused, Err(SceneError::Refused { .. })), "{refused:?}");
    }
}
