//! The cap on pressure beside volumetric J2 plasticity: tests/reference/bem_j2.csv.

use asperity_bem::{BoundaryElements, LoadCase, RandomSurface};

const J2: &str = include_str!("../../../../../tests/reference/bem_j2.csv");

#[test]
fn the_cap_errs_in_area_as_the_chapter_states() {
    // Hardness and pressure over E g; the mean of area by J2 over area by the cap.
    let stated = [(0.4, 0.02, 1.21), (0.4, 0.1, 1.38), (0.15, 0.02, 1.05), (0.15, 0.05, 1.58)];
    for (hardness, pressure, ratio) in stated {
        let mut ratios = Vec::new();
        for line in J2.lines().filter(|line| line.starts_with("rough") && line.contains(",64,24,"))
        {
            let cell = |i: usize| line.split(',').nth(i).unwrap().parse::<f64>().unwrap();
            if (cell(4), cell(6)) != (hardness, pressure) {
                continue;
            }
            let surface = RandomSurface::new(1.0, 2.0, 4.0).unwrap();
            let surface = surface.gradient(0.1).unwrap().side(1.0).unwrap();
            let map = surface.seed(cell(1) as u64).heights(64).unwrap();
            let solver = BoundaryElements::new(map, 1.0).unwrap().hardness(0.1 * hardness).unwrap();
            let found = solver.solve(LoadCase::MeanPressure(0.1 * pressure)).unwrap();
            ratios.push(cell(9) / found.area);
        }
        assert_eq!(ratios.len(), 4);
        let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
        assert!((mean - ratio).abs() < 0.01, "{hardness} {pressure}: {ratios:?}");
    }
}
