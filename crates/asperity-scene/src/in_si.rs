//! Numbers with units in the text of a scene file.

use std::fmt::Write;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::notation::{with_decimal_point, without_thousands};
use crate::quantity::units_of;
use crate::template::joined;
use crate::units::{converted, in_other_case, list, read};

/// The error for a text that is not a number in the unit of its key.
pub(crate) struct QuantityError {
    /// The key with its sections.
    pub(crate) path: String,
    pub(crate) found: String,
    /// The same number with a unit that differs only in case.
    pub(crate) near: Option<String>,
    pub(crate) needed: String,
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
    let items = table.iter().map(|(name, value)| (name.get_ref().to_string(), value));
    for (name, value) in items {
        match value.get_ref() {
            DeValue::Table(inner) => collect(inner, &joined(section, &name), found)?,
            DeValue::Array(tables) => {
                for (table, k) in tables.iter().zip(1..) {
                    if let DeValue::Table(inner) = table.get_ref() {
                        collect(inner, &format!("{name}[{k}]"), found)?;
                    }
                }
            }
            DeValue::String(given) => {
                let bare = section.split('[').next().unwrap_or(section);
                if let Some(units) = units_of(bare, &name) {
                    let dot = if section.is_empty() { "" } else { "." };
                    let path = format!("{section}{dot}{name}");
                    let Some(number) = read(given, units) else {
                        let ((si, example, _), known) = (units, list(units.2));
                        let plain = (with_decimal_point(given), without_thousands(given));
                        let needed = match (converted(given, si), plain) {
                            (Some(same), _) => {
                                format!("a known unit, as in \"{same}\", which is the same,")
                            }
                            (_, (Some(decimal), Some(thousands))) => {
                                format!("either \"{decimal}\" or \"{thousands}\"")
                            }
                            (_, (Some(same), None)) => {
                                format!("a decimal point, as in \"{same}\",")
                            }
                            (_, (None, Some(same))) => {
                                format!("a number without separators, as in \"{same}\",")
                            }
                            _ => format!(
                                "a number in {si} without quotes, or with a unit, for example \"{example}\" (units: {known}),"
                            ),
                        };
                        let near = in_other_case(given, units);
                        return Err(QuantityError { path, found: given.to_string(), near, needed });
                    };
                    found.push(Stated { path, span: value.span(), value: number });
                }
            }
            _ => {}
        }
    }
    Ok(())
}
