//! The format of a file, by its first bytes or its extension; formats without a reader are named.

use super::{gwy, npy, sdf, sur, x3p};
use crate::TopographyError;

/// A format with a reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Gwy,
    Npy,
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
    /// How a program converts it, if one does.
    advice: &'static str,
}

fn formats() -> impl Iterator<Item = Foreign> {
    let rows = include_str!("formats.csv").lines().filter(|row| !row.starts_with('#'));
    rows.filter_map(|row| {
        let cells: Vec<_> = row.split(';').collect();
        let [kind, mark, name, converter] = cells[..] else { return None };
        let advice = match converter {
            "SurfaceTopography" => SURFACE_TOPOGRAPHY,
            "numpy" => "; numpy.save(\"scan.npy\", numpy.load(\"FILE\")[name]) writes one of them",
            "Gwyddion" => "; Gwyddion reads it and saves it as .gwy",
            _ => "",
        };
        Some(Foreign { kind, mark: bytes(mark), name, advice })
    })
}

const SURFACE_TOPOGRAPHY: &str = "; SurfaceTopography (PyPI) converts it: python3 -c \"import SurfaceTopography as s; s.read_topography('FILE').to_gwy('FILE.gwy')\"";

/// The bytes of a mark, as text or, after `0x`, in hexadecimal digits.
fn bytes(mark: &str) -> Vec<u8> {
    let Some(digits) = mark.strip_prefix("0x") else { return mark.into() };
    let byte = |at: usize| u8::from_str_radix(digits.get(at..at + 2)?, 16).ok();
    (0..digits.len()).step_by(2).filter_map(byte).collect()
}

impl Format {
    /// The format of the bytes of a file called `name`.
    ///
    /// # Errors
    /// [`TopographyError::Format`] for a picture, another format without a reader, and other binary
    /// files.
    pub(super) fn of(name: &str, bytes: &[u8]) -> Result<Self, TopographyError> {
        let extension = name.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
        let extension = extension.as_deref().unwrap_or_default();
        let starts = |mark: &&[u8]| bytes.starts_with(mark);
        let read = |(.., marks): &&(_, _, &[&[u8]])| marks.iter().any(starts);
        match READ.iter().find(read) {
            Some((format, ..)) => return Ok(*format),
            None if sdf::is_sdf(bytes) => return Ok(Self::Sdf),
            None => {}
        }
        if let Some(Foreign { kind, name, advice, .. }) = foreign(extension, bytes) {
            let found = match kind {
                "picture" => format!("a picture ({name})"),
                _ => format!("in the format {name}, which has no reader here"),
            };
            return Err(TopographyError::Format { found, advice });
        }
        match READ.iter().find(|(_, name, _)| *name == extension) {
            _ if bytes.starts_with(x3p::MAGIC) => Ok(Self::X3p),
            Some((format, ..)) => Ok(*format),
            None if is_binary(bytes) => {
                let found = "binary and of unknown format".into();
                Err(TopographyError::Format { found, advice: "" })
            }
            None => Ok(Self::Text),
        }
    }
}

/// Formats with a reader, by extension and first bytes. Archives of other formats begin as X3P.
const READ: [(Format, &str, &[&[u8]]); 5] = [
    (Format::Gwy, "gwy", &[gwy::MAGIC]),
    (Format::Npy, "npy", &[npy::MAGIC]),
    (Format::Sur, "sur", &[sur::MAGIC, sur::COMPRESSED]),
    (Format::Sdf, "sdf", &[]),
    (Format::X3p, "x3p", &[]),
];

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
        let converter = |extension, bytes: &[u8]| {
            let advice = foreign(extension, bytes)?.advice;
            advice.strip_prefix("; ").and_then(|advice| advice.split(' ').next())
        };
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
