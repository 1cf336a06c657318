//! The files of the page that are copied as they are.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use crate::head;

/// Copies the page and the example scenes; html gets its head.
pub(super) fn write(root: &Path, folder: &Path) -> Result<()> {
    all(&root.join("crates/asperity-web/www"), folder)?;
    all(&root.join("crates/asperity-inputs/examples"), &folder.join("examples"))?;
    for name in super::PAGES {
        let path = folder.join(name);
        let of = || path.display().to_string();
        let page = head::of_explorer(&fs::read_to_string(&path).with_context(of)?);
        let page = page.with_context(|| format!("{name} does not begin with its head"))?;
        fs::write(&path, page).with_context(of)?;
    }
    Ok(())
}

fn all(from: &Path, to: &Path) -> Result<()> {
    let of = |path: &Path| path.display().to_string();
    fs::create_dir_all(to).with_context(|| of(to))?;
    for entry in fs::read_dir(from).with_context(|| of(from))? {
        let path = entry.with_context(|| of(from))?.path();
        if let (true, Some(name)) = (path.is_file(), path.file_name()) {
            fs::copy(&path, to.join(name)).with_context(|| of(&path))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::folder::figures_folder;

    #[test]
    fn the_page_is_copied_with_its_examples_and_links_inside() {
        let folder = tempfile::tempdir().unwrap();
        let root = figures_folder().parent().unwrap().to_path_buf();
        write(&root, folder.path()).unwrap();
        let page = fs::read_to_string(folder.path().join("index.html")).unwrap();
        assert!(folder.path().join("examples/ground-steel.toml").is_file());
        for name in ["src=\"", "href=\""].iter().flat_map(|key| page.split(key).skip(1)) {
            let name = name.split('"').next().unwrap_or_default();
            let anchor = |id: &str| page.contains(&format!("id=\"{id}\""));
            let inside = ["data:,", "guide/index.html"].contains(&name)
                || name.strip_prefix('#').is_some_and(anchor)
                || folder.path().join(name).is_file();
            assert!(inside, "{name} is not a file of the page");
        }
        assert!(page.contains("script-src 'self' 'wasm-unsafe-eval'"));
        assert!(!page.contains("unsafe-inline"));
    }
}
