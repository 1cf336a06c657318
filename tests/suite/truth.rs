//! A small case of the truth report is solved again by the program that made the committed table.

use xtask::figures::truth_ranges::models;
use xtask::table::agree_by;
use xtask::truth::{small, with_new_models};

use crate::is_long;

/// Numbers of models are thousandths, those of boundary elements have four digits and their errors
/// two, of which the last may differ; solutions stop at 1e-6 of Sq, and stiffnesses are differences
/// of gaps 5 % apart. Whole numbers from `rounded` on may have been rounded to a neighbour.
fn agree(found: &str, known: &str, rounded: f64) -> bool {
    let whole = |x: f64| x.fract() == 0.0 && x.abs() >= rounded;
    agree_by(found, known, |a, b| {
        let two = |x: f64| format!("{x:.1e}").parse().is_ok_and(|y: f64| y.total_cmp(&x).is_eq());
        let step = if whole(a) && whole(b) {
            1.0
        } else if two(a) && two(b) {
            0.11 * 10f64.powf(a.abs().log10().floor())
        } else {
            0.0
        };
        (a - b).abs() <= step + 2e-3 * a.abs().max(b.abs())
    })
}

#[test]
fn a_small_case_is_reproduced() {
    let known = include_str!("../reference/truth_small.csv");
    let found = small().unwrap();
    // Counts of surfaces are below 100.
    assert!(agree(&found, known, 100.0), "{found}");
    // Elastic and psi 2 at three loads.
    assert_eq!(known.lines().count(), 1 + 2 * 3);
    assert_eq!(known.lines().next().unwrap().split(',').count(), 16 + 4 * models().len());
}

/// Every 29th case, or every 116th.
#[test]
fn models_agree_with_the_committed_table() {
    let known = asperity::Evidence::CSV;
    let mut lines = known.lines();
    let head = lines.next().unwrap();
    let some: Vec<&str> = lines.step_by(if is_long() { 29 } else { 116 }).collect();
    let text = [&[head], &some[..]].concat().join("\n") + "\n";
    let found = with_new_models(&asperity::Evidence::parse(&text).unwrap()).unwrap();
    // The counts are those of the table.
    assert!(agree(&found, &text, 0.0), "{found}");
}

#[test]
fn the_guide_lists_the_solved_surfaces() {
    let evidence = asperity::Evidence::committed().unwrap();
    let plain = evidence.cases().iter().filter(|c| c.skewness == 0.0 && c.slope_ratio <= 1.0);
    let mut alpha: Vec<f64> = plain.map(|case| case.alpha).collect();
    alpha.sort_by(f64::total_cmp);
    alpha.dedup();
    let guide = include_str!("../../crates/asperity-web/guide/which-model.md");
    let alpha: Vec<String> = alpha.iter().map(|alpha| format!("{alpha:.1}")).collect();
    let listed = format!("| α | bandwidth m₀m₄/m₂² of the heights | {} |", alpha.join(", "));
    assert!(guide.contains(&listed), "{listed}");
}
