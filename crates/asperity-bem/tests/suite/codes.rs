//! Other people's codes: tests/reference/bem_codes.csv, on surfaces that anybody can make, and
//! tests/reference/bem.csv, on two that are not in the repository.

use std::collections::HashMap;
use std::fs::File;

use asperity_bem::{BoundaryElements, HeightMap, LoadCase, RandomSurface, Solution};

use crate::{MODULUS, UNIT, close};

const CODES: &str = include_str!("../../../../tests/reference/bem_codes.csv");
const STUDY: &str = include_str!("../../../../tests/reference/bem.csv");
const STIFFNESS: &str = include_str!("../../../../tests/reference/bem_stiffness.csv");

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
/// the edges of yielded contacts as those of elastic ones.
fn area(row: &Row<'_>, keys: [&str; 3]) -> f64 {
    let [area, pressure, hardness] = keys;
    let least =
        if row[hardness].is_empty() { 0.0 } else { number(row, pressure) / number(row, hardness) };
    number(row, area).max(least)
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
        let area = area(row, ["area", "pressure", "hardness"]);
        compare(&found, row, area, pixels, plastic, number(row, "mean_gap"));
    }
}

/// A row of the study, on a surface of the side 1 and a half-space of the modulus 1.
fn of_study(folder: &str, row: &Row<'_>) -> (BoundaryElements, Solution) {
    let n = row["n"].parse::<usize>().unwrap();
    let file = File::open(format!("{folder}/{}_{n}.npy", row["surface_id"])).unwrap();
    let heights = npyz::NpyFile::new(std::io::BufReader::new(file)).unwrap().into_vec();
    let map = HeightMap::new(heights.unwrap(), [n, n], [1.0 / n as f64; 2]).unwrap();
    let mut solver = BoundaryElements::new(map, 1.0).unwrap();
    if !row["H_over_E"].is_empty() {
        solver = solver.hardness(number(row, "H_over_E")).unwrap();
    }
    let found = solver.solve(LoadCase::MeanPressure(number(row, "p_over_E"))).unwrap();
    (solver, found)
}

/// `ASPERITY_BEM_SURFACES=folder cargo test -p asperity-bem -- --ignored`
#[test]
#[ignore = "its two surfaces, syn_a8_512.npy and m3_lp8_256.npy, are not ours to distribute"]
fn every_row_of_the_study() {
    let folder = std::env::var("ASPERITY_BEM_SURFACES").unwrap();
    let rows = rows(STUDY);
    assert_eq!(rows.len(), 50);
    for row in &rows {
        let (_, found) = of_study(&folder, row);
        let pixels = counted(number(row, "area_pix"), found.gaps.len());
        let plastic = number(row, "plastic_area");
        let area = area(row, ["area_corr", "p_over_E", "H_over_E"]);
        compare(&found, row, area, pixels, plastic, number(row, "mean_gap"));
    }
}

/// Stiffness at fixed contact by another program, elastic and yielded; run as the test above.
#[test]
#[ignore = "its two surfaces, syn_a8_512.npy and m3_lp8_256.npy, are not ours to distribute"]
fn every_stiffness_of_the_study() {
    let folder = std::env::var("ASPERITY_BEM_SURFACES").unwrap();
    let rows = rows(STIFFNESS);
    assert_eq!(rows.len(), 30);
    for row in &rows {
        let (solver, solution) = of_study(&folder, row);
        let found = solver.fixed_contact(&solution).unwrap().stiffness;
        close(found, number(row, "fixed_contact_stiffness"), 1e-6);
    }
}
