//! Curved bodies over smooth ones against roughness: the numbers are solved by the studies.

use anyhow::{Context, Result};
use asperity_plot::{Axis, Curve, Figure, Mark};

use super::models::{beside, curves, named, of, panel};
use crate::folder::root;
use crate::table::Table;

/// Panels: peak pressure, half axis and stiffness.
pub const PANELS: [&str; 3] = ["peak", "axis", "stiffness"];
/// Models between spheres, and a wheel on a rail.
pub const CURVES: [&str; 4] = ["gw", "ke", "jg", WHEEL];
/// KE between a wheel and a rail.
pub const WHEEL: &str = "wheel";
/// A formula for spheres.
pub const BAHRAMI: &str = "bahrami";
/// The looks of the two.
const OTHERS: [(&str, usize, &str); 2] =
    [(WHEEL, 8, "KE, wheel on rail"), (BAHRAMI, 6, "Bahrami et al., plastic asperities")];

/// The committed numbers.
///
/// # Errors
/// A file that cannot be read.
pub fn table() -> Result<Table> {
    let mut table = Table::new(&["panel", "curve", "alpha", "ratio"]);
    let path = root().join("xtask/data/curved.csv");
    let mut csv = csv::Reader::from_path(&path).context("xtask/data/curved.csv")?;
    for row in csv.deserialize() {
        let (panel, curve, alpha, ratio): (String, String, f64, f64) = row?;
        table.push(&[&panel, &curve], [alpha, ratio])?;
    }
    Ok(table)
}

/// Three panels.
///
/// # Errors
/// None.
pub fn style(_: &str) -> Result<Figure> {
    let all = [curves(&CURVES[..3])?, named(&OTHERS)].concat();
    let shown = |label, key, title, range: [f64; 2], curves: &[Curve]| {
        let x = Axis::new("alpha", "roughness α").log();
        let y = Axis::new("ratio", label).range(range[0], range[1]);
        let mut panel = of("panel", key, title, panel(&x, y, curves));
        panel.horizontals = vec![Mark::new(1.0, "")];
        panel
    };
    let peak = shown("peak pressure/Hertz", PANELS[0], "peak pressure", [0.0, 1.05], &all);
    let axis = shown("half axis/Hertz", PANELS[1], "half axis of the patch", [0.9, 5.0], &all);
    let stiffness = shown("stiffness/Hertz", PANELS[2], "stiffness", [0.0, 1.05], &all[..4]);
    Ok(beside(3, [peak, axis, stiffness]))
}
