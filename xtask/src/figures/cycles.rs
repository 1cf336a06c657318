//! Loading, and unloading by three laws from three separations; cycles of tangential force, and the
//! energy dissipated in one.

use anyhow::{Error, Result};
use asperity::joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity::{At, Model, Quantity, Separation, Tolerance, linspace};
use asperity_plot::{Axis, Figure, Mark};

use super::models::{self, TOLERANCE, beside, geometric, named, of, panel, separation_axis, solve};
use crate::table::Table;

/// KE's joint of the paper's scene, closed to a separation or a pressure.
fn closed(at: impl Into<At>, law: UnloadingLaw) -> Result<Unloading> {
    let (model, scene): (Model, _) = ("ke".parse()?, models::scene(1e-6)?);
    Ok(Unloading::new(&model, &scene, at.into(), law, Tolerance::new(TOLERANCE)?)?)
}

/// Closest approaches over σ_z.
const CLOSEST: [f64; 3] = [0.0, 0.5, 1.0];
/// Loading, then the laws, with their looks.
const BRANCHES: [(&str, usize); 4] = [("loading", 0), ("hertz", 2), ("brake", 3), ("etsion", 1)];

/// Force and area of the paper's scene, with gaps between the branches.
pub fn unloading() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let sigma = scene.surface.asperity_height_std;
    let mut table = Table::new(&["curve", "separation_m", "force_N", "area_m2"]);
    let separations = linspace(-0.1, 3.0, 156);
    let quantities = [Quantity::Force, Quantity::Area];
    let closing = solve("ke", &scene, &quantities, separations.iter().copied())?;
    let [force, area] = quantities.map(|quantity| closing.values(quantity));
    for ((s, force), area) in separations.iter().zip(force?).zip(area?) {
        table.push(&["loading"], [s * sigma, force, area])?;
    }
    for (name, _) in &BRANCHES[1..] {
        let law: UnloadingLaw = name.parse().map_err(Error::msg)?;
        for (k, closest) in CLOSEST.into_iter().enumerate() {
            if k > 0 {
                table.push(&[name], [None::<f64>; 3])?;
            }
            let joint = closed(Separation::sigmas(closest), law)?;
            for retreat in linspace(0.0, 2.0 * sigma, 121) {
                // The fit of the area by etsion is not drawn.
                let area = match law {
                    UnloadingLaw::Etsion => None,
                    _ => Some(joint.area(retreat)?.value()),
                };
                let (at, force) = (closest * sigma + retreat, joint.force(retreat)?.value());
                table.push(&[name], [Some(at), Some(force), area])?;
            }
        }
    }
    Ok(table)
}

/// The picture of [`unloading`]: force and area side by side.
pub fn unloading_figure(_: &str) -> Result<Figure> {
    let x = separation_axis().range(-0.1e-6, 2.5e-6);
    let force = panel(&x, Axis::new("force_N", "contact force F (N)"), &named(&BRANCHES));
    let area = Axis::new("area_m2", "contact area A (mm²)").times(1e6);
    let area = panel(&x, area, &named(&BRANCHES[..3]));
    Ok(beside(2, [force, area]))
}

const FRICTION: f64 = 0.3;
/// Pressures of the losses \[Pa\] with their curves; the loops are at the second.
const PRESSURES: [f64; 3] = [1e6, 5e6, 25e6];
const LOSSES: [(&str, usize); 3] = [("1 MPa", 4), ("5 MPa", 6), ("25 MPa", 8)];
/// Amplitudes of the loops \[m\].
const AMPLITUDES: [f64; 3] = [50e-9, 100e-9, 200e-9];
/// First shift, and the loops.
const LOOPS: [(&str, usize); 4] = [("virgin", 0), ("50 nm", 1), ("100 nm", 2), ("200 nm", 3)];

fn joint(pressure: f64) -> Result<PartialSlip> {
    Ok(PartialSlip::new(&closed(At::Pressure(pressure), UnloadingLaw::Hertz)?, FRICTION)?)
}

/// Rows of the loops, then rows of the losses.
pub fn slip() -> Result<Table> {
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

/// The picture of [`slip`]: loops and losses side by side.
pub fn slip_figure(_: &str) -> Result<Figure> {
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
