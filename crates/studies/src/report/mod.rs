//! `cargo xtask report`: speed and accuracy of the integrals, compared with other methods.
//!
//! Times and errors of every method on the same points, in one process and one run:
//! `speed-vs-error.csv`. Errors are reproducible and guarded by tests; times are not.

mod cases;
mod methods;
mod ours;
mod problem;
mod scipy;
mod tables;

use std::path::PathBuf;
use std::process::Command;

use anyhow::Result;
use scipy::Scipy;
use xtask::command::output;
use xtask::folder::{figures_folder, save};

/// Measures and writes; returns the paths written.
///
/// # Errors
/// A reference table or scipy that does not work, a case that is refused, a file that cannot be
/// written.
pub fn write() -> Result<Vec<PathBuf>> {
    let workshop = tempfile::tempdir()?;
    let scipy = Scipy::find(workshop.path())?;
    let speed = tables::write(&tables::pairs(), Some(&scipy))?;
    let text = format!("# measured on {}\n{speed}", this_machine());
    save(&figures_folder(), [("speed-vs-error.csv".to_owned(), text)])
}

/// One line: processor, cores, compiler, build, date.
fn this_machine() -> String {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let build = if cfg!(debug_assertions) { "development build" } else { "release build" };
    let about = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = about.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let name = name.map_or("unknown processor", |(_, name)| name.trim());
    let arch = std::env::consts::ARCH.replace('_', "-");
    let printed = |command: &str, argument: &str| {
        let printed = output(Command::new(command).arg(argument));
        printed.unwrap_or_else(|_| format!("unknown {command}"))
    };
    let (compiler, date) = (printed("rustc", "--version"), printed("date", "+%F"));
    let compiler = compiler.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    format!("{name} ({arch}), {cores} cores, {compiler}, {build}, {}", date.trim())
}

#[cfg(test)]
mod tests;
