//! Programs that tasks run.

use std::process::Command;

use anyhow::{Context, Result, ensure};

/// Cargo, the one that runs this program.
#[must_use]
pub fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Runs a command that must succeed.
///
/// # Errors
/// A program that is missing or fails.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?}"))?;
    ensure!(status.success(), "{command:?} failed: {status}");
    Ok(())
}

/// Runs a command that must succeed, and returns its standard output.
///
/// # Errors
/// A program that is missing or fails, an output that is no text.
pub fn output(command: &mut Command) -> Result<String> {
    let output = command.output().with_context(|| format!("{command:?}"))?;
    let messages = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{command:?} failed: {}\n{messages}", output.status);
    Ok(String::from_utf8(output.stdout)?)
}
