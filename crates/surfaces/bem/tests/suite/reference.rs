//! tests/reference/bem_dense.csv: dense linear systems and an active set, without Fourier
//! transforms, on surfaces made from the documentation.

use std::collections::HashMap;

use asperity_bem::{Boundary, BoundaryElements, HeightMap, LoadCase, RandomSurface};

use crate::{MODULUS, close};

const TABLE: &str = include_str!("../../../../../tests/reference/bem_dense.csv");

#[test]
fn every_row_of_the_dense_solver() {
    let mut lines = TABLE.lines();
    let head: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut rows = 0;
    for line in lines {
        let row: HashMap<&str, &str> = head.iter().copied().zip(line.split(',')).collect();
        let number = |key: &str| row[key].parse::<f64>().unwrap();
        let count = |key: &str| row[key].parse::<usize>().unwrap();
        let surface = RandomSurface::new(2.0, 4.0, 8.0).unwrap().gradient(0.1).unwrap();
        let whole =
            surface.side(1e-4).unwrap().seed(number("seed") as u64).heights(count("n")).unwrap();
        let (n, columns) = (count("n"), count("columns"));
        let cut = whole.heights().chunks(n).take(count("rows")).flat_map(|row| &row[..columns]);
        let pixel = [number("dy"), whole.pixel()[1]];
        let map = HeightMap::new(cut.copied().collect(), [count("rows"), columns], pixel).unwrap();
        let boundary = if row["boundary"] == "free" { Boundary::Free } else { Boundary::Periodic };
        let mut solver = BoundaryElements::new(map, MODULUS).unwrap().boundary(boundary);
        solver = solver.tolerance(1e-10).unwrap();
        if !row["hardness"].is_empty() {
            solver = solver.hardness(number("hardness")).unwrap();
        }
        let found = solver.solve(LoadCase::MeanPressure(number("pressure"))).unwrap();
        let pixels = count("rows") * columns;
        let counted = |share: f64| (share * pixels as f64).round() as usize;
        assert_eq!(counted(found.pixel_area), count("pixels"), "{line}");
        assert_eq!(counted(found.plastic_area), count("plastic"), "{line}");
        assert_eq!(found.edges, count("edges"), "{line}");
        close(found.mean_gap, number("mean_gap"), 1e-9);
        close(found.gap_volume, number("gap_volume"), 1e-8);
        let highest = found.pressures.iter().copied().fold(0.0, f64::max);
        close(highest, number("highest_pressure"), 1e-6);
        let square = found.pressures.iter().map(|p| p * p).sum::<f64>() / pixels as f64;
        close(square, number("pressure_square"), 1e-7);
        close(found.mean_pressure, number("pressure"), 1e-12);
        let held = solver.fixed_contact(&found).unwrap();
        close(held.stiffness, number("fixed_stiffness"), 1e-9);
        rows += 1;
    }
    assert_eq!(rows, 36);
}
