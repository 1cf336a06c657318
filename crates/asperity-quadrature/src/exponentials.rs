//! Sums of weighted exponentials, four at a time: nearly all the time of a compiled evaluation.

use crate::avx2;
use crate::terms::{Exponent, Four, Place, Sums};

/// Σ e, all weights being positive.
#[inline]
pub(crate) fn positive(fours: &[Four], exponent: &Exponent) -> f64 {
    avx2::positive(fours, exponent).unwrap_or_else(|| one_by_one::positive(fours, exponent))
}

/// Σ e and Σ |e|.
#[inline]
pub(crate) fn signed(fours: &[Four], exponent: &Exponent) -> (f64, f64) {
    avx2::signed(fours, exponent).unwrap_or_else(|| one_by_one::signed(fours, exponent))
}

/// All sums.
#[inline]
pub(crate) fn sums(fours: &[Four], exponent: &Exponent, place: Place) -> Sums {
    avx2::sums(fours, exponent, place).unwrap_or_else(|| one_by_one::sums(fours, exponent, place))
}

/// With the exponential of the standard library. Without AVX2 a branch-free one was no faster.
mod one_by_one {
    use crate::terms::{Exponent, Four, LANES, Place, Sums};

    fn terms((nodes, weights): &Four, e: &Exponent) -> [f64; LANES] {
        let mut terms = nodes.map(|t| e.at(t).exp());
        terms.iter_mut().zip(weights).for_each(|(term, w)| *term *= w);
        terms
    }

    pub(super) fn positive(fours: &[Four], e: &Exponent) -> f64 {
        fours.iter().map(|four| terms(four, e).iter().sum::<f64>()).sum()
    }

    pub(super) fn signed(fours: &[Four], e: &Exponent) -> (f64, f64) {
        fours
            .iter()
            .flat_map(|four| terms(four, e))
            .fold((0.0, 0.0), |(value, size), term| (value + term, size + term.abs()))
    }

    pub(super) fn sums(fours: &[Four], e: &Exponent, place: Place) -> Sums {
        let mut sums = Sums::default();
        for four in fours {
            for (t, term) in four.0.iter().zip(terms(four, e)) {
                sums.add(term, place.s + place.ratio * t);
            }
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_paths_agree() {
        let fours: Vec<Four> = (0..5)
            .map(|k| {
                let t = [0.1, 0.4, 0.7, 0.95].map(|x| x + f64::from(k));
                (t, t.map(|t| (if k > 2 { -1.0 } else { 1.0 }) / (1.0 + t)))
            })
            .collect();
        let close = |a: f64, b: f64, size: f64| assert!((a - b).abs() < 1e-15 * size, "{a} {b}");
        for s in [-3.0, 0.0, 0.7, 30.0] {
            let exponent = Exponent { lead: 1.3, offset: 0.2, half: 0.5, rate: s };
            let place = Place { s, ratio: 1.1 };
            let here = sums(&fours, &exponent, place);
            let plain = one_by_one::sums(&fours, &exponent, place);
            for k in 0..3 {
                close(here.power[k], plain.power[k], plain.size[k]);
                close(here.size[k], plain.size[k], plain.size[k]);
            }
            let pair = one_by_one::signed(&fours, &exponent);
            close(signed(&fours, &exponent).0, pair.0, pair.1);
            close(signed(&fours, &exponent).1, plain.size[0], pair.1);
            let above = one_by_one::positive(&fours[..3], &exponent);
            close(positive(&fours[..3], &exponent), above, above);
        }
    }
}
