//! Licences of the dependencies: which are accepted, and the texts that go with a binary.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde::Deserialize;
use spdx::{Expression, ParseMode};

use super::{cargo, output};

/// Licences that allow to pass on a program of either licence of this project.
const ACCEPTED: [&str; 9] = [
    "0BSD",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSL-1.0",
    "MIT",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
];
/// Where dependencies come from.
const REGISTRY: &str = "registry+https://github.com/rust-lang/crates.io-index";

/// The part of the output of `cargo metadata` that is needed here.
#[derive(Deserialize)]
pub struct Packages {
    packages: Vec<Package>,
    resolve: Graph,
}

#[derive(Deserialize)]
struct Package {
    id: String,
    name: String,
    version: String,
    license: Option<String>,
    /// `None` for a member of the workspace.
    source: Option<String>,
    manifest_path: PathBuf,
}

#[derive(Deserialize)]
struct Graph {
    nodes: Vec<Node>,
}

#[derive(Deserialize)]
struct Node {
    id: String,
    deps: Vec<Dependency>,
}

#[derive(Deserialize)]
struct Dependency {
    pkg: String,
    dep_kinds: Vec<Kind>,
}

/// `None` for what is linked.
#[derive(Deserialize)]
struct Kind {
    kind: Option<String>,
}

/// All packages, of one target or of every target.
///
/// # Errors
/// A failure of cargo.
pub fn packages(target: Option<&str>) -> Result<Packages> {
    let mut command = cargo();
    command
        .args(["metadata", "--format-version", "1", "--locked"])
        .current_dir(crate::guide::root());
    if let Some(target) = target {
        command.args(["--filter-platform", target]);
    }
    serde_json::from_str(&output(&mut command)?).context("cargo metadata")
}

/// The dependencies whose licence is not accepted, or that come from elsewhere than crates.io.
///
/// # Errors
/// A licence that is no SPDX expression.
pub fn refused(packages: &Packages) -> Result<Vec<String>> {
    let mut refused = vec![];
    for Package { name, version, license, source, .. } in &packages.packages {
        let Some(source) = source else { continue };
        let licence = license.as_deref().unwrap_or_default();
        if source != REGISTRY {
            refused.push(format!("{name} {version} comes from {source}"));
        } else if !is_accepted(licence).with_context(|| format!("{name} {version}"))? {
            refused.push(format!("{name} {version}: {licence:?}"));
        }
    }
    Ok(refused)
}

fn is_accepted(licence: &str) -> Result<bool> {
    if licence.is_empty() {
        return Ok(false);
    }
    let expression = Expression::parse_mode(licence, ParseMode::LAX)?;
    Ok(expression.evaluate(|required| ACCEPTED.contains(&required.to_string().as_str())))
}

/// The names and texts of the licences of what is linked into a package on a target.
///
/// # Errors
/// A failure of cargo, a text that cannot be read.
pub fn notices(package: &str, target: &str) -> Result<String> {
    let packages = packages(Some(target))?;
    let mut linked: Vec<&Package> = linked(&packages, package)?;
    linked.sort_by_key(|package| (&package.name, &package.version));
    let mut text = String::from("Third-party software in this binary.\n\n");
    let mut texts: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for package in linked {
        let licence = package.license.as_deref().unwrap_or_default();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{} {}: {licence}", package.name, package.version);
        for licence in licence_texts(&package.manifest_path)? {
            texts.entry(licence).or_default().push(&package.name);
        }
    }
    for (licence, names) in texts {
        let _ = write!(text, "\n{}\n{}\n\n{licence}\n", "=".repeat(80), names.join(", "));
    }
    Ok(text)
}

/// The packages from elsewhere that a package is linked with, directly or through others.
fn linked<'a>(packages: &'a Packages, name: &str) -> Result<Vec<&'a Package>> {
    let by_id: HashMap<&str, &Package> =
        packages.packages.iter().map(|package| (package.id.as_str(), package)).collect();
    let nodes: HashMap<&str, &Node> =
        packages.resolve.nodes.iter().map(|node| (node.id.as_str(), node)).collect();
    let is_root = |package: &&Package| package.name == name && package.source.is_none();
    let root = packages.packages.iter().find(is_root);
    let root = root.with_context(|| format!("{name} is not a package of the workspace"))?;
    let (mut seen, mut open) = (HashSet::new(), vec![root.id.as_str()]);
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        let needs = nodes.get(id).into_iter().flat_map(|node| &node.deps);
        let is_linked =
            |dependency: &&Dependency| dependency.dep_kinds.iter().any(|kind| kind.kind.is_none());
        open.extend(needs.filter(is_linked).map(|dependency| dependency.pkg.as_str()));
    }
    let seen = seen.into_iter().filter_map(|id| by_id.get(id).copied());
    Ok(seen.filter(|package| package.source.is_some()).collect())
}

/// The texts of licences and notices beside a manifest.
fn licence_texts(manifest: &Path) -> Result<Vec<String>> {
    let folder = manifest.parent().unwrap_or(manifest);
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .with_context(|| folder.display().to_string())?
        .filter_map(|entry| entry.ok().map(|entry| entry.path()))
        .filter(|path| path.is_file() && is_licence(path))
        .collect();
    paths.sort();
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).with_context(|| path.display().to_string())?;
        Ok(text.replace("\r\n", "\n").trim().to_owned())
    };
    paths.into_iter().map(read).collect()
}

fn is_licence(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
    ["LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE"].iter().any(|w| name.starts_with(w))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Packages of other targets need not be on this machine.
    const HERE: &str = "x86_64-unknown-linux-gnu";

    #[test]
    fn every_dependency_has_an_accepted_licence_and_comes_from_the_registry() {
        let packages = packages(Some(HERE)).unwrap();
        assert!(packages.packages.len() > 100);
        assert_eq!(refused(&packages).unwrap(), Vec::<String>::new());
    }

    #[test]
    fn one_accepted_alternative_is_enough_and_a_sum_needs_all() {
        for (licence, expected) in [
            ("MIT", true),
            ("GPL-3.0-only", false),
            ("MIT/Apache-2.0", true),
            ("GPL-2.0-only OR MIT", true),
            ("MIT AND GPL-2.0-only", false),
            ("Apache-2.0 WITH LLVM-exception", true),
            ("", false),
        ] {
            assert_eq!(is_accepted(licence).unwrap(), expected, "{licence}");
        }
        assert!(is_accepted("free for all").is_err());
    }

    #[test]
    fn notices_have_what_is_linked_with_its_text_and_no_tools_of_tests() {
        let text = notices("asperity-cli", HERE).unwrap();
        assert!(text.contains("\nclap 4.") && text.contains("\nrustfft "), "{text}");
        assert!(!text.contains("\ninsta ") && !text.contains("\nasperity"));
        assert!(text.contains("Permission is hereby granted, free of charge"));
        let missing = notices("nowhere", HERE).unwrap_err().to_string();
        assert_eq!(missing, "nowhere is not a package of the workspace");
    }
}
