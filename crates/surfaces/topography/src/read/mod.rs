//! Readers of scans, from files and bytes.

mod blocks;
mod format;
mod gwy;
mod header;
mod lines;
mod npy;
mod points;
mod profile;
mod sample;
mod scan;
mod sdf;
mod sur;
mod table;
mod words;
mod x3p;
mod x3p_xml;

use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use flate2::read::MultiGzDecoder;

pub use header::HeaderLine;
pub use scan::ReadOptions;
pub(crate) use words::{quantities, unit_meaning};

use self::blocks::{Block, blocks};
use self::format::Format;
use self::header::Header;
use self::scan::{Scan, listed, select};
use crate::error::{at_most, damaged, refuse, undecided, unknown_name};
use crate::{Topography, TopographyError};

/// The largest file that is read, and the largest content of a gzip file: 2 GiB.
pub const MAX_FILE_BYTES: u64 = 1 << 31;

/// The surface in a file.
///
/// The first bytes identify the format, the extension only where they do not. NumPy `.npy`, X3P,
/// Digital Surf SUR, Gwyddion `.gwy` and SDF are read, each also inside gzip; a file of another
/// instrument is named. All other files are text, distinguished by the number of columns:
///
/// | columns | |
/// |---|---|
/// | 1 | a profile: heights at a distance of `pixel_size` |
/// | 2 | a profile: positions and heights |
/// | 3 | points x y z of a regular grid, in any order |
/// | 4 and more | a matrix: a row of heights to a line |
///
/// Names over the columns and positions in the first row and column of a matrix go before that.
/// Text is UTF-8, Latin 1 or, with its mark at the beginning, UTF-16. Fields are separated by
/// semicolons, tabs, commas or spaces: the first of these that the first row of numbers has; they
/// may be quoted. The decimal separator is a point or, in quotes or where commas do not separate, a
/// comma. Lines before that row are a header in the words of `words.csv`: size, pixel size, numbers
/// of points, units, factor and the code of missing points; [`read_header`] shows them. `nan`,
/// `bad`, `No Data`, `***`, `--` and empty fields are missing points.
///
/// Rows and columns are in one order for all formats: x grows with the column and y with the row,
/// in the coordinates of the file. A file without coordinates begins with row 0, column 0.
///
/// # Errors
/// [`TopographyError::File`] with the path and the error, which is
/// [`Undecided`](TopographyError::Undecided) where an option must choose between readings.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Topography, TopographyError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let checked = options.check().and_then(|()| all_bytes(path));
    checked
        .and_then(|bytes| scan(&name, bytes, options)?.topography(options))
        .map_err(|error| TopographyError::File { path: path.to_owned(), source: Box::new(error) })
}

/// The surface in the bytes of a file called `name`: see [`read`].
///
/// # Errors
/// [`TopographyError`] without a path.
pub fn read_bytes(
    name: &str,
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Topography, TopographyError> {
    options.check()?;
    scan(name, bytes, options)?.topography(options)
}

/// The lines of the header of a text file, and what they are understood as; none of other formats.
///
/// # Errors
/// [`TopographyError`] as [`read_bytes`], for a file without a table of numbers.
pub fn read_header(
    name: &str,
    bytes: &[u8],
    options: &ReadOptions,
) -> Result<Vec<HeaderLine>, TopographyError> {
    let (name, bytes) = unpacked(name, bytes)?;
    match Format::of(name, &bytes)? {
        Format::Text => {
            Ok(tables(&bytes, options)?.into_iter().flat_map(|(header, _)| header.lines).collect())
        }
        _ => Ok(vec![]),
    }
}

/// Takes the bytes, so that the memory of the file is freed before the surface is measured.
fn scan(
    name: &str,
    bytes: impl AsRef<[u8]>,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    let (name, bytes) = unpacked(name, bytes.as_ref())?;
    let channel = options.channel.as_deref();
    let scan = match Format::of(name, &bytes)? {
        Format::Gwy => return gwy::scan(&bytes, channel),
        Format::Sur => return sur::scan(&bytes, channel),
        Format::Npy => npy::scan(&bytes),
        Format::X3p => x3p::scan(&bytes),
        Format::Sdf => sdf::scan(&bytes),
        Format::Text => return text_scan(&bytes, options),
    };
    let Some(channel) = channel else { return scan };
    Err(unknown_name("channel", channel, "a file with several channels (.gwy, .sur or text)"))
}

/// The surface in a text.
fn text_scan(bytes: &[u8], options: &ReadOptions) -> Result<Scan, TopographyError> {
    let mut tables = tables(bytes, options)?;
    let name = |(k, (header, _)): (usize, &(Header, Block))| match header.name() {
        Some(name) => name.to_owned(),
        None => format!("table {}", k + 1),
    };
    let names: Vec<String> = tables.iter().enumerate().map(name).collect();
    if let (None, Some((header, block))) = (&options.channel, tables.get(1)) {
        let line = header.lines.first().map_or(block.line, |first| first.line.min(block.line));
        let found = "a second table".to_owned();
        return Err(undecided(format!("line {line}"), found, "channel", &listed(&names)));
    }
    let (at, _) = select(&names, options.channel.as_deref())?;
    let (header, block) = tables.swap_remove(at);
    table::scan(block, &header, options)
}

/// The tables of a text with their headers.
fn tables(bytes: &[u8], options: &ReadOptions) -> Result<Vec<(Header, Block)>, TopographyError> {
    let mut tables = vec![];
    for block in blocks(&lines::decode(bytes)?, options)? {
        let header = Header::read(&block.header, block.delimiter);
        let blocks = match header.points()? {
            [None, None] => block.split(),
            _ => vec![block],
        };
        for block in blocks {
            tables.push((Header::read(&block.header, block.delimiter), block));
        }
    }
    Ok(tables)
}

/// The name and the content of a file that may be packed by gzip.
fn unpacked<'a>(
    name: &'a str,
    bytes: &'a [u8],
) -> Result<(&'a str, Cow<'a, [u8]>), TopographyError> {
    Ok(match bytes.starts_with(GZIP) {
        true => (name.trim_end_matches(".gz"), unpack(bytes)?.into()),
        false => (name, bytes.into()),
    })
}

fn all_bytes(path: &Path) -> Result<Vec<u8>, TopographyError> {
    let file = File::open(path)?;
    let size = file.metadata()?.len();
    let mut bytes = Vec::new();
    if size <= MAX_FILE_BYTES {
        bytes.reserve_exact(size as usize);
        // The size of devices and growing files is unreliable.
        file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes)?;
    }
    let size = size.max(bytes.len() as u64);
    at_most("the number of bytes of the file", size, MAX_FILE_BYTES)?;
    Ok(bytes)
}

/// First bytes of files packed by gzip.
const GZIP: &[u8] = b"\x1f\x8b\x08";
/// The largest ratio of unpacked to packed size: heights pack to a tenth of their size, a bomb to
/// a thousandth.
const MAX_RATIO: usize = 100;
/// Small files may have any ratio.
const SMALL: usize = 1 << 20;

/// The unpacked file.
fn unpack(packed: &[u8]) -> Result<Vec<u8>, TopographyError> {
    let limit = packed.len().saturating_mul(MAX_RATIO).max(SMALL).min(MAX_FILE_BYTES as usize);
    let mut bytes = Vec::new();
    let read = MultiGzDecoder::new(packed).take(limit as u64 + 1).read_to_end(&mut bytes);
    let cut = "it is cut short, or its bytes are not those that were packed; copy the file again";
    read.map_err(|_| damaged("gzip", cut))?;
    if bytes.len() > limit {
        let required = format!("at most {limit} bytes, {MAX_RATIO} times the packed size");
        return Err(refuse("gzip content", "more", required));
    }
    match bytes.starts_with(GZIP) {
        true => Err(refuse("gzip content", "another gzip file", "a scan; unpack the file once")),
        false => Ok(bytes),
    }
}
