//! Words of a list: found, or refused with the nearest and with all of them.

use std::borrow::Cow;

use crate::{Place, SceneError};

/// Words with what they stand for.
pub(crate) type Words<'a, T> = [(&'a str, T)];

/// What a word stands for. `found` is what to call that which is no word; `or` is what is allowed
/// beside the words, if anything.
pub(crate) fn meaning<T: Copy>(
    at: &Place,
    word: Result<&str, String>,
    words: &Words<'_, T>,
    or: &str,
) -> Result<T, SceneError> {
    let known = || words.iter().map(|(word, _)| *word);
    let (found, near) = match word {
        Ok(word) => {
            if let Some((_, meaning)) = words.iter().find(|(known, _)| *known == word) {
                return Ok(*meaning);
            }
            (quoted(word), nearest(word, known()).map(Into::into))
        }
        Err(found) => (found, None),
    };
    let or = (!or.is_empty()).then(|| or.to_string());
    let needed: Vec<String> = known().map(|word| format!("{word:?}")).chain(or).collect();
    Err(SceneError::Value { at: Box::new(at.clone()), found, near, needed: needed.join(" or ") })
}

/// The known word nearest to a mistyped one, if one is near: at most two slips, fewer in short
/// words, whatever the case.
pub(crate) fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let mistyped = word.to_lowercase();
    let distance = |k: &str| strsim::osa_distance(&mistyped, &k.to_lowercase());
    let allowed = (mistyped.chars().count() / 2).min(2);
    let nearest = known.into_iter().min_by_key(|k| distance(k))?;
    (distance(nearest) <= allowed).then_some(nearest)
}

/// A text from a file, for an error: quoted, on one line, and not longer than a line.
pub(crate) fn quoted(text: &str) -> String {
    format!("{:?}", shortened(text))
}

/// The beginning of a text that may be of any length.
pub(crate) fn shortened(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(60) {
        Some((end, _)) => format!("{}...", &text[..end]).into(),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_words_are_near_and_far_ones_are_not() {
        let known = ["plane", "quadratic", "none", "SH"];
        for (word, wanted) in [
            ("plain", Some("plane")),
            ("QUADRATIC", Some("quadratic")),
            ("sh", Some("SH")),
            ("noen", Some("none")),
            ("x", None),
            ("parabola", None),
            ("", None),
        ] {
            assert_eq!(nearest(word, known), wanted, "{word}");
        }
        assert_eq!(nearest("x", []), None);
    }

    #[test]
    fn long_texts_are_cut_between_characters() {
        let long = "µ".repeat(1000);
        assert_eq!(shortened(&long).chars().count(), 63);
        assert_eq!(quoted("a\nb"), "\"a\\nb\"");
    }
}
