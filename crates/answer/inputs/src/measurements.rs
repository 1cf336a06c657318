//! Tables of measurements: a csv whose columns are named as those of `asperity curve`.

use std::path::Path;

use asperity::fit::{DataColumn, MeasuredTable, is_column};

use crate::cells::Cells;
use crate::text_file::{SAVE_AS_CSV, read_text};
use crate::{Place, SceneError};

/// The columns of a csv of numbers with a header; cells may be empty, and lines that begin with #
/// are skipped. Where semicolons or tabs separate the cells of the header, numbers may have decimal
/// commas. The columns `model` and `separation_over_sigma` of `asperity curve` are left out.
///
/// # Errors
/// [`SceneError`] with the file, the line, the column, the value found and the value needed.
pub fn read_measurements(path: impl AsRef<Path>) -> Result<MeasuredTable, SceneError> {
    let path = path.as_ref();
    let place = |field: &str| Place { file: Some(path.to_path_buf()), ..Place::field(field) };
    let text = read_text(path, SAVE_AS_CSV, || place("the data"))?;
    if text.lines().any(|line| ["[[body]]", "[surface]", "[interface]"].contains(&line.trim())) {
        let reason = "the file looks like a scene, not like measurements; give the scene first, then the measurements";
        return Err(SceneError::Refused { at: place("CSV").into(), reason: reason.into() });
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
                return Err(SceneError::value(place("model").into(), found, needed));
            }
        } else {
            let odd = "is no number, and no fit reads this column; remove it";
            let numbers = table.column(k, Some(odd).filter(|_| !is_column(name)))?;
            columns.push(((*name).into(), numbers));
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
        for (cell, wanted) in [
            ("1.500,5", "load_N = \"1.500,5\" has thousands separators; remove them"),
            ("1.500.000", "has thousands separators; remove them"),
            ("1,5,0", "is \"1,5,0\": a number was required"),
        ] {
            let refused = read(&format!("load_N;area_m2\n{cell};2e-9\n")).unwrap_err();
            assert!(refused.contains(wanted), "{refused}");
        }
        // 1.500 may be 1500 there.
        let refused = read("load_N;area_m2\n1.500;2,0e-9\n").unwrap_err();
        let wanted = "load_N = \"1.500\" has a point where other cells have decimal commas; write a comma, or no separator of thousands";
        assert!(refused.ends_with(wanted), "{refused}");
        assert_eq!(read("load_N;area_m2\n1.500;2e-9\n").unwrap()[0].1, [Some(1.5)]);
        let thousands = read("load_N;area_m2\n1.500;213.870.238\n").unwrap_err();
        assert!(thousands.contains("has thousands separators"), "{thousands}");
        assert_eq!(read("load_N;area_m2\n1,5e6;3e8\n").unwrap()[0].1, [Some(1.5e6)]);
        for row in ["1,5,2,0e-9", "1,5e6,3e8"] {
            let refused = read(&format!("load_N,area_m2\n{row}\n")).unwrap_err();
            let hint = "decimal commas are read where semicolons or tabs separate the columns";
            assert!(refused.ends_with(hint), "{refused}");
        }
    }

    #[test]
    fn everything_else_is_refused_with_its_line_and_column() {
        for (text, wanted) in [
            (
                "load_N,area_m2,comment\n1,2,first\n",
                ":2: comment = \"first\" is no number, and no fit reads this column; remove it",
            ),
            ("load_kN,area_m2\nabc,1\n", ":2: load_kN is \"abc\": a number was required"),
            (
                "laod_N,displacement_um\n1,abc\n",
                ":2: displacement_um is \"abc\": a number was required",
            ),
            ("load_N,area_m2\n1;2\n", ":2: CSV: 1 cells under a header of 2 columns"),
            (
                "\"1,000,000\",\"2,000,000\"\n",
                ":1: the header is \"1,000,000,2,000,000\": a header",
            ),
            ("[[body]]\nyoungs_modulus = 2e11\n", ": CSV: the file looks like a scene, not like"),
            ("load_N,area_m2\n1,two\n", ":2: area_m2 is \"two\": a number was required"),
            ("load_N,area_m2\n1,2\n3\n", ":3: CSV: 1 cells under a header of 2 columns"),
            ("1,2\n3,4\n", ":1: the header is \"1,2\": a header, for example load_N"),
            ("model,load_N\nke,1\ngw,1\n", ": model is \"ke and gw\": the rows of one model"),
            ("load_N,area_m2\n1,2,\n", ":2: CSV: 3 cells under a header of 2 columns"),
            ("load_N\n# by hand\n1e400\n", ":3: load_N is \"1e400\": a finite number was required"),
            ("load_N area_m2\n1 2\n", ":1: CSV: blanks separate the columns; separate them by"),
            ("load_N,area_m2\n[kN],mm2\n1,2\n", ":2: load_N is \"[kN]\": a number was required"),
            ("load_N,area_m2\n", ": CSV: no row of values under the header"),
            (
                "load_N,area_m2\n1,500'000.0\n",
                ":2: area_m2 = \"500'000.0\" has thousands separators; remove them",
            ),
            (
                "load_N,area_m2\n1,12\u{202f}500\n",
                ":2: area_m2 = \"12\u{202f}500\" has thousands separators; remove them",
            ),
            ("load_N\n1,5\n", ":2: CSV: 2 cells under a header of 1 columns"),
        ] {
            let refused = read(text).unwrap_err();
            assert!(refused.starts_with(wanted), "{refused}");
        }
        let folder = tempfile::tempdir().unwrap();
        let wanted =
            "cannot be read: the file is not a text file in UTF-8; save the sheet as csv in UTF-8";
        for bytes in [
            &b"PK\x03\x04\x14\x00"[..],
            b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1",
            b"\xff\xfel\0o\0",
            b"l\0o\0a\0d\0",
            b"load_N,area_\xb5m2\n1,2\n",
        ] {
            let path = folder.path().join("data.xlsx");
            fs::write(&path, bytes).unwrap();
            let refused = read_measurements(&path).unwrap_err().to_string();
            assert!(refused.ends_with(wanted), "{refused}");
        }
        assert!(read_measurements("none.csv").unwrap_err().to_string().contains("cannot be read"));
    }
}
