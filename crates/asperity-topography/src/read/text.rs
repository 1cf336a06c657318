//! Text files: matrix, XYZ points and profiles, distinguished by the number of columns.

use super::points::grid;
use super::scan::{PixelSize, Scan, points};
use super::table::{Delimiter, Table};
use crate::error::excerpt;
use crate::{LengthUnit, TopographyError};

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    // UTF-16 text, and binary files of other formats.
    if bytes[..bytes.len().min(4096)].contains(&0) {
        return Err(TopographyError::UnknownFormat);
    }
    let table = Table::parse(bytes)?;
    let header = Header::read(&table)?;
    match table.columns {
        1 => Ok(column(table, &header)),
        2 if header.size == [None; 2] => profile(table, &header),
        3 if header.size == [None; 2] => xyz(table, &header),
        _ => matrix(table, &header),
    }
}

fn matrix(table: Table, header: &Header) -> Result<Scan, TopographyError> {
    let Table { values: heights, columns, .. } = table;
    let rows = heights.len() / columns;
    points(columns as u64, rows as u64)?;
    let pixel_size = match header.size {
        [Some(width), Some(height)] => {
            PixelSize::Metres([width / columns as f64, height / rows as f64])
        }
        [Some(width), None] if rows == 1 => PixelSize::Metres([width / columns as f64; 2]),
        _ => PixelSize::Unknown,
    };
    Ok(Scan { heights, columns, unit: header.unit, pixel_size })
}

fn column(table: Table, header: &Header) -> Scan {
    let heights = table.values;
    let columns = heights.len();
    let pixel_size = match header.size[0] {
        Some(width) => PixelSize::Metres([width / columns as f64; 2]),
        None => PixelSize::Unknown,
    };
    let unit = header.unit.or(header.columns.first().copied().flatten());
    Scan { heights, columns, unit, pixel_size }
}

fn profile(table: Table, header: &Header) -> Result<Scan, TopographyError> {
    let (places, heights): (Vec<f64>, Vec<f64>) =
        table.values.chunks(2).map(|row| (row[0], row[1])).unzip();
    drop(table);
    let step = super::points::equidistant(&places)?;
    let pixel_size = header.pixel_size([step; 2])?;
    let unit = header.columns.get(1).copied().flatten().or(header.unit);
    Ok(Scan { columns: heights.len(), heights, unit, pixel_size })
}

fn xyz(table: Table, header: &Header) -> Result<Scan, TopographyError> {
    let (heights, columns, pixel_size) = grid(table.values)?;
    let pixel_size = header.pixel_size(pixel_size)?;
    let unit = header.columns.get(2).copied().flatten().or(header.unit);
    Ok(Scan { heights, columns, unit, pixel_size })
}

/// The header above the numbers.
#[derive(Default)]
struct Header {
    /// Unit of the heights.
    unit: Option<LengthUnit>,
    /// Width and height \[m\].
    size: [Option<f64>; 2],
    /// Units over the columns.
    columns: Vec<Option<LengthUnit>>,
}

impl Header {
    fn read(table: &Table) -> Result<Self, TopographyError> {
        let mut header = Self::default();
        for (line, text) in &table.header {
            let bare = text.trim_start_matches(['#', '%', '\\', '/', '*', '"', ' ']);
            let Some((key, value)) = bare.split_once([':', '=']) else { continue };
            let value = value.trim().trim_end_matches('"');
            let wrong = |required: &str| TopographyError::Line {
                line: *line,
                found: excerpt(bare),
                required: required.to_owned(),
            };
            match key.trim().to_ascii_lowercase().as_str() {
                "width" => {
                    header.size[0] =
                        Some(length(value).ok_or_else(|| wrong("a length, for example 10 um,"))?);
                }
                "height" => {
                    header.size[1] =
                        Some(length(value).ok_or_else(|| wrong("a length, for example 10 um,"))?);
                }
                "value units"
                | "value unit"
                | "exported image units"
                | "height units"
                | "height unit"
                | "z units"
                | "z unit"
                | "units"
                | "unit" => {
                    let unit = value.parse();
                    header.unit = Some(unit.map_err(|_| wrong("a unit of length"))?);
                }
                _ => {}
            }
        }
        // The last line may name the columns.
        if let Some((_, names)) = table.header.last() {
            let names = names.trim_start_matches(['#', '%', '\\', '/', '*']).as_bytes();
            let delimiter = match table.delimiter {
                Delimiter::Space if names.contains(&b',') => Delimiter::Comma,
                other => other,
            };
            if table.columns <= 3 && delimiter.fields(names).count() == table.columns {
                let unit = |name| unit_in(&String::from_utf8_lossy(name));
                header.columns = delimiter.fields(names).map(unit).collect();
            }
        }
        Ok(header)
    }

    /// The distance of points in the units over the columns of positions.
    fn pixel_size(&self, size: [f64; 2]) -> Result<PixelSize, TopographyError> {
        let unit = |column: usize| self.columns.get(column).copied().flatten();
        let places = if self.columns.len() > 2 { [unit(0), unit(1)] } else { [unit(0); 2] };
        match places {
            [Some(x), Some(y)] => {
                Ok(PixelSize::Metres([size[0] * x.metres(), size[1] * y.metres()]))
            }
            [None, None] => Ok(PixelSize::InUnit(size)),
            _ => Err(TopographyError::Grid {
                field: "header",
                found: "a unit over one of the columns x and y".to_owned(),
                required: "units over both or over neither".to_owned(),
            }),
        }
    }
}

/// `10.00 µm` in metres.
fn length(text: &str) -> Option<f64> {
    let end = text.find(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E'))?;
    let (number, unit) = text.split_at(end);
    let length = number.trim().parse::<f64>().ok()? * unit.parse::<LengthUnit>().ok()?.metres();
    (length.is_finite() && length > 0.0).then_some(length)
}

/// The unit in `x [mm]`, `x (mm)`, `x_mm` or `x / mm`.
fn unit_in(name: &str) -> Option<LengthUnit> {
    let name = name.trim().trim_matches('"').trim_end_matches([']', ')']);
    let (_, unit) = name.rsplit_once(['[', '(', '_', '/'])?;
    unit.parse().ok()
}
