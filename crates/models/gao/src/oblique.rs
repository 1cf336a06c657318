//! An oblique contact, and the average over contact angles as a function of the approach x.

use std::ops::Range;
use std::sync::Arc;

use asperity_quadrature::{Estimate, Point, TanhSinh, bracketed_root, highest, last_place};

/// An oblique contact, already averaged over the azimuth θ.
///
/// A pair approached vertically by x has the contact-normal interference y = x u.
pub trait ObliqueContact: Send + Sync {
    /// Writes to `out` the averages over θ at contact-normal interference `y`, for pairs approached
    /// by x = y + gap, to a relative tolerance. Returns the largest relative error.
    fn means(&self, y: f64, gaps: &[f64], tolerance: f64, out: &mut [f64]) -> f64;

    /// The gaps at which the average has branch points as a function of x, for this y; infinite
    /// for those that do not exist.
    fn corners(&self, y: f64) -> [f64; 3];

    /// The gap up to which the average changes from one power of the gap to another, where it can
    /// be much smaller than y; infinite otherwise.
    fn layer(&self, _y: f64) -> f64 {
        f64::INFINITY
    }

    /// A text that identifies this contact, if there is one: a law that recurs in a sweep is then
    /// tabulated once.
    fn key(&self) -> Option<String> {
        None
    }
}

/// The angle average q(x) = (1/x) ∫ (c₀ + c₂ y²/x²) m(y, x) dy over y in `range`, y ≤ x.
#[derive(Clone)]
pub(crate) struct AngleAverage {
    pub(crate) contact: Arc<dyn ObliqueContact>,
    pub(crate) range: Range<f64>,
    /// c₀ and c₂.
    pub(crate) density: (f64, f64),
    branches: Vec<Branch>,
    /// The y at which a corner appears from infinity or disappears to it: next to these y the
    /// integral over x has an essential singularity.
    pub(crate) singular: Vec<f64>,
    /// Relative.
    pub(crate) tolerance: f64,
}

/// A range of y on which a corner rises or falls: each x is crossed at most once.
#[derive(Debug, Clone, Copy)]
struct Branch {
    corner: usize,
    y: (f64, f64),
    /// 1/x of the corner at the ends.
    inverse: (f64, f64),
}

/// Tolerance of the azimuth average over the tolerance of the angle average.
const AZIMUTHS: f64 = 0.05;

impl AngleAverage {
    /// The same average to a smaller relative tolerance.
    pub(crate) fn within(&self, tolerance: f64) -> Self {
        Self { tolerance: tolerance.min(self.tolerance), ..self.clone() }
    }

    pub(crate) fn new(
        contact: Arc<dyn ObliqueContact>,
        range: Range<f64>,
        density: (f64, f64),
        tolerance: f64,
    ) -> Self {
        let (branches, singular) = branches(&*contact, &range);
        Self { contact, range, density, branches, singular, tolerance }
    }

    /// The relative tolerance of the azimuth averages m.
    pub(crate) fn azimuth_tolerance(&self) -> f64 {
        AZIMUTHS * self.tolerance
    }

    /// The y at which a corner passes x: branch points of the integrand.
    fn breaks(&self, x: f64) -> impl Iterator<Item = f64> {
        let crossing = move |branch: &Branch| {
            let off = |y: f64| x * inverses(&*self.contact, y)[branch.corner] - 1.0;
            let (from, to) = (x * branch.inverse.0 - 1.0, x * branch.inverse.1 - 1.0);
            (from * to < 0.0).then(|| bracketed_root(off, branch.y.0, branch.y.1)).flatten()
        };
        self.branches.iter().filter_map(crossing)
    }

    /// The kinks of q: the ends of the range, and the x at which a corner appears or disappears.
    pub(crate) fn kinks(&self) -> Vec<f64> {
        let Range { start, end } = self.range;
        let inside = |y: f64| y > FIRST && y < LAST;
        let ends = self.branches.iter().flat_map(|b| [(b.y.0, b.inverse.0), (b.y.1, b.inverse.1)]);
        let kinks = ends.filter(|(y, _)| inside(*y)).map(|(_, inverse)| inverse.recip());
        kinks.chain([start, end]).filter(|x| x.is_finite() && *x > 0.0).collect()
    }

    pub(crate) fn value(&self, x: f64) -> Estimate {
        let end = self.range.end.min(x);
        if end <= self.range.start {
            return Estimate { value: 0.0, error: 0.0, evaluations: 0 };
        }
        let mut ends: Vec<f64> = self.breaks(x).collect();
        ends.retain(|y| *y > self.range.start && *y < end);
        ends.extend([self.range.start, end]);
        ends.sort_by(f64::total_cmp);
        let (c0, c2) = self.density;
        // From the right, where responses are largest: the rest is accurate relative to them.
        let (mut total, mut error, mut evaluations, mut worst) = (0.0f64, 0.0, 0, 0.0f64);
        for pair in ends.windows(2).rev().filter(|pair| pair[1] > pair[0]) {
            let integrand = |p: Point| {
                let mut mean = [0.0];
                let gap = (x - pair[1]) + p.right;
                let tolerance = self.azimuth_tolerance();
                worst = worst.max(self.contact.means(p.x, &[gap], tolerance, &mut mean));
                (c0 + c2 * (p.x / x).powi(2)) * mean[0]
            };
            let goal = 0.2 * self.tolerance;
            let rules = TanhSinh::shared();
            let found = rules.integrate(pair[0], pair[1], goal, total.abs(), integrand);
            total += found.value;
            error += found.error;
            evaluations += found.evaluations;
        }
        Estimate { value: total / x, error: (error + worst * total.abs()) / x, evaluations }
    }
}

/// 1/x of the corners at a y; 0 for those that do not exist.
fn inverses(contact: &dyn ObliqueContact, y: f64) -> [f64; 3] {
    contact.corners(y).map(|gap| (y + gap).recip())
}

/// Points of y at which corners are examined to find their branches, evenly spaced in the logarithm
/// of the distance from the start of a range.
const SCAN: i32 = 48;
/// First and last y of the scan where the range starts at 0 or has no end.
const FIRST: f64 = 1e-80;
const LAST: f64 = 1e40;

/// The branches of all corners, and the singular y.
fn branches(contact: &dyn ObliqueContact, range: &Range<f64>) -> (Vec<Branch>, Vec<f64>) {
    let nearest = if range.start > 0.0 { 1e-15 * range.start } else { FIRST };
    let farthest = (range.end - range.start).min(LAST);
    let step = (farthest / nearest).ln() / f64::from(SCAN);
    let y = |k: f64| match k {
        k if k <= 0.0 && range.start > 0.0 => range.start,
        k if k >= f64::from(SCAN) => range.end.min(LAST),
        k => range.start + nearest * (k * step).exp(),
    };
    let scan: Vec<[f64; 3]> = (0..=SCAN).map(|k| inverses(contact, y(f64::from(k)))).collect();
    let (mut branches, mut singular) = (vec![], vec![]);
    for corner in (0..3).filter(|corner| scan.iter().any(|at| at[*corner] > 0.0)) {
        let at = |k: f64| inverses(contact, y(k))[corner];
        // Ends of branches, as places on the scan.
        let mut ends = vec![0.0];
        for (k, three) in scan.windows(3).enumerate() {
            let [before, middle, after] = [three[0], three[1], three[2]].map(|at| at[corner]);
            if (middle - before) * (after - middle) < 0.0 {
                let sign = (middle - before).signum();
                ends.push(highest(|k| sign * at(k), k as f64, k as f64 + 2.0));
            }
        }
        for (k, two) in scan.windows(2).enumerate() {
            let exists = two[0][corner] > 0.0;
            if exists != (two[1][corner] > 0.0) {
                singular.push(y(last_place(|k| (at(k) > 0.0) == exists, k as f64, k as f64 + 1.0)));
            }
        }
        ends.push(f64::from(SCAN));
        for pair in ends.windows(2) {
            let [from, to] = [pair[0], pair[1]];
            branches.push(Branch { corner, y: (y(from), y(to)), inverse: (at(from), at(to)) });
        }
    }
    (branches, singular)
}
