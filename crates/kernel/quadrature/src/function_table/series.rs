//! One Chebyshev series, on a range of x.

use crate::chebyshev::chebyshev_sum;

/// The variable v in \[0, 1\] of a series, between two ends in x.
#[derive(Debug, Clone, Copy)]
pub(super) enum Map {
    /// v linear in ln x.
    Log,
    /// ln(x/low) = width v⁴: powers of the distance to a kink on the left become smooth.
    Left,
    /// ln(high/x) = width v⁴: a kink on the right.
    Right,
}

impl Map {
    pub(super) fn x(self, (low, high): (f64, f64), v: f64) -> f64 {
        let width = (high / low).ln();
        match self {
            Self::Log => low * (v * width).exp(),
            Self::Left => low * (v.powi(4) * width).exp(),
            Self::Right => high * (-v.powi(4) * width).exp(),
        }
    }

    fn v(self, (low, high): (f64, f64), x: f64) -> f64 {
        let width = (high / low).ln();
        let v = match self {
            Self::Log => (x / low).ln() / width,
            Self::Left => ((x / low).ln() / width).max(0.0).sqrt().sqrt(),
            Self::Right => ((high / x).ln() / width).max(0.0).sqrt().sqrt(),
        };
        v.clamp(0.0, 1.0)
    }
}

/// f(x)/x on a part of a map's interval.
#[derive(Debug)]
pub(super) struct Series {
    pub(super) low: f64,
    pub(super) high: f64,
    map: Map,
    /// Ends of the map's interval.
    ends: (f64, f64),
    /// The part in v.
    range: (f64, f64),
    terms: Vec<f64>,
}

impl Series {
    pub(super) fn new(map: Map, ends: (f64, f64), range: (f64, f64), terms: Vec<f64>) -> Self {
        let (a, b) = (map.x(ends, range.0), map.x(ends, range.1));
        Self { low: a.min(b), high: a.max(b), map, ends, range, terms }
    }

    pub(super) fn value(&self, x: f64) -> f64 {
        let v = self.map.v(self.ends, x);
        chebyshev_sum(&self.terms, 2.0 * (v - self.range.0) / (self.range.1 - self.range.0) - 1.0)
    }
}
