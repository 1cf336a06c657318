//! The three readings of the AT sum, compared with Gao and KE.

use anyhow::{Context, Result};
use asperity::{Model, Quantity, Request, linspace};
use rayon::prelude::*;

use super::models::{self, MARKERS, curve};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel, Strip};

const MODELS: [&str; 5] = ["at", "at-additive", "at-overlap", "gao", "ke"];
/// Separations over σ_z, a panel each.
const SEPARATIONS: [f64; 3] = [0.0, 2.0, 4.0];
const X: &str = "plasticity_index";
const Y: &str = "force_over_gw";

/// Force over GW's against the plasticity index, at three separations.
pub fn table() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let request = Request::new([Quantity::Force]);
    let reference = "gw".parse::<Model>()?.compile(&scene, &request)?;
    let critical = scene.asperity()?.critical_interference()?;
    let steps: Vec<f64> =
        linspace(0.3f64.ln(), 30f64.ln(), 201).into_iter().map(f64::exp).collect();
    let curves = MODELS
        .par_iter()
        .map(|id| {
            // One law for all plasticity indices: only σ_z changes.
            let compiled = id.parse::<Model>()?.compile(&scene, &request)?;
            let mut rows = vec![];
            for psi in &steps {
                let mut rougher = scene.clone();
                rougher.surface.asperity_height_std = psi * psi * critical;
                let (model, gw) = (compiled.on(&rougher)?, reference.on(&rougher)?);
                for s in SEPARATIONS {
                    let [a, b] = [&model, &gw].map(|c| c.evaluate(Quantity::Force, s));
                    rows.push((panel_key(s), *psi, a?.value() / b?.value()));
                }
            }
            Ok(rows)
        })
        .collect::<Result<Vec<_>>>()?;
    let mut table = Table::new(&["separation_over_sigma", "curve", X, Y]);
    for separation in SEPARATIONS {
        let key = panel_key(separation);
        for (id, rows) in MODELS.iter().zip(&curves) {
            for (_, psi, ratio) in rows.iter().filter(|(s, ..)| *s == key) {
                let fields = [
                    Field::Word(&key),
                    Field::Word(id),
                    Field::Number(*psi),
                    Field::Number(*ratio),
                ];
                table.push(&fields)?;
            }
        }
    }
    Ok(table)
}

fn panel_key(separation: f64) -> String {
    format!("{separation}")
}

/// The window of the plasticity index in which the printed reading is negative, from the csv.
fn negative_window(csv: &str, separation: f64) -> Result<Option<(f64, f64)>> {
    let start = format!("{},at,", panel_key(separation));
    let mut crossings = vec![];
    let mut before: Option<(f64, f64)> = None;
    for row in csv.lines().filter_map(|line| line.strip_prefix(&start)) {
        let (x, y) = row.split_once(',').context("a row of two numbers")?;
        let now: (f64, f64) = (x.parse()?, y.parse()?);
        if let Some(before) = before.filter(|before| before.1.signum() * now.1.signum() < 0.0) {
            crossings.push(before.0 + (now.0 - before.0) * before.1 / (before.1 - now.1));
        }
        before = Some(now);
    }
    Ok(match crossings[..] {
        [from, to] => Some((from, to)),
        _ => None,
    })
}

/// A panel for each separation, the negative window shaded.
pub fn style(csv: &str) -> Result<Figure> {
    let mut curves = MODELS[3..].iter().map(|id| curve(id)).collect::<Result<Vec<_>>>()?;
    let readings = ["AT as printed", "AT additive", "AT overlap"];
    for (k, (id, label)) in MODELS.iter().zip(readings).enumerate() {
        curves.insert(k, Curve::new([8, 0, 1][k], id, label));
    }
    let mut panels = vec![];
    for separation in SEPARATIONS {
        let x = Axis::new(X, "plasticity index ψ").log();
        let mut panel = Panel::new(x, Axis::new(Y, "force over GW's"));
        panel.only = Some(("separation_over_sigma".into(), panel_key(separation)));
        panel.title = format!("d = {separation}\u{a0}σ_z");
        panel.curves = curves.clone();
        panel.horizontals = vec![Mark::new(0.0, "")];
        if let Some((from, to)) = negative_window(csv, separation)? {
            panel.title += &format!(": AT as printed is negative for ψ = {from:.2} to {to:.2}");
            panel.strips = vec![Strip::upright(from, to, "")];
        }
        panels.push(panel);
    }
    let caption = "Printed: I[e;0,1] - I[ep1;1,6] + I[ep2;6,110] + I[p;110,∞]; additive: all plus; overlap: I[e;0,6] - I[ep1;1,6] + I[ep2;1,110] + I[p;110,∞]. Interface and R = 359 µm of the paper's scene; σ_z varies with the plasticity index. Gao and additive almost coincide.";
    Ok(Figure::new("Three readings of the AT sum", &[caption, MARKERS], panels))
}
