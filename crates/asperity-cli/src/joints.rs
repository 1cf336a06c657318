//! What `unload`, `slip` and their variants share.

use anyhow::{Result, bail};
use asperity::joints::{EnergyGain, Joint, PartialSlip, Unloading, Work};
use asperity::{At, ContactError, SeparationUnit, shortest_digits};
use asperity_plot::{Axis, Curve};

use crate::output::number::rounded;
use crate::output::plot;
use crate::output::table::{Cell, Table};
use crate::scene::{LoadedScene, NamedModel};

/// The reason for values of 0.
pub const READ_0: &str =
    "are 0: they are below the smallest f64, and far fewer than one asperity touches";

/// The end of the reason against a tangential force that is too large.
pub const SLIDES: &str = "the joint slides";

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
    scene.report(gain.iter().map(EnergyGain::finding).collect());
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

/// The amplitude of shift under an amplitude of the tangential force.
pub fn amplitude_at(slip: &PartialSlip, force: f64) -> Result<f64> {
    slip.amplitude_at(force).or_else(|error| {
        let ContactError::OutOfRange { field: "tangential_force", .. } = error else {
            return Err(error.into());
        };
        let limit = slip.limit()?;
        let digits = [force, limit].map(rounded);
        // Forces that differ in later digits only.
        let equal = digits[0] == digits[1];
        let ten = |x: f64| shortest_digits(format!("{x:.9e}").parse().unwrap_or(x));
        let [shown, of] = if equal { [force, limit].map(ten) } else { digits };
        match force < limit {
            true => bail!(
                "a tangential force of {shown} N is within the tolerance of mu F = {of} N: {SLIDES}"
            ),
            false => bail!("a tangential force of {shown} N is not below mu F = {of} N: {SLIDES}"),
        }
    })
}

/// Load, pressure and separation of a preload, of those that are given.
pub fn given_preload(scene: &LoadedScene, place: At) -> [Option<f64>; 3] {
    let (contact, from) = (&scene.file.scene, scene.file.separation_from);
    match place {
        At::Separation(closest) => {
            let closest = closest.measured_in(SeparationUnit::Sigma, from, contact);
            [None, None, closest.ok().map(|closest| closest.value)]
        }
        at => [at.load(contact), at.pressure(contact), None],
    }
}

/// Load, pressure and separation of a preload: what is given is printed with its own digits.
pub fn preload(
    scene: &LoadedScene,
    place: At,
    joint: &Unloading,
) -> Result<[f64; 3], ContactError> {
    let (contact, from) = (&scene.file.scene, scene.file.separation_from);
    let [load, pressure, separation] = given_preload(scene, place);
    let load = load.map_or_else(|| joint.force(0.0).map(|force| force.value()), Ok)?;
    let closest = joint.closest().measured_in(SeparationUnit::Sigma, from, contact)?;
    Ok([load, pressure.unwrap_or(load / contact.nominal_area), separation.unwrap_or(closest.value)])
}
