//! The chapters of the guide, as `crates/asperity-web/guide/chapters.txt` lists them: under each
//! heading a line with the name of the page, its title and what it shows.

use std::sync::LazyLock;

use anyhow::{Context, Result};

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
    use crate::folder::{read, root};
    use asperity::{Described, Model};

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
        for model in Model::of_asperities() {
            let stem = model.id().split('-').next().unwrap();
            assert!(ALL.iter().any(|chapter| chapter.slug == stem), "{model} has no chapter");
        }
    }
}
