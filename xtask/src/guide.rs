//! The guide: READMEs, definitions and chapters of the repository, which MkDocs writes as html.
//!
//! The chapters stand in `crates/apps/web/guide/chapters.txt`, the settings of MkDocs beside.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use asperity::{Code, Described, Model, Quantity};

use crate::command::{output, run};
use crate::figures::{FIGURES, captions};
use crate::folder::{copy, read, root, target_folder, write as save};
use crate::opened::links;
use crate::table::{markdown_head, markdown_row};

const CHAPTERS: &str = include_str!("../../crates/apps/web/guide/chapters.txt");
const MODELS: &str = "list of models";
/// Documentation of the interfaces beside the guide, listed where `dist` has written it.
const API: [(&str, &str); 2] =
    [("Rust crates", "../rust/asperity/index.html"), ("Python package", "../python/asperity.html")];

/// Writes the guide beside the page, `target/page/guide`, and returns its front page. MkDocs is
/// installed under `target/guide` the first time.
///
/// # Errors
/// A file or heading that a chapter names and that does not exist, a machine without Python or the
/// package MkDocs.
pub fn write() -> Result<PathBuf> {
    let (page, work) = (target_folder().join("page"), target_folder().join("guide"));
    let docs = work.join("docs");
    if docs.exists() {
        fs::remove_dir_all(&docs).with_context(|| docs.display().to_string())?;
    }
    // The chapter that shows a file.
    let mut places = HashMap::from([("README.md", "index"), ("figures", "figures")]);
    for (slug, _, parts) in CHAPTERS.lines().filter_map(chapter) {
        for part in parts {
            places.entry(part).or_insert(slug);
        }
    }
    let mut nav = String::from("nav:\n");
    for line in CHAPTERS.lines() {
        if let Some(group) = line.strip_prefix("# ") {
            nav += &format!("- {group}:\n");
        }
        let Some((slug, title, parts)) = chapter(line) else { continue };
        nav += &format!("  - {title:?}: {slug}.md\n");
        // What a word means stands first among what is found.
        let boost = if slug == "definitions" { "---\nsearch:\n  boost: 4\n---\n" } else { "" };
        let mut text = format!("{boost}# {title}\n\n");
        for part in parts {
            let shown = markdown(part).and_then(|text| linked(&text, part, &places, &docs));
            text += &shown.with_context(|| part.to_owned())?;
        }
        save(&docs.join(slug).with_extension("md"), text)?;
    }
    let written = |(_, to): &(&str, &str)| page.join(to.trim_start_matches("../")).is_file();
    for (k, (name, to)) in API.into_iter().filter(written).enumerate() {
        nav += &format!("{}  - {name}: {to}\n", if k == 0 { "- Interfaces:\n" } else { "" });
    }
    let own = root().join("crates/apps/web/guide");
    for file in ["guide.css", "near.js"] {
        copy(&own.join(file), &docs.join(file))?;
    }
    let site = page.join("guide");
    let settings = format!("INHERIT: {:?}\nsite_dir: {site:?}\n{nav}", own.join("mkdocs.yml"));
    save(&work.join("mkdocs.yml"), settings)?;
    let python = work.join("venv/bin/python");
    if !work.join("venv/bin/mkdocs").is_file() {
        run(Command::new("python3").args(["-m", "venv"]).arg(work.join("venv")))?;
        let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
        run(Command::new(&python).args(pip).arg("mkdocs-material>=9.5,<10"))?;
    }
    let build = ["-m", "mkdocs", "build", "--strict", "--config-file", "mkdocs.yml"];
    // Its warnings are errors, and shown with them.
    output(Command::new(&python).args(build).current_dir(&work))?;
    Ok(site.join("index.html"))
}

/// The name, the title and the parts of a chapter; `None` of other lines.
fn chapter(line: &str) -> Option<(&str, &str, Vec<&str>)> {
    let mut cells = line.split(" | ");
    Some((cells.next()?, cells.next()?, cells.collect()))
}

/// What a part of a chapter shows: a markdown file, the comment at the head of a Rust file, a file
/// `as code`, or a `list of` the code.
fn markdown(part: &str) -> Result<String> {
    if part == "crates/answer/scene/src/template.toml as code" {
        // Its comments come from the table of inputs.
        return Ok(format!("```toml\n{}\n```\n", asperity_scene::template()));
    }
    if let Some(path) = part.strip_suffix(" as code") {
        let code = read(&root().join(path))?;
        let below = code.lines().filter(|line| !line.starts_with("//!")).collect::<Vec<_>>();
        return Ok(format!("```rust\n{}\n```\n", below.join("\n").trim()));
    }
    match part {
        MODELS => Ok(models()),
        "list of quantities" => Ok(quantities()),
        "list of findings" => Ok(Code::ALL.iter().map(finding).collect()),
        "list of figures" => figures(),
        path => {
            let text = read(&root().join(path))?;
            if path.ends_with(".rs") { Ok(head(&text)) } else { Ok(text) }
        }
    }
}

/// The `//!` lines without those that rustdoc hides; headings go down by one level, names that
/// rustdoc links are code.
fn head(text: &str) -> String {
    let (mut shown, mut in_code) = (String::new(), false);
    for line in text.lines().map_while(|line| line.strip_prefix("//!")) {
        let line = line.strip_prefix(' ').unwrap_or(line);
        in_code ^= line.starts_with("```");
        match line.starts_with("# ") {
            true if in_code => {}
            true => shown += &format!("#{line}\n"),
            false => shown += &(line.replace("[`", "`").replace("`]", "`") + "\n"),
        }
    }
    shown
}

/// A text without its title, its links to files of the repository as links to chapters
/// or to copies of the files.
fn linked(text: &str, of: &str, places: &HashMap<&str, &str>, docs: &Path) -> Result<String> {
    let (mut linked, mut in_code) = (String::from("\n"), false);
    for line in text.lines() {
        in_code ^= line.trim_start().starts_with("```");
        if in_code || !line.starts_with("# ") {
            let mut parts = line.split("](");
            linked += parts.next().unwrap_or_default();
            for part in parts {
                let (link, rest) = part.split_once(')').unwrap_or((part, ""));
                let to = if in_code { link.into() } else { target(link, of, places, docs)? };
                linked += &format!("]({to}){rest}");
            }
            linked.push('\n');
        }
    }
    Ok(linked)
}

/// Where a link of a part leads within the guide.
fn target(link: &str, of: &str, places: &HashMap<&str, &str>, docs: &Path) -> Result<String> {
    if link.contains("://") || link.starts_with('#') || of == MODELS {
        return Ok(link.into());
    }
    let (file, anchor) = link.split_at(link.find('#').unwrap_or(link.len()));
    let mut path = Path::new(of).with_file_name("");
    for part in Path::new(file) {
        if part == ".." {
            path.pop();
        } else {
            path.push(part);
        }
    }
    let name = path.to_str().unwrap_or_default();
    if let Some(slug) = places.get(name) {
        return Ok(format!("{slug}.md{anchor}"));
    }
    ensure!(root().join(&path).is_file(), "{link}: no such file");
    // Browsers show what ends in txt.
    let is_shown = [".svg", ".csv", ".png"].iter().any(|end| name.ends_with(end));
    let to = format!("files/{name}{}", if is_shown { "" } else { ".txt" });
    copy(&root().join(&path), &docs.join(&to))?;
    Ok(to)
}

/// The chapter about a model, with its equations.
fn chapter_of(id: &str) -> &str {
    match id.split('-').collect::<Vec<_>>()[..] {
        [.., arrangement @ ("random" | "pairs")] => arrangement,
        ["dmt" | "jkr", ..] => "adhesion",
        ["cmy" | "mikic", ..] => "conductance",
        ["best", ..] => "which-model",
        [first, ..] => first,
        [] => "models",
    }
}

/// A table of all models but those on random surfaces and between two rough ones.
fn models() -> String {
    let mut rows = markdown_head(&["id", "name", "year", "authors", "equations", "valid for"], 0);
    for model in Model::all().into_iter().filter(|model| model.equal().id() == model.id()) {
        let citation = model.citation();
        rows += &markdown_row(&[
            &format!("[`{}`]({}.md)", model.id(), chapter_of(model.id())),
            model.name(),
            &citation.year.to_string(),
            citation.authors,
            &citation.provenance.to_string(),
            model.validity().valid_for,
        ]);
    }
    rows
}

/// A table of all quantities.
fn quantities() -> String {
    let mut rows = markdown_head(&["quantity", "symbol", "unit", "definition", "errors"], 0);
    for quantity in Quantity::ALL {
        rows += &markdown_row(&[
            &*format!("`{quantity}`"),
            &quantity.symbol().replace("sum ", "Σ"),
            if quantity.unit().is_empty() { "1" } else { quantity.unit() },
            quantity.definition(),
            if quantity.is_absolute() { "absolute" } else { "relative" },
        ]);
    }
    rows
}

/// What the code of a warning or note means, and what to do.
fn finding(code: &Code) -> String {
    let (name, [meaning, harmless, remedy]) = (code.name(), code.texts());
    format!("### `{name}`\n\n{meaning}\n\nHarmless: {harmless}\n\nTo do: {remedy}\n\n")
}

/// Every committed figure under its title.
fn figures() -> Result<String> {
    let mut text = String::from("## Pictures\n\n");
    for (name, ..) in &FIGURES {
        let title = captions::of(name)?.0;
        let file = format!("figures/{name}");
        let links = links(name)?;
        text += &format!("![{title}]({file}.svg)\n\n{links}[{title}: numbers]({file}.csv)\n\n");
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_crate_with_a_law_has_a_chapter_and_each_chapter_can_be_read() -> Result<()> {
        let shown: Vec<&str> = CHAPTERS.lines().filter_map(chapter).flat_map(|c| c.2).collect();
        for entry in std::fs::read_dir(root().join("crates/models"))? {
            let readme = entry?.path().join("README.md");
            if read(&readme).is_ok_and(|text| text.contains("\n## Law\n")) {
                let name = readme.strip_prefix(root())?.display().to_string();
                assert!(shown.contains(&&*name), "{name}");
            }
        }
        for link in models().split("](").skip(1).filter_map(|rest| rest.split_once(".md)")) {
            let is_chapter = CHAPTERS.lines().filter_map(chapter).any(|c| c.0 == link.0);
            assert!(is_chapter, "{}", link.0);
        }
        shown.into_iter().try_for_each(|part| markdown(part).map(drop).context(part.to_owned()))
    }
}
