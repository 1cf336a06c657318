//! ISO 25178-72 `.x3p`: a zip archive of `main.xml` and a file of heights in metres.
//!
//! The layout follows the reader of SurfaceTopography, not the standard.

use std::io::{Cursor, Read};

use roxmltree::{Document, Node, ParsingOptions};
use zip::ZipArchive;

use super::npy;
use super::sample::{Kind, Sample};
use super::scan::{PixelSize, Scan, points};
use crate::error::excerpt;
use crate::{LengthUnit, TopographyError};

pub(super) const MAGIC: &[u8] = b"PK\x03\x04";
/// The largest size of `main.xml` \[bytes\].
const MAX_XML: u64 = 1 << 20;
/// The largest number of elements, texts and comments in it.
const MAX_NODES: u32 = 10_000;

/// The highest ratio of deflate: 258 bytes in two bits.
const DEFLATE_RATIO: usize = 1032;

type Archive<'a> = ZipArchive<Cursor<&'a [u8]>>;

pub(super) fn scan(bytes: &[u8]) -> Result<Scan, TopographyError> {
    let mut archive = ZipArchive::new(Cursor::new(bytes))
        .map_err(|error| refuse("archive", error, "a zip archive"))?;
    if archive.file_names().flatten().any(|name| name.ends_with(".npy")) {
        return Err(npy::archive(bytes));
    }
    let xml = main_xml(&mut archive)?;
    let options = ParsingOptions { nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(&xml, options)
        .map_err(|error| refuse("main.xml", error, "an XML document"))?;
    let Description { columns, rows, pixel_size, sample, step, offset, data, valid } =
        Description::read(document.root_element())?;
    let n = points(columns, rows)?;
    let packed = (n * sample.size()).div_ceil(DEFLATE_RATIO);
    if packed > bytes.len() {
        let found = format!("{columns} x {rows} points in a file of {} bytes", bytes.len());
        return Err(refuse(
            "MatrixDimension",
            found,
            &format!("at least {packed} bytes for these points"),
        ));
    }
    let mut heights = Vec::with_capacity(n);
    unpack(&mut archive, &data, n * sample.size(), |bytes| sample.decode(bytes, &mut heights))?;
    for height in &mut heights {
        *height = *height * step + offset;
    }
    if let Some(valid) = valid {
        let mut point = 0;
        unpack(&mut archive, &valid, n.div_ceil(8), |bytes| {
            for byte in bytes {
                for bit in 0..8 {
                    if let Some(height) = heights.get_mut(point).filter(|_| byte >> bit & 1 == 0) {
                        *height = f64::NAN;
                    }
                    point += 1;
                }
            }
        })?;
    }
    let (unit, pixel_size) = (Some(LengthUnit::Metre), PixelSize::Metres(pixel_size));
    Ok(Scan { heights, columns: columns as usize, unit, pixel_size })
}

fn main_xml(archive: &mut Archive<'_>) -> Result<String, TopographyError> {
    let entry = archive
        .by_name("main.xml")
        .map_err(|error| refuse("main.xml", error, "an entry of this name"))?;
    let mut xml = Vec::new();
    entry
        .take(MAX_XML + 1)
        .read_to_end(&mut xml)
        .map_err(|error| refuse("main.xml", error, "an entry that can be unpacked"))?;
    if xml.len() as u64 > MAX_XML {
        return Err(refuse("main.xml", "more", &format!("at most {MAX_XML} bytes")));
    }
    String::from_utf8(xml).map_err(|_| refuse("main.xml", "something else", "UTF-8"))
}

/// Passes on an entry of exactly `size` bytes in pieces of complete numbers. At most `size` bytes
/// are unpacked, whatever the archive declares.
fn unpack(
    archive: &mut Archive<'_>,
    name: &str,
    size: usize,
    mut piece: impl FnMut(&[u8]),
) -> Result<(), TopographyError> {
    let entry_error = |error: &dyn ToString| format!("{name}: {}", error.to_string());
    let mut entry = archive
        .by_name(name)
        .map_err(|error| refuse("DataLink", entry_error(&error), "an entry of this name"))?;
    let mut buffer = [0; 1 << 13];
    let mut left = size;
    while left > 0 {
        let part = &mut buffer[..left.min(1 << 13)];
        entry.read_exact(part).map_err(|error| {
            let required = format!("{size} bytes, by main.xml");
            refuse("DataLink", entry_error(&error), &required)
        })?;
        piece(part);
        left -= part.len();
    }
    // Reading to the end also checks the checksum.
    match entry.read(&mut buffer) {
        Ok(0) => Ok(()),
        Ok(_) => {
            Err(refuse("DataLink", entry_error(&"more"), &format!("{size} bytes, by main.xml")))
        }
        Err(error) => Err(refuse("DataLink", entry_error(&error), "an entry that can be unpacked")),
    }
}

/// The content of `main.xml`.
struct Description {
    columns: u64,
    rows: u64,
    pixel_size: [f64; 2],
    sample: Sample,
    step: f64,
    offset: f64,
    data: String,
    valid: Option<String>,
}

impl Description {
    fn read(root: Node<'_, '_>) -> Result<Self, TopographyError> {
        let profile = match text(root, &["Record1", "FeatureType"], "FeatureType")? {
            "SUR" => false,
            "PRF" => true,
            other => return Err(refuse("FeatureType", other, "SUR (surface) or PRF (profile)")),
        };
        let size = &["Record3", "MatrixDimension"];
        let count = |name: &'static str| -> Result<u64, TopographyError> {
            let found = text(root, &[size[0], size[1], name], name)?;
            let n = found.parse().ok().filter(|n| *n > 0);
            n.ok_or_else(|| refuse(name, found, "a whole number of at least 1"))
        };
        let (columns, rows) = (count("SizeX")?, count("SizeY")?);
        if count("SizeZ")? != 1 {
            return Err(refuse("SizeZ", count("SizeZ")?, "1: a single layer"));
        }
        let kind = match text(root, &["Record1", "Axes", "CZ", "DataType"], "CZ DataType")? {
            "I" => Kind::I16,
            "L" => Kind::I32,
            "F" => Kind::F32,
            "D" => Kind::F64,
            other => return Err(refuse("CZ DataType", other, "I, L, F or D")),
        };
        let dx = increment(root, "CX", "CX AxisType", "CX Increment")?;
        let dy = match profile && rows == 1 {
            true => dx,
            false => increment(root, "CY", "CY AxisType", "CY Increment")?,
        };
        let of_z =
            |name: &str, field, default: f64| match find(root, &["Record1", "Axes", "CZ", name]) {
                Some(node) => number(node, field),
                None => Ok(default),
            };
        let link = |name: &str| find(root, &["Record3", "DataLink", name]).map(trimmed_text);
        let data = link("PointDataLink").ok_or_else(|| {
            refuse(
                "PointDataLink",
                "nothing",
                "the name of an entry (heights in main.xml are not read)",
            )
        })?;
        Ok(Self {
            columns,
            rows,
            pixel_size: [dx, dy],
            sample: Sample { kind, big_endian: false },
            step: of_z("Increment", "CZ Increment", 1.0)?,
            offset: of_z("Offset", "CZ Offset", 0.0)?,
            data: data.to_owned(),
            valid: link("ValidPointsLink").filter(|name| !name.is_empty()).map(str::to_owned),
        })
    }
}

fn increment(
    root: Node<'_, '_>,
    axis: &str,
    kind: &'static str,
    field: &'static str,
) -> Result<f64, TopographyError> {
    let found = text(root, &["Record1", "Axes", axis, "AxisType"], kind)?;
    if found != "I" {
        return Err(refuse(kind, found, "I: points at equal distances"));
    }
    match find(root, &["Record1", "Axes", axis, "Increment"]) {
        Some(node) => number(node, field),
        None => Err(refuse(field, "nothing", "the distance of the points in m")),
    }
}

fn number(node: Node<'_, '_>, field: &'static str) -> Result<f64, TopographyError> {
    let number: Option<f64> = trimmed_text(node).parse().ok();
    let number = number.filter(|number| number.is_finite());
    number.ok_or_else(|| refuse(field, trimmed_text(node), "a finite number"))
}

fn text<'a>(
    root: Node<'a, '_>,
    path: &[&str],
    field: &'static str,
) -> Result<&'a str, TopographyError> {
    find(root, path)
        .map(trimmed_text)
        .ok_or_else(|| refuse(field, "nothing", "an element of this name"))
}

fn find<'a, 'input>(root: Node<'a, 'input>, path: &[&str]) -> Option<Node<'a, 'input>> {
    path.iter()
        .try_fold(root, |node, name| node.children().find(|child| child.tag_name().name() == *name))
}

fn trimmed_text<'a>(node: Node<'a, '_>) -> &'a str {
    node.text().unwrap_or_default().trim()
}

fn refuse(field: &'static str, found: impl ToString, required: &str) -> TopographyError {
    let (found, required) = (excerpt(&found.to_string()), required.to_owned());
    TopographyError::Field { format: "x3p", field, found, required }
}
