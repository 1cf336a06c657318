//! The description of an X3P archive, `main.xml`.

use roxmltree::{Document, Node, ParsingOptions};

use super::sample::Sample;
use crate::TopographyError;
use crate::error::refuse;

/// The largest number of elements, texts and comments.
const MAX_NODES: u32 = 100_000;

/// The content of `main.xml`.
pub(super) struct Description {
    pub(super) columns: u64,
    pub(super) rows: u64,
    /// Distance of points along x and y, for axes of equal distances \[m\].
    pub(super) increments: [Option<f64>; 2],
    /// The coordinates stored for each point, of which z is the last.
    pub(super) stored: Vec<Coordinate>,
    pub(super) data: Data,
}

/// A stored coordinate: `step` times the number plus `offset` \[m\].
#[derive(Clone, Copy)]
pub(super) struct Coordinate {
    pub(super) sample: Sample,
    pub(super) step: f64,
    pub(super) offset: f64,
}

/// The place of the coordinates.
pub(super) enum Data {
    /// Names of the entries of coordinates and, if there is one, of bits of valid points.
    Entries { points: String, valid: Option<String> },
    /// Coordinates in `main.xml`, point by point, NaN where missing.
    Numbers(Vec<f64>),
}

impl Description {
    pub(super) fn parse(xml: &str) -> Result<Self, TopographyError> {
        let options = ParsingOptions { nodes_limit: MAX_NODES, ..ParsingOptions::default() };
        let document = Document::parse_with_options(xml, options)
            .map_err(|error| refuse("x3p main.xml", error, "an XML document"))?;
        Self::read(document.root_element())
    }

    fn read(root: Node<'_, '_>) -> Result<Self, TopographyError> {
        let (profile, cloud) = match text(root, &["Record1", "FeatureType"])? {
            "SUR" => (false, false),
            "PRF" => (true, false),
            "PCL" => (false, true),
            other => {
                let required = "SUR (surface), PRF (profile) or PCL (points)";
                return Err(refuse("x3p FeatureType", other, required));
            }
        };
        let [columns, rows] = dimensions(root)?;
        let line = profile && rows == 1;
        let (mut stored, mut increments) = (vec![], [None; 2]);
        for (k, axis) in ["CX", "CY"].into_iter().enumerate() {
            let placed = cloud || line && k == 0;
            let required = match (cloud, placed) {
                (true, _) => "A: points with positions in x and y",
                (_, true) => "I (equal distances) or A (positions)",
                _ => "I: points at equal distances",
            };
            let path = |name| ["Record1", "Axes", axis, name];
            match text(root, &path("AxisType")) {
                // A profile has no distance of rows.
                found if line && k == 1 && found.as_ref().map_or(true, |kind| *kind != "A") => {
                    increments[1] = increments[0];
                }
                Ok("I") if !cloud => {
                    let absent = || refuse(place(&path("Increment")), "nothing", "a length in m");
                    let found = number(root, &path("Increment"))?;
                    increments[k] = Some(found.ok_or_else(absent)?);
                }
                Ok("A") if placed => stored.push(coordinate(root, axis)?),
                found => return Err(refuse(place(&path("AxisType")), found?, required)),
            }
        }
        stored.push(coordinate(root, "CZ")?);
        let data = Data::read(root, stored.len())?;
        Ok(Self { columns, rows, increments, stored, data })
    }
}

impl Data {
    fn read(root: Node<'_, '_>, coordinates: usize) -> Result<Self, TopographyError> {
        let link = |name: &str| {
            find(root, &["Record3", "DataLink", name]).map(|node| trimmed_text(node).to_owned())
        };
        if let Some(points) = link("PointDataLink") {
            let valid = link("ValidPointsLink").filter(|name| !name.is_empty());
            return Ok(Self::Entries { points, valid });
        }
        let list = find(root, &["Record3", "DataList"])
            .ok_or_else(|| refuse("x3p Record3", "no data", "a PointDataLink or a DataList"))?;
        let mut numbers = Vec::new();
        for datum in list.children().filter(|node| node.tag_name().name() == "Datum") {
            let text = trimmed_text(datum);
            // An empty element is a missing point.
            let words = text.split(';').map(str::trim);
            let found: Option<Vec<f64>> = match text {
                "" => Some(vec![f64::NAN; coordinates]),
                _ => words.map(|word| word.parse().ok()).collect(),
            };
            let found = found.filter(|found| found.len() == coordinates);
            let required = format!("{coordinates} numbers between semicolons");
            numbers.extend(found.ok_or_else(|| refuse("x3p Datum", text, required))?);
        }
        Ok(Self::Numbers(numbers))
    }
}

/// Columns and rows.
fn dimensions(root: Node<'_, '_>) -> Result<[u64; 2], TopographyError> {
    let count = |path: &[&str]| -> Result<u64, TopographyError> {
        let found = text(root, path)?;
        let n = found.parse().ok().filter(|n| *n > 0);
        n.ok_or_else(|| refuse(place(path), found, "a whole number of at least 1"))
    };
    if find(root, &["Record3", "ListDimension"]).is_some() {
        return Ok([count(&["Record3", "ListDimension"])?, 1]);
    }
    let size = |name| count(&["Record3", "MatrixDimension", name]);
    let layers = size("SizeZ")?;
    if layers != 1 {
        return Err(refuse("x3p SizeZ", layers, "1: a single layer"));
    }
    Ok([size("SizeX")?, size("SizeY")?])
}

fn coordinate(root: Node<'_, '_>, axis: &str) -> Result<Coordinate, TopographyError> {
    let path = |name| ["Record1", "Axes", axis, name];
    let kind = text(root, &path("DataType"))?;
    let sample = [("I", b"i2"), ("L", b"i4"), ("F", b"f4"), ("D", b"f8")];
    let sample = sample.into_iter().find(|(name, _)| *name == kind).map(|(_, of)| Sample::new(*of));
    let sample = sample.ok_or_else(|| refuse(place(&path("DataType")), kind, "I, L, F or D"))?;
    let step = number(root, &path("Increment"))?.unwrap_or(1.0);
    Ok(Coordinate { sample, step, offset: number(root, &path("Offset"))?.unwrap_or(0.0) })
}

/// The number in an element, if it is there and not empty.
fn number(root: Node<'_, '_>, path: &[&str]) -> Result<Option<f64>, TopographyError> {
    let text = find(root, path).map_or("", trimmed_text);
    if text.is_empty() {
        return Ok(None);
    }
    let number: Option<f64> = text.parse().ok().filter(|number: &f64| number.is_finite());
    number.map(Some).ok_or_else(|| refuse(place(path), text, "a finite number"))
}

fn text<'a>(root: Node<'a, '_>, path: &[&str]) -> Result<&'a str, TopographyError> {
    let absent = || refuse(place(path), "nothing", "an element of this name");
    find(root, path).map(trimmed_text).ok_or_else(absent)
}

/// The end of a path as the place of an error, with the axis where there is one.
fn place(path: &[&str]) -> String {
    match path {
        [_, _, axis @ ("CX" | "CY" | "CZ"), name] => format!("x3p {axis} {name}"),
        _ => format!("x3p {}", path.last().unwrap_or(&"")),
    }
}

fn find<'a, 'input>(root: Node<'a, 'input>, path: &[&str]) -> Option<Node<'a, 'input>> {
    path.iter()
        .try_fold(root, |node, name| node.children().find(|child| child.tag_name().name() == *name))
}

fn trimmed_text<'a>(node: Node<'a, '_>) -> &'a str {
    node.text().unwrap_or_default().trim()
}
