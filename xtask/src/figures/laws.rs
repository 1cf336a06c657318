//! The laws of one asperity in every model.

use anyhow::Result;
use asperity::{Model, Quantity, Tolerance};
use asperity_plot::{Axis, Figure, Mark};

use super::models::{self, beside, curves, geometric, panel};
use crate::table::Table;

/// All models, with one reading of AT.
const MODELS: [&str; 11] =
    ["gw", "ceb", "zmc", "ke", "etsion", "jg", "jg-cosine", "ghaednia", "af", "gao", "at"];
/// Assumed: E_t/E_b, of the model with hardening.
const HARDENING: f64 = 0.02;
const X: &str = "interference_over_critical";
const COLUMNS: [(&str, &str); 3] = [
    ("force_over_critical", "force over critical force"),
    ("area_over_critical", "area over critical area"),
    ("mean_pressure_over_hardness", "mean pressure/hardness"),
];

/// Points of x = w/w_c: a logarithmic grid with, at every jump, the values on both sides and a gap.
fn grid(kinks: &[f64]) -> Vec<Option<f64>> {
    let mut points = geometric(10f64.powf(-0.5), 10f64.powf(2.5), 201);
    points.retain(|x| !kinks.iter().any(|k| (x / k - 1.0).abs() < 1e-3));
    points.extend(kinks.iter().flat_map(|k| [k * (1.0 - 1e-9), *k]));
    points.sort_by(f64::total_cmp);
    let with_gap = |x| if kinks.contains(&x) { vec![None, Some(x)] } else { vec![Some(x)] };
    points.into_iter().flat_map(with_gap).collect()
}

/// Force and area of one asperity of the paper's scene in all models; gaps mark jumps.
pub fn table() -> Result<Table> {
    let mut scene = models::scene(1e-6)?;
    let youngs_modulus = 2.0 * (1.0 - 0.31 * 0.31) * scene.interface.equivalent_modulus;
    scene.interface.tangent_modulus = Some(HARDENING * youngs_modulus);
    let asperity = scene.asperity()?;
    let (critical, force_unit) = (asperity.critical_interference()?, asperity.critical_force()?);
    let area_unit = std::f64::consts::PI * asperity.radius * critical;
    let mut table = Table::new(&["curve", X, COLUMNS[0].0, COLUMNS[1].0, COLUMNS[2].0]);
    for id in MODELS {
        let model: Model = id.parse()?;
        let law = |quantity| model.law(&asperity, quantity, Tolerance::default());
        let (force, area) = (law(Quantity::Force)?, law(Quantity::Area)?);
        let mut kinks: Vec<f64> =
            force.kinks().into_iter().map(|x| x * force.interference_unit / critical).collect();
        // An angle average is continuous and has no jumps.
        kinks.retain(|x| *x > 0.35 && *x < 310.0 && !model.validity().angles);
        for x in grid(&kinks) {
            let Some(x) = x else {
                table.push(&[id], [None::<f64>; 4])?;
                continue;
            };
            let (f, a) = (force.value(x * critical)?, area.value(x * critical)?);
            // The mean pressure has no meaning where the printed sum is negative.
            let pressure = (f > 0.0 && a > 0.0).then_some(f / a / asperity.hardness()?);
            table.push(&[id], [Some(x), Some(f / force_unit), Some(a / area_unit), pressure])?;
        }
    }
    Ok(table)
}

/// Three panels with log axes.
pub fn style(_: &str) -> Result<Figure> {
    let mut curves = curves(&MODELS)?;
    // Gaps of AT are negative values, gaps of the others jumps.
    curves.iter_mut().for_each(|curve| curve.join_gaps = curve.key != "at");
    let panel = |(column, label)| {
        let x = Axis::new(X, "interference over critical interference").log();
        let mut panel = panel(&x, Axis::new(column, label).log(), &curves);
        panel.verticals = [1.0, 6.0, 110.0].map(|at| Mark::new(at, &format!("{at}"))).to_vec();
        panel
    };
    Ok(beside(1, COLUMNS.map(panel)))
}
