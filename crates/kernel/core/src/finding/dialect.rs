//! Texts with marked terms, and how their readers call these.

/// How a reader calls the terms of findings and errors, which stand in backticks there: keys of
/// scene files, quantities, names of models, commands and options of the program.
///
/// ```
/// use asperity_core::{AsWritten, Dialect};
///
/// struct Spoken;
/// impl Dialect for Spoken {
///     fn term(&self, term: &str) -> String {
///         term.replace('_', " ")
///     }
/// }
/// let text = "`yield_strength` is missing: see `asperity list materials`";
/// assert_eq!(Spoken.say(text), "yield strength is missing: see asperity list materials");
/// assert_eq!(AsWritten.say(text), "yield_strength is missing: see `asperity list materials`");
/// ```
pub trait Dialect {
    /// What the reader calls a term.
    fn term(&self, term: &str) -> String;

    /// A text in the terms of the reader.
    fn say(&self, marked: &str) -> String {
        let part = |(k, part): (usize, &str)| match k % 2 {
            0 => part.into(),
            _ => self.term(part),
        };
        marked.split('`').enumerate().map(part).collect()
    }
}

/// The terms of scene files and of the program, whose commands stay in backticks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AsWritten;

impl Dialect for AsWritten {
    fn term(&self, term: &str) -> String {
        if term.starts_with("asperity ") { format!("`{term}`") } else { term.into() }
    }
}
