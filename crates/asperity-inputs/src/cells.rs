//! Cells of a csv: its delimiter, its numbers, and how else to write those that are refused.

use crate::document::shorten;
use crate::likely::with_decimal_point;

/// The beginning of a text in quotes, with its narrow blanks as they are.
pub(crate) fn quoted(text: &str) -> String {
    format!("\"{}\"", shorten(text).replace(char::is_control, " "))
}

/// How to write a number with a point where other cells have decimal commas.
pub(crate) fn beside_commas(given: &str) -> String {
    let (decimal, joined) = (given.replacen('.', ",", 1), given.replace('.', ""));
    let is_group = given.rsplit('.').next().is_some_and(|last| last.len() == 3);
    let how = if is_group { format!("{decimal} or {joined}") } else { decimal };
    format!("has a point where other cells have decimal commas; write {how}")
}

/// How to write a number in per cent.
pub(crate) fn share_hint(name: &str, given: &str, delimiter: u8) -> Option<String> {
    let number = given.strip_suffix('%')?.trim();
    let number: f64 = with_decimal_point(number).unwrap_or(number.into()).parse().ok()?;
    Some(match name.strip_suffix("_std") {
        Some(of) => format!("is a share of {of}; write the standard deviation in the unit of {of}"),
        None => {
            let plain = asperity::short(0.01 * number);
            let has_comma = delimiter != b',' && given.contains(',');
            let plain = if has_comma { plain.replace('.', ",") } else { plain };
            format!("has a per cent sign; write {plain}")
        }
    })
}

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
