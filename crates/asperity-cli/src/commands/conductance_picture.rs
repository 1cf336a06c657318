//! The plot of `asperity conductance`.

use std::cmp::Ordering;

use anyhow::Result;
use asperity::joints::conductance::Correlation;
use asperity::{Quantity, Scene};
use asperity_plot::{Axis, Curve, Scale};

use crate::output::table::{Cell, Table};
use crate::output::{once, plot};

pub const CONDUCTANCE: Quantity = Quantity::ThermalConductancePerArea;

/// The head of the conductance of the gas, or of contacts and gas together.
pub fn column(part: &str) -> String {
    format!("{part}_{}", CONDUCTANCE.column())
}

/// The conductance of the contacts and, with a gas, in total against the pressure, one curve for
/// each model and correlation; correlations are grey where they do not hold.
pub fn picture(table: &Table, scene: &Scene) -> Result<String> {
    let [model, pressure, holds] = places(table)?;
    let pressure = |row: &[Cell]| row[pressure].number();
    let mut x = Axis::new("pressure_Pa", "pressure (Pa)");
    x.scale = Scale::fitting(&table.rows.iter().filter_map(|r| pressure(r)).collect::<Vec<_>>());
    let mut long = table.clone();
    let ids: Vec<Cell> = long.rows.iter().map(|row| row[model].clone()).collect();
    let ids = once(&ids);
    for row in &mut long.rows {
        let invalid = Correlation::ALL.into_iter().find(|known| row[model] == known.id().into());
        if let Some(correlation) = invalid.filter(|_| row[holds] == "no".into()) {
            row[model] = invalid_name(correlation, scene).as_str().into();
        }
    }
    let names: Vec<Cell> = long.rows.iter().map(|row| row[model].clone()).collect();
    let (few, mut invalid) = (long.rows.len() <= plot::MARKED * ids.len(), 0..);
    let curve = |name: &Cell| {
        let Cell::Text(text) = name else { return None };
        let mut curve = match ids.iter().position(|id| id == name) {
            Some(look) => Curve::new(look, text, text),
            None => Curve::invalid(invalid.next().unwrap_or_default(), text, text),
        };
        curve.every_point = few;
        Some(curve)
    };
    let mut curves: Vec<Curve> = once(&names).iter().filter_map(curve).collect();
    // Below the others, which they may cover.
    curves.sort_by_key(|curve| !curve.invalid);
    let (contacts, total) = (CONDUCTANCE.column(), column("total"));
    let columns = [
        (&*contacts, "conductance of the contacts (W/(m² K))"),
        (&*total, "conductance of contacts and gas (W/(m² K))"),
    ];
    // Lines run from left to right for any order of the rows.
    long.rows.sort_by(|a, b| pressure(a).partial_cmp(&pressure(b)).unwrap_or(Ordering::Equal));
    plot::against_alike(&long, &x, &columns, &curves)
}

/// The places of the columns of the model, the pressure, and whether a correlation holds.
fn places(table: &Table) -> Result<[usize; 3]> {
    Ok([
        plot::place(table, "model")?,
        plot::place(table, "pressure_Pa")?,
        plot::place(table, "holds")?,
    ])
}

/// The name of a correlation where it does not hold, with the reason.
fn invalid_name(correlation: Correlation, scene: &Scene) -> String {
    let reason = match correlation.foreign(scene) {
        Some(_) => format!("{} contacts", correlation.other_contacts()),
        None => format!("{} out of range", correlation.relative_pressure()),
    };
    format!("{} (invalid: {reason})", correlation.id())
}
