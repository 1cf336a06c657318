//! Tangential force against shift in cycles, and the energy dissipated per cycle.

use anyhow::Result;
use asperity::joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity::{At, Model, Tolerance, linspace};
use asperity_plot::{Axis, Figure, Mark};

use super::models::{self, TOLERANCE, beside, geometric, named, of, panel};
use crate::table::Table;

const FRICTION: f64 = 0.3;
/// Pressures of the losses \[Pa\] with their curves; the loops are at the second.
const PRESSURES: [f64; 3] = [1e6, 5e6, 25e6];
const LOSSES: [(&str, usize, &str); 3] =
    [("1 MPa", 4, "loss at 1 MPa"), ("5 MPa", 6, "loss at 5 MPa"), ("25 MPa", 8, "loss at 25 MPa")];
/// Amplitudes of the loops \[m\].
const AMPLITUDES: [f64; 3] = [50e-9, 100e-9, 200e-9];
/// First shift, and the loops.
const LOOPS: [(&str, usize, &str); 4] = [
    ("virgin", 0, "first shift"),
    ("50 nm", 1, "cycles of ±50 nm"),
    ("100 nm", 2, "cycles of ±100 nm"),
    ("200 nm", 3, "cycles of ±200 nm"),
];

fn joint(pressure: f64) -> Result<PartialSlip> {
    let (model, scene): (Model, _) = ("ke".parse()?, models::scene(1e-6)?);
    let (at, tolerance) = (At::Pressure(pressure), Tolerance::new(TOLERANCE)?);
    let closed = Unloading::new(&model, &scene, at, UnloadingLaw::Hertz, tolerance)?;
    Ok(PartialSlip::new(&closed, FRICTION)?)
}

/// Rows of the loops, then rows of the losses.
pub fn table() -> Result<Table> {
    let mut table = Table::new(&["panel", "curve", "shift_m", "force_over_limit", "loss_J_per_m2"]);
    let (pressure, area) = (PRESSURES[1], models::NOMINAL_AREA);
    let (slip, limit) = (joint(pressure)?, FRICTION * pressure * area);
    let mut add = |key: &str, shift: f64, force: f64| {
        table.push(&["loops", key], [Some(shift), Some(force / limit), None])
    };
    for shift in linspace(0.0, 250e-9, 126) {
        add(LOOPS[0].0, shift, slip.force(shift)?.value())?;
    }
    for (amplitude, (key, ..)) in AMPLITUDES.iter().zip(&LOOPS[1..]) {
        let forth = linspace(-amplitude, *amplitude, 81);
        let back = forth.iter().rev().skip(1).map(|shift| (shift, false));
        for (shift, forward) in forth.iter().map(|shift| (shift, true)).chain(back) {
            add(key, *shift, slip.loop_force(*shift, *amplitude, forward)?)?;
        }
    }
    for (pressure, (key, ..)) in PRESSURES.into_iter().zip(LOSSES) {
        let slip = joint(pressure)?;
        for amplitude in geometric(1e-9, 10f64.powf(-5.5), 106) {
            let loss = slip.loss(amplitude)?.value() / area;
            table.push(&["loss", key], [Some(amplitude), None, Some(loss)])?;
        }
    }
    Ok(table)
}

/// Loops and losses side by side.
pub fn style(_: &str) -> Result<Figure> {
    let x = Axis::new("shift_m", "shift u (nm)").times(1e9).range(-220e-9, 250e-9);
    let y = Axis::new("force_over_limit", "tangential force Q/(µF)").range(-1.1, 1.1);
    let mut loops = of("panel", "loops", "loops at 5 MPa", panel(&x, y, &named(&LOOPS)));
    loops.horizontals = vec![Mark::new(0.0, "")];
    let x = Axis::new("shift_m", "amplitude D (nm)").times(1e9).log();
    let y = Axis::new("loss_J_per_m2", "loss per cycle W/A_n (J/m²)").log();
    let title = "energy dissipated per cycle";
    let losses = of("panel", "loss", title, panel(&x, y, &named(&LOSSES)));
    Ok(beside(2, [loops, losses]))
}
