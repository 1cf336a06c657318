//! NumPy `.npy`, versions 1 to 3: a header as a Python literal, then plain numbers.
//!
//! The header is parsed here because crates for it multiply declared shapes and allocate before
//! checking against the file, and accept nested brackets of any depth.

use std::io::Cursor;

use zip::ZipArchive;

use super::refusal::npy as refuse;
use super::sample::{Kind, Sample};
use super::scan::{Scan, points};
use crate::TopographyError;
use crate::error::excerpt;

pub(super) const MAGIC: &[u8] = b"\x93NUMPY";
/// The limit of NumPy itself.
const MAX_HEADER: usize = 10_000;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let (header, data) = parts(bytes)?;
    let header = Header::parse(header)?;
    let (rows, columns) = match header.shape[..] {
        [n] => (1, n),
        [rows, columns] => (rows, columns),
        _ => {
            return Err(refuse("shape", format!("{:?}", header.shape), "(n,) or (rows, columns)"));
        }
    };
    let n = points(columns, rows)?;
    // Both factors are limited above.
    let needed = n * header.sample.size();
    if data.len() != needed {
        let required = format!("{needed}, by the shape and the type");
        return Err(refuse("data", format!("{} bytes", data.len()), &required));
    }
    let mut heights = Vec::with_capacity(n);
    header.sample.decode(data, &mut heights);
    let (rows, columns) = (rows as usize, columns as usize);
    if header.fortran_order && rows > 1 {
        // The file stores the heights column by column.
        heights = (0..n).map(|i| heights[i / columns + rows * (i % columns)]).collect();
    }
    Ok(Scan { heights, columns, ..Scan::default() })
}

/// The error for an `.npz`, an archive of several arrays.
pub(super) fn archive(bytes: &[u8]) -> TopographyError {
    let archive = ZipArchive::new(Cursor::new(bytes)).ok();
    let names =
        archive.map(|archive| archive.file_names().flatten().collect::<Vec<_>>().join(", "));
    let found = format!("an archive of arrays ({})", names.unwrap_or_else(|| "broken".into()));
    let required = "a single array: numpy.save(\"scan.npy\", numpy.load(\"scan.npz\")[name])";
    TopographyError::Field {
        format: "npz",
        field: "file",
        found: excerpt(&found),
        required: required.to_owned(),
    }
}

/// Header text and data.
fn parts(bytes: &[u8]) -> Result<(&str, &[u8]), TopographyError> {
    let short = || refuse("header", format!("{} bytes", bytes.len()), "a whole header");
    if !bytes.starts_with(MAGIC) {
        return Err(refuse("file", "something else", "a file that begins with \\x93NUMPY"));
    }
    let (version, rest) =
        bytes.get(MAGIC.len()..).and_then(<[u8]>::split_first_chunk).ok_or_else(short)?;
    let (length, rest) = match version {
        [1, 0] => {
            let (length, rest) = rest.split_first_chunk().ok_or_else(short)?;
            (usize::from(u16::from_le_bytes(*length)), rest)
        }
        [2 | 3, 0] => {
            let (length, rest) = rest.split_first_chunk().ok_or_else(short)?;
            (u32::from_le_bytes(*length) as usize, rest)
        }
        [major, minor] => {
            return Err(refuse("version", format!("{major}.{minor}"), "1.0, 2.0 or 3.0"));
        }
    };
    if length > MAX_HEADER {
        let required = format!("at most {MAX_HEADER} bytes");
        return Err(refuse("header", format!("{length} bytes"), &required));
    }
    let (header, data) = rest.split_at_checked(length).ok_or_else(short)?;
    let text = std::str::from_utf8(header)
        .map_err(|_| refuse("header", "something that is not UTF-8", "text"))?;
    Ok((text, data))
}

struct Header {
    sample: Sample,
    fortran_order: bool,
    shape: Vec<u64>,
}

impl Header {
    /// Parses `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }`.
    fn parse(text: &str) -> Result<Self, TopographyError> {
        let wrong = || {
            let required = "{'descr': .., 'fortran_order': .., 'shape': ..} of plain numbers";
            refuse("header", format!("{:?}", text.trim_end()), required)
        };
        let inner = text.trim().strip_prefix('{').and_then(|rest| rest.strip_suffix('}'));
        let mut rest = inner.ok_or_else(wrong)?.trim();
        let (mut descr, mut fortran_order, mut shape) = (None, None, None);
        while !rest.is_empty() {
            let (key, value) = rest.split_once(':').ok_or_else(wrong)?;
            let value = value.trim_start();
            // A shape contains commas.
            let end = match value.starts_with('(') {
                true => value.find(')').ok_or_else(wrong)? + 1,
                false => value.find(',').unwrap_or(value.len()),
            };
            let (value, after) = value.split_at(end);
            let value = value.trim();
            match unquote(key.trim()) {
                Some("descr") => descr = Some(unquote(value).ok_or_else(wrong)?),
                Some("fortran_order") => fortran_order = Some(value),
                Some("shape") => shape = Some(value),
                _ => return Err(wrong()),
            }
            let after = after.trim_start();
            rest = after.strip_prefix(',').unwrap_or(after).trim_start();
        }
        let fortran_order = match fortran_order.ok_or_else(wrong)? {
            "True" => true,
            "False" => false,
            other => return Err(refuse("fortran_order", other, "True or False")),
        };
        let shape = shape.ok_or_else(wrong)?;
        let numbers = shape.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        let numbers = numbers.ok_or_else(wrong)?.split(',').map(str::trim);
        let shape = numbers
            .filter(|number| !number.is_empty())
            .map(|number| number.parse().map_err(|_| refuse("shape", shape, "whole numbers")))
            .collect::<Result<_, _>>()?;
        Ok(Self { sample: sample(descr.ok_or_else(wrong)?)?, fortran_order, shape })
    }
}

fn unquote(text: &str) -> Option<&str> {
    ['\'', '"'].iter().find_map(|quote| text.strip_prefix(*quote)?.strip_suffix(*quote))
}

fn sample(descr: &str) -> Result<Sample, TopographyError> {
    let wrong = || refuse("descr", descr, "a type such as <f8, <f4, >f8, <i2 or |u1");
    let mut letters = descr.chars();
    let big_endian = match letters.next() {
        Some('<' | '|') => false,
        Some('>') => true,
        _ => return Err(wrong()),
    };
    let kind = match letters.as_str() {
        "i1" => Kind::I8,
        "u1" => Kind::U8,
        "i2" => Kind::I16,
        "u2" => Kind::U16,
        "i4" => Kind::I32,
        "u4" => Kind::U32,
        "i8" => Kind::I64,
        "u8" => Kind::U64,
        "f4" => Kind::F32,
        "f8" => Kind::F64,
        _ => return Err(wrong()),
    };
    Ok(Sample { kind, big_endian })
}
