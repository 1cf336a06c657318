//! What to do about a finding, where the way differs from place to place.

use std::fmt;

/// What to do about a finding, for which the program has a command, Python a function and the page
/// a button; each front end words it. [`Display`](fmt::Display) has words for every reader.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Advice {
    /// Use these models.
    UseModels(&'static str),
    /// Compare the statistics of the scan at several cut-offs.
    CompareCutOffs,
    /// Replace the outliers of the scan.
    Despike,
}

impl fmt::Display for Advice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UseModels(ids) => write!(f, "use {ids}"),
            Self::CompareCutOffs => f.write_str("compare several cut-offs"),
            Self::Despike => f.write_str("replace these points"),
        }
    }
}
