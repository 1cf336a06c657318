//! The panels of a weight, from its logarithm and breaks, and the check of its integral.

use std::sync::Arc;

use super::fit::Fitter;
use super::integral::Overlap;
use super::source::Source;
use super::tree::tree;
use super::weight::{BULK, Tail, Weight};
use crate::{Density, Piece, QuadratureError, WeightFault};

/// The octave beyond which the weight is negligible.
const BOTTOM: i32 = 60;
/// The largest deviation from 1 of the integral of an exact weight.
const NORMALISED: f64 = 1e-6;

impl Weight {
    /// A weight on its support. `breaks` are the places of kinks, jumps and poles; undeclared kinks
    /// and jumps are found. `error` is the relative error of the weight's own values.
    ///
    /// # Errors
    /// [`QuadratureError::Weight`] with the fault.
    pub fn new(
        name: impl Into<String>,
        ln: impl Fn(f64) -> f64 + Send + Sync + 'static,
        (low, high): (f64, f64),
        breaks: &[f64],
        error: f64,
    ) -> Result<Self, QuadratureError> {
        let source = Source { name: name.into(), ln: Box::new(ln) };
        if !(low < high && low < f64::INFINITY && high > f64::NEG_INFINITY) {
            return Err(source.fault(WeightFault::Support { low, high }));
        }
        if let Some(&at) = breaks.iter().find(|at| !at.is_finite()) {
            return Err(source.fault(WeightFault::Break { at }));
        }
        let inside = breaks.iter().copied().filter(|at| *at > low && *at < high);
        let mut ends: Vec<f64> = [low, high].into_iter().filter(|at| at.is_finite()).collect();
        ends.extend(inside);
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        if ends.is_empty() {
            // The mean, a likely place of a kink.
            ends.push(0.0);
        }
        let outermost = (ends[0], ends[ends.len() - 1]);
        let tail = |anchor: f64, end: f64, side: f64| {
            let scale = if end.is_finite() { None } else { source.scale(anchor, side) };
            scale.map(|scale| Tail::new(anchor, side, scale))
        };
        let tails = [tail(outermost.0, low, -1.0), tail(outermost.1, high, 1.0)];
        let mut fitter = Fitter::new(&source, true, f64::NEG_INFINITY);
        for pair in ends.windows(2) {
            fitter.between(pair[0], pair[1])?;
        }
        for tail in tails.iter().flatten() {
            fitter.beside(tail.anchor, tail.at(0))?;
            for octave in 0..BULK {
                fitter.octave(tail.at(octave), tail.at(octave + 1))?;
            }
        }
        let Fitter { mut panels, kinks, faint, .. } = fitter;
        panels.sort_by(|a, b| a.low.total_cmp(&b.low));
        if panels.is_empty() {
            let value = (source.ln)(0.0);
            let (at, nan) = (0.0, value.is_nan());
            let zero = WeightFault::Zero { low, high };
            return Err(source.fault(if nan { WeightFault::Value { at, value } } else { zero }));
        }
        ends.extend(kinks);
        ends.sort_by(f64::total_cmp);
        let nodes = tree(&panels);
        let weight = Self { source, panels, nodes, tails, breaks: ends, faint };
        let integral = weight.integral()?;
        if (integral - 1.0).abs() <= NORMALISED.max(2.0 * error) {
            Ok(weight)
        } else {
            Err(weight.source.fault(WeightFault::Integral { integral }))
        }
    }

    /// The integral of the weight: undeclared poles, peaks and jumps may be missing in it.
    fn integral(&self) -> Result<f64, QuadratureError> {
        let (low, high) = self.bulk();
        let below = self.tails[0].as_ref().map_or(low - (high - low), |tail| tail.at(BOTTOM));
        let one = |_: &[f64], out: &mut [f64]| {
            out.fill(1.0);
            Ok(())
        };
        let piece = Piece {
            from: 0.0,
            to: f64::INFINITY,
            sign: 1.0,
            kinks: vec![],
            origin: Some(0.0),
            sampler: Arc::new(one),
        };
        let one = Overlap::smooth(Density { pieces: vec![piece] }, high - low, NORMALISED);
        Ok(one.find(self, below, false)?.sums[0])
    }
}
