//! Text files: matrix, XYZ points and profiles, distinguished by the number of columns.

use std::borrow::Cow;

use super::header::Header;
use super::points::grid;
use super::profile::profile;
use super::scan::{PixelSize, Scan, points};
use super::table::NumberTable;
use crate::TopographyError;
use crate::error::refuse_line;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let mut table = NumberTable::parse(&without_words(with_line_ends(decode(bytes)?)))?;
    table.drop_empty();
    let header = Header::read(&table)?;
    if header.index && table.columns > 1 {
        table.drop_column(0);
    }
    let mut scan = match (table.columns, header.size) {
        (3, _) if header.validity => {
            table.drop_invalid();
            positions(table, &header)?
        }
        (2, [None, None]) => positions(table, &header)?,
        (3, [None, None]) => {
            let (heights, columns, pixel_size) = grid(table.values)?;
            let (unit, pixel_size) = (header.heights(Some(2)), header.distance(pixel_size)?);
            Scan { heights, columns, unit, pixel_size, notes: vec![] }
        }
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
    let required = "UTF-16 text, by the first two bytes,";
    let text = text.map_err(|error| refuse_line(1, &error.to_string(), required))?;
    Ok(text.into_bytes().into())
}

/// The text with the line ends of Unix, where there are only those of old Macs.
fn with_line_ends(mut bytes: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    if !bytes.contains(&b'\n') && bytes.contains(&b'\r') {
        bytes.to_mut().iter_mut().filter(|byte| **byte == b'\r').for_each(|byte| *byte = b'\n');
    }
    bytes
}

/// The text with `nan` for the words `No Data`, which spaces would separate.
fn without_words(mut bytes: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    const WORDS: &[u8] = b"no data";
    let is_mark = |part: &[u8]| part.eq_ignore_ascii_case(WORDS);
    let mut done = 0;
    while let Some(ahead) = bytes[done..].windows(WORDS.len()).position(is_mark) {
        let at = done + ahead;
        done = at + WORDS.len();
        bytes.to_mut()[at..done].copy_from_slice(b"  nan  ");
    }
    bytes
}

/// A row of heights to a line; a single column is a profile.
fn matrix(table: NumberTable, header: &Header) -> Result<Scan, TopographyError> {
    let n = table.values.len();
    let (columns, over) = if table.columns == 1 { (n, Some(0)) } else { (table.columns, None) };
    let rows = n / columns;
    points(columns as u64, rows as u64)?;
    let pixel_size = match header.size {
        [Some(width), _] if rows == 1 => PixelSize::Metres([width / columns as f64; 2]),
        [Some(width), Some(height)] => {
            PixelSize::Metres([width / columns as f64, height / rows as f64])
        }
        _ => header.pixel_size,
    };
    let unit = header.heights(over);
    Ok(Scan { heights: table.values, columns, unit, pixel_size, notes: vec![] })
}

/// A profile of positions and heights.
fn positions(table: NumberTable, header: &Header) -> Result<Scan, TopographyError> {
    let rows = table.values.chunks(table.columns);
    let (places, heights) = rows.map(|row| (row[0], row[1])).unzip();
    drop(table);
    let (scan, step) = profile(places, heights)?;
    Ok(Scan { unit: header.heights(Some(1)), pixel_size: header.distance([step; 2])?, ..scan })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_may_end_as_on_old_macs() {
        let [unix, mac] =
            ["1 2 3 4\n5 6 7 8\n", "1 2 3 4\r5 6 7 8\r"].map(|text| scan(text.as_bytes()).unwrap());
        assert_eq!((mac.columns, &mac.heights), (4, &unix.heights));
        assert_eq!(scan(b"1 2 3 4\r\n5 6 7 8\r\n").unwrap().columns, 4);
    }

    #[test]
    fn no_data_is_one_mark() {
        let table = |text: &'static str| NumberTable::parse(&without_words(text.as_bytes().into()));
        let found = table("0 0 No Data\n1 0 2.5\n2 0 no data\n").unwrap();
        assert_eq!((found.columns, found.values.len()), (3, 9));
        let missing: Vec<_> = (0..9).filter(|k| found.values[*k].is_nan()).collect();
        assert_eq!(missing, [2, 8]);
        assert_eq!(table("1;No Data;2\n1;2;3\n").unwrap().columns, 3);
        let wrong = table("0 0 1\n1 0 No Datum\n").err().unwrap().to_string();
        assert!(wrong.starts_with("line 2: \"No\""), "{wrong}");
    }
}
