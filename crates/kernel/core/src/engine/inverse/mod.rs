//! The separations that carry a load.

use asperity_quadrature::Moments;

use crate::engine::inverse::force_at::ForceAt;
use crate::engine::inverse::interval::Level;
use crate::error::{positive, require};
use crate::scene::place::{HIGHEST, LOWEST, SeparationInSigma};
use crate::{At, ContactError};

pub(crate) mod above;
pub(crate) mod force_at;
pub(crate) mod interval;
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

pub(crate) fn unresolved(from: f64, to: f64) -> ContactError {
    ContactError::Unresolved { from: from.into(), to: to.into() }
}

/// Newton's steps end after about five; bracketed ones, at the worst, after about sixty.
const MOST: usize = 200;

impl CarriedLoad {
    /// ln of an integral over the load, and its fall with s.
    pub(crate) fn measure(&self, moments: &Moments) -> (f64, f64) {
        let Moments { value, slope, ln_scale, .. } = *moments;
        if value > 0.0 {
            let ln = value.ln() + ln_scale + (self.factor / self.load.abs()).ln();
            (ln, slope / value)
        } else {
            (f64::NEG_INFINITY, 0.0)
        }
    }

    /// The root of a positive integral. In the tail its logarithm is concave, so that Newton's
    /// steps come down from the right; elsewhere brackets guard them.
    pub(crate) fn newton(
        &self,
        curve: &mut impl ForceCurve,
    ) -> Result<SeparationInSigma, ContactError> {
        let guess = self.guess(&curve.at(0.0)?);
        self.steps(curve, guess, (f64::NEG_INFINITY, f64::INFINITY))
    }

    /// The root between two separations, with more than the load at the lower one and less at the
    /// other.
    pub(crate) fn newton_between(
        &self,
        curve: &mut impl ForceCurve,
        (low, high): (f64, f64),
    ) -> Result<SeparationInSigma, ContactError> {
        self.steps(curve, 0.5 * (low + high), (low, high))
    }

    fn steps(
        &self,
        curve: &mut impl ForceCurve,
        mut s: f64,
        ends: (f64, f64),
    ) -> Result<SeparationInSigma, ContactError> {
        let (mut low, mut high) = ends;
        // Far below 0, integrals below this are refused.
        let mut refused = f64::NEG_INFINITY;
        // In a light tail of the heights, integrals above this are refused.
        let mut empty = f64::INFINITY;
        let mut last = f64::INFINITY;
        for _ in 0..MOST {
            let moments = match curve.at(s) {
                Err(ContactError::Integral { .. }) if s < ALL_TOUCH && low < ALL_TOUCH => {
                    refused = s;
                    let answered = high.min(ALL_TOUCH);
                    if answered - refused <= 1e-9 * answered.abs() {
                        // No load is carried where integrals are refused.
                        return Err(self.out_of_reach(&curve.at(answered)?, answered));
                    }
                    s = 0.5 * (refused + answered);
                    continue;
                }
                Err(error @ ContactError::Integral { .. }) if s > 0.0 => {
                    empty = s;
                    let answered = low.max(0.0);
                    if empty - answered <= 1e-9 * empty {
                        return Err(error);
                    }
                    s = 0.5 * (answered + empty);
                    continue;
                }
                other => other?,
            };
            let (above, fall) = self.measure(&moments);
            if above > 0.0 {
                low = s;
            } else {
                high = s;
            }
            if s <= LOWEST && above < 0.0 {
                return Err(self.out_of_reach(&moments, s));
            }
            if s >= HIGHEST && above > 0.0 {
                let smallest = self.load.abs() * above.exp();
                return Err(ContactError::TooLight { load: self.load, smallest, at: s.into() });
            }
            let mut next = s + above / fall;
            let unit = f64::EPSILON * (1.0 + s.abs());
            // An exact root lies on its bracket.
            let (bottom, top) = (low.max(refused), high.min(empty));
            let within = next > bottom && next < top;
            let inside = within || (next - s).abs() <= unit;
            if !(inside || above == 0.0) {
                next = match (bottom.is_finite(), top.is_finite()) {
                    (true, true) => 0.5 * (bottom + top),
                    (false, _) => top - 2.0 * (1.0 + top.abs()),
                    (true, false) => bottom + 2.0 * (1.0 + bottom.abs()),
                };
            }
            next = next.clamp(LOWEST, HIGHEST);
            let step = (next - s).abs();
            // Newton's steps shrink as their squares: this one may be the last above rounding.
            let remains = match inside && last.is_finite() {
                true => step * (step / last) * (step / last),
                false => step,
            };
            s = next;
            if step <= 4.0 * unit || remains <= 0.25 * unit || high - low <= 4.0 * unit {
                if curve.settle(s)? {
                    ((low, high), last) = (ends, f64::INFINITY);
                    continue;
                }
                if refused.is_finite() && low < refused {
                    return Err(self.out_of_reach(&moments, s));
                }
                return Ok(place(s, &moments));
            }
            last = if inside { step } else { f64::INFINITY };
        }
        Err(unresolved(low.max(LOWEST), high.min(HIGHEST)))
    }

    /// From the value and the slope at 0: exp(-a s - s²/2) above, a power of the overlap below.
    fn guess(&self, at_zero: &Moments) -> f64 {
        let (above, fall) = self.measure(at_zero);
        if !(above.is_finite() && fall > 0.0) {
            return -1.0;
        }
        if above > 0.0 {
            return 2.0 * above / (fall + (fall * fall + 2.0 * above).sqrt());
        }
        const POWER: f64 = 1.3;
        (-(POWER / fall) * (-above / POWER).exp_m1()).max(LOWEST)
    }

    pub(crate) fn out_of_reach(&self, moments: &Moments, s: f64) -> ContactError {
        let largest = moments.value * moments.ln_scale.exp() * self.factor;
        ContactError::OutOfReach { load: self.load, largest, at: At::sigmas(s) }
    }
}
