//! Plots and messages shared by `unload` and its histories.

use anyhow::Result;
use asperity::joints::{EnergyGain, Joint, Work};
use asperity::{At, ContactError};
use asperity_plot::{Axis, Curve};

use crate::output::plot;
use crate::output::table::{Cell, Table};
use crate::scene::{LoadedScene, NamedModel};

/// The reason for values of 0.
pub const READ_0: &str =
    "are 0: they are below the smallest f64, and far fewer than one asperity touches";

/// The columns of plots, with their labels.
pub const COLUMNS: [(&str, &str); 3] =
    [("force_N", "force (N)"), ("area_m2", "area (m²)"), ("stiffness_N_per_m", "stiffness (N/m)")];

pub fn named(scene: &LoadedScene, (id, _): &NamedModel) -> String {
    format!("{}: {id}", scene.name)
}

/// Warns of a joint that creates energy when it is closed to a place and opened.
pub fn warn_energy_gain(
    scene: &LoadedScene,
    joint: &Joint,
    closest: At,
    work: &Work,
) -> Result<(), ContactError> {
    let gain = joint.energy_gain(closest, work)?;
    scene.report(gain.iter().map(EnergyGain::diagnostic).collect());
    Ok(())
}

/// A copy of a row that gets a marker in the plot.
pub fn marked(row: &[Cell]) -> Vec<Cell> {
    let mut row = row.to_vec();
    if let Cell::Text(law) = &row[1] {
        row[1] = Cell::from(&*marked_key(law));
    }
    row
}

fn marked_key(law: &str) -> String {
    format!("{law}, marked")
}

/// A curve for each law, with markers at the [`marked`] rows if there are any.
pub fn picture(table: &Table, x: &Axis, id: &str, joints: &[Joint]) -> Result<String> {
    let mut by_law = table.clone();
    // The law names the curve.
    by_law.head.remove(0);
    by_law.rows.iter_mut().for_each(|row| drop(row.remove(0)));
    let laws = joints.iter().map(|joint| joint.law().to_string());
    let curves: Vec<Curve> = laws
        .enumerate()
        .map(|(look, law)| {
            let mut curve = Curve::new(look, &law, &format!("{id}, back by {law}"));
            let key = marked_key(&law);
            let is_marked = by_law.rows.iter().any(|row| row[0] == Cell::from(&*key));
            curve.marked = is_marked.then_some(key);
            curve
        })
        .collect();
    plot::against(&by_law, x, &COLUMNS, &curves)
}
