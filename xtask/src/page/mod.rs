//! The page: the explorer in `target/page` and the guide below it, with relative links only.

mod copy;
mod gallery;
mod module;
mod server;

use std::path::PathBuf;

use anyhow::{Result, ensure};

pub use server::serve;

use crate::folder::figures_folder;
use crate::guide;

/// The pages of the explorer.
const PAGES: [&str; 3] = ["index.html", "gallery.html", "models.html"];

/// Writes the page and returns its folder; with `keep_module` without building the module again.
///
/// # Errors
/// A failed build, files that cannot be read or written, and links that dangle or lead outside.
pub fn write(keep_module: bool) -> Result<PathBuf> {
    let root = figures_folder();
    let root = root.parent().unwrap_or(&root);
    let folder = root.join("target").join("page");
    copy::write(root, &folder)?;
    gallery::write(&folder)?;
    if !keep_module {
        module::write(root, &folder)?;
    }
    guide::write(&folder)?;
    let pages = PAGES.map(|name| folder.join(name));
    let violations = guide::links::violations(&pages, &[])?;
    ensure!(violations.is_empty(), "links of the explorer:\n{}", violations.join("\n"));
    Ok(folder)
}
