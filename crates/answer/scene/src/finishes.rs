//! Ranges of surface numbers by finish and by cut-offs, with their sources: finishes.csv.

use std::sync::LazyLock;

use asperity::{ContactError, short};
use serde::Deserialize;

use crate::unknown::Unknown;

/// A range of a number of surfaces of one finish, or of one ratio of cut-offs.
#[derive(Debug, Clone, Deserialize)]
pub(crate) struct Range {
    /// The number: `ra` \[m\] (of less frequent applications by ASME B46.1 \[recalled\], twice as
    /// wide and finer where super-finished surfaces are), `rq_over_ra`, `rz_over_rq`, `slope` (over
    /// the usual one, at λ_s 2.5 µm), `slope_longer` (at a cut-off 3.2 times as long over that),
    /// `skewness`, `along_over_across` (slopes, by the lay), `bandwidth`, `slope_over_rz_rsm` (over
    /// 2 Rz/RSm) or `wavelengths` (λ_s and λ_c \[m\]).
    what: String,
    /// The finish, the ratio of the cut-offs λ_c/λ_s, or the largest Ra \[m\].
    of: String,
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    /// What the range rests on: `formula`, `scan`, `assumed` or `ISO`.
    pub(crate) status: String,
    pub(crate) source: String,
}

/// The key of the range where the finish is not known.
const UNKNOWN: &str = "unknown";

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
    /// The range of this number for a finish, or where none is known.
    ///
    /// # Errors
    /// [`ContactError::Missing`] for a finish without one.
    pub(crate) fn of_finish(
        what: &str,
        finish: Option<&str>,
    ) -> Result<&'static Self, ContactError> {
        let found = ranges(what).find(|range| range.of == finish.unwrap_or(UNKNOWN));
        let reason = || format!("a finish with a known {what}");
        found.ok_or_else(|| ContactError::Missing { field: "finish", reason: reason() })
    }

    /// The range of this number for the ratio of the cut-offs λ_s and λ_c of the table that is
    /// nearest.
    ///
    /// # Errors
    /// [`ContactError::Missing`] asks for `key` instead more than a factor of 2 away.
    pub(crate) fn at_ratio(
        what: &str,
        key: &'static str,
        [short_cut, cut]: [f64; 2],
    ) -> Result<&'static Self, ContactError> {
        let off = |range: &Self| (range.number() * short_cut / cut).ln().abs();
        let nearest = ranges(what).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.filter(|range| off(range) <= std::f64::consts::LN_2).ok_or_else(|| {
            let reason = format!(
                "lambda_c/lambda_s is {}, and scans give a range from 10 to 320 only",
                short(cut / short_cut)
            );
            ContactError::Missing { field: key, reason }
        })
    }

    /// The usual cut-offs \[m\] of profiles with this Ra \[m\]: λ_s and λ_c.
    pub(crate) fn cut_offs(ra: f64) -> Option<[f64; 2]> {
        let range = ranges("wavelengths").find(|range| ra <= range.number())?;
        Some([range.lower, range.upper])
    }

    /// The range of the slope over the usual one of profiles of a finish with this λ_s \[m\]: the
    /// table has that at 2.5 µm, and the range of the ratio of two slopes of which one has 3.2
    /// times the cut-off of the other.
    ///
    /// # Errors
    /// The errors of [`of_finish`](Self::of_finish).
    pub(crate) fn slopes(
        finish: Option<&str>,
        short_cut: f64,
    ) -> Result<(&'static Self, [f64; 2]), ContactError> {
        let range = Self::of_finish("slope", finish)?;
        let longer = Self::of_finish("slope_longer", finish)?;
        let steps = (short_cut / 2.5e-6).ln() / 3.2f64.ln();
        let by = [longer.lower.powf(steps), longer.upper.powf(steps)];
        let [least, most] = [by[0].min(by[1]), by[0].max(by[1])];
        Ok((range, [range.lower * least, range.upper * most]))
    }

    /// The range of a number that follows from this one, which is described by `text`.
    pub(crate) fn unknown(
        &'static self,
        name: &str,
        [one, other]: [f64; 2],
        text: &str,
        narrowed: &'static str,
    ) -> Unknown {
        let Self { status, source, .. } = self;
        let (ends, source) = ([one.min(other), one.max(other)], format!("{text}: {source}"));
        Unknown { name: name.into(), ends, status, source, narrowed }
    }

    fn number(&self) -> f64 {
        self.of.parse().unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_is_a_range_and_every_finish_has_six() {
        assert_eq!(TABLE.len(), include_str!("finishes.csv").lines().count() - 1);
        for Range { what, of, lower, upper, status, source } in TABLE.iter() {
            let is_positive = 0.0 < *lower || what == "skewness";
            assert!(is_positive && lower <= upper && !source.is_empty(), "{what} of {of}");
            assert!(["formula", "scan", "assumed", "ISO"].contains(&&**status), "{status}");
        }
        let key = crate::keys::KEYS.iter().find(|key| key.name == "finish").unwrap();
        assert_eq!(finishes().collect::<Vec<_>>().join("|"), key.form[1]);
        for what in ["ra", "rq_over_ra", "rz_over_rq", "slope", "slope_longer", "along_over_across"]
        {
            assert!(
                finishes().all(|finish| Range::of_finish(what, Some(finish)).is_ok()),
                "{what}"
            );
        }
        // An Ra beyond the last row has a cut-off, too.
        assert_eq!(Range::cut_offs(1e-3), Some([2.5e-5, 8e-3]));
        assert!(Range::at_ratio("bandwidth", "bandwidth", [1.0, 1000.0]).is_err());
    }

    #[test]
    fn measured_slopes_and_bandwidths_lie_in_the_ranges() {
        let rows = include_str!("../../../../tests/reference/finishes_scans.csv").lines().skip(1);
        let rows: Vec<(&str, &str, Vec<f64>)> = rows
            .map(|line| {
                let cells: Vec<&str> = line.split(',').collect();
                let numbers = cells[2..].iter().map(|n| n.parse().unwrap()).collect();
                (cells[0], cells[1], numbers)
            })
            .collect();
        let mut compared = 0;
        for (surface, finish, numbers) in &rows {
            let [cut, short, rq, slope, bandwidth] = numbers[..] else { panic!("{surface}") };
            let range = Range::at_ratio("bandwidth", "bandwidth", [short, cut]).unwrap();
            assert!(
                (range.lower..=range.upper).contains(&bandwidth),
                "{surface} {cut} {short}: bandwidth {bandwidth}"
            );
            // Slopes at the longest cut-off of each surface, without its waviness.
            let of_surface = rows.iter().filter(|row| row.0 == *surface);
            let longest = of_surface.map(|row| row.2[0]).fold(0.0, f64::max);
            if finish.is_empty() || cut < longest {
                continue;
            }
            let ratio = slope / (0.125 * rq.powf(0.402));
            let (_, [lower, upper]) = Range::slopes(Some(finish), 1e-6 * short).unwrap();
            assert!(
                (lower..=upper).contains(&ratio),
                "{surface} {cut} {short}, {finish}: {ratio} of {lower} to {upper}"
            );
            compared += 1;
        }
        assert!(compared > 15, "{compared}");
    }
}
