//! Writers of small binary files for the tests of the readers.

#![allow(clippy::unwrap_used, dead_code, reason = "writers for tests; each test uses some")]

use std::io::{Cursor, Write};

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
}

impl Default for Sur {
    fn default() -> Self {
        Self { bits: 32, unit: b"um", inversion: 0, lowest: None, comment: 0, size: [5, 4] }
    }
}

impl Sur {
    /// The file with these heights in steps of an eighth of the unit; points are 5 and 2.5 units
    /// apart.
    pub fn bytes(&self, heights: &[f64]) -> Vec<u8> {
        let mut header = vec![0; 512];
        let mut put = |at: usize, bytes: &[u8]| header[at..at + bytes.len()].copy_from_slice(bytes);
        put(0, b"DIGITAL SURF");
        put(14, &1u16.to_le_bytes());
        put(18, &2u16.to_le_bytes());
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
        header.extend(std::iter::repeat_n(b'!', usize::from(self.comment)));
        for height in heights {
            match self.bits {
                16 => header.extend((*height as i16).to_le_bytes()),
                _ => header.extend((*height as i32).to_le_bytes()),
            }
        }
        header
    }
}

/// An X3P archive.
pub struct X3p {
    pub feature: &'static str,
    pub kind: &'static str,
    pub of_z: &'static str,
    pub size: [u64; 2],
    pub data: Vec<u8>,
    pub valid: Option<Vec<u8>>,
}

impl Default for X3p {
    fn default() -> Self {
        let (feature, kind, of_z) = ("SUR", "D", "");
        Self { feature, kind, of_z, size: [5, 4], data: Vec::new(), valid: None }
    }
}

impl X3p {
    pub fn xml(&self) -> String {
        let Self { feature, kind, of_z, size: [columns, rows], .. } = self;
        let valid = match self.valid {
            Some(_) => "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>",
            None => "",
        };
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\"><Record1>
<Revision>ISO5436 - 2000</Revision><FeatureType>{feature}</FeatureType><Axes>
<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-7</Increment></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>2.5e-7</Increment></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType>{of_z}</CZ></Axes></Record1>
<Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ>
</MatrixDimension><DataLink><PointDataLink>bindata/data.bin</PointDataLink>{valid}
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
