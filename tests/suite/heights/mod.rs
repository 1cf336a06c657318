//! Heights of every kind, against closed forms and independent quadratures.

mod densities;
mod refused;
pub mod standardised;
mod tables;
mod weibull;

use std::f64::consts::PI;

use asperity::{
    HeightDistribution, Heights, Model, Quantity, Scene, Tolerance, greenwood_integral,
};
use asperity_quadrature::gauss_kronrod;
use statrs::distribution::{Beta, Normal, Uniform, Weibull};

use self::standardised::StandardisedHeights;
use crate::scenes::{close, compiled, model, named, upright, value};

const ASKED: [Quantity; 3] = [Quantity::Force, Quantity::Area, Quantity::Tangent];

fn on(scene: &str, heights: HeightDistribution) -> Scene {
    let mut scene = named(scene);
    scene.heights = heights;
    scene
}

#[test]
fn greenwood_integrals_have_fifteen_digits() {
    let mut count = 0;
    for line in include_str!("../../reference/greenwood.csv").lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|field| field.parse().unwrap()).collect();
        let [order, separation, wanted, ln_wanted] = row[..] else { panic!("{line}") };
        let found = greenwood_integral(order, separation).unwrap();
        close(found.value(), wanted, 1e-12, line);
        // The rounding of large logarithms: half an ulp of 700, or 1e-12 of F.
        let error = (found.ln_value() - ln_wanted).abs();
        assert!(error < 1e-12 + 4e-16 * ln_wanted.abs(), "{line}: {}", found.ln_value());
        assert!(found.relative_error() < 1e-13, "{line}: {found:?}");
        count += 1;
    }
    assert!(count == 144, "{count} rows");
}

#[test]
fn greenwood_integrals_are_positive_and_finite() {
    for order in [0.0, 0.3, 1.0, 1.5, 10.0] {
        for separation in [-1e6, -1e3, -64.5, -0.0, 0.0, 1e-300, 38.5, 60.0, 1e4, 1e9] {
            let found = greenwood_integral(order, separation).unwrap();
            let what = format!("F_{order}({separation}) = {found:?}");
            assert!(found.scaled > 0.0 && found.ln_value().is_finite(), "{what}");
            // F_n(h) → Γ(n+1) φ(h) h^-(n+1) for large h, |h|^n for large -h; both to 1/h².
            if separation <= -1e3 {
                close(found.value(), (-separation).powf(order), 1e-4, &what);
            } else if separation >= 1e4 && order.to_bits() == 1f64.to_bits() {
                let ln =
                    -0.5 * separation * separation - 0.5 * (2.0 * PI).ln() - 2.0 * separation.ln();
                assert!((found.ln_value() - ln).abs() < 1e-6 + 4e-16 * ln.abs(), "{what}, {ln}");
            }
        }
    }
    for (order, separation, field) in [
        (-0.1, 0.0, "order is -0.1"),
        (f64::NAN, 0.0, "order is NaN"),
        (1.0, f64::NAN, "separation is NaN"),
        (1.0, f64::INFINITY, "separation is inf"),
    ] {
        let message = greenwood_integral(order, separation).unwrap_err().to_string();
        assert!(message.starts_with(field) && message.contains("was required"), "{message}");
    }
}

#[test]
fn exponential_heights_have_the_closed_form_of_greenwood_and_williamson() {
    for name in ["at-paper", "mild", "severe"] {
        let scene = on(name, HeightDistribution::Exponential);
        let found = compiled(&model("gw"), &scene, &ASKED, 1e-14);
        let (surface, e) = (scene.surface, scene.interface.equivalent_modulus);
        let (r, sigma) = (surface.asperity_radius, surface.asperity_height_std);
        let at_zero = scene.asperities() * r * sigma;
        let force = at_zero * PI.sqrt() * e * (sigma / r).sqrt();
        for (quantity, wanted) in ASKED.into_iter().zip([force, PI * at_zero, force / sigma]) {
            for separation in [0.0, 0.3, 1.0, 7.0, 40.0, 600.0] {
                let what = format!("{name} {quantity} {separation}");
                // Both sides are rounded a dozen times: 1e-14 is 45 units of the last place.
                close(
                    value(&found, quantity, separation),
                    wanted * (-separation).exp(),
                    1e-14,
                    &what,
                );
            }
            let far = found.evaluate(quantity, 1e5).unwrap();
            assert!(far.value() < f64::MIN_POSITIVE && far.scaled > 0.0);
            // One unit in the last place of 1e5.
            assert!((far.ln_value() - (wanted.ln() - 1e5)).abs() < 3e-11, "{}", far.ln_value());
        }
    }
}

/// Force or area \[N or m²\] by adaptive quadrature over the heights, split at the law's kinks.
fn by_quadrature(
    model: &Model,
    scene: &Scene,
    quantity: Quantity,
    d: f64,
    (low, high): (f64, f64),
    ln_density: impl Fn(f64) -> f64,
) -> f64 {
    let law = model.law(&scene.asperity().unwrap(), quantity, Tolerance::default()).unwrap();
    let sigma = scene.surface.asperity_height_std;
    let low = low.max(d);
    let kinks = law.kinks().into_iter().map(|x| d + x * law.interference_unit / sigma);
    let ends = [0.01, 0.1, 0.3, 0.6].map(|share| low + share * (high - low));
    let mut ends: Vec<f64> = kinks.chain(ends).filter(|z| *z > low && *z < high).collect();
    ends.extend([low, high]);
    ends.sort_by(f64::total_cmp);
    let mut total = 0.0;
    for pair in ends.windows(2) {
        // z = a + (b-a) v²(3-2v): half powers at both ends become whole ones.
        let integrand = |v: f64| {
            let z = pair[0] + (pair[1] - pair[0]) * v * v * (3.0 - 2.0 * v);
            let density = if z > pair[0] && z < pair[1] { ln_density(z).exp() } else { 0.0 };
            law.value((z - d) * sigma).unwrap() * density * 6.0 * v * (1.0 - v)
        };
        let part = gauss_kronrod(integrand, &[0.0, 0.3, 0.7, 1.0], 1e-12, 400_000).unwrap();
        total += part.value * (pair[1] - pair[0]);
    }
    total * scene.asperities()
}

#[test]
fn exponential_heights_below_their_beginning_meet_an_independent_quadrature() {
    for name in ["mild", "at-paper"] {
        let scene = on(name, HeightDistribution::Exponential);
        for model in upright() {
            let found = compiled(&model, &scene, &[Quantity::Force, Quantity::Area], 1e-12);
            for quantity in [Quantity::Force, Quantity::Area] {
                for d in [-6.0, -1.0, -0.02, 0.0, 0.5] {
                    // exp(-50) is 2e-22 of the whole.
                    let wanted = by_quadrature(&model, &scene, quantity, d, (0.0, 50.0), |z| -z);
                    let what = format!("{name} {model} {quantity} at {d}");
                    // Both sides have a tolerance of 1e-12.
                    close(value(&found, quantity, d), wanted, 3e-12, &what);
                }
            }
        }
    }
}

#[test]
fn laws_that_grow_as_high_powers_are_integrated_far_out() {
    // Jackson and Green's area grows as w^(0.14 exp(23 S_y/E)): the 14th power of w here, whose
    // mean comes from heights around 15 σ_z.
    let mut scene = on("mild", HeightDistribution::Exponential);
    scene.interface.hardness = Some(2.8 * 0.2 * scene.interface.equivalent_modulus);
    scene.surface.asperity_height_std = 4.0 * scene.asperity().unwrap().radius;
    let found = compiled(&model("jg"), &scene, &[Quantity::Area], 1e-12);
    for d in [-2.0, 0.0, 3.0] {
        // exp(-200) w^14 is 1e-60.
        let range = (0.0, 200.0);
        let wanted = by_quadrature(&model("jg"), &scene, Quantity::Area, d, range, |z| -z);
        close(value(&found, Quantity::Area, d), wanted, 3e-12, &format!("at {d}"));
    }
}

#[test]
fn the_tangent_for_exponential_heights_includes_their_jump() {
    let scene = on("at-paper", HeightDistribution::Exponential);
    for model in upright() {
        let found = compiled(&model, &scene, &[Quantity::Force, Quantity::Tangent], 1e-13);
        // Away from kinks of the law's image; h⁴ F⁽⁵⁾ is 1e-9 here.
        for d in [-3.3, -0.7, 0.9] {
            let h = 0.01;
            let force = |k: f64| value(&found, Quantity::Force, d + k * h);
            let difference =
                (8.0 * (force(-1.0) - force(1.0)) - (force(-2.0) - force(2.0))) / (12.0 * h);
            let wanted = difference / scene.surface.asperity_height_std;
            close(value(&found, Quantity::Tangent, d), wanted, 1e-7, &format!("{model} at {d}"));
        }
    }
}

#[test]
fn a_normal_distribution_from_statrs_is_the_gaussian_for_all_models() {
    let std = named("at-paper").surface.asperity_height_std;
    let normal = Normal::new(-3.0, 7.0).unwrap();
    let heights = StandardisedHeights::new("normal", normal, std);
    let heights = HeightDistribution::other(heights);
    for model in Model::of_asperities() {
        let gaussian = compiled(&model, &named("at-paper"), &ASKED, 1e-10);
        let other = gaussian.on(&on("at-paper", heights.clone())).unwrap();
        for quantity in ASKED {
            for separation in [-1.5, 0.0, 2.0, 5.0] {
                let [a, b] = [&gaussian, &other].map(|c| c.evaluate(quantity, separation).unwrap());
                // Same law tables; two integrals of 1e-10, relative to the absolute integral, of
                // which AT is a difference.
                let cancellation = a.size / a.scaled.abs();
                let what = format!("{model} {quantity} at {separation}");
                close(a.value(), b.value(), 2e-10 * cancellation, &what);
            }
        }
    }
}

#[test]
fn bounded_and_skewed_heights_meet_an_independent_quadrature() {
    let std = named("mild").surface.asperity_height_std;
    let weibull = Weibull::new(2.5, 3.0).unwrap();
    let weibull = StandardisedHeights::new("weibull", weibull, std);
    let beta = StandardisedHeights::new("beta", Beta::new(2.5, 4.0).unwrap(), std);
    // Over the height in standard deviations.
    let per_std = |heights: &dyn Heights, z: f64| heights.ln_density(z * std) + std.ln();
    let all: [Box<dyn Fn(f64) -> f64>; 2] = [
        Box::new({
            let weibull = weibull.clone();
            move |z| per_std(&weibull, z)
        }),
        Box::new({
            let beta = beta.clone();
            move |z| per_std(&beta, z)
        }),
    ];
    let supports = [weibull.support(), beta.support()].map(|(a, b)| (a / std, b / std));
    let heights = [HeightDistribution::other(weibull), HeightDistribution::other(beta)];
    for ((heights, density), (low, high)) in heights.into_iter().zip(all).zip(supports) {
        let scene = on("mild", heights);
        for id in ["gw", "ceb", "ke", "zmc", "jg"] {
            let found = compiled(&model(id), &scene, &[Quantity::Force, Quantity::Area], 1e-10);
            for quantity in [Quantity::Force, Quantity::Area] {
                for d in [-4.0, -1.0, 0.0, 1.5] {
                    // Weibull's tail is below 1e-22 of its peak at 9.
                    let range = (low, high.min(9.0));
                    let wanted = by_quadrature(&model(id), &scene, quantity, d, range, &density);
                    let name = scene.heights.name();
                    close(
                        value(&found, quantity, d),
                        wanted,
                        2e-10,
                        &format!("{name} {id} {quantity} {d}"),
                    );
                }
            }
        }
    }
}

#[test]
fn uniform_heights_have_a_closed_form_and_an_end() {
    let std = named("mild").surface.asperity_height_std;
    let uniform = Uniform::new(1.0, 2.0).unwrap();
    let heights = StandardisedHeights::new("uniform", uniform, std);
    let scene = on("mild", HeightDistribution::other(heights));
    let found = compiled(&model("gw"), &scene, &ASKED, 1e-12);
    let half = 3f64.sqrt();
    let sigma = scene.surface.asperity_height_std;
    let hertz = 4.0 / 3.0
        * scene.interface.equivalent_modulus
        * (scene.surface.asperity_radius * sigma).sqrt()
        * sigma
        * scene.asperities();
    for d in [-3.0, -half, -1.0, 0.0, 1.7] {
        // ∫ (z-d)^1.5 dz/(2√3) over z in -√3..√3, z > d.
        let (from, to) = ((-half - d).max(0.0), half - d);
        let wanted = hertz * (to.powf(2.5) - from.powf(2.5)) / 2.5 / (2.0 * half);
        close(value(&found, Quantity::Force, d), wanted, 2e-12, &format!("force at {d}"));
        let wanted = hertz * (to.powf(1.5) - from.powf(1.5)) / (2.0 * half) / sigma;
        close(value(&found, Quantity::Tangent, d), wanted, 2e-12, &format!("tangent at {d}"));
    }
    for model in upright() {
        let found = compiled(&model, &scene, &ASKED, 1e-10);
        for quantity in ASKED {
            for d in [1.7321, 2.0, 1e9] {
                let none = found.evaluate(quantity, d).unwrap();
                // No asperity reaches the flat: exactly 0.
                assert!(
                    none.value().abs() < f64::MIN_POSITIVE && none.scaled.to_bits() << 1 == 0,
                    "{none:?}"
                );
                assert!(none.ln_value().is_infinite() && none.ln_value() < 0.0);
                assert!(none.relative_error() <= 0.0);
            }
        }
    }
}
