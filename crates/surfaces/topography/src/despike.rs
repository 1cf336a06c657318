//! The search for outliers: a few points far above or below all their surroundings, as dust and
//! lost signals leave in a scan. They are a small share of the points, and may be most of m₄ and
//! the kurtosis.

use crate::{Level, Outliers, Topography, TopographyError};

/// Side of the window around a point of an areal scan, and length of that of a profile.
const WINDOW: [usize; 2] = [5, 17];
/// Rank of the neighbours with which a point is compared, from the highest and from the lowest:
/// outliers of one pixel less hide nothing, and an edge, a corner or a line of a stepped surface
/// has as many equal neighbours.
const RANK: [usize; 2] = [4, 3];
/// The fewest neighbours that are compared.
const FEWEST: usize = 12;
/// An outlier is this many times as far outside its neighbours as these are apart: a peak of
/// three pixels has 0.5.
const LOCAL: f64 = 2.0;
/// ... and this many times as far as all but 1 % of the points: 6 standard deviations of white
/// noise, 12 means of exponential noise.
const GLOBAL: f64 = 4.0;
/// The share of the points that may be further outside than the body of the surface.
const TAIL: f64 = 0.01;
/// Outliers at a larger share are themselves that body: where it is this many times as far as the
/// median distance of points from the mean of two neighbours, that distance decides.
const USUAL: f64 = 20.0;
/// Distances below this share of the largest height are rounding.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl Topography {
    /// The outliers of the surface: points that lie outside their neighbours (5 x 5, in a profile
    /// 17) by twice the range of these, and by four times what 99 % of all points do; where more
    /// than 1 % are outliers, by twenty times the median distance of points from the mean of two
    /// neighbours. Up to four adjacent points (in a profile three) are found; larger ones are
    /// features. The least-squares plane is ignored. None are found where a point has fewer than 12
    /// measured neighbours.
    ///
    /// Those of a [filtered](Self::filter) or [smoothed](Self::smooth) surface are those found
    /// before, because a filter spreads them.
    #[must_use]
    pub fn outliers(&self) -> Outliers {
        let found = self.outliers.as_deref().cloned().unwrap_or_else(|| self.find_outliers());
        if found.count == 0 {
            return found;
        }
        let rest = self.clone().without_points(&found.points);
        let m4 = |surface: &Self| surface.moments().map_or(0.0, |moments| moments.profile.m4);
        let fourth = |surface: &Self| surface.central_moment(surface.mean(), 4);
        let share = |all: f64, rest: f64| {
            if all > 0.0 && rest.is_finite() { (1.0 - rest / all).max(0.0) } else { 0.0 }
        };
        let m4_share = share(m4(self), m4(&rest));
        Outliers { m4_share, kurtosis_share: share(fourth(self), fourth(&rest)), ..found }
    }

    /// The surface with its [outliers](Self::outliers) replaced as missing points are
    /// [filled](Self::fill), by harmonic heights; missing points stay missing.
    /// [`Statistics`](crate::Statistics) count them.
    ///
    /// # Errors
    /// The errors of [`fill`](Self::fill), for the outliers alone;
    /// [`TopographyError::Filtered`] for a filtered surface, in which outliers are spread.
    pub fn despiked(mut self) -> Result<Self, TopographyError> {
        if self.outliers.is_some() {
            return Err(TopographyError::Filtered);
        }
        let points = self.find_outliers().points;
        self.replace(&points, self.measured())?;
        self.despiked += points.len();
        Ok(self)
    }

    /// Their number, places and largest; without shares.
    pub(crate) fn find_outliers(&self) -> Outliers {
        let [rows, columns] = [self.rows(), self.columns()];
        let form = self.form(Level::Plane).or_else(|_| self.form(Level::Mean));
        let flat = form.map_or_else(|_| self.clone(), |form| self.clone().without(&form));
        let profile = usize::from(self.is_profile());
        let (side, rank) = (WINDOW[profile], RANK[profile]);
        let height = if self.is_profile() { 1 } else { side.min(rows) };
        let width = side.min(columns);
        let mut candidates: Vec<Candidate> = vec![];
        let mut window = Vec::with_capacity(height * width);
        for at in (0..rows * columns).filter(|at| !flat.heights()[*at].is_nan()) {
            let (x, y) = (at % columns, at / columns);
            // At an edge, the window lies inside.
            let left = x.saturating_sub(width / 2).min(columns - width);
            let top = y.saturating_sub(height / 2).min(rows - height);
            let lines = (top..top + height).map(|y| y * columns + left);
            let lines = lines.map(|start| &flat.heights()[start..start + width]);
            candidates.extend(Candidate::new(at, flat.heights()[at], lines, rank, &mut window));
        }
        let tail = (TAIL * self.measured() as f64) as usize;
        let mut body = 0.0;
        if candidates.len() > tail {
            let by_distance = |a: &Candidate, b: &Candidate| b.outside().total_cmp(&a.outside());
            body = candidates.select_nth_unstable_by(tail, by_distance).1.outside();
        }
        let rounding = ROUNDING * flat.largest();
        let usual = USUAL * usual_distance(&flat, rounding);
        let floor = if body > usual { usual } else { GLOBAL * body }.max(rounding);
        candidates.retain(|one| one.outside() > floor && one.outside() > LOCAL * one.range);
        candidates.sort_by_key(|one| one.at);
        let furthest = candidates.iter().max_by(|a, b| a.outside().total_cmp(&b.outside()));
        Outliers {
            count: candidates.len(),
            largest: furthest.map_or(0.0, |one| one.distance),
            points: candidates.iter().map(|one| one.at).collect(),
            ..Outliers::default()
        }
    }
}

/// The median distance of points from the mean of the points before and after them, along rows or
/// columns, whichever is larger; at least the step of heights, which is above `rounding`.
fn usual_distance(surface: &Topography, rounding: f64) -> f64 {
    let (heights, columns) = (surface.heights(), surface.columns());
    let (mut usual, mut step) = (0.0, f64::INFINITY);
    for stride in [1, columns] {
        let inside = |at: &usize| stride > 1 || (at + 1) % columns > 1;
        let places = (stride..heights.len().saturating_sub(stride)).filter(inside);
        let off =
            |at: usize| (heights[at] - 0.5 * (heights[at - stride] + heights[at + stride])).abs();
        let mut distances: Vec<f64> =
            places.map(off).filter(|distance| !distance.is_nan()).collect();
        step =
            distances.iter().copied().filter(|distance| *distance > rounding).fold(step, f64::min);
        let middle = distances.len() / 2;
        if !distances.is_empty() {
            usual = f64::max(usual, *distances.select_nth_unstable_by(middle, f64::total_cmp).1);
        }
    }
    if usual > rounding || step.is_infinite() { usual } else { step }
}

/// A point outside its neighbours.
struct Candidate {
    at: usize,
    /// Above the highest of its neighbours but a few, or, if negative, below the lowest \[m\].
    distance: f64,
    /// The range of its neighbours without a few highest and lowest \[m\].
    range: f64,
}

impl Candidate {
    /// The point of height z in its window of lines, if it is among the highest or the lowest.
    fn new<'a>(
        at: usize,
        z: f64,
        lines: impl Iterator<Item = &'a [f64]> + Clone,
        rank: usize,
        window: &mut Vec<f64>,
    ) -> Option<Self> {
        let points = lines.flatten().filter(|height| !height.is_nan());
        let (mut count, mut above, mut below) = (0, 0, 0);
        for height in points.clone() {
            count += 1;
            above += usize::from(*height > z);
            below += usize::from(*height < z);
        }
        // The window counts the point itself.
        if count <= FEWEST || above.min(below) >= rank {
            return None;
        }
        window.clear();
        window.extend(points);
        window.sort_by(f64::total_cmp);
        // Without the point itself, which is among the first or the last ones.
        let own = window.iter().position(|height| *height >= z)?;
        window.remove(own);
        let (low, high) = (window[rank - 1], window[window.len() - rank]);
        let distance = if z > high { z - high } else { z - low };
        (z > high || z < low).then_some(Self { at, distance, range: high - low })
    }

    fn outside(&self) -> f64 {
        self.distance.abs()
    }
}
