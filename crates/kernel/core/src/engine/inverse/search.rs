//! Where a force that need not fall all the way carries a load, and where it is largest.

use asperity_quadrature::{bracketed_root, fallible};

use crate::ContactError;
use crate::engine::inverse::force_at::{ForceAt, Landmark};
use crate::engine::inverse::interval::{Course, Interval, Level, Sample};
use crate::engine::inverse::{ALL_TOUCH, unresolved};
use crate::scene::place::{HIGHEST, LOWEST};

/// Separations at which a search gives up.
const MOST: usize = 4000;
/// A force is larger than another by more than this share, the square of what rounding moves the
/// place of a maximum by.
const LARGER: f64 = 1e-14;
/// Two crossings nearer than this, relative to 1 + |s|, where the force touches the load, are one.
const TOUCH: f64 = 1e-9;

impl ForceAt<'_> {
    /// Separations that carry a level up to `top`, from the largest on, or the largest alone.
    pub(crate) fn crossings(
        &self,
        level: Level,
        top: f64,
        first_only: bool,
    ) -> Result<Vec<f64>, ContactError> {
        let mut found = vec![];
        let mut enough = |interval, landmark: &Landmark| {
            self.within(interval, level, first_only, &mut found)?;
            Ok(first_only && !found.is_empty() || landmark.stays_above(level))
        };
        self.walk(self.highest(top)?, &mut enough)?;
        found.dedup_by(|a, b| (*a - *b).abs() <= TOUCH * (1.0 + a.abs()));
        Ok(found)
    }

    /// Shows the intervals between landmarks from `high` on down, until `enough` or to the last.
    fn walk(
        &self,
        mut high: Sample,
        enough: &mut dyn FnMut(Interval, &Landmark) -> Result<bool, ContactError>,
    ) -> Result<(), ContactError> {
        for landmark in self.landmarks(high.s) {
            let (low, last) = match landmark.sample(self) {
                // Hardly any height is left here, below a place where none is.
                Err(ContactError::Integral { .. }) if landmark.s > 0.0 && high.is_nothing() => {
                    continue;
                }
                // Integrals end on the way down.
                Err(ContactError::Integral { .. }) if landmark.s < ALL_TOUCH => {
                    (self.last(landmark.s, high)?, true)
                }
                // The variation of a law that turns all the time cannot be integrated.
                Err(ContactError::Integral { .. }) => return Err(unresolved(LOWEST, high.s)),
                // Landmarks next to the lowest separation stand for it.
                other => (other?, landmark.s <= LOWEST * (1.0 - 1e-8)),
            };
            if enough(Interval { low, high }, landmark)? || last {
                return Ok(());
            }
            high = low;
        }
        match high.s <= LOWEST {
            true => Ok(()),
            false => Err(unresolved(LOWEST, high.s)),
        }
    }

    /// The sample at `top`, or at the highest separation below it that has one: heights with a
    /// light tail cannot be integrated so far out, where nothing touches.
    fn highest(&self, top: f64) -> Result<Sample, ContactError> {
        let error = match self.sample(top) {
            Err(error @ ContactError::Integral { .. }) if top > 0.0 => error,
            other => return other,
        };
        let mut below = self.landmarks(top).take_while(|landmark| landmark.s >= 0.0);
        let answered = below.find_map(|landmark| landmark.sample(self).ok()).ok_or(error)?;
        self.last(top, answered)
    }

    /// The last separation on the way from one that is answered to one that is refused.
    fn last(&self, mut refused: f64, mut answered: Sample) -> Result<Sample, ContactError> {
        while (answered.s - refused).abs() > 1e-9 * refused.abs() {
            let middle = 0.5 * (refused + answered.s);
            match self.sample(middle) {
                Ok(sample) => answered = sample,
                Err(ContactError::Integral { .. }) => refused = middle,
                Err(other) => return Err(other),
            }
        }
        Ok(answered)
    }

    /// Those in one interval, the larger first.
    fn within(
        &self,
        whole: Interval,
        level: Level,
        first_only: bool,
        found: &mut Vec<f64>,
    ) -> Result<(), ContactError> {
        let mut open = vec![whole];
        for _ in 0..MOST {
            let Some(interval) = open.pop() else { return Ok(()) };
            let [least, most] = interval.bounds(level);
            if least > 0.0 || most < 0.0 {
                continue;
            }
            if interval.is_narrow() {
                let met = interval.crosses(level) || interval.touches(level);
                found.extend(met.then_some(interval.high.s));
            } else {
                let Some(middle) = self.middle(interval, &mut open)? else { continue };
                match interval.course(&middle, level) {
                    Course::Apart => {}
                    Course::Monotone => found.extend(self.root(interval, level)?),
                    Course::OneTurn => {
                        for part in interval.parts(self.turn(interval)?).into_iter().rev() {
                            found.extend(self.root(part, level)?);
                        }
                    }
                    Course::Unknown if interval.keeps(-level.sign, &middle) => {}
                    Course::Unknown => open.extend(interval.parts(middle)),
                }
            }
            if first_only && !found.is_empty() {
                return Ok(());
            }
        }
        Err(unresolved(whole.low.s, whole.high.s))
    }

    /// The sample in the middle of an interval; or, where hardly any height is left there and none
    /// at its upper end, nothing, and the interval up to the last sample that there is stays open.
    fn middle(
        &self,
        Interval { low, high }: Interval,
        open: &mut Vec<Interval>,
    ) -> Result<Option<Sample>, ContactError> {
        let middle = 0.5 * (low.s + high.s);
        match self.sample(middle) {
            Err(ContactError::Integral { .. }) if high.is_nothing() && !low.is_nothing() => {
                open.push(Interval { low, high: self.last(middle, low)? });
                Ok(None)
            }
            found => found.map(Some),
        }
    }

    /// Where the force is the level, between signs that differ.
    fn root(&self, interval: Interval, level: Level) -> Result<Option<f64>, ContactError> {
        if !interval.crosses(level) {
            return Ok(None);
        }
        let at = interval.level(level);
        let excess = |s| Ok(interval.scaled(&self.force(s)?)[0] - at);
        let (low, high) = (interval.low.s, interval.high.s);
        let root = fallible(excess, |excess| bracketed_root(excess, low, high))?;
        // Next to an end, rounding decides which side of it the root is on.
        let [at_low, at_high] = interval.ends(level).map(f64::abs);
        Ok(root.or(Some(if at_low < at_high { low } else { high })))
    }

    /// Where the force turns in an interval; one of its ends if it does not.
    fn turn(&self, interval: Interval) -> Result<Sample, ContactError> {
        if interval.turns() {
            let slope = |s| Ok(interval.scaled(&self.force(s)?)[1]);
            let (low, high) = (interval.low.s, interval.high.s);
            if let Some(s) = fallible(slope, |slope| bracketed_root(slope, low, high))? {
                return self.sample(s);
            }
        }
        Ok(interval.high)
    }

    /// Where the force times `sign` is largest, of forces above the level `ln_least`; otherwise one
    /// of the landmarks.
    pub(crate) fn largest(&self, sign: f64, ln_least: f64) -> Result<Sample, ContactError> {
        let least = Level { sign, ln: ln_least };
        let to_exceed = |best: &Sample| match best.level() {
            level if level.sign * sign > 0.0 && level.ln > ln_least => {
                Level { ln: level.ln + LARGER, ..level }
            }
            _ => least,
        };
        let high = self.highest(HIGHEST)?;
        let (mut best, mut open) = (high, vec![]);
        self.walk(high, &mut |interval, landmark| {
            best = larger(best, interval.low, sign);
            open.push(interval);
            Ok(sign < 0.0 && landmark.stays_above(least))
        })?;
        for _ in 0..MOST {
            let Some(interval) = open.pop() else { return Ok(best) };
            let level = to_exceed(&best);
            let [least, most] = interval.bounds(level);
            let unlike = if sign > 0.0 { most <= 0.0 } else { least >= 0.0 };
            if unlike || interval.is_narrow() {
                continue;
            }
            // The upper end may be the last sample that there is, not seen before.
            best = larger(best, interval.high, sign);
            let Some(middle) = self.middle(interval, &mut open)? else { continue };
            best = larger(best, middle, sign);
            match interval.course(&middle, level) {
                Course::Apart | Course::Monotone => {}
                Course::OneTurn => best = larger(best, self.turn(interval)?, sign),
                Course::Unknown if interval.keeps(-sign, &middle) => {}
                Course::Unknown => open.extend(interval.parts(middle)),
            }
        }
        Err(unresolved(LOWEST, HIGHEST))
    }
}

/// The one whose force times `sign` is larger.
fn larger(a: Sample, b: Sample, sign: f64) -> Sample {
    let ln_scale = a.level().ln.max(b.level().ln);
    let [x, y] = [a, b].map(|sample| sign * sample.level().over(ln_scale));
    if y > x { b } else { a }
}
