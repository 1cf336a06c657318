//! Loading, and unloading by three laws from three separations.

use anyhow::Result;
use asperity::joints::{Unloading, UnloadingLaw};
use asperity::{At, ContactModel, Model, Quantity, Request, Separation, Tolerance, linspace};

use super::models::{self, INPUTS, MARKERS};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Panel};

const MODEL: &str = "ke";
/// Closest approaches over σ_z.
const CLOSEST: [f64; 3] = [0.0, 0.5, 1.0];
const LOADING: &str = "loading";
/// The laws with their looks and names in the legend.
const LAWS: [(UnloadingLaw, usize, &str); 3] = [
    (UnloadingLaw::Hertz, 2, "unloading, hertz"),
    (UnloadingLaw::Brake, 3, "unloading, brake (Brake 2015)"),
    (UnloadingLaw::Etsion, 1, "unloading, etsion (Etsion et al. 2005)"),
];

/// Force and area of the paper's scene, with gaps between the branches.
pub fn table() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let sigma = scene.surface.asperity_height_std;
    let (model, tolerance): (Model, _) = (MODEL.parse()?, Tolerance::new(1e-9)?);
    let mut table = Table::new(&["curve", "separation_m", "force_N", "area_m2"]);
    let separations = linspace(-0.1, 3.0, 156);
    let request = Request::new([Quantity::Force, Quantity::Area]).within(tolerance);
    let closing = model.solve(&scene, &request.at(separations.iter().copied()))?;
    let (force, area) = (closing.values(Quantity::Force)?, closing.values(Quantity::Area)?);
    for ((s, force), area) in separations.iter().zip(force).zip(area) {
        let numbers = [s * sigma, force, area].map(Field::Number);
        table.push(&[&[Field::Word(LOADING)], &numbers[..]].concat())?;
    }
    for (law, ..) in LAWS {
        let name = law.to_string();
        for (k, closest) in CLOSEST.into_iter().enumerate() {
            if k > 0 {
                table.push(&[Field::Word(&name), Field::Gap, Field::Gap, Field::Gap])?;
            }
            let at = At::from(Separation::sigmas(closest));
            let joint = Unloading::new(&model, &scene, at, law, tolerance)?;
            for retreat in linspace(0.0, 2.0 * sigma, 121) {
                let area = match law {
                    // Its fit of the area is not drawn.
                    UnloadingLaw::Etsion => Field::Gap,
                    _ => Field::Number(joint.area(retreat)?.value()),
                };
                let (at, force) = (closest * sigma + retreat, joint.force(retreat)?.value());
                let row = [Field::Word(&name), Field::Number(at), Field::Number(force), area];
                table.push(&row)?;
            }
        }
    }
    Ok(table)
}

/// Force and area side by side.
pub fn style(_: &str) -> Result<Figure> {
    let laws = LAWS.map(|(law, look, label)| Curve::new(look, &law.to_string(), label));
    let curves = [&[Curve::new(0, LOADING, "first loading")], &laws[..]].concat();
    let columns = [
        ("force_N", "contact force F (N)", 1.0, &curves[..]),
        ("area_m2", "contact area A (mm²)", 1e6, &curves[..3]),
    ];
    let panels = columns.map(|(column, label, factor, curves)| {
        let x = Axis::new("separation_m", "separation d (µm)").times(1e6).range(-0.1e-6, 2.5e-6);
        let mut panel = Panel::new(x, Axis::new(column, label).times(factor));
        panel.curves = curves.to_vec();
        panel
    });
    let caption = format!(
        "KE, loaded for the first time to d\u{a0}=\u{a0}0, 0.5 and 1\u{a0}σ_z, and unloaded. Hertz and etsion almost coincide; with brake the area jumps at the start of unloading; etsion's fit of the area is not drawn. Reloading follows the unloading curve, and then the first loading. {INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm."
    );
    let title = "Unloading by three laws";
    let mut figure = Figure::new(title, &[&caption, MARKERS], panels.to_vec());
    figure.columns = 2;
    Ok(figure)
}
