//! What is known of surfaces by their finish and their filters: ranges with their sources.

use std::sync::LazyLock;

use serde::Deserialize;

/// A range of a ratio or number of surfaces of one finish, or of one ratio of cut-offs.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Range {
    /// What the range is of: `rq_over_ra`, `slope`.
    what: String,
    /// The finish, the ratio of the cut-offs, or the largest Ra \[m\].
    of: String,
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    /// What the range rests on: `formula`, `scan`, `assumed` or `ISO`.
    status: String,
    pub(crate) source: String,
}

/// The key of the range where the finish is not known.
pub(crate) const UNKNOWN: &str = "unknown";

static TABLE: LazyLock<Vec<Range>> = LazyLock::new(|| {
    let rows = csv::Reader::from_reader(include_str!("finishes.csv").as_bytes());
    rows.into_deserialize().filter_map(Result::ok).collect()
});

fn ranges(what: &str) -> impl Iterator<Item = &'static Range> {
    TABLE.iter().filter(move |range| range.what == what)
}

/// The finishes of the table.
pub(crate) fn finishes() -> impl Iterator<Item = &'static str> {
    ranges("slope").map(|range| &*range.of)
}

impl Range {
    /// The range of this number for a finish.
    pub(crate) fn of_finish(what: &str, finish: &str) -> Option<&'static Self> {
        ranges(what).find(|range| range.of == finish)
    }

    /// The range of this number for the ratio of cut-offs of the table that is nearest, at most a
    /// factor of 2 away.
    pub(crate) fn at_ratio(what: &str, ratio: f64) -> Option<&'static Self> {
        let off = |range: &Self| (range.number() / ratio).ln().abs();
        let nearest = ranges(what).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.filter(|range| off(range) <= std::f64::consts::LN_2)
    }

    /// The usual cut-offs \[m\] of profiles with this Ra \[m\]: λ_s and λ_c.
    pub(crate) fn wavelengths(ra: f64) -> Option<[f64; 2]> {
        let range = ranges("wavelengths").find(|range| ra <= range.number())?;
        Some([range.lower, range.upper])
    }

    fn number(&self) -> f64 {
        self.of.parse().unwrap_or(f64::NAN)
    }

    pub(crate) fn status(&'static self) -> &'static str {
        &self.status
    }

    pub(crate) fn contains(&self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }
}
