//! Curved bodies over smooth ones against roughness, and beside boundary elements: the numbers are
//! solved by the studies.

use anyhow::Result;
use asperity_plot::{Axis, Curve, Figure, MEASURED, Mark};

use super::models::{beside, curves, named, of, panel};
use crate::folder::root;
use crate::table::{Table, rows_of};

/// Panels: peak pressure, half axis and stiffness.
pub const PANELS: [&str; 3] = ["peak", "axis", "stiffness"];
/// Models between spheres, and a wheel on a rail.
pub const CURVES: [&str; 4] = ["gw", "ke", "jg", WHEEL];
/// KE between a wheel and a rail.
pub const WHEEL: &str = "wheel";
/// A formula for spheres.
pub const BAHRAMI: &str = "bahrami";
/// The looks of the two.
const OTHERS: [(&str, usize); 2] = [(WHEEL, 8), (BAHRAMI, 6)];

/// Rough spheres: local pressure in the middle, half axis, effective radius, approach, real area.
pub const SPHERE: [&str; 5] = ["pressure", "axis", "radius", "approach", "area"];
/// Their file.
pub const SOLVED: &str = "rough-sphere.csv";
/// Models between them.
pub const MODELS: [&str; 3] = ["gw", "ke", "jg"];
/// Boundary elements on elastic ones.
pub const ELASTIC: &str = "bem-elastic";
/// On ones with a hardness.
pub const YIELDING: &str = "bem";
/// On smooth ones.
pub const SMOOTH: &str = "bem-smooth";

/// The committed numbers of a file but those of smooth spheres: panel, curve, alpha and the value.
///
/// # Errors
/// A file that cannot be read.
pub fn committed(name: &str, value: &str) -> Result<Table> {
    let mut table = Table::new(&["panel", "curve", "alpha", value]);
    let rows = rows_of(&root().join("xtask/data").join(name))?;
    for (panel, curve, alpha, value) in rows as Vec<(String, String, f64, f64)> {
        if curve != SMOOTH {
            table.push(&[&panel, &curve], [alpha, value])?;
        }
    }
    Ok(table)
}

/// Four panels.
///
/// # Errors
/// None.
pub fn sphere_style(_: &str) -> Result<Figure> {
    let points = [
        Curve::points(7, ELASTIC, "boundary elements, elastic"),
        Curve::points(MEASURED, YIELDING, "boundary elements, yielding"),
    ];
    let all = [curves(&MODELS)?, points.to_vec()].concat();
    let shown = |key: usize, title, label, range: [f64; 2]| {
        let x = Axis::new("alpha", "roughness α").range(0.04, 1.25).log();
        let y = Axis::new("value", label).range(range[0], range[1]);
        of("panel", SPHERE[key], title, panel(&x, y, &all))
    };
    let panels = [
        shown(0, "pressure in the middle", "pressure/Hertz", [0.0, 1.05]),
        shown(1, "half axis of the patch", "half axis/Hertz", [1.0, 2.0]),
        shown(3, "approach beyond Hertz", "approach/σ", [-1.5, 1.5]),
        shown(4, "real area", "area/Hertz' patch", [0.0, 0.3]),
    ];
    Ok(beside(2, panels))
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
