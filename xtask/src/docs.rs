//! The documentation of the whole workspace, with a front page that lists the crates.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde_json::Value;

use crate::command::{cargo, output, run};
use crate::folder;
use crate::html::escape;

/// Runs `cargo doc` with warnings as errors and writes `target/doc/index.html`; returns its path.
///
/// # Errors
/// A failure of cargo, a broken link in the documentation, a file that cannot be written.
pub fn write() -> Result<PathBuf> {
    let flags = std::env::var("RUSTDOCFLAGS").unwrap_or_default();
    let flags = format!("{flags} -D warnings");
    run(cargo().args(["doc", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", flags))?;
    let printed = output(cargo().args(["metadata", "--no-deps", "--format-version", "1"]))?;
    let metadata: Value = serde_json::from_str(&printed)?;
    let target = metadata["target_directory"].as_str().context("cargo metadata")?;
    let path = Path::new(target).join("doc/index.html");
    folder::write(&path, page(&metadata).context("cargo metadata")?)?;
    Ok(path)
}

/// A link and a description for each documented library, the facade first; `None` of other than the
/// metadata of cargo.
fn page(metadata: &Value) -> Option<String> {
    let is_library = |target: &&Value| {
        let kind = target["kind"][0].as_str();
        target["doc"] == true && kind.is_some_and(|kind| kind.ends_with("lib"))
    };
    let mut libraries = vec![];
    for package in metadata["packages"].as_array()? {
        if let Some(library) = package["targets"].as_array()?.iter().find(is_library) {
            libraries.push((library["name"].as_str()?, package["description"].as_str()?));
        }
    }
    libraries.sort_by_key(|(name, _)| (*name != "asperity", *name));
    let row = |(name, description): (&str, &str)| {
        let (folder, description) = (name.replace('-', "_"), escape(description));
        format!(
            "<tr><td><a href=\"{folder}/index.html\">{folder}</a></td><td>{description}</td></tr>\n"
        )
    };
    let rows: String = libraries.into_iter().map(row).collect();
    Some(include_str!("docs.html").replace("<!-- rows -->\n", &rows))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_page_lists_libraries_with_the_facade_first_and_no_programs() {
        let package = |name: &str, kind: &str| {
            let target = json!({ "name": name, "kind": [kind], "doc": true });
            json!({ "description": format!("{name} <describes> itself"), "targets": [target] })
        };
        let packages = [
            package("asperity-core", "lib"),
            package("asperity", "lib"),
            package("asperity-cli", "bin"),
        ];
        let text = page(&json!({ "packages": packages })).unwrap();
        let at = |text_of: &str| text.find(text_of);
        assert!(at("asperity/index.html\">asperity</a></td>") < at("asperity_core/index.html"));
        assert!(at("asperity_cli").is_none());
        assert!(text.contains("asperity-core &lt;describes&gt; itself"));
    }
}
