//! Contacts that have closed forms.

use std::f64::consts::{PI, TAU};

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase};

use crate::{MODULUS, close, paraboloid};

/// Westergaard 1939 \[recalled\]: a wave A cos(2πx/λ) is touched on sin²(πa/λ) = p/p*,
/// p* = π E A/λ, half-width a, by p(x) = 2p cos(πx/λ)/sin²(πa/λ) √(sin²(πa/λ) - sin²(πx/λ)).
#[test]
fn westergaards_wave() {
    let (n, amplitude) = (512, 0.01);
    let heights: Vec<f64> =
        (0..n * 2).map(|i| amplitude * (TAU * (i % n) as f64 / n as f64).cos()).collect();
    let map = HeightMap::new(heights, [2, n], [1.0 / n as f64; 2]).unwrap();
    let full = PI * MODULUS * amplitude;
    let solver = BoundaryElements::new(map, MODULUS).unwrap();
    for share in [0.05, 0.3, 0.7, 0.95] {
        let solution = solver.solve(LoadCase::MeanPressure(share * full)).unwrap();
        let half_width = share.sqrt().asin() / PI;
        // A pixel more or less at each of the two edges.
        assert!((solution.pixel_area - 2.0 * half_width).abs() <= 2.0 / n as f64);
        let exact = |x: f64| {
            let inside = share - (PI * x).sin().powi(2);
            2.0 * full * (PI * x).cos().abs() * inside.max(0.0).sqrt()
        };
        let error = (0..n).map(|i| (solution.pressures[i] - exact(i as f64 / n as f64)).powi(2));
        let rms = (error.sum::<f64>() / n as f64).sqrt();
        assert!(rms < 0.02 * share * full, "{share}: {rms:e}");
        close(solution.pressures[0], exact(0.0), 2e-3);
    }
    // All of it: the pressure is the mean and the wave.
    let solution = solver.solve(LoadCase::MeanPressure(1.5 * full)).unwrap();
    close(solution.pixel_area, 1.0, 0.0);
    assert!(solution.mean_gap.abs() < 1e-8 * amplitude);
    close(solution.pressures[0], 2.5 * full, 1e-9);
    close(solution.pressures[n / 2], 0.5 * full, 1e-9);
}

/// A sphere of the radius R on a half-space: a³ = 3FR/(4E), p0 = 2Ea/(πR), approach a²/R.
#[test]
fn hertzs_sphere_with_free_edges() {
    let (radius, load) = (1e-3, 2.0);
    let contact = (3.0 * load * radius / (4.0 * MODULUS)).cbrt();
    let (side, highest) = (4.0 * contact, 2.0 * MODULUS * contact / (PI * radius));
    let mut errors = Vec::new();
    for n in [33, 65, 129] {
        let step = side / n as f64;
        let map = paraboloid(n, step, radius);
        let area = map.area();
        let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
        let solution = solver.solve(LoadCase::Load(load)).unwrap();
        close(solution.load, load, 1e-12);
        let middle = (n / 2) * n + n / 2;
        let exact_area = PI * contact.powi(2);
        // Outside, at the middle of an edge: Johnson, Contact Mechanics, section 3.4. [recalled]
        let r = (n / 2) as f64 * step;
        let share = contact / r;
        let deflection = (2.0 - share.powi(-2)) * share.asin() + (share.powi(-2) - 1.0).sqrt();
        let gap = contact.powi(2) / radius * (deflection / PI - 1.0) + r * r / (2.0 * radius);
        errors.push([
            solution.pressures[middle] / highest - 1.0,
            solution.area * area / exact_area - 1.0,
            solution.gaps[n / 2] / gap - 1.0,
        ]);
        assert_eq!(solution.patches.len(), 1);
    }
    // First order in the pixel, and small on the finest grid.
    for (k, most) in [3e-3, 1.5e-2, 1e-3].into_iter().enumerate() {
        let [coarse, _, fine] = [0, 1, 2].map(|n: usize| errors[n][k].abs());
        assert!(fine < most && fine < 0.5 * coarse, "{errors:?}");
    }
}

/// A square of Love's on its own: one pixel of a flat map carries everything.
#[test]
fn one_pixel_of_a_free_map_sinks_as_loves_rectangle() {
    // One column is far above the rest.
    let (rows, columns, [dy, dx]) = (5, 4, [2e-6, 1e-6]);
    let mut heights = vec![0.0; rows * columns];
    heights[2 * columns + 1] = 1e-6;
    let map = HeightMap::new(heights, [rows, columns], [dy, dx]).unwrap();
    let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
    let solution = solver.solve(LoadCase::Load(1e-3)).unwrap();
    assert_eq!(solution.patches, [1]);
    // Deflection at the middle of an a x b rectangle under the force F: [recalled]
    // 2F/(π E a b) (a asinh(b/a) + b asinh(a/b)).
    let middle =
        2.0 * 1e-3 / (PI * MODULUS * dx * dy) * (dx * (dy / dx).asinh() + dy * (dx / dy).asinh());
    // At the corner of the map, by the midpoint rule.
    let corner = {
        let steps = 400;
        let mid = |k: usize, length: f64| ((k as f64 + 0.5) / f64::from(steps) - 0.5) * length;
        let sum: f64 = (0..steps as usize)
            .flat_map(|i| (0..steps as usize).map(move |j| (i, j)))
            .map(|(i, j)| 1.0 / (2.0 * dy + mid(i, dy)).hypot(dx + mid(j, dx)))
            .sum();
        1e-3 / (PI * MODULUS) * sum / f64::from(steps).powi(2)
    };
    close(1e-6 - solution.gaps[0], middle - corner, 1e-5);
}
