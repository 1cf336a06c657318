//! The codes of warnings and notes that a scene may accept.

use asperity::Code;

use crate::document::Document;
use crate::error::SceneError;
use crate::scene_file::SceneFile;

/// Refuses a code that no warning and no note has.
pub(crate) fn check(document: &Document<'_>, accept: &[String]) -> Result<(), SceneError> {
    let known = accept.iter().try_for_each(|code| Code::named(code).map(drop));
    known.map_err(|reason| SceneError::Refused { at: document.place("accept"), reason })
}

impl SceneFile {
    /// Accepts warnings and notes of these codes, too.
    ///
    /// # Errors
    /// Those of [`Code::named`].
    pub fn accepting(mut self, codes: &[String]) -> Result<Self, String> {
        codes.iter().try_for_each(|code| Code::named(code).map(drop))?;
        self.spec.accept.extend_from_slice(codes);
        self.warnings = self.warnings.silenced(codes);
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::{Path, PathBuf};

    use super::Code;

    const QUOTE: char = '"';

    fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                sources(&path, found);
            } else if path.extension().is_some_and(|end| end == "rs") {
                found.push(path);
            }
        }
    }

    /// Each code stands in the sources, and those of scans and scenes are all known.
    #[test]
    fn the_codes_are_those_of_the_sources() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().parent().unwrap();
        let mut files = vec![];
        for group in fs::read_dir(crates).unwrap() {
            let group = group.unwrap().path();
            let members = fs::read_dir(&group).unwrap().map(|entry| entry.unwrap().path());
            for folder in members.chain([group.clone()]).map(|one| one.join("src")) {
                if folder.is_dir() {
                    sources(&folder, &mut files);
                }
            }
        }
        let all: String = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
        let known: BTreeSet<&str> = Code::all().map(|code| code.name).collect();
        for call in [
            "Finding::warning(",
            "Finding::note(",
            "sheet.note(",
            "sheet.warn(",
            "output::note(",
            "output::warn(",
            " note(",
            " warning(",
            "warn_text(py, ",
            "Finding::refusal(",
            "at), ",
        ] {
            for after in all.split(call).skip(1) {
                let quoted = after.trim_start().strip_prefix(QUOTE);
                let code = quoted.filter(|code| code.starts_with(char::is_lowercase));
                let code = code.and_then(|code| code.split(QUOTE).next());
                assert!(code.is_none_or(|code| known.contains(code)), "{code:?}");
            }
        }
        for code in known {
            assert!(all.contains(&format!("\"{code}\"")), "{code}");
        }
    }
}
