//! The plot of `asperity conductance`.

use anyhow::Result;
use asperity::joints::conductance::Correlation;
use asperity::{Quantity, Scene};
use asperity_answer::Sheet;
use asperity_plot::{Axis, Curve, Figure, Scale, look_of};

use crate::output::plot;

/// The conductance of the contacts and, with a gas, in total against the pressure, one curve for
/// each model and correlation; correlations are grey where they do not hold.
pub fn picture(sheet: &Sheet, scene: &Scene) -> Result<String> {
    let (mut long, holds) = (sheet.clone(), plot::place(sheet, "holds")?);
    let ids = plot::names(sheet);
    for row in &mut long.rows {
        let invalid = Correlation::ALL.into_iter().find(|known| row[0].text() == known.id());
        if let Some(correlation) = invalid.filter(|_| row[holds].text() == "no") {
            row[0] = invalid_name(correlation, scene).as_str().into();
        }
    }
    let mut invalid = 0..;
    let mut curves = plot::curves(&long, |_, name| match ids.iter().position(|id| id == name) {
        Some(k) => Curve::new(look_of(name).unwrap_or(k), name, name),
        None => Curve::invalid(invalid.next().unwrap_or_default(), name, name),
    });
    // Below the others, which they may cover.
    curves.sort_by_key(|curve| !curve.invalid);
    let contacts = Quantity::ThermalConductancePerArea.column();
    let total = format!("total_{contacts}");
    let columns = [
        (&*contacts, "conductance of the contacts (W/(m² K))"),
        (&*total, "conductance of contacts and gas (W/(m² K))"),
    ];
    let x = plot::fitted(&mut long, Axis::new("pressure_Pa", "pressure (Pa)"));
    let mut panels = plot::panels(&long, &x, &columns, &curves)?;
    // Of one quantity: if one spans decades, both have a logarithmic axis.
    if panels.iter().any(|panel| panel.y.scale == Scale::Log) {
        panels.iter_mut().for_each(|panel| panel.y.scale = Scale::Log);
    }
    plot::drawn(&long, &Figure::new("", &[], panels))
}

/// The name of a correlation where it does not hold, with the reason.
fn invalid_name(correlation: Correlation, scene: &Scene) -> String {
    let reason = match correlation.foreign(scene) {
        Some(_) => format!("{} contacts", correlation.other_contacts()),
        None => format!("{} out of range", correlation.relative_pressure()),
    };
    format!("{} (invalid: {reason})", correlation.id())
}
