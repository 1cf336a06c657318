//! Parser of text to a table of numbers: a header, then rows of equal length.

use crate::error::{at_most, refuse_line};
use crate::{MAX_POINTS, TopographyError};

/// A table of numbers; NaN for missing values.
pub(super) struct NumberTable {
    /// Lines before the first row, with their numbers.
    pub(super) header: Vec<(usize, String)>,
    pub(super) values: Vec<f64>,
    pub(super) columns: usize,
    pub(super) delimiter: Delimiter,
    /// Whether a delimiter ends each row.
    closed: bool,
    /// The decimal separator, once a row has shown it.
    decimal: Option<u8>,
}

/// The separator of the fields of a line; a space stands for any number of blanks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Delimiter(pub(super) u8);

impl Delimiter {
    /// The delimiter of the first row. Commas within numbers between spaces are decimal commas, as
    /// beside semicolons or tabs.
    fn detect(line: &[u8]) -> Self {
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

    fn parts(self, byte: u8) -> bool {
        byte == self.0 || self.0 == b' ' && byte.is_ascii_whitespace()
    }

    /// The fields of a line, without the spaces around them.
    pub(super) fn fields(self, line: &[u8]) -> impl Iterator<Item = &[u8]> + Clone {
        line.split(move |byte| self.parts(*byte))
            .map(<[u8]>::trim_ascii)
            .filter(move |field| self.0 != b' ' || !field.is_empty())
    }

    /// The line without its trailing delimiter, if it has one.
    fn open(self, line: &[u8]) -> Option<&[u8]> {
        let (last, rest) = line.split_last()?;
        (self.0 != b' ' && self.parts(*last)).then_some(rest)
    }
}

impl NumberTable {
    /// # Errors
    /// [`TopographyError`] when there is no row of numbers, when rows differ in length, when a
    /// field is neither a number nor a mark of a missing point, or when there are too many values.
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, TopographyError> {
        let mut header = Vec::new();
        let mut rows: Option<Self> = None;
        for (index, line) in bytes.split(|byte| *byte == b'\n').enumerate() {
            let (number, line) = (index + 1, line.strip_suffix(b"\r").unwrap_or(line));
            if line.trim_ascii().is_empty() || rows.is_some() && line.starts_with(b"#") {
                continue;
            }
            // A number alone above rows of several counts them.
            let counted = |rows: &Self| rows.values.len() == 1 && Self::new(line, 0).columns > 1;
            if rows.as_ref().is_some_and(counted) {
                rows = None;
            }
            match &mut rows {
                Some(rows) => rows.add(number, line)?,
                None if is_row(line) => {
                    rows.insert(Self::new(line, bytes.len())).add(number, line)?;
                }
                None => header.push((number, decode(line))),
            }
        }
        let Some(rows) = rows else {
            let (line, found) = header.into_iter().next().unwrap_or((1, String::new()));
            return Err(refuse_line(line, &found, "a row of numbers in this line or below"));
        };
        Ok(Self { header, ..rows })
    }

    /// No rows, with the delimiter and the number of columns of the first row.
    fn new(line: &[u8], bytes: usize) -> Self {
        let delimiter = Delimiter::detect(line);
        let open = delimiter.open(line);
        let columns = delimiter.fields(open.unwrap_or(line)).count();
        // Capacity for rows as long as the first; no row has more fields than bytes.
        let expected = (bytes / (line.len() + 1) + 1) * columns;
        let values = Vec::with_capacity(expected.min(MAX_POINTS));
        let closed = open.is_some();
        Self { header: vec![], values, columns, delimiter, closed, decimal: None }
    }

    fn add(&mut self, number: usize, line: &[u8]) -> Result<(), TopographyError> {
        let start = self.values.len();
        let open = if self.closed { self.delimiter.open(line) } else { None };
        let line = open.unwrap_or(line);
        let comma = self.delimiter.0 != b',';
        for field in self.delimiter.fields(line) {
            self.values.push(value(field, comma).ok_or_else(|| {
                let required = match comma {
                    true => "a finite number, or nan,",
                    false => "a finite number with a decimal point, or nan,",
                };
                refuse_line(number, &decode(field), required)
            })?);
        }
        for mark in [b'.', b','].into_iter().filter(|mark| comma && line.contains(mark)) {
            if *self.decimal.get_or_insert(mark) != mark {
                let required = "one decimal separator, a point or a comma, in all rows";
                return Err(refuse_line(number, &decode(line), required));
            }
        }
        let (found, required) = (self.values.len() - start, self.columns);
        if found != required {
            return Err(TopographyError::RowLength { line: number, found, required });
        }
        let size = self.values.len() as u64;
        at_most("the number of values in the text", size, 3 * MAX_POINTS as u64)
    }

    /// Removes a third column without values, as after `1.5,2.5,,`.
    pub(super) fn drop_empty(&mut self) {
        let empty = || self.values.chunks(3).all(|row| row.last().is_some_and(|z| z.is_nan()));
        if self.columns == 3 && empty() {
            self.drop_column(2);
        }
    }

    /// Removes a column.
    pub(super) fn drop_column(&mut self, column: usize) {
        let mut places = (0..self.columns).cycle();
        self.values.retain(|_| places.next() != Some(column));
        self.columns -= 1;
    }

    /// NaN in the second column where the third is 0.
    pub(super) fn drop_invalid(&mut self) {
        for row in self.values.chunks_mut(self.columns) {
            if let [_, height, valid] = row
                && *valid == 0.0
            {
                *height = f64::NAN;
            }
        }
    }
}

/// Whether a line can be the first row: all fields are values, and not all are marks such as `---`,
/// which may underline a header.
fn is_row(line: &[u8]) -> bool {
    let delimiter = Delimiter::detect(line);
    let number = |field: &[u8]| value(field, delimiter.0 != b',').is_some();
    delimiter.fields(line).all(number)
        && delimiter.fields(line).any(|field| field.iter().any(u8::is_ascii_alphanumeric))
}

/// A finite number, NaN for a missing point, `None` for any other text. The decimal separator is a
/// point or, if `comma`, a comma.
fn value(field: &[u8], comma: bool) -> Option<f64> {
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

/// UTF-8 text, or else Latin 1: instruments write µ in either.
pub(super) fn decode(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|byte| char::from(*byte)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_with_whole_numbers_among_decimal_commas_are_rows() {
        let text = b"0,1 0,5 1 0,3\n0,2 0,4 0,7 0,9\n1 2 3 4\n";
        let table = NumberTable::parse(text).unwrap();
        assert!(table.header.is_empty());
        assert_eq!((table.columns, table.values.len(), table.values[2]), (4, 12, 1.0));
        // A comma at the end of a word separates.
        assert_eq!(NumberTable::parse(b"1, 2, 3\n4, 5, 6\n").unwrap().columns, 3);
        assert_eq!(NumberTable::parse(b"1.5 ,2.5 ,3\n").unwrap().columns, 3);
    }

    #[test]
    fn decimal_commas_are_read_where_commas_do_not_separate() {
        for text in ["1,5;2\n-3,25e1;4\n", "1,5\t2\n-3,25e1\t4", "1,5 2,0\n-3,25e1 4\n"] {
            assert_eq!(values(text), (2, vec![1.5, 2.0, -32.5, 4.0]), "{text}");
        }
        assert_eq!(values("1,5\n2,5\n"), (2, vec![1.0, 5.0, 2.0, 5.0]));
        let both = message(b"1,5;2\n3.5;4\n");
        assert!(both.starts_with("line 2: \"3.5;4\""), "{both}");
        assert!(message(b"1;2\n3;1,5,5\n").starts_with("line 2: \"1,5,5\" was found"));
    }

    #[test]
    fn a_count_above_the_rows_is_a_header() {
        assert_eq!(values("um um\n2\n1, 2\n3, 4\n"), (2, vec![1.0, 2.0, 3.0, 4.0]));
        assert_eq!(values("1\n2\n3\n"), (1, vec![1.0, 2.0, 3.0]));
    }

    fn values(text: &str) -> (usize, Vec<f64>) {
        let table = NumberTable::parse(text.as_bytes()).unwrap();
        (table.columns, table.values)
    }

    fn message(bytes: &[u8]) -> String {
        NumberTable::parse(bytes).err().unwrap().to_string()
    }

    #[test]
    fn the_first_row_sets_the_delimiter() {
        for text in [
            "1 2.5  3\n-4 5e1 6",
            "1,2.5,3\r\n-4, 5e1 ,6\r\n",
            "1\t2.5\t3\n-4\t5e1\t6\n",
            "1;2.5;3;\n-4;5e1;6;\n",
        ] {
            assert_eq!(values(text), (3, vec![1.0, 2.5, 3.0, -4.0, 50.0, 6.0]), "{text}");
        }
    }

    #[test]
    fn missing_points_have_several_marks() {
        let (columns, found) = values("head, er\n1,nan,,NaN\n***,2,bad,--\n# later\n1,2,3,4");
        assert_eq!((columns, found.len()), (4, 12));
        let missing: Vec<_> = found.iter().map(|value| value.is_nan()).collect();
        assert_eq!(missing[..8], [false, true, true, true, true, false, true, true]);
        // A row of nan is a row, a row of dashes a header.
        assert_eq!(values("nan nan\n1 2").1.len(), 4);
        assert_eq!(values("a b\n--- ---\n1 2").1.len(), 2);
    }

    #[test]
    fn invalid_tables_are_refused_with_the_line() {
        assert!(message(b"").starts_with("line 1: \"\""));
        assert!(message(b"some\nwords").starts_with("line 1: \"some\""));
        let ragged = NumberTable::parse(b"h\n1 2 3\n1 2\n");
        let wanted = |error: &_| {
            matches!(error, TopographyError::RowLength { line: 3, found: 2, required: 3 })
        };
        assert!(ragged.err().as_ref().is_some_and(wanted));
        assert!(message(b"1 2\n3 inf\n").starts_with("line 2: \"inf\""));
        assert!(message(b"1 2\n3 1e999\n").starts_with("line 2: \"1e999\""));
        assert!(message(b"1 2\n3 \xff\xfe\n").starts_with("line 2: \"ÿþ\""));
        assert!(message(b"\x00\x00\n").starts_with("line 1: \"\\0\\0\""));
    }
}
