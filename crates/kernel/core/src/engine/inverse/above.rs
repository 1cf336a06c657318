//! The largest separation that carries a load, from one that does, without the variation of the
//! law: for Gaussian heights, and laws whose added parts and subtracted parts are positive.
//!
//! With φ(s + w) = φ(w) exp(-s w) exp(-s²/2), the integral of a positive part is
//! ```text
//! F(s) = exp(-s²/2) ∫ q(w) φ(w) exp(-s w) dw
//! ```
//! where the second factor, a Laplace transform, falls and has a convex logarithm: (ln F)'' ≥ -1.
//! Chords of ln F + s²/2 bound F from above, and tangents from below.

use crate::engine::inverse::{CarriedLoad, ForceCurve};
use crate::scene::place::SeparationInSigma;

/// Tolerance of the integrals between which bounds are drawn.
pub(crate) const ROUGH: f64 = 1e-3;
/// Below this, bounds reach too far to be of use.
const DEEPEST: f64 = -8.0;
/// Separations to look at before it is left to the variation.
const MOST: usize = 24;
/// The first distance between two of them \[σ_z\], and the least.
const STEP: f64 = 1.0;
const LEAST: f64 = 1.0 / 32.0;
/// Pieces of an interval, each with bounds of its own.
const PIECES: u32 = 32;

/// ln of an integral over the load, and the bound of its error; its derivative, with its own.
#[derive(Debug, Clone, Copy)]
struct Half {
    ln: f64,
    off: f64,
    rise: f64,
    rise_off: f64,
}

/// Both halves at s.
#[derive(Debug, Clone, Copy)]
struct Node {
    s: f64,
    added: Half,
    subtracted: Half,
}

impl CarriedLoad {
    /// The largest separation that carries the load, a positive one, given one that does; `None`
    /// if the bounds do not show which it is.
    pub(crate) fn largest_from(
        &self,
        force: &mut impl ForceCurve,
        mut found: SeparationInSigma,
    ) -> Option<SeparationInSigma> {
        let mut left = MOST;
        while found.s >= DEEPEST {
            let mut low = self.node(force, found.s)?;
            // Those to look at, the nearest last; and the last one with more than the load.
            let (mut ahead, mut above, mut step) = (vec![], None, STEP);
            loop {
                if low.stays_below() {
                    return Some(found);
                }
                left = usize::checked_sub(left, 1)?;
                let high = ahead.pop().map_or_else(|| self.node(force, low.s + step), Some)?;
                if high.exceeds() {
                    (low, above) = (high, Some(high.s));
                } else if let Some(from) = above.filter(|_| high.is_less()) {
                    found = self.newton_between(force, (from, high.s)).ok()?;
                    break;
                } else if above.is_none() && is_below(&low, &high) {
                    (low, step) = (high, 2.0 * (high.s - low.s));
                } else if high.s - low.s > 2.0 * LEAST {
                    let middle = self.node(force, 0.5 * (low.s + high.s))?;
                    ahead.extend([high, middle]);
                } else {
                    return None;
                }
            }
        }
        None
    }

    fn node(&self, force: &mut impl ForceCurve, s: f64) -> Option<Node> {
        let halves = force.halves(s).ok()??;
        let [added, subtracted] = halves.map(|m| {
            let (above, fall) = self.measure(&m);
            let [off, rise_off] = m.sizes.map(|size| m.error * size);
            let share = if m.value > 0.0 { m.value.recip() } else { 0.0 };
            let (off, rise_off) = (off * share, (rise_off + off * fall.abs()) * share);
            // ln(1 + off) and -ln(1 - off).
            Half { ln: above, off: 2.0 * off, rise: -fall, rise_off: 2.0 * rise_off }
        });
        (added.off.max(subtracted.off) < 0.1).then_some(Node { s, added, subtracted })
    }
}

impl Node {
    /// Whether the force exceeds the load here.
    fn exceeds(&self) -> bool {
        self.added.least().exp() - self.subtracted.most().exp() > 1.0
    }

    /// Whether it is less than the load here.
    fn is_less(&self) -> bool {
        self.added.most().exp() - self.subtracted.least().exp() < 1.0
    }

    /// Whether what is added alone is less than the load from here on: exp(s²/2) F falls.
    fn stays_below(&self) -> bool {
        self.added.most() + 0.5 * self.s.min(0.0).powi(2) < 0.0
    }
}

impl Half {
    fn least(&self) -> f64 {
        self.ln - self.off
    }

    fn most(&self) -> f64 {
        self.ln + self.off
    }
}

/// The bounds of one half between two nodes `h` apart, at distances t from the lower one.
struct Bounds<'a> {
    low: &'a Half,
    high: &'a Half,
    h: f64,
}

impl Bounds<'_> {
    /// The largest ln between two places, by the chord: a concave parabola.
    fn most(&self, from: f64, to: f64) -> f64 {
        let [a, b] = [self.low.most(), self.high.most()];
        if a.max(b) == f64::NEG_INFINITY {
            return a;
        }
        let vertex = 0.5 * self.h + (b - a) / self.h;
        let t = vertex.max(from).min(to);
        a + (b - a) * (t / self.h) + 0.5 * t * (self.h - t)
    }

    /// The smallest ln between two places, by the better tangent.
    fn least(&self, from: f64, to: f64) -> f64 {
        let tangent = |half: &Half, t: f64| {
            half.least() + half.rise * t - half.rise_off * t.abs() - 0.5 * t * t
        };
        let at = |half, shift: f64| tangent(half, from - shift).min(tangent(half, to - shift));
        at(self.low, 0.0).max(at(self.high, self.h))
    }

    /// The largest and the smallest derivative of ln between two places.
    fn rises(&self, from: f64, to: f64) -> [f64; 2] {
        let [low, high] = [self.low, self.high];
        [high.rise + high.rise_off + self.h - from, low.rise - low.rise_off - to]
    }
}

/// Whether the force is at most the load between two nodes, if it is at the lower: piece by piece
/// it falls, or stays below.
fn is_below(low: &Node, high: &Node) -> bool {
    let h = high.s - low.s;
    let added = Bounds { low: &low.added, high: &high.added, h };
    let subtracted = Bounds { low: &low.subtracted, high: &high.subtracted, h };
    (0..PIECES).all(|k| {
        let [from, to] = [k, k + 1].map(|k| h * f64::from(k) / f64::from(PIECES));
        let [most, least] = [added.most(from, to), subtracted.least(from, to)].map(f64::exp);
        if most - least < 1.0 {
            return true;
        }
        let ([steepest, _], [_, gentlest]) = (added.rises(from, to), subtracted.rises(from, to));
        let bound = |rise: f64, least: f64, most: f64| rise * if rise < 0.0 { least } else { most };
        bound(steepest, added.least(from, to).exp(), most)
            + bound(-gentlest, least, subtracted.most(from, to).exp())
            < 0.0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ln F, and its derivative, for two asperities of interference w at s = 0: exact.
    fn two(s: f64) -> Half {
        let terms = [(3.0, 0.2), (0.5, 2.5)].map(|(mass, w): (f64, f64)| {
            let term = mass * (-s * w - 0.5 * s * s).exp();
            (term, -(s + w) * term)
        });
        let (value, rise) = (terms[0].0 + terms[1].0, terms[0].1 + terms[1].1);
        Half { ln: value.ln(), off: 0.0, rise: rise / value, rise_off: 0.0 }
    }

    #[test]
    fn chords_and_tangents_bound_an_integral_and_its_derivative() {
        for (from, h) in [(-3.0, 1.0), (-0.5, 2.0), (0.3, 0.25), (2.0, 1.5)] {
            let (low, high) = (two(from), two(from + h));
            let bounds = Bounds { low: &low, high: &high, h };
            for k in 0..40 {
                let [t, to] = [k, k + 1].map(|k| h * f64::from(k) / 40.0);
                let [most, least] = [bounds.most(t, to), bounds.least(t, to)];
                let [largest, smallest] = bounds.rises(t, to);
                for place in [t, 0.5 * (t + to), to] {
                    let Half { ln, rise, .. } = two(from + place);
                    assert!(least <= ln + 1e-12 && ln <= most + 1e-12, "{from} {place}: {ln}");
                    assert!(smallest <= rise + 1e-12 && rise <= largest + 1e-12, "{from} {place}");
                }
                // No looser than the spread of the two interferences makes them.
                assert!(most - least < 1.4 * h * h + 3.0 * (to - t) * (1.0 + from.abs() + h));
            }
        }
    }
}
