//! What a part of a chapter shows, as markdown.

use anyhow::{Result, ensure};

use super::lists;
use crate::folder::{read, root};

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

#[cfg(test)]
mod tests {
    use super::*;

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
}
