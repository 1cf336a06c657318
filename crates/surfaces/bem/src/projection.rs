//! The nearest pressures that lie between 0 and the hardness and carry the load.

use crate::parallel::{number, reduce, sum, update};

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
    /// The highest end, and the pressure there after the step: ends may be so long that their
    /// differences alone have digits at the size of the pressures.
    highest: f64,
    level: f64,
    cap: f64,
    /// Whether a pixel was cut off; if none was, the step is linear.
    pub(crate) cut: bool,
}

impl Projection {
    pub(crate) fn new(from: &[f64], direction: &[f64], length: f64, cap: f64, load: f64) -> Self {
        let mut this = Self { length, highest: 0.0, level: 0.0, cap, cut: true };
        let maps = [from, direction];
        // Where the pixels would end without bounds: the lowest and the highest end, the number of
        // pixels that move, the sum of the pressures of those that do not, and that of the ends.
        let fold = |[lowest, highest, moving, stay, all]: [f64; 5], [from, direction]: [f64; 2]| {
            if direction == 0.0 {
                return [lowest, highest, moving, stay + from, all];
            }
            let end = from - length * direction;
            [f64::min(lowest, end), f64::max(highest, end), moving + 1.0, stay, all + end]
        };
        let join = |a: [f64; 5], b: [f64; 5]| {
            [a[0].min(b[0]), a[1].max(b[1]), a[2] + b[2], a[3] + b[3], a[4] + b[4]]
        };
        let zero = [f64::INFINITY, f64::NEG_INFINITY, 0.0, 0.0, 0.0];
        let [lowest, highest, moving, stay, all] = reduce(maps, zero, fold, join);
        let need = load - stay;
        if lowest >= 0.0 && highest <= cap && (all - need).abs() <= BALANCE * load {
            this.cut = false;
            return this;
        }
        // At the level 0 nothing is pressed, at `high` everything is pressed enough.
        let (mut low, mut high) = (0.0, highest - lowest + (need / moving).min(cap));
        (this.highest, this.level) = (highest, highest.clamp(low, high));
        for _ in 0..MOST_PASSES {
            let [carried, free] = sum(maps, |[from, direction]| {
                let moves = number(direction != 0.0);
                let end = this.end(from, direction);
                [moves * end.clamp(0.0, cap), moves * number((end > 0.0) & (end < cap))]
            });
            let excess = carried - need;
            if excess > 0.0 {
                high = this.level;
            } else {
                low = this.level;
            }
            if excess.abs() <= ROUNDING * load {
                break;
            }
            let newton = this.level - excess / free;
            this.level = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if this.level <= low || this.level >= high {
                break;
            }
        }
        this
    }

    fn end(&self, from: f64, direction: f64) -> f64 {
        (from - self.length * direction - self.highest) + self.level
    }

    /// Makes the step.
    pub(crate) fn step(&self, pressures: &mut [f64], direction: &[f64]) {
        update(pressures, [direction], |pressure, [direction]| {
            if direction != 0.0 {
                *pressure = self.end(*pressure, direction).clamp(0.0, self.cap);
            }
            []
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lengths of the steps from none to many hardnesses, with and without a hardness.
    #[test]
    fn the_nearest_pressures_carry_the_load() {
        let from: Vec<f64> = (0..999).map(|i| f64::from(i % 7) / 7.0).collect();
        let load: f64 = from.iter().sum();
        // A third stays.
        let direction: Vec<f64> =
            (0..999).map(|i| if i % 3 == 0 { 0.0 } else { f64::from(i).sin() }).collect();
        for cap in [1.0, f64::INFINITY] {
            for length in [0.0, 1e-3, 0.3, 10.0, 1e6] {
                let step = Projection::new(&from, &direction, length, cap, load);
                let mut to = from.clone();
                step.step(&mut to, &direction);
                assert!((to.iter().sum::<f64>() / load - 1.0).abs() < 1e-9, "{cap} {length}");
                assert!(to.iter().all(|pressure| (0.0..=cap).contains(pressure)));
                assert!((0..999).step_by(3).all(|i| (to[i] - from[i]).abs() <= 0.0));
                // Nearest: between the bounds all are off their ends by the same shift, at the
                // bounds by more in the direction of the bound.
                let shift = step.highest - step.level;
                for i in (0..999).filter(|i| i % 3 != 0) {
                    let off = from[i] - length * direction[i] - to[i];
                    let little = 1e-9 * (1.0 + length);
                    let [open, full] = [to[i] <= 0.0, to[i] >= cap];
                    assert!(open || off >= shift - little, "{cap} {length} {off}");
                    assert!(full || off <= shift + little, "{cap} {length} {off}");
                }
            }
        }
    }

    #[test]
    fn a_step_that_reaches_no_bound_is_not_cut() {
        let direction = [0.25, -0.25, 0.0, 0.0];
        let cut = |length: f64| Projection::new(&[0.5; 4], &direction, length, 1.0, 2.0).cut;
        assert!(!cut(0.0) && !cut(2.0));
        assert!(cut(2.1));
        // Nor is one that carries another load left alone.
        assert!(Projection::new(&[0.5; 4], &direction, 1.0, 1.0, 2.1).cut);
    }
}
