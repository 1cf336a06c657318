//! `cargo xtask truth`: every model compared with boundary elements on reproducible surfaces.
//!
//! Random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are solved elastically and
//! with several hardnesses, and kept under target/truth. The results are in
//! `crates/asperity/data/truth.csv`, which `asperity::Evidence` reads; the figures and the table of
//! the README follow from that text alone.

mod family;
mod feeding;
mod kept;
mod ordinary;
mod plan;
mod rows;
pub mod scans;
mod solve;
pub mod world;
mod yielded;

use std::path::{Path, PathBuf};

use anyhow::Result;
use asperity::Evidence;

use crate::figures::captions::with_caption;
use crate::figures::truth::{SHOWN, style, table};
use crate::figures::truth_ranges::table as ranges;
use crate::folder::{figures_folder, root, save, target_folder};
use kept::Kept;
use plan::{FULL, QUICK, SMALL, Scope};
use rows::evidence;
use solve::solve;

/// The folder of the committed evidence, in the crate that includes it.
const DATA: &str = "crates/asperity/data";

/// Solves the cases that are not kept, or none of them, and writes the evidence and its figures;
/// returns the paths.
///
/// # Errors
/// A case that cannot be solved, a file that cannot be written.
pub fn write(solve_missing: bool, anew: bool) -> Result<Vec<PathBuf>> {
    let mut kept = Kept::in_folder(&target_folder().join("truth"))?;
    if !anew {
        kept = kept.with_rows(Evidence::committed()?)?;
    }
    if solve_missing {
        solve(FULL, &kept)?;
    }
    draw(evidence(FULL, &kept)?, solve_missing)
}

/// Solves a sketch in two minutes and writes its evidence and table to target/truth-quick.
///
/// # Errors
/// Those of [`write()`].
pub fn write_quick() -> Result<Vec<PathBuf>> {
    let folder = target_folder().join("truth-quick");
    let text = solved(QUICK, &folder.join("kept"))?;
    let table = ranges(&Evidence::parse(&text)?);
    save(&folder, [("truth.csv".to_owned(), text), ("truth.md".to_owned(), table)])
}

/// Solves the small case for the tests; returns its path.
///
/// # Errors
/// Those of [`write()`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    save(&root().join("tests/reference"), [("truth_small.csv".to_owned(), small()?)])
}

/// The small case as csv, solved anew.
///
/// # Errors
/// Those of [`write()`].
pub fn small() -> Result<String> {
    solved(SMALL, tempfile::tempdir()?.path())
}

fn solved(scope: Scope, folder: &Path) -> Result<String> {
    let kept = Kept::in_folder(folder)?;
    solve(scope, &kept)?;
    evidence(scope, &kept)
}

/// Evaluates the models of the committed evidence anew, keeps its boundary elements, and draws it.
///
/// # Errors
/// A model that fails, a file that cannot be written.
pub fn update_models() -> Result<Vec<PathBuf>> {
    draw(with_new_models(Evidence::committed()?)?, false)
}

/// The rows of a full table with the models evaluated anew and its boundary elements unchanged.
///
/// # Errors
/// A model that fails.
pub fn with_new_models(table: &Evidence) -> Result<String> {
    evidence(FULL, &Kept::default().with_rows(table)?)
}

/// Writes evidence and draws it. The table of ordinary scenes stays as it is if its solutions are
/// not kept and none may be solved.
fn draw(text: String, solve_missing: bool) -> Result<Vec<PathBuf>> {
    let evidence = Evidence::parse(&text)?;
    let mut paths = save(&root().join(DATA), [("truth.csv".to_owned(), text)])?;
    let kept = |name: &str| target_folder().join("truth").join(name);
    let mut drawn = vec![("truth.md".to_owned(), ranges(&evidence))];
    for shown in &SHOWN {
        let (name, csv) = (shown.0, table(&evidence, shown)?.into_text());
        let svg = asperity_plot::draw(&with_caption(name, style(&csv, shown)?)?, &csv)?;
        drawn.extend([(format!("{name}.csv"), csv), (format!("{name}.svg"), svg)]);
    }
    for (name, table) in [
        ("ordinary", ordinary::table(&evidence, &kept("ordinary"), solve_missing)?),
        ("shapes", Some(feeding::table(&evidence)?)),
        ("yielded", Some(yielded::table(&evidence)?)),
        ("scans", Some(scans::table(&evidence, &scans::read()?)?)),
    ] {
        drawn.extend(table.map(|table| (format!("truth-{name}.md"), table)));
    }
    paths.extend(save(&figures_folder(), drawn)?);
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::family::{FAMILIES, scene};
    use super::*;

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
}
