//! The description of an X3P archive, `main.xml`.

use roxmltree::{Document, Node, ParsingOptions};

use super::refusal::x3p as refuse;
use super::sample::{Kind, Sample};
use crate::TopographyError;

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
            .map_err(|error| refuse("main.xml", error, "an XML document"))?;
        Self::read(document.root_element())
    }

    fn read(root: Node<'_, '_>) -> Result<Self, TopographyError> {
        let (profile, cloud) = match text(root, &["Record1", "FeatureType"], "FeatureType")? {
            "SUR" => (false, false),
            "PRF" => (true, false),
            "PCL" => (false, true),
            other => {
                let required = "SUR (surface), PRF (profile) or PCL (points)";
                return Err(refuse("FeatureType", other, required));
            }
        };
        let [columns, rows] = dimensions(root)?;
        let mut stored = Vec::new();
        let (x, of_x) = axis(root, "CX", ["CX AxisType", "CX DataType", "CX Increment"])?;
        if of_x.is_some() && !cloud && !(profile && rows == 1) {
            return Err(refuse("CX AxisType", "A", "I: points at equal distances"));
        }
        stored.extend(of_x);
        let y = match profile && rows == 1 {
            // Only its increment would be absent.
            true => {
                let kind = find(root, &["Record1", "Axes", "CY", "AxisType"]).map(trimmed_text);
                if kind == Some("A") {
                    return Err(refuse("CY AxisType", "A", "I: a profile along x"));
                }
                x
            }
            false => match axis(root, "CY", ["CY AxisType", "CY DataType", "CY Increment"])? {
                (y, of_y) if cloud || of_y.is_none() => {
                    stored.extend(of_y);
                    y
                }
                _ => return Err(refuse("CY AxisType", "A", "I: points at equal distances")),
            },
        };
        if cloud && stored.len() != 2 {
            return Err(refuse("AxisType", "I", "A: points with positions in x and y"));
        }
        let kind = text(root, &["Record1", "Axes", "CZ", "DataType"], "CZ DataType")?;
        stored.push(coordinate(root, "CZ", ["CZ DataType", "CZ Increment"], kind)?);
        let data = Data::read(root, stored.len())?;
        Ok(Self { columns, rows, increments: [x, y], stored, data })
    }
}

impl Data {
    fn read(root: Node<'_, '_>, coordinates: usize) -> Result<Self, TopographyError> {
        let link = |name: &str| find(root, &["Record3", "DataLink", name]).map(trimmed_text);
        if let Some(points) = link("PointDataLink") {
            let valid = link("ValidPointsLink").filter(|name| !name.is_empty());
            return Ok(Self::Entries {
                points: points.to_owned(),
                valid: valid.map(str::to_owned),
            });
        }
        let list = find(root, &["Record3", "DataList"])
            .ok_or_else(|| refuse("Record3", "no data", "a PointDataLink or a DataList"))?;
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
            numbers.extend(found.ok_or_else(|| refuse("Datum", text, &required))?);
        }
        Ok(Self::Numbers(numbers))
    }
}

/// Columns and rows.
fn dimensions(root: Node<'_, '_>) -> Result<[u64; 2], TopographyError> {
    let count = |path: &[&str], name: &'static str| -> Result<u64, TopographyError> {
        let found = text(root, path, name)?;
        let n = found.parse().ok().filter(|n| *n > 0);
        n.ok_or_else(|| refuse(name, found, "a whole number of at least 1"))
    };
    if find(root, &["Record3", "ListDimension"]).is_some() {
        return Ok([count(&["Record3", "ListDimension"], "ListDimension")?, 1]);
    }
    let size = |name| count(&["Record3", "MatrixDimension", name], name);
    let layers = size("SizeZ")?;
    if layers != 1 {
        return Err(refuse("SizeZ", layers, "1: a single layer"));
    }
    Ok([size("SizeX")?, size("SizeY")?])
}

/// The increment of an axis of equal distances, or else its stored coordinate.
fn axis(
    root: Node<'_, '_>,
    name: &str,
    [axis_type, data_type, increment]: [&'static str; 3],
) -> Result<(Option<f64>, Option<Coordinate>), TopographyError> {
    match text(root, &["Record1", "Axes", name, "AxisType"], axis_type)? {
        "I" => match find(root, &["Record1", "Axes", name, "Increment"]) {
            Some(node) => Ok((Some(number(node, increment)?), None)),
            None => Err(refuse(increment, "nothing", "the distance of the points in m")),
        },
        "A" => {
            let kind = text(root, &["Record1", "Axes", name, "DataType"], data_type)?;
            Ok((None, Some(coordinate(root, name, [data_type, increment], kind)?)))
        }
        other => Err(refuse(axis_type, other, "I (equal distances) or A (positions)")),
    }
}

fn coordinate(
    root: Node<'_, '_>,
    axis: &str,
    [data_type, increment]: [&'static str; 2],
    kind: &str,
) -> Result<Coordinate, TopographyError> {
    let kind = match kind {
        "I" => Kind::I16,
        "L" => Kind::I32,
        "F" => Kind::F32,
        "D" => Kind::F64,
        other => return Err(refuse(data_type, other, "I, L, F or D")),
    };
    let of = |name: &str, field, usual: f64| match find(root, &["Record1", "Axes", axis, name]) {
        Some(node) if !trimmed_text(node).is_empty() => number(node, field),
        _ => Ok(usual),
    };
    let offset = if axis == "CZ" { "CZ Offset" } else { "CX Offset" };
    Ok(Coordinate {
        sample: Sample { kind, big_endian: false },
        step: of("Increment", increment, 1.0)?,
        offset: of("Offset", offset, 0.0)?,
    })
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
