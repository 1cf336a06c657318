//! A weight as panels, made once for all integrals over it.

use std::sync::OnceLock;

use super::fit::Fitter;
use super::panel::Panel;
use super::source::Source;
use super::tree::{Node, Parts};
use crate::{QuadratureError, WeightFault};

/// Octaves beyond the bulk of an unbounded weight, on each side.
pub(crate) const OCTAVES: usize = 300;
/// Octaves that belong to the bulk.
pub(crate) const BULK: i32 = 3;

/// A probability density with its ends, kinks, jumps and poles, as panels on which it is smooth
/// but for a power of the distance to one end.
#[derive(Debug)]
pub struct Weight {
    pub(crate) source: Source,
    /// Ascending and contiguous.
    pub(crate) panels: Vec<Panel>,
    /// Groups of panels, the root last.
    pub(crate) nodes: Vec<Node>,
    /// Below and above the panels.
    pub(crate) tails: [Option<Tail>; 2],
    pub(super) breaks: Vec<f64>,
    /// Above this place the weight underflows.
    pub(crate) faint: Option<f64>,
}

impl Weight {
    /// Finite ends of the support, declared breaks, and undeclared kinks and jumps, ascending.
    #[must_use]
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// The range of the panels: outside, the weight is smooth or zero.
    pub(crate) fn bulk(&self) -> (f64, f64) {
        let (first, last) = (self.panels.first(), self.panels.last());
        (first.map_or(0.0, |p| p.low), last.map_or(0.0, |p| p.high))
    }

    /// The upper end of the support, or infinity.
    pub(crate) fn top(&self) -> f64 {
        if self.tails[1].is_some() { f64::INFINITY } else { self.bulk().1 }
    }

    /// Roughly the logarithm of the largest weight above a place.
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

    /// The weight at one place over exp(`ln_scale`), from its source.
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

/// Panels, made when first needed.
type Octave = OnceLock<Result<Vec<Panel>, QuadratureError>>;

/// A weight far out: panels octave by octave, made when first needed.
#[derive(Debug)]
pub(crate) struct Tail {
    pub(super) anchor: f64,
    pub(crate) side: f64,
    scale: f64,
    octaves: Box<[Octave]>,
}

impl Tail {
    pub(super) fn new(anchor: f64, side: f64, scale: f64) -> Self {
        let octaves = (0..OCTAVES).map(|_| OnceLock::new()).collect();
        Self { anchor, side, scale, octaves }
    }

    /// The end of an octave towards the anchor.
    pub(super) fn at(&self, octave: i32) -> f64 {
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
