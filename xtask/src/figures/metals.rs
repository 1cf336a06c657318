//! Thermal conductance of joints of two metals: models beside correlations.

use anyhow::Result;
use asperity::joints::conductance::{Correlation, GapRoughness};
use asperity::{At, Body, Interface, Quantity, Scene, Surface, linspace};
use asperity_plot::{Axis, Figure};

use super::joints::CORRELATIONS;
use super::models::{beside, curves, named, of, panel, pressure_axis, solve};
use crate::table::Table;

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

/// Two equally rough bodies.
fn scene(bodies: [[f64; 4]; 2]) -> Result<Scene> {
    let [first, second] = bodies.map(|[youngs_modulus, poissons_ratio, hardness, conductivity]| {
        let mut body = Body::new(youngs_modulus, poissons_ratio, hardness);
        body.thermal_conductivity = Some(conductivity);
        body
    });
    let [height_std, mean_slope, bandwidth] = ROUGHNESS;
    let one = GapRoughness { height_std, mean_slope };
    let both = GapRoughness::between(&one, &one);
    // η = m₄/(6√3 π m₂) with m₄ = α m₂²/m₀, of the gap.
    let m2 = 0.5 * std::f64::consts::PI * both.mean_slope.powi(2);
    let density =
        bandwidth * m2 / both.height_std.powi(2) / (6.0 * 3f64.sqrt() * std::f64::consts::PI);
    let surface = Surface::from_mean_slope(both.height_std, both.mean_slope, density)?;
    Ok(Scene::new(Interface::between(&first, &second)?, surface, 1e-4))
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
            let at = pressures.iter().copied().map(At::Pressure);
            curves.push((id, solve(id, &scene, &[conductance], at)?.values(conductance)?));
        }
        for (id, column) in curves {
            for ((p, h), cmy) in pressures.iter().zip(column).zip(&cmy) {
                table.push(&[joint, id], [*p, h, h / cmy])?;
            }
        }
    }
    Ok(table)
}

/// Conductance of each joint, and over that of CMY.
pub fn style(_: &str) -> Result<Figure> {
    let curves = [named(&CORRELATIONS), curves(&MODELS)?].concat();
    let conductance = Axis::new(H, "conductance h (W/(m² K))").log();
    let ratio = Axis::new("over_cmy", "conductance over that of CMY").range(0.0, 1.4);
    let row = |y: Axis| {
        JOINTS.map(|(joint, _)| {
            of("joint", joint, joint, panel(&pressure_axis(), y.clone(), &curves))
        })
    };
    Ok(beside(3, [row(conductance), row(ratio)].concat()))
}
