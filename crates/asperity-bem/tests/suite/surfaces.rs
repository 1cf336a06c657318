//! Random surfaces: what they are stated to be.

use asperity_bem::RandomSurface;

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
