//! Writers of small binary files for the tests of the readers.

#![allow(clippy::unwrap_used, dead_code, reason = "writers for tests; each test uses some")]

use std::io::{Cursor, Write};

use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use zip::write::SimpleFileOptions;

/// A Digital Surf file of 5 columns and 4 rows.
pub struct Sur {
    pub bits: u16,
    pub unit: &'static [u8],
    pub inversion: u16,
    /// Lowest height, for files with missing points.
    pub lowest: Option<i32>,
    pub comment: u16,
    pub size: [i32; 2],
    /// Streams of compressed data; 0 for none.
    pub streams: usize,
    pub kind: u16,
    /// Objects that the header declares.
    pub objects: u16,
    pub name: &'static str,
}

impl Default for Sur {
    fn default() -> Self {
        Self {
            bits: 32,
            unit: b"um",
            inversion: 0,
            lowest: None,
            comment: 0,
            size: [5, 4],
            streams: 0,
            kind: 2,
            objects: 1,
            name: "",
        }
    }
}

impl Sur {
    /// The file with these heights in steps of an eighth of the unit; points are 5 and 2.5 units
    /// apart.
    pub fn bytes(&self, heights: &[f64]) -> Vec<u8> {
        let mut header = vec![0; 512];
        let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
        put(0, if self.streams > 0 { b"DSCOMPRESSED" } else { b"DIGITAL SURF" });
        put(14, &self.objects.to_le_bytes());
        put(18, &self.kind.to_le_bytes());
        put(20, self.name.as_bytes());
        put(86, &u16::from(self.lowest.is_some()).to_le_bytes());
        put(98, &self.bits.to_le_bytes());
        put(100, &self.lowest.unwrap_or_default().to_le_bytes());
        put(108, &self.size[0].to_le_bytes());
        put(112, &self.size[1].to_le_bytes());
        put(120, &5f32.to_le_bytes());
        put(124, &2.5f32.to_le_bytes());
        put(128, &0.125f32.to_le_bytes());
        for at in [180, 196, 212] {
            put(at, &[b' '; 16]);
            put(at, self.unit);
        }
        put(290, &self.inversion.to_le_bytes());
        put(334, &self.comment.to_le_bytes());
        let mut data = Vec::new();
        for height in heights {
            match self.bits {
                16 => data.extend((*height as i16).to_le_bytes()),
                _ => data.extend((*height as i32).to_le_bytes()),
            }
        }
        if self.streams > 0 {
            data = self.compressed(&data);
            header[324..328].copy_from_slice(&(data.len() as u32).to_le_bytes());
        }
        header.extend(std::iter::repeat_n(b'!', usize::from(self.comment)));
        header.extend(data);
        header
    }

    fn compressed(&self, data: &[u8]) -> Vec<u8> {
        let parts: Vec<_> = data.chunks(data.len().div_ceil(self.streams).max(1)).collect();
        let mut table = (parts.len() as u32).to_le_bytes().to_vec();
        let mut streams = Vec::new();
        for part in parts {
            let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
            encoder.write_all(part).unwrap();
            let packed = encoder.finish().unwrap();
            table.extend((part.len() as u32).to_le_bytes());
            table.extend((packed.len() as u32).to_le_bytes());
            streams.extend(packed);
        }
        table.extend(streams);
        table
    }
}

/// The bytes packed by gzip.
pub fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// A named item of a Gwyddion file.
pub fn item(name: &str, kind: u8, value: &[u8]) -> Vec<u8> {
    [name.as_bytes(), &[0, kind], value].concat()
}

/// A Gwyddion object with items, as a value.
pub fn object(name: &str, items: &[Vec<u8>]) -> Vec<u8> {
    let items = items.concat();
    [name.as_bytes(), &[0], &(items.len() as u32).to_le_bytes(), &items].concat()
}

/// A Gwyddion field of 5 columns and 4 rows of 5 and 2.5 of the lateral unit.
pub fn gwy_field(heights: &[f64], unit_xy: &str, unit_z: &str) -> Vec<u8> {
    let unit = |name: &str| object("GwySIUnit", &[item("unitstr", b's', &zeroed(name))]);
    let data = heights.iter().flat_map(|z| z.to_le_bytes());
    let data: Vec<u8> = (heights.len() as u32).to_le_bytes().into_iter().chain(data).collect();
    object(
        "GwyDataField",
        &[
            item("xres", b'i', &5i32.to_le_bytes()),
            item("yres", b'i', &4i32.to_le_bytes()),
            item("xreal", b'd', &25f64.to_le_bytes()),
            item("yreal", b'd', &10f64.to_le_bytes()),
            item("si_unit_xy", b'o', &unit(unit_xy)),
            item("si_unit_z", b'o', &unit(unit_z)),
            item("data", b'D', &data),
        ],
    )
}

/// A Gwyddion file.
pub fn gwy(items: &[Vec<u8>]) -> Vec<u8> {
    [&b"GWYP"[..], &object("GwyContainer", items)].concat()
}

/// The text and a zero.
pub fn zeroed(text: &str) -> Vec<u8> {
    [text.as_bytes(), &[0]].concat()
}

/// A binary SDF file of points 5 um and 2.5 um apart and heights in um.
pub fn sdf(magic: &str, size: [u32; 2], data_type: u8, data: &[u8]) -> Vec<u8> {
    let mut bytes = [magic.as_bytes(), &[b' '; 10 + 12 + 12]].concat();
    for n in size {
        match magic.ends_with("2.0") {
            true => bytes.extend(n.to_le_bytes()),
            false => bytes.extend((n as u16).to_le_bytes()),
        }
    }
    bytes.extend([5e-6, 2.5e-6, 1e-6, -1.0].iter().flat_map(|scale: &f64| scale.to_le_bytes()));
    bytes.extend([0, data_type, 0]);
    bytes.extend(data);
    bytes
}

/// A text SDF file like that of [`sdf`].
pub fn sdf_text(magic: &str, size: [u64; 2], data: &str) -> String {
    let [points, profiles] = size;
    format!(
        "{magic}\r\nManufacID = us\r\nNumPoints = {points}\r\nNumProfiles = {profiles}\r
Xscale = 5e-6\r\nYscale = 2.5e-6\r\nZscale = 1e-6\r\nZresolution = -1\r\nCompression = 0\r
DataType = 7\r\nCheckType = 0\r\n*\r\n{data}\r\n*\r\nOperator = we\r\n*\r\n"
    )
}

/// An X3P archive.
pub struct X3p {
    pub feature: &'static str,
    pub kind: &'static str,
    pub of_z: &'static str,
    pub size: [u64; 2],
    pub data: Vec<u8>,
    pub valid: Option<Vec<u8>>,
    /// Numbers in `main.xml`.
    pub list: &'static str,
    /// Axis x: `I` at equal distances, `A` stored as doubles.
    pub x: &'static str,
}

impl Default for X3p {
    fn default() -> Self {
        let (feature, kind, of_z) = ("SUR", "D", "");
        Self { feature, kind, of_z, size: [5, 4], data: vec![], valid: None, list: "", x: "I" }
    }
}

impl X3p {
    pub fn xml(&self) -> String {
        let Self { feature, kind, of_z, size: [columns, rows], list, x, .. } = self;
        let (dx, link) = match (*x, *list) {
            ("I", "") => ("5e-7", "<PointDataLink>bindata/data.bin</PointDataLink>"),
            ("I", _) => ("5e-7", ""),
            (_, "") => ("1", "<PointDataLink>bindata/data.bin</PointDataLink>"),
            _ => ("1", ""),
        };
        let valid = match self.valid {
            Some(_) => "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>",
            None => "",
        };
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1>
<Revision>ISO5436 - 2000</Revision><FeatureType>{feature}</FeatureType><Axes>
<CX><AxisType>{x}</AxisType><DataType>D</DataType><Increment>{dx}</Increment></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>2.5e-7</Increment></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType>{of_z}</CZ></Axes></Record1>
<Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ>
</MatrixDimension>{list}<DataLink>{link}{valid}
</DataLink></Record3></p:ISO5436_2>"
        )
    }
}

pub fn x3p_of(x3p: &X3p) -> Vec<u8> {
    archive(&[
        ("main.xml", x3p.xml().as_bytes()),
        ("bindata/data.bin", &x3p.data),
        ("bindata/valid.bin", x3p.valid.as_deref().unwrap_or_default()),
    ])
}

pub fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in entries {
        archive.start_file(*name, SimpleFileOptions::default()).unwrap();
        archive.write_all(bytes).unwrap();
    }
    archive.finish().unwrap().into_inner()
}
