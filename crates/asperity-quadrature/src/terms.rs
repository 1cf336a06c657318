//! What is summed: weighted exponentials of nodes in fours, and the sums over them.

pub(crate) const LANES: usize = 4;
/// Four nodes and their weights, handled together.
pub(crate) type Four = ([f64; LANES], [f64; LANES]);

/// The exponent -(lead·t + offset)(half·t + rate) of a node t.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exponent {
    pub(crate) lead: f64,
    pub(crate) offset: f64,
    pub(crate) half: f64,
    pub(crate) rate: f64,
}

impl Exponent {
    #[inline]
    pub(crate) fn at(&self, t: f64) -> f64 {
        -(self.lead * t + self.offset) * (self.half * t + self.rate)
    }
}

/// The point z = s + ratio·t of a node t.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) s: f64,
    pub(crate) ratio: f64,
}

/// Sums over the terms e = w exp(..) at z.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Sums {
    /// Σ e zᵏ, k = 0, 1, 2.
    pub(crate) power: [f64; 3],
    /// Σ |e zᵏ|.
    pub(crate) size: [f64; 3],
}

impl Sums {
    /// Adds a weighted exponential at z.
    #[inline]
    pub(crate) fn add(&mut self, term: f64, z: f64) {
        for (k, term) in [term, term * z, term * z * z].into_iter().enumerate() {
            self.power[k] += term;
            self.size[k] += term.abs();
        }
    }
}
