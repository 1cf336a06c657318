//! The separations that carry a load.

use asperity_quadrature::Moments;

use crate::ContactError;
use crate::engine::inverse::force_at::ForceAt;
use crate::engine::inverse::interval::Level;
use crate::error::{positive, require};
use crate::scene::place::{HIGHEST, LOWEST, SeparationInSigma};

pub(crate) mod above;
pub(crate) mod force_at;
pub(crate) mod interval;
mod newton;
mod search;
mod variation;

/// Below this all asperities are in contact.
pub(crate) const ALL_TOUCH: f64 = -64.0;

/// The integrals of the added and of the subtracted parts of a law, both positive.
pub(crate) type Halves = [Moments; 2];

/// The integral of a force that falls with the separation.
pub(crate) trait ForceCurve {
    /// The integral and its slope.
    fn at(&mut self, s: f64) -> Result<Moments, ContactError>;

    /// Makes finer integrals near s; returns whether there were any.
    fn settle(&mut self, _s: f64) -> Result<bool, ContactError> {
        Ok(false)
    }

    /// The halves at s, to a thousandth at least; `None` if a part changes its sign, or if they
    /// cannot be told apart.
    fn halves(&mut self, _s: f64) -> Result<Option<Halves>, ContactError> {
        Ok(None)
    }
}

impl<F: FnMut(f64) -> Result<Moments, ContactError>> ForceCurve for F {
    fn at(&mut self, s: f64) -> Result<Moments, ContactError> {
        self(s)
    }
}

/// A load to be carried.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CarriedLoad {
    /// \[N\]; below 0 for a tension.
    pub(crate) load: f64,
    /// The factor of the integral \[N\].
    pub(crate) factor: f64,
}

/// Checks a load or a pressure: above 0, or a tension with adhesion.
pub(crate) fn check_load(
    field: &'static str,
    value: f64,
    adhesive: bool,
) -> Result<f64, ContactError> {
    let subnormal = value != 0.0 && value.abs() < f64::MIN_POSITIVE;
    require(!subnormal, field, value, "one that a double holds to all digits (2.2e-308 and more)")?;
    let required = "a finite number other than 0 (below it for tensions)";
    match adhesive {
        true => require(value.is_finite() && value != 0.0, field, value, required),
        false => positive(field, value),
    }
}

impl CarriedLoad {
    /// Where a force that need not fall everywhere first carries the load: on approach at the
    /// largest separation, and in tension, pulled from contact, at the smallest.
    pub(crate) fn first(&self, force: &ForceAt<'_>) -> Result<SeparationInSigma, ContactError> {
        let pulled = self.load < 0.0;
        let found = self.crossings(force, !pulled)?;
        let first = if pulled { found.last() } else { found.first() };
        let s = first.copied().unwrap_or(f64::NAN);
        let mut moments = force.force(s)?;
        if moments.slope.is_nan() {
            let near = 1e-6 * (1.0 + s.abs());
            let [low, high] = [force.force(s - near)?, force.force(s + near)?];
            let [low, high] = [low, high].map(|m| m.value * (m.ln_scale - moments.ln_scale).exp());
            moments.slope = (low - high) / (2.0 * near);
        }
        Ok(place(s, &moments))
    }

    /// The logarithm of the integral of the smallest force that f64 holds to all digits.
    pub(crate) fn ln_least(&self) -> f64 {
        f64::MIN_POSITIVE.ln() - self.factor.ln()
    }

    /// The separations from the largest on, or the largest alone; a refusal names the largest
    /// force.
    pub(crate) fn crossings(
        &self,
        force: &ForceAt<'_>,
        first_only: bool,
    ) -> Result<Vec<f64>, ContactError> {
        let sign = self.load.signum();
        // No force exceeds its variation, which falls with the separation.
        let bound = Self { load: self.load.abs(), ..*self };
        let level = Level { sign, ln: (self.load.abs() / self.factor).ln() };
        let top = match bound.newton(&mut |s| force.variation(s)) {
            Ok(top) => top.s + top.rounding + 1e-9 * (1.0 + top.s.abs()),
            Err(ContactError::TooLight { .. }) => {
                let far = force.sample(HIGHEST)?;
                if sign > 0.0 && far.reaches(level) {
                    let smallest = far.force.value * far.force.ln_scale.exp() * self.factor;
                    return Err(ContactError::TooLight {
                        load: self.load,
                        smallest,
                        at: HIGHEST.into(),
                    });
                }
                HIGHEST
            }
            Err(ContactError::OutOfReach { .. }) => LOWEST,
            Err(other) => return Err(other),
        };
        let found = force.crossings(level, top.min(HIGHEST), first_only)?;
        if found.is_empty() {
            let largest = force.largest(sign, self.ln_least())?;
            return Err(self.out_of_reach(&largest.force, largest.s));
        }
        Ok(found)
    }
}

/// The separation of the force, with the error that follows from the force's.
fn place(s: f64, moments: &Moments) -> SeparationInSigma {
    let error = moments.error * moments.sizes[0] / moments.slope.abs();
    SeparationInSigma { s, rounding: error + 2.0 * f64::EPSILON * (1.0 + s.abs()) }
}
