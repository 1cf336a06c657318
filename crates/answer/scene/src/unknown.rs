//! A number that is known within a range.

/// A number of a scene that is known within a range: written as two values, or supplied by a
/// finish or by a yield strength without a hardness.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Unknown {
    /// Its name, as that of an [input](crate::SceneFile::inputs): `body1_hardness`,
    /// `counterface_rq`. The `mean_slope` of a finish is that of the isotropic surface with the
    /// same rms gradient.
    pub name: String,
    /// Lower and upper end, in SI units.
    pub ends: [f64; 2],
    /// What the range rests on: `given`, `formula`, `scan` or `assumed`.
    pub status: &'static str,
    /// Where the range comes from.
    pub source: String,
    /// What would narrow the range.
    pub narrowed: &'static str,
}

impl Unknown {
    /// A range of one number, which is known.
    pub(crate) fn given(name: &str, value: f64, source: &str) -> Self {
        // Only the lay of a finish opens a given slope again.
        let (name, source, narrowed) = (name.into(), source.into(), "a scan");
        Self { name, ends: [value; 2], status: "given", source, narrowed }
    }

    /// A range that was written.
    pub(crate) fn written(name: String, ends: [f64; 2]) -> Self {
        let source = "two values in the scene".into();
        Self { name, ends, status: "given", source, narrowed: "one value" }
    }

    pub(crate) fn is_open(&self) -> bool {
        self.ends[0] < self.ends[1]
    }

    /// The number at a share of the range, 0 at its lower end and 1 at its upper one; the middle is
    /// the geometric mean of two positive ends, or else the arithmetic one.
    #[must_use]
    pub fn at(&self, share: f64) -> f64 {
        match self.ends {
            [lower, _] if !self.is_open() => lower,
            [lower, upper] if lower > 0.0 => lower.powf(1.0 - share) * upper.powf(share),
            [lower, upper] => lower * (1.0 - share) + upper * share,
        }
    }

    /// The number in the middle of the range.
    #[must_use]
    pub fn middle(&self) -> f64 {
        self.at(0.5)
    }
}
