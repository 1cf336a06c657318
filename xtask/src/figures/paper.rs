//! Figures 4 to 10 of Amini & Tehrani (2020).

use anyhow::{Result, ensure};
use asperity::{Quantity, Scene, linspace};
use asperity_plot::{Axis, Curve, Figure};
use rayon::prelude::*;

use super::models::{self, INPUTS, MARKERS, PAPER, beside, named, panel, separation_axis, solve};
use crate::folder::root;
use crate::table::Table;

/// σ_z of figures 4, 6 and 8 [m], with their keys and names; assumed, because the paper does not
/// give it.
pub const ROUGHNESSES: [(f64, &str, &str); 4] = [
    (0.5e-6, "sigma_z=0.5e-6", "σ_z = 0.5 µm"),
    (1.0e-6, "sigma_z=1.0e-6", "σ_z = 1.0 µm"),
    (1.5e-6, "sigma_z=1.5e-6", "σ_z = 1.5 µm"),
    (2.0e-6, "sigma_z=2.0e-6", "σ_z = 2.0 µm"),
];
/// σ_z of figures 5, 7 and 9 [m]; assumed.
pub const ROUGHNESS: f64 = 1.0e-6;

/// One curve for each (key, model, scene), at d/σ_z of the paper's curves.
fn curves(quantity: Quantity, list: &[(&str, &str, Scene)]) -> Result<Table> {
    let separations = linspace(0.0, 4.0, 201);
    let solve = |(_, model, scene): &(&str, &str, Scene)| {
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
    let of = |(std, key, _)| Ok((key, "at", models::scene(std)?));
    curves(quantity, &ROUGHNESSES.into_iter().map(of).collect::<Result<Vec<_>>>()?)
}

/// A quantity of all models for the paper's scene.
pub fn nine_models(quantity: Quantity) -> Result<Table> {
    all_models(quantity, &models::scene(ROUGHNESS)?)
}

fn all_models(quantity: Quantity, scene: &Scene) -> Result<Table> {
    curves(quantity, &PAPER.map(|id| (id, id, scene.clone())))
}

/// A linear and a logarithmic panel of the same curves, in units in which the numbers are short.
fn figure(quantity: Quantity, which: &str, curves: &[Curve], caption: &[&str]) -> Figure {
    let (what, label, factor) = match quantity {
        Quantity::Force => ("Contact force against separation", "contact force F (N)", 1.0),
        Quantity::Area => ("Real contact area against separation", "contact area A (mm²)", 1e6),
        _ => ("Contact stiffness against separation", "stiffness K (N/µm)", 1e-6),
    };
    let y = Axis::new(&quantity.column(), label).times(factor);
    let panels = [y.clone(), y.log()].map(|y| panel(&separation_axis(), y, curves));
    beside(2, &format!("{what}, {which}"), caption, panels.to_vec())
}

/// The picture of [`roughness`].
pub fn roughness_figure(quantity: Quantity) -> Result<Figure> {
    let curves: Vec<_> = ROUGHNESSES.iter().enumerate().map(|(k, of)| (of.1, k, of.2)).collect();
    let same = "The model is AT as printed. With plasticity index and β_z fixed, R = 359 σ_z and η ∝ 1/σ_z² follow from σ_z.";
    let assumed = format!("{INPUTS} Assumed: the four values of σ_z.");
    Ok(figure(quantity, "AT model", &named(&curves), &[same, &assumed, MARKERS]))
}

/// The picture of [`nine_models`].
pub fn models_figure(quantity: Quantity) -> Result<Figure> {
    let which = match quantity {
        Quantity::Stiffness => {
            " Stiffness is -dF/dd, for Gao and AT the papers' average of asperity stiffnesses."
        }
        _ => "",
    };
    let assumed = format!(
        "{INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm, so R\u{a0}=\u{a0}359\u{a0}µm.{which}"
    );
    Ok(figure(quantity, "nine models", &models::curves(&PAPER)?, &[&assumed, MARKERS]))
}

/// Area of all models for Kucharski's steel, and the measured points of figure 10 if
/// `data/kucharski.csv` has them.
pub fn kucharski() -> Result<Table> {
    let mut table = all_models(Quantity::Area, &models::kucharski()?)?;
    let path = root().join("xtask/data/kucharski.csv");
    if path.exists() {
        let mut csv = csv::Reader::from_path(&path)?;
        let head: Vec<&str> = csv.headers()?.iter().collect();
        ensure!(head == ["separation_m", "area_m2"], "{}: another head", path.display());
        for row in csv.deserialize::<[f64; 2]>() {
            table.push(&["measured"], row?)?;
        }
    }
    Ok(table)
}

/// The picture of [`kucharski`].
pub fn kucharski_figure(csv: &str) -> Result<Figure> {
    let mut curves = models::curves(&PAPER)?;
    let inputs = "Steel of Kucharski et al. (1994) on a rigid flat: E₁\u{a0}=\u{a0}200\u{a0}GPa, ν\u{a0}=\u{a0}0.3, Y\u{a0}=\u{a0}400\u{a0}MPa, so E\u{a0}=\u{a0}219.8\u{a0}GPa, G\u{a0}=\u{a0}45.2\u{a0}GPa, H\u{a0}=\u{a0}2.8\u{a0}Y\u{a0}=\u{a0}1.12\u{a0}GPa, S\u{a0}=\u{a0}0.577. The surface is not given: assumed σ_z\u{a0}=\u{a0}3\u{a0}µm, R\u{a0}=\u{a0}60\u{a0}µm, β_z\u{a0}=\u{a0}0.04, A_n\u{a0}=\u{a0}10⁻⁴\u{a0}m², Gaussian heights, d from the mean of the asperity heights.";
    let mut points = "No measured points are included: markers distinguish the curves.";
    if csv.lines().any(|line| line.starts_with("measured,")) {
        curves.push(Curve::points(10, "measured", "measured"));
        points = MARKERS;
    }
    let mut figure = figure(Quantity::Area, "", &curves, &[inputs, points]);
    figure.title = "Real contact area of a steel, nine models".into();
    Ok(figure)
}
