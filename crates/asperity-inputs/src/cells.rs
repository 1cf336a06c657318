//! Cells of a csv: its delimiter, its numbers, and how else to write those that are refused.

use crate::document::shorten;

/// The beginning of a text in quotes, with its narrow blanks as they are.
pub(crate) fn quoted(text: &str) -> String {
    format!("\"{}\"", shorten(text).replace(char::is_control, " "))
}

/// A number with a point where other cells have decimal commas: 1.500 may be 1,5 or 1500.
pub(crate) const BESIDE_COMMAS: &str = "has a point where other cells have decimal commas; write a comma, or no separator of thousands";

/// Advice for a row with more cells than columns.
pub(crate) fn delimiter_hint(delimiter: u8) -> &'static str {
    match delimiter {
        b',' => {
            "; numbers with decimal commas are read where semicolons or tabs separate the columns"
        }
        _ => "",
    }
}

/// The delimiter of the header, the first line that is no comment.
pub(crate) fn delimiter(text: &str) -> u8 {
    let head = text.lines().find(|line| !line.is_empty() && !line.starts_with('#'));
    let has = |delimiter: char| head.is_some_and(|head| head.contains(delimiter));
    match (has(';'), has('\t')) {
        (true, _) => b';',
        (_, true) => b'\t',
        _ => b',',
    }
}

/// A number; its comma is a decimal comma where commas do not separate cells.
pub(crate) fn number(text: &str, delimiter: u8) -> Option<f64> {
    text.parse().ok().or_else(|| {
        let is_decimal = delimiter != b',' && text.matches(',').count() == 1 && !text.contains('.');
        is_decimal.then(|| text.replace(',', ".").parse().ok()).flatten()
    })
}
