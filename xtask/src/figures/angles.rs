//! The angle density as printed in the paper, and folded.

use anyhow::Result;
use asperity::AngleDensity;
use asperity_plot::{Axis, Figure, Mark, Strip};

use super::models::{beside, named, panel};
use crate::table::Table;

/// Azimuths in degrees, with their curves.
const AZIMUTHS: [(f64, &str); 4] =
    [(45.0, "theta=45"), (90.0, "theta=90"), (135.0, "theta=135"), (225.0, "theta=225")];
const FOLDED: &str = "folded";

/// 4π ψ over the polar angle for several azimuths, and the folded density.
pub fn table() -> Result<Table> {
    let density = AngleDensity::default();
    let mut table = Table::new(&["curve", "phi_degree", "four_pi_density"]);
    let angles = || (0..=180).map(f64::from);
    for (theta, key) in AZIMUTHS {
        for phi in angles() {
            table.push(&[key], [phi, density.printed(phi.to_radians(), theta.to_radians())])?;
        }
    }
    for phi in angles() {
        let u = phi.to_radians().cos().abs();
        table.push(&[FOLDED], [phi, density.folded().map_or(0.0, |(c0, c2)| c0 + c2 * u * u)])?;
    }
    Ok(table)
}

/// One panel with the negative region marked.
pub fn style(_: &str) -> Result<Figure> {
    let x =
        Axis::new("phi_degree", "polar angle φ (degrees; 0 and 180 are upright)").range(0.0, 180.0);
    let y = Axis::new("four_pi_density", "angle density 4πψ").range(-1.6, 3.6);
    let printed = AZIMUTHS.iter().zip(1..).map(|((_, key), look)| (*key, look));
    let curves: Vec<_> = printed.chain([(FOLDED, 0)]).collect();
    let mut panel = panel(&x, y, &named(&curves));
    panel.strips = vec![Strip::across(f64::NEG_INFINITY, 0.0, "negative: no density")];
    panel.horizontals = vec![Mark::new(0.0, "")];
    Ok(beside(1, [panel]))
}
