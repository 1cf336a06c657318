//! Which page shows which file and heading, and where links lead.

use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

use anyhow::{Result, bail};

use super::chapters::{self, Chapter};
use super::links::{DOI, normal};
use super::markdown::{self, Heading, Ids, Target};
use super::source::{self, Fragment, Part};

/// The text of all chapters.
pub struct Site {
    chapters: HashMap<&'static str, Vec<(Fragment, Vec<Heading>)>>,
    /// The page of a file.
    pages: HashMap<PathBuf, String>,
    /// The page and id of a heading of a file.
    anchors: HashMap<(PathBuf, String), String>,
    /// Files that pages link or show, and where their copies are.
    files: BTreeMap<PathBuf, String>,
}

/// The address of a chapter, within the guide.
#[must_use]
pub fn address(chapter: &Chapter) -> String {
    format!("{}.html", chapter.slug)
}

impl Site {
    /// Reads all chapters.
    ///
    /// # Errors
    /// A file or a section that does not exist.
    pub fn read() -> Result<Self> {
        let (mut texts, files) = (HashMap::new(), BTreeMap::new());
        let (mut pages, mut anchors) = (HashMap::new(), HashMap::new());
        for chapter in chapters::all() {
            let page = address(chapter);
            let (mut ids, mut fragments) = (Ids::default(), vec![]);
            for (path, part) in chapter.parts {
                let fragment = source::read(path, *part)?;
                let headings = markdown::headings(&fragment.text, &mut ids);
                for heading in &headings {
                    let key = (fragment.path.clone(), heading.anchor.clone());
                    let address = format!("{page}#{}", heading.id);
                    anchors.entry(key).or_insert(address);
                }
                let is_page = matches!(part, Part::Whole | Part::Head);
                if is_page || !pages.contains_key(&fragment.path) {
                    pages.insert(fragment.path.clone(), page.clone());
                }
                fragments.push((fragment, headings));
            }
            texts.insert(chapter.slug, fragments);
        }
        // Of sections, none stands for the whole.
        pages.insert("README.md".into(), "index.html".into());
        pages.insert("figures".into(), "figures.html".into());
        Ok(Self { chapters: texts, pages, anchors, files })
    }

    /// The headings of a chapter.
    pub fn headings(&self, chapter: &Chapter) -> impl Iterator<Item = &Heading> {
        self.chapters[chapter.slug].iter().flat_map(|(_, headings)| headings)
    }

    /// The words of a chapter before its first heading, and under each of its headings.
    #[must_use]
    pub fn words(&self, chapter: &Chapter) -> (String, Vec<String>) {
        let (mut lead, mut under) = (String::new(), vec![]);
        for (fragment, _) in &self.chapters[chapter.slug] {
            let mut sections = markdown::sections(&fragment.text).into_iter();
            lead += &sections.next().unwrap_or_default();
            under.extend(sections);
        }
        (lead, under)
    }

    /// The html of a chapter's text.
    ///
    /// # Errors
    /// A link that leads nowhere.
    pub fn render(&mut self, chapter: &Chapter) -> Result<String> {
        let fragments = self.chapters[chapter.slug].clone();
        let mut html = String::new();
        for (fragment, headings) in &fragments {
            let with = chapter.equations;
            html += &markdown::render(&fragment.text, headings, with, |link, is_picture| {
                self.resolve(&fragment.path, link, is_picture)
            })?;
        }
        Ok(html)
    }

    /// The address of a copy of a file of the repository.
    pub fn file(&mut self, path: &Path) -> String {
        let plain = ["rs", "py", "toml", "ipynb"];
        let is_code = path.extension().is_some_and(|found| plain.iter().any(|end| found == *end));
        // Browsers show what ends in txt, and save what they do not know.
        let end = if is_code { ".txt" } else { "" };
        let address = format!("files/{}{end}", path.display());
        self.files.insert(path.to_owned(), address.clone());
        address
    }

    /// The files that pages link or show, and the addresses of their copies.
    pub fn files(&self) -> impl Iterator<Item = (&Path, &str)> {
        self.files.iter().map(|(path, address)| (path.as_path(), address.as_str()))
    }

    fn resolve(&mut self, from: &Path, link: &str, is_picture: bool) -> Result<Target> {
        if link.starts_with(DOI) {
            return Ok(Target::Address(link.into()));
        }
        // The guide works where there is no network: an address is text.
        if let Some((_, rest)) = link.split_once("://") {
            return Ok(Target::Text(format!(" ({})", rest.trim_end_matches('/'))));
        }
        // To the pages themselves, from the chapters written for the guide.
        if link.starts_with("../") && link.ends_with("index.html") {
            return Ok(Target::Address(link.into()));
        }
        let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
        let path = match path {
            "" => from.to_owned(),
            path => normal(&from.with_file_name("").join(path)),
        };
        if !anchor.is_empty() {
            let key = (path, anchor.to_owned());
            return match self.anchors.get(&key) {
                Some(address) => Ok(Target::Address(address.clone())),
                None => bail!("{}: {link}: no page of the guide has this heading", from.display()),
            };
        }
        if let Some(page) = self.pages.get(&path).filter(|_| !is_picture) {
            return Ok(Target::Address(page.clone()));
        }
        if !source::root().join(&path).is_file() {
            bail!("{}: {link}: no such file", from.display());
        }
        Ok(Target::Address(self.file(&path)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_between_files_become_links_between_pages() {
        let mut site = Site::read().unwrap();
        let mut to = |from: &str, link: &str| site.resolve(Path::new(from), link, false);
        let address = |text: &str| Target::Address(text.into());
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
        assert_eq!(outside, Target::Text(" (example.org/a)".into()));
        for wrong in ["nowhere.md", "#nowhere"] {
            let message = to("README.md", wrong).unwrap_err().to_string();
            assert!(message.starts_with("README.md: ") && message.contains(wrong), "{message}");
        }
    }
}
