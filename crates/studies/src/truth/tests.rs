//! A small case of the truth report is solved again by the program that made the committed table.

use xtask::figures::compared::models;
use xtask::folder::read;
use xtask::table::agree_by;

use super::family::{FAMILIES, scene};
use super::*;

/// Numbers of models are thousandths, boundary elements have four digits and their errors
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
    let known = include_str!("../../../../tests/reference/truth_small.csv");
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
    let mut lines = asperity::Evidence::lines_with_models();
    let head = lines.next().unwrap();
    let some = lines.step_by(if std::env::var_os("ASPERITY_LONG").is_some() { 29 } else { 116 });
    let text = [head].into_iter().chain(some).collect::<Vec<_>>().join("\n") + "\n";
    let found = with_new_models(&asperity::Evidence::parse(&text).unwrap()).unwrap();
    // The table has these counts.
    assert!(agree(&found, &text, 0.0), "{found}");
    // Numbers of boundary elements are written again as they were read.
    let bem = |text: &str| -> Vec<Vec<String>> {
        text.lines().map(|line| line.split(',').take(16).map(str::to_owned).collect()).collect()
    };
    assert_eq!(bem(&found), bem(&text));
}

#[test]
fn the_table_of_ranges_is_that_of_the_committed_evidence() -> Result<()> {
    let committed = read(&figures_folder().join("truth.md"))?;
    assert_eq!(ranges::table(&Evidence::with_models()?), committed);
    Ok(())
}

#[test]
fn surfaces_and_materials_have_the_moments_of_the_evidence() -> Result<()> {
    // Sums of C q² and C q⁴ over the waves of each spectrum, computed by another program: the
    // evidence was made by the functions under test.
    for (family, alpha) in FAMILIES.iter().zip([7.5, 3.0, 29.0, 77.0, 135.0]) {
        for pixels in [family.pixels, 1024] {
            let found = family.surface(pixels)?.moments().bandwidth();
            assert!((found / alpha - 1.0).abs() < 0.1, "{} {found}", family.name);
        }
    }
    for index in [0.7, 2.0, 8.0] {
        let found = scene(&FAMILIES[0].surface(512)?, index)?.plasticity_index()?;
        assert!((found / index - 1.0).abs() < 1e-12, "{found}");
    }
    Ok(())
}
