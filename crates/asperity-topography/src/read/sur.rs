//! Digital Surf `.sur`, uncompressed: a header of 512 bytes, a comment, whole numbers.
//!
//! The layout follows the readers of Gwyddion and SurfaceTopography, not the specification.

use super::sample::{Kind, Sample};
use super::scan::{PixelSize, Scan, points};
use crate::error::excerpt;
use crate::{LengthUnit, TopographyError};

pub(super) const MAGIC: &[u8] = b"DIGITAL SURF";
pub(super) const COMPRESSED: &[u8] = b"DSCOMPRESSED";
const HEADER: usize = 512;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    if bytes.starts_with(COMPRESSED) {
        let required = "an uncompressed file (MountainsMap: save without compression)";
        return Err(refuse("file", "a compressed file", required));
    }
    if !bytes.starts_with(MAGIC) {
        return Err(refuse("file", "something else", "a file that begins with DIGITAL SURF"));
    }
    let Some((header, rest)) = bytes.split_first_chunk::<HEADER>() else {
        return Err(refuse("header", format!("{} bytes", bytes.len()), "512 bytes"));
    };
    let header = Header(header);
    if header.u16(12) != 0 {
        return Err(refuse("format", header.u16(12), "0: numbers with the low byte first"));
    }
    if header.u16(14) > 1 {
        return Err(refuse("number of objects", header.u16(14), "1: files of one surface"));
    }
    let object = header.u16(18);
    if !(1..=2).contains(&object) {
        return Err(refuse("object type", object, "1 (profile) or 2 (surface)"));
    }
    let kind = match header.u16(98) {
        16 => Kind::I16,
        32 => Kind::I32,
        other => return Err(refuse("bits of a point", other, "16 or 32")),
    };
    let sample = Sample { kind, big_endian: false };
    let columns = header.count(108, "number of columns")?;
    let rows = header.count(112, "number of rows")?;
    let n = points(columns, rows)?;
    let needed = n * sample.size();
    let data = rest.get(usize::from(header.u16(334)) + usize::from(header.u16(336))..);
    let Some(data) = data.and_then(|data| data.get(..needed)) else {
        let required = format!("{columns} x {rows} points, {needed} bytes after the comments");
        return Err(refuse("data", format!("{} bytes after the header", rest.len()), &required));
    };
    let step = header.f32(128, "height of one step")?;
    let unit = header.unit(212, "unit of heights")?;
    let pixel_size = [
        header.f32(120, "distance of columns")? * header.unit(180, "unit of columns")?.metres(),
        header.f32(124, "distance of rows")? * header.unit(196, "unit of rows")?.metres(),
    ];
    // Heights are inverted for 1, and inverted and mirrored for 2 and 3; mirroring does not change
    // the statistics.
    let step = if (1..=3).contains(&header.u16(290)) { -step } else { step };
    // Missing points are stored two steps below the lowest height.
    let missing = (header.u16(86) == 1).then(|| f64::from(header.i32(100)) - 2.0);
    let mut heights = Vec::with_capacity(n);
    sample.decode(data, &mut heights);
    for height in &mut heights {
        // The heights are integers: equal or at least 1 apart.
        let is_missing = missing.is_some_and(|missing| (*height - missing).abs() < 0.5);
        *height = if is_missing { f64::NAN } else { *height * step };
    }
    let pixel_size = PixelSize::Metres(pixel_size);
    Ok(Scan { heights, columns: columns as usize, unit: Some(unit), pixel_size })
}

/// The first 512 bytes, which hold every field read here.
struct Header<'a>(&'a [u8; HEADER]);

impl Header<'_> {
    fn bytes<const N: usize>(&self, at: usize) -> [u8; N] {
        std::array::from_fn(|i| self.0[at + i])
    }

    fn u16(&self, at: usize) -> u16 {
        u16::from_le_bytes(self.bytes(at))
    }

    fn i32(&self, at: usize) -> i32 {
        i32::from_le_bytes(self.bytes(at))
    }

    fn count(&self, at: usize, field: &'static str) -> Result<u64, TopographyError> {
        let found = self.i32(at);
        u64::try_from(found)
            .ok()
            .filter(|n| *n > 0)
            .ok_or_else(|| refuse(field, found, "at least 1"))
    }

    fn f32(&self, at: usize, field: &'static str) -> Result<f64, TopographyError> {
        let found = f32::from_le_bytes(self.bytes(at));
        if found.is_finite() && found > 0.0 {
            Ok(f64::from(found))
        } else {
            Err(refuse(field, found, "a finite number above 0"))
        }
    }

    fn unit(&self, at: usize, field: &'static str) -> Result<LengthUnit, TopographyError> {
        let latin: String = self.bytes::<16>(at).iter().map(|byte| char::from(*byte)).collect();
        let name = latin.trim_end_matches(['\0', ' ']);
        // Old files have the MS-DOS code of µ, which is æ in Latin 1.
        let name = if name == "\u{e6}m" { "um" } else { name };
        name.parse().map_err(|_| refuse(field, format!("{name:?}"), "a unit of length"))
    }
}

fn refuse(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    let (found, required) = (excerpt(&found.to_string()), required.to_owned());
    TopographyError::Field { format: "sur", field, found, required }
}
