//! ISO 25178-71 `.sdf`, text and binary, versions ISO-1.0, ISO-2.0 and BCR-1.0.
//!
//! The layout follows the readers of Gwyddion, surfalize and sdfio, not the standard.

use super::refusal::sdf as refuse;
use super::scan::{PixelSize, Scan};
use super::sdf_ascii;
use super::sdf_header::Header;
use crate::{LengthUnit, TopographyError};

pub(super) fn is_sdf(bytes: &[u8]) -> bool {
    let (kind, family) = (bytes.first(), bytes.get(1..5).unwrap_or_default());
    matches!(kind, Some(b'a' | b'A' | b'b' | b'B')) && matches!(family, b"ISO-" | b"BCR-" | b"NPL-")
}

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let (heights, header) = match bytes.first() {
        _ if !is_sdf(bytes) => {
            let required = "aISO-1.0, bISO-1.0, aISO-2.0, bISO-2.0, aBCR-1.0 or bBCR-1.0";
            return Err(refuse("file", "something else", required));
        }
        Some(b'a' | b'A') => sdf_ascii::read(bytes)?,
        _ => binary(bytes)?,
    };
    let pixel_size = PixelSize::Metres(header.pixel_size()?);
    let scale = header.height_scale()?;
    let heights = heights.into_iter().map(|height| height * scale).collect();
    let (columns, unit) = (header.columns as usize, Some(LengthUnit::Metre));
    Ok(Scan { heights, columns, unit, pixel_size, notes: vec![] })
}

fn binary(bytes: &[u8]) -> Result<(Vec<f64>, Header), TopographyError> {
    let short = || refuse("header", format!("{} bytes", bytes.len()), "a whole header");
    let (family, version) = (bytes.get(1..4), bytes.get(5..8));
    let bcr = family == Some(b"BCR");
    // Name of the manufacturer and two dates are skipped.
    let rest = bytes.get(8 + 10 + 12 + 12..).ok_or_else(short)?;
    let (columns, rows, rest) = match version {
        Some(b"1.0" | b"0.0") => {
            let (counts, rest) = rest.split_first_chunk::<4>().ok_or_else(short)?;
            let [a, b, c, d] = *counts;
            (u16::from_le_bytes([a, b]).into(), u16::from_le_bytes([c, d]).into(), rest)
        }
        Some(b"2.0") => {
            let (counts, rest) = rest.split_first_chunk::<8>().ok_or_else(short)?;
            let counts = u64::from_le_bytes(*counts);
            (counts & 0xffff_ffff, counts >> 32, rest)
        }
        other => {
            let found = String::from_utf8_lossy(other.unwrap_or_default());
            return Err(refuse("version", found, "1.0 or 2.0"));
        }
    };
    let (numbers, rest) = rest.split_first_chunk::<32>().ok_or_else(short)?;
    let ([compression, data_type, check], data) = rest.split_first_chunk().ok_or_else(short)?;
    let numbers = numbers.as_chunks().0;
    let number = |i: usize| numbers.get(i).map_or(f64::NAN, |number| f64::from_le_bytes(*number));
    let header = Header {
        columns,
        rows,
        scales: [number(0), number(1), number(2)],
        packing: [*compression, *check],
        data_type: *data_type,
        largest_is_missing: bcr,
    };
    let (n, sample) = (header.points()?, header.sample()?);
    let needed = n * sample.size();
    let Some(data) = data.get(..needed) else {
        let required = format!("{needed}, for {columns} x {rows} points");
        return Err(refuse("data", format!("{} bytes", data.len()), &required));
    };
    let mut heights = Vec::with_capacity(n);
    sample.decode(data, &mut heights);
    header.mark(&mut heights)?;
    Ok((heights, header))
}
