//! A surface that is turned under the instrument has the same numbers.

use std::f64::consts::TAU;

use asperity_topography::{Estimator, Level, Topography};

const SIDE: usize = 160;

/// A disc of a surface of 30 waves, turned by an angle about its middle; slopes along its lay,
/// which is along columns, are smaller by the factor `ratio`. Turned, the same part is measured.
fn disc(ratio: f64, degrees: f64) -> Topography {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let wave = |k: i32| {
        let turn = 2.399_963 * f64::from(k);
        let number = TAU / (12.0 + f64::from(k * 7 % 30));
        let (u, v) = (number * turn.cos(), number * turn.sin() / ratio);
        [cos * u - sin * v, sin * u + cos * v, 5.1 * f64::from(k * k)]
    };
    let waves: Vec<[f64; 3]> = (0..30).map(wave).collect();
    let place = |k: usize| k as f64 - 0.5 * (SIDE - 1) as f64;
    let height = |k: usize| {
        let (x, y) = (place(k % SIDE), place(k / SIDE));
        let inside = x.hypot(y) < 0.5 * SIDE as f64;
        let sum = |_| waves.iter().map(|[a, b, c]| (a * x + b * y + c).cos()).sum::<f64>();
        2.5e-7 * inside.then_some(()).map_or(f64::NAN, sum)
    };
    let heights = (0..SIDE * SIDE).map(height).collect();
    Topography::new(heights, SIDE, [1e-6; 2]).unwrap().level(Level::Plane).unwrap()
}

/// Names, numbers and the largest errors of the grid, and the codes of warnings.
fn measured(surface: &Topography) -> (Vec<(&'static str, f64, f64)>, Vec<String>) {
    let [moments, summits] = [Estimator::Moments, Estimator::Summits]
        .map(|estimator| surface.statistics(estimator).unwrap());
    let parameters = surface.parameters().unwrap();
    let (lay, correlation) = (moments.moments.texture().unwrap(), surface.lay().unwrap());
    let decay = surface.decay().unwrap();
    let numbers = vec![
        ("sq", moments.sq, 0.001),
        ("m2", moments.moments.profile.m2, 0.006),
        ("m4", moments.moments.profile.m4, 0.011),
        ("alpha", moments.moments.profile.bandwidth(), 0.003),
        ("eta", moments.surface().unwrap().asperity_density, 0.006),
        ("R", moments.surface().unwrap().asperity_radius, 0.006),
        ("sigma", moments.surface().unwrap().asperity_height_std, 0.001),
        // Of 20 to 60 summits, a few at the rim come and go.
        ("eta of summits", summits.surface().unwrap().asperity_density, 0.1),
        ("R of summits", summits.surface().unwrap().asperity_radius, 0.03),
        ("sigma of summits", summits.surface().unwrap().asperity_height_std, 0.12),
        ("slope along the lay", lay.slope_along, 0.01),
        ("slope across the lay", lay.slope_across, 0.01),
        ("1 + skewness by slopes", 1.0 + moments.moments.slope_skewness(), 0.003),
        ("sdq", parameters.sdq, 0.003),
        ("sdr", parameters.sdr.unwrap(), 0.006),
        ("sal", decay.sal, 0.01),
        ("shortest correlation", correlation.lengths[0].min(correlation.lengths[1]), 0.01),
        ("longest correlation", correlation.lengths[0].max(correlation.lengths[1]), 0.01),
    ];
    let codes = moments.warnings.iter().map(|found| found.code.to_string()).collect();
    (numbers, codes)
}

#[test]
fn a_turned_scan_has_the_numbers_of_the_scan() {
    for ratio in [1.0, 4.0] {
        let straight = disc(ratio, 0.0);
        let (wanted, codes) = measured(&straight);
        for degrees in [17.0, 30.0, 45.0, 90.0] {
            let surface = disc(ratio, degrees);
            let (found, warned) = measured(&surface);
            for ((name, found, slack), (_, wanted, _)) in found.into_iter().zip(&wanted) {
                let off = (found / wanted - 1.0).abs();
                let slack = if degrees > 89.0 { 1e-9 } else { slack };
                assert!(off < slack, "{ratio} {degrees}: {name} {found:e} {wanted:e} {off:.4}");
            }
            assert_eq!(warned, codes, "{ratio} {degrees}");
            if ratio > 1.0 {
                let direction =
                    |of: &Topography| of.moments().unwrap().texture().unwrap().direction;
                let turned = direction(&surface) - direction(&straight) - degrees;
                let off = turned.rem_euclid(180.0);
                assert!(off.min(180.0 - off) < 0.5, "{degrees} {off}");
                let off = (surface.lay().unwrap().degrees - direction(&surface)).rem_euclid(90.0);
                assert!(off.min(90.0 - off) < 1.0, "{degrees} {off}");
            }
        }
    }
}
