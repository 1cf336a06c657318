//! The pressure at a mean gap: a cubic between points of a fixed grid, then Newton's method. Points
//! are computed where gaps are asked for, and kept: the answer does not depend on what was asked
//! before.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Points of the grid in a unit of y = ln b + b²: ln u falls like ln(-y) or like -y.
const IN_A_UNIT: f64 = 16.0;
/// A step of Newton's method after which x is exact to rounding, as the slope of the cubic has a
/// relative error below 10⁻⁶.
const SHORT: f64 = 1e-7;
const STEPS: usize = 50;

/// Where ln u has a value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Found {
    /// x = ln b, and d(ln u)/dx there.
    At(f64, f64),
    /// u is smaller at the lower end of x already.
    Below,
    /// u is larger at the upper end.
    Above,
}

/// A point of ln u(x), which falls.
#[derive(Debug, Clone, Copy)]
struct Point {
    /// In the grid.
    place: i32,
    x: f64,
    ln_u: f64,
    /// d(ln u)/dx, where it was needed.
    slope: Option<f64>,
}

/// The points of a function that are known.
#[derive(Debug, Default)]
pub(crate) struct Inverse {
    /// In the order of their places.
    points: Mutex<Vec<Point>>,
}

/// A function to be inverted between two ends of x = ln b.
pub(crate) trait Falling {
    type Error;
    fn ends(&self) -> [f64; 2];
    fn ln_u(&self, x: f64) -> Result<f64, Self::Error>;
    /// d(ln u)/dx at an x, where ln u is known.
    fn slope(&self, x: f64, ln_u: f64) -> Result<f64, Self::Error>;
}

impl Inverse {
    /// The x of a ln u.
    pub(crate) fn find<F: Falling>(&self, of: &F, ln_u: f64) -> Result<Found, F::Error> {
        let [mut low, mut high] = of.ends().map(|x| (IN_A_UNIT * y_of(x)).round() as i32);
        if self.point(of, low)?.ln_u < ln_u {
            return Ok(Found::Below);
        }
        if self.point(of, high)?.ln_u > ln_u {
            return Ok(Found::Above);
        }
        // Halving, between points that are known.
        for point in self.points().iter() {
            if point.ln_u < ln_u {
                high = point.place;
                break;
            }
            low = point.place;
        }
        while high - low > 1 {
            let middle = low + (high - low) / 2;
            *if self.point(of, middle)?.ln_u >= ln_u { &mut low } else { &mut high } = middle;
        }
        let [low, high] = [self.with_slope(of, low)?, self.with_slope(of, high)?];
        let (mut x, slope) = between(low, high, ln_u);
        for _ in 0..STEPS {
            let step = (ln_u - of.ln_u(x)?) / slope;
            x = (x + step).clamp(low.0.x, high.0.x);
            if step.abs() <= SHORT {
                break;
            }
        }
        Ok(Found::At(x, slope))
    }

    fn points(&self) -> MutexGuard<'_, Vec<Point>> {
        self.points.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Keeps a point in its place.
    fn keep(&self, point: Point) {
        let mut points = self.points();
        match points.binary_search_by_key(&point.place, |known| known.place) {
            Ok(known) => points[known] = point,
            Err(new) => points.insert(new, point),
        }
    }

    fn point<F: Falling>(&self, of: &F, place: i32) -> Result<Point, F::Error> {
        if let Some(point) = self.points().iter().find(|point| point.place == place) {
            return Ok(*point);
        }
        let x = x_of(f64::from(place) / IN_A_UNIT);
        let point = Point { place, x, ln_u: of.ln_u(x)?, slope: None };
        self.keep(point);
        Ok(point)
    }

    fn with_slope<F: Falling>(&self, of: &F, place: i32) -> Result<(Point, f64), F::Error> {
        let point = self.point(of, place)?;
        if let Some(slope) = point.slope {
            return Ok((point, slope));
        }
        let slope = of.slope(point.x, point.ln_u)?;
        self.keep(Point { slope: Some(slope), ..point });
        Ok((point, slope))
    }
}

/// y = ln b + b² at x = ln b.
fn y_of(x: f64) -> f64 {
    x + (2.0 * x).exp()
}

/// x = ln b at a y, by Newton's method from above the root.
fn x_of(y: f64) -> f64 {
    let mut x = if y > 1.0 { 0.5 * y.ln() } else { y };
    for _ in 0..STEPS {
        let square = (2.0 * x).exp();
        let step = (x + square - y) / (1.0 + 2.0 * square);
        x -= step;
        if step.abs() <= 1e-15 * x.abs() {
            break;
        }
    }
    x
}

/// x and d(ln u)/dx at a ln u between two points, by the cubic x(ln u) with their slopes.
fn between(a: (Point, f64), b: (Point, f64), ln_u: f64) -> (f64, f64) {
    let (width, rise) = (b.0.ln_u - a.0.ln_u, b.0.x - a.0.x);
    let t = (ln_u - a.0.ln_u) / width;
    let [from, to] = [width / a.1, width / b.1];
    let (square, cube) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
    let x = a.0.x + t * (from + t * (square + t * cube));
    (x, width / (from + t * (2.0 * square + t * 3.0 * cube)))
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use asperity_core::ProfileMoments;

    use super::*;
    use crate::Spectrum;
    use crate::gap::{self, Gap, LN_PRESSURES};

    /// Counts the integrals.
    struct Counting<'a>(Gap<'a>, Cell<usize>);

    impl Falling for Counting<'_> {
        type Error = <Gap<'static> as Falling>::Error;

        fn ends(&self) -> [f64; 2] {
            LN_PRESSURES
        }

        fn ln_u(&self, x: f64) -> Result<f64, Self::Error> {
            self.1.set(self.1.get() + 1);
            self.0.ln_u(x)
        }

        fn slope(&self, x: f64, ln_u: f64) -> Result<f64, Self::Error> {
            self.1.set(self.1.get() + 1);
            self.0.slope(x, ln_u)
        }
    }

    /// The gap at a pressure is one integral.
    #[test]
    fn the_pressure_at_a_gap_takes_at_most_three_integrals() {
        for (alpha, hurst, gamma) in [(8.0, 0.8, 1.0), (1.6, 0.8, 4.0 / 9.0), (1e6, 0.1, 1.0)] {
            let moments = ProfileMoments { m0: 1.0, m2: 1.0, m4: alpha };
            let spectrum = Spectrum::power_law(&moments, hurst).unwrap();
            for (rows, most) in [(1, 30), (401, 3 * 401)] {
                let of = Counting(Gap { spectrum: &spectrum, gamma }, Cell::default());
                let inverse = Inverse::default();
                for k in 0..rows {
                    let u = 0.01 + 4.0 * f64::from(k) / f64::from(rows);
                    let Found::At(x, _) = inverse.find(&of, u.ln()).unwrap() else { panic!("{u}") };
                    let back = of.0.mean_gap(x.exp()).unwrap();
                    assert!((back / u - 1.0).abs() < 0.1 * gap::ERROR, "{u} {back}");
                }
                assert!(of.1.get() <= most, "{} for {rows}", of.1.get());
            }
        }
    }

    #[test]
    fn what_was_asked_before_does_not_change_an_answer() {
        let spectrum = Spectrum::of_waves([(1.0, 1.0), (3.0, 0.2), (40.0, 0.01)]).unwrap();
        let of = Gap { spectrum: &spectrum, gamma: 1.0 };
        let one = Inverse::default();
        for u in [1e-200, 1e-3, 0.9, 0.901, 5.0, 30.0_f64] {
            let [first, again] =
                [&Inverse::default(), &one].map(|inverse| inverse.find(&of, u.ln()).unwrap());
            let Found::At(x, slope) = first else { panic!("{u}") };
            assert_eq!(first, again);
            let gap = of.ln_u(x).unwrap();
            assert!((gap - u.ln()).abs() < 0.1 * gap::ERROR, "{u}");
            assert!((slope / of.slope(x, gap).unwrap() - 1.0).abs() < 1e-5, "{u}");
        }
        assert_eq!(one.find(&of, 10.0).unwrap(), Found::Below);
        assert_eq!(one.find(&of, -1e4).unwrap(), Found::Above);
    }
}
