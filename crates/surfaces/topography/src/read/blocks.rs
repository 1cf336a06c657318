//! Blocks of a text: header lines and the table of numbers below them.

use super::header::is_known;
use super::lines::{COMMENT, Delimiter, text, value};
use super::scan::ReadOptions;
use super::words::meanings;
use crate::error::{at_most, excerpt, refuse, refuse_line, undecided};
use crate::{MAX_POINTS, TopographyError};

/// Header lines, and rows of numbers; NaN for missing values.
#[derive(Debug, Default)]
pub(super) struct Block {
    /// Lines before the first row, with their numbers.
    pub(super) header: Vec<(usize, String)>,
    pub(super) values: Vec<f64>,
    pub(super) columns: usize,
    pub(super) delimiter: Delimiter,
    /// The line of the first row.
    pub(super) line: usize,
    /// The first row that is longer or shorter than the first one.
    pub(super) ragged: Option<TopographyError>,
    /// Rows with a blank line before them, and their lines.
    gaps: Vec<(usize, usize)>,
    /// Whether a delimiter ends each row.
    closed: bool,
    /// The decimal separator, once a row has shown it.
    decimal: Option<u8>,
}

/// The blocks of a text, at least one.
///
/// # Errors
/// [`TopographyError`] when there is no row of numbers, when a field is neither a number nor a mark
/// of a missing point, when a line behind the first row is neither a row nor a comment nor the
/// header of another table, or when there are too many values.
pub(super) fn blocks(bytes: &[u8], options: &ReadOptions) -> Result<Vec<Block>, TopographyError> {
    let mut blocks: Vec<Block> = vec![];
    let mut header: Vec<(usize, String)> = vec![];
    // Keys of lines without a key, which follow a word.
    let mut keys = vec![];
    let mut blank = false;
    let detect = |line: &[u8]| {
        options.delimiter.map_or_else(|| Delimiter::detect(line), |given| Delimiter(given as u8))
    };
    let lines = bytes.split(|byte| *byte == b'\n').enumerate().skip(options.skip_lines);
    for (number, line) in lines.map(|(index, line)| (index + 1, line)) {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if line.trim_ascii().is_empty() {
            blank = true;
            continue;
        }
        if let Some(key) = keys.pop() {
            header.push((number, format!("{key}: {}", text(line))));
            continue;
        }
        // A number alone above rows of several counts them.
        let several = || detect(line).is_row(line) && detect(line).fields(line).count() > 1;
        if header.is_empty()
            && let Some(count) = blocks.pop_if(|block| block.values.len() == 1 && several())
        {
            header = count.header;
        }
        let open = blocks.last_mut().filter(|_| header.is_empty());
        let outside = match open {
            Some(block) => match block.add(number, line, blank) {
                Ok(()) => None,
                Err(error) => {
                    let line = text(line);
                    let comment = line.starts_with(['#', '%'])
                        || line.starts_with(COMMENT) && !block.is_like(&line);
                    match is_known(&line, block.delimiter) {
                        false if comment => None,
                        false if block.is_like(&line) => return Err(error),
                        _ => Some(line),
                    }
                }
            },
            None if detect(line).is_row(line) => {
                if options.delimiter.is_none() && Delimiter::has_two_commas(line) {
                    return Err(two_commas(number, line));
                }
                let mut block = Block::new(line, detect(line), bytes.len());
                (block.header, block.line) = (std::mem::take(&mut header), number);
                block.add(number, line, false)?;
                blocks.push(block);
                None
            }
            None => Some(text(line)),
        };
        if let Some(line) = outside {
            let next = meanings("header", &line).iter().find_map(|key| key.strip_prefix("next="));
            keys = next.map_or(vec![], |next| next.rsplit(';').collect());
            header.push((number, line));
        }
        blank = false;
    }
    let Some(last) = blocks.last_mut() else {
        let (line, found) = header.into_iter().next().unwrap_or((1, String::new()));
        return Err(refuse_line(line, &found, "a row of numbers in this line or below"));
    };
    // Lines below the last table may belong to its header.
    let stray = |(_, line): &&(usize, String)| {
        !is_known(line, last.delimiter) && !line.starts_with(COMMENT)
    };
    if let Some((line, found)) = header.iter().find(stray) {
        return Err(refuse_line(*line, found, "a row of numbers or a comment (#)"));
    }
    last.header.append(&mut header);
    Ok(blocks)
}

/// A line with commas within and between its numbers.
fn two_commas(number: usize, line: &[u8]) -> TopographyError {
    let choices = "\",\" if commas only separate numbers, \" \" if they are decimal marks as well";
    undecided(format!("line {number}"), excerpt(&text(line)), "delimiter", choices)
}

impl Block {
    /// No rows, with the number of columns of the first row.
    fn new(line: &[u8], delimiter: Delimiter, bytes: usize) -> Self {
        let open = delimiter.open(line);
        let columns = delimiter.fields(open.unwrap_or(line)).count();
        // Capacity for rows as long as the first; no row has more fields than bytes.
        let expected = (bytes / (line.len() + 1) + 1) * columns;
        let values = Vec::with_capacity(expected.min(MAX_POINTS));
        Self { values, columns, delimiter, closed: open.is_some(), ..Self::default() }
    }

    pub(super) fn rows(&self) -> usize {
        self.values.len() / self.columns
    }

    /// Whether a line that is no row seems to be a broken one.
    pub(super) fn is_like(&self, line: &str) -> bool {
        let fields = self.delimiter.fields(line.as_bytes());
        let number = |field: &[u8]| value(field, self.delimiter.decimal_comma()).is_some();
        let as_many = fields.clone().count() == self.columns && fields.clone().any(number);
        as_many
            || line
                .trim_start_matches(['-', '+', '.', ' ', '"'])
                .starts_with(|c: char| c.is_ascii_digit())
    }

    fn add(&mut self, number: usize, line: &[u8], blank: bool) -> Result<(), TopographyError> {
        let start = self.values.len();
        let open = if self.closed { self.delimiter.open(line) } else { None };
        let line = open.unwrap_or(line);
        let comma = self.delimiter.decimal_comma();
        for field in self.delimiter.fields(line) {
            let Some(value) = value(field, comma) else {
                self.values.truncate(start);
                let point = if comma { "" } else { " with a decimal point" };
                let required = format!("a finite number{point}, or nan");
                return Err(refuse_line(number, &text(field), &required));
            };
            self.values.push(value);
        }
        for mark in [b'.', b','].into_iter().filter(|mark| comma && line.contains(mark)) {
            if *self.decimal.get_or_insert(mark) != mark {
                let required = "one decimal separator, a point or a comma, in all rows";
                return Err(refuse_line(number, &text(line), required));
            }
        }
        let (found, required) = (self.values.len() - start, self.columns);
        if found != required && self.ragged.is_none() {
            let required = format!("a row of {required}, as the first");
            self.ragged = Some(match Delimiter::has_two_commas(line) && !comma {
                true => two_commas(number, line),
                false => refuse(format!("line {number}"), format!("a row of {found}"), required),
            });
        }
        if blank {
            self.gaps.push((start / self.columns, number));
        }
        at_most("the number of values in the text", self.values.len() as u64, 3 * MAX_POINTS as u64)
    }

    /// The tables of equal size that blank lines separate, if there are several; rows of points and
    /// of profiles may be separated so.
    pub(super) fn split(self) -> Vec<Self> {
        let size = self.gaps.first().map_or(0, |(row, _)| *row);
        let equal = (1..).zip(&self.gaps).all(|(k, (row, _))| *row == k * size);
        let whole = size * (self.gaps.len() + 1) == self.rows();
        if size < 2 || self.columns < 4 || !equal || !whole || self.ragged.is_some() {
            return vec![self];
        }
        let lines = std::iter::once(self.line).chain(self.gaps.iter().map(|(_, line)| *line));
        let tables = self.values.chunks(size * self.columns).zip(lines);
        let Self { columns, delimiter, .. } = self;
        let part = |(values, line): (&[f64], usize)| {
            let (header, values) = (self.header.clone(), values.to_vec());
            Self { header, values, columns, delimiter, line, ..Self::default() }
        };
        tables.map(part).collect()
    }
}
