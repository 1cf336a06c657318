//! Rules of style.

use std::fs;
use std::path::{Path, PathBuf};

/// Longest file, in lines.
const LINES: usize = 500;
/// Longest comment line, in characters; rustfmt does not wrap comments.
const COLUMNS: usize = 100;

/// All Rust files of the workspace.
pub fn rust_files() -> Vec<PathBuf> {
    let mut found = vec![];
    let mut folders: Vec<PathBuf> =
        ["crates", "tests", "xtask"].iter().map(|name| root().join(name)).collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                // A crate outside the workspace may have a build folder of its own.
                if !path.ends_with("target") {
                    folders.push(path);
                }
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                found.push(path);
            }
        }
    }
    assert!(found.len() > 100, "{} files found", found.len());
    found
}

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// Fails with the list of violations, each with file and line.
pub fn assert_none(violations: &[String], rule: &str) {
    assert!(violations.is_empty(), "{rule}:\n{}", violations.join("\n"));
}

#[test]
fn files_are_short() {
    let lines = |path: &PathBuf| fs::read_to_string(path).unwrap().lines().count();
    let long: Vec<String> = rust_files()
        .iter()
        .map(|path| (path, lines(path)))
        .filter(|(_, count)| *count > LINES)
        .map(|(path, count)| format!("{}: {count} lines", path.display()))
        .collect();
    assert_none(&long, "at most 500 lines");
}

#[test]
fn comment_lines_are_short() {
    let mut long = vec![];
    for path in rust_files() {
        let mut is_code = false;
        for (number, line) in fs::read_to_string(&path).unwrap().lines().enumerate() {
            let text = line.trim_start();
            let is_comment = text.starts_with("//");
            let comment = text.trim_start_matches(['/', '!']);
            is_code = is_comment && is_code != comment.trim_start().starts_with("```");
            // Code, formulas and links keep their lines.
            let is_link = text.contains("](") || text.contains("http");
            let may_be_long = is_code || is_link || comment.starts_with("    ");
            if is_comment && !may_be_long && line.chars().count() > COLUMNS {
                long.push(format!("{}:{}", path.display(), number + 1));
            }
        }
    }
    assert_none(&long, "at most 100 characters");
}
