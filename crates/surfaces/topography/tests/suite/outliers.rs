//! Outliers: those of spiked surfaces are found and replaced, clean surfaces keep their points.

use asperity_topography::{Estimator, Statistics, Topography, TopographyError};

use crate::gaussian::{Spectrum, Uniform};

/// A ground surface, 256 x 320: waves eight times as long along columns as along rows.
fn ground() -> Topography {
    let mut waves = vec![];
    for p in 3..40 {
        for q in -5..=5 {
            let size = f64::hypot(f64::from(p), 8.0 * f64::from(q));
            if size <= 40.0 {
                waves.push((p, q, size.powf(-3.0)));
            }
        }
    }
    let total: f64 = waves.iter().map(|wave| wave.2).sum();
    waves.iter_mut().for_each(|wave| wave.2 *= 4e-13 / total);
    let whole = Spectrum { n: 320, pixel_size: [1e-6; 2], waves }.surface(3);
    Topography::new(whole.heights()[..256 * 320].to_vec(), 320, [1e-6; 2]).unwrap()
}

fn statistics(surface: &Topography) -> Statistics {
    surface.clone().levelled(None).unwrap().statistics(Estimator::Moments).unwrap()
}

/// The surface with spikes of some Sq, each of `size` points in a row.
fn spiked(clean: &Topography, count: usize, size: usize, height: f64) -> Topography {
    let (mut heights, mut uniform) = (clean.heights().to_vec(), Uniform(8));
    let columns = clean.columns();
    for k in 0..count {
        let (x, y) = (uniform.next(), uniform.next());
        let x = (x * (columns - size) as f64) as usize;
        let y = (y * clean.rows() as f64) as usize;
        let sign = if k % 3 == 0 { -1.0 } else { 1.0 };
        for i in 0..size {
            heights[y * columns + x + i] += sign * height * (0.7 + 0.6 * uniform.next());
        }
    }
    Topography::new(heights, columns, clean.pixel_size()).unwrap()
}

#[test]
fn a_spiked_ground_surface_comes_back() {
    let clean = ground();
    let wanted = statistics(&clean);
    let anisotropic = |s: &Statistics| s.warnings.iter().any(|w| w.code.name() == "anisotropic");
    assert!(clean.outliers().count == 0 && anisotropic(&wanted));
    for (count, size) in [(40, 1), (20, 2), (12, 4)] {
        let spiked = spiked(&clean, count, size, 15.0 * wanted.sq);
        let found = statistics(&spiked);
        // As bad as it gets: three times the curvature and more.
        assert!(
            found.surface().unwrap().asperity_radius
                < 0.6 * wanted.surface().unwrap().asperity_radius
        );
        assert!(found.sku > 12.0 && found.outliers.matter(), "{}", found.sku);
        assert_eq!(found.outliers.count, count * size);
        assert!(found.outliers.largest.abs() > 12.0 * wanted.sq);
        assert_eq!(found.warnings[0].code.name(), "outliers");
        assert!(anisotropic(&found), "{:?}", found.warnings);

        let despiked = spiked.despiked().unwrap();
        let found = statistics(&despiked);
        assert_eq!((found.outliers.count, found.despiked), (0, count * size));
        for (found, wanted) in [
            (found.moments.profile.m0, wanted.moments.profile.m0),
            (found.moments.profile.m2, wanted.moments.profile.m2),
            (found.moments.profile.m4, wanted.moments.profile.m4),
            (found.sku, wanted.sku),
            (found.surface().unwrap().asperity_radius, wanted.surface().unwrap().asperity_radius),
            (found.surface().unwrap().asperity_density, wanted.surface().unwrap().asperity_density),
        ] {
            assert!((found / wanted - 1.0).abs() < 0.02, "{found:e} {wanted:e}");
        }
    }
}

#[test]
fn lost_points_are_found_at_any_share() {
    let clean = ground();
    for (nth, least) in [(400, 1.0), (90, 1.0), (41, 0.99), (19, 0.9)] {
        let lost = |at: usize| (7 * at + at / clean.columns()).is_multiple_of(nth);
        let height = |(at, z): (usize, &f64)| if lost(at) { -1e-4 } else { *z };
        let heights: Vec<f64> = clean.heights().iter().enumerate().map(height).collect();
        let all = (0..heights.len()).filter(|at| lost(*at)).count();
        let coded = Topography::new(heights, clean.columns(), clean.pixel_size()).unwrap();
        let found = coded.outliers();
        assert!(found.points.iter().all(|at| lost(*at)), "{nth}");
        assert!(found.count as f64 >= least * all as f64, "{nth}: {} of {all}", found.count);
    }
}

/// A surface without outliers, skewed by exp: skewness s of a lognormal of shape `width`.
fn skewed(surface: &Topography, width: f64) -> Topography {
    let sq = surface.moments().unwrap().profile.m0.sqrt();
    let bend = |z: &f64| if width == 0.0 { z / sq } else { (width * z / sq).exp() / width };
    let heights = surface.heights().iter().map(bend).collect();
    Topography::new(heights, surface.columns(), surface.pixel_size()).unwrap()
}

#[test]
fn clean_surfaces_keep_their_points() {
    let mut uniform = Uniform(2);
    // Uniform heights by sums of twelve: white noise, nearly Gaussian.
    let noise = (0..512 * 512).map(|_| (0..12).map(|_| uniform.next()).sum::<f64>() - 6.0);
    let noise = Topography::new(noise.collect(), 512, [1e-6; 2]).unwrap();
    let mut surfaces = vec![("noise", noise)];
    for (name, to) in [("two pixels", 128.0), ("three pixels", 85.0), ("eight pixels", 32.0)] {
        let spectrum = Spectrum::isotropic(256, 1e-6, [4.0, to], 3.6, 1e-6, |_, _| true);
        surfaces.push((name, spectrum.surface(5)));
    }
    for (name, surface) in &surfaces {
        // Skewness 2 and -2 at a width of 0.5513.
        for width in [-0.5513, 0.0, 0.5513] {
            let surface = skewed(surface, width);
            let found = surface.outliers();
            let share = found.count as f64 / surface.heights().len() as f64;
            assert!(share < 1e-4 && !found.matter(), "{name} {width}: {found:?}");
            // Profiles through it.
            let rows = surface.heights().chunks(surface.columns());
            let profile = |row: &[f64]| Topography::new(row.to_vec(), row.len(), [1e-6; 2]);
            let lost: usize = rows.map(|row| profile(row).unwrap().outliers().count).sum();
            let share = lost as f64 / surface.heights().len() as f64;
            assert!(share < 1e-3, "profiles, {name} {width}: {share:e}");
        }
    }
}

#[test]
fn steps_corners_and_lines_are_not_outliers() {
    let checks = |x: usize, y: usize| f64::from((x / 7 + y / 5).is_multiple_of(2));
    let groove = |x: usize, y: usize| -f64::from(x == 20 || x == y);
    let terraces = |x: usize, _: usize| (x / 9) as f64;
    let shapes: [&dyn Fn(usize, usize) -> f64; 3] = [&checks, &groove, &terraces];
    for (k, shape) in shapes.iter().enumerate() {
        for noise in [0.0, 0.01] {
            let mut uniform = Uniform(4);
            let height = |at: usize| shape(at % 64, at / 64) + noise * uniform.next();
            let surface = Topography::new((0..64 * 64).map(height).collect(), 64, [1.0; 2]);
            assert_eq!(surface.unwrap().outliers().count, 0, "{k} {noise}");
        }
    }
}

#[test]
fn small_flat_and_holed_surfaces_have_none_or_their_own() {
    let flat = Topography::new(vec![0.0; 100], 10, [1.0; 2]).unwrap();
    assert_eq!(flat.outliers(), asperity_topography::Outliers::default());
    for (count, columns) in [(4, 2), (12, 3), (9, 9), (1, 1)] {
        let heights = (0..count).map(|k| f64::from(k == 1)).collect();
        let small = Topography::new(heights, columns, [1.0; 2]).unwrap();
        assert_eq!(small.clone().outliers().count, 0);
        assert_eq!(small.clone().despiked().unwrap(), small);
    }
    let mut heights: Vec<f64> = (0..400).map(|k| 0.1 * (f64::from(k % 20)).sin()).collect();
    heights[210] = 50.0;
    heights[211] = f64::NAN;
    heights[0] = -40.0;
    let holed = Topography::new(heights, 20, [1.0, 2.0]).unwrap();
    let found = holed.outliers();
    assert_eq!((found.points.clone(), found.count), (vec![0, 210], 2));
    assert!((found.largest / 50.0 - 1.0).abs() < 0.05, "{found:?}");
    let despiked = holed.despiked().unwrap();
    assert!(despiked.heights()[211].is_nan() && despiked.heights()[210].abs() < 0.2);
    assert!(despiked.heights()[0].abs() < 0.2);
    // A filter spreads them: they are reported, and too late to be replaced.
    let smooth = spiked(&ground(), 40, 1, 1e-5).smooth(1e-5).unwrap();
    assert_eq!(smooth.outliers().count, 40);
    assert!(matches!(smooth.despiked(), Err(TopographyError::Filtered)));
}
