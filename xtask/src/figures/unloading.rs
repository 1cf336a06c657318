//! Loading, and unloading by three laws from three separations.

use anyhow::Result;
use asperity::joints::{Unloading, UnloadingLaw};
use asperity::{At, Model, Quantity, Separation, Tolerance, linspace};
use asperity_plot::{Axis, Figure};

use super::models::{self, TOLERANCE, beside, named, panel, separation_axis, solve};
use crate::table::Table;

/// Closest approaches over σ_z.
const CLOSEST: [f64; 3] = [0.0, 0.5, 1.0];
const LAWS: [UnloadingLaw; 3] = [UnloadingLaw::Hertz, UnloadingLaw::Brake, UnloadingLaw::Etsion];
/// Loading, then the laws, with their looks and names in the legend.
const CURVES: [(&str, usize, &str); 4] = [
    ("loading", 0, "first loading"),
    ("hertz", 2, "unloading, hertz"),
    ("brake", 3, "unloading, brake (Brake 2015)"),
    ("etsion", 1, "unloading, etsion (Etsion et al. 2005)"),
];

/// Force and area of the paper's scene, with gaps between the branches.
pub fn table() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let sigma = scene.surface.asperity_height_std;
    let (model, tolerance): (Model, _) = ("ke".parse()?, Tolerance::new(TOLERANCE)?);
    let mut table = Table::new(&["curve", "separation_m", "force_N", "area_m2"]);
    let separations = linspace(-0.1, 3.0, 156);
    let quantities = [Quantity::Force, Quantity::Area];
    let closing = solve("ke", &scene, &quantities, separations.iter().copied())?;
    let [force, area] = quantities.map(|quantity| closing.values(quantity));
    for ((s, force), area) in separations.iter().zip(force?).zip(area?) {
        table.push(&["loading"], [s * sigma, force, area])?;
    }
    for (law, (name, ..)) in LAWS.into_iter().zip(&CURVES[1..]) {
        for (k, closest) in CLOSEST.into_iter().enumerate() {
            if k > 0 {
                table.push(&[name], [None::<f64>; 3])?;
            }
            let at = At::from(Separation::sigmas(closest));
            let joint = Unloading::new(&model, &scene, at, law, tolerance)?;
            for retreat in linspace(0.0, 2.0 * sigma, 121) {
                // The fit of the area by etsion is not drawn.
                let area = match law {
                    UnloadingLaw::Etsion => None,
                    _ => Some(joint.area(retreat)?.value()),
                };
                let (at, force) = (closest * sigma + retreat, joint.force(retreat)?.value());
                table.push(&[name], [Some(at), Some(force), area])?;
            }
        }
    }
    Ok(table)
}

/// Force and area side by side.
pub fn style(_: &str) -> Result<Figure> {
    let x = separation_axis().range(-0.1e-6, 2.5e-6);
    let force = panel(&x, Axis::new("force_N", "contact force F (N)"), &named(&CURVES));
    let area = Axis::new("area_m2", "contact area A (mm²)").times(1e6);
    let area = panel(&x, area, &named(&CURVES[..3]));
    Ok(beside(2, [force, area]))
}
