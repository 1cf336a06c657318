//! The variation of a law, V(x) = |q(0)| + ∫₀ˣ |dq|: it never falls, whatever the law does, so
//! that its average over heights bounds how much the force changes between two separations:
//! ```text
//! ∫ₐᵇ |dF/ds| ds ≤ V(a) - V(b)
//! ```

use std::sync::Arc;

use asperity_quadrature::{Density, Piece, QuadratureError, Sampler, highest};

use crate::{Formula, Law, Part};

/// Places at which a function is looked at, in each octave; where it turns more than twice there,
/// four times as many, and so on up to a number beyond which its turns count as unresolved.
const OCTAVE: usize = 12;
const MOST_OF_OCTAVE: usize = 3072;
/// More turns than these are not followed: each integral of the variation is split at all of them.
const TURNS: usize = 128;
/// Turns are resolved where this many places lie between two.
const BETWEEN: usize = 6;
/// Smaller falls, over the size of the law's parts, are rounding or the error of a tabulated law.
const FLAT: f64 = 1e-9;

/// Next to an end, as a share of it.
const BESIDE: f64 = 1e-9;

/// A place where a law jumps, turns or changes its formula, in its unit from its onset.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Knot {
    pub(crate) x: f64,
    left: f64,
    right: f64,
}

/// The knots of a law, between which it rises or falls all the way.
#[derive(Debug)]
pub(crate) struct Variation {
    pub(crate) knots: Vec<Knot>,
    /// Where it first falls, if it does.
    pub(crate) falls: Option<f64>,
    /// Beyond this, it turns more often than can be followed.
    pub(crate) resolved: f64,
    /// The farthest place at which it was looked at, and its value, unless its formula shows that
    /// it rises for ever.
    last: Option<(f64, f64)>,
}

impl Variation {
    /// Of a law, where its value matters: between x = `least` and `most`.
    pub(crate) fn new(law: &Law, (least, most): (f64, f64)) -> Self {
        let breaks = law.density().breaks(0.0, f64::INFINITY);
        let ends: Vec<f64> = [0.0].into_iter().chain(breaks).chain([f64::INFINITY]).collect();
        let mut found = Self { knots: vec![], falls: None, resolved: f64::INFINITY, last: None };
        let (mut left, mut before) = (0.0, 0.0);
        for pair in ends.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let first = if from > 0.0 { from } else { 1e-6 * least.min(to) };
            // A formula may have no value at the very end of its range.
            let right = seen(law, first).or_else(|| seen(law, first * (1.0 + BESIDE)));
            let Some((right, _)) = right else { break };
            found.push(law, Knot { x: from, left, right }, before);
            before = from;
            if !rises(law, from, to) {
                before = found.turns(law, first, (from, right), (to, least, most)).0;
            }
            match seen(law, to.next_down()).or_else(|| seen(law, to * (1.0 - BESIDE))) {
                Some((value, _)) => left = value,
                None => break,
            }
        }
        if let Some(knot) = found.knots.get(TURNS) {
            found.resolved = found.resolved.min(knot.x);
        }
        found
    }

    /// The knots that are followed.
    pub(crate) fn followed(&self) -> &[Knot] {
        &self.knots[..self.knots.len().min(TURNS)]
    }

    fn push(&mut self, law: &Law, knot: Knot, before: f64) {
        let from = self.knots.last().map_or(0.0, |knot| knot.right);
        let flat = FLAT * seen(law, knot.x).map_or(0.0, |(_, size)| size);
        if self.falls.is_none() && knot.left < from - flat {
            self.falls = Some(before);
        }
        if self.falls.is_none() && knot.right < knot.left - flat {
            self.falls = Some(knot.x);
        }
        self.knots.push(knot);
    }

    /// Adds where the law turns between two breaks; the last place and value seen come out.
    fn turns(
        &mut self,
        law: &Law,
        first: f64,
        start: (f64, f64),
        (to, least, most): (f64, f64, f64),
    ) -> (f64, f64) {
        let (from, upto) = (first.max(least.min(0.5 * to)), to.min(most.max(2.0 * first)));
        let (all, resolved) = samples(law, from, upto);
        self.resolved = self.resolved.min(resolved);
        self.last = all.last().map(|last| (last.0, last.1)).filter(|_| to == f64::INFINITY);
        let (mut extreme, mut upwards, mut knot) = (start, None, start);
        for (k, &(x, q, flat)) in all.iter().enumerate() {
            let up = upwards.unwrap_or(q > extreme.1);
            let onwards = if up { q - extreme.1 } else { extreme.1 - q };
            if onwards >= 0.0 {
                upwards = upwards.or((onwards > flat).then_some(up));
                extreme = (x, q);
            } else if onwards < -flat && upwards.is_some() {
                // The extreme lies next to its largest sample.
                let sign = if up { 1.0 } else { -1.0 };
                let low = all[..k].iter().rev().map(|p| p.0).find(|p| *p < extreme.0);
                let f = |x: f64| sign * law.shape(x).unwrap_or(f64::NAN);
                let at = highest(f, low.unwrap_or(start.0), x);
                let (at, value) = match law.shape(at) {
                    Ok(value) if sign * value > sign * extreme.1 => (at, value),
                    _ => extreme,
                };
                self.push(law, Knot { x: at, left: value, right: value }, knot.0);
                knot = (at, value);
                (extreme, upwards) = ((x, q), Some(!up));
            }
        }
        // A fall that goes on to the end, or to where the law ends.
        if self.falls.is_none() && upwards == Some(false) {
            self.falls = Some(knot.0);
        }
        knot
    }

    /// The smallest value from this x on, as far as the law was looked at.
    pub(crate) fn least_from(&self, law: &Law, x: f64) -> Option<f64> {
        let last = match self.last {
            Some((end, _)) if x >= end => return None,
            Some((_, value)) => value,
            None => f64::INFINITY,
        };
        let here = law.shape(x).ok().filter(|_| x > 0.0)?;
        let beyond = self.knots.iter().filter(|knot| knot.x >= x);
        Some(beyond.map(|knot| knot.left.min(knot.right)).fold(here.min(last), f64::min))
    }

    /// The variation as a density.
    pub(crate) fn density(&self, law: &Law) -> Density {
        let (mut before, mut value, mut pieces) = (0.0, 0.0, vec![]);
        let all: Vec<f64> = law.density().breaks(0.0, f64::INFINITY);
        let knots = self.followed();
        for (k, knot) in knots.iter().enumerate() {
            let (from, to) = (knot.x, knots.get(k + 1).map_or(f64::INFINITY, |next| next.x));
            value += (knot.left - before).abs() + (knot.right - knot.left).abs();
            before = knot.right;
            let middle = if to.is_finite() { 0.5 * (from + to) } else { 2.0 * from + 1.0 };
            let parts: Vec<Part> =
                law.parts.iter().filter(|part| part.range.contains(&middle)).cloned().collect();
            let kinks = all.iter().copied().filter(|x| *x > from && *x < to).collect();
            let sampler = Arc::new(Watched { parts, value, from: knot.right });
            pieces.push(Piece { from, to, sign: 1.0, kinks, origin: None, sampler });
        }
        Density { pieces }
    }
}

/// The variation between two knots.
struct Watched {
    parts: Vec<Part>,
    value: f64,
    from: f64,
}

impl Sampler for Watched {
    fn sample(&self, x: &[f64], out: &mut [f64]) -> Result<(), QuadratureError> {
        let (mut total, mut one) = (vec![0.0; x.len()], vec![0.0; x.len()]);
        for part in &self.parts {
            part.form.sample(x, &mut one)?;
            total.iter_mut().zip(&one).for_each(|(total, one)| *total += part.sign * one);
        }
        out.iter_mut().zip(total).for_each(|(out, q)| *out = self.value + (q - self.from).abs());
        Ok(())
    }

    fn relative_error(&self, x: &[f64]) -> f64 {
        self.parts.iter().map(|part| part.form.relative_error(x)).fold(0.0, f64::max)
    }
}

/// Whether the formula alone shows that the law rises between two of its breaks.
fn rises(law: &Law, from: f64, to: f64) -> bool {
    law.parts.iter().filter(|part| part.range.start < to && part.range.end > from).all(|part| {
        let Formula::Powers(powers) = &part.form else { return false };
        powers
            .iter()
            .all(|p| p.exponent == 0.0 || p.exponent > 0.0 && p.coefficient * part.sign >= 0.0)
    })
}

/// The law's value, and the sum of its parts' absolute values.
fn seen(law: &Law, x: f64) -> Option<(f64, f64)> {
    let (mut total, mut size, mut one) = (0.0, 0.0, [0.0]);
    for part in law.parts.iter().filter(|part| part.range.contains(&x)) {
        part.form.sample(&[x], &mut one).ok()?;
        total += part.sign * one[0];
        size += one[0].abs();
    }
    total.is_finite().then_some((total, size))
}

/// The law between two places, octave by octave: place, value and what is flat there; and the place
/// beyond which it turns too often to be followed.
fn samples(law: &Law, from: f64, to: f64) -> (Vec<(f64, f64, f64)>, f64) {
    let (mut all, mut resolved) = (vec![], f64::INFINITY);
    // At least two octaves' worth of places, on however narrow a range.
    let octaves = (to / from).log2().ceil().clamp(2.0, 512.0);
    let ratio = (to / from).ln() / octaves;
    for k in 0..octaves as usize {
        let mut count = OCTAVE;
        loop {
            let place = |j: usize| {
                let share = k as f64 + j as f64 / count as f64;
                (from * (ratio * share).exp()).min(to.next_down()).max(from)
            };
            let octave: Vec<(f64, f64, f64)> = (0..=count)
                .map(place)
                .map_while(|x| seen(law, x).map(|(q, size)| (x, q, FLAT * size)))
                .collect();
            let ends = octave.len() <= count;
            let coarse = BETWEEN * turns_of(&octave) > count;
            if coarse && resolved.is_infinite() && !ends {
                if count < MOST_OF_OCTAVE {
                    count *= 4;
                    continue;
                }
                resolved = place(0);
            }
            all.extend(octave);
            if ends {
                return (all, resolved);
            }
            // It begins the next one, too.
            if k + 1 < octaves as usize {
                all.pop();
            }
            break;
        }
    }
    (all, resolved)
}

/// How often a run of samples changes its direction.
fn turns_of(samples: &[(f64, f64, f64)]) -> usize {
    let steps = samples.windows(2).map(|pair| (pair[1].1 - pair[0].1, pair[1].2));
    let steps = steps.filter(|(step, flat)| step.abs() > *flat).map(|(step, _)| step > 0.0);
    let steps: Vec<bool> = steps.collect();
    steps.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Power;

    const ALL: std::ops::Range<f64> = 0.0..f64::INFINITY;

    fn variation(law: &Law) -> Variation {
        Variation::new(law, (1e-3, 1e3))
    }

    #[test]
    fn laws_that_rise_have_no_fall() {
        let powers = Law::in_units(1.0, 1.0)
            .elastic(0.0..1.0, [Power::new(1.0, 1.5)])
            .plastic(1.0..f64::INFINITY, [Power::new(1.2, 1.0)]);
        let function = Law::in_units(1.0, 1.0).elastic(ALL, Formula::function(|x| x * x.ln_1p()));
        for law in [powers, function] {
            assert_eq!(variation(&law).falls, None, "{law:?}");
        }
    }

    #[test]
    fn jumps_and_turns_are_where_they_should_be() {
        let jumps = Law::in_units(1.0, 1.0)
            .elastic(0.0..2.0, [Power::new(1.0, 1.0)])
            .plastic(2.0..f64::INFINITY, [Power::new(0.9, 1.0)]);
        assert_eq!(variation(&jumps).falls, Some(2.0));
        let turns =
            Law::in_units(1.0, 1.0).elastic(ALL, Formula::function(|x| x * (x - 3.0).powi(2)));
        let found = variation(&turns);
        let knots: Vec<f64> = found.knots.iter().map(|knot| knot.x).collect();
        assert!(knots.len() == 3 && found.falls.is_some(), "{found:?}");
        assert!((knots[1] - 1.0).abs() < 1e-6 && (knots[2] - 3.0).abs() < 1e-6, "{knots:?}");
        // Up to 4, down to 0, and up to 20 at x = 5.
        let density = found.density(&turns);
        for (x, wanted) in [(0.5, 3.125), (1.0, 4.0), (2.0, 6.0), (3.0, 8.0), (5.0, 28.0)] {
            let value = density.value_at(x).unwrap();
            assert!((value - wanted).abs() < 1e-9, "{x}: {value}");
        }
    }
}
