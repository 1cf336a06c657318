//! Every separation that carries a load, where the force need not fall all the way.

use asperity_quadrature::{bracketed_root, fallible};

use crate::ContactError;
use crate::engine::inverse::{DEEP, ForceCurve, Of, Target};
use crate::request::separation::LOWEST;

/// Down to [`DEEP`], crossings are looked for in these steps; deeper down, where all asperities are
/// in contact, none is known to turn around. The force is the law folded with heights of standard
/// deviation 1: nothing of it is narrower, and slopes tell what lies between.
const STEP: f64 = 0.25;

/// Force over load, less 1, at s.
#[derive(Debug, Clone, Copy)]
struct Sample {
    s: f64,
    value: f64,
    slope: f64,
}

impl Target {
    /// Force over load, less 1, and its derivative.
    fn excess(&self, curve: &mut impl ForceCurve, s: f64) -> Result<Sample, ContactError> {
        let moments = curve.at(s)?;
        let ratio = (moments.ln_scale + (self.factor / self.load.abs()).ln()).exp();
        let unit = ratio.copysign(self.load);
        Ok(Sample { s, value: moments.value * unit - 1.0, slope: -moments.slope * unit })
    }

    /// Newton's step from s to where the force is the load.
    pub(crate) fn step(&self, curve: &mut impl ForceCurve, s: f64) -> Result<f64, ContactError> {
        let Sample { value, slope, .. } = self.excess(curve, s)?;
        Ok((-value / slope).clamp(-STEP, STEP))
    }

    /// Crossings from the largest on, or the largest alone.
    pub(crate) fn crossings(
        &self,
        curve: &mut impl ForceCurve,
        first_only: bool,
    ) -> Result<Vec<f64>, ContactError> {
        // What is never negative is its own size, and its slope is known where that of the size is a
        // bound.
        let of = if self.signed { Of::Size } else { Of::Value };
        let top = self.newton(curve, of)?.s;
        let mut found = vec![];
        if !self.signed {
            found.push(top);
        }
        // No crossing lies above: a hair off, so that rounding does not show this one twice.
        let hair = 1e-9 * (1.0 + top.abs());
        let mut right = self.excess(curve, if self.signed { top + hair } else { top - hair })?;
        let (mut largest, mut wide) = (right, STEP);
        while right.s > LOWEST && (found.is_empty() || !first_only) {
            let seen = self.begins.seen(right.s);
            let (deep, step) = (seen <= DEEP, if seen > DEEP { STEP } else { seen.abs() });
            // Pressed together the force is above any tension.
            let pending = self.load < 0.0 && right.value > 0.0;
            if deep && !found.is_empty() && !pending {
                break;
            }
            let left = match self.excess(curve, (right.s - step).max(LOWEST)) {
                // The force has fallen from its top, and a load above that is out of reach.
                Err(ContactError::Integral { .. }) if deep && !pending && largest.s > right.s => {
                    break;
                }
                other => other?,
            };
            self.between(curve, left, right, &mut found)?;
            if left.value > largest.value {
                (largest, wide) = (left, step);
            }
            right = left;
        }
        if found.is_empty() {
            let top = self.top(curve, largest, wide);
            return Err(self.out_of_reach(curve, top));
        }
        Ok(found)
    }

    /// Where the force is largest next to the largest sample, which has another a step beside it; the
    /// sample's own place where nothing turns there, or it cannot be told.
    fn top(&self, curve: &mut impl ForceCurve, near: Sample, step: f64) -> f64 {
        let beside = near.s + step.copysign(near.slope);
        let slope = |s| Ok::<_, ContactError>(self.excess(curve, s)?.slope);
        let found = fallible(slope, |slope| bracketed_root(slope, near.s, beside));
        found.ok().flatten().unwrap_or(near.s)
    }

    /// Crossings between two samples, the larger first.
    fn between(
        &self,
        curve: &mut impl ForceCurve,
        left: Sample,
        right: Sample,
        found: &mut Vec<f64>,
    ) -> Result<(), ContactError> {
        if left.value * right.value <= 0.0 {
            let excess = |s| Ok::<_, ContactError>(self.excess(curve, s)?.value);
            found.extend(fallible(excess, |excess| bracketed_root(excess, left.s, right.s))?);
            return Ok(());
        }
        // Two crossings hide where the force turns towards the load between the samples.
        let towards = -left.value.signum();
        let turns = left.slope * towards > 0.0 && right.slope * towards < 0.0;
        let reach = 0.5 * (right.s - left.s) * left.slope.abs().max(right.slope.abs());
        let near = left.value.abs().min(right.value.abs()) <= reach;
        if turns && near && right.s - left.s > 1e-9 * (1.0 + left.s.abs()) {
            let middle = self.excess(curve, 0.5 * (left.s + right.s))?;
            self.between(curve, middle, right, found)?;
            self.between(curve, left, middle, found)?;
        }
        Ok(())
    }
}
