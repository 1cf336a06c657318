//! The folder of the figures, and writing into a folder.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

/// The workspace's `figures` folder.
#[must_use]
pub fn figures_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("figures")
}

/// The workspace's `target` folder.
#[must_use]
pub fn target_folder() -> PathBuf {
    figures_folder().with_file_name("target")
}

/// A file's name and its text.
pub type Fresh = (String, String);

/// Writes texts to files; returns the paths.
///
/// # Errors
/// A file that cannot be written.
pub fn save(folder: &Path, texts: impl IntoIterator<Item = Fresh>) -> Result<Vec<PathBuf>> {
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    let save = |(name, text)| {
        let path = folder.join(name);
        fs::write(&path, text).with_context(|| path.display().to_string())?;
        Ok(path)
    };
    texts.into_iter().map(save).collect()
}
