//! Pressures as a matrix of numbers, and as a map.

use std::path::Path;

use anyhow::Result;
use asperity::bem::{Bem, BemError, BoundaryElements, Direction, Solution};
use asperity_answer::Sheet;
use asperity_plot::Map;

use crate::output;
use asperity_answer::rounded;

/// The map of the one contact of a sheet; `hardness` where there is one.
pub fn picture(
    bem: &Bem,
    pressures: &[f64],
    sheet: &Sheet,
    hardness: Option<f64>,
    name: &str,
) -> Map {
    let value = |column: &str| {
        let cell = sheet.column(column).and_then(|k| sheet.rows.first()?[k].number());
        cell.unwrap_or(f64::NAN)
    };
    let (depth, of_depth) = scaled(value("mean_gap_m").abs(), &LENGTHS);
    let top = hardness.unwrap_or_else(|| pressures.iter().copied().fold(0.0, f64::max));
    let (pressure, of_pressure) =
        scaled(top, &[(1.0, "Pa"), (1e3, "kPa"), (1e6, "MPa"), (1e9, "GPa")]);
    let mut caption = vec![format!(
        "{:.3} % of the area is in contact, in {} patches, under a mean pressure of {} {of_pressure}; mean gap {} {of_depth}.",
        100.0 * value("area_fraction"),
        value("patches"),
        rounded(value("pressure_Pa") / pressure),
        rounded(value("mean_gap_m") / depth),
    )];
    if hardness.is_some() {
        let hardness = rounded(top / pressure);
        caption.push(format!(
            "Black is plastic: {:.3} % of the area carries the hardness, {hardness} {of_pressure}.",
            100.0 * value("plastic_fraction"),
        ));
    }
    Map {
        title: format!("Contact pressure on {name}"),
        caption,
        values: pressures.iter().map(|p| p / pressure).collect(),
        label: format!("pressure ({of_pressure})"),
        top: top / pressure,
        white: "white: no contact".into(),
        ..outline(bem)
    }
}

/// The map of the flow along x through the gap of a contact; contacts have a colour of their own.
pub fn flow(
    bem: &Bem,
    elements: &BoundaryElements,
    solution: &Solution,
    name: &str,
) -> Result<Map, BemError> {
    let gap = elements.hydraulic_gap(solution, Direction::X)?;
    let values = elements.flux(solution, Direction::X)?;
    let mut order: Vec<f64> = values.iter().copied().filter(|flux| *flux > 0.0).collect();
    order.sort_unstable_by(f64::total_cmp);
    // Single constrictions have many times the flow of all others.
    let top = order.get(order.len() * 99 / 100).copied().unwrap_or(1.0);
    let shown = values.iter().zip(&solution.pressures).map(|(flux, pressure)| {
        match flux.min(DARKEST * top) {
            _ if *pressure > 0.0 => top,
            flux => flux,
        }
    });
    let (length, unit) = scaled(gap, &LENGTHS);
    let passes = match gap > 0.0 {
        true => format!("the hydraulic gap is {} {unit}", rounded(gap / length)),
        false => "no open path of pixels leads from side to side".into(),
    };
    let area = 100.0 * solution.area;
    Ok(Map {
        title: format!("Flow from left to right through the gap of {name}"),
        caption: vec![format!("{area:.3} % of the area is in contact; {passes}.")],
        values: shown.collect(),
        label: "flow per width, over its mean".into(),
        top,
        white: "white: no flow".into(),
        full: "contact".into(),
        ..outline(bem)
    })
}

/// The largest flow of a map over its top, which contacts have.
const DARKEST: f64 = 0.999;

/// Lengths of a map.
const LENGTHS: [(f64, &str); 4] = [(1e-9, "nm"), (1e-6, "µm"), (1e-3, "mm"), (1.0, "m")];

/// A map with the shape and size of a scan.
fn outline(bem: &Bem) -> Map {
    let [rows, columns] = bem.map().shape();
    let [dy, dx] = bem.map().pixel();
    let size = [columns as f64 * dx, rows as f64 * dy];
    let (length, unit) = scaled(size[0], &LENGTHS);
    Map { columns, size: size.map(|side| side / length), unit: unit.into(), ..Map::default() }
}

/// The map of a contact that slips: 1 where a pixel slips, 2 where it sticks.
pub fn stick_picture(bem: &Bem, states: &[f64], name: &str) -> Map {
    Map {
        title: format!("Stick and slip on {name}"),
        values: states.to_vec(),
        label: "1: slips".into(),
        top: 2.0,
        white: "white: no contact".into(),
        full: "2: sticks".into(),
        ..outline(bem)
    }
}

/// The unit in which a number is at least 1 and short.
fn scaled(value: f64, units: &[(f64, &'static str)]) -> (f64, &'static str) {
    units.iter().copied().rev().find(|(unit, _)| value >= *unit).unwrap_or(units[0])
}

/// A matrix, or a stack of them, as NumPy's `.npy`.
pub fn write(path: &Path, maps: &[&[f64]], [rows, columns]: [usize; 2]) -> Result<()> {
    let stack = if maps.len() == 1 { String::new() } else { format!("{}, ", maps.len()) };
    let shape = format!("({stack}{rows}, {columns})");
    let head = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}");
    // Magic, version, length and head end at a multiple of 64 bytes.
    let length = (10 + head.len() + 1).next_multiple_of(64) - 10;
    output::write(Some(path), |out| {
        out.write_all(b"\x93NUMPY\x01\x00")?;
        out.write_all(&(length as u16).to_le_bytes())?;
        writeln!(out, "{head:<0$}", length - 1)?;
        let mut numbers = maps.iter().copied().flatten();
        numbers.try_for_each(|number| out.write_all(&number.to_le_bytes()))
    })
}
