//! Cycles between amplitudes of the tangential force.

use anyhow::{Result, anyhow, bail};
use asperity::At;
use asperity::joints::PartialSlip;
use asperity_plot::{Axis, Curve, Scale};

use super::slip::Slip;
use crate::joints::{SLIDES, amplitude_at, given_preload, preload};
use crate::output::number::rounded;
use crate::output::plot;
use crate::output::print_message;
use crate::output::table::{Cell, Table};
use crate::scene::{LoadedScene, NamedModel};

impl Slip {
    /// A cycle of each amplitude of the tangential force at each preload; what slides is blank.
    pub(super) fn forces(
        &self,
        scene: &LoadedScene,
        (id, model): &NamedModel,
        places: &[At],
        forces: &[f64],
    ) -> Result<()> {
        let head = ["model", "load_N", "pressure_Pa", "separation_over_sigma"];
        let cycle = ["tangential_force_N", "amplitude_m", "secant_stiffness_N_per_m"];
        let mut table = Table::new(&[&head[..], &cycle[..], &["loss_J", "loss_factor"]].concat());
        let (mut reasons, mut answered) = (vec![], false);
        for place in places {
            let joint = self.joint(scene, model, *place);
            let before = match &joint {
                Ok((joint, _)) => preload(scene, *place, joint).ok().map(|known| known.map(Some)),
                Err(_) => None,
            };
            let before = before.unwrap_or_else(|| given_preload(scene, *place));
            let mut refused = vec![];
            for force in forces {
                let found = joint.as_ref().map_err(|error| anyhow!(error.clone()));
                let found = found.and_then(|(joint, slip)| {
                    self.under(preload(scene, *place, joint)?, slip, *force)
                });
                let numbers = found.map(|numbers| numbers.map(Some)).unwrap_or_else(|error| {
                    refused.push(error.to_string());
                    let [load, pressure, separation] = before;
                    [load, pressure, separation, Some(*force), None, None, None, None]
                });
                answered |= numbers[4].is_some();
                let mut row = vec![Cell::from(id.as_str())];
                row.extend(numbers.map(Cell::Number));
                table.rows.push(row);
            }
            // Forces that are too large are no reason for those that are too small.
            let slides = |reason: &String| reason.ends_with(SLIDES);
            let (large, small): (Vec<_>, Vec<_>) = refused.into_iter().partition(slides);
            for refused in [large, small] {
                let (count, all) = (refused.len(), forces.len());
                reasons.extend(refused.into_iter().next().map(|first| match count {
                    1 if all == 1 => first,
                    1 => format!("1 of {all} forces has no cycle: {first}"),
                    _ => format!("{count} of {all} forces have no cycle, first: {first}"),
                }));
            }
        }
        if !answered && !reasons.is_empty() {
            bail!("{}", reasons.join("; "));
        }
        for reason in reasons {
            print_message("warning", &format!("{}: {id}: {reason}", scene.name));
        }
        self.output.write(&table, || forces_picture(&table))
    }

    /// Load, pressure, separation and the results of a cycle of this tangential force.
    fn under(
        &self,
        [load, pressure, separation]: [f64; 3],
        slip: &PartialSlip,
        force: f64,
    ) -> Result<[f64; 8]> {
        let amplitude = amplitude_at(slip, force)?;
        let results = [
            amplitude,
            force / amplitude,
            slip.loss(amplitude)?.value(),
            slip.loss_factor(amplitude)?,
        ];
        let [amplitude, stiffness, loss, factor] = results.map(|x| self.digits(x));
        Ok([load, pressure, separation, force, amplitude, stiffness, loss, factor])
    }
}

/// The plot of cycles against their amplitudes of force, a curve for each preload.
fn forces_picture(table: &Table) -> Result<String> {
    let mut long = table.clone();
    long.head[0] = "preload".into();
    let of_row = |row: &[Cell]| row[1].number().map_or("none".into(), |load| rounded(load) + " N");
    let mut preloads: Vec<String> = vec![];
    for row in &mut long.rows {
        let name = of_row(row);
        row[0] = name.as_str().into();
        if !preloads.contains(&name) {
            preloads.push(name);
        }
    }
    let forces: Vec<f64> = long.rows.iter().filter_map(|row| row[4].number()).collect();
    let mut x = Axis::new("tangential_force_N", "amplitude of the tangential force (N)");
    x.scale = Scale::fitting(&forces);
    let columns = [
        ("secant_stiffness_N_per_m", "secant stiffness (N/m)"),
        ("loss_J", "energy dissipated per cycle (J)"),
        ("loss_factor", "loss factor"),
    ];
    let curve = |(name, k): (&String, usize)| {
        let mut curve = Curve::new(k, name, &format!("preload {name}"));
        curve.every_point = forces.len() <= plot::MARKED * preloads.len();
        curve
    };
    let curves: Vec<Curve> = preloads.iter().zip(0..).map(curve).collect();
    // Lines run from left to right for any order of the forces.
    let force = |row: &Vec<Cell>| row[4].number().unwrap_or(f64::NAN);
    long.rows.sort_by(|a, b| force(a).total_cmp(&force(b)));
    plot::against(&long, &x, &columns, &curves)
}
