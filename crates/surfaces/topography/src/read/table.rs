//! Tables of numbers as surfaces: a matrix, a matrix with axes, or columns of points.

use super::blocks::Block;
use super::header::{Header, no_unit};
use super::lines::{COMMENT, Delimiter, value};
use super::points::{deviation, grid, step};
use super::profile::profile;
use super::scan::{ReadOptions, Scan, agree, is_code, mirror_rows, points};
use super::words::{meanings, named, unit_meaning};
use crate::error::{excerpt, refuse, refuse_line, undecided, unknown_name};
use crate::topography::transposed;
use crate::{Distance, LengthUnit, TopographyError};

/// How the columns of a table are read.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Layout {
    /// A row of heights to a line.
    Matrix,
    /// A matrix with positions in its first column, in its first row, or in both.
    Axes,
    /// The columns of x, y, z and of validity.
    Columns([Option<usize>; 4]),
}

/// The values of the option `columns`.
const LAYOUTS: &str = "matrix (all are heights), axes (the first are positions), the number of the column of heights, or a list such as x,y,z,-";

/// The surface in a block.
pub(super) fn scan(
    mut block: Block,
    header: &Header,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    if let [Some(x), Some(y)] = header.points()?
        && x.checked_mul(y) == Some(block.values.len())
        && (block.ragged.is_some() || x % block.columns == 0)
    {
        // Lines of a grid may be broken.
        (block.columns, block.ragged) = (x, None);
    }
    if let Some(error) = block.ragged.take() {
        return Err(error);
    }
    let corner = take_positions(&mut block)?;
    let names = names(&block);
    let layout = match &options.columns {
        Some(columns) => by_option(columns, &names)?,
        None => match by_names(&names)? {
            Some(layout) => layout,
            None => by_numbers(&block, header)?,
        },
    };
    let mut scan = match layout {
        Layout::Columns(columns) => positions(block, columns, &names, header, options)?,
        Layout::Axes => axes(block, corner, header, options)?,
        Layout::Matrix => matrix(block.values, block.columns, header, options)?,
    };
    for code in header.missing() {
        scan.heights.iter_mut().filter(|z| is_code(**z, *code)).for_each(|z| *z = f64::NAN);
    }
    scan.unit = header.unit(scan.unit)?;
    if let Some((factor, note)) = header.factor(scan.unit.or(options.height_unit()).is_some())? {
        scan.factor = Some(factor);
        scan.notes.extend(Some(note).filter(|_| factor.total_cmp(&1.0).is_ne()));
    }
    Ok(scan)
}

/// Makes positions over the columns, in a line such as `y\x,0.0,0.5,1.0`, the first row, and
/// returns the name before them.
///
/// # Errors
/// [`TopographyError::Content`] for a line of numbers that is no row.
fn take_positions(block: &mut Block) -> Result<Option<Column>, TopographyError> {
    let Some((number, text)) = block.header.last() else { return Ok(None) };
    let (n, comma) = (block.columns, block.delimiter.decimal_comma());
    let fields: Vec<_> = block.delimiter.fields(text.as_bytes()).collect();
    let numbers: Vec<f64> = fields.iter().filter_map(|field| value(field, comma)).collect();
    if fields.len() == n && numbers.len() + 1 == n && step(&numbers).is_some() {
        let corner = Column::new(&String::from_utf8_lossy(fields[0]));
        block.values.splice(..0, std::iter::once(f64::NAN).chain(numbers));
        return Ok(Some(corner));
    }
    // A stray quote hides the fields behind it.
    let bare = text.replace('"', "");
    let numbers = block.delimiter.fields(bare.as_bytes()).filter_map(|field| value(field, comma));
    if n > 3 && 2 * numbers.count() >= n && block.is_like(text) && !text.starts_with(['#', '%']) {
        return Err(refuse_line(*number, text, "a row of finite numbers, or nan"));
    }
    Ok(None)
}

/// The name of a column.
#[derive(Debug, Clone, Default)]
struct Column {
    name: String,
    /// `x`, `y`, `z`, `index`, `valid`, `-` for what is no height, or empty.
    role: &'static str,
    unit: Option<String>,
}

impl Column {
    fn new(text: &str) -> Self {
        let (name, unit) = named(text);
        let digits = |c: char| c.is_ascii_digit();
        let names = [name, name.trim_end_matches(digits)];
        let role = names.iter().find_map(|name| meanings("column", name).first().copied());
        let role = role.filter(|_| !name.is_empty() || text.trim().is_empty()).unwrap_or_default();
        let other = role != "valid" && unit.and_then(unit_meaning) == Some("other");
        let name = text.trim().trim_matches('"').to_owned();
        Self { name, role: if other { "-" } else { role }, unit: unit.map(str::to_owned) }
    }

    fn known(&self) -> bool {
        !self.role.is_empty() || self.unit.is_some()
    }

    fn unit(&self) -> Result<Option<LengthUnit>, TopographyError> {
        let wrong = || refuse("column", format!("{:?}", self.name), "a unit of length");
        self.unit.as_ref().map(|unit| unit.parse().map_err(|_| wrong())).transpose()
    }
}

/// The names over the columns, with units from a second line.
fn names(block: &Block) -> Vec<Column> {
    let mut names = vec![Column::default(); block.columns];
    for (nth, (_, line)) in block.header.iter().rev().take(3).enumerate() {
        let found = names_in(line.trim_start_matches(COMMENT), block, nth).unwrap_or_default();
        for (name, found) in names.iter_mut().zip(found) {
            let Column { name: text, role, unit } = std::mem::replace(name, found);
            if !role.is_empty() {
                (name.name, name.role) = (text, role);
            }
            name.unit = unit.or(name.unit.take());
        }
    }
    names
}

/// The names in a line, the `nth` above the rows, if it names the columns.
fn names_in(line: &str, block: &Block, nth: usize) -> Option<Vec<Column>> {
    let n = block.columns;
    let by = |delimiter: Delimiter| {
        let fields = delimiter.fields(line.as_bytes()).map(String::from_utf8_lossy);
        let mut names: Vec<_> = fields.map(|name| Column::new(&name)).collect();
        // A delimiter may end the line.
        if names.len() == n + 1 {
            names.pop_if(|last| last.name.is_empty());
        }
        names
    };
    let bracketed = line.split_inclusive([']', ')']).map(Column::new).collect();
    let alone = if n == 1 && nth == 0 { vec![Column::new(line)] } else { vec![] };
    let spaces = Delimiter(b' ');
    let splits = [(block.delimiter == spaces, by(block.delimiter)), (false, by(Delimiter(b',')))];
    let splits = splits.into_iter().chain([(false, bracketed), (true, by(spaces)), (false, alone)]);
    let names_all = |(spaced, names): &(bool, Vec<Column>)| {
        let known = names.iter().filter(|name| name.known()).count();
        let count = |role: &str| names.iter().filter(|name| name.role == role).count();
        let places = ["x", "y", "z"].map(count);
        // Spaces may part the words of a sentence, too.
        names.len() == n
            && match spaced {
                true => known == n && places.iter().all(|count| *count < 2),
                false => known == n || n < 4 && known > 0 || !places.contains(&0),
            }
    };
    splits.into_iter().find(names_all).map(|(_, names)| names)
}

/// The layout of the option `columns`.
fn by_option(text: &str, names: &[Column]) -> Result<Layout, TopographyError> {
    let n = names.len();
    let roles: Vec<_> = text.split(',').map(str::trim).collect();
    let place = |role: &str| roles.iter().position(|found| found.eq_ignore_ascii_case(role));
    let at = |role: &str| names.iter().position(|column| column.role == role);
    Ok(match (text.trim(), text.trim().parse::<usize>()) {
        ("matrix", _) => Layout::Matrix,
        ("axes", _) => Layout::Axes,
        (_, Ok(k)) if (1..=n).contains(&k) => {
            Layout::Columns([at("x").filter(|x| x + 1 != k), None, Some(k - 1), at("valid")])
        }
        _ if roles.len() == n && place("z").is_some() => {
            Layout::Columns([place("x"), place("y"), place("z"), at("valid")])
        }
        _ => {
            return Err(unknown_name("columns", text, format!("for {n} columns {LAYOUTS}")));
        }
    })
}

/// The layout that the names of the columns state.
fn by_names(names: &[Column]) -> Result<Option<Layout>, TopographyError> {
    let of = |role: &str| -> Vec<usize> {
        (0..names.len()).filter(|k| names[*k].role == role).collect()
    };
    let [mut x, mut y, z, other, index, valid] = ["x", "y", "z", "-", "index", "valid"].map(of);
    let unknown = of("");
    // Names before that of the heights are those of positions.
    let before = unknown.iter().filter(|k| z.first().is_some_and(|z| *k < z)).copied();
    let before: Vec<_> = if x.is_empty() && y.is_empty() { before.collect() } else { vec![] };
    if let [first, ref second @ ..] = before[..]
        && second.len() < 2
    {
        (x, y) = (vec![first], second.to_vec());
    }
    // Beside x alone, y are heights.
    let beside = || if x.is_empty() { vec![] } else { y.clone() };
    let heights = [z, unknown].into_iter().find(|z| !z.is_empty()).unwrap_or_else(beside);
    let placed = [&x, &y, &other, &index].iter().any(|columns| !columns.is_empty());
    let shown = || names.iter().map(|name| excerpt(&name.name)).collect::<Vec<_>>().join(", ");
    let place = || format!("columns {}", shown());
    match heights[..] {
        _ if !names.iter().any(Column::known) || !placed && heights.len() != 1 => Ok(None),
        [z] => {
            let y = y.first().copied().filter(|y| *y != z);
            let columns = [x.first().copied(), y, Some(z), valid.first().copied()];
            Ok(Some(Layout::Columns(columns)))
        }
        [] => Err(refuse(place(), "no heights", "a column of heights")),
        _ if names.len() > 3 && x.is_empty() && other.is_empty() => Ok(None),
        _ => {
            let found = format!("{} of them may be heights", heights.len());
            Err(undecided(place(), found, "columns", LAYOUTS))
        }
    }
}

/// The layout of a table without names.
fn by_numbers(block: &Block, header: &Header) -> Result<Layout, TopographyError> {
    let (n, rows, values) = (block.columns, block.rows(), &block.values);
    let place = || format!("the table from line {}", block.line);
    let count = |k: &usize| rows > 9 && values[*k].total_cmp(&((rows - k - 1) as f64)).is_eq();
    if let (1, Some(k)) = (n, (0..rows.min(4)).find(count)) {
        let found = format!("{:?} before {} heights", &values[..=k], rows - k - 1);
        let choice = format!("{} to leave out such counts and lengths", block.line + k);
        return Err(undecided(place(), found, "skip_lines", &choice));
    }
    let sized = header.has_size() || header.points()? != [None; 2];
    match n {
        1 => return Ok(Layout::Matrix),
        2 if !sized => return Ok(Layout::Columns([Some(0), None, Some(1), None])),
        3 if !sized => {
            // A third column without values, as after `1.5,2.5,,`.
            let empty = column(block, 2, 0).iter().all(|z| z.is_nan());
            let [y, z] = if empty { [None, Some(1)] } else { [Some(1), Some(2)] };
            return Ok(Layout::Columns([Some(0), y, z, None]));
        }
        _ if rows < 2 => return Ok(Layout::Matrix),
        _ => {}
    }
    let framed = values[0].is_nan() && step(&values[1..n]).is_some();
    if framed && step(&column(block, 0, 1)).is_some() {
        return Ok(Layout::Axes);
    }
    let axis = |first: &[f64], second: &[f64]| {
        first.len() > 4 && step(first).is_some() && deviation(second) > 0.5
    };
    let cloud = || {
        let points = values.chunks(n).flat_map(|row| row.iter().take(3)).copied().collect();
        grid(points).is_ok_and(|(heights, ..)| heights.len() == rows)
    };
    let found = match () {
        () if n < 8 && rows > 8 && cloud() => "columns 1 and 2 are the points of a grid",
        () if axis(&column(block, 0, 1), &column(block, 1, 1)) => "column 1 has equal steps",
        () if axis(&values[1..n], &values[n + 1..2 * n]) => "the first row has equal steps",
        () => return Ok(Layout::Matrix),
    };
    Err(undecided(place(), found.to_owned(), "columns", LAYOUTS))
}

fn column(block: &Block, at: usize, from: usize) -> Vec<f64> {
    block.values.chunks(block.columns).skip(from).map(|row| row[at]).collect()
}

/// A matrix with positions in its first row, in its first column, or in both.
fn axes(
    block: Block,
    corner: Option<Column>,
    header: &Header,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    let (n, place) = (block.columns, format!("the table from line {}", block.line));
    let top = Some(&block.values[1..n]).filter(|row| step(row).is_some());
    let side = Some(column(&block, 0, top.is_some().into())).filter(|side| step(side).is_some());
    let (first, skip) = (usize::from(top.is_some()), usize::from(side.is_some()));
    if first + skip == 0 {
        return Err(refuse(place, "no axis", "a first row or column of equal steps"));
    }
    let mut cloud = Vec::with_capacity(3 * block.values.len());
    for (i, row) in block.values.chunks(n).skip(first).enumerate() {
        let y = if skip > 0 { row[0] } else { i as f64 };
        for (j, z) in row.iter().enumerate().skip(skip) {
            cloud.extend([if first > 0 { block.values[j] } else { j as f64 }, y, *z]);
        }
    }
    let (heights, columns, steps) = grid(cloud)?;
    let unit = corner.as_ref().map_or(Ok(None), Column::unit)?;
    // Counts of rows and columns are no lengths.
    let counts = |axis: &[f64]| {
        let start = axis[0].min(axis[axis.len() - 1]);
        (start * (start - 1.0)).abs() < 1e-9
            && (step(axis).unwrap_or_default().abs() - 1.0).abs() < 1e-9
    };
    let counted = unit.is_none() && [top, side.as_deref()].into_iter().flatten().all(counts);
    let mut pixel_size = header.pixel_size([columns, heights.len() / columns], options)?;
    if pixel_size.is_none() && !counted && first + skip == 2 {
        let side = |axis: usize| {
            let unit =
                agree("units", options.lateral(axis), unit.or(header.lateral(axis, options)?))?;
            let unit = unit.ok_or_else(|| no_unit(place.clone(), "its axis"))?;
            Ok::<_, TopographyError>(Distance { value: steps[axis], unit: Some(unit) })
        };
        pixel_size = Some([side(0)?, side(1)?]);
    }
    Ok(Scan { heights, columns, pixel_size, ..Scan::default() })
}

/// A row of heights to a line; a single column is a profile.
fn matrix(
    values: Vec<f64>,
    columns: usize,
    header: &Header,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    let (n, profile) = (values.len(), columns == 1);
    let mut counts = if profile { [n, 1] } else { [columns, n / columns] };
    points(counts[0] as u64, counts[1] as u64)?;
    let mut heights = values;
    if header.has("turned") {
        heights = transposed(&heights, columns);
        counts.reverse();
    }
    if header.has("downwards") {
        mirror_rows(&mut heights, counts[0]);
    }
    if !profile {
        header.check(counts)?;
    }
    let pixel_size = header.pixel_size(counts, options)?;
    Ok(Scan { heights, columns: counts[0], pixel_size, ..Scan::default() })
}

/// Points of a grid, or a profile.
fn positions(
    block: Block,
    [x, y, z, valid]: [Option<usize>; 4],
    names: &[Column],
    header: &Header,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    let of = |at: Option<usize>| at.map_or(Ok(None), |at| names[at].unit());
    let side = |axis: usize, at: usize| agree("units", options.lateral(axis), of(Some(at))?);
    let height = |row: &[f64]| match valid {
        Some(valid) if row[valid] == 0.0 => f64::NAN,
        _ => row[z.unwrap_or_default()],
    };
    let rows = block.values.chunks(block.columns);
    let unit = of(z)?;
    let scan = match (x, y) {
        (Some(x), Some(y)) => {
            let values = rows.flat_map(|row| [row[x], row[y], height(row)]).collect();
            let (heights, columns, steps) = grid(values)?;
            let units = [side(0, x)?, side(1, y)?];
            if units[0].is_some() != units[1].is_some() {
                let found = "a unit over one of the columns x and y";
                return Err(refuse("header", found, "units over both or over neither"));
            }
            let size = [0, 1].map(|axis| Distance { value: steps[axis], unit: units[axis] });
            Scan { heights, columns, pixel_size: Some(size), ..Scan::default() }
        }
        (Some(at), None) | (None, Some(at)) => {
            let (places, heights) = rows.map(|row| (row[at], height(row))).unzip();
            let (scan, value) = profile(places, heights)?;
            Scan { pixel_size: Some([Distance { value, unit: side(0, at)? }; 2]), ..scan }
        }
        (None, None) => matrix(rows.map(height).collect(), 1, header, options)?,
    };
    Ok(Scan { unit, ..scan })
}
