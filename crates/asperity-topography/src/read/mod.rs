//! Readers of scans, from files and bytes.

mod npy;
mod options;
mod points;
mod sample;
mod scan;
mod sur;
mod table;
mod text;
mod x3p;

use std::fs::File;
use std::io::Read;
use std::path::Path;

pub use options::ReadOptions;

use crate::{Topography, TopographyError};

/// The largest file that is read: 2 GiB.
pub const MAX_FILE_BYTES: u64 = 1 << 31;

/// The surface in a file.
/// The extension or the first bytes identify NumPy, X3P and SUR files; other files are text,
/// distinguished by the number of columns:
///
/// | columns | |
/// |---|---|
/// | 1 | a profile: heights at a distance of `pixel_size` |
/// | 2 | a profile: equidistant positions and heights |
/// | 3 | points x y z of a regular grid, in any order |
/// | 4 and more | a matrix: a row of heights to a line |
///
/// Columns are separated by semicolons, tabs, commas or spaces: the first of these that the first
/// row of numbers has. The decimal separator is a point. Lines before that row are a header. It may
/// name units over the columns (`x [mm], z [µm]` or `x_mm, z_um`), and for a matrix the size
/// (`Width: 10 µm`, `Height: 10 µm`: n pixels of 10/n µm) and the unit of the heights (`Value
/// units: nm`). `nan`, `bad`, `***`, `--` and empty fields are missing points.
///
/// # Errors
/// [`TopographyError::File`] with the path and the error.
pub fn read(path: &Path, options: &ReadOptions) -> Result<Topography, TopographyError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let checked = options.check().and_then(|()| all_bytes(path));
    checked
        .and_then(|bytes| scan(&name, bytes)?.topography(options))
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
    scan(name, bytes)?.topography(options)
}

/// Takes the bytes, so that the memory of the file is freed before the surface is measured.
fn scan(name: &str, bytes: impl AsRef<[u8]>) -> Result<scan::Scan, TopographyError> {
    let bytes = bytes.as_ref();
    let extension = name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
    match extension.as_deref() {
        Some("npy") => npy::scan(bytes),
        Some("npz") => Err(npy::archive(bytes)),
        Some("x3p") => x3p::scan(bytes),
        Some("sur") => sur::scan(bytes),
        _ if bytes.starts_with(npy::MAGIC) => npy::scan(bytes),
        _ if bytes.starts_with(x3p::MAGIC) => x3p::scan(bytes),
        _ if bytes.starts_with(sur::MAGIC) || bytes.starts_with(sur::COMPRESSED) => {
            sur::scan(bytes)
        }
        _ => text::scan(bytes),
    }
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
    if size > MAX_FILE_BYTES {
        let what = "the number of bytes of the file";
        return Err(TopographyError::TooLarge { what, size, limit: MAX_FILE_BYTES });
    }
    Ok(bytes)
}
