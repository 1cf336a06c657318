//! The documentation of the interfaces, beside the guide: rustdoc and pdoc, which keep their own
//! links and styles.

use std::fs;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use super::save;
use crate::docs;
use crate::folder::target_folder;

/// Writes `rust/` and `python/` to the folder of the page. The Python package must be installed in
/// `target/python`, as `.ci/python` does; pdoc is installed there if it is missing.
///
/// # Errors
/// A failure of cargo, pip or pdoc, a package that is not installed.
pub fn write(page_folder: &Path) -> Result<()> {
    let front = docs::write()?;
    let made = front.parent().context("the folder of rustdoc")?;
    let rust = page_folder.join("rust");
    empty(&rust)?;
    copy_all(made, &rust)?;
    let python = page_folder.join("python");
    empty(&python)?;
    let interpreter = target_folder().join("python/bin/python");
    ensure!(interpreter.is_file(), "target/python is missing: run .ci/python");
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "pdoc"];
    run(Command::new(&interpreter).args(pip))?;
    run(Command::new(&interpreter)
        .args(["-m", "pdoc", "--docformat", "numpy", "--output-directory"])
        .arg(&python)
        .arg("asperity"))
}

fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| format!("{command:?}"))?;
    ensure!(status.success(), "{command:?} failed: {status}");
    Ok(())
}

fn empty(folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder).with_context(|| folder.display().to_string())?;
    }
    Ok(())
}

fn copy_all(from: &Path, to: &Path) -> Result<()> {
    for entry in fs::read_dir(from).with_context(|| from.display().to_string())? {
        let path = entry?.path();
        let target = to.join(path.file_name().unwrap_or_default());
        match path.is_dir() {
            true => copy_all(&path, &target)?,
            // A lock of cargo.
            false if path.file_name().is_some_and(|name| name == ".lock") => {}
            false => save(&target, &fs::read(&path)?)?,
        }
    }
    Ok(())
}
