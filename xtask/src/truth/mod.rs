//! `cargo xtask truth`: every model compared with boundary elements on reproducible surfaces.
//!
//! Random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are solved elastically and
//! with several hardnesses, and kept under target/truth. The results are in
//! `crates/asperity/data/truth.csv`, which `asperity::Evidence` reads; the figures and the table of
//! the README follow from that text alone.

pub mod family;
pub mod feeding;
pub mod kept;
pub mod ordinary;
pub mod plan;
mod rows;
mod solve;
mod unseen;
pub mod yielded;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use asperity::Evidence;

pub use plan::{FULL, QUICK, SMALL, Scope};
pub use rows::evidence;

use crate::figures::truth::{Shown, style, table};
use crate::figures::truth_ranges::table as markdown;
use crate::folder::{figures_folder, save};
use kept::Kept;
use solve::solve;

/// The committed evidence, in the crate that includes it.
#[must_use]
pub fn evidence_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("crates/asperity/data/truth.csv")
}

/// The folder of solved cases.
#[must_use]
pub fn kept_folder() -> PathBuf {
    figures_folder().with_file_name("target").join("truth")
}

/// Solves the cases that are not kept, or none of them, and writes the evidence and its figures;
/// returns the paths.
///
/// # Errors
/// A case that cannot be solved, a file that cannot be written.
pub fn write(figures: &Path, solve_missing: bool, anew: bool) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let mut kept = Kept::in_folder(&kept_folder())?;
    if !anew {
        kept = kept.with_rows(&Evidence::parse(&committed()?)?)?;
    }
    if solve_missing {
        solve(&FULL, &kept)?;
    }
    let mut paths = save(folder, [("truth.csv".to_owned(), evidence(&FULL, &kept)?)])?;
    paths.extend(draw(figures, solve_missing)?);
    Ok(paths)
}

/// Solves a sketch in two minutes and writes its evidence and table to target/truth-quick.
///
/// # Errors
/// Those of [`write()`].
pub fn write_quick() -> Result<Vec<PathBuf>> {
    let folder = kept_folder().with_file_name("truth-quick");
    let kept = Kept::in_folder(&folder.join("kept"))?;
    solve(&QUICK, &kept)?;
    let text = evidence(&QUICK, &kept)?;
    let table = markdown(&text)?;
    save(&folder, [("truth.csv".to_owned(), text), ("truth.md".to_owned(), table)])
}

/// Solves the small case for the tests; returns its path.
///
/// # Errors
/// Those of [`write()`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    let folder = figures_folder().with_file_name("tests").join("reference");
    save(&folder, [("truth_small.csv".to_owned(), small()?)])
}

/// The small case as csv, solved anew.
///
/// # Errors
/// Those of [`write()`].
pub fn small() -> Result<String> {
    let folder = tempfile::tempdir()?;
    let kept = Kept::in_folder(folder.path())?;
    solve(&SMALL, &kept)?;
    evidence(&SMALL, &kept)
}

/// Evaluates the models of the committed evidence anew, keeps its boundary elements, and draws it.
///
/// # Errors
/// Evidence that is missing or cannot be read.
pub fn update_models(figures: &Path) -> Result<Vec<PathBuf>> {
    let path = evidence_file();
    let folder = path.parent().context("a folder")?;
    let text = with_new_models(&committed()?)?;
    let mut paths = save(folder, [("truth.csv".to_owned(), text)])?;
    paths.extend(draw(figures, false)?);
    Ok(paths)
}

/// The rows of a full table with the models evaluated anew and its boundary elements unchanged.
///
/// # Errors
/// A text that is not evidence, a model that fails.
pub fn with_new_models(text: &str) -> Result<String> {
    evidence(&FULL, &Kept::default().with_rows(&Evidence::parse(text)?)?)
}

fn committed() -> Result<String> {
    let path = evidence_file();
    std::fs::read_to_string(&path).with_context(|| path.display().to_string())
}

/// Draws the committed evidence. The table of ordinary scenes stays as it is if their solutions are
/// not kept and none may be solved.
fn draw(figures: &Path, solve_missing: bool) -> Result<Vec<PathBuf>> {
    let text = committed()?;
    let mut drawn = vec![("truth.md".to_owned(), markdown(&text)?)];
    for shown in Shown::ALL {
        let csv = table(&text, shown)?.into_text();
        let svg = asperity_plot::draw(&style(&csv, shown)?, &csv)?;
        drawn.extend([
            (format!("{}.csv", shown.name()), csv),
            (format!("{}.svg", shown.name()), svg),
        ]);
    }
    let ordinary = ordinary::table(&text, &kept_folder().join("ordinary"), solve_missing)?;
    drawn.extend([
        ("truth-shapes.md".to_owned(), feeding::table(&text)?),
        ("truth-yielded.md".to_owned(), yielded::table(&text)?),
    ]);
    drawn.extend(ordinary.map(|table| ("truth-ordinary.md".to_owned(), table)));
    let unseen = unseen::table(&text, &kept_folder().join("unseen"), solve_missing)?;
    drawn.extend(unseen.map(|table| ("truth-unseen.md".to_owned(), table)));
    save(figures, drawn)
}

#[cfg(test)]
mod tests {
    use super::family::{FAMILIES, scene};
    use super::*;

    #[test]
    fn surfaces_and_materials_have_the_moments_of_the_evidence() -> Result<()> {
        // Sums of C q² and C q⁴ over the waves of each spectrum, computed by another program: the
        // evidence was made by the functions under test.
        for (family, alpha) in FAMILIES.iter().zip([7.5, 3.0, 29.0, 77.0]) {
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
