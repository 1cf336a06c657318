//! Loads so light that deflections are far below the heights, and heights of any size.

use asperity_bem::{BoundaryElements, HeightMap, LoadCase};

use crate::{MODULUS, UNIT, close, rough};

/// Waves along both sides whose highest pixels are several, on pixels of 1 µm; heights in units of
/// `size` \[m\].
fn waves(size: f64) -> HeightMap {
    let n = 64;
    let at = |k: usize| std::f64::consts::TAU * k as f64 / n as f64;
    let heights = (0..n * n).map(|k| {
        let (x, y) = (at(k / n), at(k % n));
        size * (x.cos() + (2.0 * y).cos() + 0.3 * (3.0 * x + 2.0 * y).cos())
    });
    HeightMap::new(heights.collect(), [n, n], [1e-6; 2]).unwrap()
}

/// Balance, and contact where pressure is and nowhere else, as parts of what one pixel under all of
/// the load is pressed in by.
fn holds(solver: &BoundaryElements, map: &HeightMap, pressures: &[f64]) {
    let given: Vec<LoadCase> = pressures.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
    let solutions = solver.solve_all(&given, |_| std::ops::ControlFlow::Continue(()));
    for (pressure, solution) in pressures.iter().zip(solutions) {
        let solution = solution.unwrap();
        close(solution.mean_pressure, *pressure, 1e-12);
        let scale = (pressure * map.area() / (MODULUS * 1e-6)).min(map.rms_height());
        for (&p, &gap) in solution.pressures.iter().zip(&solution.gaps) {
            assert!(gap > -1e-5 * scale && (gap < 1e-5 * scale || p <= 0.0), "{pressure}: {gap:e}");
        }
    }
}

#[test]
fn any_load_is_in_balance_alone_and_after_a_heavy_one() {
    let map = waves(1e-6);
    let solver = BoundaryElements::new(map.clone(), MODULUS).unwrap();
    for light in [1e2, 1.0, 1e-2, 1e-4, 1e-8] {
        holds(&solver, &map, &[light]);
        holds(&solver, &map, &[1e9, light]);
    }
}

#[test]
fn heights_of_any_size_have_the_same_contact() {
    let one = BoundaryElements::new(waves(1e-6), MODULUS).unwrap();
    for light in [1e8, 1e2, 1e-4] {
        let of_one = one.solve(LoadCase::MeanPressure(light)).unwrap();
        for size in [1e-12, 1e-6, 1e3] {
            let map = waves(1e-6 * size);
            let solver = BoundaryElements::new(map.clone(), MODULUS).unwrap();
            holds(&solver, &map, &[light * size]);
            let found = solver.solve(LoadCase::MeanPressure(light * size)).unwrap();
            close(found.pixel_area, of_one.pixel_area, 1e-12);
            // Both are iterated to 1e-8 of Sq.
            close(found.mean_gap, size * of_one.mean_gap, 1e-7);
        }
    }
}

#[test]
fn rough_maps_are_solved_at_any_load_with_a_hardness_too() {
    let map = rough(64, 5);
    let elastic = BoundaryElements::new(map.clone(), MODULUS).unwrap();
    let soft = elastic.clone().hardness(0.3 * UNIT).unwrap();
    for exponent in [2, 6, 12, 16, 20] {
        let pressure = UNIT / 10f64.powi(exponent);
        for solver in [&elastic, &soft] {
            for list in [&[pressure][..], &[0.1 * UNIT, pressure]] {
                let given: Vec<LoadCase> =
                    list.iter().map(|p| LoadCase::MeanPressure(*p)).collect();
                let solutions = solver.solve_all(&given, |_| std::ops::ControlFlow::Continue(()));
                close(solutions.last().unwrap().as_ref().unwrap().mean_pressure, pressure, 1e-12);
            }
        }
    }
}
