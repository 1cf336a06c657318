//! `cargo xtask report`: how fast and how accurate the integrals are, beside what else there is.
//!
//! Times, errors and numbers of evaluations of every method on the same points, in one process and
//! one run: `speed-vs-error.{csv,svg,md}`; and where each method breaks: `hard-cases.{csv,svg}`.
//! Errors and counts are the same in every run and guarded by tests; times are not.

mod accuracy;
mod builds;
mod cases;
mod external;
mod hard;
mod laws;
mod machine;
mod markdown;
mod methods;
mod picture;
mod problem;
mod scope;
mod sheet;
mod speed;
pub mod throughput;
mod timing;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use indicatif::{ProgressBar, ProgressStyle};

pub use scope::Scope;

use laws::Laws;
use speed::Run;

/// Measures and writes; returns the paths written. The bar shows on a terminal only.
///
/// # Errors
/// A reference table or another library that does not work, a case that is refused, a file that
/// cannot be written.
pub fn write(scope: Scope, folder: &Path) -> Result<Vec<PathBuf>> {
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    let bar = ProgressBar::no_length();
    bar.set_style(ProgressStyle::with_template("{elapsed} {wide_bar} {pos}/{len} {msg}")?);
    bar.set_message("references");
    let laws = Laws::default();
    let cases = cases::read(&laws, &scope.models()?, scope.quantities())?;
    let workshop = external::Workshop::new()?;
    let libraries = external::find(&workshop)?;
    let tick = |what: &str| {
        bar.set_message(what.to_owned());
        bar.inc(1);
    };
    let run = Run { scope, laws: &laws, cases: &cases, tick: &tick };
    let pairs = run.pairs()?;
    let mut length = 0;
    for (model, _) in &pairs {
        let settings = |method| scope.settings(method, model).len();
        length += methods::all().iter().map(settings).sum::<usize>();
        length += 2 * scope.tolerances(model).len();
    }
    bar.set_length(length as u64);
    let mut rows = vec![];
    for (model, quantity) in &pairs {
        rows.extend(run.own(model, *quantity, true)?);
        rows.extend(run.builds(model, *quantity)?);
    }
    for library in &libraries {
        let found = run.external(library)?;
        rows.extend(found);
    }
    bar.set_message("throughput");
    let throughput = throughput::measure(scope)?;
    let speed = speed::csv(&rows)?;
    bar.set_message("hard cases");
    let hard = hard::csv(&laws, &cases, &libraries)?;
    bar.finish_and_clear();

    let machine = machine::description();
    let tables = [
        ("speed-vs-error.md", markdown::text(&speed, &throughput, &libraries, &machine)?),
        ("speed-vs-error.csv", speed.clone()),
        ("hard-cases.csv", hard.clone()),
    ];
    // Numbers first: they took long, and a picture may fail.
    let mut paths = save(folder, tables)?;
    paths.extend(save(folder, pictures(&speed, &hard, &machine)?)?);
    Ok(paths)
}

fn save<const N: usize>(folder: &Path, texts: [(&str, String); N]) -> Result<Vec<PathBuf>> {
    let save = |(name, text): (&str, String)| {
        let path = folder.join(name);
        fs::write(&path, text).with_context(|| path.display().to_string())?;
        Ok(path)
    };
    texts.into_iter().map(save).collect()
}

/// The pictures by name, from the texts of the two csv and the line that names the machine.
///
/// # Errors
/// A csv that is none of the report's.
pub fn pictures(speed: &str, hard: &str, machine: &str) -> Result<[(&'static str, String); 2]> {
    Ok([
        ("speed-vs-error.svg", picture::frontier(speed, machine)?),
        ("hard-cases.svg", picture::hard_cases(hard)?),
    ])
}

/// Whether two errors, or two numbers of evaluations, are the same as far as they do not hang on
/// rounding: small errors are made of it, and differ from compiler to compiler.
#[must_use]
pub fn errors_agree(a: f64, b: f64) -> bool {
    let (small, large) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    large <= 1.05 * small || large < 2e-14 || (large < 1e-10 && large <= 5.0 * small)
}

/// What does not depend on the machine, for tests: the csv of errors and evaluations without
/// times, and that of the hard cases, both without other libraries.
///
/// # Errors
/// A reference table that does not work, or a case that is refused.
pub fn accuracy(scope: Scope) -> Result<(String, String)> {
    let laws = Laws::default();
    let cases = cases::read(&laws, &scope.models()?, scope.quantities())?;
    let run = Run { scope, laws: &laws, cases: &cases, tick: &|_| {} };
    let mut rows = vec![];
    for (model, quantity) in run.pairs()? {
        rows.extend(run.own(&model, quantity, false)?);
    }
    Ok((speed::csv(&rows)?, hard::csv(&laws, &cases, &[])?))
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
