//! The laws of one asperity in every model.

use anyhow::Result;
use asperity::{Law, Model, Quantity, Tolerance};

use super::models::{self, MARKERS, curve};
use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel};

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
    let mut points: Vec<f64> =
        (0..=200).map(|k| 10f64.powf(-0.5 + 3.0 * f64::from(k) / 200.0)).collect();
    points.retain(|x| !kinks.iter().any(|k| (x / k - 1.0).abs() < 1e-3));
    points.extend(kinks.iter().flat_map(|k| [k * (1.0 - 1e-9), *k]));
    points.sort_by(f64::total_cmp);
    let mut grid = vec![];
    for x in points {
        if kinks.contains(&x) {
            grid.push(None);
        }
        grid.push(Some(x));
    }
    grid
}

/// Force and area of one asperity of the paper's scene; gaps mark jumps.
pub fn table() -> Result<Table> {
    let mut scene = models::scene(1e-6)?;
    let youngs_modulus = 2.0 * (1.0 - 0.31 * 0.31) * scene.interface.equivalent_modulus;
    scene.interface.tangent_modulus = Some(HARDENING * youngs_modulus);
    let asperity = scene.asperity()?;
    let critical = asperity.critical_interference()?;
    let force_unit = asperity.critical_force()?;
    let area_unit = std::f64::consts::PI * asperity.radius * critical;
    let mut table = Table::new(&["curve", X, COLUMNS[0].0, COLUMNS[1].0, COLUMNS[2].0]);
    for id in MODELS {
        let model: Model = id.parse()?;
        let law = |quantity| model.law(&asperity, quantity, Tolerance::default());
        let (force, area) = (law(Quantity::Force)?, law(Quantity::Area)?);
        for x in grid(&jumps(&model, &force, critical)) {
            let Some(x) = x else {
                table.push(&[Field::Word(id), Field::Gap, Field::Gap, Field::Gap, Field::Gap])?;
                continue;
            };
            let (f, a) = (force.value(x * critical)?, area.value(x * critical)?);
            // The mean pressure has no meaning where the printed sum is negative.
            let pressure = f / a / asperity.hardness()?;
            let pressure = if f > 0.0 && a > 0.0 { Field::Number(pressure) } else { Field::Gap };
            table.push(&[
                Field::Word(id),
                Field::Number(x),
                Field::Number(f / force_unit),
                Field::Number(a / area_unit),
                pressure,
            ])?;
        }
    }
    Ok(table)
}

/// Kinks of a law in x = w/w_c, inside the grid; an angle average is continuous and has no jumps.
fn jumps(model: &Model, law: &Law, critical: f64) -> Vec<f64> {
    if model.validity().angles {
        return vec![];
    }
    let kinks = law.kinks().into_iter().map(|x| x * law.interference_unit / critical);
    kinks.filter(|x| *x > 0.35 && *x < 310.0).collect()
}

/// Three panels with log axes.
pub fn style(_: &str) -> Result<Figure> {
    let panels = panels(&MODELS, "interference over critical interference")?;
    let caption = [
        "One asperity of the paper's scene (E = 116 GPa, ν = 0.31, H = 1.12 GPa, S = 0.58, R = 359 µm), in units of F_c\u{a0}=\u{a0}(2/3)πRw_cSH and A_c\u{a0}=\u{a0}πRw_c. Jumps are those of the published laws: CEB at 1, KE at 1, 6 and 110, Etsion at 170, JG and Ghaednia at 1.9 of their own unit. Ghaednia hardens: assumed E_t\u{a0}=\u{a0}0.02\u{a0}E_b of two like bodies. Gao and AT are averaged over the contact angles; AT as printed subtracts a part, and its curves break off where force or area is negative.",
        MARKERS,
    ];
    Ok(Figure::new("The laws of one asperity", &caption, panels))
}

/// The same for some models side by side, to be drawn from their rows.
pub fn some(models: &[&str]) -> Result<Figure> {
    let caption = "One asperity: interference w, force and area in units of w_c, F_c\u{a0}=\u{a0}(2/3)πRw_cSH and A_c\u{a0}=\u{a0}πRw_c, for E = 116 GPa, ν = 0.31, H = 1.12 GPa, S = 0.58; vertical lines at 1, 6 and 110 w_c. Dotted: jumps of the published laws.";
    let mut figure = Figure::new("", &[caption], panels(models, "w/w_c")?);
    figure.columns = COLUMNS.len();
    Ok(figure)
}

fn panels(models: &[&str], interference: &str) -> Result<Vec<Panel>> {
    // Gaps of AT are negative values; those of the others are jumps.
    let style = |id: &str| -> Result<Curve> {
        let mut curve = curve(id)?;
        curve.join_gaps = id != "at";
        Ok(curve)
    };
    let curves = models.iter().map(|id| style(id)).collect::<Result<Vec<_>>>()?;
    Ok(COLUMNS
        .map(|(column, label)| {
            let x = Axis::new(X, interference).log();
            let mut panel = Panel::new(x, Axis::new(column, label).log());
            panel.curves = curves.clone();
            panel.verticals = [1.0, 6.0, 110.0].map(|at| Mark::new(at, &format!("{at}"))).to_vec();
            panel
        })
        .to_vec())
}
