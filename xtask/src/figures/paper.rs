//! Figures 4 to 10 of Amini & Tehrani (2020).

use anyhow::Result;
use asperity::{Quantity, Scene, linspace};
use asperity_plot::{Axis, Curve, Figure};
use rayon::prelude::*;

use super::models::{self, PAPER, beside, panel, separation_axis, solve};
use crate::table::Table;

/// σ_z of figures 4, 6 and 8 [µm]; assumed, because the paper does not give it.
pub const ROUGHNESSES: [f64; 4] = [0.5, 1.0, 1.5, 2.0];
/// σ_z of figures 5, 7 and 9 [m]; assumed.
pub const ROUGHNESS: f64 = 1.0e-6;

/// The name of a roughness \[µm\].
pub fn label(std: f64) -> String {
    format!("σ_z = {std:.1} µm")
}

fn key(std: f64) -> String {
    format!("sigma_z={std:.1}e-6")
}

/// One curve for each (key, model, scene), at d/σ_z of the paper's curves.
fn curves(quantity: Quantity, list: &[(String, &str, Scene)]) -> Result<Table> {
    let separations = linspace(0.0, 4.0, 201);
    let solve = |(_, model, scene): &(String, &str, Scene)| {
        Ok(solve(model, scene, &[quantity], separations.iter().copied())?.values(quantity)?)
    };
    let solved: Vec<Vec<f64>> = list.par_iter().map(solve).collect::<Result<_>>()?;
    let mut table = Table::new(&["curve", "separation_m", &quantity.column()]);
    for ((key, _, scene), values) in list.iter().zip(solved) {
        for (s, value) in separations.iter().zip(values) {
            table.push(&[key], [s * scene.surface.asperity_height_std, value])?;
        }
    }
    Ok(table)
}

/// A quantity of AT for several roughnesses.
pub fn roughness(quantity: Quantity) -> Result<Table> {
    let of = |std: f64| Ok((key(std), "at", models::scene(std * 1e-6)?));
    curves(quantity, &ROUGHNESSES.map(of).into_iter().collect::<Result<Vec<_>>>()?)
}

/// A quantity of all models for a scene.
pub fn all_models(quantity: Quantity, scene: Result<Scene>) -> Result<Table> {
    let scene = scene?;
    curves(quantity, &PAPER.map(|id| (id.to_owned(), id, scene.clone())))
}

/// A linear and a logarithmic panel of the same curves, in units in which the numbers are short.
fn figure(quantity: Quantity, curves: &[Curve]) -> Figure {
    let (label, factor) = match quantity {
        Quantity::Force => ("contact force F (N)", 1.0),
        Quantity::Area => ("contact area A (mm²)", 1e6),
        _ => ("stiffness K (N/µm)", 1e-6),
    };
    let y = Axis::new(&quantity.column(), label).times(factor);
    beside(2, [y.clone(), y.log()].map(|y| panel(&separation_axis(), y, curves)))
}

/// The picture of [`roughness`].
pub fn roughness_figure(quantity: Quantity) -> Result<Figure> {
    let curve = |(k, std)| Curve::new(k, &key(std), &label(std));
    let curves: Vec<Curve> = ROUGHNESSES.into_iter().enumerate().map(curve).collect();
    Ok(figure(quantity, &curves))
}

/// The picture of [`all_models`].
pub fn models_figure(quantity: Quantity) -> Result<Figure> {
    Ok(figure(quantity, &models::curves(&PAPER)?))
}
