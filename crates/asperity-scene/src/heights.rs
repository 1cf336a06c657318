//! `heights`: how the asperities are spread, and the CSV file of a measured density.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use asperity::{ContactError, HeightDistribution, TabulatedHeights};

use crate::document::Section;
use crate::words::quoted;
use crate::{Place, SceneError};

/// Header of the CSV file: it states the units.
const HEADER: [&str; 2] = ["height_m", "density_per_m"];
/// No table of heights needs more points, and every one costs time in each evaluation.
const MOST_POINTS: usize = 10_000;
/// Nor does one need more bytes.
const MOST_BYTES: u64 = 1 << 20;

/// The heights of a scene as its file states them.
#[derive(Debug, Clone)]
pub(crate) enum Spread {
    Gaussian,
    Exponential,
    Table(Box<TabulatedHeights>),
}

impl Spread {
    pub(crate) fn table(&self) -> Option<&TabulatedHeights> {
        match self {
            Self::Table(table) => Some(table),
            _ => None,
        }
    }

    /// As the library takes them, for this `asperity_height_std` \[m\].
    pub(crate) fn distribution(self, std: f64) -> Result<HeightDistribution, ContactError> {
        Ok(match self {
            Self::Gaussian => HeightDistribution::Gaussian,
            Self::Exponential => HeightDistribution::Exponential,
            Self::Table(table) => HeightDistribution::other(table.in_units_of(std)?),
        })
    }
}

pub(crate) fn spread(section: &Section<'_>) -> Result<Spread, SceneError> {
    let Some(entry) = section.entry("heights") else { return Ok(Spread::Gaussian) };
    if !entry.is_table() {
        let words = [("gaussian", false), ("exponential", true)];
        let exponential = entry.one_of_or(&words, "{ file = \"pdf.csv\" }")?;
        return Ok(if exponential { Spread::Exponential } else { Spread::Gaussian });
    }
    let table = entry.section("heights")?;
    let needed = "the path of a CSV file with the columns height_m,density_per_m";
    let file = table.entry("file").ok_or_else(|| table.missing("file", needed))?;
    let path = section.document().path(file.text().ok_or_else(|| file.wrong(needed))?);
    Ok(Spread::Table(Box::new(read(&path, &file.at)?)))
}

/// Reads a table; `named` is the place that names the file.
fn read(path: &Path, named: &Place) -> Result<TabulatedHeights, SceneError> {
    let unreadable = |reason: String| SceneError::Unreadable {
        at: Box::new(Place { field: format!("{} = {path:?}", named.field), ..named.clone() }),
        reason,
    };
    let file = File::open(path).map_err(|error| unreadable(error.to_string()))?;
    let mut text = String::new();
    file.take(MOST_BYTES + 1).read_to_string(&mut text).map_err(|e| unreadable(e.to_string()))?;
    if text.len() as u64 > MOST_BYTES {
        return Err(unreadable(format!("it has more than {MOST_BYTES} bytes")));
    }
    let name = path.file_name().map_or("table".into(), |name| name.to_string_lossy());
    table(&text, &name, path)
}

/// The table of a CSV text: two numbers a line below the header; lines that are empty or begin
/// with # are skipped.
fn table(text: &str, name: &str, path: &Path) -> Result<TabulatedHeights, SceneError> {
    let place = |line: Option<usize>, field: &str| {
        Box::new(Place { file: Some(path.to_path_buf()), line, field: field.into() })
    };
    let value = |line: usize, field: &str, found: &str, needed: &str| SceneError::Value {
        at: place(Some(line), field),
        found: quoted(found),
        near: None,
        needed: needed.into(),
    };
    let text = text.trim_start_matches('\u{feff}');
    let numbered = text.lines().map(str::trim).enumerate().map(|(k, line)| (k + 1, line));
    let mut rows = numbered.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (line, header) = rows.next().unwrap_or((1, ""));
    if header.split(',').map(str::trim).ne(HEADER) {
        let needed = "\"height_m,density_per_m\", heights in m and densities in 1/m,";
        return Err(value(line, "the header", header, needed));
    }
    let (mut points, mut lines) = (vec![], vec![]);
    for (line, row) in rows {
        if points.len() == MOST_POINTS {
            let reason = format!("there are more than {MOST_POINTS} points");
            return Err(SceneError::Syntax { at: place(Some(line), "CSV"), reason });
        }
        let Some((height, density)) = row.split_once(',') else {
            return Err(value(line, "the row", row, "two numbers with a comma between them"));
        };
        let number = |text: &str, field: &str| {
            text.trim().parse::<f64>().map_err(|_| value(line, field, text.trim(), "a number"))
        };
        points.push((number(height, HEADER[0])?, number(density, HEADER[1])?));
        lines.push(line);
    }
    TabulatedHeights::new(name, &points).map_err(|source| match source {
        ContactError::InTable { row, field, value, required } => SceneError::Value {
            at: place(row.checked_sub(1).and_then(|row| lines.get(row)).copied(), field),
            found: format!("{value:?}"),
            near: None,
            needed: required.trim_end_matches(',').into(),
        },
        other => SceneError::from_contact(other, |field| place(None, field)),
    })
}

/// The CSV file of a density of heights, as points (height \[m\], density \[1/m\]): what
/// `heights = { file = "..." }` reads back exactly.
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
        table(text, "any", Path::new("any.csv"))
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
            let wanted = TabulatedHeights::new("any", &points).unwrap();
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
