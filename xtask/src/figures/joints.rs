//! Quantities from the sum of the contact radii against the pressure: three stiffnesses and thermal
//! conductance, of the paper's scene and of joints of two metals beside correlations.

use anyhow::Result;
use asperity::joints::Correlation;
use asperity::joints::conductance::{
    CorrelationValue, GapRoughness, cooper_mikic_yovanovich, mikic_elastic,
};
use asperity::{At, Body, Interface, ProfileMoments, Quantity, Response, Scene, Surface};
use asperity_plot::{Axis, Figure};
use rayon::prelude::*;

use super::models::{self, beside, curves, geometric, named, of, panel, pressure_axis, solve};
use crate::table::Table;

/// The models with circular contacts.
const CIRCULAR: [&str; 7] = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "af"];
/// The place of KE among them.
const KE: usize = 3;
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::TangentialStiffness];
const KINDS: [(&str, usize); 3] = [("tangent", 8), ("unloading", 9), ("tangential", 7)];
/// Assumed, of the two bodies together \[W/(m K)\].
const CONDUCTIVITY: f64 = 50.0;

/// Pressures on the nominal area \[Pa\].
fn pressures() -> impl Iterator<Item = f64> {
    geometric(1e4, 1e8, 121).into_iter()
}

/// Quantities of every model with circular contacts, in the order of [`CIRCULAR`].
fn solved(scene: &Scene, quantities: &[Quantity]) -> Result<Vec<Response>> {
    let solve = |id: &&str| solve(id, scene, quantities, pressures().map(At::Pressure));
    CIRCULAR.par_iter().map(solve).collect()
}

/// Stiffnesses of KE, then the ratio of two of them for all models.
pub fn stiffness() -> Result<Table> {
    let all = solved(&models::scene(1e-6)?, &STIFFNESSES)?;
    let mut table = Table::new(&["panel", "curve", "pressure_Pa", "stiffness_N_per_m", "ratio"]);
    for (k, (id, answer)) in CIRCULAR.iter().zip(&all).enumerate() {
        for (quantity, (key, ..)) in STIFFNESSES.into_iter().zip(KINDS).filter(|_| k == KE) {
            for (p, value) in pressures().zip(answer.values(quantity)?) {
                table.push(&["kinds", key], [Some(p), Some(value), None])?;
            }
        }
        let [tangent, unloading] = [0, 1].map(|kind| answer.values(STIFFNESSES[kind]));
        for (p, (tangent, unloading)) in pressures().zip(tangent?.into_iter().zip(unloading?)) {
            table.push(&["ratio", id], [Some(p), None, Some(unloading / tangent)])?;
        }
    }
    Ok(table)
}

/// The picture of [`stiffness`].
pub fn stiffness_figure(_: &str) -> Result<Figure> {
    let (x, y) = (pressure_axis(), Axis::new("stiffness_N_per_m", "stiffness (N/µm)"));
    let kinds = panel(&x, y.times(1e-6).log(), &named(&KINDS));
    let title = "unloading over first loading";
    let ratio = panel(&x, Axis::new("ratio", title).range(0.8, 4.0), &curves(&CIRCULAR)?);
    let kinds = of("panel", "kinds", "three stiffnesses of KE", kinds);
    Ok(beside(2, [kinds, of("panel", "ratio", title, ratio)]))
}

/// The usual correlations, with their looks and names in the legend.
const CORRELATIONS: [(&str, usize); 2] = [("cmy", 8), ("mikic", 7)];

/// Conductance of every model and of the correlations where they hold, and over KE's.
pub fn conductance() -> Result<Table> {
    let mut scene = models::scene(1e-6)?;
    scene.interface.thermal_conductivity = Some(CONDUCTIVITY);
    let roughness = GapRoughness::of(&scene.surface.moments());
    let quantity = Quantity::ThermalConductancePerArea;
    let mut curves: Vec<(&str, Vec<Option<f64>>)> = vec![];
    for (id, answer) in CIRCULAR.iter().zip(solved(&scene, &[quantity])?) {
        curves.push((id, answer.values(quantity)?.into_iter().map(Some).collect()));
    }
    let reference = curves[KE].1.clone();
    let (k, asperity) = (CONDUCTIVITY, scene.asperity()?);
    let (modulus, hardness) = (asperity.equivalent_modulus, asperity.hardness()?);
    let cmy = |p| cooper_mikic_yovanovich(k, &roughness, p, hardness);
    let mikic = |p| mikic_elastic(k, &roughness, p, modulus);
    let held = |found: CorrelationValue| found.holds.then_some(found.conductance);
    curves.push(("cmy", pressures().map(|p| Ok(held(cmy(p)?))).collect::<Result<_>>()?));
    curves.push(("mikic", pressures().map(|p| Ok(held(mikic(p)?))).collect::<Result<_>>()?));
    let mut table = Table::new(&["curve", "pressure_Pa", H, "over_ke"]);
    for (id, column) in &curves {
        for ((p, h), ke) in pressures().zip(column).zip(&reference) {
            if let Some((h, ke)) = h.zip(*ke) {
                table.push(&[id], [p, h, h / ke])?;
            }
        }
    }
    Ok(table)
}

/// The picture of [`conductance`].
pub fn conductance_figure(_: &str) -> Result<Figure> {
    let curves = [curves(&CIRCULAR)?, named(&CORRELATIONS)].concat();
    let panels = [
        Axis::new(H, "conductance h (W/(m² K))").log(),
        Axis::new("over_ke", "conductance over that of KE"),
    ]
    .map(|y| panel(&pressure_axis(), y, &curves));
    Ok(beside(2, panels))
}

/// Assumed: Young's modulus [Pa], Poisson's ratio, hardness [Pa], conductivity [W/(m K)].
const ALUMINIUM: [f64; 4] = [70e9, 0.33, 1.1e9, 170.0];
const STEEL: [f64; 4] = [200e9, 0.29, 2.5e9, 16.0];
const COPPER: [f64; 4] = [120e9, 0.34, 0.9e9, 390.0];
const JOINTS: [(&str, [[f64; 4]; 2]); 3] = [
    ("Al-Al", [ALUMINIUM, ALUMINIUM]),
    ("Al-steel", [ALUMINIUM, STEEL]),
    ("Cu-Cu", [COPPER, COPPER]),
];
const SOME: [&str; 5] = ["gw", "zmc", "ke", "etsion", "jg"];
/// Assumed, of each body: σ [m], m, and α = m₀m₄/m₂².
const ROUGHNESS: [f64; 3] = [1e-6, 0.1, 8.0];
const H: &str = "conductance_W_per_m2K";

/// Two equally rough bodies.
fn metal_scene(bodies: [[f64; 4]; 2]) -> Result<Scene> {
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

/// Conductance of the models and correlations of each joint, and over CMY's.
pub fn metals() -> Result<Table> {
    let pressures = geometric(1e5, 1e7, 61);
    let conductance = Quantity::ThermalConductancePerArea;
    let mut table = Table::new(&["joint", "curve", "pressure_Pa", H, "over_cmy"]);
    for (joint, bodies) in JOINTS {
        let scene = metal_scene(bodies)?;
        let roughness = GapRoughness::of(&scene.surface.moments());
        let mut curves: Vec<(&str, Vec<f64>)> = vec![];
        for correlation in Correlation::ALL {
            let of = |p: &f64| Ok(correlation.at(&scene, &roughness, *p)?.conductance);
            curves.push((correlation.id(), pressures.iter().map(of).collect::<Result<_>>()?));
        }
        let cmy = curves[0].1.clone();
        for id in SOME {
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

/// The picture of [`metals`].
pub fn metals_figure(_: &str) -> Result<Figure> {
    let curves = [named(&CORRELATIONS), curves(&SOME)?].concat();
    let conductance = Axis::new(H, "conductance h (W/(m² K))").log();
    let ratio = Axis::new("over_cmy", "conductance over that of CMY").range(0.0, 1.4);
    let row = |y: Axis| {
        JOINTS.map(|(joint, _)| {
            of("joint", joint, joint, panel(&pressure_axis(), y.clone(), &curves))
        })
    };
    Ok(beside(3, [row(conductance), row(ratio)].concat()))
}
