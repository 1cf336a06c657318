//! Filling of a few missing points from their neighbours.

use crate::error::refuse;
use crate::{Level, Topography, TopographyError};

/// Residual of the equations, relative to its initial value.
const TOLERANCE: f64 = 1e-10;

impl Topography {
    /// The largest share of the points that is [filled](Self::fill): above it, interpolation would
    /// dominate the statistics.
    pub const MOST_FILLED: f64 = 0.05;

    /// The surface with heights where points are missing: harmonic ones, each the mean of its four
    /// neighbours (weighted by 1/dx² and 1/dy²), without summits of their own. Beyond an edge the
    /// surface continues as its least-squares plane, or periodically if it is periodic. A gap in a
    /// profile is filled by a straight line.
    ///
    /// # Errors
    /// [`TopographyError::Content`] above [`MOST_FILLED`](Self::MOST_FILLED), and if the residual
    /// does not fall to 1e-10.
    pub fn fill(mut self) -> Result<Self, TopographyError> {
        let places: Vec<usize> =
            (0..self.heights.len()).filter(|at| self.heights[*at].is_nan()).collect();
        self.replace(&places, self.heights.len())?;
        self.filled += std::mem::take(&mut self.missing);
        Ok(self)
    }

    /// Harmonic heights at these points, at most a small share of `all`.
    pub(crate) fn replace(&mut self, places: &[usize], all: usize) -> Result<(), TopographyError> {
        let (share, limit) = (places.len() as f64 / all as f64, Self::MOST_FILLED);
        if share > limit {
            let required = format!("at most {limit} to fill them, as in a cropped scan");
            return Err(refuse("missing points", format_args!("a share of {share:.4}"), required));
        }
        let heights = self.harmonic(places)?;
        places.iter().zip(heights).for_each(|(at, height)| self.heights[*at] = height);
        Ok(())
    }

    /// Harmonic heights \[m\] at these points, ascending; other points without a height count as
    /// beyond an edge.
    fn harmonic(&self, places: &[usize]) -> Result<Vec<f64>, TopographyError> {
        if places.is_empty() {
            return Ok(vec![]);
        }
        // The heights there must not tilt the plane.
        let open = self.clone().without_points(places);
        // Without the tilt, so that the filled heights are level at an edge.
        let form = open.form(Level::usual(self.is_periodic()));
        let form = form.or_else(|_| open.form(Level::Mean))?;
        let flat = open.without(&form);
        let points: Vec<Point> = places.iter().map(|at| Point::new(&flat, places, *at)).collect();
        let found = solve(&points, points.iter().map(|point| point.measured).collect())?;
        let columns = self.columns();
        let height = |(at, rest): (&usize, f64)| rest + form.along_row(at / columns)(at % columns);
        Ok(places.iter().zip(found).map(height).collect())
    }
}

/// A missing point: the sum of the weights of its neighbours, the weighted sum of the measured
/// ones, and the missing ones by their number.
struct Point {
    weight: f64,
    measured: f64,
    missing: [Option<(usize, f64)>; 4],
}

impl Point {
    fn new(surface: &Topography, places: &[usize], at: usize) -> Self {
        let [wx, wy] = surface.pixel_size().map(|step| (step / surface.pixel_size()[0]).powi(-2));
        let steps = [(0, -1, wx), (0, 1, wx), (-1, 0, wy), (1, 0, wy)];
        let beside = |(down, along, weight)| Some((surface.beside(at, down, along)?, weight));
        let mut point = Self { weight: 0.0, measured: 0.0, missing: [None; 4] };
        for (k, (beside, weight)) in steps.into_iter().filter_map(beside).enumerate() {
            let height = surface.heights()[beside];
            match places.binary_search(&beside) {
                Ok(number) => point.missing[k] = Some((number, weight)),
                Err(_) if height.is_nan() => continue,
                Err(_) => point.measured += weight * height,
            }
            point.weight += weight;
        }
        point
    }

    /// The left side of the equation of the point at these heights; `own` is its own height.
    fn apply(&self, own: f64, heights: &[f64]) -> f64 {
        let beside = self.missing.iter().flatten().map(|(number, w)| w * heights[*number]);
        self.weight * own - beside.sum::<f64>()
    }
}

/// Conjugate gradients from 0: the equations are symmetric, and positive definite because every
/// hole has a rim.
fn solve(points: &[Point], right: Vec<f64>) -> Result<Vec<f64>, TopographyError> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (mut found, mut way) = (vec![0.0; right.len()], right.clone());
    let (mut rest, mut square) = (right.clone(), dot(&right, &right));
    let enough = TOLERANCE * TOLERANCE * square;
    // Exact arithmetic needs as many steps as there are points, and far fewer are usual.
    for _ in 0..10 * points.len() + 10 {
        if square <= enough {
            return Ok(found);
        }
        let applied: Vec<f64> =
            points.iter().zip(&way).map(|(p, own)| p.apply(*own, &way)).collect();
        let length = square / dot(&way, &applied);
        for ((found, rest), (way, applied)) in
            found.iter_mut().zip(&mut rest).zip(way.iter().zip(&applied))
        {
            *found += length * way;
            *rest -= length * applied;
        }
        let last = std::mem::replace(&mut square, dot(&rest, &rest));
        for (way, rest) in way.iter_mut().zip(&rest) {
            *way = rest + square / last * *way;
        }
    }
    let required = "heights of similar size around them, to fill them";
    Err(refuse("missing points", format_args!("{} in holes", points.len()), required))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [40, 30];

    /// A map of heights by column and row, without those in some holes.
    fn holed(height: impl Fn(f64, f64) -> f64, pixel: [f64; 2], edges: bool) -> Topography {
        let [columns, rows] = SIZE;
        let missing = |x: usize, y: usize| {
            let inside = (12..18).contains(&x) && (10..15).contains(&y) || (x, y) == (30, 20);
            inside || edges && ((x, y) == (0, 0) || x == 39 && y > 26)
        };
        let at = |k: usize| match (k % columns, k / columns) {
            (x, y) if missing(x, y) => f64::NAN,
            (x, y) => height(x as f64 * pixel[0], y as f64 * pixel[1]),
        };
        Topography::new((0..columns * rows).map(at).collect(), columns, pixel).unwrap()
    }

    #[test]
    fn harmonic_heights_are_recovered() {
        // For x² - y² on rectangular pixels, xy and a plane, differences are exact.
        for height in [|x: f64, y: f64| x * x - y * y, |x, y| 3.0 * x * y + 5.0 * x - y + 7.0] {
            let pixel = [1e-6, 1.5e-6];
            let filled = holed(height, pixel, false).fill().unwrap();
            for (k, found) in filled.heights().iter().enumerate() {
                let exact = height((k % 40) as f64 * pixel[0], (k / 40) as f64 * pixel[1]);
                assert!(
                    (found - exact).abs() < 1e-9 * exact.abs().max(1e-9),
                    "{k} {found} {exact}"
                );
            }
            assert!((filled.filled_share() - 31.0 / 1200.0).abs() < 1e-15);
            assert_eq!((filled.missing_share(), filled.measured()), (0.0, 1200));
        }
    }

    #[test]
    fn a_hole_at_the_edge_of_a_tilted_plane_is_filled_by_the_plane() {
        let height = |x: f64, y: f64| 3e-2 * x - 5e-2 * y + 1e-6;
        let pixel = [1e-6, 1.5e-6];
        let filled = holed(height, pixel, true).fill().unwrap();
        for (k, found) in filled.heights().iter().enumerate() {
            let exact = height((k % 40) as f64 * pixel[0], (k / 40) as f64 * pixel[1]);
            assert!((found - exact).abs() < 1e-18, "{k} {found} {exact}");
        }
        // The order of levelling and filling matters only through the filled points in the plane
        // fit.
        let wavy = |x: f64, y: f64| height(x, y) + 1e-7 * (3e5 * x + 4e5 * y).sin();
        let level = |surface: Topography| surface.level(Level::Plane).unwrap();
        let before = level(holed(wavy, pixel, true)).fill().unwrap();
        let after = level(holed(wavy, pixel, true).fill().unwrap());
        for (a, b) in before.heights().iter().zip(after.heights()) {
            assert!((a - b).abs() < 2e-9, "{a} {b}");
        }
    }

    #[test]
    fn every_filled_point_is_the_mean_of_its_neighbours_also_across_periodic_edges() {
        let height = |x: f64, y: f64| (0.7 * x + 0.2 * y * y).sin();
        for periodic in [false, true] {
            let holed = holed(height, [1.0; 2], true).with_periodic(periodic);
            // Heights above the plane, or the mean.
            let holed = holed.levelled(None).unwrap();
            let filled = holed.clone().fill().unwrap();
            let z = |x: i32, y: i32| match periodic {
                true => Some(filled.heights()[(y.rem_euclid(30) * 40 + x.rem_euclid(40)) as usize]),
                false => ((0..40).contains(&x) && (0..30).contains(&y))
                    .then(|| filled.heights()[(y * 40 + x) as usize]),
            };
            for (k, before) in holed.heights().iter().enumerate() {
                let (x, y) = ((k % 40) as i32, (k / 40) as i32);
                if !before.is_nan() {
                    assert_eq!(z(x, y), Some(*before));
                    continue;
                }
                let beside: Vec<f64> = [(x - 1, y), (x + 1, y), (x, y - 1), (x, y + 1)]
                    .into_iter()
                    .filter_map(|(x, y)| z(x, y))
                    .collect();
                let mean = beside.iter().sum::<f64>() / beside.len() as f64;
                assert!((z(x, y).unwrap() - mean).abs() < 1e-8, "{x} {y} {mean}");
            }
        }
    }

    #[test]
    fn a_gap_in_a_profile_is_a_line_and_too_many_missing_points_are_refused() {
        let heights = |gap: std::ops::Range<usize>| {
            let at = |k: usize| if gap.contains(&k) { f64::NAN } else { (k * k) as f64 };
            Topography::new((0..100).map(at).collect(), 100, [1.0; 2]).unwrap()
        };
        let filled = heights(10..14).fill().unwrap();
        // From 81 to 196 in five steps.
        assert!(
            (10..14).all(|k| (filled.heights()[k] - (81.0 + 23.0 * (k - 9) as f64)).abs() < 1e-6)
        );
        let whole = heights(0..0);
        assert_eq!(whole.clone().fill().unwrap(), whole);
        let refused = heights(10..16).fill().unwrap_err().to_string();
        assert!(refused.starts_with("missing points: a share of 0.06"), "{refused}");
    }

    #[test]
    fn filled_points_have_a_warning() {
        let height = |x: f64, y: f64| (0.7 * x + 0.2 * y).sin() + (0.3 * x - 0.8 * y).cos();
        let statistics = |surface: Topography| surface.statistics(crate::Estimator::Moments);
        let holed = holed(height, [1.0; 2], false);
        let [open, filled] = [holed.clone(), holed.fill().unwrap()].map(|s| statistics(s).unwrap());
        assert!((open.missing_share - filled.missing_share).abs() < 1e-15);
        assert!((filled.moments.profile.m2 / open.moments.profile.m2 - 1.0).abs() < 0.03);
        let has_warning = |statistics: &crate::Statistics| {
            statistics.warnings.iter().any(|w| w.to_string().contains("filled"))
        };
        assert!(has_warning(&filled) && !has_warning(&open), "{:?}", filled.warnings);
    }
}
