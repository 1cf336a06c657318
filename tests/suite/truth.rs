//! A small case of the truth report, solved again: what is committed of the large one comes of the same
//! program.

use xtask::table::agree;
use xtask::truth::{SMALL, solve};

#[test]
fn a_small_case_is_found_again() {
    let known = include_str!("../reference/truth_small.csv");
    let found = solve(&SMALL).unwrap();
    // The solver stops at 1e-8 or so, and stiffnesses are differences of gaps that are 5 % apart.
    assert!(agree(&found, known, 1e-4), "{found}");
    assert_eq!(known.lines().count(), 1 + 2 * (5 + 23));
}

/// The README shows some rows of the table, as they are.
#[test]
fn the_readme_shows_what_was_found() {
    let table = include_str!("../../figures/truth.md");
    let readme = include_str!("../../README.md");
    let (_, shown) = readme.split_once("| area, % off |").unwrap();
    let rows: Vec<&str> = shown.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    assert!(rows.len() >= 12, "{rows:?}");
    let (areas, _) = table.split_once("| stiffness").unwrap();
    for row in rows {
        assert!(areas.contains(row), "{row}");
    }
}
