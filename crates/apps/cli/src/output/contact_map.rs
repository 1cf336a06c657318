//! Maps of the contact pressure, of the flow through the gap and of stick and slip, drawn or as
//! matrices of numbers.

use std::path::Path;

use anyhow::Result;
use asperity::bem::{Bem, BemError, BoundaryElements, Direction, Solution};
use asperity_answer::rounded;
use asperity_plot::{Map, legible};

use crate::output;

/// The map of a contact; `hardness` where there is one, and the tightest gaps of `leaks`.
pub fn picture(
    bem: &Bem,
    solution: &Solution,
    hardness: Option<f64>,
    leaks: Option<&BoundaryElements>,
    name: &str,
) -> Result<Map, BemError> {
    let mut caption = vec![format!(
        "{:.3} % of the area is in contact, in {} patches, under a mean pressure of {}; mean gap {}.",
        100.0 * solution.area,
        solution.patches.len(),
        said(solution.mean_pressure, "Pa"),
        said(solution.mean_gap, "m"),
    )];
    if let Some(hardness) = hardness {
        caption.push(format!(
            "Black is plastic: {:.3} % of the area carries the hardness, {}.",
            100.0 * solution.plastic_area,
            said(hardness, "Pa"),
        ));
    }
    let ([rows, columns], mut marks) = (bem.map().shape(), vec![]);
    for (elements, along) in leaks.iter().flat_map(|of| Direction::ALL.map(|along| (of, along))) {
        if let Some((gap, at)) = elements.tightest_gap(solution, along)? {
            let centre = |k: usize, count: usize| (k as f64 + 0.5) / count as f64;
            marks.push((
                along.to_string(),
                [centre(at % columns, columns), centre(at / columns, rows)],
            ));
            let gap = said(gap, "m");
            caption.push(format!(
                "Square {along}: the tightest gap of the widest path along {along}, {gap}."
            ));
        }
    }
    Ok(Map {
        marks,
        title: format!("Contact pressure on {name}"),
        caption,
        white: "white: no contact".into(),
        ..Map::of_pressures(&solution.pressures, bem.map().shape(), bem.map().pixel(), hardness)
    })
}

/// The map of the flow along x through the gap of a contact; contacts have a colour of their own.
pub fn flow(
    bem: &Bem,
    elements: &BoundaryElements,
    solution: &Solution,
    name: &str,
) -> Result<Map, BemError> {
    let gap = elements.hydraulic_gap(solution, Direction::X)?;
    let passes = match gap > 0.0 {
        true => format!("the hydraulic gap is {}", said(gap, "m")),
        false => "no open path of pixels leads from side to side".into(),
    };
    let flux = elements.flux(solution, Direction::X)?;
    Ok(Map {
        title: format!("Flow from left to right through the gap of {name}"),
        caption: vec![format!(
            "{:.3} % of the area is in contact; {passes}.",
            100.0 * solution.area
        )],
        white: "white: no flow".into(),
        ..Map::of_flow(flux, bem.map().shape(), bem.map().pixel())
            .with_contacts(&solution.pressures)
    })
}

/// The map of a contact that slips: 1 where a pixel slips, 2 where it sticks.
pub fn stick_picture(bem: &Bem, states: &[f64], name: &str) -> Map {
    Map {
        title: format!("Stick and slip on {name}"),
        label: "1: slips".into(),
        top: 2.0,
        white: "white: no contact".into(),
        full: "2: sticks".into(),
        ..Map::of_pixels(states.to_vec(), bem.map().shape(), bem.map().pixel())
    }
}

/// A number in a legible unit.
fn said(value: f64, unit: &str) -> String {
    let (factor, unit) = legible(value, unit);
    format!("{} {unit}", rounded(value / factor))
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
