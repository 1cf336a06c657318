//! A joint through a history of turning points: part of `asperity unload`.

use anyhow::{Context, Result};
use asperity::joints::{Joint, Path, Point, Unloading};
use asperity::{At, ContactError, ContactModel, Quantity, Request, Separation, SeparationUnit};
use asperity_plot::Axis;

use crate::input::args::DrawnArgs;
use crate::joints::{READ_0, marked, named, picture, warn_energy_gain};
use crate::output::number::rounded;
use crate::output::print_message;
use crate::output::table::{Cell, Table};
use crate::scene::{LoadedScene, NamedModel};

/// Points on each path between turning points.
const STEPS: usize = 50;

/// Writes the paths between turning points by each law, with notes on their work.
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
    // No line is drawn at jumps of the stiffness, where a path leaves or meets the virgin curve.
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
        // A turning point.
        let rows = &table.rows[table.rows.len() - path.points.len()..];
        let ends = |(k, point): &(usize, &Point)| {
            path.points.get(k + 1).is_none_or(|next| next.way != point.way)
        };
        drawn
            .rows
            .extend(path.points.iter().enumerate().filter(ends).map(|(k, _)| marked(&rows[k])));
        report_work(id, joint, &path);
        if let Some(last) = path.points.last().filter(|_| path.points.len() > 1) {
            let closest = At::metres(last.closest);
            let warned =
                joint.work(closest).and_then(|w| warn_energy_gain(scene, joint, closest, &w));
            // Missing work has a warning of its own.
            warned.or_else(|error| match error {
                ContactError::Integral { .. } | ContactError::OutOfRange { .. } => Ok(()),
                error => Err(error),
            })?;
        }
        report_few(model, joint, &path).with_context(|| named(scene, model))?;
    }
    output.write(&table, || {
        let x = Axis::new("separation_m", &format!("separation from {from} (µm)")).times(1e6);
        picture(&drawn, &x, id, joints)
    })
}

/// Warns of points at which fewer than one asperity touches, and of zeros.
fn report_few((id, model): &NamedModel, joint: &Joint, path: &Path) -> Result<(), ContactError> {
    let virgin = model.compile(joint.scene(), &Request::new([Quantity::Contacts]))?;
    let name = format!("{id} by {}", joint.law());
    let (mut few, mut way) = (vec![], None::<(f64, Unloading)>);
    for point in &path.points {
        let (place, closest) = (At::metres(point.separation), point.closest);
        let contacts = if point.separation > closest {
            let opening = match way.take().filter(|(from, _)| from.total_cmp(&closest).is_eq()) {
                Some((_, opening)) => opening,
                None => joint.unloading(At::metres(closest))?,
            };
            let found = opening.contacts(point.separation - closest)?.value();
            way = Some((closest, opening));
            found
        } else {
            virgin.evaluate(Quantity::Contacts, virgin.separation(place)?)?.value()
        };
        if contacts < 1.0 {
            few.push(point);
        }
    }
    let Some(first) = few.first() else { return Ok(()) };
    let zeros = few.iter().filter(|point| point.force == 0.0 || point.stiffness == 0.0).count();
    let zeros = match zeros {
        0 => String::new(),
        count => format!("; at {count} of them values {READ_0}"),
    };
    let (count, all, number) = (few.len(), path.points.len(), first.way);
    let text = format!(
        "{name}: fewer than one asperity touches on average at {count} of {all} points, first at {} on way {number}{zeros}",
        At::metres(first.separation)
    );
    print_message("warning", &text);
    Ok(())
}

/// Reports the work of the first closing and of the later paths.
fn report_work(id: &str, joint: &Joint, path: &Path) {
    let Some(first) = path.points.first() else { return };
    let name = format!("{id} by {}", joint.law());
    let first = match joint.work(At::metres(first.separation)) {
        Ok(work) => work.spent.value(),
        Err(error) => {
            return print_message("warning", &format!("{name}: the work is unavailable: {error}"));
        }
    };
    let all = rounded(first + path.work.iter().sum::<f64>());
    let works: Vec<String> = path.work.iter().map(|work| rounded(*work)).collect();
    let (first, works) = (rounded(first), works.join(", "));
    let text = match &*works {
        "" => format!("{name}: closing to the turning point takes {first} J"),
        _ => format!(
            "{name}: first closing takes {first} J, the later paths {works} J (negative: returned), {all} J in total"
        ),
    };
    print_message("note", &text);
}
