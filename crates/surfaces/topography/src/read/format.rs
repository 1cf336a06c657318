//! The format of a file, by its first bytes or its extension; formats without a reader are named.

use super::{npy, sdf, sur, x3p};
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

/// A format without a reader, in a row of `formats.csv`.
struct Foreign {
    /// `extension`, `first`, `entry` or `picture`.
    kind: &'static str,
    mark: Vec<u8>,
    name: &'static str,
    converter: Option<&'static str>,
}

fn formats() -> impl Iterator<Item = Foreign> {
    let rows = include_str!("formats.csv").lines().filter(|row| !row.starts_with('#'));
    rows.filter_map(|row| {
        let cells: Vec<_> = row.split(';').collect();
        let [kind, mark, name, converter] = cells[..] else { return None };
        let converter = Some(converter).filter(|converter| !converter.is_empty());
        Some(Foreign { kind, mark: unescaped(mark), name, converter })
    })
}

/// The bytes of a mark with `\\xff`, `\\r`, `\\n` and `\\\\`.
fn unescaped(mark: &str) -> Vec<u8> {
    let (mut bytes, mut rest) = (vec![], mark.as_bytes());
    while let [first, tail @ ..] = rest {
        let (byte, length) = match (first, tail) {
            (b'\\', [b'x', digits @ ..]) => {
                let digits = digits.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
                (digits.and_then(|digits| u8::from_str_radix(digits, 16).ok()).unwrap_or(0), 4)
            }
            (b'\\', [b'r', ..]) => (b'\r', 2),
            (b'\\', [b'n', ..]) => (b'\n', 2),
            (b'\\', [other, ..]) => (*other, 2),
            (byte, _) => (*byte, 1),
        };
        bytes.push(byte);
        rest = rest.get(length..).unwrap_or_default();
    }
    bytes
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
        match bytes {
            _ if bytes.starts_with(b"GWYP") => return Ok(Self::Gwy),
            _ if bytes.starts_with(npy::MAGIC) => return Ok(Self::Npy),
            _ if bytes.starts_with(sur::MAGIC) => return Ok(Self::Sur),
            _ if bytes.starts_with(sur::COMPRESSED) => return Ok(Self::Sur),
            _ if sdf::is_sdf(bytes) => return Ok(Self::Sdf),
            _ => {}
        }
        match foreign(extension, bytes) {
            Some(Foreign { kind: "picture", name: format, .. }) => {
                return Err(TopographyError::Picture { format });
            }
            Some(Foreign { name: format, converter, .. }) => {
                return Err(TopographyError::ForeignFormat { format, converter });
            }
            None => {}
        }
        match extension {
            "npz" => Ok(Self::Npz),
            _ if bytes.starts_with(x3p::MAGIC) => Ok(Self::X3p),
            "gwy" => Ok(Self::Gwy),
            "npy" => Ok(Self::Npy),
            "sur" => Ok(Self::Sur),
            "sdf" => Ok(Self::Sdf),
            "x3p" => Ok(Self::X3p),
            _ if is_binary(bytes) => Err(TopographyError::UnknownFormat),
            _ => Ok(Self::Text),
        }
    }
}

/// The format of a file if it has no reader. An extension alone counts for binary files only.
fn foreign(extension: &str, bytes: &[u8]) -> Option<Foreign> {
    // The directory, which lists the names, is at the end of an archive.
    let directory = bytes.get(bytes.len().saturating_sub(1 << 16)..).unwrap_or_default();
    let has = |name: &[u8]| directory.windows(name.len()).any(|part| part == name);
    let archive = bytes.starts_with(x3p::MAGIC) && !has(b"main.xml");
    formats().find(|Foreign { kind, mark, .. }| match *kind {
        "extension" => mark == extension.as_bytes() && is_binary(bytes),
        "entry" => archive && has(mark),
        _ => bytes.starts_with(mark),
    })
}

/// Whether a file has bytes that no text has.
fn is_binary(bytes: &[u8]) -> bool {
    let utf16 = [&b"\xff\xfe"[..], b"\xfe\xff"].iter().any(|mark| bytes.starts_with(mark));
    // A form feed or an escape may stand in text; 0x1a ends text of MS-DOS.
    let control = |byte: &u8| matches!(byte, 1..=8 | 14..=25 | 28..=31);
    !utf16 && (bytes.contains(&0) || bytes.iter().take(4096).any(control))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_named_by_their_first_bytes_or_extension() {
        let found = |extension, bytes: &[u8]| foreign(extension, bytes).map(|format| format.name);
        assert_eq!(found("spm", b"\\*File list\r\n\\Version: 1"), Some("Bruker Nanoscope"));
        assert_eq!(found("txt", b"VK4_\x01"), Some("Keyence VK"));
        assert_eq!(found("ibw", b"\x05\x00\x94g"), Some("Igor Pro ibw"));
        // Text with the extension of a binary format is text.
        assert_eq!(found("plu", b"1 2 3 4\n"), None);
        let plux = b"PK\x03\x04 ... index.xml ... LAYER_0.raw";
        assert_eq!(found("plux", plux), Some("Sensofar plux"));
        assert_eq!(found("x3p", b"PK\x03\x04 main.xml index.xml"), None);
        assert_eq!((found("a", b"GIF 1 2 3"), found("a", b"\x89PNG\r\n")), (None, Some("PNG")));
        assert!(is_binary(b"\x01\x02") && !is_binary(b"a\tb\r\n") && !is_binary(b"\xff\xfea\0"));
    }

    #[test]
    fn converters_are_named_for_what_they_read() {
        let converter =
            |extension, bytes: &[u8]| foreign(extension, bytes).and_then(|format| format.converter);
        for (extension, bytes, name) in [
            ("a", &b"VK4_"[..], Some("SurfaceTopography")),
            ("datx", b"\x89HDF\r\n\x1a\n\0", Some("SurfaceTopography")),
            ("h5", b"\x89HDF\r\n\x1a\n\0", None),
            ("stl", b"solid cube", None),
            ("stl", b"\0\0\0", None),
            ("bz2", b"BZh9", None),
            ("xlsx", b"PK\x03\x04 [Content_Types].xml", None),
            ("dat", b"Zygo ASCII Data File", Some("Gwyddion")),
        ] {
            assert_eq!(converter(extension, bytes), name, "{extension}");
        }
    }
}
