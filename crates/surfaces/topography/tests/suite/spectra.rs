//! Moments of Gaussian surfaces of known spectrum.

use std::sync::LazyLock;

use asperity_core::{Finding, ProfileMoments, Surface};
use asperity_topography::{Estimator, Level, Statistics, Topography, TopographyError};

use crate::gaussian::{Spectrum, Uniform};

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found:e} is not {expected:e}");
}

/// Broad, well sampled: 19 points per shortest wave.
fn broad() -> Spectrum {
    Spectrum::isotropic(768, 1e-6, [4.0, 40.0], 2.5, 1e-6, |_, _| true)
}

/// One of them, made once.
fn rough() -> Topography {
    static ROUGH: LazyLock<Topography> = LazyLock::new(|| broad().surface(1));
    ROUGH.clone()
}

#[test]
fn moments_are_those_of_the_spectrum() {
    let spectrum = broad();
    let surface = rough();
    let moments = surface.moments().unwrap();
    let [x, y] = spectrum.moments(true);
    // Sums over waves equal sums over points for the differences of a periodic surface.
    close(moments.profile.m0, spectrum.m0(), 1e-10);
    close(moments.along_rows[0], x[0], 1e-10);
    close(moments.along_rows[1], x[1], 1e-10);
    close(moments.along_columns.unwrap()[0], y[0], 1e-10);
    close(moments.along_columns.unwrap()[1], y[1], 1e-10);
    // The moments of the surface itself, up to the sampling error.
    let [x, y] = spectrum.moments(false);
    close(moments.profile.m2, 0.5 * (x[0] + y[0]), 0.005);
    close(moments.profile.m4, 0.5 * (x[1] + y[1]), 0.015);
}

#[test]
fn both_estimators_find_the_asperities_of_the_spectrum() {
    let spectrum = broad();
    let [x, y] = spectrum.moments(false);
    let (m0, m2, m4) = (spectrum.m0(), 0.5 * (x[0] + y[0]), 0.5 * (x[1] + y[1]));
    let expected = Surface::from_moments(&ProfileMoments { m0, m2, m4 }).unwrap();
    for surface in [rough(), spectrum.surface(2)] {
        let by_moments = surface.statistics(Estimator::Moments).unwrap();
        let found = by_moments.surface().unwrap();
        close(found.asperity_density, expected.asperity_density, 0.01);
        close(found.asperity_radius, expected.asperity_radius, 0.01);
        close(found.asperity_height_std, expected.asperity_height_std, 0.002);
        let beta = by_moments.sq * found.asperity_density * found.asperity_radius;
        close(
            beta.powi(2) * 768.0 * std::f64::consts::PI,
            by_moments.moments.profile.bandwidth(),
            1e-10,
        );
        assert_eq!(by_moments.warnings, []);
        // With some thousand summits, their count, mean and spread have small statistical errors.
        let by_summits = surface.statistics(Estimator::Summits).unwrap();
        close(by_summits.surface().unwrap().asperity_density, expected.asperity_density, 0.05);
        close(by_summits.surface().unwrap().asperity_radius, expected.asperity_radius, 0.05);
        close(
            by_summits.surface().unwrap().asperity_height_std,
            expected.asperity_height_std,
            0.05,
        );
        assert_eq!(by_summits.warnings, []);
        // The mean of the summits agrees with the moments.
        let heights = surface.summits().unwrap().heights;
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        close(mean, expected.mean_plane_offset(), 0.1);
    }
}

#[test]
fn a_tilted_surface_has_the_moments_of_its_roughness() {
    let surface = rough();
    let whole = surface.statistics(Estimator::Moments).unwrap();
    let tilted: Vec<f64> = surface
        .heights()
        .iter()
        .enumerate()
        .map(|(i, z)| z + 1e-3 + 2e-8 * (i % 768) as f64 - 5e-9 * (i / 768) as f64)
        .collect();
    let tilted = Topography::new(tilted, 768, [1e-6; 2]).unwrap();
    let levelled = tilted.clone().level(Level::Plane).unwrap();
    let levelled = levelled.statistics(Estimator::Moments).unwrap();
    close(levelled.moments.profile.m0, whole.moments.profile.m0, 0.01);
    close(levelled.moments.profile.m2, whole.moments.profile.m2, 0.01);
    close(levelled.moments.profile.m4, whole.moments.profile.m4, 0.01);
    let skew = tilted.statistics(Estimator::Moments).unwrap();
    assert!(
        skew.moments.profile.m0 > 10.0 * whole.moments.profile.m0,
        "{:e}",
        skew.moments.profile.m0
    );
}

#[test]
fn moments_of_two_surfaces_add() {
    // Waves of odd and of even p are orthogonal, so the moments of the surfaces add exactly.
    let odd = Spectrum::isotropic(384, 1e-6, [3.0, 20.0], 2.0, 1e-6, |p, _| p % 2 != 0);
    let even = Spectrum::isotropic(384, 1e-6, [3.0, 24.0], 3.0, 4e-7, |p, _| p % 2 == 0);
    let (a, b) = (odd.surface(1), even.surface(2));
    let sum = a.heights().iter().zip(b.heights()).map(|(a, b)| a + b).collect();
    let sum = Topography::new(sum, 384, [1e-6; 2]).unwrap().with_periodic(true);
    let sum = sum.statistics(Estimator::Moments).unwrap();
    let of = |surface: Topography| surface.statistics(Estimator::Moments).unwrap();
    let both = Statistics::combined(&of(a), &of(b)).unwrap();
    for (found, expected) in [
        (both.sq, sum.sq),
        (both.moments.profile.m2, sum.moments.profile.m2),
        (both.moments.profile.m4, sum.moments.profile.m4),
        (both.surface().unwrap().asperity_density, sum.surface().unwrap().asperity_density),
        (both.surface().unwrap().asperity_radius, sum.surface().unwrap().asperity_radius),
        (both.surface().unwrap().asperity_height_std, sum.surface().unwrap().asperity_height_std),
    ] {
        close(found, expected, 1e-9);
    }
}

#[test]
fn summits_of_two_surfaces_are_refused() {
    let of = |estimator| rough().statistics(estimator).unwrap();
    let (moments, summits) = (of(Estimator::Moments), of(Estimator::Summits));
    for (a, b) in [(&summits, &moments), (&moments, &summits), (&summits, &summits)] {
        let refused = Statistics::combined(a, b);
        assert!(matches!(refused, Err(TopographyError::SummitsOfTwo)), "{refused:?}");
    }
    assert!(Statistics::combined(&moments, &moments).is_ok());
}

#[test]
fn skewness_and_kurtosis_of_two_surfaces_are_those_of_their_sum() {
    let mut uniform = Uniform(5);
    // Blocks of two by two points, because uncorrelated points barely have asperities.
    let mut skew = |power| {
        let blocks: Vec<f64> = (0..62_500).map(|_| uniform.next().powi(power)).collect();
        (0..250_000).map(|i| blocks[i % 500 / 2 + i / 1000 * 250]).collect::<Vec<_>>()
    };
    let (a, b) = (skew(4), skew(2));
    let sum = a.iter().zip(&b).map(|(a, b)| a + b).collect();
    let of = |heights| {
        let surface = Topography::new(heights, 500, [1.0; 2]).unwrap();
        surface.statistics(Estimator::Moments).unwrap()
    };
    let (a, b, sum) = (of(a), of(b), of(sum));
    let both = Statistics::combined(&a, &b).unwrap();
    assert!(a.ssk > 1.0 && (both.ssk - sum.ssk).abs() < 0.02, "{} {}", both.ssk, sum.ssk);
    assert!((both.sku - sum.sku).abs() < 0.05, "{} {}", both.sku, sum.sku);
}

fn noisy(noise: f64) -> Topography {
    let smooth = rough();
    let mut uniform = Uniform(11);
    let heights = smooth.heights().iter().map(|z| z + noise * (uniform.next() - 0.5)).collect();
    Topography::new(heights, 768, [1e-6; 2]).unwrap()
}

#[test]
fn noise_has_a_warning_and_smoothing_removes_it() {
    let noisy = noisy(2e-7);
    let warnings = noisy.statistics(Estimator::Moments).unwrap().warnings;
    let follows = |warning: &Finding| warning.code.name() == "summits-follow-sampling";
    assert!(warnings.iter().any(follows), "{warnings:?}");
    let steep = |warning: &Finding| warning.code.name() == "roughness-parameter";
    assert!(warnings.iter().any(steep), "{warnings:?}");
    assert!(warnings.iter().all(|warning| warning.to_string().len() > 60));
    let smooth = noisy.smooth(10e-6).unwrap().statistics(Estimator::Moments).unwrap();
    assert!(!smooth.warnings.iter().any(follows), "{:?}", smooth.warnings);
    // A profile of it has a warning, too.
    let profile = Topography::new(noisy_row(), 768, [1e-6; 2]).unwrap();
    let warnings = profile.statistics(Estimator::Moments).unwrap().warnings;
    let follows = |warning: &Finding| warning.code.name() == "curvature-follows-sampling";
    assert!(warnings.iter().any(follows), "{warnings:?}");
}

#[test]
fn estimators_that_disagree_give_one_warning() {
    // A few high summits on a nearly flat surface.
    let heights = rough().heights().iter().map(|z| (4e6 * z).exp()).collect();
    let peaked = Topography::new(heights, 768, [1e-6; 2]).unwrap();
    let warnings = peaked.statistics(Estimator::Moments).unwrap().warnings;
    let apart: Vec<_> =
        warnings.iter().filter(|warning| warning.code.name() == "estimators-disagree").collect();
    let [warning] = apart[..] else { panic!("{warnings:?}") };
    assert!(warning.value > 2.0 && (warning.usual[1] - 2.0).abs() < 1e-12, "{warning:?}");
    let text = warning.to_string();
    assert!((2..=3).contains(&text.matches("by the summits").count()), "{text}");
    assert_eq!(text.matches("compare the results").count(), 1, "{text}");
}

fn noisy_row() -> Vec<f64> {
    noisy(2e-7).heights()[..768].to_vec()
}

#[test]
fn profiles_have_the_moments_of_the_surface() {
    let surface = rough();
    let whole = surface.statistics(Estimator::Moments).unwrap();
    // The mean over all rows as profiles is that along rows.
    let mut m2 = 0.0;
    for row in surface.heights().chunks(768) {
        let profile = Topography::new(row.to_vec(), 768, [1e-6; 2]).unwrap().with_periodic(true);
        m2 += profile.moments().unwrap().profile.m2 / 768.0;
    }
    close(m2, whole.moments.along_rows[0], 1e-10);
    let profile = Topography::new(surface.heights()[..768].to_vec(), 768, [1e-6; 2]).unwrap();
    assert!(profile.statistics(Estimator::Moments).is_ok());
    let summits = profile.statistics(Estimator::Summits).unwrap();
    assert!(summits.surface().unwrap_err().to_string().contains("profile"));
}

#[test]
fn missing_points_change_the_statistics_little_and_are_reported() {
    let surface = rough();
    let whole = surface.statistics(Estimator::Summits).unwrap();
    let mut uniform = Uniform(3);
    let hole = |z: &f64| if uniform.next() < 0.02 { f64::NAN } else { *z };
    let holed = surface.heights().iter().map(hole).collect();
    let holed = Topography::new(holed, 768, [1e-6; 2]).unwrap();
    let holed = holed.statistics(Estimator::Summits).unwrap();
    assert!((holed.missing_share - 0.02).abs() < 0.002);
    close(holed.moments.profile.m4, whole.moments.profile.m4, 0.01);
    close(
        holed.surface().unwrap().asperity_density,
        whole.surface().unwrap().asperity_density,
        0.03,
    );
}

#[test]
fn a_load_on_the_density_is_the_load_on_the_summits() {
    // ⟨(z - d)^1.5⟩ over z > d, to which the Greenwood-Williamson force is proportional.
    let summits = rough().summits().unwrap();
    let std = summits.surface().unwrap().asperity_height_std;
    let n = summits.heights.len() as f64;
    let mean = summits.heights.iter().sum::<f64>() / n;
    let density = summits.height_density().unwrap();
    for (d, tolerance) in [(-1.0, 0.005), (0.0, 0.01), (1.0, 0.03)] {
        let load = |z: f64| (z - d * std).max(0.0).powf(1.5);
        let direct = summits.heights.iter().map(|z| load(z - mean)).sum::<f64>() / n;
        let (z, g) = (&density.heights_m, &density.density_per_m);
        let steps = 2000;
        let mut smooth = 0.0;
        for i in 1..z.len() {
            for k in 0..steps {
                let t = (f64::from(k) + 0.5) / f64::from(steps);
                let here = g[i - 1] + t * (g[i] - g[i - 1]);
                smooth += here * load(z[i - 1] + t * (z[i] - z[i - 1])) * (z[i] - z[i - 1])
                    / f64::from(steps);
            }
        }
        close(smooth, direct, tolerance);
    }
}

#[test]
fn a_flat_surface_is_refused_and_a_regular_one_has_statistics_without_asperities() {
    let flat = Topography::new(vec![1e-6; 100], 10, [1e-6; 2]).unwrap();
    let flat = flat.statistics(Estimator::Moments);
    assert!(matches!(flat, Err(TopographyError::Flat { points: 100 })));
    // One wave: no Gaussian surface has a bandwidth of 1.
    let wave = Spectrum { n: 64, pixel_size: [1e-6; 2], waves: vec![(3, 3, 1e-14)] };
    let wave = wave.surface(1).statistics(Estimator::Moments).unwrap();
    let error = wave.surface().unwrap_err().to_string();
    assert!(error.starts_with("bandwidth") && error.contains("summits"), "{error}");
    close(wave.sq, 1e-7, 1e-12);
    close(wave.sku, 1.5, 1e-12);
    assert!(wave.ssk.abs() < 1e-12);
    assert_eq!(wave.warnings[0].code.name(), "no-asperities");
    let json = serde_json::to_value(&wave).unwrap();
    assert!(json["asperity_radius"].is_null() && json["beta"].is_null() && json["m2"].is_number());
}

#[test]
fn json_has_the_numbers_only() {
    let statistics = rough().statistics(Estimator::Moments).unwrap();
    let json: serde_json::Map<String, serde_json::Value> =
        serde_json::from_str(&serde_json::to_string(&statistics).unwrap()).unwrap();
    let mut keys: Vec<_> = json.keys().map(String::as_str).collect();
    let mut expected: Vec<_> = "sq ssk sku m0 m2 m4 alpha asperity_density asperity_radius \
        asperity_height_std beta beta_z missing_share despiked outliers"
        .split_whitespace()
        .collect();
    keys.sort_unstable();
    expected.sort_unstable();
    assert_eq!(keys, expected);
    let outliers = json["outliers"].as_object().unwrap();
    assert!(outliers.values().all(serde_json::Value::is_number));
    let numbers = json.iter().filter(|(key, _)| *key != "outliers");
    assert!(numbers.into_iter().all(|(_, value)| value.is_number()));
}
