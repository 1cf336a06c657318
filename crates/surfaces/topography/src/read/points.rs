//! Points in any order on a regular grid.

use asperity_core::written;

use super::scan;
use crate::TopographyError;
use crate::error::refuse;

/// Tolerance of a position, relative to the grid distance: files print positions with few digits.
pub(super) const SLACK: f64 = 0.1;

/// Heights, columns and pixel size of x, y, z, x, y, z...: points of a regular grid, in any order;
/// NaN for grid points without a point.
pub(super) fn grid(values: Vec<f64>) -> Result<(Vec<f64>, usize, [f64; 2]), TopographyError> {
    let across = Axis::new(&values, 0, "x")?;
    let along = Axis::new(&values, 1, "y")?;
    let n = scan::points(across.n, along.n)?;
    let given = values.len() / 3;
    // A grid far larger than the number of points is an error and would take much memory.
    if n / 1000 > given {
        let found = format!("{given} points on a grid of {} x {}", across.n, along.n);
        let required = "points at a thousandth of the grid points or more";
        return Err(refuse("x and y", found, required));
    }
    let mut heights = vec![f64::NAN; n];
    let mut taken = vec![false; n];
    let columns = across.n as usize;
    for point in values.chunks_exact(3) {
        let index = across.index(point[0])? + columns * along.index(point[1])?;
        if taken[index] {
            let found = format!("a second point at {}, {}", written(point[0]), written(point[1]));
            return Err(refuse("x and y", found, "one point per grid point"));
        }
        taken[index] = true;
        heights[index] = point[2];
    }
    Ok((heights, columns, [across.step, along.step]))
}

/// The grid points along one coordinate.
struct Axis {
    field: &'static str,
    first: f64,
    step: f64,
    n: u64,
}

impl Axis {
    fn new(values: &[f64], offset: usize, field: &'static str) -> Result<Self, TopographyError> {
        let mut places: Vec<f64> = values.iter().skip(offset).step_by(3).copied().collect();
        let wrong = |found: &str| refuse(field, found, "at least two positions of a regular grid");
        if places.iter().any(|place| place.is_nan()) {
            return Err(wrong("a point without a position"));
        }
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        let (first, last) = match places[..] {
            [first, .., last] if (last - first).is_finite() => (first, last),
            _ => return Err(wrong(&format!("{} positions", places.len()))),
        };
        let n = places.len() as u64;
        let whole = Self { field, first, step: (last - first) / (n - 1) as f64, n };
        let in_order =
            |(i, place): (usize, &f64)| whole.index(*place).is_ok_and(|index| index == i);
        if places.iter().enumerate().all(in_order) {
            return Ok(whole);
        }
        // Some rows or columns have no points: the median distance gives the grid.
        let mut steps: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let middle = (steps.len() - 1) / 2;
        let usual = *steps.select_nth_unstable_by(middle, f64::total_cmp).1;
        let intervals = ((last - first) / usual).round();
        // Compared as floats: the quotient may overflow an integer.
        if !(intervals >= 1.0 && intervals < crate::MAX_POINTS as f64) {
            let found = format!("positions from {first:?} to {last:?}, mostly {usual:?} apart");
            return Err(wrong(&found));
        }
        let axis = Self { field, first, step: (last - first) / intervals, n: intervals as u64 + 1 };
        places.iter().try_for_each(|place| axis.index(*place).map(|_| ()))?;
        Ok(axis)
    }

    /// The index of the grid point at a position.
    fn index(&self, place: f64) -> Result<usize, TopographyError> {
        let at = (place - self.first) / self.step;
        let nearest = at.round();
        if (at - nearest).abs() <= SLACK && nearest >= 0.0 && nearest < self.n as f64 {
            return Ok(nearest as usize);
        }
        let found = format!(
            "a point at {}, {} steps of {} from the first",
            written(place),
            written(at),
            written(self.step)
        );
        Err(refuse(self.field, found, "points of a regular grid"))
    }
}

/// The largest distance of numbers from a line through the first and the last, in steps of the
/// line.
pub(super) fn deviation(values: &[f64]) -> f64 {
    let (Some(first), Some(last)) = (values.first(), values.last()) else { return f64::INFINITY };
    let step = (last - first) / (values.len() - 1) as f64;
    let off = |(k, value): (usize, &f64)| ((value - first) / step - k as f64).abs();
    // NaN is the largest of all.
    values.iter().enumerate().map(off).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

/// The step of positions, rising or falling: at least two numbers at equal distances.
pub(super) fn step(values: &[f64]) -> Option<f64> {
    let step = (values.last()? - values.first()?) / (values.len().max(2) - 1) as f64;
    (deviation(values) < SLACK && step != 0.0 && step.is_finite()).then_some(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_any_order_give_the_grid() {
        // 4 x 3 points with positions printed to two digits; one point is missing.
        let mut values = Vec::new();
        for i in (0..12).map(|i| (i * 5) % 12).filter(|i| *i != 7) {
            let x = (f64::from(i % 4) * 12.7656).round() / 100.0;
            values.extend([x, -0.3 * f64::from(i / 4), f64::from(i)]);
        }
        let (heights, columns, pixel_size) = grid(values).unwrap();
        assert_eq!((heights.len(), columns), (12, 4));
        assert!((pixel_size[0] - 0.1267).abs() < 1e-3 && (pixel_size[1] - 0.3).abs() < 1e-12);
        // y descends in the file and ascends in the rows.
        assert!(heights[4 + 3].is_nan());
        assert_eq!((heights[0], heights[1], heights[8]), (8.0, 9.0, 0.0));
    }

    #[test]
    fn columns_without_points_are_missing() {
        let mut values = Vec::new();
        for i in (0..40).filter(|i| i % 10 != 4) {
            values.extend([f64::from(i % 10) * 0.1, f64::from(i / 10), 1.0]);
        }
        let (heights, columns, _) = grid(values).unwrap();
        assert_eq!(columns, 10);
        assert_eq!(heights.iter().filter(|z| z.is_nan()).count(), 4);
    }

    #[test]
    fn irregular_grids_are_refused() {
        let message = |values: &[f64]| grid(values.to_vec()).unwrap_err().to_string();
        assert!(message(&[0.0, 0.0, 1.0]).contains("1 positions;"));
        assert!(
            message(&[0., 0., 1., 1., 0., 1., 0., 1., 1., 1., 0., 2.]).contains("a second point")
        );
        let uneven = [0., 0., 1., 1., 1., 1., 2.4, 2., 1., 3., 3., 1.];
        assert!(message(&uneven).contains("a point at 2.4"), "{}", message(&uneven));
        let far = [0., 0., 1., 1., 1., 1., 2., 2., 1., 1e30, 3., 1.];
        assert!(message(&far).starts_with("x: "), "{}", message(&far));
        let nan = [0., 0., 1., f64::NAN, 1., 1.];
        assert!(message(&nan).contains("without a position"));
        let diagonal: Vec<f64> =
            (0..5000).flat_map(|i| [f64::from(i), f64::from(i), 1.0]).collect();
        assert!(message(&diagonal).contains("thousandth"));
    }
}
