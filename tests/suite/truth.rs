//! A small case of the truth report is solved again by the program that made the committed table.

use xtask::table::agree;
use xtask::truth::{FULL, SMALL, asked_anew, models, solve};

#[test]
fn a_small_case_is_reproduced() {
    let known = include_str!("../reference/truth_small.csv");
    let found = solve(&SMALL).unwrap();
    // The solver stops at about 1e-8, and stiffnesses are differences of gaps 5 % apart.
    assert!(agree(&found, known, 1e-4), "{found}");
    let (all, whole) = (models().len(), 2);
    // At each of two loads: elastic bem, gw, gw-random and the whole surface; with a hardness all.
    assert_eq!(known.lines().count(), 1 + 2 * (3 + whole + 1 + all));
}

/// The README shows some rows of the table, unchanged.
#[test]
fn the_readme_shows_rows_of_the_table() {
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

/// One surface of each bandwidth with one material.
#[test]
fn models_agree_with_the_committed_table() {
    let known = asperity::Evidence::CSV;
    let mut lines = known.lines();
    let head = lines.next().unwrap();
    let mut cases: Vec<(&str, &str)> = vec![];
    let some: Vec<&str> = lines
        .filter(|line| {
            let mut fields = line.split(',');
            let case = (fields.next().unwrap(), fields.next().unwrap());
            if !cases.contains(&case) {
                cases.push(case);
            }
            // Elastic and psi 1, 2, 4 of three surfaces: another material of each.
            let index = cases.iter().position(|known| *known == case).unwrap();
            [0, 6, 11].contains(&index)
        })
        .collect();
    let text = [&[head], &some[..]].concat().join("\n") + "\n";
    assert_eq!(cases.len(), 12);
    let found = asked_anew(&text, &FULL).unwrap();
    assert!(agree(&found, &text, 1e-6), "{found}");
}

#[test]
fn the_readme_lists_the_solved_surfaces() {
    let evidence = asperity::Evidence::committed().unwrap();
    let mut alpha: Vec<String> =
        evidence.cases().iter().map(|case| format!("{:.1}", case.alpha)).collect();
    alpha.dedup();
    let readme = include_str!("../../README.md");
    let listed = format!("α = m₀m₄/m₂² of {}, {} and {}", alpha[0], alpha[1], alpha[2]);
    assert!(readme.contains(&listed), "{listed}");
}
