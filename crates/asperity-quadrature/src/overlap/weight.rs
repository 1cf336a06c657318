//! A weight known by its logarithm, followed once for all integrals over it.

use std::fmt;
use std::sync::{Arc, OnceLock};

use super::fit::Fitter;
use super::integral::Overlap;
use super::panel::Panel;
use super::tree::{Node, Parts, tree};
use crate::{Density, Piece, QuadratureError, WeightFault};

/// Octaves beyond the bulk of a weight without an end, on each side.
pub(crate) const OCTAVES: usize = 300;
/// Octaves that belong to the bulk.
const BULK: i32 = 3;
/// The octave below which there is next to nothing.
const BOTTOM: i32 = 60;
/// How far from 1 the integral of a weight may be that is no approximation.
const NORMALISED: f64 = 1e-6;

/// What tells a weight.
pub(crate) struct Source {
    name: String,
    pub(crate) ln: Box<dyn Fn(f64) -> f64 + Send + Sync>,
}

impl Source {
    pub(crate) fn fault(&self, fault: WeightFault) -> QuadratureError {
        QuadratureError::Weight { weight: self.name.clone(), fault }
    }
}

/// A probability density with its ends, kinks, jumps and poles, cut into panels on which it is
/// smooth but for a power of the distance to one end.
pub struct Weight {
    pub(crate) source: Source,
    /// Ascending and contiguous.
    pub(crate) panels: Vec<Panel>,
    /// Groups of panels, the root last.
    pub(crate) nodes: Vec<Node>,
    /// Below and above the panels.
    pub(crate) tails: [Option<Tail>; 2],
    breaks: Vec<f64>,
    /// Above this it is known no more.
    pub(crate) faint: Option<f64>,
}

impl fmt::Debug for Weight {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Weight")
            .field("name", &self.source.name)
            .field("panels", &self.panels.len())
            .finish_non_exhaustive()
    }
}

impl Weight {
    /// Follows a weight on its support. `breaks` are where it has kinks, jumps and poles; kinks and
    /// jumps that are not among them are found. `error` is the weight's own, relative.
    ///
    /// # Errors
    /// [`QuadratureError::Weight`] with what is wrong.
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
            // The mean is as good a place to begin, and a likely one for a kink.
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

    /// The whole weight: poles, peaks and jumps that were not declared may be missing.
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

    /// Finite ends of the support, breaks, and the kinks and jumps that were found, ascending.
    #[must_use]
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// Below and above this, the weight is smooth or zero.
    pub(crate) fn bulk(&self) -> (f64, f64) {
        let (first, last) = (self.panels.first(), self.panels.last());
        (first.map_or(0.0, |p| p.low), last.map_or(0.0, |p| p.high))
    }

    /// The end of its support above, where there is one: it is zero from there on.
    pub(crate) fn top(&self) -> f64 {
        if self.tails[1].is_some() { f64::INFINITY } else { self.bulk().1 }
    }

    /// The logarithm of the largest weight above a place, or nearly.
    pub(crate) fn peak_above(&self, z: f64) -> Result<f64, QuadratureError> {
        if z < self.bulk().1 {
            return Ok(self.peak_in(self.nodes.len() - 1, z));
        }
        let value = (self.source.ln)(z);
        if value < f64::INFINITY {
            Ok(value)
        } else {
            Err(self.source.fault(WeightFault::Value { at: z, value }))
        }
    }

    fn peak_in(&self, place: usize, z: f64) -> f64 {
        let node = &self.nodes[place];
        match node.parts {
            _ if node.high <= z => f64::NEG_INFINITY,
            _ if node.low >= z => node.peak,
            Parts::Groups(left, right) => self.peak_in(left, z).max(self.peak_in(right, z)),
            Parts::Panel(panel) => {
                let panel = &self.panels[panel];
                panel.ln(panel.distance(z)).max(panel.ln(panel.distance(panel.high)))
            }
        }
    }

    /// The weight at one place over exp(`ln_scale`), as its source has it.
    pub(crate) fn at(&self, z: f64, ln_scale: f64) -> Result<f64, QuadratureError> {
        let (low, high) = self.bulk();
        if z < low && self.tails[0].is_none() || z > high && self.tails[1].is_none() {
            return Ok(0.0);
        }
        let value = (self.source.ln)(z);
        if value < f64::INFINITY {
            Ok((value - ln_scale).exp())
        } else {
            Err(self.source.fault(WeightFault::Value { at: z, value }))
        }
    }
}

impl Source {
    /// The distance from a place around which the weight is; `None` where it is zero.
    fn scale(&self, anchor: f64, side: f64) -> Option<f64> {
        let (mut best, mut most) = (None, f64::NEG_INFINITY);
        for octave in -300..=300 {
            let u = 2f64.powi(octave);
            let z = anchor + side * u;
            if u <= 64.0 * f64::EPSILON * anchor.abs() {
                continue;
            }
            // What is none here may be where nothing is ever followed to.
            let value = (self.ln)(z);
            let mass = value + u.ln();
            if mass > most && mass < f64::INFINITY {
                (best, most) = (Some(u), mass);
            }
        }
        best
    }
}

/// Panels, once they are needed.
type Octave = OnceLock<Result<Vec<Panel>, QuadratureError>>;

/// A weight far out, followed octave by octave when it is needed.
pub(crate) struct Tail {
    anchor: f64,
    pub(crate) side: f64,
    scale: f64,
    octaves: Box<[Octave]>,
}

impl Tail {
    fn new(anchor: f64, side: f64, scale: f64) -> Self {
        let octaves = (0..OCTAVES).map(|_| OnceLock::new()).collect();
        Self { anchor, side, scale, octaves }
    }

    /// Where an octave begins, seen from the anchor.
    fn at(&self, octave: i32) -> f64 {
        self.anchor + self.side * self.scale * 2f64.powi(octave)
    }

    /// The panels of an octave, ascending.
    pub(crate) fn octave(
        &self,
        source: &Source,
        peak: f64,
        k: usize,
    ) -> Result<&[Panel], QuadratureError> {
        let made = self.octaves[k].get_or_init(|| {
            let octave = BULK + k as i32;
            let mut fitter = Fitter::new(source, false, peak);
            fitter.octave(self.at(octave), self.at(octave + 1))?;
            fitter.panels.sort_by(|a, b| a.low.total_cmp(&b.low));
            Ok(fitter.panels)
        });
        made.as_deref().map_err(Clone::clone)
    }
}
