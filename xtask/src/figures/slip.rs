//! Tangential force against shift in cycles, and the energy dissipated per cycle.

use anyhow::Result;
use asperity::joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity::{At, Model, Tolerance, linspace};

use super::models::{self, INPUTS, MARKERS};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel};

const FRICTION: f64 = 0.3;
/// Pressures of the losses \[Pa\]; the loops are at the second.
const PRESSURES: [(f64, &str); 3] = [(1e6, "1 MPa"), (5e6, "5 MPa"), (25e6, "25 MPa")];
/// Amplitudes of the loops \[m\].
const AMPLITUDES: [(f64, &str); 3] = [(50e-9, "50 nm"), (100e-9, "100 nm"), (200e-9, "200 nm")];
const VIRGIN: &str = "virgin";

fn joint(pressure: f64) -> Result<PartialSlip> {
    let (model, scene): (Model, _) = ("ke".parse()?, models::scene(1e-6)?);
    let (at, tolerance) = (At::Pressure(pressure), Tolerance::new(1e-9)?);
    let closed = Unloading::new(&model, &scene, at, UnloadingLaw::Hertz, tolerance)?;
    Ok(PartialSlip::new(&closed, FRICTION)?)
}

/// Rows of the loops, then rows of the losses.
pub fn table() -> Result<Table> {
    let mut table = Table::new(&["panel", "curve", "shift_m", "force_over_limit", "loss_J_per_m2"]);
    let (pressure, area) = (PRESSURES[1].0, models::NOMINAL_AREA);
    let (slip, limit) = (joint(pressure)?, FRICTION * pressure * area);
    let mut add = |key: &str, shift: f64, force: f64| {
        let numbers = [Field::Number(shift), Field::Number(force / limit), Field::Gap];
        table.push(&[&[Field::Word("loops"), Field::Word(key)], &numbers[..]].concat())
    };
    for shift in linspace(0.0, 250e-9, 126) {
        add(VIRGIN, shift, slip.force(shift)?.value())?;
    }
    for (amplitude, key) in AMPLITUDES {
        let forth = linspace(-amplitude, amplitude, 81);
        for shift in forth.iter() {
            add(key, *shift, slip.loop_force(*shift, amplitude, true)?)?;
        }
        for shift in forth.iter().rev().skip(1) {
            add(key, *shift, slip.loop_force(*shift, amplitude, false)?)?;
        }
    }
    for (pressure, key) in PRESSURES {
        let slip = joint(pressure)?;
        for exponent in linspace(-9.0, -5.5, 106) {
            let amplitude = 10f64.powf(exponent);
            let loss = Field::Number(slip.loss(amplitude)?.value() / area);
            let place = [Field::Word("loss"), Field::Word(key), Field::Number(amplitude)];
            table.push(&[&place[..], &[Field::Gap, loss]].concat())?;
        }
    }
    Ok(table)
}

/// Loops and losses side by side.
pub fn style(_: &str) -> Result<Figure> {
    let shift = Axis::new("shift_m", "shift u (nm)").times(1e9).range(-220e-9, 250e-9);
    let mut loops = Panel::new(
        shift,
        Axis::new("force_over_limit", "tangential force Q/(µF)").range(-1.1, 1.1),
    );
    loops.title = format!("loops at {}", PRESSURES[1].1);
    loops.curves = vec![Curve::new(0, VIRGIN, "first shift")];
    let looped = AMPLITUDES.iter().zip([1, 2, 3]);
    loops
        .curves
        .extend(looped.map(|((_, key), look)| Curve::new(look, key, &format!("cycles of ±{key}"))));
    loops.horizontals = vec![Mark::new(0.0, "")];
    let amplitude = Axis::new("shift_m", "amplitude D (nm)").times(1e9).log();
    let mut losses =
        Panel::new(amplitude, Axis::new("loss_J_per_m2", "loss per cycle W/A_n (J/m²)").log());
    losses.title = "energy dissipated per cycle".into();
    losses.curves = PRESSURES
        .iter()
        .zip([4, 6, 8])
        .map(|((_, key), look)| Curve::new(look, key, &format!("loss at {key}")))
        .collect();
    for (panel, key) in [(&mut loops, "loops"), (&mut losses, "loss")] {
        panel.only = Some(("panel".into(), key.into()));
    }
    let caption = format!(
        "KE, loaded for the first time to a pressure and then shifted at constant separation, with µ\u{a0}=\u{a0}0.3 and asperities that unload by hertz: Q(u)\u{a0}=\u{a0}µ[F(0)\u{a0}-\u{a0}F(s)], s\u{a0}=\u{a0}4Gu/(µE); steady cycles by Masing's rule. The loss grows as D³ while only the rims of the contacts slip, and as 4µFD in gross slip. {INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm."
    );
    let title = "Partial slip: loops and dissipated energy";
    let mut figure = Figure::new(title, &[&caption, MARKERS], vec![loops, losses]);
    figure.columns = 2;
    Ok(figure)
}
