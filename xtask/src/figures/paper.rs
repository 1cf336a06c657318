//! Figures 4 to 10 of Amini & Tehrani (2020).

use std::path::Path;

use anyhow::{Context, Result};
use asperity::{Model, Quantity, Request, Response, Scene, Tolerance, linspace};
use rayon::prelude::*;

use super::models::{self, INPUTS, MARKERS, PAPER, curve};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Panel};

/// σ_z of figures 4, 6 and 8 [m]; assumed, because the paper does not give it.
pub const ROUGHNESSES: [f64; 4] = [0.5e-6, 1.0e-6, 1.5e-6, 2.0e-6];
/// σ_z of figures 5, 7 and 9 [m]; assumed.
pub const ROUGHNESS: f64 = 1.0e-6;
/// Far below the width of a line, and below the guard of 1e-7.
const TOLERANCE: f64 = 1e-9;

/// d/σ_z of the paper's curves.
fn separations() -> impl Iterator<Item = f64> {
    linspace(0.0, 4.0, 201).into_iter()
}

fn solve(model: &str, scene: &Scene, quantity: Quantity) -> Result<Response> {
    let model: Model = model.parse()?;
    let request = Request::new([quantity]).at(separations()).within(Tolerance::new(TOLERANCE)?);
    Ok(model.solve(scene, &request)?)
}

/// One curve for each (key, model, scene).
fn curves(quantity: Quantity, list: &[(String, &str, Scene)]) -> Result<Table> {
    let solved: Vec<Response> = list
        .par_iter()
        .map(|(_, model, scene)| solve(model, scene, quantity))
        .collect::<Result<_>>()?;
    let mut table = Table::new(&["curve", "separation_m", &quantity.column()]);
    for ((key, _, scene), response) in list.iter().zip(&solved) {
        for (s, value) in separations().zip(response.values(quantity)?) {
            let separation = s * scene.surface.asperity_height_std;
            table.push(&[Field::Word(key), Field::Number(separation), Field::Number(value)])?;
        }
    }
    Ok(table)
}

/// A quantity of AT for several roughnesses.
pub fn roughness(quantity: Quantity) -> Result<Table> {
    let list = ROUGHNESSES
        .iter()
        .map(|std| Ok((key(*std), "at", models::scene(*std)?)))
        .collect::<Result<Vec<_>>>()?;
    curves(quantity, &list)
}

fn key(std: f64) -> String {
    format!("sigma_z={:.1}e-6", std * 1e6)
}

/// A quantity of all models for the paper's scene.
pub fn nine_models(quantity: Quantity) -> Result<Table> {
    all_models(quantity, &models::scene(ROUGHNESS)?)
}

fn all_models(quantity: Quantity, scene: &Scene) -> Result<Table> {
    let list: Vec<_> = PAPER.iter().map(|id| ((*id).to_owned(), *id, scene.clone())).collect();
    curves(quantity, &list)
}

/// Label and factor of the axis: units in which the numbers are short.
fn axis(quantity: Quantity) -> Axis {
    let (label, factor) = match quantity {
        Quantity::Force => ("contact force F (N)", 1.0),
        Quantity::Area => ("contact area A (mm²)", 1e6),
        _ => ("stiffness K (N/µm)", 1e-6),
    };
    Axis::new(&quantity.column(), label).times(factor)
}

/// A linear and a logarithmic panel of the same curves.
fn panels(quantity: Quantity, curves: &[Curve]) -> Vec<Panel> {
    [false, true]
        .map(|log| {
            let y = axis(quantity);
            let x = Axis::new("separation_m", "separation d (µm)").times(1e6);
            let mut panel = Panel::new(x, if log { y.log() } else { y });
            panel.curves = curves.to_vec();
            panel
        })
        .to_vec()
}

fn figure(title: &str, quantity: Quantity, curves: &[Curve], caption: &[&str]) -> Figure {
    let mut figure = Figure::new(title, caption, panels(quantity, curves));
    figure.columns = 2;
    figure
}

/// The picture of [`roughness`].
pub fn roughness_figure(title: &str, quantity: Quantity) -> Result<Figure> {
    let curves: Vec<Curve> = ROUGHNESSES
        .iter()
        .enumerate()
        .map(|(k, std)| Curve::new(k, &key(*std), &format!("σ_z = {:.1} µm", std * 1e6)))
        .collect();
    let same = "The model is AT as printed. With plasticity index and β_z fixed, R = 359 σ_z and η ∝ 1/σ_z² follow from σ_z.";
    let assumed = format!("{INPUTS} Assumed: the four values of σ_z.");
    Ok(figure(title, quantity, &curves, &[same, &assumed, MARKERS]))
}

/// The picture of [`nine_models`].
pub fn models_figure(title: &str, quantity: Quantity) -> Result<Figure> {
    let curves = PAPER.iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?;
    let assumed =
        format!("{INPUTS} Assumed: σ_z\u{a0}=\u{a0}1.0\u{a0}µm, so R\u{a0}=\u{a0}359\u{a0}µm.");
    let which = match quantity {
        Quantity::Stiffness => {
            " Stiffness is -dF/dd, for Gao and AT the papers' average of asperity stiffnesses."
        }
        _ => "",
    };
    Ok(figure(title, quantity, &curves, &[&format!("{assumed}{which}"), MARKERS]))
}

/// Measured points of figure 10, `separation_m,area_m2`, if the file exists.
fn measured() -> Result<Vec<[f64; 2]>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/kucharski.csv");
    let Ok(text) = std::fs::read_to_string(&path) else {
        return Ok(vec![]);
    };
    let mut lines = text.lines();
    let head = lines.next().unwrap_or_default();
    anyhow::ensure!(
        head.trim() == "separation_m,area_m2",
        "{}: the head is {head:?}; it must be separation_m,area_m2",
        path.display()
    );
    let rows = lines.enumerate().filter(|(_, line)| !line.trim().is_empty());
    rows.map(|(k, line)| {
        let place = || format!("{} line {}: {line:?}", path.display(), k + 2);
        let (x, y) = line.split_once(',').with_context(place)?;
        Ok([x.trim().parse().with_context(place)?, y.trim().parse().with_context(place)?])
    })
    .collect()
}

const MEASURED: &str = "measured";

/// Area of all models for Kucharski's steel, and the measured points if there are any.
pub fn kucharski() -> Result<Table> {
    let mut table = all_models(Quantity::Area, &models::kucharski()?)?;
    for [separation, area] in measured()? {
        table.push(&[Field::Word(MEASURED), Field::Number(separation), Field::Number(area)])?;
    }
    Ok(table)
}

/// The picture of [`kucharski`].
pub fn kucharski_figure(csv: &str) -> Result<Figure> {
    let mut curves = PAPER.iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?;
    let included = csv.lines().any(|line| line.starts_with("measured,"));
    let inputs = "Steel of Kucharski et al. (1994) on a rigid flat: E₁\u{a0}=\u{a0}200\u{a0}GPa, ν\u{a0}=\u{a0}0.3, Y\u{a0}=\u{a0}400\u{a0}MPa, so E\u{a0}=\u{a0}219.8\u{a0}GPa, G\u{a0}=\u{a0}45.2\u{a0}GPa, H\u{a0}=\u{a0}2.8\u{a0}Y\u{a0}=\u{a0}1.12\u{a0}GPa, S\u{a0}=\u{a0}0.577. The surface is not given: assumed σ_z\u{a0}=\u{a0}3\u{a0}µm, R\u{a0}=\u{a0}60\u{a0}µm, β_z\u{a0}=\u{a0}0.04, A_n\u{a0}=\u{a0}10⁻⁴\u{a0}m², Gaussian heights, d from the mean of the asperity heights.";
    if included {
        curves.push(Curve::points(10, MEASURED, "measured"));
    }
    let title = "Real contact area of a steel, nine models";
    let points = if included {
        MARKERS
    } else {
        "No measured points are included: markers distinguish the curves."
    };
    Ok(figure(title, Quantity::Area, &curves, &[inputs, points]))
}
