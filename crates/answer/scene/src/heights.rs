//! `heights`: the distribution of the asperity heights, and the CSV file of a measured density.

use std::path::{Path, PathBuf};

use asperity::{Code, ContactError, Finding, HeightDistribution, TabulatedHeights, WeibullHeights};
use serde::Deserialize;

use crate::cells::Cells;
use crate::document::Document;
use crate::error::{Place, SceneError};
use crate::spec::HeightsSpec;
use crate::text_file::{SAVE_AS_CSV, read_text, shorten};

/// Header of the CSV file: it states the units.
const HEADER: [&str; 2] = ["height_m", "density_per_m"];
const NEEDED: &str = "\"height_m,density_per_m\", heights in m and densities in 1/m,";
/// The largest number of points in a table of heights; each costs time in every evaluation.
const MOST_POINTS: usize = 10_000;
/// Relative difference of the standard deviations above which there is a warning; the bins of a
/// histogram alone cause some per cent.
const DIFFERENT: f64 = 0.05;

/// `heights`.
#[derive(Debug, Default, Deserialize)]
#[serde(
    rename_all = "kebab-case",
    deny_unknown_fields,
    expecting = "\"gaussian\" or \"exponential\" or \"measured\" or { skewness = -0.5 } or { height_m = [-1e-6, 0, 2e-6], density_per_m = [0, 6e5, 0] } or { file = \"pdf.csv\" }"
)]
enum HeightsKey {
    #[default]
    Gaussian,
    Exponential,
    Measured,
    #[serde(untagged)]
    Skewed {
        skewness: f64,
    },
    #[serde(untagged)]
    Points {
        height_m: Vec<f64>,
        density_per_m: Vec<f64>,
    },
    #[serde(untagged)]
    Table {
        file: PathBuf,
    },
}

/// The distribution that is written; of measured heights without its table.
pub(crate) fn heights(document: &Document<'_>) -> Result<HeightsSpec, SceneError> {
    Ok(match document.get("surface.heights")?.unwrap_or_default() {
        HeightsKey::Gaussian => HeightsSpec::default(),
        HeightsKey::Exponential => HeightDistribution::Exponential.into(),
        HeightsKey::Measured => HeightsSpec { is_measured: true, ..HeightsSpec::default() },
        HeightsKey::Skewed { skewness } => {
            let heights = WeibullHeights::new(skewness);
            let heights = heights.map_err(document.refused("surface.heights"))?;
            HeightDistribution::Weibull(heights).into()
        }
        HeightsKey::Points { height_m, density_per_m } => {
            HeightsSpec::of_table(inline_heights(document, &height_m, &density_per_m)?)
        }
        HeightsKey::Table { file } => {
            let table = HeightsSpec::of_table(read_heights(document, &file)?);
            HeightsSpec { file: Some(document.whole_path(&file)), ..table }
        }
    })
}

/// The table of `heights = { height_m = [...], density_per_m = [...] }`.
fn inline_heights(
    document: &Document<'_>,
    heights: &[f64],
    densities: &[f64],
) -> Result<TabulatedHeights, SceneError> {
    let at = "surface.heights";
    if heights.len() != densities.len() || heights.len() > MOST_POINTS {
        let found =
            format!("a table of {} heights and {} densities", heights.len(), densities.len());
        let needed = format!("one density for each height, at most {MOST_POINTS},");
        let at = document.place(at);
        return Err(SceneError::Value { at, found, near: None, needed });
    }
    let points: Vec<(f64, f64)> = heights.iter().copied().zip(densities.iter().copied()).collect();
    TabulatedHeights::new("table", &points).map_err(|source| match source {
        ContactError::InTable { row, field, value, required } => {
            let place = document.place(&format!("{at}.{field}"));
            let place = Place { field: format!("{}[{row}]", place.field), ..*place };
            SceneError::value(place.into(), value, required)
        }
        other => document.refused(at)(other),
    })
}

/// Reads the table of `heights = { file = "pdf.csv" }`.
fn read_heights(document: &Document<'_>, file: &Path) -> Result<TabulatedHeights, SceneError> {
    let path = document.path(file);
    if let Some(bytes) = document.handed("surface.heights.file", file)? {
        return table(&String::from_utf8_lossy(bytes), &path);
    }
    let text = read_text(&path, SAVE_AS_CSV, || {
        let at = document.place("surface.heights.file");
        Place { field: format!("{} = {path:?}", at.field), ..*at }
    })?;
    table(&text, &path)
}

/// The table of a CSV text with two columns of numbers.
fn table(text: &str, path: &Path) -> Result<TabulatedHeights, SceneError> {
    let cells = Cells::read(text, path, NEEDED)?;
    let Cells { head, rows, .. } = &cells;
    if head[..] != HEADER {
        let at = cells.place(cells.line, "the header");
        return Err(SceneError::value(at, shorten(&head.join(",")), NEEDED));
    }
    if let Some((line, _)) = rows.get(MOST_POINTS) {
        return Err(cells.syntax(*line, format!("there are more than {MOST_POINTS} points")));
    }
    let mut points = vec![];
    let numbers = [cells.column(0, None)?, cells.column(1, None)?];
    for ((line, _), (height, density)) in rows.iter().zip(numbers[0].iter().zip(&numbers[1])) {
        let missing =
            || SceneError::value(cells.place(*line, "the row"), "incomplete", "two numbers");
        points.push(height.zip(*density).ok_or_else(missing)?);
    }
    let name = path.file_name().map_or("table".into(), |name| name.to_string_lossy());
    TabulatedHeights::new(name, &points).map_err(|source| match source {
        ContactError::InTable { row, field, value, required } => {
            let line = row.checked_sub(1).and_then(|row| rows.get(row)).map_or(1, |row| row.0);
            SceneError::value(cells.place(line, field), value, required)
        }
        other => SceneError::from_contact(other, |field| {
            Box::new(Place { line: None, ..*cells.place(1, field) })
        }),
    })
}

/// Warnings about the standard deviation of a table against that of the scene, and about its
/// integral.
pub(crate) fn compare_std(
    document: &Document<'_>,
    table: &TabulatedHeights,
    std: f64,
) -> Result<Vec<Finding>, SceneError> {
    let (own, integral) = (table.standard_deviation(), table.integral());
    let (at, ratio) = (document.place("surface.heights"), own / std);
    // At such a ratio one of the two is not in metres.
    if !(0.1..=10.0).contains(&ratio) {
        let found = format_args!(
            "a table with a standard deviation of {own:e} m, {ratio:.3e} times the asperity_height_std of {std:e} m"
        );
        return Err(SceneError::value(at, found, "heights in metres (a ratio within 10)"));
    }
    let mut notes = vec![];
    if (ratio - 1.0).abs() > DIFFERENT {
        let found = Finding::warning(Code::HeightsStd, "table_height_std", own)
            .usual([(1.0 - DIFFERENT) * std, (1.0 + DIFFERENT) * std])
            .unit("m")
            .fact(format!(
                "the standard deviation of the table is {own:.4e} m, asperity_height_std {std:.4e} m"
            ))
            .advice(
                "the heights are those of the table, and asperity_height_std is the unit of separations only",
            );
        notes.push(found.from_origin(at.to_string()));
    }
    if (integral - 1.0).abs() > 0.01 {
        let found = Finding::warning(Code::HeightsIntegral, "table_integral", integral)
            .usual([0.99, 1.01])
            .fact(format!("the integral of the table is {integral:.4e}, not 1"))
            .advice("the table is normalised");
        notes.push(found.from_origin(at.to_string()));
    }
    Ok(notes)
}

/// The CSV text of a density of heights from points (height \[m\], density \[1/m\]); `heights = {
/// file = "..." }` reads the same values.
#[must_use]
pub fn write_heights(points: &[(f64, f64)]) -> String {
    let row = |(height, density): &(f64, f64)| format!("{height:e},{density:e}\n");
    let rows: String = points.iter().map(row).collect();
    format!("{}\n{rows}", HEADER.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read_text(text: &str) -> Result<TabulatedHeights, SceneError> {
        table(text, Path::new("any.csv"))
    }

    #[test]
    fn windows_files_and_notes_are_read() {
        let table =
            read_text("\u{feff}# scan 7\r\nheight_m, density_per_m\r\n0, 1\r\n\r\n1, 1\r\n");
        assert!((table.unwrap().mean() - 0.5).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn written_tables_read_back(mut heights in prop::collection::vec(-1e-5f64..1e-5, 2..50), seed in 0f64..1.0) {
            heights.sort_by(f64::total_cmp);
            heights.dedup();
            prop_assume!(heights.len() > 1);
            let points: Vec<(f64, f64)> = heights.iter().map(|z| (*z, (z * 1e6 + seed).sin().abs())).collect();
            let found = read_text(&write_heights(&points)).unwrap();
            let wanted = TabulatedHeights::new("any.csv", &points).unwrap();
            prop_assert_eq!(format!("{found:?}"), format!("{wanted:?}"));
        }

        #[test]
        fn any_table_is_read_or_refused_with_its_file(rows in "[-0-9eE.,#naif \n]{0,200}") {
            for text in [format!("height_m,density_per_m\n{rows}"), rows] {
                if let Err(error) = read_text(&text) {
                    prop_assert!(error.to_string().starts_with("any.csv"), "{error}");
                }
            }
        }
    }
}
