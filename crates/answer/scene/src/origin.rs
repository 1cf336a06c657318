//! Where the numbers of a scene were written.

use std::collections::BTreeMap;
use std::path::PathBuf;

use crate::error::Place;

/// Where each number of a scene was written: in a line of a file, or as a keyword.
#[derive(Debug, Clone, Default)]
pub struct Provenance {
    pub(crate) file: Option<PathBuf>,
    /// The line of each key and of each section; none for keywords.
    pub(crate) lines: BTreeMap<String, usize>,
    /// The keys of numbers with a unit.
    pub(crate) stated: Vec<String>,
    /// The scans that the scene names.
    pub(crate) files: Vec<PathBuf>,
}

impl Provenance {
    /// The place of a key; a missing key has the line of its section.
    #[must_use]
    pub fn place(&self, path: &str) -> Place {
        let section = path.rsplit_once(['.', '[']).map_or("", |(section, _)| section);
        let line = self.lines.get(path).or_else(|| self.lines.get(section)).copied();
        // The top of a file is its first line.
        let line = line.or(self.lines.get("").copied());
        Place { file: self.file.clone(), line, field: path.into() }
    }

    /// Whether a number was given with its unit, by its path or its key in any section.
    #[must_use]
    pub fn is_stated(&self, key: &str) -> bool {
        self.stated.iter().any(|path| path == key || path.ends_with(&format!(".{key}")))
    }
}
