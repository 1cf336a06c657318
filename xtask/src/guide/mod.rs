//! The guide: READMEs, definitions and chapters of the repository as html, with a search over
//! titles, headings and text.
//!
//! [`chapters`] lists the pages and reads their text, `markdown` writes it as html, `site` knows
//! where each file and heading went, `laws` draws the models, and the tests check every link.

pub mod chapters;
mod equations;
mod laws;
#[cfg(test)]
pub(crate) mod link_tests;
mod lists;
mod markdown;
mod parts;
mod site;

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use serde::Serialize;

use crate::command::run;
use crate::docs;
use crate::folder::{copy, remove, root, write as save};
use crate::html::{self, escape};
use chapters::Chapter;
use markdown::Outline;
use site::{Piece, Site};

/// The folder of the guide within that of the page.
const FOLDER: &str = "guide";
/// The documentation of the interfaces beside the guide, listed where it was written.
const API: [(&str, &str); 2] =
    [("../rust/index.html", "Rust crates"), ("../python/asperity.html", "Python package")];
/// Style and search, copied as they are; colours and equations look as in the explorer.
const PARTS: [&str; 3] = ["www/common.css", "guide/guide.css", "guide/search.js"];

/// A page or a section that can be searched.
#[derive(Serialize)]
struct Entry {
    page: &'static str,
    heading: String,
    address: String,
    /// The words below it.
    text: String,
}

/// Writes the guide to `guide/` in the folder of the page; returns its front page.
///
/// # Errors
/// A file that cannot be read or written, a section or heading that does not exist, a picture that
/// cannot be drawn, a link that leads nowhere.
pub fn write(page_folder: &Path) -> Result<PathBuf> {
    let folder = page_folder.join(FOLDER);
    remove(&folder)?;
    let (mut site, chapters) = Site::read()?;
    let mut entries = vec![];
    let api: Vec<_> = API.into_iter().filter(|(to, _)| exists(page_folder, to)).collect();
    for (chapter, pieces) in &chapters {
        entries.extend(entries_of(chapter, pieces));
        let text = html_of(chapter, pieces, &folder, &mut site).with_context(|| chapter.slug)?;
        let body = include_str!("frame.html")
            .replace("<!-- contents -->", &lists::contents(chapter, &api))
            .replace("<!-- title -->", &escape(chapter.title))
            .replace("<!-- neighbours -->", &lists::neighbours(chapter))
            .replace("<!-- text -->", &text);
        let title = format!("{} · asperity", chapter.title);
        let about = format!("{}, a chapter of the guide to asperity.", chapter.title);
        let page = html::page([&title, &about], "guide.css", Some(("search.js", false)), &body);
        save(&folder.join(chapter.address()), page)?;
    }
    save(&folder.join("search.json"), serde_json::to_string(&entries)?)?;
    for (from, to) in &site.files {
        copy(&root().join(from), &folder.join(to))?;
    }
    for part in PARTS {
        let path = root().join("crates/asperity-web").join(part);
        copy(&path, &folder.join(path.file_name().unwrap_or_default()))?;
    }
    Ok(folder.join("index.html"))
}

/// What can be found: a page, and the sections below it.
fn entries_of(chapter: &Chapter, pieces: &[Piece]) -> Vec<Entry> {
    let entry = |heading: &str, address: String, words: &str| {
        let text = words.split_whitespace().collect::<Vec<_>>().join(" ");
        Entry { page: chapter.title, heading: heading.into(), address, text }
    };
    let (mut leads, mut entries) = (String::new(), vec![]);
    for piece in pieces {
        let Piece::Text(.., Outline { lead, headings }) = piece else { continue };
        leads += lead;
        let address = |id: &str| format!("{}#{id}", chapter.address());
        entries.extend(headings.iter().map(|h| entry(&h.text, address(&h.id), &h.words)));
    }
    entries.insert(0, entry("", chapter.address(), &leads));
    entries
}

/// The text of a chapter; laws stand before the range in which they are valid.
fn html_of(chapter: &Chapter, pieces: &[Piece], folder: &Path, site: &mut Site) -> Result<String> {
    let mut html = String::new();
    for piece in pieces {
        match piece {
            Piece::Text(path, text, outline) => {
                let resolve = |link: &str, is_picture| site.resolve(path, link, is_picture);
                html += &markdown::render(text, &outline.headings, resolve)?;
            }
            Piece::Laws(laws) => {
                let (svg, alt) = laws::draw(laws)?;
                let name = format!("laws/{}.svg", chapter.slug);
                save(&folder.join(&name), svg)?;
                let range = "<h2 id=\"valid-for\">";
                ensure!(html.contains(range), "no section \"Valid for\"");
                html = html.replacen(range, &(lists::figure(&name, &alt) + range), 1);
            }
        }
    }
    Ok(html)
}

fn exists(page_folder: &Path, address: &str) -> bool {
    page_folder.join(address.trim_start_matches("../")).is_file()
}

/// Writes the documentation of the interfaces beside the guide: rustdoc and pdoc, which keep their
/// own links and styles. The Python package must be installed in `target/python`, as `.ci/python`
/// does; pdoc is installed there if it is missing.
///
/// # Errors
/// A failure of cargo, pip or pdoc, a package that is not installed.
pub fn write_api(page_folder: &Path) -> Result<()> {
    let [rust, python] = ["rust", "python"].map(|name| page_folder.join(name));
    remove(&rust)?;
    copy(&docs::write()?.with_file_name(""), &rust)?;
    // A lock of cargo.
    let _ = std::fs::remove_file(rust.join(".lock"));
    remove(&python)?;
    let interpreter = root().join("target/python/bin/python");
    ensure!(interpreter.is_file(), "target/python is missing: run .ci/python");
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "pdoc"];
    run(Command::new(&interpreter).args(pip))?;
    let pdoc = ["-m", "pdoc", "--docformat", "numpy", "asperity", "--output-directory"];
    run(Command::new(&interpreter).args(pdoc).arg(&python))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    /// All files that end like this.
    fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        entries.filter(|path| path.extension().is_some_and(|found| found == extension)).collect()
    }

    #[test]
    fn the_guide_has_no_dangling_link_and_no_inline_script_or_style() {
        let page = tempfile::tempdir().unwrap();
        let front = write(page.path()).unwrap();
        let pages = files(front.parent().unwrap(), "html");
        assert_eq!(pages.len(), chapters::ALL.len());
        // The other pages are not there.
        let others = ["index.html", "gallery.html", "models.html"];
        let others = others.map(|name| site::normal(&page.path().join(name)));
        assert_eq!(link_tests::violations(&pages, &others).unwrap(), Vec::<String>::new());
        for path in pages {
            let text = fs::read_to_string(&path).unwrap();
            assert!(text.contains("content=\"default-src 'none';"), "{}", path.display());
            assert!(!text.contains("unsafe-inline"), "{}", path.display());
            for tag in text.split('<').skip(1).map(|tag| tag.split('>').next().unwrap()) {
                let inline = [" style=\"", " onclick=\"", "javascript:"];
                assert!(!inline.iter().any(|part| tag.contains(part)), "{tag}");
                let name = tag.split(' ').next().unwrap();
                assert!(name != "style" && (name != "script" || tag.contains(" src=")), "{tag}");
            }
        }
        let index = fs::read_to_string(front.with_file_name("search.json")).unwrap();
        let entries: Vec<serde_json::Value> = serde_json::from_str(&index).unwrap();
        let is_ke = |entry: &serde_json::Value| entry["address"] == "ke.html#known-errors";
        assert!(entries.len() > 150 && entries.iter().any(is_ke), "{}", entries.len());
        assert!(index.len() < 400_000, "{} bytes", index.len());
        let has = |entry: &serde_json::Value| {
            entry["text"].as_str().is_some_and(|text| text.contains("plasticity index ψ"))
        };
        let found = entries.iter().find(|entry| entry["address"] == "gw.html#valid-for").unwrap();
        assert!(has(found), "{found}");
    }

    #[test]
    fn documentation_of_interfaces_is_listed_where_it_is() {
        let page = tempfile::tempdir().unwrap();
        assert!(!exists(page.path(), API[0].0));
        save(&page.path().join("rust/index.html"), b"").unwrap();
        assert!(exists(page.path(), API[0].0) && !exists(page.path(), API[1].0));
    }
}
