//! Tables of numbers as surfaces: a matrix, a matrix with axes, or columns of points.

use super::blocks::Block;
use super::header::{Header, no_unit};
use super::lines::{COMMENT, Delimiter, value};
use super::points::grid;
use super::profile::profile;
use super::scan::{ReadOptions, Scan, agree, is_code, mirror_columns, mirror_rows, points};
use super::words::{meanings, named, unit_meaning};
use crate::error::{excerpt, refuse, refuse_line, undecided};
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

/// The name of a column.
#[derive(Debug, Clone, Default)]
struct Column {
    name: String,
    /// `x`, `y`, `z`, `index`, `valid`, `-` for what is no height, or empty.
    role: &'static str,
    unit: Option<String>,
}

const READINGS: &str =
    "matrix (all are heights), axes (the first are positions) or a list such as x,y,z,-";

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
    refuse_broken_row(&block)?;
    drop_empty(&mut block);
    let names = names(&block);
    let layout = match &options.columns {
        Some(columns) => by_option(columns, &names, block.columns)?,
        None => match by_names(&names, &block)? {
            Some(layout) => layout,
            None => by_numbers(&block, header)?,
        },
    };
    let sized = block.columns > 1 && header.points()? != [None; 2];
    let mut scan = match layout {
        Layout::Columns(columns) => positions(block, columns, &names, header, options)?,
        Layout::Axes => axes(block, header, options)?,
        Layout::Matrix => matrix(block.values, block.columns, header, options, sized)?,
    };
    for code in header.missing() {
        scan.heights.iter_mut().filter(|z| is_code(**z, *code)).for_each(|z| *z = f64::NAN);
    }
    if header.has_unit_of_factor() || scan.unit.is_none() {
        scan.unit = header.unit()?;
    }
    let unit = scan.unit.or(options.height_unit());
    scan.factor = header.factor(unit.is_some())?;
    Ok(scan)
}

/// Refuses a line of numbers above the first row with fields that are none.
fn refuse_broken_row(block: &Block) -> Result<(), TopographyError> {
    let Some((line, text)) = block.header.last() else { return Ok(()) };
    let comma = block.delimiter.decimal_comma();
    let values = block.delimiter.fields(text.as_bytes()).map(|field| value(field, comma));
    let broken = block.columns > 3 && 2 * values.flatten().count() >= block.columns;
    if broken
        && block.is_like(text)
        && !text.starts_with(COMMENT)
        && header_positions(block).is_none()
    {
        return Err(refuse_line(*line, text, "a row of finite numbers, or nan,"));
    }
    Ok(())
}

/// Removes a third column without values, as after `1.5,2.5,,`.
fn drop_empty(block: &mut Block) {
    if block.columns == 3
        && block.values.chunks(3).all(|row| row.last().is_some_and(|z| z.is_nan()))
    {
        block.values = block.values.chunks(3).flat_map(|row| row.iter().take(2)).copied().collect();
        block.columns = 2;
    }
}

/// The names over the columns, or units in a second line.
fn names(block: &Block) -> Vec<Column> {
    let mut columns = vec![Column::default(); block.columns];
    for (nth, (_, line)) in block.header.iter().rev().take(3).enumerate() {
        let bare = line.trim_start_matches(COMMENT);
        for (column, field) in columns.iter_mut().zip(fields(bare, block, nth).unwrap_or_default())
        {
            let found = Column::new(&field);
            column.name = if column.name.is_empty() { found.name } else { column.name.clone() };
            column.role = if column.role.is_empty() { found.role } else { column.role };
            column.unit = column.unit.take().or(found.unit);
        }
    }
    columns
}

/// The names of the columns in a line, the `nth` above the rows, if it names them.
fn fields(line: &str, block: &Block, nth: usize) -> Option<Vec<String>> {
    let n = block.columns;
    if n == 1 {
        let known = nth == 0 && Column::new(line).known();
        return known.then(|| vec![line.to_owned()]);
    }
    let split = |delimiter: Delimiter| {
        let names = delimiter.fields(line.as_bytes()).map(String::from_utf8_lossy);
        let mut names: Vec<_> = names.map(|name| name.trim_matches('"').to_owned()).collect();
        // A delimiter may end the line.
        if names.len() == n + 1 && names.last().is_some_and(String::is_empty) {
            names.pop();
        }
        (names.len() == n).then_some(names)
    };
    let known = |names: &[String]| names.iter().filter(|name| Column::new(name).known()).count();
    let separated = [block.delimiter, Delimiter(b',')].into_iter().filter(|part| part.0 != b' ');
    let separated = separated.filter_map(split);
    let bracketed = line.split_inclusive([']', ')']).map(str::to_owned).collect::<Vec<_>>();
    let mut parted = separated.chain(Some(bracketed).filter(|names| names.len() == n));
    // Spaces may part the words of a sentence, too.
    let spaced = || {
        let names = split(Delimiter(b' ')).filter(|names| known(names) == n)?;
        let roles: Vec<_> = names.iter().map(|name| Column::new(name).role).collect();
        let twice = |k: usize| !["", "-"].contains(&roles[k]) && roles[..k].contains(&roles[k]);
        (!(1..n).any(twice)).then_some(names)
    };
    let enough = |names: &Vec<String>| {
        let has = |role: &str| names.iter().any(|name| Column::new(name).role == role);
        let placed = has("z") && has("x") && has("y");
        known(names) == n || n < 4 && known(names) > 0 || placed
    };
    parted.find(enough).or_else(spaced)
}

impl Column {
    fn new(text: &str) -> Self {
        let (name, unit) = named(text);
        let role = |name: &str| meanings("column", name).first().copied();
        let bare = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let role = if name.is_empty() && !text.trim().is_empty() {
            None
        } else {
            role(name).or(role(bare))
        };
        let other = unit.and_then(unit_meaning) == Some("other") && role != Some("valid");
        let role = if other { "-" } else { role.unwrap_or_default() };
        Self { name: text.trim().to_owned(), role, unit: unit.map(str::to_owned) }
    }

    fn known(&self) -> bool {
        !self.role.is_empty() || self.unit.is_some()
    }

    fn unit(&self) -> Result<Option<LengthUnit>, TopographyError> {
        let wrong = || refuse("column", format!("{:?}", self.name), "a unit of length");
        self.unit.as_ref().map(|unit| unit.parse().map_err(|_| wrong())).transpose()
    }
}

/// The layout of the option `columns`.
fn by_option(text: &str, names: &[Column], n: usize) -> Result<Layout, TopographyError> {
    let at = |role: &str| names.iter().position(|column| column.role == role);
    let roles: Vec<_> = text.split(',').map(|role| role.trim().to_lowercase()).collect();
    let place = |role: &str| roles.iter().position(|found| found == role);
    match (text.trim(), text.trim().parse::<usize>()) {
        ("matrix", _) => Ok(Layout::Matrix),
        ("axes", _) => Ok(Layout::Axes),
        (_, Ok(k)) if (1..=n).contains(&k) => {
            Ok(Layout::Columns([at("x").filter(|x| *x != k - 1), None, Some(k - 1), at("valid")]))
        }
        _ if roles.len() == n && place("z").is_some() => {
            Ok(Layout::Columns([place("x"), place("y"), place("z"), at("valid")]))
        }
        _ => Err(TopographyError::UnknownName {
            field: "columns",
            found: excerpt(text),
            names: format!("for {n} columns {READINGS}, or the number of the column of heights"),
        }),
    }
}

/// The layout that the names of the columns state.
fn by_names(names: &[Column], block: &Block) -> Result<Option<Layout>, TopographyError> {
    if !names.iter().any(Column::known) {
        return Ok(None);
    }
    let of = |role: &str| -> Vec<usize> {
        (0..names.len()).filter(|k| names[*k].role == role).collect()
    };
    let [x, y, z, other, index, unknown] = ["x", "y", "z", "-", "index", ""].map(of);
    let heights = match () {
        () if !z.is_empty() => z,
        () if !unknown.is_empty() => unknown,
        // Beside x alone, y are heights.
        () if !x.is_empty() => y.clone(),
        () => vec![],
    };
    let named = !x.is_empty() || !y.is_empty() || !other.is_empty() || !index.is_empty();
    let valid = of("valid").first().copied();
    let shown = || names.iter().map(|column| format!("{:?}", excerpt(&column.name)));
    let shown = || shown().collect::<Vec<_>>().join(", ");
    let place = || format!("the table from line {}", block.line);
    match heights[..] {
        _ if !named && heights.len() != 1 => Ok(None),
        [z] => {
            let y = y.first().copied().filter(|y| *y != z);
            Ok(Some(Layout::Columns([x.first().copied(), y, Some(z), valid])))
        }
        [] => Err(refuse(place(), format!("columns {}", shown()), "a column of heights")),
        _ if names.len() > 3 && x.is_empty() && other.is_empty() => Ok(None),
        _ => {
            let found = format!("columns {}", shown());
            let choice = "the number of the column of heights, or a list such as x,z,-";
            Err(undecided(place(), found, "columns", choice))
        }
    }
}

/// The layout of a table without names.
fn by_numbers(block: &Block, header: &Header) -> Result<Layout, TopographyError> {
    let (n, rows) = (block.columns, block.rows());
    let value = |row: usize, column: usize| block.values[row * n + column];
    let place = |last: usize| format!("lines {} to {}", block.line, block.line + last);
    let count = |k: &usize| value(*k, 0).total_cmp(&((rows - k - 1) as f64)).is_eq();
    if let (1, Some(k)) = (n, (0..rows.min(4)).filter(|_| rows > 9).find(count)) {
        let found = format!("{:?} before {} heights", &block.values[..=k], rows - k - 1);
        let choice =
            format!("{} to leave such counts and lengths out, or columns 1", block.line + k);
        return Err(undecided(place(k), found, "skip_lines", &choice));
    }
    let sized = header.points()? != [None; 2] || header.has_size();
    match n {
        1 => return Ok(Layout::Matrix),
        2 if value(0, 0).is_nan() && line(&column(block, 0, 1)).is_some() => {
            return Ok(Layout::Axes);
        }
        2 if !sized => return Ok(Layout::Columns([Some(0), None, Some(1), None])),
        3 if !sized => return Ok(Layout::Columns([Some(0), Some(1), Some(2), None])),
        _ if rows < 2 => return Ok(Layout::Matrix),
        _ => {}
    }
    let top = header_positions(block).is_some();
    let first = usize::from(!top);
    let blank = value(0, 0).is_nan() && line(&block.values[1..n]).is_some();
    if (top || blank) && line(&column(block, 0, first)).is_some() {
        return Ok(Layout::Axes);
    }
    let axis = |first: &[f64], second: &[f64]| {
        first.len() > 4 && line(first).is_some() && line_deviation(second) > 0.5
    };
    let row = |k: usize| &block.values[k * n + 1..(k + 1) * n];
    let beside = axis(&column(block, 0, 1), &column(block, 1, 1));
    let cloud = n < 8 && rows > 8 && is_grid(&column(block, 0, 0), &column(block, 1, 0));
    if beside || cloud || axis(row(0), row(1)) {
        let found = match () {
            () if cloud => "numbers in columns 1 and 2 that are points of a grid",
            () if beside => "numbers in column 1 that rise or fall by equal steps",
            () => "numbers in the first row that rise or fall by equal steps",
        };
        return Err(undecided(place(rows - 1), found.into(), "columns", READINGS));
    }
    Ok(Layout::Matrix)
}

fn column(block: &Block, column: usize, from: usize) -> Vec<f64> {
    block
        .values
        .iter()
        .skip(from * block.columns + column)
        .step_by(block.columns)
        .copied()
        .collect()
}

/// The largest distance of numbers from a line through the first and the last, in steps of the line.
fn line_deviation(values: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else { return f64::INFINITY };
    let step = (last - first) / (values.len() - 1) as f64;
    let off = |(k, value): (usize, &f64)| ((value - first) / step - k as f64).abs();
    // NaN is the largest of all.
    values.iter().enumerate().map(off).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

/// The step of positions: at least two numbers at equal distances.
fn line(values: &[f64]) -> Option<f64> {
    let step = (values.last()? - values.first()?) / (values.len().max(2) - 1) as f64;
    (line_deviation(values) < 0.1 && step != 0.0 && step.is_finite()).then_some(step)
}

/// Whether x and y are those of every point of a grid.
fn is_grid(x: &[f64], y: &[f64]) -> bool {
    let sides = [x, y].map(|places| {
        let mut places = places.to_vec();
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        places
    });
    let [across, along] = &sides;
    across.len() > 1
        && along.len() > 1
        && across.len() * along.len() == x.len()
        && sides.iter().all(|side| line(side).is_some())
}

/// The corner and the positions over the columns, in a line such as `y\x,0.0,0.5,1.0`.
fn header_positions(block: &Block) -> Option<(String, Vec<f64>)> {
    let (_, text) = block.header.last()?;
    let mut fields = block.delimiter.fields(text.as_bytes());
    let corner = String::from_utf8_lossy(fields.next()?).into_owned();
    let comma = block.delimiter.decimal_comma();
    let positions: Option<Vec<f64>> = fields.map(|field| value(field, comma)).collect();
    let positions = positions.filter(|positions| positions.len() + 1 == block.columns);
    Some((corner, positions.filter(|positions| line(positions).is_some())?))
}

/// A matrix with positions in its first row, in its first column, or in both.
fn axes(block: Block, header: &Header, options: &ReadOptions) -> Result<Scan, TopographyError> {
    let (mut n, corner) = (block.columns, header_positions(&block));
    let own = corner.is_none().then(|| &block.values[1..n]).filter(|row| line(row).is_some());
    let above = own.map(|row| line(row)).or_else(|| Some(line(&corner.as_ref()?.1))).flatten();
    let first = usize::from(own.is_some());
    let places = column(&block, 0, first);
    let beside = line(&places);
    let index = |start: Option<&f64>, step: f64| {
        (step - 1.0).abs() < 1e-9
            && start.is_some_and(|start| start.abs().min((start - 1.0).abs()) < 1e-9)
    };
    let start =
        own.map_or_else(|| corner.as_ref().and_then(|(_, row)| row.first()), <[f64]>::first);
    let unit = corner.as_ref().and_then(|(corner, _)| Column::new(corner).unit().transpose());
    let unit = unit.transpose()?;
    let counted = unit.is_none()
        && above.is_none_or(|step| index(start, step))
        && beside.is_none_or(|step| index(places.first(), step));
    let skip = first * n;
    let mut values = block.values[skip..].to_vec();
    if beside.is_some() || above.is_some() && corner.is_some() {
        let mut at = (0..n).cycle();
        values.retain(|_| at.next() != Some(0));
        n -= 1;
    }
    let mut scan = matrix(values, n, header, options, false)?;
    if above.is_some_and(|step| step < 0.0) {
        mirror_columns(&mut scan.heights, n);
    }
    if beside.is_some_and(|step| step < 0.0) {
        mirror_rows(&mut scan.heights, n);
    }
    if scan.pixel_size.is_none() && !counted {
        let side = |axis: usize, step: Option<f64>| -> Result<Option<Distance>, TopographyError> {
            let Some(step) = step else { return Ok(None) };
            let unit =
                agree("units", options.lateral(axis), unit.or(header.lateral(axis, options)?))?;
            let missing = || no_unit(format!("the table from line {}", block.line), "its axis");
            Ok(Some(Distance { value: step.abs(), unit: Some(unit.ok_or_else(missing)?) }))
        };
        let sides = [side(0, above)?, side(1, beside)?];
        scan.pixel_size = match sides {
            [Some(x), Some(y)] => Some([x, y]),
            _ => None,
        };
    }
    Ok(scan)
}

/// A row of heights to a line; a single column is a profile.
fn matrix(
    values: Vec<f64>,
    columns: usize,
    header: &Header,
    options: &ReadOptions,
    sized: bool,
) -> Result<Scan, TopographyError> {
    let n = values.len();
    let columns = if columns == 1 { n } else { columns };
    let mut counts = [columns, n / columns];
    points(counts[0] as u64, counts[1] as u64)?;
    let mut heights = values;
    if header.by_columns() {
        heights = (0..n).map(|at| heights[at % counts[1] * columns + at / counts[1]]).collect();
        counts.reverse();
    }
    if header.downwards() {
        mirror_rows(&mut heights, counts[0]);
    }
    if sized {
        header.check(counts)?;
    }
    let pixel_size = header.pixel_size(counts, options)?;
    Ok(Scan { heights, columns: counts[0], pixel_size, ..Scan::default() })
}

/// Points of a grid, or a profile.
fn positions(
    block: Block,
    columns: [Option<usize>; 4],
    names: &[Column],
    header: &Header,
    options: &ReadOptions,
) -> Result<Scan, TopographyError> {
    let [x, y, z, valid] = columns;
    let of = |at: Option<usize>| at.map(|at| names[at].unit()).transpose().map(Option::flatten);
    let unit = of(z)?;
    let side = |axis: usize, at: Option<usize>| agree("units", options.lateral(axis), of(at)?);
    let n = block.columns;
    let height = |row: &[f64]| match valid {
        Some(valid) if row[valid] == 0.0 => f64::NAN,
        _ => row[z.unwrap_or_default()],
    };
    let rows = block.values.chunks(n);
    let scan = match (x, y) {
        (Some(x), Some(y)) => {
            let values = rows.flat_map(|row| [row[x], row[y], height(row)]).collect();
            let (heights, columns, steps) = grid(values)?;
            let units = [side(0, Some(x))?, side(1, Some(y))?];
            if units.iter().flatten().count() == 1 {
                let found = "a unit over one of the columns x and y";
                return Err(refuse("header", found, "units over both or over neither"));
            }
            let [x, y] = [0, 1].map(|axis| Distance { value: steps[axis], unit: units[axis] });
            Scan { heights, columns, pixel_size: Some([x, y]), ..Scan::default() }
        }
        (Some(at), None) | (None, Some(at)) => {
            let (places, heights) = rows.map(|row| (row[at], height(row))).unzip();
            let (scan, step) = profile(places, heights)?;
            let size = Distance { value: step, unit: side(0, Some(at))? };
            Scan { pixel_size: Some([size; 2]), ..scan }
        }
        (None, None) => matrix(rows.map(height).collect(), 1, header, options, false)?,
    };
    Ok(Scan { unit, ..scan })
}
