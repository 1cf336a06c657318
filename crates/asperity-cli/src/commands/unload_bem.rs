//! Opening of a scan by boundary elements: part of `asperity unload`.

use anyhow::{Context, Result, bail};
use asperity::bem::{Bem, BemError, LoadCase};
use asperity::{At, Datum, Separation, SeparationUnit, linspace};

use crate::interrupt;
use crate::output::number::rounded;
use crate::output::table::{Cell, Table};
use crate::output::{print_message, progress};
use crate::scene::LoadedScene;

/// Number of default retreats: each takes some solutions.
const POINTS: usize = 21;

/// The table of the contact as it opens from its greatest load; without retreats to the end of
/// contact.
pub fn table(scene: &LoadedScene, closest: At, retreats: Option<Vec<f64>>) -> Result<Table> {
    let (contact, from) = (&scene.file.scene, scene.file.separation_from);
    let nominal = contact.nominal_area;
    let bem = scene.file.bem(None, false).with_context(|| scene.name.clone())?;
    crate::output::report(&bem.note().into_iter().collect());
    let greatest = match closest {
        At::Separation(place) => {
            let gap = place.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, contact)?;
            LoadCase::MeanGap(gap.value)
        }
        _ => LoadCase::MeanPressure(closest.pressure(contact).context("a load or a pressure")?),
    };
    let bar = progress(Bem::ID);
    bar.set_message("bem: the greatest load");
    let path = bem.elements(&contact.interface)?.unloading_from(greatest);
    let path = path.with_context(|| format!("{}: bem", scene.name))?;
    let end = path.last_contact();
    let retreats = retreats.unwrap_or_else(|| linspace(0.0, end, POINTS));
    let watch = interrupt::watch(|progress| {
        bar.set_message(format!("bem: retreat {} of {}", progress.done + 1, retreats.len()));
    })?;
    let found = path.at_retreats(&retreats, watch);
    drop(bar);
    let mut table = Table::new(&[
        "model",
        "law",
        "retreat_m",
        "separation_over_sigma",
        "force_N",
        "pressure_Pa",
        "area_m2",
        "stiffness_N_per_m",
    ]);
    let mut reasons: Vec<String> = vec![];
    for (retreat, found) in retreats.iter().zip(found) {
        let found = match found {
            Ok(found) => found,
            Err(BemError::Cancelled) => continue,
            Err(error) => {
                reasons.push(format!("at a retreat of {} m: {error}", rounded(*retreat)));
                continue;
            }
        };
        let place = Separation::metres(found.mean_gap).from_surface_mean();
        let place = place.measured_in(SeparationUnit::Sigma, from, contact)?.value;
        let stiffness = match found.stiffness {
            Some(Ok(stiffness)) => Some(stiffness * nominal),
            Some(Err(error)) => {
                reasons.push(format!("no stiffness: {error}"));
                None
            }
            None => None,
        };
        let pressure = found.mean_pressure;
        let numbers = [*retreat, place, pressure * nominal, pressure, found.area * nominal];
        let mut row = vec![Cell::from(Bem::ID), Cell::from("own")];
        row.extend(numbers.map(Some).into_iter().chain([stiffness]).map(Cell::Number));
        table.rows.push(row);
    }
    for reason in crate::output::once(&reasons) {
        print_message("warning", &format!("{}: bem: {reason}", scene.name));
    }
    if table.rows.is_empty() {
        bail!("{}: no retreat was solved", scene.name);
    }
    let end = rounded(end);
    print_message(
        "note",
        &format!("bem: contact ends at a retreat of {end} m, where the last pixel parts"),
    );
    Ok(table)
}
