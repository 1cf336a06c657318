//! Digital Surf `.sur` and `.pro`: objects, each with a header of 512 bytes, a comment, a private
//! zone and whole numbers.
//!
//! The layout follows the readers of Gwyddion, surfalize and RosettaSciIO, not the specification.

use std::borrow::Cow;
use std::io::Read;

use asperity_core::{Code, Finding};
use flate2::read::ZlibDecoder;

use super::lines::text;
use super::sample::{Bytes, Sample};
use super::scan::{DEFLATE_RATIO, Scan, mirror_columns, mirror_rows, points, positive, select};
use crate::error::{damaged, refuse};
use crate::{LengthUnit, TopographyError};

pub(super) const MAGIC: &[u8] = b"DIGITAL SURF";
pub(super) const COMPRESSED: &[u8] = b"DSCOMPRESSED";
const HEADER: usize = 512;
/// Types of objects that begin with a profile or a surface of heights.
const WITH_HEIGHTS: [u16; 9] = [1, 2, 4, 5, 7, 8, 11, 13, 16];

pub(super) fn scan(bytes: &[u8], channel: Option<&str>) -> Result<Scan, TopographyError> {
    let (first, mut rest) = Object::read(bytes)?;
    let (kind, declared) = (first.header.u16(18), first.count());
    if !WITH_HEIGHTS.contains(&kind) {
        let required =
            "a profile (1) or a surface (2), or several of them (4, 5, 7, 8, 11, 13, 16)";
        return Err(refuse("sur object type", kind, required));
    }
    let mut objects = vec![first];
    while objects.len() < declared {
        if rest.is_empty() {
            let found = format!("{} of {declared}", objects.len());
            let required = "all objects that the header declares";
            return Err(refuse("sur number of objects", found, required));
        }
        let (next, after) = Object::read(rest)?;
        objects.push(next);
        rest = after;
    }
    // Pictures beside a surface are no heights.
    let unit = |object: &Object<'_>| object.header.unit(212, "unit of heights");
    let refused = objects.first().map(unit).transpose().map(drop);
    objects.retain(|object| unit(object).is_ok());
    if objects.is_empty() {
        refused?;
    }
    let n = objects.len();
    let name = |(i, object): (usize, &Object<'_>)| match object.header.text(20, 30) {
        name if name.is_empty() => format!("surface {} of {n}", i + 1),
        name => name,
    };
    let names: Vec<_> = objects.iter().enumerate().map(name).collect();
    let (at, note) = select(&names, channel)?;
    objects.swap_remove(at).scan(note)
}

/// An object of a file.
struct Object<'a> {
    header: Header<'a>,
    columns: usize,
    /// Points, columns times rows.
    points: usize,
    sample: Sample,
    packed: bool,
    data: &'a [u8],
}

impl<'a> Object<'a> {
    /// The object at the beginning, and the bytes after it.
    fn read(bytes: &'a [u8]) -> Result<(Self, &'a [u8]), TopographyError> {
        let packed = bytes.starts_with(COMPRESSED);
        if !packed && !bytes.starts_with(MAGIC) {
            let reason = "it does not begin with DIGITAL SURF or DSCOMPRESSED";
            return Err(damaged("sur", reason));
        }
        let Some((header, rest)) = bytes.split_first_chunk::<HEADER>() else {
            return Err(damaged("sur", "its header is not whole"));
        };
        let header = Header(header);
        if header.u16(12) != 0 {
            return Err(damaged("sur", "its header does not give the order of bytes"));
        }
        let sample = match header.u16(98) {
            16 => Sample::new(*b"i2"),
            32 => Sample::new(*b"i4"),
            other => return Err(refuse("sur bits of a point", other, "16 or 32")),
        };
        let columns = positive("sur number of columns", header.i32(108))? as u64;
        let rows = positive("sur number of rows", header.i32(112))? as u64;
        let points = points(columns, rows)?;
        let size = if packed { header.i32(324) as u32 as usize } else { points * sample.size };
        let before = usize::from(header.u16(334)) + usize::from(header.u16(336));
        let data = rest.get(before..).and_then(|rest| rest.split_at_checked(size));
        let Some((data, after)) = data else {
            let required = format!("{columns} x {rows} points, {size} bytes after the comments");
            let found = format!("{} bytes after the header", rest.len());
            return Err(refuse("sur data", found, required));
        };
        let columns = columns as usize;
        Ok((Self { header, columns, points, sample, packed, data }, after))
    }

    /// Objects in the file: of each the channels.
    fn count(&self) -> usize {
        let of = |at| usize::from(self.header.u16(at).max(1));
        // Old files have a code of the material in place of the number of channels.
        match self.header.u16(18) {
            1 | 2 => of(14),
            _ => of(14) * of(80),
        }
    }

    fn scan(&self, note: Option<Finding>) -> Result<Scan, TopographyError> {
        let Self { header, columns, points, sample, .. } = self;
        let step = header.f32(128, "height of one step")?;
        let unit = header.unit(212, "unit of heights")?;
        let dx = header.f32(120, "distance of columns")?;
        let pixel = dx * header.unit(180, "unit of columns")?.metres();
        let pixel_size = match (points / columns, header.f32(124, "distance of rows")) {
            // A profile has no distance of rows.
            (1, _) => [pixel; 2],
            (_, dy) => [pixel, dy? * header.unit(196, "unit of rows")?.metres()],
        };
        let data = match self.packed {
            true => Cow::from(unpack(self.data, points * sample.size)?),
            false => Cow::from(self.data),
        };
        let mut heights = sample.decode(&data);
        drop(data);
        // Missing points are stored two steps below the lowest height.
        let missing = (header.u16(86) == 1).then(|| f64::from(header.i32(100)) - 2.0);
        let inversion = header.u16(290);
        let step = if (1..=3).contains(&inversion) { -step } else { step };
        for height in &mut heights {
            // The heights are integers: equal or at least 1 apart.
            let is_missing = missing.is_some_and(|missing| (*height - missing).abs() < 0.5);
            *height = if is_missing { f64::NAN } else { *height * step };
        }
        match inversion {
            2 => mirror_columns(&mut heights, *columns),
            3 => mirror_rows(&mut heights, *columns),
            _ => {}
        }
        let mut notes: Vec<_> = note.into_iter().collect();
        notes.extend((step < 0.0).then(|| {
            Finding::note(Code::Inverted, "inversion", f64::from(inversion))
                .fact("the file marks its heights as inverted, and they are turned over")
                .advice("check the sign of the skewness, because programs differ here")
        }));
        Ok(Scan { notes, ..Scan::new(heights, *columns, Some(unit), pixel_size) })
    }
}

/// The first 512 bytes, which hold every field read here.
struct Header<'a>(&'a [u8; HEADER]);

impl Header<'_> {
    fn number(&self, at: usize, name: [u8; 2]) -> f64 {
        Bytes(&self.0[at..]).number(name).unwrap_or_default()
    }

    fn u16(&self, at: usize) -> u16 {
        self.number(at, *b"u2") as u16
    }

    fn i32(&self, at: usize) -> i32 {
        self.number(at, *b"i4") as i32
    }

    fn f32(&self, at: usize, field: &'static str) -> Result<f64, TopographyError> {
        positive(format!("sur {field}"), self.number(at, *b"f4"))
    }

    /// Text of a fixed length, in UTF-8 or Latin 1, filled up with zeros or spaces.
    fn text(&self, at: usize, length: usize) -> String {
        let bytes = self.0[at..at + length].split(|byte| *byte == 0).next().unwrap_or_default();
        text(bytes).trim().to_owned()
    }

    fn unit(&self, at: usize, field: &'static str) -> Result<LengthUnit, TopographyError> {
        let name = self.text(at, 16);
        // Old files have the MS-DOS code of µ, which is æ in Latin 1.
        let symbol = if name == "\u{e6}m" { "um" } else { &name };
        symbol
            .parse()
            .map_err(|_| refuse(format!("sur {field}"), format!("{name:?}"), "a unit of length"))
    }
}

/// The unpacked data of exactly `size` bytes: the number of streams, their sizes, the streams.
fn unpack(data: &[u8], size: usize) -> Result<Vec<u8>, TopographyError> {
    let whole = || {
        let mut streams = Bytes(data);
        let count = streams.count()?;
        let mut sizes = Bytes(streams.take(count.checked_mul(8)?)?);
        let mut unpacked = Vec::with_capacity(size);
        for _ in 0..count {
            let (plain, packed) = (sizes.count()?, sizes.count()?);
            let end = unpacked.len().checked_add(plain).filter(|end| *end <= size)?;
            // One byte more tells whether the stream ends there, and checks its checksum.
            let mut decoder = ZlibDecoder::new(streams.take(packed)?).take(plain as u64 + 1);
            decoder.read_to_end(&mut unpacked).ok().filter(|_| unpacked.len() == end)?;
        }
        Some(unpacked).filter(|unpacked| unpacked.len() == size)
    };
    let reason = "its compressed data are not those of the points in its header; copy or export the file again";
    // A short file cannot hold so many points, and none are reserved.
    let found = if size / DEFLATE_RATIO > data.len() { None } else { whole() };
    found.ok_or_else(|| damaged("sur", reason))
}
