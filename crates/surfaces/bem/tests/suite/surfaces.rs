//! Random surfaces: what they are stated to be.

use std::f64::consts::TAU;

use asperity_bem::{BemError, HeightMap, RandomSurface};

use crate::close;

#[test]
fn moments_are_those_of_the_heights() {
    let surface = RandomSurface::new(2.0, 3.0, 20.0).unwrap().hurst(0.6).unwrap();
    let surface = surface.side(3.0).unwrap().gradient(0.02).unwrap().seed(7);
    let (n, map) = (256, surface.heights(256).unwrap());
    let moments = surface.moments();
    close(moments.m2, 0.5 * 0.02_f64.powi(2), 1e-12);
    close(map.rms_height().powi(2), moments.m0, 1e-12);
    // Derivatives of profiles along rows and columns by differences of eighth order.
    let h = map.heights();
    let step = 3.0 / f64::from(n);
    let n = n as usize;
    let [mut slope, mut bend] = [0.0; 2];
    for at in 0..n * n {
        let (i, j) = (at / n, at % n);
        for down in [true, false] {
            let near = |k: usize| {
                if down { h[(i + k) % n * n + j] } else { h[i * n + (j + k) % n] }
            };
            let (ahead, back) = (|k: usize| near(k), |k: usize| near(n - k));
            let first = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
            let second = [8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
            let d1: f64 = (1..5).map(|k| first[k - 1] * (ahead(k) - back(k))).sum();
            let d2: f64 = (1..5).map(|k| second[k - 1] * (ahead(k) + back(k))).sum();
            slope += (d1 / step).powi(2);
            bend += ((d2 - 205.0 / 72.0 * near(0)) / step.powi(2)).powi(2);
        }
    }
    let count = (2 * n * n) as f64;
    close(slope / count, moments.m2, 1e-6);
    // Rows and columns are two directions of all, and a lattice is not quite isotropic.
    close(bend / count, moments.m4, 6e-3);
    close(moments.bandwidth(), moments.m0 * moments.m4 / moments.m2.powi(2), 1e-15);
}

#[test]
fn the_same_surface_on_every_grid_and_another_for_every_seed() {
    let surface = RandomSurface::new(1.0, 2.0, 10.0).unwrap();
    let (coarse, fine) = (surface.heights(45).unwrap(), surface.heights(90).unwrap());
    let half = fine.half_grid().unwrap();
    for (a, b) in coarse.heights().iter().zip(half.heights()) {
        assert!((a - b).abs() < 1e-12 * coarse.rms_height() * 10.0);
    }
    let other = surface.seed(1).heights(45).unwrap();
    let product: f64 = coarse.heights().iter().zip(other.heights()).map(|(a, b)| a * b).sum();
    let correlation = product / (45.0 * 45.0) / coarse.rms_height().powi(2);
    assert!(correlation.abs() < 0.5, "{correlation}");
    close(other.rms_height(), coarse.rms_height(), 1e-12);
}

/// The waves of a periodic map by plain sums over its rows and columns: (i, j) and the mean square
/// of each pair of opposite waves.
fn spectrum(map: &HeightMap) -> Vec<([f64; 2], f64)> {
    let [rows, columns] = map.shape();
    let turn = |n: usize, k: usize| TAU * (k % n) as f64 / n as f64;
    let along: Vec<Vec<[f64; 2]>> = map
        .heights()
        .chunks(columns)
        .map(|row| {
            let wave = |j: usize| {
                let term = |(b, h): (usize, &f64)| {
                    let (sin, cos) = turn(columns, j * b).sin_cos();
                    [h * cos, -h * sin]
                };
                row.iter().enumerate().map(term).fold([0.0; 2], |s, t| [s[0] + t[0], s[1] + t[1]])
            };
            (0..columns / 2).map(wave).collect()
        })
        .collect();
    let mut found = vec![];
    let half = rows as i64 / 2;
    for j in 0..columns / 2 {
        for i in (1 - half)..half {
            if j == 0 && i <= 0 {
                continue;
            }
            let [mut re, mut im] = [0.0; 2];
            for (a, row) in along.iter().enumerate() {
                let (sin, cos) = turn(rows, i.rem_euclid(rows as i64) as usize * a).sin_cos();
                re += row[j][0] * cos + row[j][1] * sin;
                im += row[j][1] * cos - row[j][0] * sin;
            }
            let n = (rows * columns) as f64;
            found.push(([i as f64, j as f64], 2.0 * (re * re + im * im) / (n * n)));
        }
    }
    found
}

fn skewness(map: &HeightMap) -> f64 {
    let n = map.heights().len() as f64;
    map.heights().iter().map(|h| h.powi(3)).sum::<f64>() / n / map.rms_height().powi(3)
}

#[test]
fn oblong_surfaces_with_unequal_pixels_have_the_spectrum_of_every_wave() {
    let [long, roll_off, short] = [40e-6, 16e-6, 2.45e-6];
    let size = [60e-6, 36e-6];
    let surface = RandomSurface::of_wavelengths([long, roll_off, short], size).unwrap();
    let surface = surface.hurst(0.7).unwrap().rms_height(3e-7).unwrap().seed(5);
    for skew in [None, Some(-1.0), Some(0.6)] {
        let surface = skew.map_or(surface, |skew| surface.skewness(skew).unwrap());
        // Pixels of 1.2 and 0.75 µm.
        let map = surface.map([48, 50]).unwrap();
        close(map.pixel()[0], 36e-6 / 48.0, 1e-12);
        close(map.pixel()[1], 60e-6 / 50.0, 1e-12);
        close(map.rms_height(), 3e-7, 1e-9);
        if let Some(skew) = skew {
            close(skewness(&map), skew, 2e-3);
        }
        let law = |[i, j]: [f64; 2]| {
            let k = (i / size[1]).hypot(j / size[0]);
            let shown = (1.0 / long..=1.0 / short).contains(&k);
            if shown { (k * roll_off).max(1.0).powf(-2.0 * 1.7) } else { 0.0 }
        };
        let waves = spectrum(&map);
        let all: f64 = waves.iter().map(|(at, _)| law(*at)).sum();
        for (at, found) in waves {
            let asked = 9e-14 * law(at) / all;
            assert!((found - asked).abs() <= 1e-9 * asked + 1e-26, "{at:?}: {found:e} {asked:e}");
        }
    }
}

#[test]
fn a_lay_has_the_ratio_of_slopes_and_the_direction() {
    let cases =
        [(3.0, 0.0, [128e-6, 128e-6]), (3.0, 30.0, [128e-6, 90e-6]), (1.5, -70.0, [90e-6; 2])];
    for (ratio, degrees, size) in cases {
        let surface = RandomSurface::of_wavelengths([60e-6, 40e-6, 5e-6], size).unwrap();
        let surface = surface.lay(ratio, degrees).unwrap().hurst(0.9).unwrap();
        let map = surface.rms_height(1e-6).unwrap().skewness(0.8).unwrap().map([72, 80]).unwrap();
        let [mut xx, mut xy, mut yy] = [0.0; 3];
        for ([i, j], square) in spectrum(&map) {
            let [y, x] = [TAU * i / size[1], TAU * j / size[0]];
            xx += square * x * x;
            xy += square * x * y;
            yy += square * y * y;
        }
        let along = |angle: f64| {
            let (sin, cos) = angle.sin_cos();
            (xx * cos * cos + 2.0 * xy * sin * cos + yy * sin * sin).sqrt()
        };
        let lay = degrees.to_radians();
        close(along(lay + TAU / 4.0) / along(lay), ratio, 0.012);
        // The slope is least along the lay.
        assert!([-0.02, 0.02].iter().all(|turn| along(lay + turn) > along(lay)));
    }
}

#[test]
fn surfaces_that_waves_cannot_make_are_refused() {
    let made = || RandomSurface::of_wavelengths([50e-6, 50e-6, 5e-6], [100e-6; 2]).unwrap();
    let message = |found: Result<RandomSurface, BemError>| found.unwrap_err().to_string();
    let lengths = |lengths| message(RandomSurface::of_wavelengths(lengths, [1e-4; 2]));
    assert!(lengths([1e-5, 2e-5, 1e-6]).starts_with("longest wave is 1e-5"));
    assert!(lengths([1e-5, 1e-5, 0.0]).starts_with("shortest wave is 0"));
    assert!(lengths([f64::NAN; 3]).contains("wave is NaN"));
    assert!(lengths([1e-5, 1e-5, 1e-9]).contains("1/8192 of the size"));
    assert!(lengths([9e-4, 5e-4, 2e-4]).contains("one whole wave"));
    assert!(message(made().lay(0.5, 0.0)).contains("slopes is 0.5"));
    assert!(message(made().lay(100.0, 0.0)).contains("slopes is 100"));
    assert!(message(made().lay(2.0, f64::INFINITY)).contains("lay is inf"));
    assert!(message(made().skewness(9.0)).starts_with("skewness is 9"));
    let few = RandomSurface::of_wavelengths([1e-4, 1e-4, 6e-5], [1e-4; 2]).unwrap();
    let few = few.skewness(4.0).unwrap().map([64, 64]).unwrap_err().to_string();
    assert!(few.starts_with("skewness is 4"), "{few}");
    assert!(made().map([64, 40]).unwrap_err().to_string().contains("two pixels"));
    assert!(made().map([0, 64]).is_err());
}
