//! Periodic maps with steps: contacts of ContactMechanics in tests/reference/bem_steps.csv, and the
//! same contacts wherever the map begins.

use asperity_bem::{Bem, Continuation, HeightMap, LoadCase, Solution};
use asperity_core::Interface;

use crate::options;

const STEPS: &str = include_str!("../../../../../tests/reference/bem_steps.csv");
const N: usize = 64;

/// The map of a line of heights, begun at a column.
fn map(line: &[f64], first: usize) -> HeightMap {
    let row = (0..N).map(|j| line[(j + first) % N]);
    let heights = (0..N).flat_map(|_| row.clone()).collect();
    HeightMap::new(heights, [N, N], [1.0 / N as f64; 2]).unwrap()
}

fn solve(map: HeightMap, modulus: f64, pressure: f64, tolerance: f64) -> Solution {
    let bem = Bem::new(map, options(Some(Continuation::Periodic), true));
    let elements = bem.elements(&Interface::elastic(modulus, 0.3)).unwrap();
    elements.tolerance(tolerance).unwrap().solve(LoadCase::MeanPressure(pressure)).unwrap()
}

#[test]
fn steps_are_pressed_as_by_contact_mechanics_wherever_the_map_begins() {
    let mut shapes = 0;
    for row in STEPS.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |k: usize| cells[k].parse::<f64>().unwrap();
        let [modulus, height, pressure] = [2, 3, 4].map(number);
        let at = |j: usize| match cells[0] {
            "saw-tooth" => height * j as f64 / N as f64,
            "square" => height * f64::from(j < N / 2),
            shape => panic!("{shape}"),
        };
        let line: Vec<f64> = (0..N).map(at).collect();
        let largest = |solution: &Solution| solution.pressures.iter().copied().fold(0.0, f64::max);
        let found = solve(map(&line, 0), modulus, pressure, 1e-13);
        assert!((found.pixel_area - number(5)).abs() < 1e-15, "{row}: {}", found.pixel_area);
        // Its tolerance is 1e-10 of the rms height.
        assert!((largest(&found) / number(6) - 1.0).abs() < 1e-6, "{row}: {:e}", largest(&found));
        // Saw-teeth begin at any column, also with the step inside.
        for first in [1, 16, 23, 32, 48] {
            let shifted = solve(map(&line, first), modulus, pressure, 1e-13);
            assert!((shifted.pixel_area - found.pixel_area).abs() < 1e-15, "{row} from {first}");
            assert!((shifted.area / found.area - 1.0).abs() < 1e-10, "{row} from {first}");
            assert!((largest(&shifted) / largest(&found) - 1.0).abs() < 1e-10, "{row} {first}");
            assert!((shifted.mean_gap / found.mean_gap - 1.0).abs() < 1e-10, "{row} from {first}");
        }
        shapes += 1;
    }
    assert_eq!(shapes, 2);
}
