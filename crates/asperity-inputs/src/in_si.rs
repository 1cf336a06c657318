//! Numbers with units in the text of a scene file.

use std::fmt::Write;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::hardness::{Stress, hardness};
use crate::notation::{notation_hint, with_decimal_point, without_thousands};
use crate::quantity::units_of;
use crate::template::joined;
use crate::units::{Units, converted, in_other_case, list, read};

/// The error for a text that is not a number in the unit of its key.
pub(crate) struct QuantityError {
    /// The key with its sections.
    pub(crate) path: String,
    pub(crate) found: String,
    pub(crate) reason: Reason,
}

/// Why a text is not a number in the unit of its key.
pub(crate) enum Reason {
    /// How to write the number instead.
    Notation(String),
    /// The text needed, and the same number with a unit that differs only in case.
    Unit { near: Option<String>, needed: String },
}

/// A number with its unit in a text.
struct Stated {
    /// The key with its sections.
    path: String,
    span: Range<usize>,
    /// In SI units.
    value: f64,
}

/// The text with plain numbers instead of numbers with units, and the keys of these; line numbers
/// stay.
pub(crate) fn in_si(
    text: &str,
    table: &DeTable<'_>,
) -> Result<(String, Vec<String>), QuantityError> {
    let mut found = vec![];
    collect(table, "", &mut found)?;
    found.sort_by_key(|stated: &Stated| stated.span.start);
    let (mut rewritten, mut done) = (String::with_capacity(text.len()), 0);
    let mut paths = vec![];
    for Stated { path, span, value } in found {
        paths.push(path);
        rewritten.push_str(text.get(done..span.start).unwrap_or_default());
        // A text in three quotes may contain newlines.
        let lines = text.get(span.clone()).unwrap_or_default().matches('\n').count();
        let _ = write!(rewritten, "{value:?}");
        if lines > 0 {
            rewritten.push_str(" #");
            rewritten.extend(std::iter::repeat_n('\n', lines));
        }
        done = span.end;
    }
    rewritten.push_str(text.get(done..).unwrap_or_default());
    Ok((rewritten, paths))
}

fn collect(
    table: &DeTable<'_>,
    section: &str,
    found: &mut Vec<Stated>,
) -> Result<(), QuantityError> {
    for (name, value) in table {
        let name = name.get_ref();
        match value.get_ref() {
            DeValue::Table(inner) => collect(inner, &joined(section, name), found)?,
            DeValue::Array(items) => {
                let tables = items.iter().zip(1..).filter_map(|(item, k)| match item.get_ref() {
                    DeValue::Table(inner) => Some((inner, format!("{name}[{k}]"))),
                    _ => None,
                });
                for (inner, section) in tables {
                    collect(inner, &section, found)?;
                }
            }
            DeValue::String(given) => {
                if let Some((path, value_in_si)) = number(section, name, given)? {
                    found.push(Stated { path, span: value.span(), value: value_in_si });
                }
            }
            _ => {}
        }
    }
    Ok(())
}

/// The path of a key with a unit, and its number in SI units; `None` for keys without a unit.
fn number(section: &str, name: &str, given: &str) -> Result<Option<(String, f64)>, QuantityError> {
    let bare = section.split('[').next().unwrap_or(section);
    let Some(units) = units_of(bare, name) else { return Ok(None) };
    let path = joined(section, name);
    match read(given, units) {
        Some(number) => Ok(Some((path, number))),
        None => {
            let reason = reason(given, units, Stress::of(name));
            Err(QuantityError { path, found: given.into(), reason })
        }
    }
}

fn reason(given: &str, units: Units, stress: Stress) -> Reason {
    let (si, example, known) = units;
    if let Some(same) = converted(given, si) {
        let needed = format!("a known unit, as in \"{same}\", which is the same,");
        return Reason::Unit { near: None, needed };
    }
    let hint = hardness(given, stress).filter(|_| si == "Pa");
    // The number instead needs no quotes.
    let same = with_decimal_point(given).or_else(|| without_thousands(given));
    let is_plain = same.is_some_and(|same| same.trim().parse::<f64>().is_ok());
    let quotes = if is_plain { " without quotes" } else { "" };
    match hint.or_else(|| notation_hint(given).map(|hint| hint + quotes)) {
        Some(hint) => Reason::Notation(hint),
        None => Reason::Unit {
            near: in_other_case(given, units),
            needed: format!(
                "a number in {si} without quotes, or with a unit, for example \"{example}\" (units: {}),",
                list(known)
            ),
        },
    }
}
