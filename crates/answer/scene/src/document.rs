//! The text of a scene file: its values in SI units, and their places.

mod mistakes;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::{Path, PathBuf};

use asperity::{ContactError, Finding, written};
use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue};
use toml::{Spanned, Table, Value};

use crate::error::{Place, Provenance, SceneError};
use crate::keys::{COUNTERFACE, Key, joined, keys_of, section_and_name};
use crate::quantity::{both_ends, in_si, without_unit};
use crate::text_file::shorten;
use crate::unknown::Unknown;

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

/// A text in TOML, parsed once.
#[derive(Debug)]
pub(crate) struct Document<'a> {
    files: Files<'a>,
    text: &'a str,
    /// The offsets of the ends of lines.
    ends: Vec<usize>,
    /// The keys of numbers that were written as two values, the ends of a range, with these; the
    /// middle stands in their place.
    pub(crate) ranges: Vec<(String, [f64; 2])>,
    /// Where each key was written.
    pub(crate) origin: Provenance,
    /// Every key with the range of its value in the text, and the value, with numbers in SI units
    /// instead of those with units.
    values: BTreeMap<String, (Range<usize>, Value)>,
}

impl<'a> Document<'a> {
    /// The keys of a text, with its numbers in SI units.
    pub(crate) fn new(
        file: Option<&'a Path>,
        files: Files<'a>,
        text: &'a str,
    ) -> Result<Self, SceneError> {
        let origin = Provenance { file: file.map(Path::to_path_buf), ..Provenance::default() };
        let ends = text.match_indices('\n').map(|(end, _)| end).collect();
        let (ranges, values) = (vec![], BTreeMap::new());
        let mut document = Self { files, text, ends, ranges, origin, values };
        let root = DeTable::parse(text).map_err(|error| document.toml_error(&error))?;
        let (span, root) = (root.span(), DeValue::Table(root.into_inner()));
        document.keep("", 0, &Spanned::new(span, root))?;
        Ok(document)
    }

    /// A value, with numbers in SI units instead of texts with a unit; keeps it with its place.
    fn keep(
        &mut self,
        path: &str,
        start: usize,
        value: &Spanned<DeValue<'_>>,
    ) -> Result<Value, SceneError> {
        self.origin.lines.extend(self.line(start).map(|line| (path.to_string(), line)));
        let read = self.read_value(value.get_ref(), path)?;
        self.values.insert(path.into(), (value.span(), read.clone()));
        Ok(read)
    }

    fn read_value(&mut self, value: &DeValue<'_>, path: &str) -> Result<Value, SceneError> {
        let (section, key) = section_and_name(path);
        // Digits beyond the largest number are infinite, which every range excludes.
        let float = |digits: &str| Value::Float(digits.parse().unwrap_or(f64::INFINITY));
        Ok(match value {
            DeValue::String(text) => match Key::find(section, key).and_then(Key::units) {
                Some(units) => {
                    let number = in_si(text, key, units).map_err(|hint| {
                        let ends = || both_ends(text);
                        let hint = Key::may_have_range(path).then(ends).flatten().unwrap_or(hint);
                        let (at, found) = (self.place(path), format!("{:?}", shorten(text)));
                        SceneError::notation(at, &found, &hint)
                    })?;
                    self.origin.stated.push(path.into());
                    Value::Float(number)
                }
                None => Value::String(text.clone().into_owned()),
            },
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
                .map_or_else(|_| float(digits.as_str()), Value::Integer),
            DeValue::Float(digits) => float(digits.as_str()),
            DeValue::Boolean(value) => Value::Boolean(*value),
            DeValue::Datetime(value) => Value::Datetime(*value),
            DeValue::Array(items) => {
                let item = |(item, k): (&Spanned<DeValue<'_>>, i32)| {
                    self.keep(&format!("{path}[{k}]"), item.span().start, item)
                };
                let items = items.iter().zip(1..).map(item).collect::<Result<Vec<_>, _>>()?;
                self.range(path, &items)?.unwrap_or(Value::Array(items))
            }
            DeValue::Table(inner) => {
                let value = |(key, value): (&Spanned<Cow<'_, str>>, &Spanned<DeValue<'_>>)| {
                    let path = joined(path, &shorten(key.get_ref()));
                    let start = key.span().start.min(value.span().start);
                    Ok((key.get_ref().clone().into_owned(), self.keep(&path, start, value)?))
                };
                Value::Table(inner.iter().map(value).collect::<Result<_, SceneError>>()?)
            }
        })
    }

    /// The middle of the range of a number that is written as two values; keeps the ends.
    ///
    /// # Errors
    /// [`SceneError::Refused`] where one end has a unit and the other, which is not 0, has none.
    fn range(&mut self, path: &str, items: &[Value]) -> Result<Option<Value>, SceneError> {
        let number = |item: &Value| item.as_float().or_else(|| item.clone().try_into().ok());
        let numbers = items.iter().map(number).collect::<Option<Vec<f64>>>();
        let Some([one, other]) = numbers.as_deref() else { return Ok(None) };
        if !Key::may_have_range(path) {
            return Ok(None);
        }
        let stated = [1, 2].map(|k| self.origin.is_stated(&format!("{path}[{k}]")));
        if let Some(bare) = without_unit([*one, *other], stated) {
            let at = self.place(&format!("{path}[{}]", bare + 1));
            let hint = "has no unit, and the other end has one: give both ends a unit";
            return Err(SceneError::notation(at, &written([*one, *other][bare]), hint));
        }
        // One that is no number stays, to be refused.
        let ends = if one <= other { [*one, *other] } else { [*other, *one] };
        if stated[0] {
            self.origin.stated.push(path.into());
        }
        let middle = Unknown::written(String::new(), ends).middle();
        self.ranges.extend((ends[0] < ends[1]).then(|| (path.to_string(), ends)));
        Ok(Some(Value::Float(middle)))
    }

    /// The value of a key.
    pub(crate) fn value(&self, path: &str) -> Option<&Value> {
        self.values.get(path).map(|(_, value)| value)
    }

    /// The number of a key that a scene must have.
    pub(crate) fn needed_number(&self, path: &str) -> Result<f64, SceneError> {
        self.get(path)?
            .ok_or_else(|| self.missing(path, format!("a number ({})", Key::meaning(path))))
    }

    /// The keys of a section, if it is there, as one of the types of the library.
    pub(crate) fn section<T: DeserializeOwned>(&self, name: &str) -> Result<Option<T>, SceneError> {
        let read = || self.read_over(name, &keys_of(name), Table::new());
        self.has(name).then(read).transpose()
    }

    /// The value of a key as one of the types of the library.
    pub(crate) fn get<T: DeserializeOwned>(&self, path: &str) -> Result<Option<T>, SceneError> {
        let Some(value) = self.value(path) else { return Ok(None) };
        let found = value.clone().try_into();
        found.map(Some).map_err(|error| self.wrong(path, error.message()))
    }

    /// The keys of a section over those of `base`, as one of the types of the library.
    pub(crate) fn read_over<T: DeserializeOwned>(
        &self,
        section: &str,
        names: &[&str],
        mut base: Table,
    ) -> Result<T, SceneError> {
        for name in names {
            let path = joined(section, name);
            let Some(value) = self.value(&path) else { continue };
            base.insert((*name).into(), value.clone());
            // Of the keys so far each is valid.
            let read = base.clone().try_into::<T>();
            read.map_err(|error| self.wrong(&path, error.message()))?;
        }
        base.try_into().map_err(|error| self.wrong(section, error.message()))
    }

    /// Refuses the first key of a section that it does not have.
    pub(crate) fn check_keys(&self, section: &str, known: &[&str]) -> Result<(), SceneError> {
        let table = match self.value(section) {
            None => return Ok(()),
            Some(Value::Table(table)) => table,
            _ => return Err(self.wrong(section, &format!("a table, [{section}],"))),
        };
        let unknown = table.keys().filter(|name| !known.contains(&name.as_str()));
        let unknown = unknown.map(|name| joined(section, &shorten(name)));
        let start = |path: &String| self.values.get(path).map(|(span, _)| span.start);
        unknown.min_by_key(start).map_or(Ok(()), |path| Err(self.unknown(&path, known)))
    }

    /// Refuses unknown keys everywhere but in the options.
    pub(crate) fn check_sections(&self) -> Result<(), SceneError> {
        let is_word = self.value(COUNTERFACE).is_some_and(Value::is_str);
        let sections =
            ["", "surface", COUNTERFACE, "interface", "curvature", "gap", "seal"].into_iter();
        for section in sections.filter(|section| !is_word || *section != COUNTERFACE) {
            self.check_keys(section, &keys_of(section))?;
        }
        let bodies = self.value("body").and_then(Value::as_array).map_or(0, Vec::len);
        (1..=bodies).try_for_each(|k| self.check_keys(&format!("body[{k}]"), &keys_of("body")))
    }

    /// The line of an offset; none for keywords.
    fn line(&self, offset: usize) -> Option<usize> {
        let before = self.ends.partition_point(|end| *end < offset);
        (!matches!(self.files, Files::Nowhere)).then_some(1 + before)
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
            let at = *self.place(field);
            let at = Place { field: format!("{} = {path:?}", at.field), ..at };
            SceneError::refused(at, "the file has not been chosen")
        })
    }

    pub(crate) fn has(&self, path: &str) -> bool {
        self.values.contains_key(path)
    }

    /// The place of a key; a missing key has the line of its section.
    pub(crate) fn place(&self, path: &str) -> Box<Place> {
        self.origin.place(path).into()
    }

    /// Converts an error of the library to an error at the key of a section.
    pub(crate) fn refused(&self, section: &str) -> impl Fn(ContactError) -> SceneError {
        move |source| SceneError::from_contact(source, |field| self.place(&joined(section, field)))
    }

    /// The error of an odd number of a section that was given without its unit, if another unit
    /// than that of its key makes it usual.
    pub(crate) fn likely_unit(&self, section: &str, odd: Option<Finding>) -> Option<SceneError> {
        let Finding { field, likely_unit, .. } = odd?;
        let path = joined(section, &field);
        let unit = likely_unit.filter(|_| !self.origin.is_stated(&path))?;
        Some(SceneError::refused(self.place(&path), unit))
    }

    pub(crate) fn missing(&self, path: &str, needed: impl AsRef<str>) -> SceneError {
        SceneError::missing(self.place(path), needed.as_ref())
    }

    pub(crate) fn conflict(&self, one: &str, other: &str, needed: &str) -> SceneError {
        SceneError::conflict(self.place(one), &self.place(other), needed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_read_by_the_names_under_which_they_were_handed_over() {
        let text = "nominal_area = 1e-6\n[interface]\nequivalent_modulus = 1e11\n\
                    poissons_ratio = 0.3\nhardness = 1e9\n[surface]\nfile = \"b.x3p\"\n";
        let missing = crate::parse_handed(text, &HandedFiles::new()).unwrap_err();
        assert!(matches!(missing, SceneError::Refused { .. }), "{missing}");
        assert_eq!(missing.place().unwrap().line, Some(7));
        let broken = HandedFiles::from([("b.x3p".into(), vec![])]);
        let refused = crate::parse_handed(text, &broken).unwrap_err().to_string();
        assert!(refused.starts_with("line 7: surface.file: b.x3p: "), "{refused}");
    }
}
