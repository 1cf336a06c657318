//! Headers of text files: keys with a number, a unit or a word, by the words of `words.csv`.

use std::collections::HashMap;

use asperity_core::{Code, Finding, written};
use serde::Serialize;

use super::lines::{COMMENT, Delimiter};
use super::scan::{ReadOptions, agree};
use super::words::{meanings, named, number, quantities, unit_meaning};
use crate::error::{excerpt, refuse, refuse_line, undecided};
use crate::{Distance, LengthUnit, MAX_POINTS, TopographyError};

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
struct Entry {
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
        let (text, words) = (text.into(), words.trim().trim_matches(['"', ',', ' ']).into());
        Self { meanings: meanings("header", name), line: 0, text, numbers, unit, words }
    }

    /// Points with a unit of length are a length: `Xsize 7 um`.
    fn of_its_unit(mut self) -> Self {
        let is_length = self.unit.as_ref().is_some_and(|unit| unit.parse::<LengthUnit>().is_ok());
        self.meanings = match self.meanings {
            ["points x", ..] if is_length => &["width"],
            ["points y", ..] if is_length => &["height"],
            meanings => meanings,
        };
        self
    }

    fn known(&self) -> bool {
        !self.meanings.is_empty()
    }

    fn wrong(&self, required: &str) -> TopographyError {
        refuse_line(self.line, &self.text, required)
    }

    /// The number of this place of two, or else the last one, above 0.
    fn positive(&self, at: usize, required: &str) -> Result<f64, TopographyError> {
        let two = self.numbers.get(at).filter(|_| self.numbers.len() == 2);
        let number = two.or(self.numbers.last()).copied();
        let positive = number.filter(|number| *number > 0.0 && number.is_finite());
        positive.ok_or_else(|| self.wrong(required))
    }

    /// The unit of length that a text states.
    fn length_unit(&self, text: &str) -> Result<LengthUnit, TopographyError> {
        text.parse().map_err(|_| self.wrong("a unit of length"))
    }

    /// The unit of its length, or else this one.
    fn unit_or(&self, lateral: Option<LengthUnit>) -> Result<Option<LengthUnit>, TopographyError> {
        self.unit.as_ref().map_or(Ok(lateral), |unit| self.length_unit(unit).map(Some))
    }

    /// Whether the numbers count points, by their unit; `none` if they have none.
    fn counts(&self, none: bool) -> bool {
        self.unit.as_deref().map_or(none, |unit| unit_meaning(unit) == Some("points"))
    }
}

/// Whether a line has a key that is understood.
pub(super) fn is_known(text: &str, delimiter: Delimiter) -> bool {
    entry(text, delimiter).is_some_and(|entry| entry.known())
}

/// The key of a line and what stands behind it: `# Width: 10 µm`, `"Width","10","µm"`, `ncols 48`.
fn entry(text: &str, delimiter: Delimiter) -> Option<Entry> {
    let bare = text.trim_start_matches(COMMENT).trim_start_matches([' ', '"', '*', '\\', '/']);
    // Some keys stand alone or have a word for a value.
    let wordy = |entry: &Entry| {
        let prefixes = ["unit", "name", "scaled", "mark"];
        let word = |key: &&str| key.contains('=') || prefixes.iter().any(|p| key.starts_with(p));
        entry.meanings.iter().any(word)
    };
    let assigned = bare.split_once([':', '=', '\u{ff1a}']);
    let assigned = assigned.map(|(key, words)| Entry::new(bare, key, words, '\t'));
    let parts = ['\t', ';', char::from(delimiter.0), ','].into_iter().filter(|part| *part != ' ');
    let parted = parts.filter_map(|part| {
        let (key, words) = bare.split_once(part)?;
        let entry = Entry::new(bare, key, words, part);
        Some(entry).filter(|entry| wordy(entry) || !entry.numbers.is_empty())
    });
    let spaced = bare.match_indices([' ', '\t']).take(9).filter_map(|(at, _)| {
        let (key, words) = bare.split_at(at);
        number(words.split_whitespace().next()?)?;
        Some(Entry::new(bare, key, words, '\t'))
    });
    let alone = Some(Entry::new(bare, bare, "", ' ')).filter(wordy);
    let known =
        assigned.iter().cloned().chain(parted).chain(spaced).chain(alone).find(Entry::known);
    known.or(assigned)
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
            let found = entry(text, delimiter).map(Entry::of_its_unit);
            let name = |key: &'static str| key.split(['=', '@']).next();
            let meaning = found.iter().flat_map(|entry| entry.meanings).copied().find_map(name);
            for (key, entry) in
                found.iter().flat_map(|entry| entry.meanings.iter().map(move |key| (*key, entry)))
            {
                let mut entry = Entry { line: *line, ..entry.clone() };
                if let Some((_, value)) = key.split_once('=') {
                    (entry.words, entry.numbers) =
                        (value.into(), value.parse().into_iter().collect());
                } else if let Some((_, unit)) = key.split_once('@') {
                    entry.unit = Some(unit.into());
                }
                header.entries.entry(name(key).unwrap_or(key)).or_insert(entry);
            }
            header.lines.push(HeaderLine { line: *line, text: text.clone(), meaning });
        }
        header
    }

    pub(super) fn has(&self, meaning: &str) -> bool {
        self.entries.contains_key(meaning)
    }

    /// The entry of the first of these meanings that the header has.
    fn find<const N: usize>(&self, meanings: [&str; N]) -> Option<&Entry> {
        meanings.into_iter().find_map(|meaning| self.entries.get(meaning))
    }

    /// The name of the channel.
    pub(super) fn name(&self) -> Option<&str> {
        self.find(["name"]).map(|entry| entry.words.as_str())
    }

    /// The unit of the heights: that which their factor leads to, that over their column or that
    /// which a line states.
    pub(super) fn unit(
        &self,
        of_column: Option<LengthUnit>,
    ) -> Result<Option<LengthUnit>, TopographyError> {
        let of_factor = self.find(["factor"]).map_or(Ok(None), |entry| entry.unit_or(None))?;
        let required = "a unit of length, or a conversion factor of the heights";
        let stated = |entry: &Entry| entry.words.parse().map_err(|_| entry.wrong(required));
        match of_factor.or(of_column) {
            None => self.find(["unit"]).map(stated).transpose(),
            unit => Ok(unit),
        }
    }

    /// The factor of the heights, which leads to their unit, with a note of it; `unit` tells
    /// whether that is known.
    pub(super) fn factor(&self, unit: bool) -> Result<Option<(f64, Finding)>, TopographyError> {
        let note = |factor: f64, Entry { line, text, .. }: &Entry| {
            let fact = format!(
                "the heights are multiplied by {}, by line {line}: {:?}",
                written(factor),
                excerpt(text)
            );
            (factor, Finding::note(Code::Factor, "factor", factor).fact(fact))
        };
        // Nova writes `No` where heights are in their unit, Wyko 1 as the second of three flags.
        let scaled = |entry: &Entry| {
            entry.words.eq_ignore_ascii_case("no") || entry.numbers.get(1) == Some(&1.0)
        };
        if self.find(["scaled"]).is_some_and(scaled) {
            return Ok(None);
        }
        let required = "the factor from the heights to a unit of length, as in (-> m)=1e-9";
        if let (Some(wavelength), Some(divisor)) =
            (self.find(["wavelength"]), self.find(["divisor"]))
        {
            let factor = wavelength.positive(9, required)? / divisor.positive(9, required)?;
            return Ok(Some(note(factor, wavelength)));
        }
        let Some(entry) = self.find(["factor"]) else { return Ok(None) };
        let factor = entry.numbers.last().copied().filter(|factor| unit && factor.is_finite());
        factor.map(|factor| Some(note(factor, entry))).ok_or_else(|| entry.wrong(required))
    }

    /// The numbers that mark missing points.
    pub(super) fn missing(&self) -> &[f64] {
        self.find(["missing"]).map_or(&[], |entry| &entry.numbers)
    }

    /// Whether it states a width, which positions in columns would repeat.
    pub(super) fn has_size(&self) -> bool {
        self.find(["width", "height", "size"]).is_some()
    }

    /// The number of columns and of rows.
    pub(super) fn points(&self) -> Result<[Option<usize>; 2], TopographyError> {
        let count = |axis: usize| {
            let own = self.find([["points x"], ["points y"]][axis]);
            let own = own.filter(|entry| entry.counts(true) && !entry.numbers.is_empty());
            let size =
                || self.find([["width"], ["height"]][axis]).filter(|entry| entry.counts(false));
            let both = || self.find(["points"]).filter(|entry| entry.numbers.len() == 2);
            let Some(entry) = own.or_else(size).or_else(both) else { return Ok(None) };
            let number = entry.positive(axis, "a number of points")?;
            let whole = number.fract() == 0.0 && number <= MAX_POINTS as f64;
            whole.then_some(Some(number as usize)).ok_or_else(|| entry.wrong("a number of points"))
        };
        Ok([count(0)?, count(1)?])
    }

    /// Refuses a table of another size than the header states.
    pub(super) fn check(&self, found: [usize; 2]) -> Result<(), TopographyError> {
        let stated = self.points()?;
        if stated.iter().zip(found).all(|(stated, found)| stated.is_none_or(|n| n == found)) {
            return Ok(());
        }
        let [x, y] = stated.map(|n| n.map_or("?".to_owned(), |n| n.to_string()));
        let required = format!("the {} x {} of the table", found[0], found[1]);
        Err(refuse("header", format!("{x} x {y} points"), required))
    }

    /// The unit of lengths along an axis.
    pub(super) fn lateral(
        &self,
        axis: usize,
        options: &ReadOptions,
    ) -> Result<Option<LengthUnit>, TopographyError> {
        let keys = [["unit x", "unit xy", "unit y"], ["unit y", "unit x", "unit xy"]][axis];
        let unit = self.find(keys).map(|entry| entry.length_unit(&entry.words)).transpose()?;
        agree("units", options.lateral(axis), unit)
    }

    /// The distance of points along the axes of a table of this many columns and rows.
    pub(super) fn pixel_size(
        &self,
        [columns, rows]: [usize; 2],
        options: &ReadOptions,
    ) -> Result<Option<[Distance; 2]>, TopographyError> {
        let square = columns == rows || rows == 1;
        let side = |axis, n| self.side(axis, n, square, options);
        let [x, y] = [side(0, columns)?, side(1, rows)?];
        let y = y.or(x.filter(|_| rows == 1));
        Ok(x.zip(y).map(|(x, y)| [x, y]))
    }

    /// The stated distance of points along an axis, with its entry.
    fn step(
        &self,
        axis: usize,
        lateral: Option<LengthUnit>,
    ) -> Result<Option<(&Entry, Distance)>, TopographyError> {
        let step = self.find([["step x", "step"], ["step y", "step"]][axis]);
        let step = step.filter(|entry| entry.unit.is_some() || lateral.is_some());
        let Some(entry) = step.or_else(|| self.find(["pixel"])) else { return Ok(None) };
        let aspect = self.find(["aspect"]).filter(|_| axis == 0);
        let aspect = aspect.map_or(Ok(1.0), |entry| entry.positive(9, "a ratio"))?;
        let value = aspect * entry.positive(axis, "a length above 0")?;
        Ok(Some((entry, Distance { value, unit: entry.unit_or(lateral)? })))
    }

    /// The distance of points along an axis, of a side of `n` points.
    fn side(
        &self,
        axis: usize,
        n: usize,
        square: bool,
        options: &ReadOptions,
    ) -> Result<Option<Distance>, TopographyError> {
        let lateral = self.lateral(axis, options)?;
        let step = self.step(axis, lateral);
        // One number is the size of a square.
        let both = || self.find(["size"]).filter(|entry| square || entry.numbers.len() == 2);
        let size = self.find([["width"], ["height"]][axis]).or_else(both);
        if let Some(entry) = size.filter(|entry| !entry.counts(false)) {
            let length = entry.positive(axis, "a length, for example 10 um")?;
            match entry.unit_or(lateral)? {
                Some(unit) => {
                    let whole = length * unit.metres();
                    if let Ok(Some((step, Distance { value, unit: Some(unit) }))) = step {
                        // It may be measured from the first point to the last.
                        let (over, slack) = (whole / (value * unit.metres()), 1e-2 * n as f64);
                        if !(n as f64 - 1.0 - slack..=n as f64 + slack).contains(&over) {
                            let stated =
                                |entry: &Entry| format!("{:?} in line {}", entry.text, entry.line);
                            let found = format!("{} and {}", stated(entry), stated(step));
                            let required = format!(
                                "a side of {n} times the distance of points; skip_lines leaves lines out"
                            );
                            return Err(refuse("header", found, required));
                        }
                    }
                    return Ok(Some(Distance::metre(whole / n as f64)));
                }
                // The number of points.
                None if length.total_cmp(&(n as f64)).is_eq() || options.pixel_size.is_some() => {}
                None => return Err(no_unit(format!("line {}", entry.line), &entry.text)),
            }
        }
        if let Some((_, step)) = step? {
            return Ok(Some(step));
        }
        let Some(entry) = self.find([["range x"], ["range y"]][axis]) else { return Ok(None) };
        let [first, last] = entry.numbers[..] else { return Err(entry.wrong("two positions")) };
        let value = (last - first) / (n.max(2) - 1) as f64;
        let usable = value > 0.0 && value.is_finite();
        let size = usable.then_some(Some(Distance { value, unit: lateral }));
        size.ok_or_else(|| entry.wrong("two rising positions"))
    }
}

/// The error of a length that has no unit.
pub(super) fn no_unit(place: String, found: &str) -> TopographyError {
    let choice = "those of lengths and heights, as um,nm";
    undecided(place, format!("{found} has no unit"), "units", choice)
}
