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

/// First bytes and names of formats without a reader.
const FIRST_BYTES: &[(&[u8], &str)] = &[
    (b"\\*File list", "Bruker Nanoscope"),
    (b"\\*Force file list", "Bruker Nanoscope"),
    (b"?*File list", "Bruker Nanoscope"),
    (b"\x88\x1b\x03", "Zygo MetroPro (dat)"),
    (b"\x89HDF\r\n\x1a\n", "HDF5 (Zygo datx, NetCDF 4 and others)"),
    (b"\x01\x00Directory", "Wyko OPD"),
    (b"Wyko ASCII Data File Format", "Wyko ASCII"),
    (b"VCA DATA", "Bruker OPDx"),
    (b"VK3_", "Keyence VK"),
    (b"VK4_", "Keyence VK"),
    (b"VK6", "Keyence VK"),
    (b"VK7", "Keyence VK"),
    (b"KPK", "Keyence ZON"),
    (b"AliconaImaging", "Alicona al3d"),
    (b"fileType      ", "Agilent MI"),
    (b"[DataSet]\r\n", "Nanosurf nid"),
    (b"WSxM file copyright", "WSxM"),
    (b"FRTM_GLIDERV", "FRT MicroProf"),
    (b"fileformat = bcr", "BCR"),
    (b"f\0i\0l\0e\0f\0o\0r\0m\0a\0t\0", "BCR"),
    (b"Binary TrueMap Data File", "TrueMap tmd"),
    (b"CDF\x01", "NetCDF"),
    (b"CDF\x02", "NetCDF"),
    (b"MATLAB 5.0 MAT-file", "MATLAB mat"),
    (b"OLYMPUSRAWFORMAT", "Olympus oir"),
    (b"OmniSurf3D", "OmniSurf3D"),
    (b"Zeta-Instruments", "Zeta zmg"),
    (b"Zygo XYZ Data File", "Zygo ASCII"),
    (b"Zygo ASCII Data File", "Zygo ASCII"),
    (b"GWYO", "Gwyddion 1"),
    (b"GWYQ", "Gwyddion 3"),
    (b"II*\0", "TIFF (JPK, Park Systems or a picture)"),
    (b"MM\0*", "TIFF (JPK, Park Systems or a picture)"),
    (b"%PDF", "PDF"),
    (b"\xd0\xcf\x11\xe0", "OLE (MountainsMap mnt or Excel xls)"),
    (b"solid ", "STL"),
];

/// First bytes and names of formats of pictures.
const PICTURES: &[(&[u8], &str)] =
    &[(b"\x89PNG\r\n", "PNG"), (b"\xff\xd8\xff", "JPEG"), (b"BM6\0", "BMP"), (b"GIF8", "GIF")];

/// Extensions of binary files and names of formats without first bytes of their own.
const EXTENSIONS: &[(&[u8], &str)] = &[
    (b"hgt", "SRTM hgt"),
    (b"ibw", "Igor Pro ibw"),
    (b"jpk", "JPK"),
    (b"mi", "Agilent MI"),
    (b"mnt", "MountainsMap mnt"),
    (b"nms", "NanoMap nms"),
    (b"plu", "Sensofar plu"),
    (b"spm", "Bruker Nanoscope"),
    (b"stl", "STL"),
    (b"vk4", "Keyence VK"),
    (b"vk6", "Keyence VK"),
    (b"vk7", "Keyence VK"),
];

/// Entries of zip archives and names of formats.
const ENTRIES: &[(&[u8], &str)] = &[
    (b"index.xml", "Sensofar plux"),
    (b"header.properties", "JPK"),
    (b"[Content_Types].xml", "Excel xlsx"),
    (b"meta.yml", "SurfaceTopography container"),
];

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
        if let Some(format) = named(PICTURES, |magic| bytes.starts_with(magic)) {
            return Err(TopographyError::Picture { format });
        }
        if let Some(format) = foreign(extension, bytes) {
            return Err(TopographyError::ForeignFormat { format });
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

/// The name of a format without a reader. An extension alone counts for binary files only.
fn foreign(extension: &str, bytes: &[u8]) -> Option<&'static str> {
    // The directory, which lists the names, is at the end of an archive.
    let directory = bytes.get(bytes.len().saturating_sub(1 << 16)..).unwrap_or_default();
    let has = |name: &[u8]| directory.windows(name.len()).any(|part| part == name);
    let archive = || bytes.starts_with(x3p::MAGIC) && !has(b"main.xml");
    named(FIRST_BYTES, |magic| bytes.starts_with(magic))
        .or_else(|| named(ENTRIES, has).filter(|_| archive()))
        .or_else(|| named(EXTENSIONS, |end| end == extension.as_bytes() && is_binary(bytes)))
}

fn named(list: &[(&[u8], &'static str)], is: impl Fn(&[u8]) -> bool) -> Option<&'static str> {
    list.iter().find(|(mark, _)| is(mark)).map(|(_, name)| *name)
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
        assert_eq!(foreign("spm", b"\\*File list\r\n\\Version: 1"), Some("Bruker Nanoscope"));
        assert_eq!(foreign("txt", b"VK4_\x01"), Some("Keyence VK"));
        assert_eq!(foreign("ibw", b"\x05\x00\x94g"), Some("Igor Pro ibw"));
        // Text with the extension of a binary format is text.
        assert_eq!(foreign("plu", b"1 2 3 4\n"), None);
        let plux = b"PK\x03\x04 ... index.xml ... LAYER_0.raw";
        assert_eq!(foreign("plux", plux), Some("Sensofar plux"));
        assert_eq!(foreign("x3p", b"PK\x03\x04 main.xml index.xml"), None);
        assert_eq!((foreign("a", b"GIF 1 2 3"), foreign("png", b"\x89PNG\r\n")), (None, None));
        assert!(is_binary(b"\x01\x02") && !is_binary(b"a\tb\r\n") && !is_binary(b"\xff\xfea\0"));
    }
}
