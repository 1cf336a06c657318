//! Plain arrays of values, with one bound for all.

use crate::error::require;
use crate::response::row_check::CANCELLED;
use crate::{At, ContactError, Evaluation, Quantity};

/// Number of values computed one by one if an array of them is not possible.
const FALLBACK_BLOCK: usize = 16_384;

/// Bounds on all values of plain arrays.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FillReport {
    /// The largest [bound](crate::Evaluation::bound).
    pub bound: f64,
    /// No [condition](crate::Evaluation::condition) is larger; where parts cancel, up to half more
    /// than the largest.
    pub condition: f64,
}

impl FillReport {
    /// Whether parts cancel in some value enough for a warning.
    #[must_use]
    pub fn cancels(&self) -> bool {
        self.condition > CANCELLED
    }

    const NONE: Self = Self { bound: 0.0, condition: 1.0 };

    fn with(self, other: Self) -> Self {
        let (bound, condition) = (self.bound.max(other.bound), self.condition.max(other.condition));
        Self { bound, condition }
    }
}

/// Fills a column for each quantity: with `many` values at a time where these are there, otherwise
/// with `one` after the other.
pub(crate) fn fill(
    (many, one): (
        impl Fn(Quantity, &[f64], &mut [f64]) -> Option<FillReport>,
        impl Fn(Quantity, At) -> Result<Evaluation, ContactError>,
    ),
    quantities: &[Quantity],
    separations: &[f64],
    columns: &mut [&mut [f64]],
) -> Result<FillReport, ContactError> {
    check(quantities, separations, columns)?;
    let mut report = FillReport::NONE;
    for (quantity, column) in quantities.iter().zip(columns) {
        for (s, values) in separations.chunks(FALLBACK_BLOCK).zip(column.chunks_mut(FALLBACK_BLOCK))
        {
            report = report.with(match many(*quantity, s, values) {
                Some(filled) => filled,
                None => one_by_one(|at| one(*quantity, at), *quantity, s, values)?,
            });
        }
    }
    Ok(report)
}

/// Refuses columns of another number than the quantities, or another length than the separations.
fn check(
    quantities: &[Quantity],
    separations: &[f64],
    columns: &[&mut [f64]],
) -> Result<(), ContactError> {
    let same = |a: usize, b: usize, field, required| require(a == b, field, a as f64, required);
    let each = "one for each quantity,";
    same(columns.len(), quantities.len(), "the number of columns", each)?;
    let long = |column: &&mut [f64]| {
        let required = "that of the separations,";
        same(column.len(), separations.len(), "the length of a column", required).map(drop)
    };
    columns.iter().try_for_each(long)
}

fn one_by_one(
    one: impl Fn(At) -> Result<Evaluation, ContactError>,
    quantity: Quantity,
    separations: &[f64],
    values: &mut [f64],
) -> Result<FillReport, ContactError> {
    let mut report = FillReport::NONE;
    for (s, value) in separations.iter().zip(values) {
        let found = one(At::from(*s))?;
        *value = found.value();
        let (bound, condition) = (found.bound(quantity), found.condition());
        report = report.with(FillReport { bound, condition });
    }
    Ok(report)
}
