//! The plot of `asperity conductance`.

use anyhow::{Context, Result};
use asperity::joints::conductance::Correlation;
use asperity::{Quantity, Scene};
use asperity_answer::{Cell, Sheet};
use asperity_plot::{Axis, Curve};

use crate::output::{once, plot};

/// The conductance of the contacts and, with a gas, in total against the pressure, one curve for
/// each model and correlation; correlations are grey where they do not hold.
pub fn picture(sheet: &Sheet, scene: &Scene) -> Result<String> {
    let mut long = sheet.clone();
    let names =
        |sheet: &Sheet| once(&sheet.rows.iter().map(|row| row[0].clone()).collect::<Vec<_>>());
    let ids = names(&long);
    let holds = sheet.column("holds").context("the table has no column holds")?;
    for row in &mut long.rows {
        let invalid = Correlation::ALL.into_iter().find(|known| row[0] == known.id().into());
        if let Some(correlation) = invalid.filter(|_| row[holds] == "no".into()) {
            row[0] = invalid_name(correlation, scene).as_str().into();
        }
    }
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
    let mut curves: Vec<Curve> = names(&long).iter().filter_map(curve).collect();
    // Below the others, which they may cover.
    curves.sort_by_key(|curve| !curve.invalid);
    let contacts = Quantity::ThermalConductancePerArea.column();
    let total = format!("total_{contacts}");
    let columns = [
        (&*contacts, "conductance of the contacts (W/(m² K))"),
        (&*total, "conductance of contacts and gas (W/(m² K))"),
    ];
    let x = plot::fitted(&mut long, Axis::new("pressure_Pa", "pressure (Pa)"));
    plot::against_alike(&long, &x, &columns, &curves)
}

/// The name of a correlation where it does not hold, with the reason.
fn invalid_name(correlation: Correlation, scene: &Scene) -> String {
    let reason = match correlation.foreign(scene) {
        Some(_) => format!("{} contacts", correlation.other_contacts()),
        None => format!("{} out of range", correlation.relative_pressure()),
    };
    format!("{} (invalid: {reason})", correlation.id())
}
