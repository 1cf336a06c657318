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
