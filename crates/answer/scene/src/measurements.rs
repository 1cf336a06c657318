//! Tables of measurements: a csv whose columns are named as those of `asperity curve`.

use std::path::Path;

use asperity::fit::{DataColumn, MeasuredTable, is_column, is_unit};

use crate::cells::Cells;
use crate::error::{Place, SceneError};
use crate::text_file::{SAVE_AS_CSV, read_text};

/// The columns of a csv of numbers with a header, whose names may have units behind them or below
/// (`Load [kN]`); cells may be empty, and lines that begin with #
/// are skipped. Where semicolons or tabs separate the cells of the header, numbers may have decimal
/// commas. The columns `model` and `separation_over_sigma` of `asperity curve` are left out.
///
/// # Errors
/// [`SceneError`] with the file, the line, the column, the value found and the value needed.
pub fn read_measurements(path: impl AsRef<Path>) -> Result<MeasuredTable, SceneError> {
    let path = path.as_ref();
    let place = |field: &str| Place { file: Some(path.to_path_buf()), ..Place::field(field) };
    let text = read_text(path, SAVE_AS_CSV, || place("the data"))?;
    let needed = "a header, for example load_N,unloading_stiffness_N_per_m";
    let mut table = Cells::read(&text, path, needed)?;
    let units = table.units(is_unit);
    let mut columns: Vec<DataColumn> = vec![];
    for (k, name) in table.head.iter().enumerate() {
        let unit = units.get(k).map_or("", |unit| unit.trim_matches(['[', ']', '(', ')', '-']));
        let name = if unit.is_empty() { (*name).into() } else { format!("{name} [{unit}]") };
        if name == "model" {
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
            let numbers = table.column(k, Some(odd).filter(|_| !is_column(&name)))?;
            columns.push((name, numbers));
        }
    }
    columns.retain(|(name, _)| name != "separation_over_sigma");
    Ok(MeasuredTable { columns, lines: table.rows.iter().map(|(line, _)| *line).collect() })
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
    fn units_may_stand_below_the_names() {
        let columns = read("Load;A;area_fraction\n[kN];mm2;[-]\n1,5;2;0,1\n").unwrap();
        let names: Vec<_> = columns.iter().map(|(name, _)| &**name).collect();
        assert_eq!((names, columns[0].1.len()), (vec!["Load [kN]", "A [mm2]", "area_fraction"], 1));
        // A row of other words is none of units.
        assert!(read("load_N,area_m2\nN.,wide\n1,2\n").is_err());
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
