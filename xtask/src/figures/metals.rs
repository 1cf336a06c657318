//! Thermal conductance of joints of two metals: models beside correlations.

use anyhow::Result;
use asperity::joints::conductance::{Correlation, GapRoughness};
use asperity::{
    At, Body, ContactModel, Interface, Model, Quantity, Request, Scene, Surface, Tolerance,
    linspace,
};
use asperity_plot::{Axis, Curve, Figure, Panel};

use super::joints::{CORRELATIONS, pressure_axis};
use super::models::{MARKERS, curve};
use crate::table::{Field, Table};

/// Assumed: Young's modulus [Pa], Poisson's ratio, hardness [Pa], conductivity [W/(m K)].
const ALUMINIUM: [f64; 4] = [70e9, 0.33, 1.1e9, 170.0];
const STEEL: [f64; 4] = [200e9, 0.29, 2.5e9, 16.0];
const COPPER: [f64; 4] = [120e9, 0.34, 0.9e9, 390.0];
const JOINTS: [(&str, [[f64; 4]; 2]); 3] = [
    ("Al-Al", [ALUMINIUM, ALUMINIUM]),
    ("Al-steel", [ALUMINIUM, STEEL]),
    ("Cu-Cu", [COPPER, COPPER]),
];
const MODELS: [&str; 5] = ["gw", "zmc", "ke", "etsion", "jg"];
/// Assumed, of each body: σ [m], m, and α = m₀m₄/m₂².
const ROUGHNESS: [f64; 3] = [1e-6, 0.1, 8.0];
const H: &str = "conductance_W_per_m2K";

fn body([youngs_modulus, poissons_ratio, hardness, conductivity]: [f64; 4]) -> Body {
    let mut body = Body::new(youngs_modulus, poissons_ratio, hardness);
    body.thermal_conductivity = Some(conductivity);
    body
}

/// Two equally rough bodies.
fn scene([first, second]: [[f64; 4]; 2]) -> Result<Scene> {
    let [height_std, mean_slope, bandwidth] = ROUGHNESS;
    let one = GapRoughness { height_std, mean_slope };
    let both = GapRoughness::between(&one, &one);
    // η = m₄/(6√3 π m₂) with m₄ = α m₂²/m₀, of the gap.
    let m2 = 0.5 * std::f64::consts::PI * both.mean_slope.powi(2);
    let density =
        bandwidth * m2 / both.height_std.powi(2) / (6.0 * 3f64.sqrt() * std::f64::consts::PI);
    let surface = Surface::from_mean_slope(both.height_std, both.mean_slope, density)?;
    Ok(Scene::new(Interface::between(&body(first), &body(second))?, surface, 1e-4))
}

/// Conductance of the models and correlations of each joint, and over that of CMY.
pub fn table() -> Result<Table> {
    let pressures: Vec<f64> = linspace(5.0, 7.0, 61).into_iter().map(|x| 10f64.powf(x)).collect();
    let conductance = Quantity::ThermalConductancePerArea;
    let mut table = Table::new(&["joint", "curve", "pressure_Pa", H, "over_cmy"]);
    for (joint, bodies) in JOINTS {
        let scene = scene(bodies)?;
        let roughness = GapRoughness::of(&scene.surface.moments());
        let mut curves: Vec<(&str, Vec<f64>)> = vec![];
        for correlation in Correlation::ALL {
            let of = |p: &f64| Ok(correlation.at(&scene, &roughness, *p)?.conductance);
            curves.push((correlation.id(), pressures.iter().map(of).collect::<Result<_>>()?));
        }
        let cmy = curves[0].1.clone();
        for id in MODELS {
            let request = Request::new([conductance]).within(Tolerance::new(1e-9)?);
            let request = request.at(pressures.iter().copied().map(At::Pressure));
            let answer = id.parse::<Model>()?.solve(&scene, &request)?;
            curves.push((id, answer.values(conductance)?.to_vec()));
        }
        for (id, column) in curves {
            for ((p, h), cmy) in pressures.iter().zip(column).zip(&cmy) {
                let numbers = [*p, h, h / cmy].map(Field::Number);
                table.push(&[&[Field::Word(joint), Field::Word(id)], &numbers[..]].concat())?;
            }
        }
    }
    Ok(table)
}

/// Conductance of each joint, and over that of CMY.
pub fn figure(_: &str) -> Result<Figure> {
    let mut curves = CORRELATIONS.map(|(key, look, label)| Curve::new(look, key, label)).to_vec();
    curves.extend(MODELS.iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?);
    let mut panels = vec![];
    for y in [
        Axis::new(H, "conductance h (W/(m² K))").log(),
        Axis::new("over_cmy", "conductance over that of CMY").range(0.0, 1.4),
    ] {
        for (joint, _) in JOINTS {
            let mut panel = Panel::new(pressure_axis(), y.clone());
            panel.title = joint.into();
            panel.only = Some(("joint".into(), joint.into()));
            panel.curves.clone_from(&curves);
            panels.push(panel);
        }
    }
    let caption = "Two bodies, each with σ\u{a0}=\u{a0}1\u{a0}µm and a mean absolute slope m\u{a0}=\u{a0}0.1; together √2 times that, and for the models a Gaussian gap with α\u{a0}=\u{a0}m₀m₄/m₂²\u{a0}=\u{a0}8. Assumed: aluminium E\u{a0}=\u{a0}70\u{a0}GPa, ν\u{a0}=\u{a0}0.33, H\u{a0}=\u{a0}1.1\u{a0}GPa, k\u{a0}=\u{a0}170\u{a0}W/(m\u{a0}K); stainless steel 200, 0.29, 2.5, 16; copper 120, 0.34, 0.9, 390. The softer body yields; k_s\u{a0}=\u{a0}2k₁k₂/(k₁\u{a0}+\u{a0}k₂). The contacts are plastic, so that Mikic's elastic correlation, and GW, do not apply: they show how much that matters.";
    let title = "Thermal conductance of joints of two metals";
    let mut figure = Figure::new(title, &[caption, MARKERS], panels);
    figure.columns = 3;
    Ok(figure)
}
