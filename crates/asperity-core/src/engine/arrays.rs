//! Values of many separations in plain arrays: a few nanoseconds each, and nothing kept beside them.

use asperity_quadrature::Moments;

use crate::engine::compiled::Compiled;
use crate::response::row_check::CANCELLED;
use crate::{At, Contact, ContactError, Quantity};

/// Rows whose integrals are taken together: they stay in the fastest memory.
const TOGETHER: usize = 128;
/// Below this logarithm a scale is no normal number, and what it is multiplied with may make it one.
const LEAST: f64 = -700.0;
/// Below this, slopes are looked at one by one.
const DEEP: f64 = -8.0;

/// What a quantity is read from.
struct Read {
    base: Quantity,
    slope: bool,
    factor: f64,
    /// What it is divided by.
    per: f64,
}

/// What is known of all values of plain arrays.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct FillReport {
    /// The largest [bound](crate::Evaluation::bound).
    pub bound: f64,
    /// The largest [condition](crate::Evaluation::condition).
    pub condition: f64,
}

impl FillReport {
    /// Whether parts cancel in some value so far that an answer would warn of it.
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

/// The way that any contact has: one row after the other.
pub(crate) fn one_by_one(
    contact: &(impl Contact + ?Sized),
    quantities: &[Quantity],
    separations: &[f64],
    columns: &mut [&mut [f64]],
) -> Result<FillReport, ContactError> {
    let mut all = FillReport::NONE;
    for (quantity, column) in quantities.iter().zip(columns) {
        for (s, value) in separations.iter().zip(column.iter_mut()) {
            let found = contact.evaluate_at(*quantity, At::from(*s))?;
            *value = found.value();
            let (bound, condition) = (found.bound(*quantity), found.condition());
            all = all.with(FillReport { bound, condition });
        }
    }
    Ok(all)
}

/// Whether the columns are as many as the quantities, and as long as the separations.
pub(crate) fn check(
    quantities: &[Quantity],
    separations: &[f64],
    columns: &[&mut [f64]],
) -> Result<(), ContactError> {
    let wrong = |field, value: usize, required| {
        Err(ContactError::OutOfRange { field, value: value as f64, required })
    };
    if columns.len() != quantities.len() {
        return wrong("the number of columns", columns.len(), "one for each quantity,");
    }
    match columns.iter().find(|column| column.len() != separations.len()) {
        Some(column) => wrong("the length of a column", column.len(), "that of the separations,"),
        None => Ok(()),
    }
}

impl Compiled {
    /// [`Contact::fill`] where all quantities are integrals times a number.
    pub(crate) fn filled(
        &self,
        quantities: &[Quantity],
        separations: &[f64],
        columns: &mut [&mut [f64]],
    ) -> Result<FillReport, ContactError> {
        let reads: Option<Vec<Read>> = quantities.iter().map(|q| self.read(*q)).collect();
        let Some(reads) = reads else {
            return one_by_one(self, quantities, separations, columns);
        };
        let slopes = reads.iter().any(|read| read.slope);
        let mut all = FillReport::NONE;
        let (mut moments, mut scales) = ([Moments::NONE; TOGETHER], [0.0; TOGETHER]);
        for (k, s) in separations.chunks(TOGETHER).enumerate() {
            let (moments, scales) = (&mut moments[..s.len()], &mut scales[..s.len()]);
            let (mut base, mut known) = (None, false);
            for (j, (read, column)) in reads.iter().zip(columns.iter_mut()).enumerate() {
                let out = &mut column[TOGETHER * k..][..s.len()];
                if base != Some(read.base) {
                    base = Some(read.base);
                    known = self.channel(read.base)?.total.run(s, slopes, moments).is_some();
                    let ln_scales = moments.iter().map(|moments| moments.ln_scale);
                    scales.iter_mut().zip(ln_scales).for_each(|(scale, ln)| *scale = ln.exp());
                }
                let filled = known.then(|| read.fill(s, moments, scales, out)).flatten();
                all = all.with(match filled {
                    Some(filled) => filled,
                    None => one_by_one(self, &quantities[j..=j], s, &mut [out])?,
                });
            }
        }
        Ok(all)
    }

    fn read(&self, quantity: Quantity) -> Option<Read> {
        let height_std = self.scene().surface.asperity_height_std;
        let nominal_area = self.scene().nominal_area;
        let own = matches!(self.bases(Quantity::Stiffness), [Quantity::Stiffness]);
        let (base, slope, per) = match quantity {
            Quantity::Force | Quantity::Area | Quantity::Contacts => (quantity, false, 1.0),
            Quantity::Stiffness if own => (quantity, false, 1.0),
            Quantity::Stiffness | Quantity::Tangent => (Quantity::Force, true, height_std),
            Quantity::Pressure => (Quantity::Force, false, nominal_area),
            Quantity::AreaFraction => (Quantity::Area, false, nominal_area),
            _ => return None,
        };
        self.check_requested(quantity).ok()?;
        let factor = self.channel(base).ok()?.units.factor;
        Some(Read { base, slope, factor, per })
    }
}

impl Read {
    /// The values, and what is known of them; none where one is to be looked at by itself.
    fn fill(
        &self,
        s: &[f64],
        moments: &[Moments],
        scales: &[f64],
        out: &mut [f64],
    ) -> Option<FillReport> {
        let n = usize::from(self.slope);
        let (mut plain, mut error, mut condition) = (true, 0.0_f64, 1.0_f64);
        let (mut deepest, mut least) = (0.0_f64, 0.0_f64);
        for (k, of) in moments.iter().enumerate() {
            let value = if self.slope { of.slope } else { of.value };
            let size = of.sizes[n];
            // In the order in which one value is made: the same digits.
            let scaled = if self.slope {
                value / self.per * self.factor
            } else {
                value * self.factor / self.per
            };
            out[k] = scaled * scales[k];
            plain &= out[k].abs() >= f64::MIN_POSITIVE && out[k].abs() < f64::INFINITY;
            let cancelled = if value >= size { 1.0 } else { size / value.abs() };
            condition = condition.max(cancelled);
            error = error.max(of.error * cancelled);
            deepest = deepest.min(s[k]);
            least = least.min(of.ln_scale);
        }
        let plain = plain && least > LEAST && !(self.slope && deepest < DEEP);
        // The rounding of the scale's logarithm, as of one value.
        let bound = error + (0.5 * least.abs() + 3.0) * f64::EPSILON;
        plain.then_some(FillReport { bound, condition })
    }
}
