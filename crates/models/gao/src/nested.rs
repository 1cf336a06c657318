//! The integral of an angle average times a weight of x, for laws that are integrated once: over y
//! outside and over x inside, because the corners of slip are known for each y.

use std::sync::LazyLock;

use asperity_quadrature::{PointMasses, WeightFunction};

use crate::gauss::{Gauss, Sum, bisect, whole_powers};
use crate::oblique::AngleAverage;

/// Nodes on a panel of x or of y.
const NODES: usize = 16;
/// y minus the start of its panel is this power of the outer variable: fractional powers at the
/// start become high powers.
const POWER: i32 = 4;
/// Largest ratio of the ends of a panel of √(x - y), a variable that is smooth next to y and far
/// from it.
const RATIO: f64 = 3.5;

static RULE: LazyLock<Gauss<NODES>> = LazyLock::new(Gauss::new);

/// The masses of q(x) = (1/x) ∫ (c₀ + c₂ y²/x²) m(y, x) dy times a weight.
pub(crate) fn masses(average: &AngleAverage, against: &WeightFunction<'_>) -> PointMasses {
    let (from, to) = (average.range.start, average.range.end.min(against.range.1));
    let unit = 1.0 / against.likely();
    let found = PointMasses::default();
    let azimuths = average.azimuth_tolerance();
    let mut nest = Nest { average, against, azimuths, found, unit, size: 0.0 };
    let mut ends: Vec<f64> = average.singular.iter().copied().filter(|y| *y < to).collect();
    ends.extend([from, to]);
    ends.sort_by(f64::total_cmp);
    let mut panels: Vec<Panel> = vec![];
    for pair in ends.windows(2).filter(|pair| pair[1] > pair[0]) {
        let (start, mut end) = (pair[0], pair[1]);
        if end < to {
            let middle = 0.5 * (start + end);
            panels.extend(Panel::of(end, middle - end, against.edges));
            end = middle;
        }
        panels.extend(Panel::of(start, end - start, against.edges));
    }
    // The largest first: smaller panels are accurate relative to it.
    let likely = against.likely().clamp(from, to.max(from));
    let off = |panel: &Panel| (panel.y(0.5).0 - likely).abs();
    panels.sort_by(|a, b| off(a).total_cmp(&off(b)));
    panels.iter().for_each(|panel| nest.panel(panel));
    nest.found
}

/// y = `from` + `width` w^POWER for w between `low` and `high`, both in 0..1; the width can be
/// negative.
struct Panel {
    from: f64,
    width: f64,
    low: f64,
    high: f64,
}

impl Panel {
    /// Panels that end at edges, starting where the integrand has a singularity.
    fn of(from: f64, width: f64, edges: &[f64]) -> Vec<Self> {
        let w = |y: &f64| ((y - from) / width).powf(1.0 / f64::from(POWER));
        let mut inside: Vec<f64> = edges.iter().map(w).filter(|w| *w < 0.8).collect();
        inside.sort_by(f64::total_cmp);
        // One panel seldom resolves both the singularity and the rest.
        let first = inside.first().copied().unwrap_or(1.0) / 3.0;
        let mut panels = vec![Self { from, width, low: 0.0, high: first }];
        let mut low = first;
        for high in inside.into_iter().chain([1.0]) {
            if high > 1.2 * low {
                panels.push(Self { from, width, low, high });
                low = high;
            }
        }
        panels
    }

    /// y and |dy/dw| at a fraction of the panel.
    fn y(&self, share: f64) -> (f64, f64) {
        let w = self.low + (self.high - self.low) * share;
        let slope = self.width * w.powi(POWER - 1);
        let stretch = f64::from(POWER) * (self.high - self.low);
        (self.from + slope * w, stretch * slope.abs())
    }
}

struct Nest<'a> {
    average: &'a AngleAverage,
    against: &'a WeightFunction<'a>,
    azimuths: f64,
    found: PointMasses,
    /// Factor of x. Slopes of integrals use the same masses times x and must be as accurate; next
    /// to the maximum of the weight, differences of x matter.
    unit: f64,
    /// The integral so far.
    size: f64,
}

impl Nest<'_> {
    /// Adds the integral over y in a panel.
    fn panel(&mut self, panel: &Panel) {
        let rule = &*RULE;
        let mut whole = 0.0f64;
        bisect(|left, span, last| {
            let before = (self.found.points.len(), self.found.error);
            let mut at = |node: f64, weight: f64| {
                let (y, slope) = panel.y(left + span * node);
                self.over_x(y, span * slope * weight).map(|sum| span * slope * sum)
            };
            let sums: [_; NODES] = std::array::from_fn(|k| at(rule.nodes[k], rule.weights[k]));
            let at_start = panel.low <= 0.0 && left <= 0.0;
            let [found, moment] = [0, 1].map(|k| {
                let sums = sums.map(|sum| sum[k]);
                if at_start { rule.sum_from_power(&sums) } else { rule.sum(&sums) }
            });
            let found = Sum { error: found.error.max(moment.error), ..found };
            whole = whole.max(found.likely());
            let aim = self.against.aim * (self.size + whole + self.against.beside);
            let resolved = last || found.error <= aim || found.error.is_nan();
            if resolved {
                self.size += found.value.abs();
                self.found.error += found.error;
            } else {
                self.found.points.truncate(before.0);
                self.found.masses.truncate(before.0);
                self.found.error = before.1;
            }
            resolved
        });
    }

    /// The integral over x at one y, and the same times x `unit`. Its masses times `share`, the
    /// weight of this y, are stored.
    fn over_x(&mut self, y: f64, share: f64) -> [f64; 2] {
        let rule = &*RULE;
        let WeightFunction { range: (start, end), weight, aim, beside, .. } = *self.against;
        let (c0, c2) = self.average.density;
        // Contributions below this size need no further refinement.
        let beside = 0.01 * (self.size + beside) / share;
        let ([mut total, mut moment], mut whole) = ([0.0; 2], 0.0f64);
        for (from, to, half) in self.panels(y, (start - y).max(0.0), end - y) {
            let [r1, r2, r3] = whole_powers(half);
            bisect(|left, span, last| {
                let (mut gaps, mut slopes) = ([0.0; NODES], [0.0; NODES]);
                for k in 0..NODES {
                    let v = left + span * rule.nodes[k];
                    let root = from + (to - from) * (v * (r1 + v * (r2 + v * r3)));
                    let slope = r1 + v * (2.0 * r2 + v * 3.0 * r3);
                    gaps[k] = root * root;
                    slopes[k] = span * (to - from) * slope * 2.0 * root;
                }
                let mut values = [0.0; NODES];
                let worst = self.average.contact.means(y, &gaps, self.azimuths, &mut values);
                for k in 0..NODES {
                    let x = y + gaps[k];
                    let u = y / x;
                    values[k] *= slopes[k] * (c0 + c2 * u * u) / x * weight(x);
                }
                self.found.evaluations += NODES;
                let found = rule.sum(&values);
                let of_x: [f64; NODES] =
                    std::array::from_fn(|k| self.unit * (y + gaps[k]) * values[k]);
                let of_x = rule.sum(&of_x);
                let (value, error) = (found.value, found.error.max(of_x.error));
                whole = whole.max(f64::abs(total) + found.likely());
                let resolved = last || error <= 0.3 * aim * (whole + beside) || error.is_nan();
                if resolved {
                    total += value;
                    moment += of_x.value;
                    self.found.error += share * (error + worst * value.abs());
                    for k in 0..NODES {
                        self.found.points.push(y + gaps[k]);
                        self.found.masses.push(share * rule.weights[k] * values[k]);
                    }
                }
                resolved
            });
        }
        [total, moment]
    }

    /// Panels of √(x - y) for gaps x - y from `near` to `far`. They end at the corners of slip,
    /// which are half powers, and at every second edge of the weight. The flags mark corners at the
    /// ends.
    fn panels(&self, y: f64, near: f64, far: f64) -> Vec<(f64, f64, [bool; 2])> {
        let corners = self.average.contact.corners(y);
        let mut ends: Vec<f64> =
            corners.into_iter().filter(|gap| *gap > near && *gap < far).collect();
        ends.sort_by(f64::total_cmp);
        let edges = self.against.edges.iter().map(|x| x - y);
        let edges: Vec<f64> = edges.filter(|gap| *gap > near).map(f64::sqrt).collect();
        let layer = self.average.contact.layer(y).max(f64::MIN_POSITIVE);
        let nearest = (4.0 * y).min(RATIO * RATIO * layer).sqrt();
        let (mut panels, mut from, mut at_corner) = (vec![], near.sqrt(), false);
        let count = ends.len();
        for (k, to) in ends.into_iter().chain([far]).map(f64::sqrt).enumerate() {
            while from < to {
                let farthest = if from > 0.0 { RATIO * from } else { nearest };
                let suits = edges.iter().copied().filter(|e| *e > 1.05 * from).nth(1);
                let next = suits.unwrap_or(to).min(farthest);
                let next = if next > 0.8 * to { to } else { next };
                panels.push((from, next, [at_corner, next >= to && k < count]));
                (from, at_corner) = (next, false);
            }
            at_corner = true;
        }
        panels
    }
}
