//! ISO 25178-72 `.x3p`: a zip archive of `main.xml` and a file of coordinates in metres.
//!
//! The layout follows the readers of SurfaceTopography and x3pio, not the standard.

use std::io::{Cursor, ErrorKind, Read};

use zip::ZipArchive;

use super::points::grid;
use super::profile::profile;
use super::scan::{DEFLATE_RATIO, Scan, mirror_columns, mirror_rows, points};
use super::x3p_xml::{Data, Description};

use crate::error::{damaged, excerpt, refuse};
use crate::{Distance, LengthUnit, TopographyError};

pub(super) const MAGIC: &[u8] = b"PK\x03\x04";
/// The largest size of `main.xml` \[bytes\].
const MAX_XML: u64 = 1 << 20;

/// What an archive lacks that was not copied whole.
const CUT_SHORT: &str = "the list of its parts, at its end, is missing or broken, as after an incomplete copy; copy or export the file again";

type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|_| damaged("x3p", CUT_SHORT))?;
    let (folder, xml) = main_xml(&mut archive)?;
    let Description { columns, rows, increments, stored, data } = Description::parse(&xml)?;
    drop(xml);
    let n = points(columns, rows)?;
    let size: usize = stored.iter().map(|one| one.sample.size).sum();
    let mut numbers = match data {
        Data::Numbers(numbers) if numbers.len() == n * stored.len() => numbers,
        Data::Numbers(numbers) => {
            let found = format!("{} points", numbers.len() / stored.len());
            return Err(refuse("x3p DataList", found, format!("{n}, by MatrixDimension")));
        }
        Data::Entries { points, valid } => {
            let packed = (n * size).div_ceil(DEFLATE_RATIO);
            if packed > bytes.len() {
                let found = format!("{columns} x {rows} points in a file of {} bytes", bytes.len());
                let required = format!("at least {packed} bytes for these points");
                return Err(refuse("x3p MatrixDimension", found, required));
            }
            let mut numbers = Vec::with_capacity(n * stored.len());
            unpack(&mut archive, &(folder.clone() + &points), [n, size], |mut record| {
                for one in &stored {
                    let (number, rest) = record.split_at(one.sample.size);
                    numbers.push(one.sample.number(number));
                    record = rest;
                }
            })?;
            if let Some(valid) = valid {
                let mut points = numbers.chunks_mut(stored.len());
                unpack(&mut archive, &(folder + &valid), [n.div_ceil(8), 1], |byte| {
                    for (bit, point) in (0..8).zip(&mut points) {
                        if byte.iter().all(|byte| byte >> bit & 1 == 0) {
                            point.fill(f64::NAN);
                        }
                    }
                })?;
            }
            numbers
        }
    };
    for point in numbers.chunks_mut(stored.len()) {
        for (number, one) in point.iter_mut().zip(&stored) {
            // Instruments mark missing points by NaN or by infinity.
            let finite = if number.is_finite() { *number } else { f64::NAN };
            *number = finite * one.step + one.offset;
        }
    }
    let unit = Some(LengthUnit::METRE);
    if stored.len() == 3 {
        let placed = |point: &&[f64]| point.iter().take(2).all(|place| !place.is_nan());
        let placed = numbers.chunks(3).filter(placed).flatten().copied().collect();
        let (heights, columns, pixel_size) = grid(placed)?;
        return Ok(Scan::new(heights, columns, unit, pixel_size));
    }
    let [Some(dx), Some(dy)] = increments else {
        let points = numbers.chunks(2).filter(|point| point.iter().all(|number| !number.is_nan()));
        let (places, heights) = points.map(|point| (point[0], point[1])).unzip();
        let (scan, step) = profile(places, heights)?;
        return Ok(Scan { unit, pixel_size: Some([Distance::metre(step); 2]), ..scan });
    };
    let columns = columns as usize;
    if dx < 0.0 {
        mirror_columns(&mut numbers, columns);
    }
    if dy < 0.0 {
        mirror_rows(&mut numbers, columns);
    }
    Ok(Scan::new(numbers, columns, unit, [dx.abs(), dy.abs()]))
}

/// The folder of `main.xml` within the archive, and its text.
fn main_xml(archive: &mut Archive<'_>) -> Result<(String, String), TopographyError> {
    const NAME: &str = "main.xml";
    let folder = |name: &str| match name.strip_suffix(NAME) {
        Some(folder) if folder.is_empty() || folder.ends_with('/') => Some(folder.to_owned()),
        _ => None,
    };
    // Some programs pack the folder and not its content.
    let folders = archive.file_names().flatten().filter_map(|name| folder(&name));
    let folder = folders.min_by_key(String::len).unwrap_or_default();
    let entry = archive
        .by_name(&(folder.clone() + NAME))
        .map_err(|_| damaged("x3p", "it has no main.xml, which describes the scan"))?;
    let mut xml = Vec::new();
    entry.take(MAX_XML + 1).read_to_end(&mut xml).map_err(|_| damaged("x3p", broken(NAME)))?;
    if xml.len() as u64 > MAX_XML {
        return Err(refuse("x3p main.xml", "more", format!("at most {MAX_XML} bytes")));
    }
    // Some programs begin with the mark of UTF-8.
    let xml =
        String::from_utf8(xml).map_err(|_| refuse("x3p main.xml", "something else", "UTF-8"))?;
    Ok((folder, xml.trim_start_matches('\u{feff}').to_owned()))
}

/// Passes on the `n` records of an entry, of `size` bytes each. No more than these are unpacked,
/// whatever the archive declares.
fn unpack(
    archive: &mut Archive<'_>,
    name: &str,
    [n, size]: [usize; 2],
    mut with: impl FnMut(&[u8]),
) -> Result<(), TopographyError> {
    let refuse =
        |found: &str, required: &str| refuse("x3p DataLink", format!("{name}: {found}"), required);
    let mut entry = archive
        .by_name(name)
        .map_err(|_| refuse("no such part", "a part of this name in the file"))?;
    let required = format!("{} bytes, by main.xml", n * size);
    let mut buffer = [0; 1 << 13];
    let whole = buffer.len() / size * size;
    let mut left = n * size;
    while left > 0 {
        let part = &mut buffer[..left.min(whole)];
        entry.read_exact(part).map_err(|error| match error.kind() {
            ErrorKind::UnexpectedEof => refuse("fewer bytes", &required),
            _ => damaged("x3p", broken(name)),
        })?;
        part.chunks(size).for_each(&mut with);
        left -= part.len();
    }
    // Reading to the end also checks the checksum.
    match entry.read(&mut buffer) {
        Ok(0) => Ok(()),
        Ok(_) => Err(refuse("more", &required)),
        Err(_) => Err(damaged("x3p", broken(name))),
    }
}

/// What is wrong with a part that cannot be unpacked or has another checksum.
fn broken(name: &str) -> String {
    let name = excerpt(name);
    format!("the bytes of {name} are not those that were stored; copy or export the file again")
}
