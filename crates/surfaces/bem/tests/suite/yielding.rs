//! Areas of contacts that yield, against finer grids.

use std::f64::consts::PI;

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface, Solution};

use crate::{MODULUS, UNIT, close, is_long, paraboloid, rough};

/// Waves of at least 1/16 of the side, on n x n pixels.
fn surface(n: usize) -> HeightMap {
    let surface = RandomSurface::new(2.0, 4.0, 16.0).unwrap().gradient(0.1).unwrap();
    surface.side(1e-4).unwrap().seed(1).heights(n).unwrap()
}

/// No pressure exceeds H: the contact is at least F/H, and at least its plastic part.
#[track_caller]
fn carries(solution: &Solution, hardness: f64) {
    let least = solution.mean_pressure / hardness;
    assert!(solution.area >= least * (1.0 - 1e-12), "{} < {least}", solution.area);
    if let LoadCase::MeanPressure(pressure) = solution.given {
        assert!(solution.area >= pressure / hardness, "{} {pressure}", solution.area);
    }
    assert!(solution.area <= solution.pixel_area * (1.0 + 1e-12));
    assert!(solution.plastic_area <= solution.area * (1.0 + 1e-12));
}

/// From 35 to 99 % plastic, at 8, 16 and 64 pixels per shortest wave.
#[test]
fn yielded_contacts_keep_the_area_of_finer_grids() {
    let hardnesses = [0.05, 0.15, 0.6, 0.1, 0.2, 0.3];
    for hardness in hardnesses.into_iter().take(if is_long() { 6 } else { 3 }) {
        let given = LoadCase::MeanPressure(0.01 * UNIT);
        let solve = |n| {
            let solver = BoundaryElements::new(surface(n), MODULUS).unwrap();
            let solver = solver.hardness(hardness * UNIT).unwrap().tolerance(1e-6).unwrap();
            let solution = solver.solve(given).unwrap();
            carries(&solution, hardness * UNIT);
            solution
        };
        let fine = solve(512).area;
        for (n, within) in [(128, 0.02), (256, 0.015)] {
            close(solve(n).area, fine, within);
        }
    }
}

/// F/H to the last digit of the given load, though pressures sum to a little less.
#[test]
fn nearly_full_plastic_contacts_carry_their_load() {
    let hardness = 0.05 * UNIT;
    let solver = BoundaryElements::new(surface(64), MODULUS).unwrap().hardness(hardness).unwrap();
    let shares = (0..16).map(|k| 0.9 + 0.006 * f64::from(k));
    let given: Vec<_> = shares.map(|share| LoadCase::MeanPressure(share * hardness)).collect();
    let solved = solver.solve_all(&given, |_| std::ops::ControlFlow::Continue(()));
    solved.into_iter().for_each(|solution| carries(&solution.unwrap(), hardness));
}

/// Deflections of such loads hide the heights: refused, and the other loads of a list as alone.
#[test]
fn loads_far_above_the_modulus_are_refused() {
    let solver = BoundaryElements::new(surface(64), MODULUS).unwrap();
    let given = [0.01 * UNIT, 1e100, 0.02 * UNIT].map(LoadCase::MeanPressure);
    let solved = solver.solve_all(&given, |_| std::ops::ControlFlow::Continue(()));
    let refused = solver.solve(given[1]).unwrap_err();
    assert!(refused.to_string().starts_with("mean pressure is 1e100: "), "{refused}");
    assert_eq!(solved[1].as_ref().unwrap_err(), &refused);
    for k in [0, 2] {
        close(solved[k].as_ref().unwrap().area, solver.solve(given[k]).unwrap().area, 1e-3);
    }
}

/// Where all of a sphere's contact yields it carries H on F/H.
#[test]
fn a_soft_sphere_carries_the_hardness() {
    let (radius, hardness) = (1e-3, 1e-3 * MODULUS);
    for [pixels, within] in [[8.0, 0.02], [16.0, 0.01]] {
        let contact = 1e-4;
        let n = 65;
        let step = contact / pixels;
        let map = paraboloid(n, step, radius);
        let nominal = map.area();
        let solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(Boundary::Free);
        let solver = solver.hardness(hardness).unwrap();
        let load = PI * contact.powi(2) * hardness;
        let solution = solver.solve(LoadCase::Load(load)).unwrap();
        carries(&solution, hardness);
        close(solution.area * nominal, load / hardness, within);
    }
}

/// Pixels out of contact have a gap above 0 also where the imprint makes the mean gap negative, and
/// the area is at least F/H.
#[test]
fn open_gaps_are_positive_and_the_area_carries_the_load() {
    let elastic = BoundaryElements::new(rough(64, 3), MODULUS).unwrap();
    let mut reached = [0; 2];
    for [hardness, share] in [[0.5, 0.02], [0.05, 0.1], [0.05, 0.5], [0.05, 0.99]] {
        let hardness = hardness * UNIT;
        let solver = elastic.clone().hardness(hardness).unwrap();
        let solution = solver.solve(LoadCase::MeanPressure(share * hardness)).unwrap();
        let pixels = solution.pressures.iter().zip(&solution.gaps);
        let open: Vec<f64> = pixels.filter(|(p, _)| **p <= 0.0).map(|(_, gap)| *gap).collect();
        let mean = open.iter().sum::<f64>() / open.len() as f64;
        close(solution.mean_open_gap.unwrap(), mean, 1e-12);
        assert!(mean > 0.0 && mean > solution.mean_gap);
        assert!(solution.area >= share, "{share}");
        reached[0] += usize::from(solution.mean_gap < 0.0);
        reached[1] += usize::from(solution.area <= share);
    }
    assert!(reached.iter().all(|count| (1..4).contains(count)), "{reached:?}");
    let full = elastic.solve(LoadCase::MeanPressure(3.0 * UNIT)).unwrap();
    assert_eq!((full.pixel_area >= 1.0, full.mean_open_gap), (true, None));
}
