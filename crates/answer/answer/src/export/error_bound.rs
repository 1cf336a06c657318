//! The largest size of a function on an interval, with a bound between the points where it is
//! known.

use std::f64::consts::PI;

use asperity_quadrature::{chebyshev_roots, chebyshev_terms};

/// Terms of the Chebyshev series on each piece.
const TERMS: usize = 8;
/// Points at which a series is searched for its largest value,
const POINTS: u32 = 64;
/// and between which it is larger by no more than this factor: 1/cos(n π/(2m)) for the degree n and
/// m intervals of equal angles (Ehlich & Zeller 1964). \[recalled, tested below\]
const BETWEEN: f64 = 1.015_02;
/// The terms that a series leaves out, over its last two: 2.6 next to a kink, where terms fall as
/// 1/n²; of smooth functions far less.
const REST: f64 = 4.0;
/// A piece is halved until the terms left out are this part of the largest value.
const RESOLVED: f64 = 0.02;
/// A piece is halved no more often than this: next to an undeclared jump it is then negligible.
const DEEPEST: u32 = 20;

/// Bounds of the sizes of `K` functions between ascending `ends`, at which alone they may have
/// kinks. Terms below `noise` are rounding. Once the first function is above `enough`, no more is
/// looked at.
pub(crate) fn bounds<const K: usize, E>(
    f: impl Fn(f64) -> Result<[f64; K], E>,
    ends: &[f64],
    (noise, enough): (f64, f64),
) -> Result<[f64; K], E> {
    let mut largest = [0.0_f64; K];
    let mut pieces: Vec<_> = ends.windows(2).map(|pair| (pair[0], pair[1], 0)).collect();
    while let Some((from, to, halved)) = pieces.pop() {
        let middle = 0.5 * (from + to);
        let mut samples = [[0.0; TERMS]; K];
        for (k, root) in chebyshev_roots(TERMS).enumerate() {
            let values = f(middle + 0.5 * (to - from) * root)?;
            for ((samples, value), largest) in samples.iter_mut().zip(values).zip(&mut largest) {
                samples[k] = value;
                *largest = largest.max(value.abs());
            }
        }
        if largest[0] > enough {
            return Ok(largest);
        }
        let found = samples.map(|samples| bound(&samples));
        let resolved = found
            .iter()
            .zip(largest)
            .all(|(&(bound, rest), largest)| rest <= (RESOLVED * bound.max(largest)).max(noise));
        if resolved || halved == DEEPEST || middle <= from || middle >= to {
            for ((bound, rest), largest) in found.into_iter().zip(&mut largest) {
                *largest = largest.max(bound + rest);
            }
        } else {
            pieces.extend([(middle, to, halved + 1), (from, middle, halved + 1)]);
        }
    }
    Ok(largest)
}

/// The largest size of the polynomial through samples, and of the terms left out.
fn bound(samples: &[f64; TERMS]) -> (f64, f64) {
    let terms = chebyshev_terms(samples);
    let at = |k: u32| {
        let angle = PI * f64::from(k) / f64::from(POINTS);
        terms.iter().zip(0_i32..).map(|(term, n)| term * (f64::from(n) * angle).cos()).sum::<f64>()
    };
    let largest = (0..=POINTS).map(|k| at(k).abs()).fold(0.0, f64::max);
    let last: f64 = terms[TERMS - 2..].iter().map(|term| term.abs()).sum();
    (BETWEEN * largest, REST * last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_are_bounded_between_the_points() {
        let between = 1.0 / (PI * (TERMS - 1) as f64 / (2.0 * f64::from(POINTS))).cos();
        assert!(BETWEEN >= between && BETWEEN < between + 1e-4, "{between}");
    }

    #[test]
    fn bounds_hold_and_are_close() {
        let largest = |f: &dyn Fn(f64) -> f64, ends: &[f64]| {
            bounds(|x| Ok::<_, ()>([f(x)]), ends, (1e-14, f64::INFINITY)).unwrap()[0]
        };
        // The error of a cubic, a narrow peak, a declared kink, and, undeclared, what a jump of the
        // density leaves in a force.
        type Case<'c> = (&'c dyn Fn(f64) -> f64, &'c [f64], f64);
        let cases: [Case<'_>; 4] = [
            (&|x| (x * (1.0 - x)).powi(2), &[0.0, 1.0], 1.0 / 16.0),
            (&|x| 1.0 / (1.0 + ((x - 0.3) / 0.01).powi(2)), &[0.0, 1.0], 1.0),
            (&|x| 1.0 - (x - 0.123).abs(), &[0.0, 0.123, 1.0], 1.0),
            (&|x| 1.0 - (x - 0.123).abs().powf(1.5), &[0.0, 1.0], 1.0),
        ];
        for (k, (f, ends, wanted)) in cases.into_iter().enumerate() {
            let found = largest(f, ends);
            assert!(found >= wanted && found < 1.04 * wanted, "{k}: {found} {wanted}");
        }
    }
}
