//! The page as a zip.

use std::path::{Path, PathBuf};

use anyhow::{Result, ensure};

use super::{Build, VERSION, archive};
use crate::folder::target_folder;
use crate::guide;

/// Packs `target/page`, if it was built.
///
/// # Errors
/// A page for users without the documentation of the interfaces beside its guide.
pub fn write(build: Build, folder: &Path) -> Result<Option<PathBuf>> {
    let page = target_folder().join("page");
    if !page.join("index.html").is_file() {
        return Ok(None);
    }
    if let Some(lack) = lack(&page) {
        ensure!(build == Build::Quick, "{lack}");
        eprintln!("note: {lack}");
    }
    let name = format!("asperity-{VERSION}-page");
    let zip = folder.join(format!("{name}.zip"));
    archive::zip(&page, &name, &zip)?;
    Ok(Some(zip))
}

/// What a page lacks, and what to do.
fn lack(page: &Path) -> Option<String> {
    let missing = guide::missing_api(page).join(" and ");
    let advice = "run .ci/python and cargo xtask guide --api";
    (!missing.is_empty()).then(|| format!("target/page has no {missing}: {advice}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_lacks_what_is_not_beside_its_guide() {
        let page = tempfile::tempdir().unwrap();
        let found = lack(page.path()).unwrap();
        assert!(found.contains("rust/index.html and python/asperity.html: run"), "{found}");
        for name in ["rust/index.html", "python/asperity.html"] {
            let path = page.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, "").unwrap();
        }
        assert_eq!(lack(page.path()), None);
    }
}
