//! The angle density as printed in the paper, and folded.

use anyhow::Result;
use asperity::AngleDensity;

use crate::table::{Field, Table};
use asperity_plot::{Axis, Curve, Figure, Mark, Panel, Strip};

const AZIMUTHS: [(f64, &str); 4] =
    [(45.0, "theta=45"), (90.0, "theta=90"), (135.0, "theta=135"), (225.0, "theta=225")];
const FOLDED: &str = "folded";

/// 4π ψ over the polar angle for several azimuths, and the folded density.
pub fn table() -> Result<Table> {
    let density = AngleDensity::default();
    let mut table = Table::new(&["curve", "phi_degree", "four_pi_density"]);
    let mut add = |key: &str, phi: f64, value: f64| {
        table.push(&[Field::Word(key), Field::Number(phi), Field::Number(value)])
    };
    for (theta, key) in AZIMUTHS {
        for k in 0..=180 {
            add(key, f64::from(k), density.printed(f64::from(k).to_radians(), theta.to_radians()))?;
        }
    }
    for k in 0..=180 {
        let u = f64::from(k).to_radians().cos().abs();
        add(FOLDED, f64::from(k), density.folded().map_or(0.0, |(c0, c2)| c0 + c2 * u * u))?;
    }
    Ok(table)
}

/// One panel with the negative region marked.
pub fn style(_: &str) -> Result<Figure> {
    let x =
        Axis::new("phi_degree", "polar angle φ (degrees; 0 and 180 are upright)").range(0.0, 180.0);
    let mut panel =
        Panel::new(x, Axis::new("four_pi_density", "angle density 4πψ").range(-1.6, 3.6));
    panel.curves = AZIMUTHS
        .iter()
        .enumerate()
        .map(|(k, (theta, key))| Curve::new(k + 1, key, &format!("as printed, θ = {theta}°")))
        .collect();
    panel.curves.push(Curve::new(0, FOLDED, "as used (folded)"));
    panel.strips = vec![Strip::across(f64::NEG_INFINITY, 0.0, "negative: no density")];
    panel.horizontals = vec![Mark::new(0.0, "")];
    let title = "Density of contact normals, as printed and as used";
    let caption = "4πψ = 1 + a₂₀P₂(cos φ) + (a₂₁cos θ + b₂₁sin θ)P₂¹(cos φ) with a₂₀ = -0.5, a₂₁ = b₂₁ = 1, as printed by Amini & Tehrani (2020). It is negative on 21.9 % of the sphere, down to -1.279. A normal and its opposite are one contact: folding them leaves 1.25 - 0.75 cos²φ, and the terms with a₂₁ and b₂₁ change no result. Markers distinguish the curves.";
    Ok(Figure::new(title, &[caption], vec![panel]))
}
