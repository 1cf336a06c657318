//! The fixed-point iteration of Greenwood & Tripp beside Newton's method, between spheres.
#![allow(clippy::unwrap_used, reason = "a test: a panic is the failure")]

use std::f64::consts::PI;

use asperity_core::{
    Contact, ContactModel, Interface, Quantity, Request, Scene, Surface, Tolerance,
};
use asperity_curved::{Curved, Shape};
use asperity_gw::GreenwoodWilliamson;

/// The public code's relaxation, and the change of the deflection over σ at which it ends.
const RELAXATION: f64 = 0.3;
const TOLERANCE: f64 = 1e-3;
const MOST: usize = 500;
const RINGS: usize = 300;
const SIGMA: f64 = 1e-6;

/// The complete elliptic integrals K and E of a modulus from 0 to below 1.
fn elliptic(modulus: f64) -> [f64; 2] {
    let (mut a, mut b, mut sum) = (1.0, (1.0 - modulus * modulus).sqrt(), 0.5 * modulus * modulus);
    let mut power = 1.0;
    while a - b > 1e-15 {
        let c = 0.5 * (a - b);
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
        sum += power * c * c;
        power *= 2.0;
    }
    let k = PI / (2.0 * a);
    [k, k * (1.0 - sum)]
}

/// The deflection at r under a unit pressure on a disc, times the modulus (Johnson 1985, 3.29).
fn under_disc(radius: f64, r: f64) -> f64 {
    if radius == 0.0 {
        return 0.0;
    }
    let [inner, outer] = [r.min(radius), r.max(radius)];
    let ratio = (inner / outer).min(1.0 - 1e-12);
    let [k, e] = elliptic(ratio);
    let outside = e - (1.0 - ratio * ratio) * k;
    4.0 / PI * outer * if r < radius { e } else { outside }
}

/// Iterations and load of the fixed point at an approach, or `None` where it does not converge.
fn fixed_point(
    layer: &dyn Contact,
    (modulus, radius, approach): (f64, f64, f64),
    reach: f64,
) -> Option<(usize, f64)> {
    let step = reach / RINGS as f64;
    let middle = |k: usize| (k as f64 + 0.5) * step;
    let edge = |k: usize, r: f64| under_disc(k as f64 * step, r);
    let ring = |k: usize, i: usize| (edge(k + 1, middle(i)) - edge(k, middle(i))) / modulus;
    let matrix: Vec<Vec<f64>> =
        (0..RINGS).map(|i| (0..RINGS).map(|k| ring(k, i)).collect()).collect();
    // From smooth bodies in touch.
    let touching = |k: usize| (approach - middle(k).powi(2) / (2.0 * radius)).max(0.0);
    let (mut u, mut p) = ((0..RINGS).map(touching).collect::<Vec<f64>>(), vec![0.0; RINGS]);
    for iteration in 1..=MOST {
        let gap = |k: usize| middle(k).powi(2) / (2.0 * radius) + u[k] - approach;
        let gaps: Vec<f64> = (0..RINGS).map(|k| gap(k) / SIGMA).collect();
        layer.fill(&[Quantity::Force], &gaps, &mut [&mut p]).unwrap();
        let mut change = 0.0_f64;
        for (own, row) in u.iter_mut().zip(&matrix) {
            let off = row.iter().zip(&p).map(|(a, p)| a * p).sum::<f64>() - *own;
            *own += RELAXATION * off;
            change = change.max(off.abs() / SIGMA);
        }
        if change < TOLERANCE {
            let load = (0..RINGS).map(|k| p[k] * 2.0 * PI * middle(k) * step).sum();
            return Some((iteration, load));
        }
    }
    None
}

/// Both give the same contact of rough bodies; of smoother ones only Newton's method does.
#[test]
fn the_fixed_point_takes_more_steps_and_diverges_for_smooth_bodies() {
    let (modulus, peak) = (115e9, 1.37e9);
    let asperities = Surface::new(500.0 * SIGMA, 0.05 / (500.0 * SIGMA * SIGMA), SIGMA);
    let scene = Scene::new(Interface::elastic(modulus, 0.3), asperities, 1.0);
    let request = Request::new([Quantity::Force]);
    let layer = GreenwoodWilliamson.compile(&scene, &request).unwrap();
    let mut found = vec![];
    for alpha in [0.3, 0.1, 0.03] {
        let slope: f64 = PI * peak / (2.0 * modulus);
        let radius = SIGMA / (alpha * slope * slope);
        let a = slope * radius;
        let ball = Shape::Point { radius_x: radius, radius_y: radius };
        let tolerance = Tolerance::new(1e-6).unwrap();
        let curved = Curved::new(&GreenwoodWilliamson, &scene, ball, &[], tolerance).unwrap();
        let load = 2.0 / 3.0 * PI * a * a * peak;
        let newton = curved.at_load(load).unwrap();
        let bodies = (modulus, radius, newton.approach().unwrap());
        let iterations = fixed_point(&*layer, bodies, 4.0 * newton.axes()[0]);
        if let Some((_, carried)) = iterations {
            assert!((carried / load - 1.0).abs() < 3e-3, "{alpha}: {}", carried / load - 1.0);
        }
        found.push((newton.work().steps, iterations.map(|(count, _)| count)));
    }
    let [rough, middle, smooth] = found[..] else { panic!("{found:?}") };
    assert!(found.iter().all(|(steps, _)| *steps <= 6), "{found:?}");
    assert!(rough.1.unwrap() > 15 && middle.1.unwrap() > 50 && smooth.1.is_none(), "{found:?}");
}
