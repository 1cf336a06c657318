//! A small case of the truth report, solved again: what is committed of the large one comes of the
//! same program.

use xtask::table::agree;
use xtask::truth::{FULL, SMALL, asked_anew, models, solve};

#[test]
fn a_small_case_is_found_again() {
    let known = include_str!("../reference/truth_small.csv");
    let found = solve(&SMALL).unwrap();
    // The solver stops at 1e-8 or so, and stiffnesses are differences of gaps that are 5 % apart.
    assert!(agree(&found, known, 1e-4), "{found}");
    let (all, whole) = (models().len(), 2);
    // At each of two loads: elastic bem, gw, gw-random and the whole surface; with a hardness all.
    assert_eq!(known.lines().count(), 1 + 2 * (3 + whole + 1 + all));
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

/// What is committed is what the models say today: of one surface of each breadth, on one material.
#[test]
fn models_say_what_is_committed() {
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

/// One home of what was solved: the README says it as the evidence does.
#[test]
fn the_readme_says_what_was_solved() {
    let evidence = asperity::Evidence::committed().unwrap();
    let mut alpha: Vec<String> =
        evidence.cases().iter().map(|case| format!("{:.1}", case.alpha)).collect();
    alpha.dedup();
    let readme = include_str!("../../README.md");
    let said = format!("α = m₀m₄/m₂² of {}, {} and {}", alpha[0], alpha[1], alpha[2]);
    assert!(readme.contains(&said), "{said}");
}
