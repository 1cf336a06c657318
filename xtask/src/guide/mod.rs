//! The guide: READMEs, definitions and chapters of the repository as html, with a search over
//! titles, headings and text.
//!
//! [`chapters`] lists the pages, `source` reads their text, `markdown` writes it as html,
//! `site` knows where each file and heading went, `laws` draws the models, and `links` checks
//! the result.

pub mod api;
pub mod chapters;
mod equations;
mod laws;
pub mod links;
mod lists;
mod markdown;
mod site;
mod source;
mod template;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use serde::Serialize;

use chapters::{Chapter, Extra};
use site::Site;
pub use source::root;

/// The folder of the guide within that of the page.
pub const FOLDER: &str = "guide";
/// The documentation of the interfaces beside the guide, listed where it was written.
const API: [(&str, &str); 2] =
    [("../rust/index.html", "Rust crates"), ("../python/asperity.html", "Python package")];
/// Style and search, copied as they are; colours and equations look as in the explorer.
const PARTS: [&str; 3] = ["www/common.css", "guide/guide.css", "guide/search.js"];

/// A page or a section that can be searched.
#[derive(Serialize)]
struct Entry<'a> {
    page: &'a str,
    heading: &'a str,
    address: String,
    /// The words below it.
    text: String,
}

/// Writes the guide to `guide/` in the folder of the page; returns its front page.
///
/// # Errors
/// A file that cannot be read or written, a section or heading that does not exist, a picture that
/// cannot be drawn, a link that dangles or leads outside.
pub fn write(page_folder: &Path) -> Result<PathBuf> {
    let folder = page_folder.join(FOLDER);
    if folder.exists() {
        fs::remove_dir_all(&folder).with_context(|| folder.display().to_string())?;
    }
    let mut site = Site::read()?;
    let api = API.iter().filter(|(address, _)| exists(&folder, address)).copied().collect();
    let frame = template::Frame { api };
    let mut entries = vec![];
    for chapter in chapters::all() {
        let address = site::address(chapter);
        let (lead, under) = site.words(chapter);
        let page = chapter.title;
        entries.push(Entry { page, heading: "", address: address.clone(), text: plain(&lead) });
        for (heading, text) in site.headings(chapter).zip(&under) {
            let address = format!("{address}#{}", heading.id);
            entries.push(Entry { page, heading: &heading.text, address, text: plain(text) });
        }
    }
    let index = serde_json::to_string(&entries)?;
    save(&folder.join("search.json"), index.as_bytes())?;
    let mut pages = vec![];
    for chapter in chapters::all() {
        let body = body(&folder, &mut site, chapter)?;
        let path = folder.join(site::address(chapter));
        save(&path, frame.page(chapter, &body).as_bytes())?;
        pages.push(path);
    }
    for (from, to) in site.files() {
        copy(&root().join(from), &folder.join(to))?;
    }
    for part in PARTS {
        let path = root().join("crates/asperity-web").join(part);
        copy(&path, &folder.join(path.file_name().unwrap_or_default()))?;
    }
    let violations = links::violations(&pages, &[links::normal(&folder.join(template::EXPLORER))])?;
    ensure!(violations.is_empty(), "links of the guide:\n{}", violations.join("\n"));
    Ok(folder.join("index.html"))
}

/// Words with one space between them.
fn plain(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The documentation of the interfaces that does not stand beside the guide of a page.
#[must_use]
pub fn missing_api(page_folder: &Path) -> Vec<&'static str> {
    let folder = page_folder.join(FOLDER);
    let missing = API.iter().filter(|(address, _)| !exists(&folder, address));
    missing.map(|(address, _)| address.trim_start_matches("../")).collect()
}

fn exists(folder: &Path, address: &str) -> bool {
    links::normal(&folder.join(address)).is_file()
}

/// The html of a chapter below its title.
fn body(folder: &Path, site: &mut Site, chapter: &Chapter) -> Result<String> {
    let mut body = site.render(chapter)?;
    match chapter.extra {
        Extra::None => {}
        Extra::Models => body += &lists::models(),
        Extra::Figures => body += &lists::figures(site)?,
        Extra::Laws(laws) => {
            let picture = laws.draw().with_context(|| format!("the laws of {}", chapter.slug))?;
            let name = format!("laws/{}.svg", chapter.slug);
            save(&folder.join(&name), picture.svg.as_bytes())?;
            let figure = template::figure(&name, &picture.alt);
            let range = "<h2 id=\"valid-for\">";
            ensure!(body.contains(range), "{} has no section \"Valid for\"", chapter.parts[0].0);
            body = body.replacen(range, &(figure + range), 1);
        }
    }
    Ok(body)
}

fn save(path: &Path, bytes: &[u8]) -> Result<()> {
    let folder = path.parent().unwrap_or(path);
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    fs::write(path, bytes).with_context(|| path.display().to_string())
}

fn copy(from: &Path, to: &Path) -> Result<()> {
    save(to, &fs::read(from).with_context(|| from.display().to_string())?)
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(pages.len(), chapters::all().count());
        // Checked again here: the explorer is the only file that is not there.
        let explorer = links::normal(&page.path().join("index.html"));
        assert_eq!(links::violations(&pages, &[explorer]).unwrap(), Vec::<String>::new());
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
        let folder = page.path().join(FOLDER);
        assert!(!exists(&folder, API[0].0));
        save(&page.path().join("rust/index.html"), b"").unwrap();
        assert!(exists(&folder, API[0].0) && !exists(&folder, API[1].0));
        assert_eq!(missing_api(page.path()), ["python/asperity.html"]);
    }
}
