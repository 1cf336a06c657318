//! ISO 25178-71 `.sdf`, text and binary, versions ISO-1.0, ISO-2.0 and BCR-1.0.
//!
//! The layout follows the readers of Gwyddion, surfalize and sdfio, not the standard.

use super::refusal::sdf as refuse;
use super::sample::{Kind, Sample};
use super::scan::{PixelSize, Scan, points};
use super::sdf_ascii;
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

/// The fields of a header. Lengths are in m.
pub(super) struct Header {
    pub(super) columns: u64,
    pub(super) rows: u64,
    pub(super) scales: [f64; 3],
    /// Compression and checksum, which are not read.
    pub(super) packing: [u8; 2],
    pub(super) data_type: u8,
    /// Whether the largest number of the type marks missing points, as in BCR-1.0. In ISO it is
    /// the smallest.
    pub(super) largest_is_missing: bool,
}

impl Header {
    /// The number of points.
    pub(super) fn points(&self) -> Result<usize, TopographyError> {
        for (packing, field) in self.packing.into_iter().zip(["Compression", "CheckType"]) {
            if packing != 0 {
                return Err(refuse(field, packing, "0: none"));
            }
        }
        for (n, field) in [(self.columns, "NumPoints"), (self.rows, "NumProfiles")] {
            if n == 0 {
                return Err(refuse(field, n, "at least 1"));
            }
        }
        points(self.columns, self.rows)
    }

    pub(super) fn sample(&self) -> Result<Sample, TopographyError> {
        let kind = match self.data_type {
            0 => Kind::U8,
            1 => Kind::U16,
            2 => Kind::U32,
            3 => Kind::F32,
            4 => Kind::I8,
            5 => Kind::I16,
            6 => Kind::I32,
            7 => Kind::F64,
            other => return Err(refuse("DataType", other, "0 to 7")),
        };
        Ok(Sample { kind, big_endian: false })
    }

    /// NaN for numbers that mark missing points.
    pub(super) fn mark(&self, heights: &mut [f64]) -> Result<(), TopographyError> {
        let (least, largest) = match self.sample()?.kind {
            Kind::U8 => (-1.0, 255.0),
            Kind::U16 => (-1.0, 65_535.0),
            Kind::U32 => (-1.0, 4_294_967_295.0),
            Kind::I8 => (-128.0, 127.0),
            Kind::I16 => (-32_768.0, 32_767.0),
            Kind::I32 => (-2_147_483_648.0, 2_147_483_647.0),
            // Files print the limit with few digits.
            Kind::F32 => (-3.4e38, 3.4e38),
            _ => (-1.7e308, 1.7e308),
        };
        let missing = |height: f64| match self.largest_is_missing {
            true => height >= largest,
            false => height <= least,
        };
        for height in heights.iter_mut().filter(|height| missing(**height)) {
            *height = f64::NAN;
        }
        Ok(())
    }

    fn pixel_size(&self) -> Result<[f64; 2], TopographyError> {
        let [x, y, _] = self.scales;
        let dx = positive("Xscale", x)?;
        // A profile has no distance of rows.
        Ok([dx, if self.rows == 1 { dx } else { positive("Yscale", y)? }])
    }

    fn height_scale(&self) -> Result<f64, TopographyError> {
        positive("Zscale", self.scales[2])
    }
}

fn positive(field: &'static str, value: f64) -> Result<f64, TopographyError> {
    let fits = value.is_finite() && value > 0.0;
    if fits { Ok(value) } else { Err(refuse(field, value, "a finite number above 0")) }
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
