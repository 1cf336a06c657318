//! The derivative of a density of unknown form.

use crate::chebyshev::lobatto::{NODES, Samples, dot, lobatto};
use crate::{Density, QuadratureError};

/// The rounding of the interpolating polynomial's derivative at its ends, in units of the largest
/// value over the interval.
pub(crate) const DERIVED: f64 = 4.0 * f64::EPSILON;
/// The share of the distance to the origin of powers below that is a large enough interval.
const ROOM: f64 = 0.25;

/// The derivative over an interval, from samples there. If a panel of a weight is so small that
/// neighbouring values of the density are equal, the interval is larger than the panel.
pub(crate) struct Slopes {
    low: f64,
    width: f64,
    by_place: Samples,
    /// Error by rounding.
    pub(crate) noise: f64,
    /// Error of the interpolation.
    pub(crate) off: f64,
}

impl Slopes {
    /// The length by which an interval between kinks is too short; 0 if it is not.
    pub(crate) fn missing(
        density: &Density,
        (from, to): (f64, f64),
        kinks: (f64, f64),
        halvings: u32,
    ) -> f64 {
        // Powers of the distance begin at the origin, or at the kink below.
        let origins = density.active(from, to).map(|piece| piece.origin.unwrap_or(kinks.0));
        let room = (from - origins.fold(f64::NEG_INFINITY, f64::max)).max(0.0);
        let missing = ROOM * 0.5f64.powi(halvings as i32) * room - (to - from);
        if missing.is_finite() {
            missing.clamp(0.0, (from - kinks.0) + (kinks.1 - to))
        } else {
            0.0
        }
    }

    /// Over `[from, to]` or more, between the kinks around it; `ends` select the pieces.
    pub(crate) fn new(
        density: &Density,
        ends: (f64, f64),
        (from, to): (f64, f64),
        kinks: (f64, f64),
        halvings: u32,
    ) -> Result<Self, QuadratureError> {
        let more = Self::missing(density, (from, to), kinks, halvings);
        let (below, above) = ((from - kinks.0).max(0.0), (kinks.1 - to).max(0.0));
        let below = (0.5 * more).max(more - above).min(below);
        let (low, width) = (from - below, to - from + more);
        let rule = lobatto();
        let x = rule.nodes.map(|node| (low + width * node).clamp(kinks.0, kinks.1));
        let (mut scratch, mut q) = ([0.0; NODES], [0.0; NODES]);
        density.sample(ends, &x, &mut scratch, &mut q)?;
        let largest = q.iter().fold(0.0, |m: f64, q| m.max(q.abs()));
        Ok(Self {
            low,
            width,
            by_place: rule.derivative(&q).map(|slope| slope / width),
            noise: DERIVED * largest / width,
            off: rule.tail(&q) / width,
        })
    }

    /// The derivative at a place in the interval.
    pub(crate) fn at(&self, x: f64) -> f64 {
        dot(&lobatto().basis((x - self.low) / self.width), &self.by_place)
    }
}
