//! Headers of text files: keys with a number, a unit or a word, by the words of `words.csv`.

use std::collections::HashMap;

use serde::Serialize;

use super::lines::{COMMENT, Delimiter};
use super::scan::{ReadOptions, agree};
use super::words::{meanings, named, number, quantities, unit_meaning};
use crate::error::{refuse, refuse_line, undecided};
use crate::{Distance, LengthUnit, TopographyError};

/// A line of the header of a text file.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct HeaderLine {
    /// Its number, from 1.
    pub line: usize,
    /// Its text.
    pub text: String,
    /// What it is understood as, such as `width` or `unit`; `None` if it is not.
    pub meaning: Option<&'static str>,
}

/// A key of a header and what stands behind it.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    meanings: &'static [&'static str],
    line: usize,
    /// The line.
    text: String,
    numbers: Vec<f64>,
    /// The unit behind the numbers or the key.
    unit: Option<String>,
    /// The text behind the key.
    words: String,
}

impl Entry {
    fn new(text: &str, key: &str, words: &str, separator: char) -> Self {
        let (name, unit) = named(key);
        let (numbers, own) = quantities(words, separator);
        let unit = own.or(unit).map(str::to_owned);
        let words = words.trim().trim_matches(['"', ',', ' ']).to_owned();
        Self {
            meanings: meanings("header", name),
            line: 0,
            text: text.into(),
            numbers,
            unit,
            words,
        }
    }

    pub(super) fn known(&self) -> bool {
        !self.meanings.is_empty()
    }

    fn wrong(&self, required: &str) -> TopographyError {
        refuse_line(self.line, &self.text, required)
    }

    /// The number in this place of two, or else the last one, above 0.
    fn positive(&self, at: usize, required: &str) -> Result<f64, TopographyError> {
        let two = self.numbers.get(at).filter(|_| self.numbers.len() == 2);
        let number = two.or(self.numbers.last()).copied();
        let positive = number.filter(|number| *number > 0.0 && number.is_finite());
        positive.ok_or_else(|| self.wrong(required))
    }

    fn length_unit(&self) -> Result<Option<LengthUnit>, TopographyError> {
        let length = |unit: &String| unit.parse().map_err(|_| self.wrong("a unit of length"));
        self.unit.as_ref().map(length).transpose()
    }

    /// Whether the numbers count points.
    fn counts(&self) -> bool {
        self.unit.as_deref().is_some_and(|unit| unit_meaning(unit) == Some("points"))
    }
}

/// The key of a line and what stands behind it: `# Width: 10 µm`, `"Width","10","µm"`, `ncols 48`.
pub(super) fn entry(text: &str, delimiter: Delimiter) -> Option<Entry> {
    let bare = text.trim_start_matches(COMMENT).trim_start_matches([' ', '"', '*', '\\', '/']);
    // Some keys stand alone or have a word for a value.
    let wordy = |entry: &Entry| {
        let word = |key: &&str| key.contains('=') || key.starts_with("unit") || *key == "name";
        entry.meanings.iter().any(|key| word(key) || matches!(*key, "scaled" | "mark"))
    };
    let assigned = bare.split_once([':', '=', '\u{ff1a}']);
    let assigned = assigned.map(|(key, words)| Entry::new(bare, key, words, '\t'));
    let parts = ['\t', ';', char::from(delimiter.0), ','].into_iter().filter(|part| *part != ' ');
    let mut parted = parts.filter_map(|part| {
        let (key, words) = bare.split_once(part)?;
        Some(Entry::new(bare, key, words, part))
    });
    let mut spaced = bare.match_indices([' ', '\t']).take(9).filter_map(|(at, _)| {
        let (key, words) = bare.split_at(at);
        number(words.split_whitespace().next()?)?;
        Some(Entry::new(bare, key, words, '\t'))
    });
    match assigned {
        Some(entry) if entry.known() => Some(entry),
        assigned => parted
            .find(|entry| entry.known() && (wordy(entry) || !entry.numbers.is_empty()))
            .or_else(|| spaced.find(Entry::known))
            .or_else(|| Some(Entry::new(bare, bare, "", ' ')).filter(wordy))
            .or(assigned),
    }
}

/// The header above a table.
#[derive(Debug, Default)]
pub(super) struct Header {
    pub(super) lines: Vec<HeaderLine>,
    /// By meaning; of several entries with one meaning, the first.
    entries: HashMap<&'static str, Entry>,
}

impl Header {
    pub(super) fn read(lines: &[(usize, String)], delimiter: Delimiter) -> Self {
        let mut header = Self::default();
        for (line, text) in lines {
            let mut meaning = None;
            if let Some(entry) = entry(text, delimiter) {
                for key in entry.meanings {
                    let mut entry = Entry { line: *line, ..entry.clone() };
                    let (key, implied) = key.split_at(key.find(['=', '@']).unwrap_or(key.len()));
                    if let Some(value) = implied.strip_prefix('=') {
                        let numbers = value.parse().into_iter().collect();
                        entry = Entry { numbers, words: value.into(), ..entry };
                    } else if let Some(unit) = implied.strip_prefix('@') {
                        entry.unit = Some(unit.into());
                    }
                    header.entries.entry(key).or_insert(entry);
                    meaning = meaning.or(Some(key));
                }
            }
            header.lines.push(HeaderLine { line: *line, text: text.clone(), meaning });
        }
        header
    }

    /// The name of the channel.
    pub(super) fn name(&self) -> Option<&str> {
        self.entries.get("name").map(|entry| entry.words.as_str())
    }

    /// The unit that the header states for the heights, after their factor.
    pub(super) fn unit(&self) -> Result<Option<LengthUnit>, TopographyError> {
        if let Some(unit) = self.entries.get("factor").and_then(|entry| entry.unit.as_ref()) {
            return unit.parse().map(Some);
        }
        let Some(entry) = self.entries.get("unit") else { return Ok(None) };
        let required = "a unit of length, or a conversion factor of the heights,";
        entry.words.parse().map(Some).map_err(|_| entry.wrong(required))
    }

    /// Whether the factor of the header states the unit it leads to.
    pub(super) fn has_unit_of_factor(&self) -> bool {
        self.entries.get("factor").is_some_and(|entry| entry.unit.is_some())
    }

    /// The factor of the heights, which leads to their unit; `unit` is known otherwise.
    pub(super) fn factor(&self, unit: bool) -> Result<Option<f64>, TopographyError> {
        // Nova writes `No` where heights are in their unit, Wyko 1 as the second of three flags.
        let scaled = |entry: &Entry| {
            entry.words.eq_ignore_ascii_case("no") || entry.numbers.get(1) == Some(&1.0)
        };
        if self.entries.get("scaled").is_some_and(scaled) {
            return Ok(None);
        }
        let required = "the factor from the heights to a unit of length, as in (-> m)=1e-9,";
        let of = |key| self.entries.get(key).map(|entry| entry.positive(usize::MAX, required));
        if let (Some(wavelength), Some(divisor)) = (of("wavelength"), of("divisor")) {
            return Ok(Some(wavelength? / divisor?));
        }
        let Some(entry) = self.entries.get("factor") else { return Ok(None) };
        let factor = entry.numbers.last().copied().filter(|factor| factor.is_finite());
        let known = unit || entry.length_unit()?.is_some();
        factor.filter(|_| known).map(Some).ok_or_else(|| entry.wrong(required))
    }

    /// The numbers that mark missing points.
    pub(super) fn missing(&self) -> &[f64] {
        self.entries.get("missing").map_or(&[], |entry| &entry.numbers)
    }

    /// Whether the first line of the file is the last row.
    pub(super) fn downwards(&self) -> bool {
        self.entries.contains_key("downwards")
    }

    /// Whether a line of the file is a column.
    pub(super) fn by_columns(&self) -> bool {
        self.entries.contains_key("lines x")
    }

    /// Whether it states a width, which positions in columns would repeat.
    pub(super) fn has_size(&self) -> bool {
        ["width", "height", "size"].iter().any(|key| self.entries.contains_key(key))
    }

    /// The number of columns and of rows.
    pub(super) fn points(&self) -> Result<[Option<usize>; 2], TopographyError> {
        let mut points = [None; 2];
        for (axis, point) in points.iter_mut().enumerate() {
            let keys = [["points x", "lines x"], ["points y", ""]][axis];
            let own = keys.iter().find_map(|key| self.entries.get(key)).or_else(|| {
                let counted = self.entries.get(["width", "height"][axis]);
                counted.filter(|entry| entry.counts())
            });
            let both = self.entries.get("points").filter(|entry| entry.numbers.len() > 1);
            let Some(entry) = own.or(both) else { continue };
            let required = "a number of points";
            let number = entry.positive(if own.is_some() { usize::MAX } else { axis }, required)?;
            if number.fract() != 0.0 || number > crate::MAX_POINTS as f64 {
                return Err(entry.wrong(required));
            }
            *point = Some(number as usize);
        }
        Ok(points)
    }

    /// The unit of lengths along an axis.
    pub(super) fn lateral(
        &self,
        axis: usize,
        options: &ReadOptions,
    ) -> Result<Option<LengthUnit>, TopographyError> {
        let keys = [["unit x", "unit xy", "unit y"], ["unit y", "unit x", "unit xy"]][axis];
        let entry = keys.iter().find_map(|key| self.entries.get(key));
        let unit = |entry: &Entry| entry.words.parse().map_err(|_| entry.wrong("a unit of length"));
        agree("units", options.lateral(axis), entry.map(unit).transpose()?)
    }

    /// The distance of points along the axes of a table of this many columns and rows.
    pub(super) fn pixel_size(
        &self,
        counts: [usize; 2],
        options: &ReadOptions,
    ) -> Result<Option<[Distance; 2]>, TopographyError> {
        let [x, y] = [self.side(0, counts[0], options)?, self.side(1, counts[1], options)?];
        Ok(match (x, y) {
            (Some(x), Some(y)) => Some([x, y]),
            (Some(x), None) if counts[1] == 1 => Some([x; 2]),
            _ => None,
        })
    }

    fn side(
        &self,
        axis: usize,
        n: usize,
        options: &ReadOptions,
    ) -> Result<Option<Distance>, TopographyError> {
        let lateral = self.lateral(axis, options)?;
        let find = |keys: [&str; 2]| self.entries.get(keys[0]).or(self.entries.get(keys[1]));
        let size = find([["width", "size"], ["height", "size"]][axis]);
        if let Some(entry) = size.filter(|entry| !entry.counts()) {
            let length = entry.positive(axis, "a length, for example 10 um,")?;
            match entry.length_unit()?.or(lateral) {
                Some(unit) => return Ok(Some(Distance::metre(length * unit.metres() / n as f64))),
                // The number of points.
                None if length.total_cmp(&(n as f64)).is_eq() => {}
                None => return Err(no_unit(format!("line {}", entry.line), &entry.text)),
            }
        }
        if let Some(entry) = find([["step x", "step"], ["step y", "step"]][axis]) {
            let value = entry.positive(axis, "a length above 0")?;
            let aspect = self.entries.get("aspect").filter(|_| axis == 0);
            let aspect = aspect.map_or(Ok(1.0), |entry| entry.positive(0, "a ratio"))?;
            let unit = entry.length_unit()?.or(lateral);
            return Ok(Some(Distance { value: value * aspect, unit }));
        }
        let Some(entry) = self.entries.get(["range x", "range y"][axis]) else { return Ok(None) };
        match entry.numbers[..] {
            [first, last] if last > first && (last - first).is_finite() && n > 1 => {
                Ok(Some(Distance { value: (last - first) / (n - 1) as f64, unit: lateral }))
            }
            _ => Err(entry.wrong("the first and the last position")),
        }
    }

    /// Refuses a table of another size than the header states.
    pub(super) fn check(&self, found: [usize; 2]) -> Result<(), TopographyError> {
        let stated = self.points()?;
        let other = |(stated, found): (Option<usize>, usize)| stated.is_some_and(|n| n != found);
        if stated.into_iter().zip(found).any(other) {
            let [x, y] = stated.map(|n| n.map_or("?".to_owned(), |n| n.to_string()));
            let required = format!("the {} x {} of the table", found[0], found[1]);
            return Err(refuse("header", format!("{x} x {y} points"), required));
        }
        Ok(())
    }
}

/// The error of a length that has no unit.
pub(super) fn no_unit(place: String, found: &str) -> TopographyError {
    undecided(
        place,
        format!("{found} has no unit"),
        "units",
        "those of lengths and heights, as um,nm",
    )
}
