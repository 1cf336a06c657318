//! The chapters of the guide, as `crates/asperity-web/guide/chapters.txt` lists them: under each
//! heading a line with the name of the page, its title and what it shows.

use std::sync::LazyLock;

use anyhow::{Context, Result, ensure};

use super::lists;
use crate::folder::{read, root};

/// One page of the guide.
#[derive(Debug)]
pub struct Chapter {
    /// The heading of the contents above it.
    pub group: &'static str,
    /// The name of its file, without `.html`.
    pub slug: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What it shows: a markdown file, one section of it behind ` # `, the comment at the head of
    /// a Rust file, a file `as code`, a `list of` models, findings or figures, or the `laws` of
    /// models.
    pub parts: Vec<&'static str>,
}

/// All chapters, in order.
pub static ALL: LazyLock<Vec<Chapter>> =
    LazyLock::new(|| chapters(include_str!("../../../crates/asperity-web/guide/chapters.txt")));

fn chapters(text: &'static str) -> Vec<Chapter> {
    let (mut group, mut all) = ("", vec![]);
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("# ") {
            group = heading;
        } else if let Some((slug, rest)) = line.split_once(" | ") {
            let (title, parts) = rest.split_once(" | ").unwrap_or((rest, ""));
            all.push(Chapter { group, slug, title, parts: parts.split(" | ").collect() });
        }
    }
    all
}

impl Chapter {
    /// Its address, within the guide.
    #[must_use]
    pub fn address(&self) -> String {
        format!("{}.html", self.slug)
    }
}

/// The markdown that a part of a chapter shows, with the path of its file from the root of the
/// repository or the name of its list; `None` for laws, which are drawn.
///
/// # Errors
/// A file that cannot be read, a section that it does not have.
pub fn markdown(part: &str) -> Result<Option<(&str, String)>> {
    if part.starts_with("laws ") {
        return Ok(None);
    }
    let (path, text) = if let Some(list) = lists::named(part)? {
        (part, list)
    } else if let Some(path) = part.strip_suffix(" as code") {
        // The comments of the template are those of the table of inputs.
        let all = match path.ends_with("/template.toml") {
            true => asperity_inputs::template().into(),
            false => read(&root().join(path))?,
        };
        let code: Vec<&str> = all.lines().filter(|line| !line.starts_with("//!")).collect();
        let language = if path.ends_with(".rs") { "rust" } else { "toml" };
        (path, format!("```{language}\n{}\n```\n", code.join("\n").trim_start()))
    } else {
        let (path, heading) = part.split_once(" # ").unwrap_or((part, ""));
        let all = read(&root().join(path))?;
        let text = match heading {
            "" if path.ends_with(".rs") => head(&all),
            "" => all.replace(&section(&all, "License"), ""),
            heading => section(&all, heading),
        };
        (path, text)
    };
    ensure!(!text.trim().is_empty(), "{part}: no such section or comment");
    Ok(Some((path, text)))
}

/// The section of level 2 with a heading; code has no headings.
fn section(text: &str, wanted: &str) -> String {
    let (mut inside, mut in_code) = (false, false);
    let within = |line: &&str| {
        in_code ^= line.starts_with("```");
        if let Some(heading) = line.strip_prefix("## ").filter(|_| !in_code) {
            inside = heading.trim_end() == wanted;
        }
        inside
    };
    text.split_inclusive('\n').filter(within).collect()
}

/// The `//!` lines; their headings go down by one level, below the title of the chapter.
fn head(text: &str) -> String {
    let mut in_code = false;
    let line = |comment: &str| {
        let comment = comment.strip_prefix(' ').unwrap_or(comment);
        in_code ^= comment.starts_with("```");
        let deeper = if comment.starts_with('#') && !in_code { "#" } else { "" };
        format!("{deeper}{comment}\n")
    };
    text.lines().map_while(|line| line.strip_prefix("//!")).map(line).collect()
}

/// The chapter of a model; those of adhesion share one.
///
/// # Errors
/// A list without that chapter.
pub fn of_model(id: &str) -> Result<&'static Chapter> {
    let stem = id.split('-').next().unwrap_or_default();
    let named = |slug: &str| ALL.iter().find(|chapter| chapter.slug == slug);
    named(stem).or_else(|| named("adhesion")).context("no chapter of adhesion")
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity::{Described, Model};

    const TEXT: &str = "# T\none\n\n## A\n```sh\n## no heading\n```\n### B\n\n## C\nlast\n";

    #[test]
    fn a_section_ends_at_the_next_and_code_has_no_headings() {
        assert_eq!(section(TEXT, "A"), "## A\n```sh\n## no heading\n```\n### B\n\n");
        assert_eq!(section(TEXT, "no heading"), "");
    }

    #[test]
    fn the_head_of_a_module_ends_with_its_comment() {
        let module =
            "//! One.\n//!\n//! # Two\n//! ```\n//! # hidden\n//! ```\nfn a() {}\n//! no\n";
        assert_eq!(head(module), "One.\n\n## Two\n```\n# hidden\n```\n");
    }

    #[test]
    fn missing_files_and_sections_are_named() {
        let refused = |part| markdown(part).unwrap_err().to_string();
        assert!(refused("nowhere.md").ends_with("nowhere.md"));
        assert_eq!(
            refused("README.md # Nothing"),
            "README.md # Nothing: no such section or comment"
        );
    }

    #[test]
    fn every_crate_with_a_law_has_a_chapter() {
        let laws = std::fs::read_dir(root().join("crates")).unwrap();
        let readmes: Vec<String> = laws
            .map(|entry| entry.unwrap().path().join("README.md"))
            .filter(|path| read(path).is_ok_and(|text| text.contains("\n## Law\n")))
            .map(|path| path.strip_prefix(root()).unwrap().display().to_string())
            .collect();
        assert!(readmes.len() > 10, "{readmes:?}");
        for readme in readmes {
            let shown = ALL
                .iter()
                .any(|chapter| chapter.parts[0] == readme && chapter.parts[1].starts_with("laws "));
            assert!(shown, "{readme} has no chapter with its laws");
        }
        for model in Model::all() {
            let stem = model.id().split('-').next().unwrap();
            assert!(ALL.iter().any(|chapter| chapter.slug == stem), "{model} has no chapter");
        }
    }
}
