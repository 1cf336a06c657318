//! The text of a scene file: its keys and their places.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashSet};
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use asperity::ContactError;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue, Error};
use toml::{Table, Value};

use crate::in_si::{QuantityError, Reason, in_si};
use crate::notation::notation_hint;
use crate::template::{counterface_keys, joined, keys_of};
use crate::{Place, SceneError};

/// The largest size of a scene file or of a table of heights.
const MOST_BYTES: u64 = 1 << 20;
/// The largest depth of a key: `body[2].hardness`, `options.displacement.zeta`.
const DEEPEST: usize = 3;

/// Files that a scene may name, by name: their bytes.
pub type HandedFiles = BTreeMap<String, Vec<u8>>;

/// Where the files that a text names are found.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Files<'a> {
    /// Nowhere: the text is made of keywords, which have no lines.
    Nowhere,
    /// Relative paths begin in this folder.
    In(&'a Path),
    /// The caller has read them.
    Handed(&'a HandedFiles),
}

/// A text in TOML with the places of its keys.
#[derive(Debug)]
pub(crate) struct Document<'a> {
    file: Option<&'a Path>,
    files: Files<'a>,
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
        files: Files<'a>,
        text: &'a str,
    ) -> Result<Self, SceneError> {
        let mut document = Self { file, files, text: text.into(), keys: vec![], stated: vec![] };
        let root = DeTable::parse(text).map_err(|error| document.toml_error(&error))?;
        let (span, table) = (root.span(), root.into_inner());
        let in_si = in_si(text, &table);
        document.index(String::new(), span, &DeValue::Table(table), DEEPEST);
        let (in_si, stated) = in_si.map_err(|QuantityError { path, found, reason }| {
            let (at, found) = (document.place(&path), format!("{:?}", shorten(&found)));
            match reason {
                Reason::Notation(hint) => SceneError::Notation { at, found, hint },
                Reason::Unit { near, needed } => {
                    SceneError::Value { at, found, near, needed: needed.into() }
                }
            }
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
        let advice = other_notation(found).unwrap_or_default();
        let reason = format!("{advice}{reason}: {:?} was found", shorten(found.trim()));
        SceneError::Syntax { at, reason }
    }

    fn at(&self, field: &str, offset: usize) -> Box<Place> {
        let before = self.text.bytes().take(offset).filter(|byte| *byte == b'\n');
        let line = (!matches!(self.files, Files::Nowhere)).then(|| 1 + before.count());
        Box::new(Place { file: self.file.map(Path::to_path_buf), line, field: field.into() })
    }

    /// A path relative to the scene file, or the name of a file that was handed over.
    pub(crate) fn path(&self, path: &Path) -> PathBuf {
        match self.files {
            Files::In(folder) => folder.join(path),
            Files::Nowhere | Files::Handed(_) => path.into(),
        }
    }

    /// The path that names the same file in a scene elsewhere.
    pub(crate) fn whole_path(&self, path: &Path) -> PathBuf {
        let path = self.path(path);
        match self.files {
            Files::Handed(_) => path,
            _ => std::path::absolute(&path).unwrap_or(path),
        }
    }

    /// The bytes of a file that was handed over; `None` where files are read from a folder.
    pub(crate) fn handed(&self, field: &str, path: &Path) -> Result<Option<&'a [u8]>, SceneError> {
        let Files::Handed(files) = self.files else { return Ok(None) };
        let found = path.to_str().and_then(|name| files.get(name));
        found.map(|bytes| Some(bytes.as_slice())).ok_or_else(|| {
            let at = self.place(field);
            let at = Box::new(Place { field: format!("{} = {path:?}", at.field), ..*at });
            SceneError::Unreadable { at, reason: "the file has not been chosen".into() }
        })
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

/// Advice for a line whose number is written in another notation, or whose quotes are curly.
fn other_notation(line: &str) -> Option<String> {
    if line.trim() == "[body]" {
        return Some("each of two bodies is written [[body]]; ".into());
    }
    let value = line.split_once('=')?.1.split('#').next()?.trim();
    if value.contains(['\u{201c}', '\u{201d}', '\u{201e}', '\u{2018}', '\u{2019}']) {
        return Some("curly quotes were found; write straight quotes, \"; ".into());
    }
    notation_hint(value).map(|hint| format!("{value} {hint}; "))
}

/// Advice for a spreadsheet that was given as a table.
pub(crate) const SAVE_AS_CSV: &str = "save the sheet as csv";

/// The text of a file; `place` gives its place in an error, and `advice` the remedy for a file that
/// is no text.
pub(crate) fn read_text(
    path: &Path,
    advice: &str,
    place: impl FnOnce() -> Place,
) -> Result<String, SceneError> {
    let mut bytes = vec![];
    let read = File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes));
    let reason = match read {
        Err(error) => error.to_string(),
        Ok(_) if is_binary(&bytes) => format!("the file is not a text file; {advice}"),
        Ok(count) if count as u64 > MOST_BYTES => {
            format!("more than {MOST_BYTES} bytes; leave out rows or digits")
        }
        Ok(_) => match String::from_utf8(bytes) {
            // Text in UTF-16 has zeros.
            Ok(mut text) if !text.contains('\0') => {
                // The end of a text in DOS.
                text.truncate(text.trim_end_matches('\u{1a}').len());
                return Ok(text);
            }
            _ => "the text is not in UTF-8; save it as UTF-8".into(),
        },
    };
    Err(SceneError::Unreadable { at: Box::new(place()), reason })
}

/// Whether bytes are no text in UTF-8, UTF-16 or an 8-bit encoding: archives, as spreadsheets are,
/// and other files with control characters.
fn is_binary(bytes: &[u8]) -> bool {
    let is_control = |byte: &u8| matches!(byte, 1..=8 | 14..=25 | 28..=31);
    let is_utf_16 = bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff");
    !is_utf_16 && bytes.iter().take(4096).any(is_control)
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
    fn files_are_read_by_the_names_under_which_they_were_handed_over() {
        let text = "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\n\
                    poissons_ratio = 0.3\nhardness = 1e9\n[surface]\nasperity_radius = 1e-5\n\
                    asperity_density = 1e10\nheights = { file = \"a/pdf.csv\" }\n";
        let mut files = HandedFiles::new();
        let missing = crate::parse_handed(text, &files).unwrap_err().to_string();
        let wanted = "line 9: surface.heights.file = \"a/pdf.csv\" cannot be read: the file has not been chosen";
        assert_eq!(missing, wanted);
        let table = b"height_m,density_per_m\n-1e-6,0\n0,1e6\n1e-6,0\n";
        files.insert("a/pdf.csv".into(), table.to_vec());
        let file = crate::parse_handed(text, &files).unwrap();
        assert_eq!(file.table.unwrap().points().len(), 3);
        let scan = text.replace("heights =", "file = \"b.x3p\"\n#").replace("asperity_", "# ");
        let broken = HandedFiles::from([("b.x3p".into(), vec![])]);
        let refused = crate::parse_handed(&scan, &broken).unwrap_err().to_string();
        assert!(refused.starts_with("line 9: surface.file: b.x3p: "), "{refused}");
    }

    #[test]
    fn long_texts_are_named_by_their_length() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("scene.toml");
        // The limit lies within a character.
        std::fs::write(&path, format!("#{}", "\u{b5}".repeat(1 << 19))).unwrap();
        let refused = read_text(&path, "", || Place::field("scene")).unwrap_err().to_string();
        assert_eq!(
            refused,
            "scene cannot be read: more than 1048576 bytes; leave out rows or digits"
        );
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
