//! `cargo xtask report`: speed and accuracy of the integrals, compared with other methods.
//!
//! Times, errors and numbers of evaluations of every method on the same points, in one process and
//! one run: `speed-vs-error.{csv,svg,md}`; and the failures of each method: `hard-cases.{csv,svg}`.
//! Errors and counts are reproducible and guarded by tests; times are not.

mod cases;
mod external;
mod machine;
mod markdown;
mod methods;
mod ours;
mod outcome;
mod points;
mod problem;
mod scope;
mod tables;
pub mod throughput;

use std::path::{Path, PathBuf};

use anyhow::Result;

pub use scope::Scope;

use crate::figures::measured::pictures;
use crate::folder::{figures_folder, read, root, save as save_all, write as save};

/// Measures and writes; returns the paths written.
///
/// # Errors
/// A reference table or another library that does not work, a case that is refused, a file that
/// cannot be written.
pub fn write(scope: Scope, folder: &Path) -> Result<Vec<PathBuf>> {
    let workshop = tempfile::tempdir()?;
    let libraries = external::find(workshop.path())?;
    let (speed, hard) = tables::write(scope, true, &libraries)?;
    let throughput = throughput::measure(scope)?;
    let text = markdown::text(&speed, &throughput, &libraries, &machine::description())?;
    // Numbers first, because they take long and a picture can fail.
    let mut paths = vec![];
    if folder == figures_folder() {
        let path = root().join("README.md");
        save(&path, markdown::readme(&read(&path)?, &speed)?)?;
        paths.push(path);
    }
    let tables =
        [("speed-vs-error.md", text), ("speed-vs-error.csv", speed), ("hard-cases.csv", hard)];
    paths.extend(save_all(folder, tables.map(|(name, text)| (name.to_owned(), text)))?);
    paths.extend(save_all(folder, pictures(folder)?)?);
    Ok(paths)
}

/// Whether two errors, or two numbers of evaluations, are the same up to rounding, which dominates
/// small errors and differs between compilers.
#[must_use]
pub fn errors_agree(a: f64, b: f64) -> bool {
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    large <= 1.05 * small || large < 2e-14 || (large < 1e-10 && large <= 5.0 * small)
}

/// The machine-independent results, for tests: errors and evaluations without times, and the hard
/// cases, both without other libraries.
///
/// # Errors
/// A reference table that does not work, or a case that is refused.
pub fn accuracy(scope: Scope) -> Result<(String, String)> {
    tables::write(scope, false, &[])
}

#[cfg(test)]
mod tests {
    use super::errors_agree;

    #[test]
    fn rounding_passes_and_a_lost_digit_does_not() {
        for (a, b, same) in [
            (1.0, 1.04, true),
            (1.0, 1.2, false),
            (2e-6, 2e-5, false),
            (1e-12, 4e-12, true),
            (1e-12, 9e-12, false),
            (0.0, 1e-14, true),
            (0.0, 1e-12, false),
        ] {
            assert!(errors_agree(a, b) == same && errors_agree(b, a) == same, "{a} {b}");
        }
    }
}
