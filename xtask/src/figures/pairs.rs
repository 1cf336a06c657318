//! Two rough surfaces: Greenwood & Tripp, the fits that codes use instead, and KE between pairs.

use std::f64::consts::{PI, SQRT_2};

use anyhow::Result;
use asperity::{Quantity, Scene, Surface, linspace};
use asperity_plot::{Axis, Figure};

use super::models::{NOMINAL_AREA, beside, interface, named, of, panel, solve};
use crate::table::Table;

/// σ of the sum of the heights \[m\], η β σ with the η and β of each surface, and ψ of the
/// contacts: all but ψ cancel.
const STD: f64 = 1e-6;
const ROUGHNESS_PARAMETER: f64 = 0.04;
const PLASTICITY_INDEX: f64 = 2.0;

const CURVES: [(&str, usize); 5] =
    [("gw-pairs", 40), ("ke-pairs", 43), ("power", 5), ("rounded", 7), ("exponential", 8)];

/// The fits of F_5/2 in public codes.
fn fit(key: &str, lambda: f64) -> f64 {
    match key {
        "power" => 4.4086e-5 * (4.0 - lambda).powf(6.804),
        "rounded" => 3.5e-5 * (4.0 - lambda).powf(6.9),
        _ => 0.6189 * (-1.973 * lambda).exp(),
    }
}

/// Pressures over (16√2π/15) (ηβσ)² √(σ/β) E, which for Hertz' law are F_5/2, and over that law's.
pub fn table() -> Result<Table> {
    let interface = interface();
    let contacts =
        Surface::from_plasticity_index(PLASTICITY_INDEX, ROUGHNESS_PARAMETER, STD, &interface)?;
    let radius = 2.0 * contacts.asperity_radius;
    let surface = Surface::new(radius, ROUGHNESS_PARAMETER / (radius * STD), STD / SQRT_2);
    let scene = Scene::new(interface, surface, NOMINAL_AREA);
    let unit = 16.0 * SQRT_2 * PI / 15.0
        * ROUGHNESS_PARAMETER.powi(2)
        * (STD / radius).sqrt()
        * interface.equivalent_modulus;
    let lambdas = linspace(0.5, 4.0, 141);
    let solved = |id: &str| -> Result<Vec<f64>> {
        let found = solve(id, &scene, &[Quantity::Pressure], lambdas.clone())?;
        Ok(found.values(Quantity::Pressure)?.into_iter().map(|p| p / unit).collect())
    };
    let exact = solved("gw-pairs")?;
    let mut table = Table::new(&["panel", "curve", "lambda", "pressure", "ratio"]);
    for (key, ..) in CURVES {
        let values = match key.ends_with("-pairs") {
            true => solved(key)?,
            false => lambdas.iter().map(|lambda| fit(key, *lambda)).collect(),
        };
        for ((lambda, value), exact) in lambdas.iter().zip(values).zip(&exact) {
            // The fits end at 4.
            if value > 0.0 {
                table.push(&["pressure", key], [Some(*lambda), Some(value), None])?;
            }
            table.push(&["ratio", key], [Some(*lambda), None, Some(value / exact)])?;
        }
    }
    Ok(table)
}

/// The picture of [`table`].
pub fn style(_: &str) -> Result<Figure> {
    let x = Axis::new("lambda", "separation over σ, λ").range(0.5, 4.0);
    let curves = named(&CURVES);
    let pressure =
        panel(&x, Axis::new("pressure", "scaled pressure").range(1e-6, 1.0).log(), &curves);
    let ratio =
        panel(&x, Axis::new("ratio", "over Greenwood & Tripp").range(0.1, 10.0).log(), &curves);
    let pressure = of("panel", "pressure", "pressure", pressure);
    Ok(beside(2, [pressure, of("panel", "ratio", "over Greenwood & Tripp", ratio)]))
}
