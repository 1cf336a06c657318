//! The format of a file, by its first bytes or its extension.

use super::{foreign, npy, sdf, sur, x3p};
use crate::TopographyError;

/// A format with a reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Gwy,
    Npy,
    Npz,
    Sdf,
    Sur,
    Text,
    X3p,
}

impl Format {
    /// The format of the bytes of a file called `name`.
    ///
    /// # Errors
    /// [`TopographyError::Picture`] for a picture, [`TopographyError::ForeignFormat`] with the name
    /// of another format without a reader, and [`TopographyError::UnknownFormat`] for other binary
    /// files.
    pub(super) fn of(name: &str, bytes: &[u8]) -> Result<Self, TopographyError> {
        let extension = name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
        let extension = extension.as_deref().unwrap_or_default();
        let begins = |magic: &[u8]| bytes.starts_with(magic);
        if begins(b"GWYP") {
            return Ok(Self::Gwy);
        }
        if begins(npy::MAGIC) {
            return Ok(Self::Npy);
        }
        if begins(sur::MAGIC) || begins(sur::COMPRESSED) {
            return Ok(Self::Sur);
        }
        if sdf::is_sdf(bytes) {
            return Ok(Self::Sdf);
        }
        if let Some(format) = foreign::picture(bytes) {
            return Err(TopographyError::Picture { format });
        }
        if let Some(format) = foreign::format(extension, bytes) {
            return Err(TopographyError::ForeignFormat { format });
        }
        if begins(x3p::MAGIC) {
            return Ok(if extension == "npz" { Self::Npz } else { Self::X3p });
        }
        match extension {
            "gwy" => Ok(Self::Gwy),
            "npy" => Ok(Self::Npy),
            "npz" => Ok(Self::Npz),
            "sur" => Ok(Self::Sur),
            "sdf" => Ok(Self::Sdf),
            "x3p" => Ok(Self::X3p),
            _ if foreign::is_binary(bytes) => Err(TopographyError::UnknownFormat),
            _ => Ok(Self::Text),
        }
    }
}
