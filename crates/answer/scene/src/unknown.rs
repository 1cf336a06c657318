//! A number that is known within a range.

use std::fmt;

use asperity::{DerivedNumber, short};

use crate::keys::key_of_input;
use crate::quantity::unit_of;

/// Relative difference of numbers that are the same but for their errors.
const SAME: f64 = 1e-9;

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

    /// The share of an open range at a number within it.
    pub(crate) fn share(&self, number: f64) -> f64 {
        match self.ends {
            [lower, upper] if lower > 0.0 => (number / lower).ln() / (upper / lower).ln(),
            [lower, upper] => (number - lower) / (upper - lower),
        }
    }

    /// The number in the middle of the range.
    #[must_use]
    pub fn middle(&self) -> f64 {
        self.at(0.5)
    }

    fn unit(&self) -> &'static str {
        unit_of(key_of_input(&self.name)).unwrap_or_default()
    }

    /// The range as a number of a check.
    pub(crate) fn derived(&self) -> DerivedNumber {
        let meaning = format!("{}: {}", self.status, self.source).into();
        let (name, ends) = (self.name.clone().into(), Some(self.ends));
        DerivedNumber { name, value: self.middle(), unit: self.unit(), meaning, ends }
    }

    /// The ends of a value and of others; `None` where all are the same.
    pub(crate) fn spanned(value: f64, others: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
        let wider = |[lower, upper]: [f64; 2], other| [lower.min(other), upper.max(other)];
        let [lower, upper] = others.fold([value; 2], wider);
        (upper - lower > SAME * value.abs()).then_some([lower, upper])
    }
}

impl fmt::Display for Unknown {
    /// `ra 6e-7 to 1e-6 m`
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [lower, upper] = self.ends.map(short);
        let unit = self.unit();
        let gap = if unit.is_empty() { "" } else { " " };
        write!(f, "{} {lower} to {upper}{gap}{unit}", self.name)
    }
}
