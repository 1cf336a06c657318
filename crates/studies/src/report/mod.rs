//! `cargo xtask report`: speed and accuracy of the integrals, compared with other methods.
//!
//! Times, errors and numbers of evaluations of every method on the same points, in one process and
//! one run: `speed-vs-error.{csv,md}`. Errors and counts are reproducible and guarded by tests; times
//! are not.

mod cases;
mod external;
mod markdown;
mod methods;
mod ours;
mod problem;
mod tables;

use std::path::PathBuf;

use anyhow::Result;

use xtask::folder::{figures_folder, save};

/// Measures and writes; returns the paths written.
///
/// # Errors
/// A reference table or another library that does not work, a case that is refused, a file that
/// cannot be written.
pub fn write() -> Result<Vec<PathBuf>> {
    let machine = markdown::this_machine();
    let workshop = tempfile::tempdir()?;
    let libraries = external::find(workshop.path())?;
    let speed = tables::write(&tables::pairs(), true, &libraries)?;
    let text = markdown::text(&speed, &libraries, &machine)?;
    let tables = [("speed-vs-error.md", text), ("speed-vs-error.csv", speed)].map(|(name, text)| (name.to_owned(), text));
    save(&figures_folder(), tables)
}

#[cfg(test)]
mod tests;
