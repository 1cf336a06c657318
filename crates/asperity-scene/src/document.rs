//! The text of a scene file: read by serde, with words for what is wrong and where.

use std::borrow::Cow;
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::{Path, PathBuf};

use asperity::ContactError;
use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue, Error};

use crate::quantity::{NoQuantity, in_si};
use crate::template::key;
use crate::{Place, SceneError};

/// No scene, and no table of heights, needs more bytes than this.
const MOST_BYTES: u64 = 1 << 20;
/// Keys stand no deeper than `body[2].hardness` and `options.displacement.zeta`.
const DEEPEST: usize = 3;

/// A text in TOML, all of whose keys are found again.
#[derive(Debug)]
pub(crate) struct Document<'a> {
    file: Option<&'a Path>,
    /// Where relative paths begin; keywords have none, and no lines.
    directory: Option<&'a Path>,
    /// With plain numbers in the place of those with units.
    text: Cow<'a, str>,
    /// Every key, those of a table behind its own, and where it stands.
    keys: Vec<(String, Range<usize>)>,
}

impl<'a> Document<'a> {
    /// The text, and what serde makes of it.
    pub(crate) fn read<T: DeserializeOwned>(
        file: Option<&'a Path>,
        directory: Option<&'a Path>,
        text: &'a str,
    ) -> Result<(Self, T), SceneError> {
        let mut document = Self { file, directory, text: text.into(), keys: vec![] };
        let root = DeTable::parse(text).map_err(|error| document.no_toml(&error))?;
        let (span, table) = (root.span(), root.into_inner());
        let in_si = in_si(text, &table);
        document.index(String::new(), span, &DeValue::Table(table), DEEPEST);
        let in_si = in_si.map_err(|NoQuantity { path, found, near, needed }| {
            match SceneError::value(document.place(&path), shortened(&found), &needed) {
                SceneError::Value { at, found, needed, .. } => {
                    SceneError::Value { at, found, near, needed }
                }
                other => other,
            }
        })?;
        if in_si != text {
            // The keys once more, as they stand now.
            document.keys.clear();
            document.text = in_si.into();
            let text = document.text.clone();
            let root = DeTable::parse(&text).map_err(|error| document.no_toml(&error))?;
            document.index(String::new(), root.span(), &DeValue::Table(root.into_inner()), DEEPEST);
        }
        let read = toml::from_str(&document.text).map_err(|error| document.explained(&error))?;
        Ok((document, read))
    }

    fn index(&mut self, path: String, span: Range<usize>, value: &DeValue<'_>, deep: usize) {
        match value {
            DeValue::Table(table) if deep > 0 => {
                for (key, value) in table {
                    let (a, b) = (key.span(), value.span());
                    let (path, span) = (
                        joined(&path, &shortened(key.get_ref())),
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

    /// Where the text is no TOML.
    fn no_toml(&self, error: &Error) -> SceneError {
        let at = self.at("TOML", error.span().map_or(0, |span| span.start));
        let found = self.text.lines().nth(at.line.unwrap_or(1) - 1).unwrap_or_default();
        let reason = error.message().replace('\n', ", ");
        let reason = format!("{reason}: {:?} was found", shortened(found.trim()));
        SceneError::Syntax { at, reason }
    }

    /// Serde's words, with the place, what was found there, and near misses.
    fn explained(&self, error: &Error) -> SceneError {
        let message = error.message();
        let span = error.span().unwrap_or(0..self.text.len());
        // What is inside comes first; the least of what is around is the key itself.
        let around = |range: &Range<usize>| range.start <= span.start && span.end <= range.end;
        let around = self.keys.iter().filter(|(_, range)| around(range));
        let path = around.min_by_key(|(_, range)| range.len()).map_or("", |(path, _)| path);
        let missing = message.strip_prefix("missing field `");
        let path = joined(path, missing.map_or("", |name| name.trim_end_matches('`')));
        let (section, name) = path.rsplit_once('.').unwrap_or(("", &path));
        let [section, bare] = [section, name].map(|name| name.split('[').next().unwrap_or(name));
        let template = key(section, bare);
        let meaning = template.as_ref().map_or("", |key| key.meaning);
        if missing.is_some() {
            return self.missing(&path, meaning);
        }
        let needed = message.rsplit_once(", expected ").map_or(message, |(_, needed)| needed);
        if message.starts_with("unknown field `") {
            let known: Vec<&str> = needed.split('`').skip(1).step_by(2).collect();
            let mut allowed = format!("the keys here are {}", known.join(", "));
            let mut near = template.is_none().then(|| nearest(name, known)).flatten();
            let mut elsewhere = template;
            if let Some((word, why)) = other_word(bare).filter(|_| near.is_none()) {
                near = Some(word.into());
                // Bodies have no adhesion of their own.
                elsewhere = key("", word).filter(|_| !needed.contains(word));
                allowed = format!("{why}{allowed}");
            }
            if let Some(key) = elsewhere {
                let top = "the top of the file, above every [section]";
                let home = if key.section.is_empty() { top } else { key.section };
                allowed = format!("it belongs to {home}; {allowed}");
            }
            return SceneError::UnknownKey { at: self.place(&path), near, allowed };
        }
        let needed = match needed {
            "f64" => format!("a number in SI units, without quotes ({meaning}),"),
            "a boolean" => "true or false".into(),
            "a sequence" => format!("a list ({meaning})"),
            "path string" => format!("the path of a file, in quotes ({meaning}),"),
            other if other.starts_with("wanted ") => "a word in quotes".into(),
            "floating-point number overflowed" => "a number of at most 1.8e308".into(),
            words => words.replace('`', "\""),
        };
        let found =
            shortened(self.text.get(span).unwrap_or_default()).replace(char::is_control, " ");
        let near = nearest(found.trim_matches('"'), needed.split('"').skip(1).step_by(2));
        let near = near.or_else(|| near_table(&found, &needed));
        SceneError::Value { at: self.place(&path), found, near, needed }
    }

    fn at(&self, field: &str, offset: usize) -> Box<Place> {
        let before = self.text.bytes().take(offset).filter(|byte| *byte == b'\n');
        let line = self.directory.map(|_| 1 + before.count());
        Box::new(Place { file: self.file.map(Path::to_path_buf), line, field: field.into() })
    }

    /// A path as the scene file means it.
    pub(crate) fn path(&self, path: &Path) -> PathBuf {
        self.directory.unwrap_or(Path::new("")).join(path)
    }

    fn range(&self, path: &str) -> Option<&Range<usize>> {
        self.keys.iter().find(|(key, _)| key == path).map(|(_, range)| range)
    }

    pub(crate) fn has(&self, path: &str) -> bool {
        self.range(path).is_some()
    }

    /// Where a key stands; what is not there has the line of its section.
    pub(crate) fn place(&self, path: &str) -> Box<Place> {
        let section =
            || self.range(path.rsplit_once(['.', '[']).map_or("", |(section, _)| section));
        let range = self.range(path).or_else(section);
        self.at(path, range.map_or(0, |range| range.start))
    }

    /// Names the key of a section that a refusal of the library is about.
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

fn joined(section: &str, key: &str) -> String {
    let dot = if section.is_empty() || key.is_empty() { "" } else { "." };
    format!("{section}{dot}{key}")
}

/// The text of a file that `named` speaks of.
pub(crate) fn text_of(path: &Path, named: impl FnOnce() -> Place) -> Result<String, SceneError> {
    let mut text = String::new();
    let read =
        File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text));
    let reason = match read {
        Err(error) => error.to_string(),
        Ok(_) if text.len() as u64 > MOST_BYTES => format!("it has more than {MOST_BYTES} bytes"),
        Ok(_) => return Ok(text),
    };
    Err(SceneError::Unreadable { at: Box::new(named()), reason })
}

/// The key that other words for the same thing mean, and what differs.
fn other_word(name: &str) -> Option<(&'static str, &'static str)> {
    let inverse = "it is 1/conductivity, in ohm m; ";
    Some(match name.to_lowercase().as_str() {
        "electrical_conductivity" | "electric_conductivity" => ("electrical_resistivity", inverse),
        "resistivity" | "electric_resistivity" => ("electrical_resistivity", ""),
        "conductivity" | "heat_conductivity" => ("thermal_conductivity", ""),
        "adhesion" | "adhesion_energy" | "surface_energy" | "energy_of_adhesion" | "gamma" => {
            ("work_of_adhesion", "it is gamma1 + gamma2 - gamma12 of the pair, in J/m^2; ")
        }
        _ => return None,
    })
}

/// The known word nearest to a mistyped one, if one is near: at most two slips, fewer in short
/// words, whatever the case.
fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<String> {
    let mistyped = word.to_lowercase();
    let distances =
        known.into_iter().map(|k| (strsim::osa_distance(&mistyped, &k.to_lowercase()), k));
    let allowed = (mistyped.chars().count() / 2).min(2);
    distances.min().filter(|(distance, _)| *distance <= allowed).map(|(_, k)| k.into())
}

/// Of tables that are allowed, as `{ skewness = -0.5 }`, the first key that begins as that of the one
/// found, or is near to it.
fn near_table(found: &str, needed: &str) -> Option<String> {
    let key = |text: &str| Some(text.split_once('=')?.0.trim().to_string());
    let given = key(found.trim_start().strip_prefix('{')?)?;
    let known: Vec<String> = needed.split('{').skip(1).filter_map(key).collect();
    let begun = known.iter().find(|known| given.len() > 2 && known.starts_with(&given)).cloned();
    begun
        .or_else(|| nearest(&given, known.iter().map(String::as_str)))
        .filter(|near| *near != given)
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
            assert_eq!(nearest(word, known).as_deref(), wanted, "{word}");
        }
        assert_eq!(nearest("x", []), None);
        let needed = "\"gaussian\" or { skewness = -0.5 } or { file = \"pdf.csv\" }";
        for (found, wanted) in [
            ("{ skew = -0.6 }", Some("skewness")),
            ("{ skewnes = -0.6 }", Some("skewness")),
            ("{ flie = \"a\" }", Some("file")),
            ("{ skewness = \"a\" }", None),
            ("{ kurtosis = 3 }", None),
            ("{}", None),
        ] {
            assert_eq!(near_table(found, needed).as_deref(), wanted, "{found}");
        }
    }

    #[test]
    fn long_texts_are_cut_between_characters() {
        let long = "µ".repeat(1000);
        assert_eq!(shortened(&long).chars().count(), 63);
    }
}
