//! The text of a chapter: files of the repository, whole, by section, or the head of a crate.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};

/// The part of a file that a chapter shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// All of a markdown file.
    Whole,
    /// The section under this heading of a markdown file.
    Section(&'static str),
    /// The comment at the head of a Rust module.
    Head,
    /// The code itself, without the comment at its head.
    Code(&'static str),
}

/// Markdown, with the file that its links start from.
#[derive(Debug, Clone, PartialEq)]
pub struct Fragment {
    /// The file, from the root of the repository.
    pub path: PathBuf,
    /// The markdown.
    pub text: String,
}

/// The root of the repository.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Reads a part of a file, given from the root of the repository.
///
/// # Errors
/// A file that cannot be read, a section that it does not have.
pub fn read(path: &str, part: Part) -> Result<Fragment> {
    let all = fs::read_to_string(root().join(path)).with_context(|| path.to_owned())?;
    let text = match part {
        Part::Whole => without(&all, "License"),
        Part::Section(heading) => section(&all, heading),
        Part::Head => head(&all),
        Part::Code(language) => {
            let code: String = all.lines().filter(|l| !l.starts_with("//!")).map(line).collect();
            format!("```{language}\n{}```\n", code.trim_start())
        }
    };
    ensure!(!text.trim().is_empty(), "{path} has no {part:?}");
    Ok(Fragment { path: path.into(), text })
}

fn line(text: &str) -> String {
    format!("{text}\n")
}

/// The lines with, for each, whether it starts a section of level 2; code has none.
fn lines(text: &str) -> impl Iterator<Item = (&str, Option<&str>)> {
    let mut in_code = false;
    text.lines().map(move |line| {
        in_code ^= line.starts_with("```");
        (line, line.strip_prefix("## ").filter(|_| !in_code))
    })
}

fn section(text: &str, wanted: &str) -> String {
    let mut inside = false;
    let mut found = String::new();
    for (line, heading) in lines(text) {
        inside = heading.map_or(inside, |heading| heading == wanted);
        if inside {
            found += line;
            found.push('\n');
        }
    }
    found
}

fn without(text: &str, unwanted: &str) -> String {
    text.replace(&section(text, unwanted), "")
}

/// The `//!` lines; their headings go down by one level, below the title of the chapter.
fn head(text: &str) -> String {
    let mut in_code = false;
    let comment = text.lines().map_while(|line| line.strip_prefix("//!"));
    comment
        .map(|comment| comment.strip_prefix(' ').unwrap_or(comment))
        .map(|comment| {
            in_code ^= comment.starts_with("```");
            let is_heading = comment.starts_with('#') && !in_code;
            line(&if is_heading { format!("#{comment}") } else { comment.to_owned() })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# T\none\n\n## A\n```sh\n## no heading\n```\n### B\n\n## C\nlast\n";

    #[test]
    fn a_section_ends_at_the_next_and_code_has_no_headings() {
        assert_eq!(section(TEXT, "A"), "## A\n```sh\n## no heading\n```\n### B\n\n");
        assert_eq!(section(TEXT, "no heading"), "");
        assert_eq!(without("# T\n\n## License\nMIT\n", "License"), "# T\n\n");
        assert_eq!(without("# T\n", "License"), "# T\n");
    }

    #[test]
    fn the_head_of_a_module_ends_with_its_comment() {
        let module =
            "//! One.\n//!\n//! # Two\n//! ```\n//! # hidden\n//! ```\nfn a() {}\n//! no\n";
        assert_eq!(head(module), "One.\n\n## Two\n```\n# hidden\n```\n");
    }

    #[test]
    fn missing_files_and_sections_are_named() {
        let refused = |path, part| read(path, part).unwrap_err().to_string();
        assert_eq!(refused("nowhere.md", Part::Whole), "nowhere.md");
        let message = refused("README.md", Part::Section("Nothing"));
        assert_eq!(message, "README.md has no Section(\"Nothing\")");
    }
}
