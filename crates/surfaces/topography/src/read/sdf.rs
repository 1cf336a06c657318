//! ISO 25178-71 `.sdf`, text and binary, versions ISO-1.0, ISO-2.0 and BCR-1.0.
//!
//! The layout follows the readers of Gwyddion, surfalize and sdfio, not the standard.

use super::sample::Sample;
use super::scan::{Scan, points, positive};
use crate::error::refuse;
use crate::{LengthUnit, TopographyError};

/// Types of the heights by their number, and the names of these types in text.
const TYPES: [&[u8; 2]; 8] = [b"u1", b"u2", b"u4", b"f4", b"i1", b"i2", b"i4", b"f8"];
const NAMES: [&str; 8] =
    ["UCHAR", "UINTEGER", "ULONGINT", "FLOAT", "CHAR", "INTEGER", "LONGINT", "DOUBLE"];

pub(super) fn is_sdf(bytes: &[u8]) -> bool {
    let (kind, family) = (bytes.first(), bytes.get(1..5).unwrap_or_default());
    matches!(kind, Some(b'a' | b'A' | b'b' | b'B')) && matches!(family, b"ISO-" | b"BCR-" | b"NPL-")
}

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let (heights, header) = match bytes.first() {
        _ if !is_sdf(bytes) => {
            let required = "aISO-1.0, bISO-1.0, aISO-2.0, bISO-2.0, aBCR-1.0 or bBCR-1.0";
            return Err(refuse("sdf file", "something else", required));
        }
        Some(b'a' | b'A') => text(bytes)?,
        _ => binary(bytes)?,
    };
    let [x, y, z] = header.scales;
    let dx = positive("sdf Xscale", x)?;
    // A profile has no distance of rows.
    let dy = if header.rows == 1 { dx } else { positive("sdf Yscale", y)? };
    let scale = positive("sdf Zscale", z)?;
    let heights = heights.into_iter().map(|height| height * scale).collect();
    let unit = Some(LengthUnit::Metre);
    Ok(Scan::new(heights, header.columns as usize, unit, [dx, dy]))
}

/// The fields of a header. Lengths are in m.
struct Header {
    columns: u64,
    rows: u64,
    scales: [f64; 3],
    /// Compression and checksum, which are not read.
    packing: [u8; 2],
    data_type: u8,
}

impl Header {
    /// The number of points and their type.
    fn points(&self) -> Result<(usize, Sample), TopographyError> {
        for (packing, field) in self.packing.into_iter().zip(["Compression", "CheckType"]) {
            if packing != 0 {
                return Err(refuse(format!("sdf {field}"), packing, "0: none"));
            }
        }
        for (n, field) in [(self.columns, "NumPoints"), (self.rows, "NumProfiles")] {
            if n == 0 {
                return Err(refuse(format!("sdf {field}"), n, "at least 1"));
            }
        }
        let n = points(self.columns, self.rows)?;
        match TYPES.get(usize::from(self.data_type)) {
            Some(name) => Ok((n, Sample::new(**name))),
            None => Err(refuse("sdf DataType", self.data_type, "0 to 7")),
        }
    }

    /// The refusal of data that are not those of all points.
    fn wrong(&self, found: impl std::fmt::Display, required: String) -> TopographyError {
        refuse(
            "sdf data",
            found,
            format!("{required}, for {} x {} points", self.columns, self.rows),
        )
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
    // Name of the manufacturer and two dates are skipped.
    let rest = bytes.get(8 + 10 + 12 + 12..).ok_or_else(short)?;
    let (columns, rows, rest) = match bytes.get(5..8) {
        Some(b"1.0" | b"0.0") => {
            let ([a, b, c, d], rest) = rest.split_first_chunk::<4>().ok_or_else(short)?;
            (u16::from_le_bytes([*a, *b]).into(), u16::from_le_bytes([*c, *d]).into(), rest)
        }
        Some(b"2.0") => {
            let (counts, rest) = rest.split_first_chunk::<8>().ok_or_else(short)?;
            let counts = u64::from_le_bytes(*counts);
            (counts & 0xffff_ffff, counts >> 32, rest)
        }
        other => {
            let found = String::from_utf8_lossy(other.unwrap_or_default());
            return Err(refuse("sdf version", found, "1.0 or 2.0"));
        }
    };
    let (numbers, rest) = rest.split_first_chunk::<32>().ok_or_else(short)?;
    let ([compression, data_type, check], data) = rest.split_first_chunk().ok_or_else(short)?;
    let number = |i: usize| f64::from_le_bytes(std::array::from_fn(|k| numbers[8 * i + k]));
    let header = Header {
        columns,
        rows,
        scales: [number(0), number(1), number(2)],
        packing: [*compression, *check],
        data_type: *data_type,
    };
    let (n, sample) = header.points()?;
    let needed = n * sample.size;
    let found = || header.wrong(format!("{} bytes", data.len()), needed.to_string());
    let whole = data.get(..needed).ok_or_else(found)?;
    let mut heights = Vec::with_capacity(n);
    sample.decode(whole, &mut heights);
    mark(&mut heights, sample, is_bcr(bytes));
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
    let (n, sample) = header.points()?;
    // A number and its separator take two bytes.
    if n / 2 > bytes.len() {
        return Err(header.wrong(format!("{} bytes", bytes.len()), n.to_string()));
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
            heights.push(height(word).ok_or_else(unread)?);
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
        mark(&mut heights, sample, bcr);
    }
    Ok((heights, header))
}

fn height(word: &[u8]) -> Option<f64> {
    if [&b"bad"[..], b"nan"].iter().any(|mark| word.eq_ignore_ascii_case(mark)) {
        return Some(f64::NAN);
    }
    let number: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    number.is_finite().then_some(number)
}

impl Header {
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
        let wrong =
            |name: &str, found: &str, required| refuse(format!("sdf {name}"), found, required);
        let there =
            |name| value(name).ok_or_else(|| wrong(name, "nothing", "this field in the header"));
        let count = |name| {
            let found = there(name)?;
            found.parse::<u64>().map_err(|_| wrong(name, found, "a whole number"))
        };
        let scale = |name| {
            let found = there(name)?;
            found.parse::<f64>().map_err(|_| wrong(name, found, "a number"))
        };
        let none = |name| match value(name).map(str::to_ascii_lowercase).as_deref() {
            None | Some("null" | "none") => Ok(0),
            Some(found) => found.parse().map_err(|_| wrong(name, found, "0: none")),
        };
        let (columns, rows) = (count("NumPoints")?, count("NumProfiles")?);
        let y = if rows == 1 && value("Yscale").is_none() { "Xscale" } else { "Yscale" };
        // Doubles, if the header does not say so: numbers of text have no other limits.
        let kind = value("DataType").unwrap_or("7");
        let named = NAMES.iter().position(|name| kind.eq_ignore_ascii_case(name));
        let data_type = named.map(|at| at as u8).or_else(|| kind.parse().ok());
        Ok(Self {
            columns,
            rows,
            scales: [scale("Xscale")?, scale(y)?, scale("Zscale")?],
            packing: [none("Compression")?, none("CheckType")?],
            data_type: data_type.ok_or_else(|| wrong("DataType", kind, "0 to 7"))?,
        })
    }
}
