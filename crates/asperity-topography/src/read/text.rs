//! Text files: matrix, XYZ points and profiles, distinguished by the number of columns.

use std::borrow::Cow;

use super::header::Header;
use super::points::grid;
use super::profile;
use super::scan::{PixelSize, Scan, points};
use super::table::Table;
use crate::TopographyError;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let bytes = decode(bytes)?;
    let mut table = Table::parse(&bytes)?;
    drop(bytes);
    table.drop_empty();
    let header = Header::read(&table)?;
    table.drop_index(header.index);
    let mut scan = match table.columns {
        1 => column(table, &header),
        3 if header.validity => {
            table.drop_invalid();
            profile(table, &header)?
        }
        2 if header.size == [None; 2] => profile(table, &header)?,
        3 if header.size == [None; 2] => xyz(table, &header)?,
        _ => matrix(table, &header)?,
    };
    if let Some(factor) = header.factor {
        scan.heights.iter_mut().for_each(|height| *height *= factor);
    }
    Ok(scan)
}

/// The text without its mark, in UTF-8 or Latin 1.
fn decode(bytes: &[u8]) -> Result<Cow<'_, [u8]>, TopographyError> {
    let (bytes, unit): (_, fn([u8; 2]) -> u16) = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => return Ok(rest.into()),
        [0xff, 0xfe, rest @ ..] => (rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => (rest, u16::from_be_bytes),
        bytes => return Ok(bytes.into()),
    };
    let units = bytes.as_chunks().0.iter().map(|pair| unit(*pair));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    let text = text.map_err(|error| TopographyError::Line {
        line: 1,
        found: error.to_string(),
        required: "UTF-16 text, by the first two bytes,".to_owned(),
    })?;
    Ok(text.into_bytes().into())
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
        _ => header.pixel_size,
    };
    let unit = header.heights(None);
    Ok(Scan { heights, columns, unit, pixel_size, ..Scan::default() })
}

fn column(table: Table, header: &Header) -> Scan {
    let heights = table.values;
    let columns = heights.len();
    let pixel_size = match header.size[0] {
        Some(width) => PixelSize::Metres([width / columns as f64; 2]),
        None => header.pixel_size,
    };
    let unit = header.heights(Some(0));
    Scan { heights, columns, unit, pixel_size, ..Scan::default() }
}

fn profile(table: Table, header: &Header) -> Result<Scan, TopographyError> {
    let rows = table.values.chunks(table.columns);
    let (places, heights): (Vec<f64>, Vec<f64>) = rows.map(|row| (row[0], row[1])).unzip();
    drop(table);
    let profile::Profile { heights, step, note } = profile::profile(places, heights)?;
    let pixel_size = header.distance([step; 2])?;
    let (unit, notes) = (header.heights(Some(1)), note.into_iter().collect());
    Ok(Scan { columns: heights.len(), heights, unit, pixel_size, notes })
}

fn xyz(table: Table, header: &Header) -> Result<Scan, TopographyError> {
    let (heights, columns, pixel_size) = grid(table.values)?;
    let pixel_size = header.distance(pixel_size)?;
    let unit = header.heights(Some(2));
    Ok(Scan { heights, columns, unit, pixel_size, ..Scan::default() })
}
