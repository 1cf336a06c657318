//! Files and bytes to surfaces.

use std::path::Path;

use crate::{LengthUnit, Topography, TopographyError};

/// The largest file that is read: 2 GiB.
pub const MAX_FILE_BYTES: u64 = 1 << 31;

/// What a file may leave open.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Unit of the heights, and of `pixel_size` where that is given. A file that states its unit
    /// must agree.
    pub unit: Option<LengthUnit>,
    /// Distance of neighbouring points along a row and along a column, in `unit` (in the unit the
    /// file states for its heights where `unit` is not given). A file that states it must agree.
    pub pixel_size: Option<[f64; 2]>,
    /// The largest share of missing points that is accepted, 0 to 1; 0.1 by default.
    pub max_missing: f64,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self { unit: None, pixel_size: None, max_missing: 0.1 }
    }
}

/// The surface in a file. Its format is told by its first bytes; text by its number of columns.
///
/// # Errors
/// [`TopographyError::File`] with the path and what was wrong.
pub fn read(path: &Path, _options: &ReadOptions) -> Result<Topography, TopographyError> {
    let source = Box::new(TopographyError::UnknownFormat);
    Err(TopographyError::File { path: path.to_owned(), source })
}

/// The surface in the bytes of a file called `name`.
///
/// # Errors
/// [`TopographyError`] with what was wrong.
pub fn read_bytes(
    _name: &str,
    _bytes: &[u8],
    _options: &ReadOptions,
) -> Result<Topography, TopographyError> {
    Err(TopographyError::UnknownFormat)
}
