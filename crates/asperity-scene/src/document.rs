//! A TOML text in which every key knows its line, and no unknown key passes.

use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::words::{Words, meaning, nearest, quoted, shortened};
use crate::{Place, SceneError};

/// The keys of every section: what is not here is refused.
const SECTIONS: [(&str, &[&str]); 6] = [
    ("", &["nominal_area", "rigid_counterface", "interface", "body", "surface", "options"]),
    (
        "interface",
        &[
            "equivalent_modulus",
            "equivalent_shear_modulus",
            "poissons_ratio",
            "hardness",
            "yield_strength",
            "pressure_factor",
        ],
    ),
    ("body", &["youngs_modulus", "poissons_ratio", "hardness", "yield_strength"]),
    (
        "surface",
        &[
            "asperity_radius",
            "asperity_density",
            "asperity_height_std",
            "plasticity_index",
            "roughness_parameter",
            "m0",
            "m2",
            "m4",
            "file",
            "files",
            "unit",
            "pixel_size",
            "estimator",
            "level",
            "filter",
            "max_missing",
            "separation_from",
            "heights",
        ],
    ),
    ("options", &crate::ModelOptions::NAMES),
    ("heights", &["file"]),
];

/// Where the text comes from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Document<'a> {
    pub(crate) file: Option<&'a Path>,
    /// Where relative paths begin.
    pub(crate) directory: &'a Path,
    pub(crate) text: &'a str,
}

impl<'a> Document<'a> {
    /// Reads the text; nothing but its syntax is looked at.
    pub(crate) fn table(&self) -> Result<Spanned<DeTable<'a>>, SceneError> {
        DeTable::parse(self.text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            let at = self.place(offset, "TOML");
            let found = self.text.lines().nth(at.line.map_or(0, |line| line - 1)).unwrap_or("");
            let reason = error.message().replace('\n', ", ");
            SceneError::Syntax {
                at,
                reason: format!("{reason}: {} was found", quoted(found.trim())),
            }
        })
    }

    fn place(&self, offset: usize, field: impl Into<String>) -> Box<Place> {
        let before = self.text.as_bytes().iter().take(offset);
        let line = 1 + before.filter(|b| **b == b'\n').count();
        let file = self.file.map(Path::to_path_buf);
        Box::new(Place { file, line: Some(line), field: field.into() })
    }

    /// A path as the scene file means it.
    pub(crate) fn path(&self, path: &str) -> PathBuf {
        self.directory.join(path)
    }
}

/// One table of a document, all of whose keys are known.
#[derive(Debug, Clone)]
pub(crate) struct Section<'a> {
    document: Document<'a>,
    /// `surface`, `body[2]`; empty for the top level.
    path: String,
    offset: usize,
    table: &'a DeTable<'a>,
}

/// One value of a section.
#[derive(Debug, Clone)]
pub(crate) struct Entry<'a> {
    document: Document<'a>,
    pub(crate) at: Box<Place>,
    offset: usize,
    value: &'a DeValue<'a>,
}

impl<'a> Section<'a> {
    /// The top level of a document.
    pub(crate) fn top(
        document: Document<'a>,
        table: &'a Spanned<DeTable<'a>>,
    ) -> Result<Self, SceneError> {
        Self::new(document, "", String::new(), 0, table.get_ref())
    }

    fn new(
        document: Document<'a>,
        name: &str,
        path: String,
        offset: usize,
        table: &'a DeTable<'a>,
    ) -> Result<Self, SceneError> {
        let section = Self { document, path, offset, table };
        let known = SECTIONS.iter().find(|s| s.0 == name).map_or(&[][..], |s| s.1);
        let unknown = table.iter().find(|(key, _)| !known.contains(&key.get_ref().as_ref()));
        let Some((key, _)) = unknown else { return Ok(section) };
        let word = key.get_ref().as_ref();
        let elsewhere = SECTIONS.iter().find(|s| s.1.contains(&word)).map(|s| s.0);
        let allowed = match elsewhere {
            Some("") => "it belongs to the top of the file, above every [section]".into(),
            Some("body") => "it belongs to a [[body]]".into(),
            Some(other) => format!("it belongs to [{other}]"),
            None => format!("the keys here are {}", known.join(", ")),
        };
        let near = nearest(word, known.iter().copied()).filter(|_| elsewhere.is_none());
        let at = document.place(key.span().start, section.field(&shortened(word)));
        Err(SceneError::UnknownKey { at, near: near.map(Into::into), allowed })
    }

    fn field(&self, key: &str) -> String {
        match (self.path.is_empty(), key.is_empty()) {
            (true, _) => key.into(),
            (false, true) => self.path.clone(),
            (false, false) => format!("{}.{key}", self.path),
        }
    }

    /// Where a key stands; the section's own place where the key was not given.
    pub(crate) fn place(&self, key: &str) -> Box<Place> {
        let offset = self.table.get_key_value(key).map_or(self.offset, |(k, _)| k.span().start);
        self.document.place(offset, self.field(key))
    }

    /// Names the key of this section that a refusal of the library is about.
    pub(crate) fn refused(&self) -> impl Fn(asperity::ContactError) -> SceneError {
        |source| SceneError::from_contact(source, |field| self.place(field))
    }

    pub(crate) fn document(&self) -> Document<'a> {
        self.document
    }

    pub(crate) fn has(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    pub(crate) fn entry(&self, key: &str) -> Option<Entry<'a>> {
        let (spanned, value) = self.table.get_key_value(key)?;
        let offset = spanned.span().start;
        let at = self.document.place(offset, self.field(key));
        Some(Entry { document: self.document, at, offset, value: value.get_ref() })
    }

    /// Every key with its value.
    pub(crate) fn entries(&self) -> impl Iterator<Item = (&'a str, Entry<'a>)> {
        self.table.iter().filter_map(|(key, _)| {
            let key = key.get_ref().as_ref();
            Some((key, self.entry(key)?))
        })
    }

    pub(crate) fn number(&self, key: &str) -> Result<Option<f64>, SceneError> {
        self.entry(key).map(|entry| entry.number()).transpose()
    }

    pub(crate) fn required(&self, key: &str, needed: &str) -> Result<f64, SceneError> {
        self.number(key)?.ok_or_else(|| self.missing(key, needed))
    }

    pub(crate) fn missing(&self, key: &str, needed: &str) -> SceneError {
        SceneError::Missing { at: self.place(key), needed: needed.into() }
    }

    pub(crate) fn conflict(&self, key: &str, other: &str, needed: &str) -> SceneError {
        let (at, other) = (self.place(key), self.place(other));
        SceneError::Conflict { at, other, needed: needed.into() }
    }

    /// A table below this one.
    pub(crate) fn section(&self, key: &str) -> Result<Option<Self>, SceneError> {
        let Some(entry) = self.entry(key) else { return Ok(None) };
        entry.section(key).map(Some)
    }
}

impl<'a> Entry<'a> {
    /// This value is not what it should be.
    pub(crate) fn wrong(&self, needed: impl Into<String>) -> SceneError {
        let (at, found) = (self.at.clone(), self.found());
        SceneError::Value { at, found, near: None, needed: needed.into() }
    }

    /// What was found, for errors.
    fn found(&self) -> String {
        match self.value {
            DeValue::String(text) => format!("the text {}", quoted(text)),
            DeValue::Integer(number) => format!("{number:.60}"),
            DeValue::Float(number) => format!("{number:.60}"),
            DeValue::Boolean(value) => value.to_string(),
            DeValue::Datetime(_) => "a date".into(),
            DeValue::Array(array) => format!("a list of {}", array.len()),
            DeValue::Table(_) => "a table".into(),
        }
    }

    pub(crate) fn number(&self) -> Result<f64, SceneError> {
        let number = match self.value {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(integer) => {
                i128::from_str_radix(integer.as_str(), integer.radix()).ok().map(|i| i as f64)
            }
            _ => None,
        };
        number.ok_or_else(|| self.wrong("a number in SI units, without quotes,"))
    }

    pub(crate) fn boolean(&self) -> Result<bool, SceneError> {
        self.value.as_bool().ok_or_else(|| self.wrong("true or false"))
    }

    pub(crate) fn text(&self) -> Option<&'a str> {
        self.value.as_str()
    }

    /// One word of a list, as what it stands for.
    pub(crate) fn one_of<T: Copy>(&self, words: &Words<'_, T>) -> Result<T, SceneError> {
        self.one_of_or(words, "")
    }

    /// The same, where something else is allowed beside the words.
    pub(crate) fn one_of_or<T: Copy>(
        &self,
        words: &Words<'_, T>,
        or: &str,
    ) -> Result<T, SceneError> {
        meaning(&self.at, self.text().ok_or_else(|| self.found()), words, or)
    }

    pub(crate) fn is_table(&self) -> bool {
        self.value.is_table()
    }

    /// A table whose keys are those of the section `name`.
    pub(crate) fn section(&self, name: &str) -> Result<Section<'a>, SceneError> {
        let Some(table) = self.value.as_table() else {
            return Err(self.wrong(format!("a table, [{}],", self.at.field)));
        };
        Section::new(self.document, name, self.at.field.clone(), self.offset, table)
    }

    /// The values of a list, numbered from 1; `None` where this is none.
    pub(crate) fn items(&self) -> Option<Vec<Self>> {
        let item = |(k, item): (usize, &'a Spanned<DeValue<'a>>)| {
            let (offset, field) = (item.span().start, format!("{}[{}]", self.at.field, k + 1));
            let at = self.document.place(offset, field);
            Entry { document: self.document, at, offset, value: item.get_ref() }
        };
        Some(self.value.as_array()?.iter().enumerate().map(item).collect())
    }

    /// The tables of a list, `[[name]]`, numbered from 1 in their paths.
    pub(crate) fn sections(&self, name: &str) -> Result<Vec<Section<'a>>, SceneError> {
        let needed = || self.wrong(format!("one or two tables [[{}]]", self.at.field));
        let array = self.value.as_array().ok_or_else(needed)?;
        let mut sections = vec![];
        for (k, item) in array.iter().enumerate() {
            let table = item.get_ref().as_table().ok_or_else(needed)?;
            let (path, offset) = (format!("{}[{}]", self.at.field, k + 1), item.span().start);
            sections.push(Section::new(self.document, name, path, offset, table)?);
        }
        Ok(sections)
    }

    /// The numbers of a table without fixed keys.
    pub(crate) fn numbers(&self) -> Result<Vec<(&'a str, f64)>, SceneError> {
        let Some(table) = self.value.as_table() else {
            return Err(self.wrong("a table of numbers"));
        };
        let number = |(key, value): (&'a Spanned<_>, &'a Spanned<DeValue<'a>>)| {
            let key: &std::borrow::Cow<'a, str> = key.get_ref();
            let field = format!("{}.{}", self.at.field, shortened(key));
            let offset = value.span().start;
            let at = self.document.place(offset, field);
            let entry = Entry { document: self.document, at, offset, value: value.get_ref() };
            Ok((key.as_ref(), entry.number()?))
        };
        table.iter().map(number).collect()
    }
}
