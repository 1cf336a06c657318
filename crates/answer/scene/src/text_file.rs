//! Files of text: scenes, and tables of heights and of measurements.

use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::error::{Place, SceneError};

/// The largest size of a file of text.
const MOST_BYTES: u64 = 1 << 20;

/// Advice for a spreadsheet that was given as a table.
pub(crate) const SAVE_AS_CSV: &str = "save the sheet as csv in UTF-8";

/// The text of a file; `place` gives its place in an error, and `advice` the remedy for a file that
/// is no text.
pub(crate) fn read_text(
    path: &Path,
    advice: &str,
    place: impl FnOnce() -> Place,
) -> Result<String, SceneError> {
    let mut bytes = vec![];
    let read = File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes));
    let is_text = |text: &String| !text.contains(|c: char| matches!(c, '\0'..='\u{8}'));
    let reason = match read {
        Err(error) => error.to_string(),
        Ok(count) if count as u64 > MOST_BYTES => {
            format!("the file has more than {MOST_BYTES} bytes: leave out rows or digits; {advice}")
        }
        Ok(_) => match String::from_utf8(bytes).ok().filter(is_text) {
            Some(mut text) => {
                // The end of a text in DOS.
                text.truncate(text.trim_end_matches('\u{1a}').len());
                return Ok(text);
            }
            None => format!("the file is not a text file in UTF-8; {advice}"),
        },
    };
    Err(SceneError::refused(place(), format!("cannot be read: {reason}")))
}

/// The first 60 characters of a text.
pub(crate) fn shorten(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}...", &text[..end]).into(),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_named_by_their_length() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        // The limit lies within a character.
        std::fs::write(&path, format!("#{}", "\u{b5}".repeat(1 << 19))).unwrap();
        let refused = read_text(&path, "advice", || Place::field("scene"));
        assert!(matches!(refused, Err(SceneError::Refused { .. })), "{refused:?}");
    }

    #[test]
    fn a_text_may_end_in_the_sign_of_dos_for_its_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        std::fs::write(&path, "a = 1\r\n\u{1a}").unwrap();
        assert_eq!(read_text(&path, "", || Place::field("scene")).unwrap(), "a = 1\r\n");
    }

    #[test]
    fn long_texts_are_cut_between_characters() {
        let long = "µ".repeat(1000);
        assert_eq!(shorten(&long).chars().count(), 63);
    }
}
