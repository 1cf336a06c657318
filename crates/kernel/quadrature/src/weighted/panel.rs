//! One panel of a weight: a series of its logarithm.

use std::sync::OnceLock;

use crate::chebyshev::chebyshev_sum;
use crate::chebyshev::lobatto::{Samples, centred, coefficients, dot, lobatto};

/// The logarithm varies by no more than this over a panel, unless the weight is small there.
pub(crate) const RANGE: f64 = 10.0;
/// Terms of a series on a panel without a special end, at most; its error is estimated from the
/// four beyond.
const TERMS: usize = 16;
/// Terms of a series beside a power of the distance to an end.
const END_TERMS: usize = 10;
/// Within this share of the panel from an end, rounding takes too much of the distance.
const NEAREST: f64 = 1e-3;
/// The power of the map that makes fractional powers smooth: see [`Map`](super::strip::Map).
pub(crate) const MAP_POWER: f64 = 5.0;

/// A part of a weight, smooth but for a power of the distance to one end.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// The end from which distances u are counted,
    pub(crate) anchor: f64,
    /// and their direction: 1 upwards, -1 downwards.
    pub(crate) side: f64,
    pub(crate) shape: Shape,
    /// Relative error of the weight, as estimated from its samples.
    pub(crate) error: f64,
}

/// The weight as a function of u.
#[derive(Debug, Clone)]
pub(crate) enum Shape {
    Zero,
    /// Linear, with the weights at u = 0 and at the other end.
    Linear([f64; 2]),
    Series(Series),
}

/// ln weight = power·ln v + Σ terms·T(v), with v = u over the panel's width.
#[derive(Debug, Clone)]
pub(crate) struct Series {
    pub(crate) power: f64,
    /// The v at which the series begins; towards 0 it is extrapolated.
    start: f64,
    terms: Vec<f64>,
}

impl Panel {
    pub(crate) fn new(low: f64, high: f64, shape: Shape, error: f64) -> Self {
        Self { low, high, anchor: low, side: 1.0, shape, error }
    }

    pub(crate) fn width(&self) -> f64 {
        self.high - self.low
    }

    /// The distance from the anchor.
    pub(crate) fn distance(&self, z: f64) -> f64 {
        self.side * (z - self.anchor)
    }

    /// The logarithm of the weight at a distance.
    pub(crate) fn ln(&self, u: f64) -> f64 {
        match &self.shape {
            Shape::Zero => f64::NEG_INFINITY,
            Shape::Linear(_) => self.weight(u, 0.0).ln(),
            Shape::Series(series) => series.ln(u / self.width()),
        }
    }

    /// The weight at a distance, over exp(`ln_scale`).
    #[inline]
    pub(crate) fn weight(&self, u: f64, ln_scale: f64) -> f64 {
        match &self.shape {
            Shape::Zero => 0.0,
            Shape::Linear([near, far]) => {
                let share = (u / self.width()).clamp(0.0, 1.0);
                let value = near * (1.0 - share) + far * share;
                if ln_scale == 0.0 { value } else { (value.ln() - ln_scale).exp() }
            }
            Shape::Series(series) => (series.ln(u / self.width()) - ln_scale).exp(),
        }
    }

    /// Whether the weight, but for a power of the distance, varies little.
    pub(crate) fn is_gentle(&self) -> bool {
        let Shape::Series(series) = &self.shape else { return true };
        let shares = [series.start.max(1e-9), 0.1, 0.3, 0.6, 1.0];
        let smooth = shares.map(|share| series.ln(share) - series.power * share.ln());
        let least = smooth.iter().copied().fold(f64::INFINITY, f64::min);
        smooth.iter().all(|ln| ln - least <= 1.5 * RANGE)
    }

    /// The power of v that makes the weight smooth at its anchor; `None` if it is smooth.
    pub(crate) fn map_power(&self) -> Option<f64> {
        match &self.shape {
            Shape::Series(series) if series.power != 0.0 => {
                Some(MAP_POWER / (1.0 + series.power.min(0.0)))
            }
            _ => None,
        }
    }
}

impl Series {
    #[inline]
    pub(crate) fn ln(&self, share: f64) -> f64 {
        let y = if self.start > 0.0 { beside(share) } else { centred(share) };
        let smooth = chebyshev_sum(&self.terms, y);
        if self.power == 0.0 { smooth } else { smooth + self.power * share.max(0.0).ln() }
    }

    /// Without a special end, from samples of the logarithm at the points of [`lobatto`]; and the
    /// error of the logarithm.
    pub(crate) fn plain(samples: &Samples) -> (Self, f64) {
        let all = coefficients(samples);
        let (terms, beyond) = all.split_at(TERMS);
        let error = beyond.iter().map(|c| c.abs()).sum();
        // Terms of the size of rounding are dropped.
        let rounding = f64::EPSILON * terms.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
        let needed = terms.iter().rposition(|c| c.abs() > rounding).map_or(1, |last| last + 1);
        (Self { power: 0.0, start: 0.0, terms: terms[..needed].to_vec() }, error)
    }

    /// Beside an end, from samples at [`end_shares`]; and the error of the logarithm.
    pub(crate) fn beside_an_end(samples: &Samples) -> (Self, f64) {
        let fit = end_fit();
        let found: Vec<f64> = fit.inverse.iter().map(|row| dot(row, samples)).collect();
        let series = Self { power: found[0], start: NEAREST, terms: found[1..].to_vec() };
        let off = |(share, wanted): (&f64, &f64)| (series.ln(*share) - wanted).abs();
        let error = fit.shares.iter().zip(samples).map(off).fold(0.0, f64::max);
        // The error grows on the way to the end, and with the error of the power.
        let error = 4.0 * error / (1.0 + series.power).clamp(1e-3, 1.0);
        (series, error)
    }
}

/// The distances over the width at which a panel beside an end is sampled.
pub(crate) fn end_shares() -> &'static Samples {
    &end_fit().shares
}

/// Least squares for a power of the distance and a series.
struct EndFit {
    shares: Samples,
    inverse: [Samples; END_TERMS + 1],
}

fn end_fit() -> &'static EndFit {
    static FIT: OnceLock<EndFit> = OnceLock::new();
    FIT.get_or_init(|| {
        let shares = lobatto().nodes.map(|v| NEAREST + (1.0 - NEAREST) * v);
        let column = |k: usize| match k {
            0 => shares.map(f64::ln),
            k => shares.map(|v| ((k - 1) as f64 * beside(v).clamp(-1.0, 1.0).acos()).cos()),
        };
        let inverse = pseudo_inverse(std::array::from_fn(column));
        EndFit { shares, inverse }
    })
}

/// The rows that turn samples into the factors of independent columns, by least squares: Gram and
/// Schmidt, twice each, and back substitution.
fn pseudo_inverse<const N: usize>(columns: [Samples; N]) -> [Samples; N] {
    let (mut q, mut r) = (columns, [[0.0; N]; N]);
    for (k, r) in r.iter_mut().enumerate() {
        let (before, rest) = q.split_at_mut(k);
        let own = &mut rest[0];
        for _ in 0..2 {
            for (j, other) in before.iter().enumerate() {
                let share = dot(other, own);
                own.iter_mut().zip(other).for_each(|(own, other)| *own -= share * other);
                r[j] += share;
            }
        }
        r[k] = dot(own, own).sqrt();
        own.iter_mut().for_each(|own| *own /= r[k]);
    }
    for k in (0..N).rev() {
        let (upto, above) = q.split_at_mut(k + 1);
        let own = &mut upto[k];
        for (row, r) in above.iter().zip(&r[k + 1..]) {
            own.iter_mut().zip(row).for_each(|(own, row)| *own -= r[k] * row);
        }
        own.iter_mut().for_each(|own| *own /= r[k][k]);
    }
    q
}

/// The variable of the series beside an end, in [-1, 1].
fn beside(share: f64) -> f64 {
    (2.0 * share - 1.0 - NEAREST) / (1.0 - NEAREST)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_at_an_end_are_fitted() {
        // Like the densities of beta, Weibull and gamma distributions near their end.
        for (power, factor) in [(-0.5, -0.5), (1.5, 3.0)] {
            let smooth = |u: f64| factor * (9.0 - u).ln() + 4.0;
            let samples = end_shares().map(|u| power * u.ln() + smooth(u));
            let (series, error) = Series::beside_an_end(&samples);
            assert!(error < 1e-11, "{power}: {error:e}");
            assert!((series.power - power).abs() < 1e-11, "{power}: {}", series.power);
            let panel = Panel::new(3.0, 4.0, Shape::Series(series), error);
            for u in [1e-12f64, 1e-5, 2e-3, 0.4, 1.0] {
                let wanted = power * u.ln() + smooth(u);
                assert!((panel.ln(u) - wanted).abs() < 3e-10, "{power} {u}");
            }
        }
    }

    #[test]
    fn series_are_as_long_as_they_need_to_be() {
        let quadratic = lobatto().nodes.map(|v| 3.0 - v * v);
        let (series, error) = Series::plain(&quadratic);
        // Rounding of samples of 3.
        assert!(error < 1e-14, "{error:e}");
        let panel = Panel::new(-1.0, 1.0, Shape::Series(series), error);
        assert!((panel.ln(1.0) - 2.75).abs() < 1e-14);
        let (_, error) = Series::plain(&lobatto().nodes.map(|v| (v - 0.3).abs()));
        assert!(error > 1e-3);
    }
}
