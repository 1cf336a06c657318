//! Formats of instruments without a reader, which are named.

/// First bytes and names of formats.
const FIRST_BYTES: &[(&[u8], &str)] = &[
    (b"\\*File list", "Bruker Nanoscope"),
    (b"\\*Force file list", "Bruker Nanoscope"),
    (b"?*File list", "Bruker Nanoscope"),
    (b"\x88\x1b\x03\x6f", "Zygo MetroPro (dat)"),
    (b"\x88\x1b\x03\x70", "Zygo MetroPro (dat)"),
    (b"\x88\x1b\x03\x71", "Zygo MetroPro (dat)"),
    (b"\x89HDF\r\n\x1a\n", "HDF5 (Zygo datx, NetCDF 4 and others)"),
    (b"\x01\x00Directory", "Wyko OPD"),
    (b"Wyko ASCII Data File Format", "Wyko ASCII"),
    (b"VCA DATA", "Bruker OPDx"),
    (b"VK3_", "Keyence VK"),
    (b"VK4_", "Keyence VK"),
    (b"VK6", "Keyence VK"),
    (b"VK7", "Keyence VK"),
    (b"KPK0", "Keyence ZON"),
    (b"KPK1", "Keyence ZON"),
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
const PICTURES: &[(&[u8], &str)] = &[
    (b"\x89PNG\r\n", "PNG"),
    (b"\xff\xd8\xff", "JPEG"),
    (b"BM6\0", "BMP"),
    (b"GIF87a", "GIF"),
    (b"GIF89a", "GIF"),
];

/// Extensions and names of formats without first bytes of their own.
const EXTENSIONS: &[(&str, &str)] = &[
    ("hgt", "SRTM hgt"),
    ("ibw", "Igor Pro ibw"),
    ("jpk", "JPK"),
    ("mi", "Agilent MI"),
    ("mnt", "MountainsMap mnt"),
    ("nms", "NanoMap nms"),
    ("plu", "Sensofar plu"),
    ("spm", "Bruker Nanoscope"),
    ("stl", "STL"),
    ("vk4", "Keyence VK"),
    ("vk6", "Keyence VK"),
    ("vk7", "Keyence VK"),
];

/// Entries of zip archives and names of formats.
const ENTRIES: &[(&[u8], &str)] = &[
    (b"index.xml", "Sensofar plux"),
    (b"header.properties", "JPK"),
    (b"[Content_Types].xml", "Excel xlsx"),
    (b"meta.yml", "SurfaceTopography container"),
];

/// The name of the format of a picture.
pub(super) fn picture(bytes: &[u8]) -> Option<&'static str> {
    PICTURES.iter().find(|(magic, _)| bytes.starts_with(magic)).map(|(_, name)| *name)
}

/// The name of a format without a reader. An extension alone counts for binary files only.
pub(super) fn format(extension: &str, bytes: &[u8]) -> Option<&'static str> {
    let first = FIRST_BYTES.iter().find(|(magic, _)| bytes.starts_with(magic));
    let packed = || {
        let archive = bytes.starts_with(super::x3p::MAGIC);
        // The directory, which lists the names, is at the end of an archive.
        let directory = bytes.get(bytes.len().saturating_sub(1 << 16)..).unwrap_or_default();
        let entry = |name: &&[u8]| directory.windows(name.len()).any(|part| part == *name);
        ENTRIES
            .iter()
            .filter(|_| archive && !entry(&&b"main.xml"[..]))
            .find(|(name, _)| entry(name))
    };
    let by_extension = || EXTENSIONS.iter().find(|(end, _)| *end == extension && is_binary(bytes));
    let name = |found: Option<&(&[u8], &'static str)>| found.map(|(_, name)| *name);
    name(first).or_else(|| name(packed())).or_else(|| by_extension().map(|(_, name)| *name))
}

/// Whether a file has bytes that no text has.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
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
        assert_eq!(format("spm", b"\\*File list\r\n\\Version: 1"), Some("Bruker Nanoscope"));
        assert_eq!(format("txt", b"VK4_\x01"), Some("Keyence VK"));
        assert_eq!(format("ibw", b"\x05\x00\x94g"), Some("Igor Pro ibw"));
        // Text with the extension of a binary format is text.
        assert_eq!(format("plu", b"1 2 3 4\n"), None);
        let plux = b"PK\x03\x04 ... index.xml ... LAYER_0.raw";
        assert_eq!(format("plux", plux), Some("Sensofar plux"));
        assert_eq!(format("x3p", b"PK\x03\x04 main.xml index.xml"), None);
        assert_eq!(picture(b"\xff\xd8\xff\xe0"), Some("JPEG"));
        assert_eq!((picture(b"GIF 1 2 3"), format("png", b"\x89PNG\r\n")), (None, None));
        assert!(is_binary(b"\x01\x02") && !is_binary(b"a\tb\r\n") && !is_binary(b"\xff\xfea\0"));
    }
}
