//! NumPy `.npy`, versions 1 to 3: a header as a Python literal, then plain numbers.
//!
//! The header is parsed here because crates for it multiply declared shapes and allocate before
//! checking against the file, and accept nested brackets of any depth.

use super::sample::{Bytes, Sample};
use super::scan::{Scan, points};
use crate::TopographyError;
use crate::error::{damaged, refuse};
use crate::topography::transposed;

pub(super) const MAGIC: &[u8] = b"\x93NUMPY";
/// The limit of NumPy itself.
const MAX_HEADER: usize = 10_000;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let (header, data) = parts(bytes)?;
    let Header { sample, fortran_order, shape } = Header::parse(header)?;
    let (rows, columns) = match shape[..] {
        [n] => (1, n),
        [rows, columns] => (rows, columns),
        _ => return Err(refuse("npy shape", format!("{shape:?}"), "(n,) or (rows, columns)")),
    };
    let n = points(columns, rows)?;
    // Both factors are limited above.
    let needed = n * sample.size;
    if data.len() != needed {
        let required = format!("{needed}, by the shape and the type");
        return Err(refuse("npy data", format!("{} bytes", data.len()), required));
    }
    let mut heights = sample.decode(data);
    let (rows, columns) = (rows as usize, columns as usize);
    if fortran_order && rows > 1 {
        // The file stores the heights column by column.
        heights = transposed(&heights, rows);
    }
    Ok(Scan { heights, columns, ..Scan::default() })
}

/// Header text and data.
fn parts(bytes: &[u8]) -> Result<(&str, &[u8]), TopographyError> {
    let short = || damaged("npy", "its header is not whole");
    let Some(rest) = bytes.strip_prefix(MAGIC) else {
        return Err(damaged("npy", "it does not begin with \\x93NUMPY"));
    };
    let mut rest = Bytes(rest);
    let size = match rest.take(2).ok_or_else(short)? {
        [1, 0] => *b"u2",
        [2 | 3, 0] => *b"u4",
        other => return Err(refuse("npy version", format!("{other:?}"), "1.0, 2.0 or 3.0")),
    };
    let length = rest.number(size).ok_or_else(short)? as usize;
    if length > MAX_HEADER {
        let required = format!("at most {MAX_HEADER} bytes");
        return Err(refuse("npy header", format!("{length} bytes"), required));
    }
    let header = rest.take(length).ok_or_else(short)?;
    let text = std::str::from_utf8(header);
    Ok((text.map_err(|_| damaged("npy", "its header is not text"))?, rest.0))
}

struct Header {
    sample: Sample,
    fortran_order: bool,
    shape: Vec<u64>,
}

impl Header {
    /// Parses `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }`.
    fn parse(text: &str) -> Result<Self, TopographyError> {
        // The value between two marks after its key.
        let value = |key: &str, open: &str, close: &str| {
            let (_, value) = text.split_once(key)?;
            let (value, _) = value.trim_start().strip_prefix(open)?.split_once(close)?;
            Some(value.trim())
        };
        let descr = value("'descr':", "'", "'");
        let order = value("'fortran_order':", "", ",");
        let (Some(descr), Some(order), Some(shape)) = (descr, order, value("'shape':", "(", ")"))
        else {
            let required = "{'descr': .., 'fortran_order': .., 'shape': ..} of plain numbers";
            return Err(refuse("npy header", format!("{:?}", text.trim_end()), required));
        };
        let required = "a type such as <f8, <f4, >f8, <i2 or |u1";
        let sample = Sample::numpy(descr).ok_or_else(|| refuse("npy descr", descr, required))?;
        let fortran_order = match order {
            "True" => true,
            "False" => false,
            other => return Err(refuse("npy fortran_order", other, "True or False")),
        };
        let numbers = shape.split(',').map(str::trim).filter(|number| !number.is_empty());
        let numbers: Result<_, _> = numbers.map(str::parse).collect();
        let wrong = |_| refuse("npy shape", format!("({shape})"), "whole numbers");
        Ok(Self { sample, fortran_order, shape: numbers.map_err(wrong)? })
    }
}
