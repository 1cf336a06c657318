//! Other people's codes on surfaces that anybody can make: tests/reference/bem_codes.csv.

use std::collections::HashMap;

use asperity_bem::{BoundaryElements, LoadCase, RandomSurface, Solution};

use crate::{MODULUS, UNIT, close};

const CODES: &str = include_str!("../../../../../tests/reference/bem_codes.csv");

type Row<'a> = HashMap<&'a str, &'a str>;

fn rows(table: &str) -> Vec<Row<'_>> {
    let mut lines = table.lines().map(|line| line.split(','));
    let head = lines.next().unwrap();
    lines.map(|line| head.clone().zip(line).collect()).collect()
}

fn number(row: &Row<'_>, key: &str) -> f64 {
    row[key].parse().unwrap_or_else(|_| panic!("{key} of {row:?}"))
}

/// The area of a row, with a hardness at least that which carries its load: other programs correct
/// the edges of yielded contacts as of elastic ones.
fn area(row: &Row<'_>) -> f64 {
    let yields = !row["hardness"].is_empty();
    let least = if yields { number(row, "pressure") / number(row, "hardness") } else { 0.0 };
    number(row, "area").max(least)
}

fn counted(share: f64, pixels: usize) -> i64 {
    (share * pixels as f64).round() as i64
}

/// Elastic contacts are the same pixels. ContactMechanics' hardness ends at other tolerances:
/// its contacts are near.
fn compare(found: &Solution, row: &Row<'_>, area: f64, pixels: i64, plastic: f64, gap: f64) {
    let elastic = found.plastic_area <= 0.0 && plastic <= 0.0;
    if elastic {
        assert_eq!(counted(found.pixel_area, found.gaps.len()), pixels, "{row:?}");
    }
    let [area_error, gap_error] = if elastic { [1e-9, 1e-6] } else { [3e-3, 2e-3] };
    close(found.area, area, area_error);
    close(found.mean_gap, gap, gap_error);
    close(found.plastic_area, plastic, 0.01);
}

#[test]
fn contacts_are_those_of_tamaas_and_contact_mechanics() {
    let rows = rows(CODES);
    assert_eq!(rows.len(), 24);
    for row in &rows {
        let n = number(row, "n") as usize;
        let surface = RandomSurface::new(2.0, 4.0, number(row, "shortest")).unwrap();
        let surface = surface.gradient(UNIT / MODULUS).unwrap().side(1e-4).unwrap();
        let map = surface.seed(number(row, "seed") as u64).heights(n).unwrap();
        let mut solver = BoundaryElements::new(map, MODULUS).unwrap();
        if !row["hardness"].is_empty() {
            solver = solver.hardness(number(row, "hardness")).unwrap();
        }
        let found = solver.solve(LoadCase::MeanPressure(number(row, "pressure"))).unwrap();
        let pixels = number(row, "pixels") as i64;
        let plastic = number(row, "plastic") / (n * n) as f64;
        compare(&found, row, area(row), pixels, plastic, number(row, "mean_gap"));
    }
}
