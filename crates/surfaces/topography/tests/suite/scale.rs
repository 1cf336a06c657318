//! Answers do not depend on the unit: heights scaled by 1e-12 to 1e3 have scaled answers.

use asperity_topography::{Estimator, Level, Topography};

use crate::gaussian::{Spectrum, Uniform};

const SCALES: [f64; 6] = [1e-12, 3.7e-10, 1e-9, 1e-6, 1e-3, 1e3];

/// Heights of rms 1, with holes.
fn surface(scale: f64) -> Topography {
    let whole = Spectrum::isotropic(128, 1e-6, [2.0, 16.0], 3.0, 1.0, |_, _| true).surface(7);
    let mut uniform = Uniform(9);
    let mut hole = |z: &f64| if uniform.next() < 0.01 { f64::NAN } else { scale * (z + 3.0) };
    let heights = whole.heights().iter().map(&mut hole).collect();
    Topography::new(heights, 128, [1e-6; 2]).unwrap()
}

#[test]
fn heights_of_every_scale_have_the_same_answers() {
    type Step = fn(Topography) -> Topography;
    let steps: [(&str, Step); 6] = [
        ("smooth", |s| s.smooth(9e-6).unwrap()),
        ("filter", |s| s.filter(40e-6).unwrap()),
        ("plane", |s| s.level(Level::Plane).unwrap()),
        ("quadratic", |s| s.level(Level::Quadratic).unwrap()),
        ("fill", |s| s.fill().unwrap()),
        ("all", |s| s.levelled(None).unwrap().fill().unwrap().smooth(9e-6).unwrap()),
    ];
    for (name, step) in steps {
        let wanted = step(surface(1.0));
        for scale in SCALES {
            let found = step(surface(scale));
            for (found, wanted) in found.heights().iter().zip(wanted.heights()) {
                assert_eq!(found.is_nan(), wanted.is_nan());
                // Heights of rms 1 about 3.
                let off = (found / scale - wanted).abs();
                assert!(found.is_nan() || off < 1e-12, "{name} {scale:e}: {off:e}");
            }
        }
    }
}

#[test]
fn statistics_and_summits_scale_with_the_heights() {
    let of = |scale| {
        let surface = surface(scale).levelled(None).unwrap().fill().unwrap();
        let surface = surface.smooth(9e-6).unwrap();
        let summits = surface.summits().unwrap();
        (surface.statistics(Estimator::Moments).unwrap(), summits)
    };
    let (wanted, peaks) = of(1.0);
    for scale in SCALES {
        let (found, summits) = of(scale);
        let square = scale * scale;
        for (k, (found, wanted)) in [
            (found.sq / scale, wanted.sq),
            (found.ssk, wanted.ssk),
            (found.sku, wanted.sku),
            (found.moments.profile.m0 / square, wanted.moments.profile.m0),
            (found.moments.profile.m2 / square, wanted.moments.profile.m2),
            (found.moments.profile.m4 / square, wanted.moments.profile.m4),
            (found.moments.profile.bandwidth(), wanted.moments.profile.bandwidth()),
            (
                found.surface().unwrap().asperity_radius * scale,
                wanted.surface().unwrap().asperity_radius,
            ),
            (found.surface().unwrap().asperity_density, wanted.surface().unwrap().asperity_density),
            (
                found.surface().unwrap().asperity_height_std / scale,
                wanted.surface().unwrap().asperity_height_std,
            ),
        ]
        .into_iter()
        .enumerate()
        {
            assert!((found / wanted - 1.0).abs() < 1e-12, "{k} {scale:e}: {found:e} {wanted:e}");
        }
        assert_eq!(summits.heights.len(), peaks.heights.len());
        for (found, wanted) in summits.curvatures.iter().zip(&peaks.curvatures) {
            // 1 m over 1 µm², in which heights of 1 m round.
            assert!((found / scale - wanted).abs() < 1e-12 * 1e12, "{found:e} {wanted:e}");
        }
    }
}
