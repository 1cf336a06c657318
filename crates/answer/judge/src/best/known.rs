//! A compared number of an answer, and where it is from.

use asperity_core::Finding;

/// A compared number of an answer: area over nominal area, stiffness \[N/m\], mean gap \[m\].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Known {
    /// The number.
    pub value: f64,
    /// The ends of an interval that holds nine of ten surfaces, with evidence.
    pub ends: Option<[f64; 2]>,
    /// The ends without: beyond solved surfaces as at the nearest of them.
    pub(super) presumed: Option<[f64; 2]>,
    /// Where it is from.
    pub source: Source,
    /// A bound on its relative numerical error.
    pub(super) error: f64,
}

impl Known {
    pub(super) fn without_ends(value: f64, source: Source, error: f64) -> Self {
        Self { value, ends: None, presumed: None, source, error }
    }
}

/// Where a number is from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// Boundary elements on this scan at this load.
    Solved,
    /// Boundary elements on solved surfaces like this one.
    Evidence,
    /// The model of this id, and why it is not valid here, if it is not.
    Model(String, Option<Box<Finding>>),
}
