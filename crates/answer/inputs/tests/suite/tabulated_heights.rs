//! A tabulated density against integrals in closed form: between two points of the table and two
//! kinks of a law, (c w^p)(a + b w) integrates to powers.

use std::f64::consts::PI;

use asperity::{
    HeightDistribution, Interface, Model, Quantity, Request, Scene, Surface, TabulatedHeights,
    Tolerance,
};

/// One power c w^p of a law on [from, to), in metres.
struct Term {
    from: f64,
    to: f64,
    factor: f64,
    exponent: f64,
}

fn interface() -> Interface {
    Interface::new(116e9, 0.31, 1.12e9)
}

const RADIUS: f64 = 3.6e-4;
const DENSITY: f64 = 1.1e8;
const AREA: f64 = 3e-5;

/// The laws of GW and KE for one asperity, independent of the library.
fn terms(model: &str, quantity: Quantity) -> Vec<Term> {
    let (e, h, s) = (116e9, 1.12e9, 0.454 + 0.41 * 0.31);
    let term = |from, to, factor, exponent| Term { from, to, factor, exponent };
    if model == "gw" {
        return vec![match quantity {
            Quantity::Area => term(0.0, f64::INFINITY, PI * RADIUS, 1.0),
            _ => term(0.0, f64::INFINITY, 4.0 / 3.0 * e * RADIUS.sqrt(), 1.5),
        }];
    }
    let wc = RADIUS * (PI * s * h / (2.0 * e)).powi(2);
    let force = 2.0 / 3.0 * PI * RADIUS * wc * s * h;
    let (unit, rows) = match quantity {
        Quantity::Area => {
            (PI * RADIUS * wc, [(1.0, 1.0), (0.93, 1.136), (0.94, 1.146), (2.0, 1.0)])
        }
        _ => (force, [(1.0, 1.5), (1.03, 1.425), (1.40, 1.263), (3.0 / s, 1.0)]),
    };
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

/// The points of a table with integral 1, heights about the mean, independent of the library.
fn normalised(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    // Simpson's rule is exact for the squares of linear functions and less.
    let moment = |f: &dyn Fn(f64) -> f64| {
        let piece = |p: &[(f64, f64)]| {
            let (a, b) = (p[0], p[1]);
            let (z, g) = (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
            (b.0 - a.0) * (f(a.0) * a.1 + 4.0 * f(z) * g + f(b.0) * b.1) / 6.0
        };
        points.windows(2).map(piece).sum::<f64>()
    };
    let area = moment(&|_| 1.0);
    let mean = moment(&|z| z) / area;
    points.iter().map(|(z, g)| (z - mean, g / area)).collect()
}

/// η A_n ∫ q(w) g(d + w) dw and its derivative -d/dd, d in metres from the mean.
fn reference(points: &[(f64, f64)], terms: &[Term], d: f64) -> (f64, f64) {
    let points = normalised(points);
    let (mut value, mut tangent) = (0.0, 0.0);
    for pair in points.windows(2).filter(|p| p[1].0 > p[0].0) {
        let ((z0, g0), (z1, g1)) = (pair[0], pair[1]);
        let b = (g1 - g0) / (z1 - z0);
        for t in terms {
            let (low, high) = (t.from.max(z0 - d), t.to.min(z1 - d));
            if high <= low {
                continue;
            }
            // g = a + b w.
            let (a, p) = (g0 + b * (d - z0), t.exponent);
            value += t.factor * (a * powers(low, high, p + 1.0) + b * powers(low, high, p + 2.0));
            tangent += p * t.factor * (a * powers(low, high, p) + b * powers(low, high, p + 1.0));
        }
    }
    // Jumps of the law multiply the density there.
    for two in terms.windows(2) {
        let w = two[0].to;
        let side = |t: &Term| t.factor * w.powf(t.exponent);
        tangent += (side(&two[1]) - side(&two[0])) * density(&points, d + w);
    }
    (DENSITY * AREA * value, DENSITY * AREA * tangent)
}

fn density(points: &[(f64, f64)], z: f64) -> f64 {
    let pair = points.windows(2).find(|p| p[0].0 <= z && z < p[1].0);
    pair.map_or(0.0, |p| p[0].1 + (p[1].1 - p[0].1) * (z - p[0].0) / (p[1].0 - p[0].0))
}

fn scene(points: &[(f64, f64)], std: Option<f64>) -> Scene {
    let heights = TabulatedHeights::new("table", points).unwrap();
    let std = std.unwrap_or(heights.standard_deviation());
    let mut scene = Scene::new(interface(), Surface::new(RADIUS, DENSITY, std), AREA);
    scene.heights = HeightDistribution::other(heights);
    scene
}

/// A noisy, skewed density like a measured one, with a gap of zeros and an outlier beyond it.
fn measured(count: usize) -> Vec<(f64, f64)> {
    let mut noise = 1u64;
    (0..=count)
        .map(|k| {
            noise = noise.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let z = -4.0 + 9.0 * k as f64 / count as f64;
            let smooth = (-0.5 * z * z).exp() + 0.3 * (-2.0 * (z - 1.5) * (z - 1.5)).exp();
            let g = smooth * (0.8 + 0.4 * (noise >> 40) as f64 / (1u64 << 24) as f64);
            let gap = z > 3.0 && z < 4.2;
            (5e-6 + 1.3e-6 * z, if gap || k == 0 || k == count { 0.0 } else { g })
        })
        .collect()
}

fn tables() -> Vec<(&'static str, Vec<(f64, f64)>)> {
    vec![
        ("triangle", vec![(-1e-6, 0.0), (0.5e-6, 1.0), (2e-6, 0.0)]),
        (
            "steps",
            vec![(0.0, 1.0), (1e-6, 1.0), (1e-6, 3.0), (2e-6, 2.0), (2e-6, 0.5), (3e-6, 0.5)],
        ),
        ("tens", measured(30)),
        ("hundreds", measured(400)),
    ]
}

#[test]
fn values_and_tangents_agree_with_closed_forms() {
    let asked = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let mut worst = 0.0f64;
    for (name, points) in tables() {
        for (model, std) in [("gw", None), ("ke", None), ("ke", Some(0.7e-6))] {
            let scene = scene(&points, std);
            let std = scene.surface.asperity_height_std;
            let request = Request::new(asked).within(Tolerance::new(1e-13).unwrap());
            let compiled = model.parse::<Model>().unwrap().compile(&scene, &request).unwrap();
            let (bottom, top) = {
                let points = normalised(&points);
                (points[0].0 / std, points[points.len() - 1].0 / std)
            };
            let inside = (0..12).map(|k| bottom + (top - bottom) * (f64::from(k) + 0.37) / 12.0);
            let below = [bottom - 20.0, bottom - 1.0, bottom];
            let near_the_top = [top - 0.01, top - 1e-5];
            for s in inside.chain(below).chain(near_the_top) {
                for quantity in asked {
                    let (value, tangent) = reference(&points, &terms(model, quantity), s * std);
                    let wanted = if quantity == Quantity::Tangent { tangent } else { value };
                    let found = compiled.evaluate(quantity, s).unwrap();
                    // Tangents are sums over the slopes of the density: the contract is relative to
                    // the size of their terms.
                    let cancels = found.size / found.scaled.abs();
                    let error = (found.value() / wanted - 1.0).abs() / cancels;
                    // The reference itself loses digits to differences of heights near the top.
                    let lost = 2e-15 * (s.abs() + 1.0) / (top - s).min(1.0);
                    let case = format!("{name} {model} {quantity} at {s}: {found:?} {wanted:e}");
                    assert!(error < 1e-12 + 4.0 * lost, "{case} off by {error:e}");
                    // The two means may differ by an ulp of 5 µm, in slopes of 50 per σ.
                    assert!(error < found.error + 4.0 * lost + 1e-13, "{case} off by {error:e}");
                    if top - s > 0.1 {
                        worst = worst.max(error);
                    }
                }
            }
            for s in [top + 1e-12, top + 1e-9, top + 5.0] {
                assert!(compiled.evaluate(Quantity::Force, s).unwrap().ln_value().is_infinite());
            }
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
}

#[test]
fn separations_at_a_load_are_found_on_a_table() {
    let scene = scene(&measured(50), None);
    for model in ["gw", "ke", "ceb"] {
        let request = Request::new([Quantity::Force]);
        let compiled = model.parse::<Model>().unwrap().compile(&scene, &request).unwrap();
        for s in [-6.0, -0.5, 1.0, 2.9, 3.5, 3.9] {
            let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
            let found = compiled.separations_at(load).unwrap();
            assert!(
                found.len() == 1 && (found[0].value - s).abs() < 1e-9,
                "{model} {s}: {found:?}"
            );
        }
    }
}

#[test]
fn a_finely_tabulated_normal_density_agrees_with_gaussian_heights() {
    let normal = |k: i32| (f64::from(k) * 0.005e-6, (-0.5 * (f64::from(k) * 0.005).powi(2)).exp());
    let table = scene(&(-1600..=1600).map(normal).collect::<Vec<_>>(), None);
    let mut gaussian = table.clone();
    gaussian.heights = HeightDistribution::Gaussian;
    let request = Request::new([Quantity::Force, Quantity::Tangent]).at([-1.0, 0.0, 2.0, 4.0]);
    let ke: Model = "ke".parse().unwrap();
    let (a, b) = (ke.solve(&table, &request).unwrap(), ke.solve(&gaussian, &request).unwrap());
    for quantity in [Quantity::Force, Quantity::Tangent] {
        for (a, b) in a.values(quantity).unwrap().iter().zip(b.values(quantity).unwrap()) {
            // The chords of a table with step h lie h²/12 of the second derivative above the curve.
            assert!((a / b - 1.0).abs() < 5e-5, "{quantity}: {a} {b}");
        }
    }
}
