//! Cycles of one amplitude at several preloads.

use std::cmp::Ordering;

use anyhow::Result;
use asperity::{At, ContactError, Model};
use asperity_plot::{Axis, Curve, Scale};

use super::slip::{SLIDING, Slip, check_amplitude};
use crate::joints::{given_preload, preload};
use crate::output::plot;
use crate::output::print_message;
use crate::output::table::{Cell, Table};
use crate::scene::{LoadedScene, NamedModel};

impl Slip {
    /// A cycle of the amplitude at each of several preloads; the row of one that fails is blank.
    pub(super) fn preloads(
        &self,
        scene: &LoadedScene,
        named: &NamedModel,
        places: &[At],
        amplitude: f64,
    ) -> Result<()> {
        let (id, model) = (&*named.0, &named.1);
        let head = ["model", "load_N", "pressure_Pa", "separation_over_sigma"];
        let cycle = ["force_N", "secant_stiffness_N_per_m", "loss_J", "loss_factor", "sliding_m"];
        let mut table = Table::new(&[&head[..], &cycle[..]].concat());
        let (mut farthest, mut left_out) = (0.0_f64, vec![]);
        for place in places {
            let numbers = match self.cycle(scene, model, *place, amplitude) {
                Ok(numbers) => {
                    farthest = farthest.max(numbers[7]);
                    numbers.map(Some)
                }
                Err(error) => {
                    left_out.push(error);
                    let [load, pressure, separation] = given_preload(scene, *place);
                    [load, pressure, separation, None, None, None, None, None]
                }
            };
            let mut row = vec![Cell::from(id)];
            row.extend(numbers.map(Cell::Number));
            table.rows.push(row);
        }
        if let (true, Some(error)) = (left_out.len() == places.len(), left_out.first()) {
            return Err(error.clone().into());
        }
        for error in left_out {
            print_message(
                "warning",
                &format!("{}: {id}: the row of a preload is blank: {error}", scene.name),
            );
        }
        check_amplitude(scene, amplitude, farthest);
        self.output.write(&table, || picture(&table, id, amplitude))
    }

    /// Load, pressure, separation and the results of the cycle.
    fn cycle(
        &self,
        scene: &LoadedScene,
        model: &Model,
        place: At,
        amplitude: f64,
    ) -> Result<[f64; 8], ContactError> {
        let (joint, slip) = self.joint(scene, model, place)?;
        let [load, pressure, separation] = preload(scene, place, &joint)?;
        let (force, loss) = (slip.force(amplitude)?, slip.loss(amplitude)?);
        let results = [
            force.value(),
            force.value() / amplitude,
            loss.value(),
            slip.loss_factor(amplitude)?,
            slip.shift_at(SLIDING)?,
        ];
        let [force, stiffness, loss, factor, sliding] = results.map(|x| self.digits(x));
        Ok([load, pressure, separation, force, stiffness, loss, factor, sliding])
    }
}

/// The plot of cycles against the loads.
fn picture(table: &Table, id: &str, amplitude: f64) -> Result<String> {
    let load = plot::place(table, "load_N")?;
    let load = |row: &[Cell]| row[load].number();
    let mut x = Axis::new("load_N", "load (N)");
    x.scale = Scale::fitting(&table.rows.iter().filter_map(|row| load(row)).collect::<Vec<_>>());
    let columns = [
        ("secant_stiffness_N_per_m", "secant stiffness (N/m)"),
        ("loss_J", "energy dissipated per cycle (J)"),
        ("loss_factor", "loss factor"),
    ];
    let what = format!("{id}, cycles of ±{amplitude:e} m");
    let mut curve = Curve::new(0, id, &what);
    curve.every_point = table.rows.len() <= plot::MARKED;
    // Lines run from left to right for any order of the rows.
    let mut sorted = table.clone();
    sorted.rows.sort_by(|a, b| load(a).partial_cmp(&load(b)).unwrap_or(Ordering::Equal));
    plot::against(&sorted, &x, &columns, &[curve])
}
