//! Which page shows which file and heading, and where links lead.

use std::collections::{BTreeMap, HashMap};
use std::path::{Component, Path, PathBuf};

use anyhow::{Result, ensure};

use super::chapters::{ALL, Chapter};
use super::markdown::{Ids, LinkTarget, Outline};
use super::parts;
use crate::folder::root;

/// The only address outside that a page may link.
pub const DOI: &str = "https://doi.org/";

/// What a chapter shows, one after the other.
pub enum Piece {
    /// A markdown text with the path of its file, from which its links start.
    Text(PathBuf, String, Outline),
    /// A picture of laws, by their name.
    Laws(&'static str),
}

/// A chapter with what it shows.
pub type Shown = (&'static Chapter, Vec<Piece>);

/// Pages of files and headings, and the files that pages link or show.
#[derive(Default)]
pub struct Site {
    /// The page of a file, and the place on a page of a heading, `file#heading`.
    places: HashMap<String, String>,
    /// The addresses of the copies of files.
    pub files: BTreeMap<PathBuf, String>,
}

impl Site {
    /// Reads all chapters.
    ///
    /// # Errors
    /// A file or a section that does not exist.
    pub fn read() -> Result<(Self, Vec<Shown>)> {
        let (mut site, mut all) = (Self::default(), vec![]);
        for chapter in ALL.iter() {
            let page = chapter.address();
            let (mut ids, mut pieces) = (Ids::default(), vec![]);
            for part in &chapter.parts {
                let Some((path, text)) = parts::markdown(part)? else {
                    pieces.push(Piece::Laws(part));
                    continue;
                };
                let outline = Outline::new(&text, &mut ids);
                for heading in &outline.headings {
                    let address = format!("{page}#{}", heading.id);
                    let key = format!("{path}#{}", heading.anchor);
                    site.places.entry(key).or_insert(address);
                }
                // Of sections and code, none stands for the whole.
                if *part == path || !site.places.contains_key(path) {
                    site.places.insert(path.into(), page.clone());
                }
                pieces.push(Piece::Text(path.into(), text, outline));
            }
            all.push((chapter, pieces));
        }
        site.places.insert("README.md".into(), "index.html".into());
        site.places.insert("figures".into(), "figures.html".into());
        Ok((site, all))
    }

    /// The address of a copy of a file of the repository.
    fn file(&mut self, path: &Path) -> String {
        let plain = ["rs", "py", "toml", "ipynb"];
        let is_code = path.extension().is_some_and(|found| plain.iter().any(|end| found == *end));
        // Browsers show what ends in txt, and save what they do not know.
        let end = if is_code { ".txt" } else { "" };
        let address = format!("files/{}{end}", path.display());
        self.files.insert(path.to_owned(), address.clone());
        address
    }

    /// Where a link of a file leads.
    ///
    /// # Errors
    /// A link that leads nowhere.
    pub fn resolve(&mut self, from: &Path, link: &str, is_picture: bool) -> Result<LinkTarget> {
        // The guide works where there is no network: an address is text.
        if let Some((_, rest)) = link.split_once("://").filter(|_| !link.starts_with(DOI)) {
            return Ok(LinkTarget::Text(format!(" ({})", rest.trim_end_matches('/'))));
        }
        // A link of rustdoc, a mail.
        if link.contains("::") || link.contains('@') {
            return Ok(LinkTarget::Text(String::new()));
        }
        // To the pages themselves, from the chapters and lists written for the guide.
        let is_page = ALL.iter().any(|chapter| chapter.address() == link);
        let is_front = link.starts_with("../") && link.ends_with("index.html");
        if link.starts_with(DOI) || is_page || is_front {
            return Ok(LinkTarget::Address(link.into()));
        }
        let (path, anchor) = link.split_once('#').map_or((link, None), |(p, a)| (p, Some(a)));
        let path = match path {
            "" => from.to_owned(),
            path => normal(&from.with_file_name("").join(path)),
        };
        let key = path.display().to_string() + &anchor.map_or(String::new(), |a| format!("#{a}"));
        if let Some(place) = self.places.get(&key).filter(|_| !is_picture) {
            return Ok(LinkTarget::Address(place.clone()));
        }
        let from = from.display();
        ensure!(anchor.is_none(), "{from}: {link}: no page of the guide has this heading");
        ensure!(root().join(&path).is_file(), "{from}: {link}: no such file");
        Ok(LinkTarget::Address(self.file(&path)))
    }
}

/// Without `.` and `..`.
#[must_use]
pub fn normal(path: &Path) -> PathBuf {
    let mut normal = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir => drop(normal.pop()),
            part => normal.push(part),
        }
    }
    normal
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_between_files_become_links_between_pages() {
        let (mut site, _) = Site::read().unwrap();
        let mut to = |from: &str, link: &str| site.resolve(Path::new(from), link, false);
        let address = |text: &str| LinkTarget::Address(text.into());
        let cli = "crates/asperity-cli/README.md";
        let files = to(cli, "../asperity-topography/README.md#files").unwrap();
        assert_eq!(files, address("surface-files.html#files"));
        let which = "crates/asperity-web/guide/which-model.md";
        let section = to(which, "#which-model-holds").unwrap();
        assert_eq!(section, address("which-model.html#which-model-holds"));
        assert_eq!(to("README.md", "figures/").unwrap(), address("figures.html"));
        let code = to("README.md", "crates/asperity-bem/src/random_surface/mod.rs").unwrap();
        assert_eq!(code, address("files/crates/asperity-bem/src/random_surface/mod.rs.txt"));
        let outside = to(cli, "https://example.org/a/").unwrap();
        assert_eq!(outside, LinkTarget::Text(" (example.org/a)".into()));
        for wrong in ["nowhere.md", "#nowhere"] {
            let message = to("README.md", wrong).unwrap_err().to_string();
            assert!(message.starts_with("README.md: ") && message.contains(wrong), "{message}");
        }
    }
}
