//! Rough surfaces whose numbers are known within ranges.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use asperity::ProfileMoments;

/// The names of the unknowns of a surface.
pub(crate) const NAMES: [&str; 3] = ["rq", "mean_slope", "bandwidth"];

/// A number of a surface that is known within a range.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Unknown {
    /// `rq` \[m\], `mean_slope` (of the isotropic surface with the same rms gradient) or
    /// `bandwidth`.
    pub name: &'static str,
    /// Lower end, geometric mean and upper end.
    pub range: [f64; 3],
    /// What the range rests on: `given`, `formula`, `scan` or `assumed`.
    pub status: &'static str,
    /// Where the range comes from.
    pub source: String,
    /// What would narrow the range.
    pub narrowed: &'static str,
}

impl Unknown {
    pub(crate) fn new(
        name: &'static str,
        [lower, upper]: [f64; 2],
        status: &'static str,
        source: String,
        narrowed: &'static str,
    ) -> Self {
        Self { name, range: [lower, (lower * upper).sqrt(), upper], status, source, narrowed }
    }

    pub(crate) fn given(name: &'static str, value: f64, source: &str) -> Self {
        // Only the lay of a finish opens a given slope again.
        let given = Self::new(name, [value; 2], "given", source.into(), "a scan");
        Self { range: [value; 3], ..given }
    }

    pub(crate) fn is_open(&self) -> bool {
        self.range[0] < self.range[2]
    }
}

/// Where each unknown of a surface is taken: 0 at its lower end, 1 in the middle, 2 at its upper
/// end.
pub(crate) type Corner = [usize; 3];
pub(crate) const MIDDLE: Corner = [1; 3];

/// One rough surface with its unknowns in the order of [`NAMES`].
#[derive(Debug, Clone)]
pub(crate) struct Face {
    pub(crate) unknowns: [Unknown; 3],
    /// The slope varies with this power of Rq over its middle; 0 if it does not follow from Rq.
    pub(crate) slope_power: f64,
}

impl Face {
    /// A surface whose moments are known.
    pub(crate) fn known(moments: &ProfileMoments) -> Self {
        let values = [moments.m0.sqrt(), (FRAC_2_PI * moments.m2).sqrt(), moments.bandwidth()];
        let given = |k: usize| Unknown::given(NAMES[k], values[k], "the numbers of the surface");
        Self { unknowns: [0, 1, 2].map(given), slope_power: 0.0 }
    }

    pub(crate) fn moments(&self, at: Corner) -> ProfileMoments {
        let [rq, slope, bandwidth] = [0, 1, 2].map(|k| self.unknowns[k].range[at[k]]);
        let slope = slope * (rq / self.unknowns[0].range[1]).powf(self.slope_power);
        let (m0, m2) = (rq * rq, FRAC_PI_2 * slope * slope);
        ProfileMoments { m0, m2, m4: bandwidth * m2 * (m2 / m0) }
    }
}
