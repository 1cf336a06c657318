//! One panel of a density times a smooth weight: samples, masses and error.

use crate::rules::legendre::{INSET, Legendre, legendre};
use crate::{Density, Piece, QuadratureError};

/// Points of the rule on each panel.
pub(crate) const POINTS: usize = 20;
/// Fractional powers at a panel's left end, (x-o)^p with p ≥ 0, become u^(5p+4), which `POINTS`
/// nodes integrate to rounding.
const MAP_POWER: i32 = 5;

/// One panel: x = origin + (v·span)^5-mapped, v in [low, high].
#[derive(Default)]
pub(crate) struct Panel {
    origin: f64,
    span: f64,
    low: f64,
    high: f64,
    /// Ends in x, which select the active pieces (the nodes never do).
    ends: (f64, f64),
    pub(crate) depth: u32,
    /// Number of halvings in a row that have not helped.
    pub(crate) stalled: u32,
    pub(crate) points: [f64; POINTS],
    pub(crate) masses: [f64; POINTS],
    pub(crate) error: f64,
}

impl Panel {
    pub(crate) fn new(origin: f64, from: f64, to: f64, ends: (f64, f64)) -> Self {
        let span = to - origin;
        let low = ((from - origin) / span).powf(1.0 / f64::from(MAP_POWER));
        Self::mapped(origin, span, (low, 1.0), ends, 0)
    }

    fn mapped(
        origin: f64,
        span: f64,
        (low, high): (f64, f64),
        ends: (f64, f64),
        depth: u32,
    ) -> Self {
        Self { origin, span, low, high, ends, depth, ..Self::default() }
    }

    pub(crate) fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.low + self.high);
        [(self.low, middle), (middle, self.high)]
            .map(|range| Self::mapped(self.origin, self.span, range, self.ends, self.depth + 1))
    }

    /// Samples the panel; returns the number of density evaluations.
    pub(crate) fn sample(
        &mut self,
        density: &Density,
        weight: &dyn Fn(f64) -> f64,
    ) -> Result<usize, QuadratureError> {
        let rule = legendre(POINTS);
        let width = self.high - self.low;
        let nodes = [INSET].into_iter().chain(rule.nodes.iter().copied()).chain([1.0 - INSET]);
        let (mut x, mut slope) = ([0.0; POINTS + 2], [0.0; POINTS + 2]);
        for ((x, slope), node) in x.iter_mut().zip(&mut slope).zip(nodes) {
            let v = self.low + width * node;
            let v4 = (v * v) * (v * v);
            *x = self.origin + self.span * (v * v4);
            *slope = self.span * f64::from(MAP_POWER) * v4;
        }
        // The ends are checked for hidden kinks, except where all kinks are known, as those of sums
        // of powers, and where the map begins, which carries next to nothing.
        let (low, high) = self.ends;
        // Kinks of tables are known too, and their own error, known only as they are built, must
        // not decide.
        let unknown =
            |piece: &Piece| piece.origin.is_none() && piece.sampler.relative_error(&[]) <= 0.0;
        let judged = density.active(low, high).any(unknown);
        let range = match (judged, self.low > 0.0) {
            (true, true) => 0..POINTS + 2,
            (true, false) => 1..POINTS + 2,
            (false, _) => 1..POINTS + 1,
        };
        let (mut scratch, mut values) = ([0.0; POINTS + 2], [0.0; POINTS + 2]);
        let evaluations = density.sample(
            self.ends,
            &x[range.clone()],
            &mut scratch[range.clone()],
            &mut values[range.clone()],
        )?;
        for ((value, slope), &at) in values.iter_mut().zip(&slope).zip(&x) {
            *value *= slope * weight(at);
            if !value.is_finite() {
                return Err(QuadratureError::NotFinite { at, value: *value });
            }
        }
        let inner = 1..POINTS + 1;
        self.points.copy_from_slice(&x[inner.clone()]);
        self.masses.copy_from_slice(&values[inner]);
        self.error = width * rule.error(&self.masses);
        if judged {
            let ends = [0, POINTS + 1].map(|k| range.contains(&k).then_some(values[k]));
            self.error += width * hidden(rule, &self.masses, ends);
        }
        for (mass, w) in self.masses.iter_mut().zip(&rule.weights) {
            *mass *= w * width;
        }
        Ok(evaluations)
    }

    pub(crate) fn size(&self) -> f64 {
        self.masses.iter().map(|m| m.abs()).sum()
    }
}

/// Bound on the error of a kink or jump beyond the outermost nodes: the share of the panel there
/// times the deviation at its ends from the series through the nodes.
pub(crate) fn hidden(rule: &Legendre, samples: &[f64], ends: [Option<f64>; 2]) -> f64 {
    let largest = samples.iter().chain(ends.iter().flatten()).fold(0.0, |m: f64, f| m.max(f.abs()));
    let rounding = 1e-12 * largest;
    let off = |(series, value): (f64, Option<f64>)| value.map_or(0.0, |v| (series - v).abs());
    let off = rule.at_ends(samples).into_iter().zip(ends).map(off).fold(0.0, f64::max);
    if off > rounding { rule.nodes[0] * off } else { 0.0 }
}
