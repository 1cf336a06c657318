//! The documentation of the whole workspace, with a front page that lists the crates.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde::Deserialize;

/// The part of the output of `cargo metadata` that is needed here.
#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
    target_directory: PathBuf,
}

#[derive(Deserialize)]
struct Package {
    description: Option<String>,
    targets: Vec<Target>,
}

#[derive(Deserialize)]
struct Target {
    name: String,
    kind: Vec<String>,
    doc: bool,
}

/// Runs `cargo doc` with warnings as errors and writes `target/doc/index.html`; returns its path.
///
/// # Errors
/// A failure of cargo, a broken link in the documentation, a file that cannot be written.
pub fn write() -> Result<PathBuf> {
    let flags = std::env::var("RUSTDOCFLAGS").unwrap_or_default();
    let status = cargo()
        .args(["doc", "--workspace", "--no-deps"])
        .env("RUSTDOCFLAGS", format!("{flags} -D warnings"))
        .status()
        .context("cargo doc")?;
    ensure!(status.success(), "cargo doc failed: {status}");
    let printed = cargo()
        .args(["metadata", "--no-deps", "--format-version", "1"])
        .output()
        .context("cargo metadata")?;
    ensure!(printed.status.success(), "cargo metadata failed: {}", printed.status);
    let metadata: Metadata = serde_json::from_slice(&printed.stdout).context("cargo metadata")?;
    let path = metadata.target_directory.join("doc").join("index.html");
    std::fs::write(&path, page(&metadata)).with_context(|| path.display().to_string())?;
    Ok(path)
}

fn cargo() -> Command {
    Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// A link and a description for each documented library, the facade first.
fn page(metadata: &Metadata) -> String {
    let mut libraries: Vec<(&str, &str)> = metadata
        .packages
        .iter()
        .filter_map(|package| {
            let is_library = |target: &&Target| {
                target.doc && target.kind.iter().any(|kind| kind.ends_with("lib"))
            };
            let library = package.targets.iter().find(is_library)?;
            Some((library.name.as_str(), package.description.as_deref().unwrap_or_default()))
        })
        .collect();
    libraries.sort_by_key(|(name, _)| (*name != "asperity", *name));
    let mut rows = String::new();
    for (name, description) in libraries {
        let folder = name.replace('-', "_");
        let description =
            description.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        // Writing to a string cannot fail.
        let _ = writeln!(
            rows,
            "<tr><td><a href=\"{folder}/index.html\">{folder}</a></td><td>{description}</td></tr>"
        );
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>asperity: crates</title>\n\
         <style>body {{ font-family: sans-serif; margin: 2em; max-width: 60em }} td {{ padding: 0.2em 1em }}</style>\n\
         </head>\n<body>\n<h1>asperity</h1>\n<p>Rough surfaces in contact. Start with \
         <a href=\"asperity/index.html\">asperity</a>; the other crates are its parts.</p>\n\
         <table>\n{rows}</table>\n</body>\n</html>\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_lists_libraries_with_the_facade_first_and_no_programs() {
        let target = |name: &str, kind: &str| Target {
            name: name.into(),
            kind: vec![kind.into()],
            doc: true,
        };
        let package = |name: &str, kind: &str| Package {
            description: Some(format!("{name} <describes> itself")),
            targets: vec![target(name, kind)],
        };
        let packages = vec![
            package("asperity-core", "lib"),
            package("asperity", "lib"),
            package("asperity-cli", "bin"),
        ];
        let text = page(&Metadata { packages, target_directory: PathBuf::new() });
        let at = |text_of: &str| text.find(text_of);
        assert!(at("asperity/index.html\">asperity</a></td>") < at("asperity_core/index.html"));
        assert!(at("asperity_cli").is_none());
        assert!(text.contains("asperity-core &lt;describes&gt; itself"));
    }
}
