//! An integral over a weight as Chebyshev series in d, made when first needed.

use std::fmt;
use std::sync::{Arc, OnceLock};

use super::integral::{Overlap, SCALED, Sums};
use super::weight::Weight;
use crate::chebyshev::{chebyshev_roots, chebyshev_sum, chebyshev_terms};
use crate::{Moments, QuadratureError};

/// Terms of a series; its error is estimated from the last three,
const TERMS: usize = 12;
const LAST: usize = 3;
/// and from the integral at these shares of a cell.
const CHECKED: [f64; 3] = [0.004, 0.47, 0.993];
/// The share of the tolerance for the series, apart from the integrals they interpolate.
const SHARE: f64 = 0.25;
/// The least width of a cell, relative to its place.
const NARROW: f64 = 1e-12;
/// The largest width of a cell, as a share of the weight's width; outside the weight, the distance
/// to it is added.
const WIDE: f64 = 0.3;
/// The largest deviation of ln I from a line over a cell: a series has some digits at most of what
/// deviates farther. In ranges narrower than a share of the weight's width that deviate as far as
/// STEEP, cells would serve too few d to pay, and there is an integral for each d.
const BENT: f64 = 10.0;
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
pub struct OverlapSeries {
    overlap: Arc<Overlap>,
    weight: Arc<Weight>,
    /// The d at which breaks and kinks meet, ascending.
    meetings: Vec<f64>,
    range: (f64, f64),
    root: Node,
}

impl fmt::Debug for OverlapSeries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OverlapSeries").field("range", &self.range).finish_non_exhaustive()
    }
}

/// A range of d, made when first needed.
#[derive(Default)]
struct Node(OnceLock<State>);

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

struct Series {
    map: Map,
    /// Value, slope and their sizes, over exp(`ln_scale`); no sizes if they equal the values.
    terms: [Vec<f64>; 4],
    /// The logarithm of the scale at the lower end, and its slope.
    ln_scale: [f64; 2],
    /// The smallest sizes of value and slope, over their scale.
    least: [f64; 2],
    /// The integration errors of value and slope, and the bound.
    reached: [f64; 2],
    error: f64,
}

/// From d to v in [0, 1].
#[derive(Debug, Clone, Copy)]
struct Map {
    low: f64,
    high: f64,
    spacing: Spacing,
}

#[derive(Debug, Clone, Copy)]
enum Spacing {
    Linear,
    /// The distance to the lower end is v².
    Low,
    /// The distance to the higher end is v².
    High,
}

impl Map {
    fn new(range: &Range) -> Self {
        let spacing = match range.sharp {
            [true, false] => Spacing::Low,
            [false, true] => Spacing::High,
            _ => Spacing::Linear,
        };
        Self { low: range.low, high: range.high, spacing }
    }

    fn d(&self, v: f64) -> f64 {
        let width = self.high - self.low;
        match self.spacing {
            Spacing::Linear => self.low + width * v,
            Spacing::Low => self.low + width * v * v,
            Spacing::High => self.high - width * v * v,
        }
    }

    fn v(&self, d: f64) -> f64 {
        let width = self.high - self.low;
        match self.spacing {
            Spacing::Linear => (d - self.low) / width,
            Spacing::Low => ((d - self.low) / width).sqrt(),
            Spacing::High => ((self.high - d) / width).sqrt(),
        }
    }
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
    /// Those of [`Overlap::at`].
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
        let map = Map::new(range);
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

/// The integral at one d.
type Sample = (f64, Sums);

/// The logarithm of the size of the integral at its d.
fn ln_size((d, found): Sample) -> (f64, f64) {
    (d, found.sizes[0].ln() + found.ln_scale)
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

impl Series {
    /// The series through the integrals at the roots, and the last terms of value and of slope,
    /// relative to their smallest sizes.
    fn through(map: Map, samples: &[Sample]) -> (Self, [f64; 2]) {
        // Far out, sizes are nearly exponentials of d.
        let ((d, from), (to, there)) = (ln_size(samples[0]), ln_size(samples[TERMS - 1]));
        let slope = (there - from) / (to - d);
        let ln_scale =
            if slope.is_finite() { [from + slope * (map.low - d), slope] } else { [0.0; 2] };
        let (terms, none) = (Default::default(), [0.0; 2]);
        let mut series = Self { map, terms, ln_scale, least: none, reached: none, error: 0.0 };
        let numbers: Vec<[f64; 4]> = samples.iter().map(|sample| series.numbers(sample)).collect();
        for n in [0, 1] {
            series.least[n] = numbers.iter().map(|f| f[n + 2]).fold(f64::INFINITY, f64::min);
            // Sizes are the values themselves if nothing changes sign.
            let same = |f: &[f64; 4]| (f[n] - f[n + 2]).abs() <= 1e-13 * f[n + 2];
            let wanted = if numbers.iter().all(same) { vec![n] } else { vec![n, n + 2] };
            for n in wanted {
                let samples: Vec<f64> = numbers.iter().map(|f| f[n]).collect();
                series.terms[n] = chebyshev_terms(&samples);
            }
        }
        let last = |n: usize| series.terms[n][TERMS - LAST..].iter().map(|t| t.abs()).sum();
        let left = [0, 1].map(|n| series.relative(n, last(n)));
        (series, left)
    }

    /// Value, slope and sizes of a sample, in the cell's scale.
    fn numbers(&self, (d, found): &Sample) -> [f64; 4] {
        let Sums { sums: [value, slope], sizes: [size, slope_size], ln_scale, .. } = *found;
        let scale = (ln_scale - self.ln_scale(*d)).exp();
        [value, slope, size, slope_size].map(|number| number * scale)
    }

    fn ln_scale(&self, d: f64) -> f64 {
        self.ln_scale[0] + self.ln_scale[1] * (d - self.map.low)
    }

    /// A deviation over the smallest size; infinite if NaN, as on ranges over which the scale
    /// overflows f64.
    fn relative(&self, n: usize, off: f64) -> f64 {
        let share = if off == 0.0 { 0.0 } else { off / self.least[n] };
        if share.is_nan() { f64::INFINITY } else { share }
    }

    /// The deviations from a sample.
    fn off(&self, sample: &Sample) -> [f64; 2] {
        let y = 2.0 * self.map.v(sample.0) - 1.0;
        let numbers = self.numbers(sample);
        let off = |n: usize| (chebyshev_sum(&self.terms[n], y) - numbers[n]).abs();
        [0, 1].map(|n| self.relative(n, off(n)))
    }

    #[inline]
    fn moments(&self, d: f64, slope: bool) -> Moments {
        let y = 2.0 * self.map.v(d) - 1.0;
        let ln = self.ln_scale(d);
        let (scale, ln_scale) = if ln.abs() < SCALED { (ln.exp(), 0.0) } else { (1.0, ln) };
        let sum = |n: usize| scale * chebyshev_sum(&self.terms[n], y);
        let size = |n: usize, f: f64| {
            if self.terms[n].is_empty() { f.abs() } else { sum(n).max(f.abs()) }
        };
        let (value, by_d) = (sum(0), if slope { sum(1) } else { 0.0 });
        let sizes = [size(2, value), if slope { size(3, by_d) } else { 0.0 }];
        Moments { value, slope: by_d, sizes, ln_scale, error: self.error }
    }
}
