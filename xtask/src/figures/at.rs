//! The three readings of the AT sum, compared with Gao and KE, and the shares of the regimes in the
//! force.

use anyhow::Result;
use asperity::{Model, Quantity, Request, linspace};
use asperity_plot::{Axis, Figure, Mark, Strip};
use rayon::prelude::*;

use super::models::{self, beside, curves, geometric, named, of, panel, separation_axis};
use crate::table::Table;

const READINGS: [(&str, usize); 3] = [("at", 8), ("at-additive", 34), ("at-overlap", 11)];
const OTHERS: [&str; 2] = ["gao", "ke"];
/// Separations over σ_z, a panel each.
const SEPARATIONS: [f64; 3] = [0.0, 2.0, 4.0];
const X: &str = "plasticity_index";

/// Force over GW's against the plasticity index, at three separations.
pub fn readings() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let request = Request::new([Quantity::Force]);
    let reference = "gw".parse::<Model>()?.compile(&scene, &request)?;
    let critical = scene.asperity()?.critical_interference()?;
    let steps = geometric(0.3, 30.0, 201);
    let ids: Vec<&str> = READINGS.iter().map(|reading| reading.0).chain(OTHERS).collect();
    let ratios = |id: &&str| -> Result<Vec<[f64; 3]>> {
        // One law for all plasticity indices: only σ_z changes.
        let compiled = id.parse::<Model>()?.compile(&scene, &request)?;
        let at = |psi: &f64| -> Result<[f64; 3]> {
            let mut rougher = scene.clone();
            rougher.surface.asperity_height_std = psi * psi * critical;
            let (model, gw) = (compiled.on(&rougher)?, reference.on(&rougher)?);
            let ratio = |s: f64| -> Result<f64> {
                let [a, b] = [&model, &gw].map(|c| c.evaluate(Quantity::Force, s));
                Ok(a?.value() / b?.value())
            };
            let [a, b, c] = SEPARATIONS.map(ratio);
            Ok([a?, b?, c?])
        };
        steps.iter().map(at).collect()
    };
    let all = ids.par_iter().map(ratios).collect::<Result<Vec<_>>>()?;
    let mut table = Table::new(&["separation_over_sigma", "curve", X, "force_over_gw"]);
    for (k, separation) in SEPARATIONS.iter().enumerate() {
        for (id, ratios) in ids.iter().zip(&all) {
            for (psi, ratio) in steps.iter().zip(ratios) {
                table.push(&[&separation.to_string(), id], [*psi, ratio[k]])?;
            }
        }
    }
    Ok(table)
}

/// The window of the plasticity index in which the printed reading is negative, from the csv.
fn negative_window(csv: &str, separation: f64) -> Result<Option<(f64, f64)>> {
    let start = format!("{separation},at,");
    let rows = csv.lines().filter_map(|line| line.strip_prefix(&start)?.split_once(','));
    let points = rows.map(|(x, y)| Ok((x.parse()?, y.parse()?)));
    let points: Vec<(f64, f64)> = points.collect::<Result<_>>()?;
    let crossing = |pair: &[(f64, f64)]| match *pair {
        [a, b] if a.1.signum() * b.1.signum() < 0.0 => Some(a.0 + (b.0 - a.0) * a.1 / (a.1 - b.1)),
        _ => None,
    };
    let crossings: Vec<f64> = points.windows(2).filter_map(crossing).collect();
    Ok(if let [from, to] = crossings[..] { Some((from, to)) } else { None })
}

/// The picture of [`readings`]: a panel for each separation, the negative window shaded.
pub fn readings_figure(csv: &str) -> Result<Figure> {
    let curves = [named(&READINGS), curves(&OTHERS)?].concat();
    let mut panels = vec![];
    for separation in SEPARATIONS {
        let (x, y) =
            (Axis::new(X, "plasticity index ψ"), Axis::new("force_over_gw", "force over GW's"));
        let (key, title) = (separation.to_string(), format!("d = {separation}\u{a0}σ_z"));
        let mut panel = of("separation_over_sigma", &key, &title, panel(&x.log(), y, &curves));
        panel.horizontals = vec![Mark::new(0.0, "")];
        if let Some((from, to)) = negative_window(csv, separation)? {
            panel.title += &format!(": AT as printed is negative for ψ = {from:.2} to {to:.2}");
            panel.strips = vec![Strip::upright(from, to, "")];
        }
        panels.push(panel);
    }
    Ok(beside(1, panels))
}

/// The readings whose regimes are shown, with their titles.
const SHOWN: [(&str, &str); 2] =
    [("at", "as printed: shares are signed"), ("at-additive", "additive reading")];
const PARTS: [(&str, usize); 4] =
    [("elastic", 0), ("elastic-plastic 1", 1), ("elastic-plastic 2", 2), ("plastic", 3)];

/// Shares of the force for two readings.
pub fn shares() -> Result<Table> {
    let scene = models::scene(1e-6)?;
    let std = scene.surface.asperity_height_std;
    let mut table = Table::new(&["reading", "curve", "separation_m", "share_of_force"]);
    for (id, _) in SHOWN {
        let model: Model = id.parse()?;
        let compiled = model.compile(&scene, &Request::new([Quantity::Force]))?;
        let separations = linspace(0.0, 4.0, 201);
        let shares = separations.iter().map(|s| compiled.shares(Quantity::Force, *s));
        let shares = shares.collect::<Result<Vec<_>, _>>()?;
        for (part, ..) in PARTS {
            for (s, shares) in separations.iter().zip(&shares) {
                for share in shares.iter().filter(|share| share.name == part) {
                    table.push(&[id, part], [s * std, share.share])?;
                }
            }
        }
    }
    Ok(table)
}

/// The picture of [`shares`]: signed lines for the printed reading, stacked areas for the additive
/// one.
pub fn shares_figure(_: &str) -> Result<Figure> {
    let panels = SHOWN.map(|(id, title)| {
        let y = Axis::new("share_of_force", "share of the force");
        let mut panel = of("reading", id, title, panel(&separation_axis(), y, &named(&PARTS)));
        panel.stacked = id == "at-additive";
        if !panel.stacked {
            panel.horizontals = vec![Mark::new(0.0, "")];
        }
        panel
    });
    Ok(beside(1, panels))
}
