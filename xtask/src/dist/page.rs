//! The page as a zip.

use std::path::{Path, PathBuf};

use anyhow::Result;

use super::{VERSION, archive};
use crate::folder::target_folder;

/// Packs `target/page`, if it was built.
pub fn write(folder: &Path) -> Result<Option<PathBuf>> {
    let page = target_folder().join("page");
    if !page.join("index.html").is_file() {
        return Ok(None);
    }
    let name = format!("asperity-{VERSION}-page");
    let zip = folder.join(format!("{name}.zip"));
    archive::zip(&page, &name, &zip)?;
    Ok(Some(zip))
}
