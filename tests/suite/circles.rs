//! No file of a crate depends on itself through others, by its `use` lines.
//!
//! A name that `lib.rs` or `mod.rs` passes on counts as the file that defines it. A module and
//! the files below it are one unit: what a file uses of the modules above it is no edge.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::tidy::{assert_none, root, rust_files};

/// A path within a crate, from its root.
type Names = Vec<String>;

/// A file of a crate.
#[derive(Default)]
struct Module {
    /// What it uses of its own crate: the name that it has here, and its path.
    uses: Vec<(String, Names)>,
    /// Names that it defines.
    defines: BTreeSet<String>,
}

/// The lines of a file without its tests.
fn without_tests(text: &str) -> Vec<&str> {
    let (mut kept, mut lines) = (vec![], text.lines());
    while let Some(line) = lines.next() {
        if line.trim() != "#[cfg(test)]" {
            kept.push(line);
            continue;
        }
        let indent = &line[..line.len() - line.trim_start().len()];
        let ends = |line: &str| line.strip_prefix(indent).is_some_and(|rest| rest == "}");
        let item = lines.by_ref().find(|line| !line.trim_start().starts_with("#["));
        if item.is_some_and(|item| item.ends_with('{')) {
            lines.by_ref().find(|line| ends(line));
        }
    }
    kept
}

/// The paths of a tree such as `a::{b, c::{self, d}}`.
fn expand(tree: &str) -> Vec<String> {
    let Some((head, rest)) = tree.split_once('{') else { return vec![tree.trim().into()] };
    let inside = rest.trim_end().strip_suffix('}').unwrap_or(rest);
    let (mut depth, mut start, mut found) = (0, 0, vec![]);
    for (k, letter) in inside.char_indices().chain([(inside.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let one = inside[start..k].trim();
                if !one.is_empty() {
                    found.extend(expand(&format!("{}{one}", head.trim())));
                }
                start = k + 1;
            }
            _ => {}
        }
    }
    found
}

/// Reads a file of the crate at `place`, whose modules have these `names`.
fn module(text: &str, place: &[String], names: &BTreeSet<Names>) -> Module {
    let mut found = Module::default();
    let lines = without_tests(text);
    let mut lines = lines.iter().map(|line| line.trim());
    while let Some(line) = lines.next() {
        let item = match line.strip_prefix("pub") {
            Some(rest) if rest.starts_with('(') => rest.split_once(' ').map_or("", |all| all.1),
            Some(rest) => rest.trim_start(),
            None => line,
        };
        let Some(tree) = item.strip_prefix("use ") else {
            let words: Vec<&str> =
                item.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
            let kinds = ["struct", "enum", "trait", "fn", "type", "const", "static", "macro_rules"];
            let defined = words.windows(2).find(|pair| kinds.contains(&pair[0]) && pair[1] != "fn");
            found.defines.extend(defined.map(|pair| pair[1].to_string()));
            continue;
        };
        let mut tree = tree.to_string();
        while !tree.ends_with(';') {
            let Some(next) = lines.next() else { break };
            tree += next;
        }
        for path in expand(tree.trim_end_matches(';')) {
            let (path, name) = match path.split_once(" as ") {
                Some((path, name)) => (path.to_string(), Some(name.to_string())),
                None => (path, None),
            };
            let mut parts: Names = path.split("::").map(|part| part.trim().to_string()).collect();
            if parts.last().is_some_and(|last| last == "self") {
                parts.pop();
            }
            let first = parts[0].clone();
            let mut own: Names = match first.as_str() {
                "crate" => vec![],
                _ => place.to_vec(),
            };
            let child = || [place, std::slice::from_ref(&first)].concat();
            match first.as_str() {
                "crate" | "self" => drop(parts.remove(0)),
                "super" => {
                    while parts.first().is_some_and(|part| part == "super") {
                        parts.remove(0);
                        own.pop();
                    }
                }
                // Another crate.
                _ if !names.contains(&child()) => continue,
                _ => {}
            }
            own.extend(parts);
            let name = name.or(own.last().cloned()).unwrap_or_default();
            found.uses.push((name, own));
        }
    }
    found
}

/// The modules of a crate by their paths.
fn modules(src: &Path, files: &[PathBuf]) -> BTreeMap<Names, Module> {
    let of = |path: &PathBuf| -> Option<(Names, String)> {
        let path_in = path.strip_prefix(src).ok()?.with_extension("");
        let parts = path_in.iter().map(|part| part.to_string_lossy().into_owned());
        let mut parts: Names = parts.collect();
        if parts.last().is_some_and(|last| ["lib", "main", "mod"].contains(&last.as_str())) {
            parts.pop();
        }
        let is_test = |part: &String| part == "tests" || part.ends_with("_tests");
        (!parts.iter().any(is_test)).then(|| (parts, fs::read_to_string(path).unwrap()))
    };
    let texts: BTreeMap<Names, String> = files.iter().filter_map(of).collect();
    let names = texts.keys().cloned().collect();
    texts.iter().map(|(place, text)| (place.clone(), module(text, place, &names))).collect()
}

/// The file that defines what a path names; none if it is not of this crate.
fn defined(all: &BTreeMap<Names, Module>, path: &[String], depth: usize) -> Option<Names> {
    let length = (0..=path.len()).rev().find(|length| all.contains_key(&path[..*length]))?;
    let (place, rest) = path.split_at(length);
    let (Some(name), true) = (rest.first(), depth < 9) else { return Some(place.to_vec()) };
    let module = &all[place];
    let passed = module.uses.iter().find(|(known, _)| known == name && name != "*");
    let of = |target: &Names| defined(all, &[target, &rest[1..]].concat(), depth + 1);
    if let Some((_, target)) = passed.filter(|_| !module.defines.contains(name)) {
        return of(target);
    }
    let globs = module.uses.iter().filter(|(known, _)| known == "*");
    for (_, target) in globs.filter(|_| !module.defines.contains(name)) {
        let (_, behind) = target.split_last()?;
        if behind != place && all.get(behind).is_some_and(|module| module.defines.contains(name)) {
            return Some(behind.to_vec());
        }
    }
    Some(place.to_vec())
}

/// The circles of a crate, each with its files.
fn circles(all: &BTreeMap<Names, Module>) -> Vec<Vec<String>> {
    let below = |place: &Names| -> BTreeSet<Names> {
        let used = all[place].uses.iter().filter_map(|(_, path)| defined(all, path, 0));
        used.filter(|other| !place.starts_with(other)).collect()
    };
    let edges: BTreeMap<&Names, BTreeSet<Names>> =
        all.keys().map(|place| (place, below(place))).collect();
    let reached = |from: &Names| {
        let (mut found, mut next) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(place) = next.pop() {
            let new = edges[&place].iter().filter(|other| found.insert((*other).clone()));
            next.extend(new.cloned().collect::<Vec<_>>());
        }
        found
    };
    let reached: BTreeMap<&Names, BTreeSet<Names>> =
        all.keys().map(|place| (place, reached(place))).collect();
    let mut found = vec![];
    for (place, all) in &reached {
        let with: Vec<String> = all
            .iter()
            .filter(|other| reached[other].contains(*place))
            .map(|one| one.join("/"))
            .collect();
        if with.len() > 1 && all.contains(*place) && !found.contains(&with) {
            found.push(with);
        }
    }
    found
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let files = rust_files();
    let folder =
        |path: &'_ PathBuf| path.ancestors().find(|one| one.ends_with("src")).map(Into::into);
    let sources: BTreeSet<PathBuf> = files.iter().filter_map(folder).collect();
    let mut found = vec![];
    for src in sources {
        let name = src.parent().unwrap().strip_prefix(root()).unwrap().display().to_string();
        let circles = circles(&modules(&src, &files));
        found.extend(circles.iter().map(|one| format!("{name}: {}", one.join(" "))));
    }
    assert_none(&found, "files that use each other in a circle");
}

#[test]
fn a_name_that_is_passed_on_counts_as_the_file_that_defines_it() {
    let files = [
        ("", "mod a;\nmod b;\npub use a::First;\npub use b::*;\n"),
        ("a", "use crate::{\n    Second as Other,\n};\npub struct First(Other);\n"),
        ("b", "pub struct Second;\n#[cfg(test)]\nmod tests {\n    use crate::a;\n}\n"),
        ("b/c", "use super::Second;\nuse crate::First;\n"),
    ];
    let place = |name: &str| -> Names {
        name.split('/').filter(|part| !part.is_empty()).map(Into::into).collect()
    };
    let names = files.iter().map(|(name, _)| place(name)).collect();
    let all = |with: &str| -> BTreeMap<Names, Module> {
        let text =
            |name: &str, text: &str| format!("{text}{}", if name == "b" { with } else { "" });
        let read = |(name, own): &(&str, &str)| {
            (place(name), module(&text(name, own), &place(name), &names))
        };
        files.iter().map(read).collect()
    };
    assert!(circles(&all("")).is_empty());
    assert_eq!(circles(&all("use crate::First;\n")), [["a", "b"]]);
}
