//! The nearest pressures that lie between 0 and the hardness and carry the load.

use crate::parallel::{reduce, sum, update};

/// More halvings than a double has digits, with room for steps of thousands of hardnesses.
const MOST_PASSES: usize = 200;
/// Relative error of the load that is rounding.
const ROUNDING: f64 = 1e-14;
/// Relative error of the load that a step may leave as it is.
const BALANCE: f64 = 1e-12;

/// A step from pressures `from` along `-direction`, cut at 0 and `cap`, with one shift for all
/// pixels that move so that the sum of the pressures is `load`: the Euclidean projection of the
/// step. Pixels whose direction is exactly 0 stay.
pub(crate) struct Projection {
    length: f64,
    shift: f64,
    cap: f64,
    /// Whether a pixel was cut off; if none was, the shift is 0 and the step is linear.
    pub(crate) cut: bool,
}

/// Where the pixels would end without bounds.
struct Ends {
    lowest: f64,
    highest: f64,
    /// Number of the pixels that move.
    moving: f64,
    /// Sum of the pressures of those that do not.
    stay: f64,
    /// Sum over those that do.
    sum: f64,
}

impl Default for Ends {
    fn default() -> Self {
        let [lowest, highest] = [f64::INFINITY, f64::NEG_INFINITY];
        Self { lowest, highest, moving: 0.0, stay: 0.0, sum: 0.0 }
    }
}

impl Ends {
    fn add(&mut self, from: f64, direction: f64, length: f64) {
        if direction == 0.0 {
            self.stay += from;
        } else {
            let end = from - length * direction;
            self.lowest = self.lowest.min(end);
            self.highest = self.highest.max(end);
            self.moving += 1.0;
            self.sum += end;
        }
    }

    fn join(self, other: Self) -> Self {
        Self {
            lowest: self.lowest.min(other.lowest),
            highest: self.highest.max(other.highest),
            moving: self.moving + other.moving,
            stay: self.stay + other.stay,
            sum: self.sum + other.sum,
        }
    }
}

impl Projection {
    pub(crate) fn new(from: &[f64], direction: &[f64], length: f64, cap: f64, load: f64) -> Self {
        let mut this = Self { length, shift: 0.0, cap, cut: true };
        let ends = reduce(
            from.len(),
            |range| {
                let mut ends = Ends::default();
                for (&from, &direction) in from[range.clone()].iter().zip(&direction[range]) {
                    ends.add(from, direction, length);
                }
                ends
            },
            Ends::join,
        );
        let Ends { lowest, highest, moving, stay, sum: all } = ends.unwrap_or_default();
        let need = load - stay;
        if lowest >= 0.0 && highest <= cap && (all - need).abs() <= BALANCE * load {
            this.cut = false;
            return this;
        }
        // Above `high` nothing is pressed, below `low` everything is pressed enough.
        let mut low = lowest - if cap.is_finite() { cap } else { need / moving };
        let mut high = highest;
        for _ in 0..MOST_PASSES {
            let [carried, free] = sum(from.len(), |i| {
                if direction[i] == 0.0 {
                    return [0.0, 0.0];
                }
                let end = this.end(from[i], direction[i]);
                let pressure = end.clamp(0.0, cap);
                [pressure, f64::from(u8::from(end > 0.0 && end < cap))]
            });
            let excess = carried - need;
            if excess > 0.0 {
                low = this.shift;
            } else {
                high = this.shift;
            }
            if excess.abs() <= ROUNDING * load {
                break;
            }
            let newton = this.shift + excess / free;
            this.shift = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if this.shift <= low || this.shift >= high {
                break;
            }
        }
        this
    }

    fn end(&self, from: f64, direction: f64) -> f64 {
        from - self.length * direction - self.shift
    }

    /// Pressure after the step.
    pub(crate) fn of(&self, from: f64, direction: f64) -> f64 {
        if direction == 0.0 { from } else { self.end(from, direction).clamp(0.0, self.cap) }
    }

    /// Makes the step.
    pub(crate) fn step(&self, pressures: &mut [f64], direction: &[f64]) {
        update(pressures, |i, pressure| {
            *pressure = self.of(*pressure, direction[i]);
            []
        });
    }
}
