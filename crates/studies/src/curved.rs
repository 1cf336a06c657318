//! Curved bodies over smooth ones, against roughness: xtask/data/curved.csv.

use std::f64::consts::PI;
use std::path::PathBuf;

use anyhow::{Context, Result};
use asperity::{Interface, Model, Quantity, Scene, Surface, Tolerance};
use asperity_curved::{Curved, Shape};
use xtask::figures::curved::{BAHRAMI, CURVES, PANELS, WHEEL};
use xtask::folder::{root, save};
use xtask::table::Table;

/// Equivalent modulus, peak pressure of smooth spheres and hardness \[Pa\].
const MODULUS: f64 = 115e9;
const PEAK: f64 = 1.37e9;
const HARDNESS: f64 = 4e9;
/// Roughness, over which the asperities have the radius 500, and η R σ.
const SIGMA: f64 = 1e-6;
const RADIUS: f64 = 500.0;
const DENSITY: f64 = 0.05;
/// Values of α by decade from 10⁻² to 10.
const PER_DECADE: u32 = 6;
/// A wheel on a rail \[m, N\], and its roughness \[m\].
const BODIES: [f64; 2] = [0.46, 0.3];
const LOAD: f64 = 80e3;
const ROUGH: [f64; 7] = [0.5e-6, 1e-6, 2e-6, 3e-6, 5e-6, 10e-6, 20e-6];

/// The scene of a roughness \[m\].
fn scene(sigma: f64) -> Scene {
    let radius = RADIUS * sigma;
    let surface = Surface::new(radius, DENSITY / (radius * sigma), sigma);
    Scene::new(Interface::new(MODULUS, 0.3, HARDNESS), surface, 1.0)
}

/// The radius of spheres with this α, of their patch when smooth \[m\], and their load \[N\].
fn sphere(alpha: f64) -> [f64; 3] {
    // α = σ/δ with δ = (π p₀/(2 E))² R.
    let slope = PI * PEAK / (2.0 * MODULUS);
    let radius = SIGMA / (alpha * slope * slope);
    let a = slope * radius;
    [radius, a, 2.0 / 3.0 * PI * a * a * PEAK]
}

/// Peak pressure, axis along x and stiffness over those of smooth bodies, behind α.
fn ratios(id: &str, sigma: f64, shape: Shape, load: f64) -> Result<[f64; 4]> {
    let model: Model = id.parse()?;
    let asked = [Quantity::Area];
    let curved = Curved::new(&model, &scene(sigma), shape, &asked, Tolerance::new(1e-7)?)?;
    let mut found = curved.at_load(load)?;
    let hertz = found.hertz;
    let approach = hertz.approach.context("an approach")?;
    Ok([
        sigma / approach,
        found.peak_pressure() / hertz.peak_pressure,
        found.axes()[0] / hertz.axes[0],
        found.tangent()? / (1.5 * load / approach),
    ])
}

/// Peak pressure and radius of the patch by Bahrami, Yovanovich and Culham \[recalled\].
fn bahrami(alpha: f64, tau: f64) -> [f64; 2] {
    let peak = 1.0 / (1.0 + 1.37 * alpha * tau.powf(-0.075));
    let radius = if peak < 0.47 { 1.605 / peak.sqrt() } else { 3.51 - 2.51 * peak };
    [peak, radius]
}

/// Solves all of them; returns the path.
///
/// # Errors
/// A contact that cannot be solved, a file that cannot be written.
pub fn write() -> Result<Vec<PathBuf>> {
    let mut table = Table::new(&["panel", "curve", "alpha", "ratio"]);
    let mut rows: Vec<(&str, [f64; 4])> = vec![];
    let mut formula = vec![];
    for k in 0..=3 * PER_DECADE {
        let alpha = 0.01 * 10_f64.powf(f64::from(k) / f64::from(PER_DECADE));
        let [radius, a, load] = sphere(alpha);
        let ball = Shape::Point { radius_x: radius, radius_y: radius };
        for id in &CURVES[..3] {
            rows.push((id, ratios(id, SIGMA, ball, load)?));
        }
        formula.push((alpha, bahrami(alpha, radius / a)));
    }
    let wheel = Shape::Point { radius_x: BODIES[0], radius_y: BODIES[1] };
    for sigma in ROUGH {
        rows.push((WHEEL, ratios("ke", sigma, wheel, LOAD)?));
    }
    for (k, panel) in PANELS.iter().enumerate() {
        for (curve, [alpha, ratios @ ..]) in &rows {
            table.push(&[panel, curve], [*alpha, ratios[k]])?;
        }
        for (alpha, values) in &formula {
            if let Some(value) = values.get(k) {
                table.push(&[panel, BAHRAMI], [*alpha, *value])?;
            }
        }
    }
    save(&root().join("xtask/data"), [("curved.csv".to_owned(), table.into_text())])
}
