//! Curves as a picture, drawn from the printed table alone.

use anyhow::{Context, Result, ensure};
use asperity::fit::DataColumn;
use asperity::{At, Datum, Quantity, Request, SeparationUnit};
use asperity_answer::{Cell, Sheet};
use asperity_plot::{Axis, Curve, Figure, MEASURED, Panel, Scale, draw, look_of};

use crate::output::once;
use crate::output::table::csv;

/// Up to this many points of a curve, each has a marker; above, a few markers identify the curve.
pub const MARKED: usize = 12;

/// The name of measured points in legends.
const POINTS: &str = "measured";
/// Columns of places, beside that of the request: an axis may show them for measured points.
const PLACES: [(&str, &str, f64); 5] = [
    ("load_N", "load (N)", 1.0),
    ("pressure_Pa", "pressure (Pa)", 1.0),
    ("film_m", "film (µm)", 1e6),
    ("lambda", "film (σ)", 1.0),
    ("separation_m", "separation (µm)", 1e6),
];

/// The picture of a table's quantities against the load or separation, one panel for each, with
/// `measured` points of the quantities that they have.
pub fn svg(
    table: &Sheet,
    request: &Request,
    from: Datum,
    measured: &[DataColumn],
) -> Result<String> {
    let mut x = axis(table, request, from);
    if !measured.is_empty() && !has(measured, &x.column) {
        x = axis_of(table, request, measured)?;
    }
    let along = numbers(table, &x.column)?;
    if !is_even(&along) {
        x.scale = Scale::fitting(&along);
    }
    let curves = curves(table, |k, id| Curve::new(look_of(id).unwrap_or(k), id, id));

    let (mut panels, mut hidden, mut any) = (vec![], vec![], false);
    for &quantity in &request.quantities {
        let name = quantity.column();
        let mut y = Axis::new(&name, &label(quantity));
        if !quantity.is_absolute() {
            y.scale = Scale::fitting(&numbers(table, &name)?);
        }
        if y.scale == Scale::Log {
            let k = place(table, &name)?;
            let low = |row: &&Vec<Cell>| row[k].number().is_some_and(|y| y <= 0.0);
            let low = table.rows.iter().filter(low);
            hidden.extend(low.map(|row| format!("{quantity} of {}", row[0].text())));
        }
        let mut panel = Panel::new(x.clone(), y);
        panel.curve_column = "model".into();
        panel.curves.clone_from(&curves);
        if has(measured, &name) {
            any = true;
            panel.curves.push(Curve::points(MEASURED, POINTS, POINTS));
        }
        panels.push(panel);
    }
    ensure!(
        any || measured.is_empty(),
        "--data: the file has none of the plotted columns: {}",
        request.quantities.iter().map(|q| q.column()).collect::<Vec<_>>().join(", ")
    );
    // A line runs from left to right for any order of the rows.
    let mut sorted = table.clone();
    for row in 0..measured.first().map_or(0, |(_, values)| values.len()) {
        let value = |head: &String| measured.iter().find(|(name, _)| name == head)?.1[row];
        let cell = |head: &String| match head.as_str() {
            "model" => POINTS.into(),
            _ => value(head).map_or(Cell::BLANK, Cell::Number),
        };
        sorted.rows.push(table.heads.iter().map(cell).collect());
    }
    put_in_order(&mut sorted, place(table, &x.column)?);
    let mut figure = Figure::new("", &[], panels);
    if !hidden.is_empty() {
        let which = once(&hidden).join(", ");
        figure.caption.push(format!("Values of 0 and below are not on logarithmic axes: {which}."));
    }
    drawn(&sorted, &figure)
}

/// The horizontal axis that a request has.
fn axis(table: &Sheet, request: &Request, from: Datum) -> Axis {
    match request.at.first() {
        Some(At::Load(_)) => Axis::new("load_N", "load (N)"),
        Some(At::Pressure(_)) => Axis::new("pressure_Pa", "pressure (Pa)"),
        Some(At::Separation(s)) if s.unit == SeparationUnit::SurfaceStd => {
            Axis::new("lambda", "film (σ)")
        }
        Some(At::Separation(_)) if table.column("film_m").is_some() => {
            Axis::new("film_m", "film (µm)").times(1e6)
        }
        Some(At::Separation(s)) if s.unit == SeparationUnit::Metres => {
            Axis::new("separation_m", &format!("separation from {from} (µm)")).times(1e6)
        }
        _ => Axis::new("separation_over_sigma", &format!("separation from {from} (σ_z)")),
    }
}

/// The horizontal axis of places that the table and the measured points have.
fn axis_of(table: &Sheet, request: &Request, measured: &[DataColumn]) -> Result<Axis> {
    let is_drawn = |name: &str| request.quantities.iter().any(|drawn| drawn.column() == name);
    let known = || {
        let has = |name: &str| table.column(name).is_some() && !is_drawn(name);
        PLACES.into_iter().filter(move |(name, ..)| has(name))
    };
    let names = || known().map(|(name, ..)| name).collect::<Vec<_>>().join(", ");
    let found = known().find(|(name, ..)| has(measured, name));
    let (name, label, factor) =
        found.with_context(|| format!("--data: the file has none of the columns {}", names()))?;
    Ok(Axis::new(name, label).times(factor))
}

fn has(measured: &[DataColumn], column: &str) -> bool {
    measured.iter().any(|(name, _)| name == column)
}

/// The names in the first column, each once.
pub fn names(table: &Sheet) -> Vec<String> {
    once(&table.rows.iter().map(|row| row[0].text().to_string()).collect::<Vec<_>>())
}

/// A curve for each name in the first column; in a short table every point has a marker.
pub fn curves(table: &Sheet, mut curve: impl FnMut(usize, &str) -> Curve) -> Vec<Curve> {
    let names = names(table);
    let few = table.rows.len() <= MARKED * names.len();
    let mut curves: Vec<Curve> =
        names.iter().enumerate().map(|(look, name)| curve(look, name)).collect();
    curves.iter_mut().for_each(|curve| curve.every_point = few);
    curves
}

/// A figure of the rows of a table.
pub fn drawn(table: &Sheet, figure: &Figure) -> Result<String> {
    let mut text = vec![];
    csv(table, &mut text)?;
    Ok(draw(figure, &String::from_utf8(text)?)?)
}

/// The picture of some columns against one, with a panel for each that the table has and a curve
/// for each name in the first column. Over a logarithmic axis, columns that span decades have one
/// as well.
pub fn against(
    table: &Sheet,
    x: &Axis,
    columns: &[(&str, &str)],
    curves: &[Curve],
) -> Result<String> {
    drawn(table, &Figure::new("", &[], panels(table, x, columns, curves)?))
}

/// The panels of [`against`].
pub fn panels(
    table: &Sheet,
    x: &Axis,
    columns: &[(&str, &str)],
    curves: &[Curve],
) -> Result<Vec<Panel>> {
    let mut panels = vec![];
    for (column, label) in columns.iter().filter(|(c, _)| table.column(c).is_some()) {
        let mut y = Axis::new(column, label);
        if x.scale == Scale::Log {
            y.scale = Scale::fitting(&numbers(table, column)?);
        }
        let mut panel = Panel::new(x.clone(), y);
        panel.curve_column.clone_from(&table.heads[0]);
        panel.curves = curves.to_vec();
        panels.push(panel);
    }
    Ok(panels)
}

/// The axis with the scale that fits its column; the rows are put in order, as lines run from left
/// to right.
pub fn fitted(sheet: &mut Sheet, mut axis: Axis) -> Axis {
    if let Some(k) = sheet.column(&axis.column) {
        put_in_order(sheet, k);
        let values = sheet.rows.iter().filter_map(|row| row[k].number());
        axis.scale = Scale::fitting(&values.collect::<Vec<_>>());
    }
    axis
}

fn put_in_order(sheet: &mut Sheet, column: usize) {
    let at = |row: &Vec<Cell>| row[column].number().unwrap_or(f64::NAN);
    sheet.rows.sort_by(|a, b| at(a).total_cmp(&at(b)));
}

/// The place of a column.
pub fn place(table: &Sheet, name: &str) -> Result<usize> {
    table.column(name).with_context(|| format!("the table has no column {name}"))
}

fn numbers(table: &Sheet, name: &str) -> Result<Vec<f64>> {
    let k = place(table, name)?;
    Ok(table.rows.iter().filter_map(|row| row[k].number()).collect())
}

/// Whether numbers follow each other in equal steps, as in A:B:N.
fn is_even(values: &[f64]) -> bool {
    let steps = || values.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
    let (low, high) = (steps().fold(f64::INFINITY, f64::min), steps().fold(0.0, f64::max));
    values.len() > 2 && high <= 1.001 * low
}

/// The label of an axis, with the unit of the numbers.
pub fn label(quantity: Quantity) -> String {
    let name = quantity.label();
    match quantity.unit().trim_start_matches("ln ").replace("m2", "m²") {
        none if none.is_empty() => name.into(),
        unit if quantity.is_absolute() => format!("{name} (of {unit})"),
        unit => format!("{name} ({unit})"),
    }
}

#[cfg(test)]
mod tests {
    use asperity::{Described, Model};

    use super::*;

    /// Variants, too: by colour, dash and marker together.
    #[test]
    fn every_model_has_a_look_of_its_own() {
        let shown = |look: usize| (look % 10, (look + look / 10) % 10, look % 12);
        let looks: Vec<_> = Model::all().iter().map(|m| shown(look_of(m.id()).unwrap())).collect();
        for (k, look) in looks.iter().enumerate() {
            assert!(!looks[k + 1..].contains(look) && *look != shown(MEASURED), "{look:?}");
        }
    }
}
