//! Rough spheres by Newton's method and by the fixed-point iteration of Greenwood and Tripp:
//! `speed-curved.md`.

use std::f64::consts::PI;
use std::hint::black_box;

use anyhow::{Context, Result};
use asperity::{Contact, ContactModel, Model, Quantity, Request, Scene, Tolerance};
use asperity_curved::{Curved, Shape, elliptic};
use xtask::table::{markdown_head, markdown_row};

use super::markdown::duration;
use super::ours::median_ns;
use crate::curved::{MODULUS, SIGMA, scene, sphere};

/// The public code's relaxation, and the change of the deflection over σ at which it ends.
const RELAXATION: f64 = 0.3;
const CHANGE: f64 = 1e-3;
const MOST: usize = 500;
const RINGS: usize = 300;
/// Values of α = σ/(approach of smooth spheres).
const ALPHAS: [f64; 4] = [0.3, 0.1, 0.05, 0.03];
/// Loads of a sweep, from a tenth on.
const SWEEP: u32 = 50;

/// Spheres with GW's asperities under a load.
struct Spheres {
    radius: f64,
    load: f64,
    model: Model,
    scene: Scene,
}

impl Spheres {
    fn new(alpha: f64) -> Result<Self> {
        let [radius, _, load] = sphere(alpha);
        Ok(Self { radius, load, model: "gw".parse()?, scene: scene(SIGMA) })
    }

    fn curved(&self, tolerance: f64) -> Result<Curved> {
        let ball = Shape::Point { radius_x: self.radius, radius_y: self.radius };
        Ok(Curved::new(&self.model, &self.scene, ball, &[], Tolerance::new(tolerance)?)?)
    }
}

/// The deflection at r under a unit pressure on a disc, times the modulus (Johnson 1985, 3.29).
fn under_disc(radius: f64, r: f64) -> f64 {
    if radius == 0.0 {
        return 0.0;
    }
    let [inner, outer] = [r.min(radius), r.max(radius)];
    let ratio = (inner / outer).min(1.0 - 1e-12);
    let [k, difference] = elliptic((1.0 - ratio * ratio).sqrt());
    let e = k - ratio * ratio * difference;
    let outside = e - (1.0 - ratio * ratio) * k;
    4.0 / PI * outer * if r < radius { e } else { outside }
}

/// The iteration on rings, which take much of its time once.
struct FixedPoint {
    layer: Box<dyn Contact>,
    radius: f64,
    rings: usize,
    step: f64,
    /// Deflections in the middle of rings under unit pressures on each.
    matrix: Vec<f64>,
}

impl FixedPoint {
    fn new(of: &Spheres, reach: f64, rings: usize) -> Result<Self> {
        let layer = of.model.compile(&of.scene, &Request::new([Quantity::Force]))?;
        let step = reach / rings as f64;
        let edge = |k: usize, i: usize| under_disc(k as f64 * step, (i as f64 + 0.5) * step);
        let all = (0..rings).flat_map(|i| (0..rings).map(move |k| (k, i)));
        let matrix = all.map(|(k, i)| (edge(k + 1, i) - edge(k, i)) / MODULUS).collect();
        Ok(Self { layer, radius: of.radius, rings, step, matrix })
    }

    /// Iterations and the load at an approach; `None` where it does not converge.
    fn solve(&self, approach: f64) -> Result<Option<(usize, f64)>> {
        let rings = self.rings;
        let middle = |k: usize| (k as f64 + 0.5) * self.step;
        let parted = |k: usize| middle(k).powi(2) / (2.0 * self.radius) - approach;
        // From smooth bodies in touch.
        let mut u: Vec<f64> = (0..rings).map(|k| (-parted(k)).max(0.0)).collect();
        let mut p = vec![0.0; rings];
        for iteration in 1..=MOST {
            let gaps: Vec<f64> = (0..rings).map(|k| (parted(k) + u[k]) / SIGMA).collect();
            self.layer.fill(&[Quantity::Force], &gaps, &mut [&mut p])?;
            let mut change = 0.0_f64;
            for (own, row) in u.iter_mut().zip(self.matrix.chunks(rings)) {
                let off = row.iter().zip(&p).map(|(a, p)| a * p).sum::<f64>() - *own;
                *own += RELAXATION * off;
                change = change.max(off.abs() / SIGMA);
            }
            if change < CHANGE {
                let load = (0..rings).map(|k| p[k] * 2.0 * PI * middle(k) * self.step).sum();
                return Ok(Some((iteration, load)));
            }
        }
        Ok(None)
    }
}

/// The rows of a roughness: the method, its steps, its time and its error.
fn rows(alpha: f64) -> Result<Vec<[String; 5]>> {
    let spheres = Spheres::new(alpha)?;
    let right = spheres.curved(1e-8)?;
    let right = right.at_load(spheres.load)?;
    let approach = right.approach().context("an approach")?;
    let error = |value: f64, right: f64, size: f64| format!("{:.1e}", (value - right).abs() / size);
    let named = |method: &str, steps: String, ns: f64, error: String| {
        [alpha.to_string(), method.into(), steps, duration(ns), error]
    };
    let mut rows = vec![];
    for tolerance in [1e-3, 1e-6] {
        let curved = spheres.curved(tolerance)?;
        let ns = median_ns(|| drop(black_box(curved.at_approach(black_box(approach)))));
        let found = curved.at_approach(approach)?;
        let (steps, off) = (found.work().steps, error(found.load(), spheres.load, spheres.load));
        let method = format!("ours at an approach, {tolerance:e}");
        rows.push(named(&method, steps.to_string(), ns, off));
    }
    let fixed = FixedPoint::new(&spheres, 4.0 * right.axes()[0], RINGS)?;
    let (found, method) = (fixed.solve(approach)?, "fixed point at an approach");
    let ns = median_ns(|| drop(black_box(fixed.solve(black_box(approach)))));
    rows.push(match found {
        Some((steps, load)) => {
            named(method, steps.to_string(), ns, error(load, spheres.load, spheres.load))
        }
        None => named(method, format!("{MOST}"), ns, "diverges".into()),
    });
    let curved = spheres.curved(1e-6)?;
    let ns = median_ns(|| drop(black_box(curved.at_load(black_box(spheres.load)))));
    let found = curved.at_load(spheres.load)?;
    let off = found.approach().context("an approach")?;
    let (steps, size) = (found.work().steps, approach.abs().max(SIGMA));
    rows.push(named("ours at a load, 1e-6", steps.to_string(), ns, error(off, approach, size)));
    let loads = (0..SWEEP).map(|k| spheres.load * 10_f64.powf(f64::from(k) / 49.0 - 1.0));
    let loads: Vec<f64> = loads.collect();
    let ns = median_ns(|| loads.iter().for_each(|load| drop(black_box(curved.at_load(*load)))));
    rows.push(named("ours, a sweep of 50 loads, 1e-6", String::new(), ns, String::new()));
    Ok(rows)
}

/// The Markdown.
///
/// # Errors
/// A contact that cannot be solved.
pub fn text(machine: &str) -> Result<String> {
    let mut text = format!(
        "# Rough spheres: speed against error

Written by `cargo xtask report`; measured on {machine}, on one thread. Times are medians of one process and one run.

GW's asperities between spheres with p₀ = 1.37 GPa when smooth, E = 115 GPa, ηRσ = 0.05, R = 500 σ, against α = σ/(approach of smooth spheres). The fixed point is the iteration of the public Greenwood-Tripp code, here on {RINGS} rings: relaxation {RELAXATION}, until the deflection changes by less than {CHANGE:e} σ; its time leaves out the {RINGS} x {RINGS} deflections of rings. Errors are those of the load at an approach, and of the approach at a load over the larger of approach and σ, against our solution to 1e-8.

{}",
        markdown_head(&["α", "method", "steps", "time", "error"], 3)
    );
    for alpha in ALPHAS {
        rows(alpha)?.iter().for_each(|row| text += &markdown_row(row));
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both give the same contact of rough bodies; of smoother ones only Newton's method does.
    #[test]
    fn the_fixed_point_takes_more_steps_and_diverges_for_smooth_bodies() -> Result<()> {
        let mut found = vec![];
        for alpha in [0.3, 0.03] {
            let spheres = Spheres::new(alpha)?;
            let curved = spheres.curved(1e-6)?;
            let newton = curved.at_load(spheres.load)?;
            let fixed = FixedPoint::new(&spheres, 4.0 * newton.axes()[0], 100)?;
            let fixed = fixed.solve(newton.approach().context("an approach")?)?;
            if let Some((_, carried)) = fixed {
                let off = carried / spheres.load - 1.0;
                assert!(off.abs() < 3e-3, "{alpha}: {off}");
            }
            found.push((newton.work().steps, fixed.map(|(count, _)| count)));
        }
        assert!(found.iter().all(|(steps, _)| *steps <= 6), "{found:?}");
        let counts: Vec<_> = found.into_iter().map(|(_, count)| count).collect();
        assert_eq!(counts, [Some(20), None]);
        Ok(())
    }
}
