//! What holds for every contact, whatever the surface.

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase, Solution};

use crate::{MODULUS, UNIT, close, rough};

const HARDNESS: f64 = 0.3 * UNIT;

fn all_ways(map: &HeightMap) -> Vec<BoundaryElements> {
    let mut ways = Vec::new();
    for boundary in [Boundary::Periodic, Boundary::Free] {
        let elastic = BoundaryElements::new(map.clone(), MODULUS).unwrap().boundary(boundary);
        ways.push(elastic.clone());
        ways.push(elastic.hardness(HARDNESS).unwrap());
    }
    ways
}

fn bits(solution: &Solution) -> Vec<u64> {
    solution.pressures.iter().chain(&solution.gaps).map(|number| number.to_bits()).collect()
}

#[test]
fn pressure_or_gap_never_both() {
    // Odd, even and oblong; sharp-edged too.
    let wavy = rough(64, 3);
    let cut: Vec<f64> = wavy.heights()[..64 * 51].to_vec();
    let steps: Vec<f64> = wavy.heights().iter().map(|h| (h * 2e6).round() * 5e-7).collect();
    let maps = [
        HeightMap::new(cut, [51, 64], [3e-6, 1e-6]).unwrap(),
        HeightMap::new(steps, [64, 64], wavy.pixel()).unwrap(),
        wavy,
    ];
    for map in &maps {
        for (way, solver) in all_ways(map).into_iter().enumerate() {
            let hardness = if way % 2 == 1 { HARDNESS } else { f64::INFINITY };
            for share in [1e-4, 0.02, 0.29] {
                let solution = solver.solve(LoadCase::MeanPressure(share * UNIT)).unwrap();
                close(solution.mean_pressure, share * UNIT, 1e-11);
                let little = 1e-5 * map.rms_height();
                for (&pressure, &gap) in solution.pressures.iter().zip(&solution.gaps) {
                    assert!((0.0..=hardness).contains(&pressure));
                    assert!(gap > -little || pressure >= hardness, "{way} {share} {gap:e}");
                    assert!(gap < little || pressure <= 0.0, "{way} {share} {gap:e}");
                }
                assert!(solution.residual <= 1e-8 && solution.residual >= 0.0);
                let pixels: usize = solution.patches.iter().sum();
                close(solution.pixel_area * solution.gaps.len() as f64, pixels as f64, 1e-12);
            }
        }
    }
}

#[test]
fn the_digits_do_not_depend_on_the_number_of_threads() {
    for solver in all_ways(&rough(128, 4)) {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| bits(&solver.solve(LoadCase::MeanPressure(0.05 * UNIT)).unwrap()))
        };
        assert!(on(1) == on(3));
    }
}

/// A solution's counts and mean gap must not change, its maps must equal `back`.
fn same(
    found: &Solution,
    required: &Solution,
    gap_unit: f64,
    pressure_unit: f64,
    back: impl Fn(usize) -> usize,
) {
    assert_eq!(found.patches, required.patches);
    assert_eq!(found.edges, required.edges);
    close(found.mean_gap * gap_unit, required.mean_gap, 1e-7);
    let highest = required.pressures.iter().copied().fold(0.0, f64::max);
    for (i, &pressure) in found.pressures.iter().enumerate() {
        let there = required.pressures[back(i)];
        assert!((pressure * pressure_unit - there).abs() < 1e-5 * highest);
    }
}

#[test]
fn shifted_turned_and_scaled_contacts_are_the_same() {
    let (rows, columns) = (48, 64);
    let map = HeightMap::new(
        rough(64, 5).heights()[..rows * columns].to_vec(),
        [rows, columns],
        [2e-6, 1e-6],
    )
    .unwrap();
    let at = |i: usize, j: usize| (i % rows) * columns + j % columns;
    let given = LoadCase::MeanPressure(0.04 * UNIT);
    for (way, solver) in all_ways(&map).into_iter().enumerate() {
        let required = solver.solve(given).unwrap();
        let with = |heights: Vec<f64>, shape, pixel, units: f64| {
            let map = HeightMap::new(heights, shape, pixel).unwrap();
            // Lengths and pressures in other units.
            let solver = BoundaryElements::new(map, MODULUS * units).unwrap();
            let boundary = if way < 2 { Boundary::Periodic } else { Boundary::Free };
            let solver = solver.boundary(boundary);
            if way % 2 == 1 { solver.hardness(HARDNESS * units).unwrap() } else { solver }
        };
        // A quarter turn: row i, column j comes from row j, column (columns - 1 - i).
        let turned = |i: usize| at(i % rows, columns - 1 - i / rows);
        let heights = (0..rows * columns).map(|i| map.heights()[turned(i)]).collect();
        let found = with(heights, [columns, rows], [1e-6, 2e-6], 1.0).solve(given).unwrap();
        same(&found, &required, 1.0, 1.0, turned);

        let heights = map.heights().iter().map(|h| h * 1e9 + 77.0).collect();
        let scaled = with(heights, [rows, columns], [2e3, 1e3], 1e-6);
        let found = scaled.solve(LoadCase::MeanPressure(0.04 * UNIT * 1e-6)).unwrap();
        same(&found, &required, 1e-9, 1e6, |i| i);

        if way < 2 {
            let shifted = |i: usize| at(i / columns + 17, i % columns + 5);
            let heights = (0..rows * columns).map(|i| map.heights()[shifted(i)]).collect();
            let found = with(heights, [rows, columns], [2e-6, 1e-6], 1.0).solve(given).unwrap();
            same(&found, &required, 1.0, 1.0, shifted);
        }
    }
}

#[test]
fn a_hardness_out_of_reach_changes_nothing() {
    let map = rough(64, 6);
    let elastic = BoundaryElements::new(map, MODULUS).unwrap();
    let hard = elastic.clone().hardness(100.0 * UNIT).unwrap();
    let given = LoadCase::MeanPressure(0.02 * UNIT);
    let (a, b) = (elastic.solve(given).unwrap(), hard.solve(given).unwrap());
    assert_eq!(a.patches, b.patches);
    assert_eq!((a.plastic_area, b.plastic_area), (0.0, 0.0));
    close(b.mean_gap, a.mean_gap, 1e-7);
}

#[test]
fn soft_and_hard_extremes_end_quickly() {
    // Where almost every pixel flows, where a single one touches, where all do.
    let map = rough(64, 7);
    let elastic = BoundaryElements::new(map, MODULUS).unwrap();
    for (hardness, share) in
        [(1e-4, 3.3e-5), (1e-4, 0.99e-4), (0.1, 0.099), (3.0, 1.5), (1e3, 1e-7), (1e3, 20.0)]
    {
        let solver = elastic.clone().hardness(hardness * UNIT).unwrap().most_iterations(80);
        let solution = solver.solve(LoadCase::MeanPressure(share * UNIT)).unwrap();
        close(solution.mean_pressure, share * UNIT, 1e-10);
    }
}
