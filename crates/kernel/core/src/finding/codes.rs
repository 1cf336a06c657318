//! What the codes of warnings and notes mean, and what to do.

use crate::text::{nearest_hint, nearest_name};

/// A code of warnings and notes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Code {
    /// Its name, in lower case with dashes: `few-contacts`.
    pub name: &'static str,
    /// What its findings mean, with the threshold.
    pub meaning: &'static str,
    /// When its findings are harmless.
    pub harmless: &'static str,
    /// What to do.
    pub remedy: &'static str,
}

impl Code {
    /// All codes, sorted by their names.
    pub fn all() -> impl Iterator<Item = Self> {
        lines().filter_map(|line| {
            let mut fields = line.split(" | ");
            let mut next = || fields.next();
            Some(Self { name: next()?, meaning: next()?, harmless: next()?, remedy: next()? })
        })
    }

    /// The code of this name.
    ///
    /// # Errors
    /// A message with the nearest name, where there is no such code.
    pub fn named(name: &str) -> Result<Self, String> {
        Self::all().find(|code| code.name == name).ok_or_else(|| {
            let near = nearest_hint(nearest_name(name, Self::all().map(|code| code.name)));
            format!("{name:?} is no code of a finding{near}: see the list of findings")
        })
    }
}

/// The lines of the file, without comments and blank ones.
fn lines() -> impl Iterator<Item = &'static str> {
    let all = include_str!("codes.txt").lines();
    all.filter(|line| !line.trim().is_empty() && !line.starts_with('#'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_sorted_and_have_whole_texts() {
        assert!(lines().all(|line| line.split(" | ").count() == 4));
        assert!(Code::all().is_sorted_by(|a, b| a.name < b.name));
        for code in Code::all() {
            assert_eq!(Code::named(code.name), Ok(code));
            for text in [code.meaning, code.harmless, code.remedy] {
                assert!(text.len() > 1 && text.ends_with('.'), "{}: {text:?}", code.name);
                assert_eq!(text.matches('`').count() % 2, 0, "{}: {text:?}", code.name);
            }
        }
        let refused = Code::named("few-contact").unwrap_err();
        assert!(refused.contains("(the nearest is \"few-contacts\")"), "{refused}");
    }
}
