//! Usual ranges of numbers, and findings of numbers outside them.

use crate::{Finding, Severity};

/// The advice about an unusual number.
pub const CHECK_UNIT: &str = "check the number and its unit";

/// Whether a value is in a range, ends included.
pub(super) fn within(value: f64, [from, to]: [f64; 2]) -> bool {
    (from..=to).contains(&value)
}

/// An error ten times outside the usual range, otherwise a warning.
pub(super) fn severity(value: f64, [from, to]: [f64; 2]) -> Severity {
    if value < 0.1 * from || value > 10.0 * to { Severity::Error } else { Severity::Warning }
}

/// A finding with the likely unit, if there is one.
pub(super) fn with_unit(found: Finding, unit: Option<String>) -> Finding {
    match unit {
        Some(unit) => found.likely_unit(unit),
        None => found,
    }
}

/// A finding for a number outside the usual range of materials.
pub(super) fn unusual(field: &'static str, value: f64, usual: [f64; 2]) -> Finding {
    Finding::warning("unusual-size", field, value).usual(usual).severity(severity(value, usual))
}
