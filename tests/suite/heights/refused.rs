//! Invalid densities, and densities without an integral: named errors, no panic and no 0.

use asperity::{Case, HeightDistribution, Heights, Quantity, Sweep, Tolerance};
use std::f64::consts::PI;

use asperity_quadrature::gauss_kronrod;
use statrs::distribution::{LogNormal, StudentsT};

use super::densities::scene;
use super::standardised::StandardisedHeights;
use crate::scenes::{close, compiled, model, value};

/// A density of z in micrometres.
#[derive(Debug, Clone)]
struct Own {
    density: fn(f64) -> f64,
    support: (f64, f64),
    breaks: Vec<f64>,
}

impl Own {
    fn new(density: fn(f64) -> f64, low: f64, high: f64) -> Self {
        Self { density, support: (1e-6 * low, 1e-6 * high), breaks: vec![] }
    }

    fn with_breaks(mut self, breaks: &[f64]) -> Self {
        self.breaks = breaks.iter().map(|z| 1e-6 * z).collect();
        self
    }
}

impl Heights for Own {
    fn name(&self) -> &str {
        "own"
    }

    fn ln_density(&self, z: f64) -> f64 {
        ((self.density)(1e6 * z) * 1e6).ln()
    }

    fn support(&self) -> (f64, f64) {
        self.support
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
}

/// The errors of a density for value and tangent, with and without preparation.
fn refusals(heights: Own) -> Vec<String> {
    let scene = scene(HeightDistribution::other(heights));
    let mut messages = vec![];
    for (id, separation) in [("gw", -1.0), ("gw", 0.1), ("ke", -30.0), ("jg", 0.1)] {
        let asked = [Quantity::Force, Quantity::Tangent];
        let found = compiled(&model(id), &scene, &asked, 1e-10);
        messages.extend(asked.map(|q| found.evaluate(q, separation).unwrap_err().to_string()));
        let model = model(id);
        let sweep = Sweep::new(&*model, &asked, Tolerance::new(1e-10).unwrap());
        let once = sweep.evaluate(&Case::new(scene.clone(), separation));
        messages.push(once.unwrap_err().to_string());
    }
    messages
}

#[test]
fn invalid_densities_are_refused_by_name() {
    let half = |_: f64| 0.5;
    let infinite = f64::INFINITY;
    let cases = [
        (Own::new(half, 1.0, -1.0), "from"),
        (Own::new(half, f64::NAN, 1.0), "from NaN"),
        (Own::new(half, 1.0, 1.0), "from"),
        (Own::new(half, infinite, infinite), "from inf"),
        (Own::new(half, -1.0, 1.0).with_breaks(&[f64::NAN]), "a break is NaN"),
        (Own::new(|_| f64::NAN, -1.0, 1.0), "logarithm is NaN"),
        (Own::new(|_| f64::NAN, -infinite, infinite), "logarithm is NaN"),
        (Own::new(|z| if z > 0.3 { f64::NAN } else { 0.5 }, -1.0, 1.0), "logarithm is NaN"),
        (Own::new(|_| -0.5, -1.0, 1.0), "logarithm is NaN"),
        (Own::new(|_| f64::INFINITY, -1.0, 1.0), "logarithm is inf"),
        (Own::new(|_| 0.0, -1.0, 1.0), "the integral is 0"),
        (Own::new(|_| 0.0, -infinite, infinite), "zero everywhere"),
        (Own::new(half, -1.0, 2.0), "the integral is 1.5"),
        (Own::new(|z| (-z.abs()).exp(), -infinite, infinite), "the integral is 2."),
        // Poles: not integrable, or inside the support and undeclared.
        (Own::new(|z| 0.5 / z, 0.0, 1.0), "pole at 0"),
        (Own::new(|z| 0.1 * (z - PI / 10.0).abs().powf(-0.8), -0.7, 1.3), "pole at"),
    ];
    for (heights, wanted) in cases {
        for message in refusals(heights) {
            let name = "heights \"own\": ";
            assert!(message.contains(name) && message.contains(wanted), "{message}, not {wanted}");
        }
    }
}

#[test]
fn divergent_integrals_are_refused_and_heavy_tails_are_not() {
    // z^-2.2 far out: the mean of w^1.5 is infinite.
    let tail = Own::new(|z| 0.6 * (1.0 + z.abs()).powf(-2.2), f64::NEG_INFINITY, f64::INFINITY);
    let scene_of = |heights| scene(HeightDistribution::other(heights));
    let found = compiled(&model("gw"), &scene_of(tail), &[Quantity::Force], 1e-10);
    let message = found.evaluate(Quantity::Force, 0.0).unwrap_err().to_string();
    assert!(message.contains("diverges"), "{message}");
    // z^-4: finite.
    let heights = StudentsT::new(0.0, 1.0, 3.0).unwrap();
    let heights = HeightDistribution::other(StandardisedHeights::new("students_t", heights, 1e-6));
    let found = compiled(&model("gw"), &scene(heights), &[Quantity::Force], 1e-10);
    for separation in [-1e6, 0.0, 1e3, 1e6, 1e9] {
        let found = found.evaluate(Quantity::Force, separation).unwrap();
        assert!(found.value() > 0.0 && found.relative_error() < 1e-9, "{separation}: {found:?}");
    }
}

#[test]
fn densities_that_underflow_are_refused() {
    // The logarithm of a density ends where the density underflows.
    let gaussian = |z: f64| (-0.5 * z * z).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let own = Own::new(gaussian, f64::NEG_INFINITY, f64::INFINITY);
    let scene = scene(HeightDistribution::other(own));
    let found = compiled(&model("gw"), &scene, &[Quantity::Force], 1e-8);
    assert!(found.evaluate(Quantity::Force, 30.0).unwrap().value() > 0.0);
    for separation in [40.0, 1e3, 1e9] {
        let message = found.evaluate(Quantity::Force, separation).unwrap_err().to_string();
        assert!(message.contains("too small above"), "{message}");
    }
    let heights = LogNormal::new(0.0, 1.0).unwrap();
    let heights = HeightDistribution::other(StandardisedHeights::new("log_normal", heights, 1e-6));
    let mut scene = scene;
    scene.heights = heights;
    let found = compiled(&model("gw"), &scene, &[Quantity::Force], 1e-8);
    let far = found.evaluate(Quantity::Force, 1e9).unwrap();
    assert!(far.scaled > 0.0 && far.ln_value().is_finite(), "{far:?}");
}

/// Force \[N\] of GW by an independent adaptive quadrature, in z = place + side·u^4.
fn hertz(density: impl Fn(f64) -> f64, d: f64, pieces: &[(f64, f64)]) -> f64 {
    let piece = |(place, to): &(f64, f64)| {
        let (side, length) = ((to - place).signum(), (to - place).abs());
        let integrand = |v: f64| {
            let u = length * v.powi(4);
            let w = (place + side * u - d).max(0.0);
            w * w.sqrt() * density(side * u) * 4.0 * length * v.powi(3)
        };
        gauss_kronrod(integrand, &[0.0, 0.3, 1.0], 1e-13, 400_000).unwrap().value
    };
    let unit = 4.0 / 3.0 * 116e9 * 3.6e-4f64.sqrt() * 1e-6f64.powf(1.5) * 1.1e8 * 3e-5;
    unit * pieces.iter().map(piece).sum::<f64>()
}

#[test]
fn declared_poles_inside_are_integrated() {
    // Different powers on both sides, 0.3 up from the mean of separations.
    let density = |z: f64| {
        let u = z - 0.3;
        if u < 0.0 { 0.15 * (-u).powf(-0.7) } else { 0.375 * u.powf(-0.25) }
    };
    let own = Own::new(density, -0.7, 1.3).with_breaks(&[0.3]);
    let found =
        compiled(&model("gw"), &scene(HeightDistribution::other(own)), &[Quantity::Force], 1e-10);
    for d in [-1.0f64, -0.2] {
        let pieces = [(0.3, d.max(-0.7)), (0.3, 1.3)];
        let from_pole =
            |u: f64| if u < 0.0 { 0.15 * (-u).powf(-0.7) } else { 0.375 * u.powf(-0.25) };
        let wanted = hertz(from_pole, d, &pieces);
        close(value(&found, Quantity::Force, d), wanted, 1e-10, &format!("at {d}"));
    }
}

#[test]
fn undeclared_gaps_in_a_density_are_found() {
    let density = |z: f64| if z.abs() > 1.0 && z.abs() < 2.0 { 0.5 } else { 0.0 };
    let own = Own::new(density, -2.5, 2.5);
    let asked = [Quantity::Force, Quantity::Tangent];
    let scene = scene(HeightDistribution::other(own));
    let found = compiled(&model("gw"), &scene, &asked, 1e-10);
    let unit = 4.0 / 3.0 * 116e9 * 3.6e-4f64.sqrt() * 1e-6f64.powf(1.5) * 1.1e8 * 3e-5;
    for d in [-5.0, -1.5, -0.4, 0.0, 1.0, 1.7] {
        // ∫ (z-d)^p dz over both parts.
        let integral = |p: f64| {
            let power = |z: f64| (z - d).max(0.0).powf(p + 1.0) / (p + 1.0);
            0.5 * (power(-1.0) - power(-2.0) + power(2.0) - power(1.0))
        };
        close(value(&found, Quantity::Force, d), unit * integral(1.5), 1e-10, &format!("{d}"));
        let wanted = 1.5 * unit * integral(0.5) / 1e-6;
        close(value(&found, Quantity::Tangent, d), wanted, 1e-10, &format!("tangent at {d}"));
    }
    for d in [2.1, 2.4] {
        let none = found.evaluate(Quantity::Force, d).unwrap();
        assert!(none.scaled.abs() < f64::MIN_POSITIVE && none.ln_value().is_infinite(), "{none:?}");
    }
}
