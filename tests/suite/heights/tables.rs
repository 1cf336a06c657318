//! Tables of heights with steps and with ends above 0, against sums of antiderivatives.

use std::f64::consts::PI;

use asperity::{
    Case, Evaluation, HeightDistribution, Quantity, Scene, Sweep, TabulatedHeights, Tolerance,
};

use super::densities;
use crate::scenes::{close, compiled, model, value};

/// One power c w^p of a law on [from, to), in metres.
struct Term {
    from: f64,
    to: f64,
    factor: f64,
    exponent: f64,
}

/// The force laws of GW and KE for one asperity of the scene, written independently.
fn terms(model: &str) -> Vec<Term> {
    let (e, h, s, r) = (116e9, 1.12e9, 0.454 + 0.41 * 0.31, 3.6e-4f64);
    let term = |from, to, factor, exponent| Term { from, to, factor, exponent };
    if model == "gw" {
        return vec![term(0.0, f64::INFINITY, 4.0 / 3.0 * e * r.sqrt(), 1.5)];
    }
    let wc = r * (PI * s * h / (2.0 * e)).powi(2);
    let unit = 2.0 / 3.0 * PI * r * wc * s * h;
    let rows = [(1.0, 1.5), (1.03, 1.425), (1.40, 1.263), (3.0 / s, 1.0)];
    let ends = [0.0, 1.0, 6.0, 110.0, f64::INFINITY];
    let scaled = |(k, (c, p)): (usize, &(f64, f64))| {
        term(ends[k] * wc, ends[k + 1] * wc, unit * c / wc.powf(*p), *p)
    };
    rows.iter().enumerate().map(scaled).collect()
}

/// (b^n - a^n)/n without cancellation.
fn powers(a: f64, b: f64, n: f64) -> f64 {
    if a > 0.0 { a.powf(n) * (n * (b / a).ln()).exp_m1() / n } else { b.powf(n) / n }
}

/// Force, and tangent -dF/dd, of heights (about their mean) and densities with integral 1: between
/// two points of the table and two kinks of the law, (c w^p)(a + b w) integrates to powers.
fn reference(points: &[(f64, f64)], terms: &[Term], d: f64) -> (f64, f64) {
    let (mut force, mut tangent) = (0.0, 0.0);
    for pair in points.windows(2).filter(|p| p[1].0 > p[0].0) {
        let ((z0, g0), (z1, g1)) = (pair[0], pair[1]);
        let b = (g1 - g0) / (z1 - z0);
        for t in terms {
            let (low, high) = (t.from.max(z0 - d), t.to.min(z1 - d));
            if high > low {
                let (a, p) = (g0 + b * (d - z0), t.exponent);
                force +=
                    t.factor * (a * powers(low, high, p + 1.0) + b * powers(low, high, p + 2.0));
                tangent +=
                    p * t.factor * (a * powers(low, high, p) + b * powers(low, high, p + 1.0));
            }
        }
    }
    // Jumps of the law times the density there.
    for two in terms.windows(2) {
        let w = two[0].to;
        let side = |t: &Term| t.factor * w.powf(t.exponent);
        let pair = points.windows(2).find(|p| p[0].0 <= d + w && d + w < p[1].0);
        let density =
            pair.map_or(0.0, |p| p[0].1 + (p[1].1 - p[0].1) * (d + w - p[0].0) / (p[1].0 - p[0].0));
        tangent += (side(&two[1]) - side(&two[0])) * density;
    }
    (1.1e8 * 3e-5 * force, 1.1e8 * 3e-5 * tangent)
}

/// Heights about the mean and densities with integral 1.
fn normalised(table: &TabulatedHeights) -> Vec<(f64, f64)> {
    let area = |pair: &[(f64, f64)]| 0.5 * (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1);
    let integral: f64 = table.points().windows(2).map(area).sum();
    table.points().iter().map(|(z, g)| (z - table.mean(), g / integral)).collect()
}

struct Random(u64);

impl Random {
    /// In [0, 1).
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Up to 40 points, some of them steps, with ends at 0 or not.
    fn table(&mut self) -> Vec<(f64, f64)> {
        let count = 2 + (38.0 * self.next().powi(2)) as usize;
        let mut z = 4e-6 * (self.next() - 0.5);
        let mut points = vec![];
        for _ in 0..count {
            points.push((z, self.next()));
            if self.next() < 0.3 && !points.is_empty() {
                points.push((z, if self.next() < 0.3 { 0.0 } else { self.next() }));
            }
            z += 2e-6 * self.next().powi(3) + 1e-9;
        }
        if self.next() < 0.5 {
            points[0].1 = 0.0;
        }
        points
    }
}

fn scene(table: &TabulatedHeights) -> Scene {
    let mut scene = densities::scene(HeightDistribution::other(table.clone()));
    scene.surface.asperity_height_std = table.standard_deviation();
    scene
}

#[test]
fn four_hundred_random_tables_have_the_tangents_of_closed_forms() {
    let mut random = Random(9);
    let asked = [Quantity::Force, Quantity::Tangent];
    let mut failed = vec![];
    for number in 0..400 {
        let points = random.table();
        let Ok(table) = TabulatedHeights::new("random", &points) else { continue };
        let (scene, points) = (scene(&table), normalised(&table));
        let std = table.standard_deviation();
        let (bottom, top) = (points[0].0, points[points.len() - 1].0);
        for id in ["gw", "ke"] {
            let model = model(id);
            let many = compiled(&model, &scene, &asked, 1e-10);
            let once = Sweep::new(&*model, &asked, Tolerance::new(1e-10).unwrap());
            for _ in 0..4 {
                let d = bottom - 0.3 * (top - bottom) + 1.3 * (top - bottom) * random.next();
                let separation = d / std;
                let once = once.evaluate(&Case::new(scene.clone(), separation)).unwrap();
                let (force, tangent) = reference(&points, &terms(id), separation * std);
                for (k, wanted) in [force, tangent].into_iter().enumerate() {
                    for found in [many.evaluate(asked[k], separation).unwrap(), once[k]] {
                        let off = (found.value() / wanted - 1.0).abs();
                        // Next to the top, the reference has the rounding of height differences.
                        let lost = 4e-15 * (d.abs() + std) / (top - d).min(std);
                        if off > 1e-10 + lost || off > found.relative_error() + lost {
                            let table = &table.points();
                            failed.push(format!(
                                "{number} {id} {k} {separation}: off {off:e}, {found:?} {table:?}"
                            ));
                        }
                    }
                }
            }
        }
    }
    assert!(failed.is_empty(), "{} of them: {}", failed.len(), failed[0]);
}

#[test]
fn a_table_of_two_rows_keeps_the_step_at_its_end() {
    let rows =
        [(7.207568126715717e-07, 0.5070268159456598), (2.643727532543779e-06, 0.43119155343093274)];
    let table = TabulatedHeights::new("two rows", &rows).unwrap();
    let d = 0.25135;
    let found = compiled(&model("gw"), &scene(&table), &[Quantity::Tangent], 1e-10);
    let (_, wanted) = reference(&normalised(&table), &terms("gw"), d * table.standard_deviation());
    assert!(wanted > 3e9, "{wanted}");
    close(value(&found, Quantity::Tangent, d), wanted, 1e-12, "tangent");
}

#[test]
fn lengths_of_a_table_are_metres_on_every_scene() {
    let points = [(-2e-6, 0.0), (0.0, 3e5), (0.5e-6, 3.5e5), (1.5e-6, 0.0)];
    let heights = HeightDistribution::other(TabulatedHeights::new("measured", &points).unwrap());
    let asked = [Quantity::Force, Quantity::Tangent];
    let first = densities::scene(heights);
    let model = model("ke");
    let found = compiled(&model, &first, &asked, 1e-12);
    let sweep = Sweep::new(&*model, &asked, Tolerance::new(1e-12).unwrap());
    for factor in [0.3, 2.0, 17.0] {
        let mut other = first.clone();
        other.surface.asperity_height_std *= factor;
        let moved = found.on(&other).unwrap();
        for metres in [-1e-6, 0.2e-6, 1e-6] {
            let [d, there] = [&first, &other].map(|s| metres / s.surface.asperity_height_std);
            let swept = sweep.evaluate(&Case::new(other.clone(), there)).unwrap();
            for (k, quantity) in asked.into_iter().enumerate() {
                let wanted = value(&found, quantity, d);
                let what = format!("{quantity} at {metres} m, unit {factor}");
                close(value(&moved, quantity, there), wanted, 3e-12, &what);
                close(swept[k].value(), wanted, 3e-12, &what);
            }
        }
    }
}

#[test]
fn series_of_a_table_of_a_thousand_rows_equal_its_integrals() {
    let mut random = Random(4);
    let g = |z: f64| (-0.5 * z * z).exp() + 0.3 * (-2.0 * (z - 1.5) * (z - 1.5)).exp();
    let row = |k: i32| {
        let z = -4.0 + 0.009 * f64::from(k);
        (1e-6 * z, g(z) * (0.8 + 0.4 * random.next()))
    };
    let table = TabulatedHeights::new("long", &(0..=1000).map(row).collect::<Vec<_>>()).unwrap();
    let scene = scene(&table);
    let asked = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let near = |a: &Evaluation, b: &Evaluation, what: &str| {
        close(a.value(), b.value(), a.relative_error() + b.relative_error(), what);
        assert!(a.relative_error() < 1e-10, "{what}: {a:?}");
    };
    for id in ["gw", "ke", "jg", "etsion"] {
        let model = model(id);
        let many = compiled(&model, &scene, &asked, 1e-10);
        let once = Sweep::new(&*model, &asked, Tolerance::new(1e-10).unwrap());
        for separation in [-40.0, -5.0, -2.0123, 0.0, 0.7001, 1.9, 2.6] {
            let once = once.evaluate(&Case::new(scene.clone(), separation)).unwrap();
            for (k, quantity) in asked.into_iter().enumerate() {
                let many = many.evaluate(quantity, separation).unwrap();
                near(&many, &once[k], &format!("{id} {quantity} at {separation}"));
            }
        }
    }
}

#[test]
fn a_finely_tabulated_normal_density_agrees_with_gaussian_heights() {
    let normal = |k: i32| (f64::from(k) * 0.005e-6, (-0.5 * (f64::from(k) * 0.005).powi(2)).exp());
    let points: Vec<(f64, f64)> = (-1600..=1600).map(normal).collect();
    let table = scene(&TabulatedHeights::new("normal", &points).unwrap());
    let mut gaussian = table.clone();
    gaussian.heights = HeightDistribution::Gaussian;
    let asked = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let [table, gaussian] = [table, gaussian].map(|s| compiled(&model("ke"), &s, &asked, 1e-10));
    for s in [-1.0, 0.0, 2.0, 4.0] {
        for quantity in asked {
            // The chords of a table with step h lie h²/12 of the second derivative above the curve.
            let wanted = value(&gaussian, quantity, s);
            close(value(&table, quantity, s), wanted, 5e-5, &format!("{quantity} at {s}"));
        }
    }
}
