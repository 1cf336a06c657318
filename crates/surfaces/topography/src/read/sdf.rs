//! ISO 25178-71 `.sdf`, text and binary, versions ISO-1.0, ISO-2.0 and BCR-1.0.
//!
//! The layout follows the readers of Gwyddion, surfalize and sdfio, not the standard.

use std::fmt::Display;

use super::lines::value;
use super::sample::{Bytes, Sample};
use super::scan::{Scan, points, positive};
use crate::error::refuse;
use crate::{LengthUnit, TopographyError};

/// The fields of a header, in the order of binary ones. Lengths are in m.
const FIELDS: [&str; 8] = [
    "NumPoints",
    "NumProfiles",
    "Xscale",
    "Yscale",
    "Zscale",
    "Compression",
    "DataType",
    "CheckType",
];
/// Types of the heights by their number, and the names of these types in text.
const TYPES: [&[u8; 2]; 8] = [b"u1", b"u2", b"u4", b"f4", b"i1", b"i2", b"i4", b"f8"];
const NAMES: [&str; 8] =
    ["UCHAR", "UINTEGER", "ULONGINT", "FLOAT", "CHAR", "INTEGER", "LONGINT", "DOUBLE"];

pub(super) fn is_sdf(bytes: &[u8]) -> bool {
    let (kind, family) = (bytes.first(), bytes.get(1..5).unwrap_or_default());
    matches!(kind, Some(b'a' | b'A' | b'b' | b'B')) && matches!(family, b"ISO-" | b"BCR-" | b"NPL-")
}

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let (heights, Header { columns, pixel, scale, .. }) = match bytes.first() {
        _ if !is_sdf(bytes) => {
            let required = "aISO-1.0, bISO-1.0, aISO-2.0, bISO-2.0, aBCR-1.0 or bBCR-1.0";
            return Err(refuse("sdf file", "something else", required));
        }
        Some(b'a' | b'A') => text(bytes)?,
        _ => binary(bytes)?,
    };
    let heights = heights.into_iter().map(|height| height * scale).collect();
    Ok(Scan::new(heights, columns, Some(LengthUnit::METRE), pixel))
}

/// What a header declares.
struct Header {
    columns: usize,
    /// Of all points.
    count: usize,
    /// \[m\]
    pixel: [f64; 2],
    /// Of a number \[m\].
    scale: f64,
    sample: Sample,
}

impl Header {
    /// The header of the numbers of [`FIELDS`].
    fn new(fields: [f64; 8]) -> Result<Self, TopographyError> {
        let [columns, rows, x, y, z, _, kind, _] = fields;
        let wrong =
            |at: usize, required| refuse(format!("sdf {}", FIELDS[at]), fields[at], required);
        // Neither compressed data nor checksums are read.
        if let Some(at) = [5, 7].into_iter().find(|at| fields[*at].abs() > 0.0) {
            return Err(wrong(at, "0: none"));
        }
        if let Some(at) =
            [0, 1].into_iter().find(|at| fields[*at] < 1.0 || fields[*at].fract() > 0.0)
        {
            return Err(wrong(at, "a whole number of at least 1"));
        }
        let kind = (0..TYPES.len()).find(|number| (*number as f64).total_cmp(&kind).is_eq());
        let kind = kind.ok_or_else(|| wrong(6, "0 to 7"))?;
        let dx = positive("sdf Xscale", x)?;
        // A profile has no distance of rows.
        let dy = if rows > 1.0 { positive("sdf Yscale", y)? } else { dx };
        Ok(Self {
            columns: columns as usize,
            count: points(columns as u64, rows as u64)?,
            pixel: [dx, dy],
            scale: positive("sdf Zscale", z)?,
            sample: Sample::new(*TYPES[kind]),
        })
    }

    /// The header of lines `Name = value`.
    fn of_lines<'a>(
        lines: impl Iterator<Item = &'a [u8]> + Clone,
    ) -> Result<Self, TopographyError> {
        let value = |name: &str| {
            lines.clone().find_map(|line| {
                let (found, value) = std::str::from_utf8(line).ok()?.split_once('=')?;
                found.trim().eq_ignore_ascii_case(name).then_some(value.trim())
            })
        };
        let mut fields = [0.0; 8];
        for (name, field) in FIELDS.into_iter().zip(&mut fields) {
            let wrong = |found, required| refuse(format!("sdf {name}"), found, required);
            let found = match (name, value(name)) {
                // Doubles: numbers of text have no other limits.
                ("DataType", None) => "7",
                ("Compression" | "CheckType", None) => "0",
                ("Yscale", None) if value("NumProfiles") == Some("1") => "0",
                (_, found) => found.ok_or_else(|| wrong("nothing", "this field in the header"))?,
            };
            let named = NAMES.iter().position(|known| found.eq_ignore_ascii_case(known));
            let none = ["null", "none"].iter().any(|none| found.eq_ignore_ascii_case(none));
            let number = if none { Some(0.0) } else { named.map(|at| at as f64) };
            let number = number.or_else(|| found.parse().ok());
            *field = number.ok_or_else(|| wrong(found, "a number"))?;
        }
        Self::new(fields)
    }

    /// The refusal of data that are not those of all points.
    fn wrong(&self, found: impl Display, required: impl Display) -> TopographyError {
        let Self { columns, count, .. } = self;
        let required = format!("{required}, for {columns} x {} points", count / columns);
        refuse("sdf data", found, required)
    }
}

/// Whether the largest number of the type marks missing points. In ISO it is the smallest.
fn is_bcr(bytes: &[u8]) -> bool {
    bytes.get(1..4) == Some(b"BCR")
}

/// NaN for numbers that mark missing points.
fn mark(heights: &mut [f64], sample: Sample, bcr: bool) {
    let [least, largest] = sample.range();
    let missing = |height: f64| if bcr { height >= largest } else { height <= least };
    heights.iter_mut().filter(|z| missing(**z)).for_each(|height| *height = f64::NAN);
}

fn binary(bytes: &[u8]) -> Result<(Vec<f64>, Header), TopographyError> {
    let short = || refuse("sdf header", format!("{} bytes", bytes.len()), "a whole header");
    let count = match bytes.get(5..8) {
        Some(b"1.0" | b"0.0") => *b"u2",
        Some(b"2.0") => *b"u4",
        other => {
            let found = String::from_utf8_lossy(other.unwrap_or_default());
            return Err(refuse("sdf version", found, "1.0 or 2.0"));
        }
    };
    let mut rest = Bytes(bytes);
    // The version, the name of the manufacturer and two dates.
    rest.take(8 + 10 + 12 + 12).ok_or_else(short)?;
    let mut fields = [0.0; 8];
    let types = [count, count, *b"f8", *b"f8", *b"f8", *b"u1", *b"u1", *b"u1"];
    for (at, name) in types.into_iter().enumerate() {
        // The resolution of heights.
        let skipped = if at == 5 { 8 } else { 0 };
        rest.take(skipped).ok_or_else(short)?;
        fields[at] = rest.number(name).ok_or_else(short)?;
    }
    let header = Header::new(fields)?;
    let (n, needed) = (rest.0.len(), header.count * header.sample.size);
    let data = rest.take(needed).ok_or_else(|| header.wrong(format!("{n} bytes"), needed))?;
    let mut heights = header.sample.decode(data);
    mark(&mut heights, header.sample, is_bcr(bytes));
    Ok((heights, header))
}

/// The text form: `Name = value` lines, a line `*`, and numbers up to another `*`.
fn text(bytes: &[u8]) -> Result<(Vec<f64>, Header), TopographyError> {
    let bcr = is_bcr(bytes);
    let lines = bytes.split(|byte| *byte == b'\n').map(|line| {
        // BCR-1.0 allows comments.
        let end = line.iter().position(|byte| bcr && *byte == b';').unwrap_or(line.len());
        line[..end].trim_ascii()
    });
    let header = Header::of_lines(lines.clone().take_while(|line| line != b"*"))?;
    let n = header.count;
    // A number and its separator take two bytes.
    if n / 2 > bytes.len() {
        return Err(header.wrong(format!("{} bytes", bytes.len()), n));
    }
    let mut heights = Vec::with_capacity(n);
    // Gwyddion does not end the data of a BCR file.
    let mut whole = bcr;
    for line in lines.skip_while(|line| line != b"*").skip(1) {
        whole |= line == b"*";
        if line == b"*" || heights.len() > n {
            break;
        }
        for word in line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
            let required = "a finite number or BAD";
            let unread = || refuse("sdf data", String::from_utf8_lossy(word), required);
            heights.push(value(word, false).ok_or_else(unread)?);
        }
    }
    if heights.len() != n {
        let found = if heights.len() > n { "more".to_owned() } else { heights.len().to_string() };
        return Err(header.wrong(found, format!("{n} numbers")));
    }
    if !whole {
        return Err(refuse("sdf data", "the end of the file", "a line with * after the numbers"));
    }
    if bcr {
        mark(&mut heights, header.sample, bcr);
    }
    Ok((heights, header))
}
