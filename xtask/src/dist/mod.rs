//! Files to install: the Python wheel, the program as an archive, the page as a zip, checksums.
//!
//! Every file is tried where it will be used: without cargo on the path.

mod archive;
pub mod licences;
mod page;
mod program;
mod wheel;

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::folder::target_folder;

/// How the files are built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Build {
    /// Optimised, for users.
    Release,
    /// Without optimisation, and the program with shared libraries, to test that the files can be
    /// built, installed and used.
    Quick,
}

impl Build {
    /// `target/dist`, or `target/dist-quick`, so that no quick build is published.
    #[must_use]
    pub fn folder(self) -> PathBuf {
        target_folder().join(match self {
            Self::Release => "dist",
            Self::Quick => "dist-quick",
        })
    }
}

/// Builds and tries all files; returns their paths.
///
/// # Errors
/// A licence that is not accepted, a tool that is missing or fails, a file that does not work.
pub fn write(build: Build) -> Result<Vec<PathBuf>> {
    let folder = build.folder();
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| folder.display().to_string())?;
    }
    fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
    let refused = licences::refused(&licences::packages(None)?)?;
    ensure!(refused.is_empty(), "licences that are not accepted:\n{}", refused.join("\n"));
    let mut files = vec![wheel::write(build, &folder)?, program::write(build, &folder)?];
    match page::write(build, &folder)? {
        Some(zip) => files.push(zip),
        None => eprintln!("note: no target/page: the page is left out; run cargo xtask page"),
    }
    files.push(checksums(&folder, &files)?);
    Ok(files)
}

/// Writes `SHA256SUMS`, as `sha256sum --check` reads it.
fn checksums(folder: &Path, files: &[PathBuf]) -> Result<PathBuf> {
    let names = files.iter().filter_map(|path| path.file_name());
    let sums = output(Command::new("sha256sum").args(names).current_dir(folder))?;
    let path = folder.join("SHA256SUMS");
    fs::write(&path, sums).with_context(|| path.display().to_string())?;
    Ok(path)
}

/// The version of the workspace.
const VERSION: &str = env!("CARGO_PKG_VERSION");

fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Runs a command that must succeed.
fn run(command: &mut Command) -> Result<()> {
    let name = name(command);
    let status = command.status().with_context(|| name.clone())?;
    ensure!(status.success(), "{name} failed: {status}");
    Ok(())
}

/// Runs a command that must succeed, and returns its standard output.
fn output(command: &mut Command) -> Result<String> {
    let name = name(command);
    let output = command.output().with_context(|| name.clone())?;
    let messages = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{name} failed: {}\n{messages}", output.status);
    String::from_utf8(output.stdout).with_context(|| name)
}

/// A command as it is typed.
fn name(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    words.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checksums_are_those_of_sha256sum_and_failures_name_the_command() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("a.txt");
        fs::write(&file, "abc").unwrap();
        let sums = checksums(folder.path(), &[file]).unwrap();
        // FIPS 180-2, appendix B.1.
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad  a.txt\n";
        assert_eq!(fs::read_to_string(sums).unwrap(), expected);
        let error = checksums(folder.path(), &["b.txt".into()]).unwrap_err().to_string();
        assert!(error.starts_with("sha256sum b.txt failed: exit status: 1\n"), "{error}");
    }
}
