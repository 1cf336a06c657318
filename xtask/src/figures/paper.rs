//! Figures 4 to 10 of Amini & Tehrani (2020).

use std::path::Path;

use anyhow::{Context, Result};
use asperity::{Model, Quantity, Request, Response, Scene, Tolerance, linspace};
use rayon::prelude::*;

use super::models::{self, INPUTS, MARKERS, PAPER, curve};
use crate::draw::{Arrangement, Axis, Colour, CurveStyle, Figure, Marker, Note, Panel, Shape};
use crate::table::{Field, Table};

/// σ_z of figures 4, 6 and 8 [m]; not in the paper, assumed.
const ROUGHNESSES: [f64; 4] = [0.5e-6, 1.0e-6, 1.5e-6, 2.0e-6];
/// σ_z of figures 5, 7 and 9 [m]; assumed.
const ROUGHNESS: f64 = 1.0e-6;
/// Figures are drawn from values far better than a line's width, and guarded to 1e-7.
const TOLERANCE: f64 = 1e-9;

fn solve(model: &str, scene: &Scene, quantity: Quantity) -> Result<Response> {
    let model: Model = model.parse()?;
    let separations = linspace(0.0, 4.0, 201);
    let request = Request::new([quantity]).at(separations).within(Tolerance::new(TOLERANCE)?);
    Ok(model.solve(scene, &request)?)
}

fn column(quantity: Quantity) -> String {
    format!("{quantity}_{}", quantity.unit())
}

/// One curve for each (key, model, scene).
fn curves(quantity: Quantity, list: &[(String, &str, Scene)]) -> Result<Table> {
    let solved: Vec<Response> = list
        .par_iter()
        .map(|(_, model, scene)| solve(model, scene, quantity))
        .collect::<Result<_>>()?;
    let mut table = Table::new(&["curve", "separation_m", &column(quantity)]);
    for ((key, _, _), response) in list.iter().zip(&solved) {
        for (s, value) in response.separations.iter().zip(response.values(quantity)?) {
            let separation = s * response.asperity_height_std;
            table.push(&[Field::Word(key), Field::Number(separation), Field::Number(*value)])?;
        }
    }
    Ok(table)
}

fn roughness(quantity: Quantity) -> Result<Table> {
    let list = ROUGHNESSES
        .iter()
        .map(|std| Ok((key(*std), "at", models::scene(*std)?)))
        .collect::<Result<Vec<_>>>()?;
    curves(quantity, &list)
}

fn key(std: f64) -> String {
    format!("sigma_z={:.1}e-6", std * 1e6)
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
        Quantity::Stiffness | Quantity::Tangent => ("stiffness K (N/µm)", 1e-6),
    };
    Axis::new(&column(quantity), label).times(factor)
}

/// A linear and a logarithmic panel of the same curves.
fn panels(quantity: Quantity, curves: &[CurveStyle]) -> Vec<Panel> {
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

fn figure(title: &str, quantity: Quantity, curves: &[CurveStyle], caption: &[&str]) -> Figure {
    Figure {
        title: title.into(),
        caption: caption.iter().map(|line| (*line).to_owned()).collect(),
        panels: panels(quantity, curves),
        arrangement: Arrangement::SideBySide,
        shared_legend: true,
        ..Figure::default()
    }
}

fn roughness_figure(title: &str, quantity: Quantity) -> Result<Figure> {
    let curves: Vec<CurveStyle> = ROUGHNESSES
        .iter()
        .enumerate()
        .map(|(k, std)| CurveStyle::numbered(k, &key(*std), &format!("σ_z = {:.1} µm", std * 1e6)))
        .collect();
    let same = "The model is AT as printed. With plasticity index and β_z fixed, R = 359 σ_z and η ∝ 1/σ_z² follow from σ_z.";
    let assumed = format!("{INPUTS} Assumed: the four values of σ_z.");
    Ok(figure(title, quantity, &curves, &[same, &assumed, MARKERS]))
}

fn models_figure(title: &str, quantity: Quantity) -> Result<Figure> {
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

/// Force of AT for several roughnesses.
pub fn table_04() -> Result<Table> {
    roughness(Quantity::Force)
}

/// Force of all models.
pub fn table_05() -> Result<Table> {
    all_models(Quantity::Force, &models::scene(ROUGHNESS)?)
}

/// Area of AT for several roughnesses.
pub fn table_06() -> Result<Table> {
    roughness(Quantity::Area)
}

/// Area of all models.
pub fn table_07() -> Result<Table> {
    all_models(Quantity::Area, &models::scene(ROUGHNESS)?)
}

/// Stiffness of AT for several roughnesses.
pub fn table_08() -> Result<Table> {
    roughness(Quantity::Stiffness)
}

/// Stiffness of all models.
pub fn table_09() -> Result<Table> {
    all_models(Quantity::Stiffness, &models::scene(ROUGHNESS)?)
}

/// Measured points of figure 10: `separation_m,area_m2`, if anybody has put them there.
fn measured() -> Result<Vec<[f64; 2]>> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/kucharski.csv");
    let Ok(text) = std::fs::read_to_string(&path) else {
        return Ok(vec![]);
    };
    let mut lines = text.lines();
    let head = lines.next().unwrap_or_default();
    anyhow::ensure!(
        head.trim() == "separation_m,area_m2",
        "{}: head is {head:?}, separation_m,area_m2 was required",
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

/// Area of all models for Kucharski's steel, and his points if there are any.
pub fn table_10() -> Result<Table> {
    let mut table = all_models(Quantity::Area, &models::kucharski()?)?;
    for [separation, area] in measured()? {
        table.push(&[Field::Word(MEASURED), Field::Number(separation), Field::Number(area)])?;
    }
    Ok(table)
}

/// Figure 4.
pub fn style_04(_: &str) -> Result<Figure> {
    roughness_figure("Contact force against separation, AT model", Quantity::Force)
}

/// Figure 5.
pub fn style_05(_: &str) -> Result<Figure> {
    models_figure("Contact force against separation, nine models", Quantity::Force)
}

/// Figure 6.
pub fn style_06(_: &str) -> Result<Figure> {
    roughness_figure("Real contact area against separation, AT model", Quantity::Area)
}

/// Figure 7.
pub fn style_07(_: &str) -> Result<Figure> {
    models_figure("Real contact area against separation, nine models", Quantity::Area)
}

/// Figure 8.
pub fn style_08(_: &str) -> Result<Figure> {
    roughness_figure("Contact stiffness against separation, AT model", Quantity::Stiffness)
}

/// Figure 9.
pub fn style_09(_: &str) -> Result<Figure> {
    models_figure("Contact stiffness against separation, nine models", Quantity::Stiffness)
}

/// Figure 10.
pub fn style_10(csv: &str) -> Result<Figure> {
    let mut curves = PAPER.iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?;
    let included = csv.lines().any(|line| line.starts_with("measured,"));
    let inputs = "Steel of Kucharski et al. (1994) on a rigid flat: E₁\u{a0}=\u{a0}200\u{a0}GPa, ν\u{a0}=\u{a0}0.3, Y\u{a0}=\u{a0}400\u{a0}MPa, so E\u{a0}=\u{a0}219.8\u{a0}GPa, G\u{a0}=\u{a0}45.2\u{a0}GPa, H\u{a0}=\u{a0}2.8\u{a0}Y\u{a0}=\u{a0}1.12\u{a0}GPa, S\u{a0}=\u{a0}0.577. The surface is not given: assumed σ_z\u{a0}=\u{a0}3\u{a0}µm, R\u{a0}=\u{a0}60\u{a0}µm, β_z\u{a0}=\u{a0}0.04, A_n\u{a0}=\u{a0}10⁻⁴\u{a0}m², Gaussian heights, d from the mean of the asperity heights.";
    if included {
        let marker = Marker::filled(Shape::Diamond);
        curves.push(CurveStyle::points(MEASURED, "measured", marker, Colour::BLACK));
    }
    let title = "Real contact area of a steel, nine models";
    let mut figure = figure(title, Quantity::Area, &curves, &[inputs, MARKERS]);
    if !included {
        for panel in &mut figure.panels {
            panel.notes = vec![Note::new("no measured points included")];
        }
    }
    Ok(figure)
}
