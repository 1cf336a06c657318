//! A sheet as a picture, drawn from its csv alone.

use anyhow::{Context, Result};
use asperity::Quantity;
use asperity_answer::{Cell, Sheet, rounded};
use asperity_plot::{Axis, Curve, Figure, MEASURED, Panel, Scale, draw, look_of};

use crate::output::once;
use crate::output::table::csv;

/// Up to this many points of a curve, each has a marker; above, a few markers identify the curve.
const MARKED: usize = 12;
/// The first cell of rows with measured points, and their name in the legend.
pub const POINTS: &str = "measured";
/// The column of a drawn table that names the curve.
const CURVE: &str = "curve";
/// A column of rows that belong to the panel of one column alone.
pub const PANEL: &str = "panel";
/// Units at the end of the names of columns, which numerals and `per` join.
const UNITS: [&str; 9] = ["N", "m", "m2", "m3", "Pa", "W", "J", "K", "S"];

/// What a picture shows of a sheet.
#[derive(Debug, Clone)]
pub struct Plot {
    /// Columns whose cells name the curve of a row.
    pub curves: Vec<String>,
    /// The columns of the horizontal and of the vertical axis, for each panel.
    pub panels: Vec<[String; 2]>,
    /// The plane that separations are measured from, where they are.
    pub from: Option<&'static str>,
    /// Whether axes are linear whatever they span.
    pub is_linear: bool,
}

impl Plot {
    /// Some columns against one, in curves by the cells of others.
    pub fn new(curves: &[&str], x: &str, columns: &[&str]) -> Self {
        let panels = columns.iter().map(|y| [x.into(), (*y).into()]).collect();
        let curves = curves.iter().map(|name| (*name).into()).collect();
        Self { curves, panels, from: None, is_linear: false }
    }

    /// The same with separations from this plane.
    pub fn from(self, plane: &'static str) -> Self {
        Self { from: Some(plane), ..self }
    }

    /// The picture: a panel for each pair of columns that the sheet has. The rows of a curve are
    /// joined from left to right or, where the sheet counts the ways of a path, in their order.
    pub fn svg(&self, sheet: &Sheet) -> Result<String> {
        let named = self.curves.iter().filter_map(|name| sheet.column(name)).collect::<Vec<_>>();
        let mut drawn = sheet.clone();
        drawn.heads.insert(0, CURVE.into());
        for row in &mut drawn.rows {
            let name = curve_name(&sheet.heads, &named, row);
            row.insert(0, name.as_str().into());
        }
        let has = |name: &String| sheet.column(name).is_some();
        let shown = self.panels.iter().filter(|[x, y]| has(x) && has(y));
        let shown: Vec<[&String; 2]> = shown.map(|[x, y]| [x, y]).collect();
        let is_path = sheet.column("way").is_some();
        let curves = curves(&drawn);
        let (mut panels, mut hidden) = (vec![], vec![]);
        for [x, y] in &shown {
            let points = points(&drawn, x, y)?;
            let mut across = axis(x, self.from);
            let along: Vec<f64> = points.iter().map(|(_, x, _)| *x).collect();
            if !is_path && !self.is_linear && !is_even(&along) {
                across.scale = Scale::fitting(&along);
            }
            let mut up = axis(y, self.from);
            let quantity = Quantity::ALL.into_iter().find(|known| known.column() == **y);
            let low: Vec<&str> =
                points.iter().filter(|(.., y)| *y <= 0.0).map(|(curve, ..)| *curve).collect();
            // Loops have as many values on either side of 0.
            let is_wide = !self.is_linear && !quantity.is_some_and(Quantity::is_absolute);
            if is_wide && 4 * low.len() < points.len() {
                up.scale = Scale::fitting(&points.iter().map(|(.., y)| *y).collect::<Vec<_>>());
            }
            if up.scale == Scale::Log {
                let name = quantity.map_or(unit_of(y).0, |quantity| quantity.to_string());
                hidden.extend(low.iter().map(|curve| format!("{name} of {curve}")));
            }
            let mut panel = Panel::new(across, up);
            panel.only = sheet.column(PANEL).map(|_| (PANEL.into(), y.to_string()));
            panel.curve_column = CURVE.into();
            panel.curves.clone_from(&curves);
            panels.push(panel);
        }
        let mut figure = Figure::new("", &[], panels);
        if !hidden.is_empty() {
            let which = once(&hidden).join(", ");
            let text = format!("Values of 0 and below are not on logarithmic axes: {which}.");
            figure.caption.push(text);
        }
        for [x, _] in shown.iter().filter(|_| !is_path) {
            let column = place(&drawn, x)?;
            let at = |row: &Vec<Cell>| row[column].number().unwrap_or(f64::NAN);
            drawn.rows.sort_by(|a, b| at(a).total_cmp(&at(b)));
        }
        let mut text = vec![];
        csv(&drawn, &mut text)?;
        Ok(draw(&figure, &String::from_utf8(text)?)?)
    }
}

/// The name of a row's curve: `ke`, `ke, law: hertz`, `ke, load: 100 N`.
fn curve_name(heads: &[String], named: &[usize], row: &[Cell]) -> String {
    let mut name = String::new();
    for &k in named {
        let (head, unit) = unit_of(&heads[k]);
        let text = match &row[k] {
            Cell::Number(value) => format!("{} {unit}", rounded(*value)),
            cell => cell.text().to_string(),
        };
        match (name.is_empty(), text.is_empty()) {
            (true, _) => name = text,
            (_, true) => {}
            _ => name += &format!(", {head}: {}", text.trim_end()),
        }
    }
    name
}

/// A curve for each name, with the look of the model of this name or one that none here has; in a
/// short table every point has a marker.
fn curves(drawn: &Sheet) -> Vec<Curve> {
    let names = once(&drawn.rows.iter().map(|row| row[0].text().to_string()).collect::<Vec<_>>());
    let looks: Vec<Option<usize>> = names.iter().map(|name| look_of(name)).collect();
    let mut others = (0..).filter(|look| !looks.contains(&Some(*look)));
    let few = drawn.rows.len() <= MARKED * names.len();
    let curve = |(name, look): (&String, &Option<usize>)| match name.as_str() {
        POINTS => Curve::points(MEASURED, name, name),
        _ => {
            let look = look.or_else(|| others.next()).unwrap_or_default();
            let mut curve = Curve::new(look, name, name);
            curve.every_point = few;
            curve
        }
    };
    names.iter().zip(&looks).map(curve).collect()
}

/// The values of two columns with the names of their curves, without measured points.
fn points<'s>(drawn: &'s Sheet, x: &str, y: &str) -> Result<Vec<(&'s str, f64, f64)>> {
    let [x, y] = [place(drawn, x)?, place(drawn, y)?];
    let rows = drawn.rows.iter().filter(|row| row[0].text() != POINTS);
    let point = |row: &'s Vec<Cell>| Some((row[0].text(), row[x].number()?, row[y].number()?));
    Ok(rows.filter_map(point).collect())
}

fn place(table: &Sheet, name: &str) -> Result<usize> {
    table.column(name).with_context(|| format!("the table has no column {name}"))
}

/// Whether numbers follow each other in equal steps, as in A:B:N.
fn is_even(values: &[f64]) -> bool {
    let steps = || values.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0);
    let (low, high) = (steps().fold(f64::INFINITY, f64::min), steps().fold(0.0, f64::max));
    values.len() > 2 && high <= 1.001 * low
}

/// The axis of a column, named with its unit; lengths are in µm.
fn axis(column: &str, from: Option<&str>) -> Axis {
    if let Some(quantity) = Quantity::ALL.into_iter().find(|known| known.column() == column) {
        return Axis::new(column, &label(quantity));
    }
    let (name, unit) = match column {
        "separation_over_sigma" => ("separation".into(), "σ_z".into()),
        "lambda" => ("film".into(), "σ".into()),
        _ => unit_of(column),
    };
    let name = match from.filter(|_| name == "separation") {
        Some(from) => format!("{name} from {from}"),
        None => name,
    };
    match unit.as_str() {
        "" => Axis::new(column, &name),
        "m" => Axis::new(column, &format!("{name} (µm)")).times(1e6),
        unit => Axis::new(column, &format!("{name} ({unit})")),
    }
}

/// The name of a column in words and its unit: `secant stiffness` and `N/m`.
fn unit_of(column: &str) -> (String, String) {
    let words: Vec<&str> = column.split('_').collect();
    let first = words.iter().position(|word| UNITS.contains(word)).unwrap_or(words.len());
    let first = if first > 0 && words[first - 1] == "per" { first - 1 } else { first };
    let unit = words[first..].join(" ");
    let (above, below) = unit.split_once("per ").unwrap_or((&unit, ""));
    let below = below.replace("per ", "");
    let above = if above.is_empty() && !below.is_empty() { "1" } else { above.trim_end() };
    let unit = match (below.is_empty(), below.contains(' ')) {
        (true, _) => above.to_string(),
        (_, true) => format!("{above}/({below})"),
        _ => format!("{above}/{below}"),
    };
    (words[..first].join(" "), unit.replace("m2", "m²").replace("m3", "m³"))
}

/// The label of an axis, with the unit of the numbers.
fn label(quantity: Quantity) -> String {
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

    #[test]
    fn columns_are_named_in_words_with_their_unit() {
        for (column, name, unit) in [
            ("secant_stiffness_N_per_m", "secant stiffness", "N/m"),
            ("loss_factor", "loss factor", ""),
            ("asperity_density_per_m2", "asperity density", "1/m²"),
            ("gas_conductance_per_area_W_per_m2_per_K", "gas conductance per area", "W/(m² K)"),
        ] {
            assert_eq!(unit_of(column), (name.into(), unit.into()));
        }
        assert_eq!(axis("retreat_m", None).label, "retreat (µm)");
    }
}
