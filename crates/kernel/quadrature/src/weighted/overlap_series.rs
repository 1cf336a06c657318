//! An integral over a weight as Chebyshev series in d, made when first needed.

use std::sync::{Arc, OnceLock};

use super::cell::{Map, Sample, Series, TERMS, ln_size};
use super::integral::Overlap;
use super::integrand::Sums;
use super::weight::Weight;
use crate::chebyshev::chebyshev_roots;
use crate::{Moments, QuadratureError};

/// The error of a series is estimated from its last terms, and from the integral at these shares of
/// a cell.
const CHECKED: [f64; 3] = [0.004, 0.47, 0.993];
/// The share of the tolerance for the series, apart from the integrals they interpolate.
const SHARE: f64 = 0.25;
/// The least width of a cell, relative to its place.
const NARROW: f64 = 1e-12;
/// The largest width of a cell, as a share of the weight's width; outside the weight, the distance
/// to it is added.
const WIDE: f64 = 0.3;
/// A range over which ln I deviates from a line by more than this is divided before a series is
/// tried, which would not reach a tolerance.
const BENT: f64 = 10.0;
/// Where ln I deviates by more than this over a range narrower than this share of the weight's
/// width, cells would be too narrow to be used twice, and there is an integral for each d.
const STEEP: f64 = 1e3;
const STEEP_BELOW: f64 = 0.01;
/// Series reach this number of widths of the weight beyond it; farther out, there is an integral
/// for each d.
const REACH: f64 = 64.0;

/// The integral I(d) of one density over one weight for many d. I is smooth between the d at which
/// a break of the weight meets a kink of the density, but for powers of the distance to them.
///
/// A cell is made when a d first falls into it, by bisection, with an error measured against the
/// integral itself; cells are shared by all threads.
#[derive(Debug)]
pub struct OverlapSeries {
    overlap: Arc<Overlap>,
    weight: Arc<Weight>,
    /// The d at which breaks and kinks meet, ascending.
    meetings: Vec<f64>,
    range: (f64, f64),
    root: Node,
}

/// A range of d, made when first needed.
#[derive(Debug, Default)]
struct Node(OnceLock<State>);

#[derive(Debug)]
enum State {
    Series(Box<Series>),
    /// The range is divided here; the index of the meeting if breaks and kinks meet here.
    Divided {
        at: f64,
        meeting: Option<usize>,
        parts: Box<[Node; 2]>,
    },
    /// The range is too narrow for a series, or the integral is an error.
    Direct,
}

/// A range of d during bisection.
#[derive(Clone)]
struct Range {
    low: f64,
    high: f64,
    /// Whether breaks and kinks meet at the ends.
    sharp: [bool; 2],
    /// The meetings inside.
    meetings: std::ops::Range<usize>,
}

impl OverlapSeries {
    /// OverlapSeries for all separations, none of them made yet.
    #[must_use]
    pub fn new(overlap: Arc<Overlap>, weight: Arc<Weight>) -> Self {
        let (low, high) = weight.bulk();
        let width = REACH * (high - low);
        let end = overlap.end(&weight);
        let range = (low - width, if end.is_finite() { end } else { high + width });
        let meet = |at: &f64| -> Vec<f64> {
            overlap.integrand.kinks.iter().map(|kink| at - kink * overlap.integrand.unit).collect()
        };
        let mut meetings: Vec<f64> = weight.breaks().iter().flat_map(meet).collect();
        meetings.retain(|d| *d > range.0 && *d < range.1);
        meetings.sort_by(f64::total_cmp);
        // Closer ones are one: the range between them is negligible.
        meetings.dedup_by(|a, b| (*a - *b).abs() <= NARROW * a.abs());
        Self { overlap, weight, meetings, range, root: Node::default() }
    }

    /// I(d) and -dI/dd; the bound holds for the slope only if `slope` is true.
    ///
    /// # Errors
    /// The errors of [`Overlap::at`].
    pub fn at(&self, d: f64, slope: bool) -> Result<Moments, QuadratureError> {
        match self.series(d) {
            Some(series) if self.overlap.check(series.reached, 0, slope).is_ok() => {
                Ok(series.moments(d, slope))
            }
            // The same digits with and without the slope.
            _ => self.overlap.answer(&self.overlap.find(&self.weight, d, true)?, slope),
        }
    }

    /// The series of the cell of d, if it has one.
    fn series(&self, d: f64) -> Option<&Series> {
        let (low, high) = self.range;
        if !(d >= low && d < high) {
            return None;
        }
        let mut range = Range { low, high, sharp: [false, true], meetings: 0..self.meetings.len() };
        let mut node = &self.root;
        loop {
            match node.0.get_or_init(|| self.make(&range)) {
                State::Series(series) => return Some(series),
                State::Direct => return None,
                State::Divided { at, meeting, parts } => {
                    let upper = d >= *at;
                    range = range.part(*at, *meeting, upper);
                    node = &parts[usize::from(upper)];
                }
            }
        }
    }

    fn make(&self, range: &Range) -> State {
        if !range.meetings.is_empty() {
            let middle = range.meetings.start + range.meetings.len() / 2;
            return State::divided(self.meetings[middle], Some(middle));
        }
        let Range { low, high, .. } = *range;
        let (width, bulk) = (high - low, self.weight.bulk());
        if width <= NARROW * low.abs().max(high.abs()) {
            return State::Direct;
        }
        // Too wide for a series.
        let outside = (bulk.0 - high).max(low - bulk.1).max(0.0);
        if width > WIDE * (bulk.1 - bulk.0) + outside {
            return State::divided(0.5 * (low + high), None);
        }
        // The integral itself returns the error.
        self.fit(range).unwrap_or(State::Direct)
    }

    /// A series over a range, or its parts if the series misses the tolerance.
    fn fit(&self, range: &Range) -> Result<State, QuadratureError> {
        let map = Map::new((range.low, range.high), range.sharp);
        let find = |v: f64| -> Result<Sample, QuadratureError> {
            let d = map.d(v);
            let found = self.overlap.find(&self.weight, d, true)?;
            // A slope that misses the tolerance is refused only when requested.
            self.overlap.check(found.errors, found.evaluations, false)?;
            Ok((d, found))
        };
        let root = |k: usize| 0.5 + 0.5 * chebyshev_roots(TERMS).nth(k).unwrap_or(0.0);
        // Far out, most ranges are too wide, which three integrals tell.
        let [(a, first), (b, middle), (c, last)] =
            [find(root(0))?, find(root(TERMS / 2))?, find(root(TERMS - 1))?].map(ln_size);
        let bend = (first + (last - first) * (b - a) / (c - a) - middle).abs();
        if bend > BENT {
            let (low, high) = self.weight.bulk();
            let narrow = range.high - range.low < STEEP_BELOW * (high - low);
            return Ok(if narrow && bend > STEEP { State::Direct } else { range.divided() });
        }
        let samples: Vec<Sample> = (0..TERMS).map(|k| find(root(k))).collect::<Result<_, _>>()?;
        let (mut series, left) = Series::through(map, &samples);
        let most = |of: &dyn Fn(&Sums) -> f64| {
            samples.iter().map(|(_, found)| of(found)).fold(0.0, f64::max)
        };
        series.reached = [0, 1].map(|n| most(&|found| found.errors[n]));
        let least = (SHARE * self.overlap.integrand.tolerance).max(1e-14);
        let allowed = series.reached.map(|reached| least.max(2.0 * reached));
        if left[0] > allowed[0] || left[1] > allowed[1] {
            return Ok(range.divided());
        }
        let mut off = left;
        for v in CHECKED {
            let here = series.off(&find(v)?);
            off = [off[0].max(here[0]), off[1].max(here[1])];
        }
        let errors = [0, 1].map(|n| most(&|found| found.total()[n]) + 2.0 * off[n]);
        series.error = self.overlap.bound(series.reached, errors);
        let good = off[0] <= 2.0 * allowed[0] && off[1] <= 2.0 * allowed[1];
        Ok(if good { State::Series(Box::new(series)) } else { range.divided() })
    }
}

impl State {
    fn divided(at: f64, meeting: Option<usize>) -> Self {
        Self::Divided { at, meeting, parts: Box::default() }
    }
}

impl Range {
    /// Its parts: a smaller one beside an end at which breaks and kinks meet.
    fn divided(&self) -> State {
        let width = self.high - self.low;
        let at = match self.sharp {
            [true, false] => self.low + 0.25 * width,
            [false, true] => self.high - 0.25 * width,
            _ => self.low + 0.5 * width,
        };
        State::divided(at, None)
    }

    fn part(self, at: f64, meeting: Option<usize>, upper: bool) -> Self {
        let Self { low, high, sharp, meetings } = self;
        let at_end = meeting.is_some();
        let middle = meeting.unwrap_or(meetings.start);
        if upper {
            let from = if at_end { middle + 1 } else { middle };
            Self { low: at, high, sharp: [at_end, sharp[1]], meetings: from..meetings.end }
        } else {
            Self { low, high: at, sharp: [sharp[0], at_end], meetings: meetings.start..middle }
        }
    }
}
