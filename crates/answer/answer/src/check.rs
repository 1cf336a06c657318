//! The check of a scene as a sheet.

use asperity::Check;

use crate::{Cell, Sheet};

/// A row for each derived number, with the ends of its range where a surface is known within
/// ranges, and the findings.
#[must_use]
pub fn check_sheet(checked: Check) -> Sheet {
    let has_ends = checked.numbers.iter().any(|number| number.ends.is_some());
    let ends = if has_ends { &["lower", "upper"][..] } else { &[] };
    let mut sheet = Sheet::default();
    sheet.under(&[&["name", "value"], ends, &["unit", "meaning"]]);
    sheet.rows.extend(checked.numbers.iter().map(|number| {
        let mut row = vec![(&*number.name).into(), Cell::Number(number.value)];
        let end = |k: usize| Cell::from(number.ends.map(|ends| ends[k]));
        row.extend((0..ends.len()).map(end));
        row.extend([number.unit.into(), (*number.meaning).into()]);
        row
    }));
    sheet.findings.extend(checked.findings);
    sheet
}
