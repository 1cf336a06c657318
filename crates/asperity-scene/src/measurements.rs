//! Tables of measurements: a csv whose columns are named as those of `asperity curve`.

use std::path::Path;

use asperity::fit::DataColumn;

use crate::document::{read_text, shorten};
use crate::{Place, SceneError};

/// The columns of a csv of numbers with a header; cells may be empty, and lines that begin with #
/// are skipped. The columns `model` and `separation_over_sigma` of `asperity curve` are left out.
///
/// # Errors
/// [`SceneError`] with the file, the line, the column, the value found and the value needed.
pub fn read_measurements(path: impl AsRef<Path>) -> Result<Vec<DataColumn>, SceneError> {
    let path = path.as_ref();
    let place = |line: Option<usize>, field: &str| {
        Box::new(Place { file: Some(path.to_path_buf()), line, field: field.into() })
    };
    let text = read_text(path, || *place(None, "the data"))?;
    // A spreadsheet's mark of UTF-8.
    let text = text.trim_start_matches('\u{feff}');
    let mut reader = csv::ReaderBuilder::new();
    let mut reader =
        reader.comment(Some(b'#')).trim(csv::Trim::All).flexible(true).from_reader(text.as_bytes());
    let syntax =
        |line: Option<usize>, reason: String| SceneError::Syntax { at: place(line, "CSV"), reason };
    let head = reader.headers().map_err(|error| syntax(None, error.to_string()))?.clone();
    if head.iter().all(|name| name.parse::<f64>().is_ok()) {
        let found = head.iter().collect::<Vec<_>>().join(",");
        let needed = "a header, for example load_N,unloading_stiffness_N_per_m";
        return Err(SceneError::value(place(Some(1), "the header"), shorten(&found), needed));
    }
    let mut columns: Vec<DataColumn> = head.iter().map(|name| (name.into(), vec![])).collect();
    let mut models: Vec<String> = vec![];
    for record in reader.records() {
        let record = record.map_err(|error| syntax(None, error.to_string()))?;
        let line = record.position().map(|position| position.line() as usize);
        if record.len() != columns.len() {
            let reason = format!(
                "{} cells under a header of {} columns: one cell for each column was required",
                record.len(),
                columns.len()
            );
            return Err(syntax(line, reason));
        }
        for ((name, values), text) in columns.iter_mut().zip(&record) {
            values.push(match text {
                "" => None,
                model if name == "model" => {
                    if !models.iter().any(|known| known == model) {
                        models.push(model.into());
                    }
                    None
                }
                number => Some(number.parse().map_err(|_| {
                    SceneError::value(place(line, name), shorten(number), "a number, or nothing")
                })?),
            });
        }
    }
    if let [first, second, ..] = &models[..] {
        let found = format!("{first} and {second}");
        let needed = "the rows of one model, or data without this column";
        return Err(SceneError::value(place(None, "model"), found, needed));
    }
    columns.retain(|(name, _)| name != "model" && name != "separation_over_sigma");
    Ok(columns)
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
        read_measurements(&path).map_err(cut)
    }

    #[test]
    fn columns_have_gaps_and_those_of_models_are_left_out() {
        let text = "\u{feff}model, load_N,area_m2\n# by hand\nke, 1,2e-9\nke,3,\n";
        let columns = read(text).unwrap();
        let wanted = [("load_N", [Some(1.0), Some(3.0)]), ("area_m2", [Some(2e-9), None])];
        assert_eq!(columns, wanted.map(|(name, values)| (name.to_string(), values.to_vec())));
    }

    #[test]
    fn everything_else_is_refused_with_its_line_and_column() {
        for (text, wanted) in [
            (
                "load_N,area_m2\n1,two\n",
                ":2: area_m2 is \"two\": a number, or nothing was required",
            ),
            ("load_N,area_m2\n1,2\n3\n", ":3: CSV: 1 cells under a header of 2 columns"),
            ("1,2\n3,4\n", ":1: the header is \"1,2\": a header, for example load_N"),
            ("model,load_N\nke,1\ngw,1\n", ": model is \"ke and gw\": the rows of one model"),
            ("load_N\n1,5\n", ":2: CSV: 2 cells under a header of 1 columns"),
        ] {
            let refused = read(text).unwrap_err();
            assert!(refused.starts_with(wanted), "{refused}");
        }
        assert!(read_measurements("none.csv").unwrap_err().to_string().contains("cannot be read"));
    }
}
