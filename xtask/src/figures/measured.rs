//! The picture of the report, from the text of its csv.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use asperity_plot::{Axis, Curve, Strip, draw};

use super::captions::with_caption;
use super::models::{beside, of, panel};
use super::report_csv::{Row, machine, median};
use crate::folder::{Fresh, read};
use crate::table::rows;

/// The picture with its name, drawn from the table in a folder.
///
/// # Errors
/// A table that is missing or not that of the report.
pub fn picture(folder: &Path) -> Result<Fresh> {
    Ok(("speed-vs-error.svg".into(), frontier(&read(&folder.join("speed-vs-error.csv"))?)?))
}

/// Errors above this count as wrong.
const WRONG: f64 = 1e-2;
/// The ends of the axis, at which larger and smaller errors are drawn.
const ERRORS: (f64, f64) = (1e-16, 10.0);

/// The methods in the order of their looks.
const METHODS: &str = "compiled gauss-legendre-64 rule gauss-kronrod scipy simpson";

/// The panels and their models.
const PANELS: [(&str, &str, &[&str]); 2] = [
    ("upright", "upright contacts: GW to AF", &[]),
    ("angles", "inclined contacts: Gao, AT", &["gao", "at", "at-additive", "at-overlap"]),
];

/// The panel of a model.
fn panel_of(model: &str) -> &'static str {
    PANELS.iter().find(|panel| panel.2.contains(&model)).map_or(PANELS[0].0, |panel| panel.0)
}

/// An error of a csv; a failure is worse than any number.
fn size(error: &str) -> f64 {
    error.parse().unwrap_or(f64::INFINITY)
}

/// Median of times against worst of errors, for each method and setting over all models and
/// quantities of a panel: `panel,method,error,time`.
fn summary(csv: &str) -> Result<String> {
    let rows: Vec<Row> = rows(csv)?;
    let together =
        |a: &Row, b: &Row| (&a.model, &a.quantity, &a.method) == (&b.model, &b.quantity, &b.method);
    let settings = rows.chunk_by(together).flat_map(|rows| rows.iter().enumerate());
    // The worst error and all times of a panel, a method and the number of its setting.
    let mut groups = BTreeMap::<_, (f64, Vec<f64>)>::new();
    for (setting, row) in settings {
        let key = (panel_of(&row.model), &row.method, setting);
        let (worst, times) = groups.entry(key).or_default();
        *worst = worst.max(size(&row.max_relative_error));
        times.push(row.median_ns.parse()?);
    }
    let mut text = String::from("panel,method,error,time\n");
    // A failure has no place on the axis.
    for ((panel, method, _), (worst, times)) in groups.into_iter().filter(|g| g.1.0.is_finite()) {
        let (worst, time) = (worst.clamp(ERRORS.0, ERRORS.1), median(times).unwrap_or(0.0));
        text += &format!("{panel},{method},{worst:e},{time:e}\n");
    }
    Ok(text)
}

/// Time against error.
///
/// # Errors
/// A csv that is not `speed-vs-error.csv`.
fn frontier(csv: &str) -> Result<String> {
    let machine = machine(csv).context("speed-vs-error.csv names no machine")?;
    let summary = summary(csv)?;
    let drawn = |key: &str, method: &str| summary.contains(&format!("\n{key},{method},"));
    let mut panels = vec![];
    for (key, title, _) in PANELS {
        let x = Axis::new("error", "worst relative error on the hard grid").log();
        let y = Axis::new("time", "median time of an evaluation (ns)").log();
        let methods = METHODS.split(' ').enumerate().filter(|(_, method)| drawn(key, method));
        let mut curves: Vec<Curve> =
            methods.map(|(look, method)| Curve::new(look, method, method)).collect();
        curves.iter_mut().for_each(|curve| curve.every_point = true);
        let (x, y) = (x.range(ERRORS.0, ERRORS.1), y.range(2.0, 2e6));
        let mut panel = of("panel", key, title, panel(&x, y, &curves));
        panel.curve_column = "method".into();
        panel.strips = vec![Strip::upright(WRONG, f64::INFINITY, "wrong")];
        panels.push(panel);
    }
    panels.retain(|panel| !panel.curves.is_empty());
    let mut figure = beside(1, panels);
    figure.caption = vec![format!("{machine}.")];
    Ok(draw(&with_caption("speed-vs-error", figure)?, &summary)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CSV: &str = "# measured on a machine
model,quantity,method,tolerance,median_ns,max_relative_error
ke,force,compiled,1e-3,30,1e-6
ke,force,compiled,1e-5,40,1e-8
ke,force,scipy,,900,1e-3
ke,force,scipy,,1800,1e-5
jg,force,compiled,1e-3,60,2e-5
jg,force,compiled,1e-5,50,not-converged
jg,force,scipy,,700,1e-2
jg,force,scipy,,1900,1e-6
";

    #[test]
    fn a_marker_is_the_median_time_and_the_worst_error_of_one_setting() -> Result<()> {
        let expected = "panel,method,error,time
upright,compiled,2e-5,6e1
upright,scipy,1e-2,9e2
upright,scipy,1e-5,1.9e3
";
        assert_eq!(summary(CSV)?, expected);
        let svg = frontier(CSV)?;
        assert!(svg.contains("scipy") && svg.contains("a machine."));
        Ok(())
    }
}
