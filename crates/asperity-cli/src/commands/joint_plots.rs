//! The plots of `asperity joint`, from its tables alone.

use anyhow::Result;
use asperity::{Datum, linspace};
use asperity_answer::{Cell, Sheet, once, rounded};
use asperity_plot::{Axis, Curve, look_of};

use crate::output::plot;

/// Least number of points of a curve.
const POINTS: usize = 202;
/// The columns of opening, with their labels.
const OPENING: [(&str, &str); 3] =
    [("force_N", "force (N)"), ("area_m2", "area (m²)"), ("stiffness_N_per_m", "stiffness (N/m)")];
/// The columns of cycles, with their labels.
const CYCLES: [(&str, &str); 3] = [
    ("secant_stiffness_N_per_m", "secant stiffness (N/m)"),
    ("loss_J", "energy dissipated per cycle (J)"),
    ("loss_factor", "loss factor"),
];

/// The retreats of a sheet, and as many between them as a smooth curve needs.
pub fn dense_retreats(sheet: &Sheet) -> Vec<f64> {
    let retreats: Vec<f64> = sheet.rows.iter().filter_map(|row| row[2].number()).collect();
    let [least, most] =
        [f64::min, f64::max].map(|pick| retreats.iter().copied().reduce(pick).unwrap_or_default());
    let mut dense = if least < most { linspace(least, most, POINTS) } else { vec![] };
    dense.extend(retreats);
    dense.sort_by(f64::total_cmp);
    dense.dedup();
    dense
}

/// Opening by each law: smooth curves, with markers at the rows of a short sheet.
pub fn opening(sheet: &Sheet, dense: &Sheet) -> Result<String> {
    let laws = laws(sheet);
    let mut drawn = dense.clone();
    if sheet.rows.len() <= plot::MARKED * laws.len() && laws != ["own"] {
        drawn.rows.extend(sheet.rows.iter().map(|row| marked(row)));
    }
    by_law(drawn, &laws, &Axis::new("retreat_m", "retreat (µm)").times(1e6))
}

/// The paths of a history by each law, with markers at the turning points.
pub fn history(sheet: &Sheet, from: Datum) -> Result<String> {
    let law = |row: &[Cell]| row[1].clone();
    let number = |row: &[Cell], k: usize| row[k].number().unwrap_or(f64::NAN);
    let mut drawn = Sheet { rows: vec![], ..sheet.clone() };
    for rows in sheet.rows.chunk_by(|one, next| law(one) == law(next)) {
        let (mut virgin, mut closest) = (true, f64::INFINITY);
        for (k, row) in rows.iter().enumerate() {
            let separation = number(row, 4);
            let was = std::mem::replace(&mut virgin, separation < closest);
            closest = closest.min(separation);
            // No line is drawn at jumps of the stiffness, where a path leaves or meets the virgin
            // curve.
            if let Some(k) = k.checked_sub(1).filter(|_| was != virgin) {
                let mut gap = rows[k].clone();
                gap[7] = Cell::BLANK;
                drawn.rows.push(gap);
            }
            drawn.rows.push(row.clone());
        }
        let turns = |k: &usize| rows.get(k + 1).is_none_or(|next| next[2] != rows[*k][2]);
        drawn.rows.extend((0..rows.len()).filter(turns).map(|k| marked(&rows[k])));
    }
    let x = Axis::new("separation_m", &format!("separation from {from} (µm)")).times(1e6);
    by_law(drawn, &laws(sheet), &x)
}

fn laws(sheet: &Sheet) -> Vec<String> {
    once(&sheet.rows.iter().map(|row| row[1].text().to_string()).collect::<Vec<_>>())
}

/// A copy of a row that gets a marker.
fn marked(row: &[Cell]) -> Vec<Cell> {
    let mut row = row.to_vec();
    row[1] = format!("{}, marked", row[1].text()).as_str().into();
    row
}

/// A curve for each law, with markers at the [`marked`] rows if there are any.
fn by_law(mut sheet: Sheet, laws: &[String], x: &Axis) -> Result<String> {
    let id = sheet.rows.first().map_or(String::new(), |row| row[0].text().into());
    // The law names the curve.
    sheet.heads.remove(0);
    sheet.rows.iter_mut().for_each(|row| drop(row.remove(0)));
    let curve = |(look, law): (usize, &String)| {
        let by = if law == "own" { String::new() } else { format!(" by {law}") };
        let mut curve = Curve::new(look, law, &format!("{id}, back{by}"));
        let key = format!("{law}, marked");
        let is_marked = sheet.rows.iter().any(|row| row[0].text() == key);
        curve.marked = is_marked.then_some(key);
        curve
    };
    let curves: Vec<Curve> = laws.iter().enumerate().map(curve).collect();
    plot::against(&sheet, x, &OPENING, &curves)
}

/// A loop, or cycles of this amplitude of shift or of tangential forces.
pub fn slip(sheet: &Sheet, amplitude: Option<f64>) -> Result<String> {
    match (sheet.column("shift_m"), amplitude) {
        (Some(_), _) => slip_loop(sheet),
        (None, Some(amplitude)) => {
            let name = |row: &[Cell]| row[0].text().to_string();
            let title = |id: &str| format!("{id}, cycles of ±{amplitude:e} m");
            cycles(sheet, ("load_N", "load (N)"), name, title)
        }
        (None, None) => {
            let load = |row: &[Cell]| row[1].number();
            let name = |row: &[Cell]| load(row).map_or("none".into(), |load| rounded(load) + " N");
            let x = ("tangential_force_N", "amplitude of the tangential force (N)");
            cycles(sheet, x, name, |name| format!("preload {name}"))
        }
    }
}

/// The plot of the first shift and the whole loop.
fn slip_loop(sheet: &Sheet) -> Result<String> {
    let mut long = Sheet::new(&["curve", "shift_m", "force_N"]);
    // The loop: forth from the left, back from the right.
    let forth = sheet.rows.iter().map(|row| ("loop", &row[1], &row[4]));
    let back = sheet.rows.iter().rev().map(|row| ("loop", &row[1], &row[3]));
    let first = sheet.rows.iter().map(|row| ("first", &row[1], &row[2]));
    for (curve, shift, force) in first.chain(forth).chain(back) {
        if force.number().is_some() {
            long.rows.push(vec![curve.into(), shift.clone(), force.clone()]);
        }
    }
    let x = Axis::new("shift_m", "shift (nm)").times(1e9);
    let curves = [Curve::new(0, "first", "first shift"), Curve::new(2, "loop", "steady cycle")];
    plot::against(&long, &x, &[("force_N", "tangential force (N)")], &curves)
}

/// The plot of cycles against their loads or forces, a curve for each name.
fn cycles(
    sheet: &Sheet,
    (column, label): (&str, &str),
    name: impl Fn(&[Cell]) -> String,
    title: impl Fn(&str) -> String,
) -> Result<String> {
    let mut long = sheet.clone();
    long.rows.iter_mut().for_each(|row| row[0] = name(row).as_str().into());
    let look = |k, name: &str| look_of(name).unwrap_or(k);
    let curves = plot::curves(&long, |k, name| Curve::new(look(k, name), name, &title(name)));
    let x = plot::fitted(&mut long, Axis::new(column, label));
    plot::against(&long, &x, &CYCLES, &curves)
}
