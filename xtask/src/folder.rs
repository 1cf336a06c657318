//! Folders of the workspace, and files with their names in every error.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

/// The root of the workspace.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("")
}

/// The workspace's `figures` folder.
#[must_use]
pub fn figures_folder() -> PathBuf {
    root().join("figures")
}

/// The folder of what cargo and these tasks make: `CARGO_TARGET_DIR`, as for cargo, or the
/// workspace's `target`.
#[must_use]
pub fn target_folder() -> PathBuf {
    let named = std::env::var_os("CARGO_TARGET_DIR").filter(|name| !name.is_empty());
    target_in(named.as_deref(), std::env::current_dir().unwrap_or_else(|_| root()))
}

fn target_in(named: Option<&OsStr>, here: PathBuf) -> PathBuf {
    named.map_or_else(|| root().join("target"), |named| here.join(named))
}

/// The text of a file.
///
/// # Errors
/// A file that cannot be read.
pub fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).with_context(|| path.display().to_string())
}

/// Writes a file, and its folder where it is missing.
///
/// # Errors
/// A file that cannot be written.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<()> {
    let folder = path.parent().unwrap_or(path);
    let written = fs::create_dir_all(folder).and_then(|()| fs::write(path, bytes));
    written.with_context(|| path.display().to_string())
}

/// Copies a file, or the files of a folder and those below it.
///
/// # Errors
/// A file that cannot be read or written.
pub fn copy(from: &Path, to: &Path) -> Result<()> {
    let name = || from.display().to_string();
    if !from.is_dir() {
        return write(to, fs::read(from).with_context(name)?);
    }
    for entry in fs::read_dir(from).with_context(name)? {
        let entry = entry?;
        copy(&entry.path(), &to.join(entry.file_name()))?;
    }
    Ok(())
}

/// A file's name and its text.
pub type Fresh = (String, String);

/// Writes texts to files; returns the paths.
///
/// # Errors
/// A file that cannot be written.
pub fn save(folder: &Path, texts: impl IntoIterator<Item = Fresh>) -> Result<Vec<PathBuf>> {
    let save = |(name, text): Fresh| {
        let path = folder.join(name);
        write(&path, text).map(|()| path)
    };
    texts.into_iter().map(save).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_target_folder_is_that_of_cargo() {
        let of = |name: Option<&str>| target_in(name.map(OsStr::new), "/here".into());
        assert_eq!(of(None), root().join("target"));
        assert_eq!(of(Some("/elsewhere")), Path::new("/elsewhere"));
        assert_eq!(of(Some("below")), Path::new("/here/below"));
    }
}
