//! Boundary elements against closed forms, against an independent solver, and against themselves.

#![allow(clippy::unwrap_used, reason = "tests")]

mod closed_forms;
mod codes;

mod inputs;
mod invariants;
mod leaks;
mod light_contacts;
mod light_loads;
mod lists;
mod model;
mod notes;
mod plasticity;
mod reference;
mod sealing;
mod slip;
mod steps;
mod surfaces;
mod unloading;
mod yielding;

use asperity_bem::{BemOptions, Continuation, HeightMap, RandomSurface};

/// Whether long cases run as well: `.ci/full` sets `ASPERITY_LONG`.
fn is_long() -> bool {
    std::env::var_os("ASPERITY_LONG").is_some()
}

/// A rough periodic map of n x n pixels with 8 pixels to the shortest wave.
fn rough(n: usize, seed: u64) -> HeightMap {
    let surface = RandomSurface::new(2.0, 4.0, n as f64 / 8.0).unwrap();
    surface.gradient(0.1).unwrap().side(1e-4).unwrap().seed(seed).heights(n).unwrap()
}

/// n x n pixels around the top of a paraboloid of this radius \[m\], `step` \[m\] apart.
fn paraboloid(n: usize, step: f64, radius: f64) -> HeightMap {
    let at = |i: usize| (i as f64 - 0.5 * (n - 1) as f64) * step;
    let heights = (0..n * n).map(|k| -(at(k / n).powi(2) + at(k % n).powi(2)) / (2.0 * radius));
    HeightMap::new(heights.collect(), [n, n], [step; 2]).unwrap()
}

fn options(boundary: Option<Continuation>, elastic: bool) -> BemOptions {
    BemOptions { boundary, elastic }
}

/// Equivalent modulus of the tests \[Pa\].
const MODULUS: f64 = 1e11;
/// Pressure unit of [`rough`], modulus times gradient \[Pa\].
const UNIT: f64 = 1e10;

#[track_caller]
fn close(found: f64, required: f64, relative: f64) {
    assert!((found - required).abs() <= relative * required.abs(), "{found:e} is not {required:e}");
}
