//! Errors about unknown keys, wrong kinds of values and syntax; they suggest what was meant.

use asperity::{nearest_hint, nearest_name};
use toml::de::Error;

use super::Document;
use crate::error::{Place, SceneError};
use crate::keys::{Key, section_and_name};
use crate::quantity::{both_ends, notation_hint};
use crate::text_file::shorten;

impl Document<'_> {
    /// The error for a value of the wrong kind, by the message of serde, whose end is what was
    /// expected.
    pub(crate) fn wrong(&self, path: &str, message: &str) -> SceneError {
        let meaning = Key::meaning(path);
        let span = self.values.get(path).map(|(span, _)| span.clone());
        let found = self.text.get(span.unwrap_or_default()).unwrap_or_default();
        let found = shorten(found).replace(char::is_control, " ");
        let text = found.trim_matches('"');
        let ends = Key::may_have_range(path).then(|| both_ends(text)).flatten();
        if let Some(hint) = ends {
            return SceneError::notation(self.place(path), &found, &hint);
        }
        let expected = message.rsplit_once(", expected ").map_or(message, |(_, needed)| needed);
        let needed = match expected {
            "f64" if found.starts_with(['[', '{']) && Key::may_have_range(path) => {
                format!("a number, or two in brackets as the ends of a range ({meaning}),")
            }
            "f64" => format!("a number ({meaning})"),
            "a boolean" => "true or false".into(),
            "a sequence" => format!("a list ({meaning})"),
            "path string" => format!("the path of a file, in quotes ({meaning}),"),
            "string only" | "a string" => "a name in quotes".into(),
            names => names.replace('`', "\""),
        };
        // A number in quotes is an example, not a name.
        let names = needed.split('"').skip(1).step_by(2);
        let names = names.filter(|name| !name.starts_with(|c: char| c.is_ascii_digit()));
        let near = nearest_name(text, names);
        SceneError::of_names(self.place(path), &found, near, &needed)
    }

    /// The error for an unknown key of a section.
    pub(super) fn unknown(&self, path: &str, keys: &[&str]) -> SceneError {
        let (section, name) = section_and_name(path);
        let mut allowed = format!("the keys here are {}", keys.join(", "));
        let elsewhere = Key::find(section, name);
        let near = match elsewhere {
            None => nearest_name(name, keys.iter().copied()),
            Some(_) => None,
        };
        if let Some(key) = elsewhere {
            allowed = format!("it belongs to {}; {allowed}", key.home());
        }
        SceneError::wrong(self.place(path), format!("not known{}: {allowed}", nearest_hint(near)))
    }

    /// An error of TOML syntax.
    pub(super) fn toml_error(&self, error: &Error) -> SceneError {
        let line = self.line(error.span().map_or(0, |span| span.start));
        let at = Place { line, ..self.origin.place("TOML") };
        let found = self.text.lines().nth(at.line.unwrap_or(1) - 1).unwrap_or_default();
        let reason = error.message().replace('\n', ", ");
        let advice = other_notation(found).unwrap_or_default();
        let reason = format!("{advice}{reason}: {:?} was found", shorten(found.trim()));
        SceneError::refused(at, reason)
    }
}

/// Advice for a line whose number is written in another notation, or that begins a body.
fn other_notation(line: &str) -> Option<String> {
    if line.trim() == "[body]" {
        return Some("each of two bodies is written [[body]]; ".into());
    }
    let value = line.split_once('=')?.1.split('#').next()?.trim();
    let ends = || both_ends(&value.replace('"', ""));
    let hint = notation_hint(value).map(String::from).or_else(ends)?;
    Some(format!("{value} {hint}; "))
}
