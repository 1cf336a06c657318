//! The text of a scene file: its keys and their places.

use std::borrow::Cow;
use std::collections::HashSet;
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use asperity::ContactError;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue, Error};
use toml::{Table, Value};

use crate::quantity::{QuantityError, in_si};
use crate::template::{counterface_keys, keys_of};
use crate::{Place, SceneError};

/// The largest size of a scene file or of a table of heights.
const MOST_BYTES: u64 = 1 << 20;
/// The largest depth of a key: `body[2].hardness`, `options.displacement.zeta`.
const DEEPEST: usize = 3;

/// A text in TOML with the places of its keys.
#[derive(Debug)]
pub(crate) struct Document<'a> {
    file: Option<&'a Path>,
    /// Base of relative paths; `None` for keywords, which have no lines.
    directory: Option<&'a Path>,
    /// The text with plain numbers instead of numbers with units.
    pub(crate) text: Cow<'a, str>,
    /// Every key with its range; a table comes before its keys.
    pub(crate) keys: Vec<(String, Range<usize>)>,
    /// The keys of numbers with a unit.
    pub(crate) stated: Vec<String>,
}

/// The keys of `[surface]` used by one module.
#[derive(Deserialize)]
struct InSurface<T> {
    surface: T,
}

/// The section of the second of two rough surfaces.
pub(crate) const COUNTERFACE: &str = "surface.counterface";

/// The keys of the second surface used by one module.
#[derive(Deserialize)]
struct OfCounterface<T> {
    counterface: T,
}

impl<'a> Document<'a> {
    /// The keys of a text, with its numbers in SI units.
    pub(crate) fn new(
        file: Option<&'a Path>,
        directory: Option<&'a Path>,
        text: &'a str,
    ) -> Result<Self, SceneError> {
        let mut document =
            Self { file, directory, text: text.into(), keys: vec![], stated: vec![] };
        let root = DeTable::parse(text).map_err(|error| document.toml_error(&error))?;
        let (span, table) = (root.span(), root.into_inner());
        let in_si = in_si(text, &table);
        document.index(String::new(), span, &DeValue::Table(table), DEEPEST);
        let (in_si, stated) = in_si.map_err(|QuantityError { path, found, near, needed }| {
            let (at, found) = (document.place(&path), format!("{:?}", shorten(&found)));
            SceneError::Value { at, found, near, needed }
        })?;
        document.stated = stated;
        if in_si != text {
            // The ranges of the keys in the rewritten text.
            document.keys.clear();
            document.text = in_si.into();
            let text = document.text.clone();
            let root = DeTable::parse(&text).map_err(|error| document.toml_error(&error))?;
            document.index(String::new(), root.span(), &DeValue::Table(root.into_inner()), DEEPEST);
        }
        Ok(document)
    }

    /// The keys of `T` at the top of the text; other keys are ignored.
    pub(crate) fn keys<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        toml::from_str(&self.text).map_err(|error| self.explain(&error))
    }

    /// The keys of `T` in `[surface]`; other keys are ignored.
    pub(crate) fn surface<T: DeserializeOwned>(&self) -> Result<T, SceneError> {
        self.keys::<InSurface<T>>().map(|keys| keys.surface)
    }

    /// The keys of `T` of the surface described in `section`; other keys are ignored.
    pub(crate) fn rough<T: DeserializeOwned>(&self, section: &str) -> Result<T, SceneError> {
        match section == COUNTERFACE {
            true => self.surface::<OfCounterface<T>>().map(|keys| keys.counterface),
            false => self.surface(),
        }
    }

    /// The whole text. An unknown key at the top or of a surface is refused here, in other sections
    /// by serde, because each is one struct.
    pub(crate) fn table(&self) -> Result<Table, SceneError> {
        let table: Table = self.keys()?;
        let surface = table.get("surface").and_then(Value::as_table);
        let counterface = surface.and_then(|keys| keys.get("counterface")?.as_table());
        let sections = [
            ("", Some(&table), keys_of("")),
            ("surface", surface, keys_of("surface")),
            (COUNTERFACE, counterface, counterface_keys()),
        ];
        for (section, keys, known) in sections {
            let unknown = keys.into_iter().flat_map(Table::keys);
            let unknown = unknown.filter(|name| !known.contains(&name.as_str()));
            let unknown: HashSet<String> =
                unknown.map(|name| joined(section, &shorten(name))).collect();
            let unknown = self.keys.iter().filter(|(path, _)| unknown.contains(path));
            if let Some((path, _)) = unknown.min_by_key(|(_, range)| range.start) {
                return Err(self.unknown(path, &known));
            }
        }
        Ok(table)
    }

    fn index(&mut self, path: String, span: Range<usize>, value: &DeValue<'_>, deep: usize) {
        match value {
            DeValue::Table(table) if deep > 0 => {
                for (key, value) in table {
                    let (a, b) = (key.span(), value.span());
                    let (path, span) = (
                        joined(&path, &shorten(key.get_ref())),
                        a.start.min(b.start)..a.end.max(b.end),
                    );
                    self.index(path, span, value.get_ref(), deep - 1);
                }
            }
            DeValue::Array(items) if deep > 0 => {
                for (item, number) in items.iter().zip(1..) {
                    self.index(format!("{path}[{number}]"), item.span(), item.get_ref(), deep - 1);
                }
            }
            _ => {}
        }
        self.keys.push((path, span));
    }

    /// An error of TOML syntax.
    fn toml_error(&self, error: &Error) -> SceneError {
        let at = self.at("TOML", error.span().map_or(0, |span| span.start));
        let found = self.text.lines().nth(at.line.unwrap_or(1) - 1).unwrap_or_default();
        let reason = error.message().replace('\n', ", ");
        let advice = if decimal_comma(found) { "write a decimal point, as in 0.3; " } else { "" };
        let reason = format!("{advice}{reason}: {:?} was found", shorten(found.trim()));
        SceneError::Syntax { at, reason }
    }

    fn at(&self, field: &str, offset: usize) -> Box<Place> {
        let before = self.text.bytes().take(offset).filter(|byte| *byte == b'\n');
        let line = self.directory.map(|_| 1 + before.count());
        Box::new(Place { file: self.file.map(Path::to_path_buf), line, field: field.into() })
    }

    /// A path relative to the scene file.
    pub(crate) fn path(&self, path: &Path) -> PathBuf {
        self.directory.unwrap_or(Path::new("")).join(path)
    }

    fn range(&self, path: &str) -> Option<&Range<usize>> {
        self.keys.iter().find(|(key, _)| key == path).map(|(_, range)| range)
    }

    pub(crate) fn has(&self, path: &str) -> bool {
        self.range(path).is_some()
    }

    /// The place of a key; a missing key has the line of its section.
    pub(crate) fn place(&self, path: &str) -> Box<Place> {
        let section =
            || self.range(path.rsplit_once(['.', '[']).map_or("", |(section, _)| section));
        let range = self.range(path).or_else(section);
        self.at(path, range.map_or(0, |range| range.start))
    }

    /// Converts an error of the library to an error at the key of a section.
    pub(crate) fn refused(&self, section: &str) -> impl Fn(ContactError) -> SceneError {
        move |source| SceneError::from_contact(source, |field| self.place(&joined(section, field)))
    }

    pub(crate) fn missing(&self, path: &str, needed: impl Into<String>) -> SceneError {
        SceneError::Missing { at: self.place(path), needed: needed.into() }
    }

    pub(crate) fn conflict(&self, one: &str, other: &str, needed: &str) -> SceneError {
        let (at, other) = (self.place(one), self.place(other));
        SceneError::Conflict { at, other, needed: needed.into() }
    }
}

/// Whether the value of a line is a number with a decimal comma.
fn decimal_comma(line: &str) -> bool {
    let value = line.split_once('=').map_or("", |(_, value)| value.trim());
    let digit = |text: Option<char>| text.is_some_and(|c| c.is_ascii_digit());
    let parts = value.split_once(',');
    parts.is_some_and(|(whole, rest)| digit(whole.chars().last()) && digit(rest.chars().next()))
        && digit(value.chars().next())
}

pub(crate) fn joined(section: &str, key: &str) -> String {
    let dot = if section.is_empty() || key.is_empty() { "" } else { "." };
    format!("{section}{dot}{key}")
}

/// The text of a file; `place` gives its place in an error.
pub(crate) fn read_text(path: &Path, place: impl FnOnce() -> Place) -> Result<String, SceneError> {
    let mut text = String::new();
    let read =
        File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text));
    let reason = match read {
        Err(error) => error.to_string(),
        Ok(_) if text.len() as u64 > MOST_BYTES => format!("more than {MOST_BYTES} bytes"),
        Ok(_) => return Ok(text),
    };
    Err(SceneError::Unreadable { at: Box::new(place()), reason })
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
    fn long_texts_are_cut_between_characters() {
        let long = "µ".repeat(1000);
        assert_eq!(shorten(&long).chars().count(), 63);
    }
}
