//! The page: the explorer in `target/page`, with relative links only.

mod copy;
mod module;
mod server;

use std::path::PathBuf;

use anyhow::Result;

pub use server::serve;

use crate::folder::figures_folder;

/// Writes the page and returns its folder; with `keep_module` without building the module again.
///
/// # Errors
/// A failed build, and files that cannot be read or written.
pub fn write(keep_module: bool) -> Result<PathBuf> {
    let root = figures_folder();
    let root = root.parent().unwrap_or(&root);
    let folder = root.join("target").join("page");
    copy::write(root, &folder)?;
    if !keep_module {
        module::write(root, &folder)?;
    }
    Ok(folder)
}
