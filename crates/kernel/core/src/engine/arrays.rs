//! Values at many separations in plain arrays: a few nanoseconds each, with one bound for all.

use asperity_quadrature::{ArrayAccuracy, ScaledIntegral};

use crate::engine::height_integral::SLOPES_CANCEL;
use crate::engine::prepared::Prepared;
use crate::error::require;
use crate::request::quantity_table::Derivation;
use crate::request::separation::LOWEST;
use crate::response::row_check::CANCELLED;
use crate::{At, ContactEngine, ContactError, Quantity};

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

/// Fills a column for each quantity: from `prepared` integrals where the quantity is a multiple of
/// one, otherwise value by value.
pub(crate) fn fill(
    contact: &(impl ContactEngine + ?Sized),
    prepared: Option<&Prepared>,
    quantities: &[Quantity],
    separations: &[f64],
    columns: &mut [&mut [f64]],
) -> Result<FillReport, ContactError> {
    check(quantities, separations, columns)?;
    let mut report = FillReport::NONE;
    for (quantity, column) in quantities.iter().zip(columns) {
        for (s, values) in separations.chunks(FALLBACK_BLOCK).zip(column.chunks_mut(FALLBACK_BLOCK))
        {
            let filled = prepared.and_then(|prepared| multiple(prepared, *quantity, s, values));
            report = report.with(match filled {
                Some(filled) => filled,
                None => one_by_one(contact, *quantity, s, values)?,
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
    contact: &(impl ContactEngine + ?Sized),
    quantity: Quantity,
    separations: &[f64],
    values: &mut [f64],
) -> Result<FillReport, ContactError> {
    let mut report = FillReport::NONE;
    for (s, value) in separations.iter().zip(values) {
        let found = contact.evaluate_at(quantity, At::from(*s))?;
        *value = found.value();
        let (bound, condition) = (found.bound(quantity), found.condition());
        report = report.with(FillReport { bound, condition });
    }
    Ok(report)
}

/// The values, if the quantity is a multiple of an integral and every value is a normal number.
fn multiple(
    prepared: &Prepared,
    quantity: Quantity,
    separations: &[f64],
    values: &mut [f64],
) -> Option<FillReport> {
    prepared.facts.check_requested(quantity).ok()?;
    let (base, slope, factor) = factor(prepared, quantity)?;
    let channel = prepared.channel(base).ok()?;
    let column = ScaledIntegral { shift: 0.0, slope, factor: factor * channel.units.factor };
    if !column.factor.is_normal() {
        return None;
    }
    let ArrayAccuracy { error, condition, normal, lowest } =
        channel.total.fill(separations, column, values)?;
    // The factor is a product of two or three numbers.
    let report = FillReport { bound: error + f64::EPSILON, condition };
    // Near the lowest separation, rows are checked one by one; `lowest` includes the onset.
    let deep = lowest < 0.5 * LOWEST || slope && lowest < SLOPES_CANCEL;
    (normal && !deep).then_some(report)
}

/// The law, whether the slope is required, and the factor, for a multiple of an integral.
fn factor(prepared: &Prepared, quantity: Quantity) -> Option<(Quantity, bool, f64)> {
    let scene = &prepared.scene;
    match quantity.derivation() {
        Derivation::Integral(_) => Some((quantity, false, 1.0)),
        Derivation::IntegralOrSlope(..) if prepared.facts.laws.own_stiffness => {
            Some((quantity, false, 1.0))
        }
        Derivation::IntegralOrSlope(_, of) | Derivation::Slope(of) => {
            Some((of, true, 1.0 / scene.surface.asperity_height_std))
        }
        Derivation::PerNominalArea(of) => {
            let (base, slope, total) = factor(prepared, of)?;
            Some((base, slope, total / scene.nominal_area))
        }
        Derivation::ContactRadii(radii) => {
            let factor = radii.on(&scene.interface, quantity).ok()?;
            Some((quantity.origin(), false, factor))
        }
        _ => None,
    }
}
