//! Lines of text: encoding, delimiter, quotes, decimal separator.

use std::borrow::Cow;

use crate::TopographyError;
use crate::error::refuse_line;

/// Bytes at the beginning of a line that is a comment.
pub(super) const COMMENT: [char; 7] = ['#', '%', '\\', '/', '*', '!', ';'];

/// The text without its mark, in UTF-8 or Latin 1, with the line ends of Unix and `No Data` as one
/// word.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, [u8]>, TopographyError> {
    let mut text: Cow<'_, [u8]> = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => rest.into(),
        [0xff, 0xfe, rest @ ..] => utf16(rest, u16::from_le_bytes)?.into(),
        [0xfe, 0xff, rest @ ..] => utf16(rest, u16::from_be_bytes)?.into(),
        bytes => bytes.into(),
    };
    // Old Macs
    if !text.contains(&b'\n') && text.contains(&b'\r') {
        text.to_mut().iter_mut().filter(|byte| **byte == b'\r').for_each(|byte| *byte = b'\n');
    }
    // Spaces would separate these words.
    const NO_DATA: &[u8] = b"no data";
    let is_mark = |part: &[u8]| part.eq_ignore_ascii_case(NO_DATA);
    let mut done = 0;
    while let Some(ahead) = text[done..].windows(NO_DATA.len()).position(is_mark) {
        let at = done + ahead;
        done = at + NO_DATA.len();
        text.to_mut()[at..done].copy_from_slice(b" nodata");
    }
    Ok(text)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<Vec<u8>, TopographyError> {
    let units = bytes.as_chunks().0.iter().map(|pair| unit(*pair));
    let text: Result<String, _> = char::decode_utf16(units).collect();
    let required = "UTF-16 text, by the first two bytes";
    Ok(text.map_err(|error| refuse_line(1, &error.to_string(), required))?.into_bytes())
}

/// A line in UTF-8, or else in Latin 1: instruments write µ in either.
pub(super) fn text(line: &[u8]) -> String {
    let latin = |_| line.iter().map(|byte| char::from(*byte)).collect();
    std::str::from_utf8(line).map_or_else(latin, str::to_owned)
}

/// The separator of the fields of a line; a space stands for any number of blanks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Delimiter(pub(super) u8);

impl Delimiter {
    /// The delimiter of a row. Commas within numbers between spaces are decimal commas, as beside
    /// semicolons or tabs.
    pub(super) fn detect(line: &[u8]) -> Self {
        // Whole numbers have none; beside a separator, a comma stands at the end of a word.
        let decimal = |word: &[u8]| {
            !word.starts_with(b",") && !word.ends_with(b",") && value(word, true).is_some()
        };
        let mut words = Self(b' ').fields(line);
        Self(match () {
            () if line.contains(&b';') => b';',
            () if line.trim_ascii().contains(&b'\t') => b'\t',
            () if line.contains(&b',') && words.clone().count() > 1 && words.all(decimal) => b' ',
            () if line.contains(&b',') => b',',
            () => b' ',
        })
    }

    /// Whether commas seem to stand within numbers as well as between them: `0,5, 1,5, 2,5`.
    pub(super) fn has_two_commas(line: &[u8]) -> bool {
        let words: Vec<_> = Self(b' ').fields(line).collect();
        let bare = || words.iter().map(|word| word.strip_suffix(b",").unwrap_or(word));
        let is_list = words.len() > 1 && words.iter().any(|word| word.ends_with(b","));
        let has_decimal = bare().any(|word| word.contains(&b',')) && !line.contains(&b'"');
        is_list && has_decimal && bare().all(|word| value(word, true).is_some())
    }

    fn parts(self, byte: u8) -> bool {
        byte == self.0 || self.0 == b' ' && byte.is_ascii_whitespace()
    }

    /// Whether commas within fields are decimal.
    pub(super) fn decimal_comma(self) -> bool {
        self.0 != b','
    }

    /// The fields of a line, with quotes and without the spaces around them.
    pub(super) fn fields(self, line: &[u8]) -> impl Iterator<Item = &[u8]> + Clone {
        let mut quoted = false;
        line.split(move |byte| {
            quoted ^= *byte == b'"';
            !quoted && self.parts(*byte)
        })
        .map(<[u8]>::trim_ascii)
        .filter(move |field| self.0 != b' ' || !field.is_empty())
    }

    /// The line without its trailing delimiter, if it has one.
    pub(super) fn open(self, line: &[u8]) -> Option<&[u8]> {
        let (last, rest) = line.split_last()?;
        (self.0 != b' ' && self.parts(*last)).then_some(rest)
    }

    /// Whether a line can be the first row: all fields are values, and not all are marks such as
    /// `---`, which may underline a header.
    pub(super) fn is_row(self, line: &[u8]) -> bool {
        self.fields(line).all(|field| value(field, self.decimal_comma()).is_some())
            && self.fields(line).any(|field| field.iter().any(u8::is_ascii_alphanumeric))
    }
}

/// A finite number, NaN for a missing point, `None` for any other text. The decimal separator is a
/// point or, if `comma` or in quotes, a comma, which may also end the field.
pub(super) fn value(field: &[u8], comma: bool) -> Option<f64> {
    let bare = field.strip_prefix(b"\"").and_then(|field| field.strip_suffix(b"\""));
    let (field, comma) = bare.map_or((field, comma), |bare| (bare.trim_ascii(), true));
    let bare = field.strip_suffix(b",").filter(|bare| comma && !bare.is_empty());
    let field = bare.unwrap_or(field);
    let text = std::str::from_utf8(field).ok()?;
    let number = match text.parse::<f64>() {
        Err(_) if comma && text.matches([',', '.']).count() == 1 => text.replace(',', ".").parse(),
        number => number,
    };
    match number {
        Ok(number) if number.is_infinite() => None,
        Ok(number) => Some(number),
        Err(_) => {
            let marks = field.iter().all(|byte| matches!(byte, b'*' | b'-'));
            let names = ["bad", "null", "none", "na", "n/a", "nodata", "1.#qnan"];
            let missing = marks || names.iter().any(|name| text.eq_ignore_ascii_case(name));
            missing.then_some(f64::NAN)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quoted_fields_are_one_and_have_decimal_commas() {
        let values = |delimiter: u8, line: &str| -> Vec<Option<f64>> {
            Delimiter(delimiter).fields(line.as_bytes()).map(|field| value(field, false)).collect()
        };
        assert_eq!(values(b',', "\"1,5\", 2.5 ,x,1e999"), [Some(1.5), Some(2.5), None, None]);
        assert_eq!(values(b' ', "\"-4\"  5e1"), [Some(-4.0), Some(50.0)]);
        for missing in ["", "nan", "NaN", "***", "bad", "--", "\"\"", "1.#QNAN"] {
            assert!(value(missing.as_bytes(), true).is_some_and(f64::is_nan), "{missing}");
        }
    }
}
