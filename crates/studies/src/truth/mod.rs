//! `cargo xtask truth`: every model compared with boundary elements on reproducible surfaces.
//!
//! Random surfaces (`asperity::bem::RandomSurface`, seeds 1, 2, ...) are solved elastically and
//! with several hardnesses, and kept under target/truth. The results are in
//! `crates/answer/judge/data/truth.csv`, which `asperity::Evidence` reads; figures and tables
//! follow from that text alone.

pub mod family;
mod kept;
mod ordinary;
mod plan;
mod ranges;
mod rows;
pub mod scans;
mod solve;
pub mod world;

use std::path::PathBuf;

use anyhow::Result;
use asperity::Evidence;

use kept::Kept;
use plan::{FULL, SMALL, cases};
use rows::evidence;
use solve::solve;
use xtask::folder::{figures_folder, root, save, target_folder};

/// The folder of the committed evidence, in the crate that includes it.
const DATA: &str = "crates/answer/judge/data";

/// Solves the cases that are not kept, or none of them, and writes the evidence and its tables;
/// returns the paths. The table of ordinary scenes stays as it is where one is not kept.
///
/// # Errors
/// A case that cannot be solved, a file that cannot be written.
pub fn write(solve_missing: bool, anew: bool) -> Result<Vec<PathBuf>> {
    let mut kept = Kept::in_folder(&target_folder().join("truth"))?;
    if !anew {
        kept = kept.with_rows(&Evidence::with_models()?)?;
    }
    if solve_missing {
        solve(&[cases(FULL)?, ordinary::all()?].concat(), &kept)?;
    }
    let text = evidence(FULL, &kept)?;
    let evidence = Evidence::parse(&text)?;
    let tables = [
        ("", Some(ranges::table(&evidence))),
        ("-ordinary", ordinary::table(&evidence, &kept)?),
        ("-scans", Some(scans::table(&evidence, &scans::read()?)?)),
    ];
    let named = |(name, table): (&str, Option<String>)| Some((format!("truth{name}.md"), table?));
    let own = Evidence::COLUMNS.split(',').count();
    let part = |is_own: bool| -> String {
        let cells = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        cells.map(|row| if is_own { &row[..own] } else { &row[own..] }.join(",") + "\n").collect()
    };
    let files =
        [("truth.csv".to_owned(), part(true)), ("truth-models.csv".to_owned(), part(false))];
    let mut paths = save(&root().join(DATA), files)?;
    paths.extend(save(&figures_folder(), tables.into_iter().filter_map(named))?);
    Ok(paths)
}

/// Solves the small case for the tests; returns its path.
///
/// # Errors
/// The errors of [`write()`].
pub fn write_small() -> Result<Vec<PathBuf>> {
    save(&root().join("tests/reference"), [("truth_small.csv".to_owned(), small()?)])
}

/// The small case as csv, solved anew.
///
/// # Errors
/// The errors of [`write()`].
fn small() -> Result<String> {
    let folder = tempfile::tempdir()?;
    let kept = Kept::in_folder(folder.path())?;
    solve(&cases(SMALL)?, &kept)?;
    evidence(SMALL, &kept)
}

/// The rows of a full table with the models evaluated anew and its boundary elements unchanged.
///
/// # Errors
/// A model that fails.
#[cfg(test)]
fn with_new_models(table: &Evidence) -> Result<String> {
    evidence(FULL, &Kept::default().with_rows(table)?)
}

#[cfg(test)]
mod tests;
