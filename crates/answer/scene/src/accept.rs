//! The codes of warnings and notes that a scene may accept.

use asperity::Code;

use crate::document::Document;
use crate::error::SceneError;
use crate::scene_file::SceneFile;

/// The codes of these names; an unknown one is refused.
pub(crate) fn codes(document: &Document<'_>, names: &[String]) -> Result<Vec<Code>, SceneError> {
    let known = names.iter().map(|name| Code::named(name)).collect::<Result<_, _>>();
    known.map_err(|reason| SceneError::Refused { at: document.place("accept"), reason })
}

impl SceneFile {
    /// Accepts warnings and notes of these codes, too.
    #[must_use]
    pub fn accepting(mut self, codes: &[Code]) -> Self {
        self.spec.accept.extend_from_slice(codes);
        self.warnings = self.warnings.silenced(codes);
        self
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::{Path, PathBuf};

    use super::Code;

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

    #[test]
    fn every_code_has_its_findings() {
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().parent().unwrap();
        let mut files = vec![];
        sources(crates, &mut files);
        let all: String = files.iter().map(|file| fs::read_to_string(file).unwrap()).collect();
        for code in Code::ALL {
            assert!(all.contains(&format!("Code::{code:?}")), "{code}");
        }
    }
}
