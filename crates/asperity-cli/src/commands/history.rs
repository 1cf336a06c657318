//! A joint that goes through a history of turning points: part of `asperity unload`.

use anyhow::{Context, Result};
use asperity::joints::Joint;
use asperity::{At, Separation, SeparationUnit};
use asperity_plot::Axis;

use crate::args::DrawnArgs;
use crate::commands::unload::{named, picture};
use crate::number::rounded;
use crate::output::say;
use crate::scene::{LoadedScene, NamedModel};
use crate::table::{Cell, Table};

/// Points on each way between turning points.
const STEPS: usize = 50;

/// Writes the ways through turning points, by each law; the work that they take is said.
pub fn write(
    scene: &LoadedScene,
    model: &NamedModel,
    joints: &[Joint],
    turns: &[At],
    output: &DrawnArgs,
) -> Result<()> {
    let (id, contact, from) = (&model.0, &scene.file.scene, scene.file.separation_from);
    let mut table = Table::new(&[
        "model",
        "law",
        "way",
        "separation_over_sigma",
        "separation_m",
        "force_N",
        "pressure_Pa",
        "stiffness_N_per_m",
    ]);
    // The stiffness jumps where a way leaves the virgin curve or meets it: no line is drawn there.
    let mut drawn = table.clone();
    for joint in joints {
        let (mut virgin, mut closest) = (true, f64::INFINITY);
        let points = joint.turning_points(turns);
        let path = points.and_then(|points| joint.path(&points, STEPS));
        let path = path.with_context(|| named(scene, model))?;
        for point in &path.points {
            let place = Separation::metres(point.separation);
            let place = |unit| place.measured_in(unit, from, contact).map(|found| found.value);
            let numbers = [
                point.way as f64,
                place(SeparationUnit::Sigma)?,
                place(SeparationUnit::Metres)?,
                point.force,
                point.force / contact.nominal_area,
                point.stiffness,
            ];
            let mut row = vec![Cell::from(&**id), Cell::from(&*joint.law().to_string())];
            row.extend(numbers.map(|x| Cell::Number(Some(x))));
            let was = std::mem::replace(&mut virgin, point.closest < closest);
            closest = point.closest;
            if let Some(last) = table.rows.last().filter(|_| was != virgin) {
                let mut gap = last.clone();
                gap[numbers.len() + 1] = Cell::Number(None);
                drawn.rows.push(gap);
            }
            drawn.rows.push(row.clone());
            table.rows.push(row);
        }
        let works: Vec<String> = path.work.iter().map(|work| rounded(*work)).collect();
        let text = format!(
            "{id} by {}: the ways take {} J (below 0: give back), {} J in all",
            joint.law(),
            works.join(", "),
            rounded(path.work.iter().sum())
        );
        say("note", &text);
    }
    output.write(&table, || {
        let x = Axis::new("separation_m", &format!("separation from {from} (µm)")).times(1e6);
        picture(&drawn, &x, id, joints)
    })
}
