//! Quantities from the sum of the contact radii against the pressure: three stiffnesses and thermal
//! conductance.

use anyhow::Result;
use asperity::joints::conductance::{
    CorrelationValue, GapRoughness, cooper_mikic_yovanovich, mikic_elastic,
};
use asperity::{At, Quantity, Response, Scene};
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
const KINDS: [(&str, usize, &str); 3] = [
    ("tangent", 8, "first loading, -dF/dd"),
    ("unloading", 9, "unloading"),
    ("tangential", 7, "tangential, no slip"),
];
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
pub(super) const CORRELATIONS: [(&str, usize, &str); 2] =
    [("cmy", 8, "CMY 1969, plastic"), ("mikic", 7, "Mikic 1974, elastic")];

/// Conductance of every model and of the correlations where they hold, and over that of KE.
pub fn conductance() -> Result<Table> {
    let mut scene = models::scene(1e-6)?;
    scene.interface.thermal_conductivity = Some(CONDUCTIVITY);
    let roughness = GapRoughness::of(&scene.surface.moments());
    let quantity = Quantity::ThermalConductance;
    let mut curves: Vec<(&str, Vec<Option<f64>>)> = vec![];
    for (id, answer) in CIRCULAR.iter().zip(solved(&scene, &[quantity])?) {
        let per_area = answer.values(quantity)?.into_iter().map(|h| Some(h / scene.nominal_area));
        curves.push((id, per_area.collect()));
    }
    let reference = curves[KE].1.clone();
    let (k, asperity) = (CONDUCTIVITY, scene.asperity()?);
    let (modulus, hardness) = (asperity.equivalent_modulus, asperity.hardness()?);
    let cmy = |p| cooper_mikic_yovanovich(k, &roughness, p, hardness);
    let mikic = |p| mikic_elastic(k, &roughness, p, modulus);
    let held = |found: CorrelationValue| found.holds.then_some(found.conductance);
    curves.push(("cmy", pressures().map(|p| Ok(held(cmy(p)?))).collect::<Result<_>>()?));
    curves.push(("mikic", pressures().map(|p| Ok(held(mikic(p)?))).collect::<Result<_>>()?));
    let mut table = Table::new(&["curve", "pressure_Pa", "conductance_W_per_m2K", "over_ke"]);
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
        Axis::new("conductance_W_per_m2K", "conductance h (W/(m² K))").log(),
        Axis::new("over_ke", "conductance over that of KE"),
    ]
    .map(|y| panel(&pressure_axis(), y, &curves));
    Ok(beside(2, panels))
}
