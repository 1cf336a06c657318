//! Thermal conductance of joints of two metals: models beside correlations.

use anyhow::Result;
use asperity::joints::conductance::{Correlation, GapRoughness};
use asperity::{At, Body, Interface, ProfileMoments, Quantity, Scene, Surface};
use asperity_plot::{Axis, Figure};

use super::joints::CORRELATIONS;
use super::models::{beside, curves, geometric, named, of, panel, pressure_axis, solve};
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
    // Of the gap, with m₂ = π m²/2 of each.
    let (m0, m2) = (2.0 * height_std.powi(2), std::f64::consts::PI * mean_slope.powi(2));
    let surface = Surface::from_moments(&ProfileMoments { m0, m2, m4: bandwidth * m2 * m2 / m0 })?;
    Ok(Scene::new(Interface::between(&first, &second)?, surface, 1e-4))
}

/// Conductance of the models and correlations of each joint, and over that of CMY.
pub fn table() -> Result<Table> {
    let pressures = geometric(1e5, 1e7, 61);
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
