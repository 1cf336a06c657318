//! Slopes and curvatures of profiles against the distance over which they are taken, and the
//! anisotropy of a surface, from the second moments of its slopes.

use serde::Serialize;

use crate::Topography;

impl Topography {
    /// Calls `each` with the heights of every square of four measured points; around the edges of
    /// a periodic surface.
    pub(crate) fn squares(&self, mut each: impl FnMut([[f64; 2]; 2])) {
        let (rows, columns) = (self.rows(), self.columns());
        if rows < 2 {
            return;
        }
        let row = |y: usize| &self.heights()[y % rows * columns..][..columns];
        let open = usize::from(!self.is_periodic());
        for y in 0..rows - open {
            let (up, down) = (row(y), row(y + 1));
            for x in 0..columns - open {
                let next = if x + 1 < columns { x + 1 } else { 0 };
                let four = [[up[x], up[next]], [down[x], down[next]]];
                if !four.iter().flatten().any(|z| z.is_nan()) {
                    each(four);
                }
            }
        }
    }
}

/// Root mean square slopes and curvatures over a distance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct AtDistance {
    /// Points from one height to the next.
    pub step: usize,
    /// Rms of (z(x + d) - z(x))/d along rows, d = step pixels; `None` beyond the scan.
    pub slope_rows: Option<f64>,
    /// Along columns.
    pub slope_columns: Option<f64>,
    /// Rms of (z(x + d) - 2 z(x) + z(x - d))/d² along rows \[1/m\].
    pub curvature_rows: Option<f64>,
    /// Along columns \[1/m\].
    pub curvature_columns: Option<f64>,
}

impl Topography {
    /// Slopes and curvatures over distances of 1, 2, 4, ... pixels, up to a quarter of the longer
    /// side. Differences with a missing point are left out; a periodic surface continues beyond
    /// its edges.
    #[must_use]
    pub fn scale_dependence(&self) -> Vec<AtDistance> {
        let most = (self.columns().max(self.rows()) / 4).max(1);
        let steps = std::iter::successors(Some(1_usize), |step| Some(2 * step));
        steps.take_while(|step| *step <= most).map(|step| self.at_distance(step)).collect()
    }

    /// Slopes and curvatures over a distance of whole pixels.
    #[must_use]
    pub fn at_distance(&self, step: usize) -> AtDistance {
        let rms = |mean: Mean| mean.mean().map(f64::sqrt);
        let [along_rows, along_columns] = self.differences(step, 0.0);
        AtDistance {
            step,
            slope_rows: rms(along_rows.slope),
            slope_columns: rms(along_columns.slope),
            curvature_rows: rms(along_rows.curvature),
            curvature_columns: rms(along_columns.curvature),
        }
    }

    /// The differences of heights so many points apart, along rows and along columns; products with
    /// heights are of those above `base`.
    pub(crate) fn differences(&self, step: usize, base: f64) -> [Differences; 2] {
        let [dx, dy] = self.pixel_size().map(|pixel| step as f64 * pixel);
        [self.differences_along([0, step], dx, base), self.differences_along([step, 0], dy, base)]
    }

    /// The same, from heights so many rows and columns apart, at a distance.
    fn differences_along(
        &self,
        [down, right]: [usize; 2],
        distance: f64,
        base: f64,
    ) -> Differences {
        let (rows, columns, wrap) = (self.rows(), self.columns(), self.is_periodic());
        let after = |at: usize, steps: usize, n: usize| match at + steps {
            to if to < n => Some(to),
            to => (wrap && steps < n).then(|| to % n),
        };
        let row = |y: usize| &self.heights()[y * columns..][..columns];
        let mut sums = Differences::default();
        for y in 0..rows {
            let Some(next) = after(y, down, rows).map(row) else { break };
            let (here, far) = (row(y), after(y, 2 * down, rows).map(row));
            let mut line = Differences::default();
            for (x, z) in here.iter().enumerate() {
                let Some(one) = after(x, right, columns) else { break };
                let slope = (next[one] - z) / distance;
                line.slope.add(slope * slope);
                line.slope_height.add(slope * slope * (0.5 * (z + next[one]) - base));
                if let Some((far, two)) = far.zip(after(x, 2 * right, columns)) {
                    let curvature = (z - 2.0 * next[one] + far[two]) / (distance * distance);
                    line.curvature.add(curvature * curvature);
                }
            }
            sums.slope.plus(line.slope);
            sums.slope_height.plus(line.slope_height);
            sums.curvature.plus(line.curvature);
        }
        sums
    }
}

/// A running mean without values that contain a missing point.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Mean {
    sum: f64,
    pub(crate) count: usize,
}

impl Mean {
    pub(crate) fn add(&mut self, value: f64) {
        if !value.is_nan() {
            self.sum += value;
            self.count += 1;
        }
    }

    pub(crate) fn plus(&mut self, other: Self) {
        self.sum += other.sum;
        self.count += other.count;
    }

    pub(crate) fn mean(self) -> Option<f64> {
        (self.count > 0).then(|| self.sum / self.count as f64)
    }
}

/// Squares of slopes and curvatures along one direction, and squares of slopes times the height
/// between their two points.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Differences {
    pub(crate) slope: Mean,
    pub(crate) curvature: Mean,
    pub(crate) slope_height: Mean,
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::Texture;

    /// Two waves at right angles, the second along the direction of the lay.
    fn crossed(degrees: f64, [across, along]: [f64; 2]) -> Texture {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let n = 400;
        let height = |k: usize| {
            let (x, y) = (0.2 * (k % n) as f64, 0.2 * (k / n) as f64);
            across * (y * cos - x * sin).cos() + along * (x * cos + y * sin).cos()
        };
        let surface = Topography::new((0..n * n).map(height).collect(), n, [0.2, 0.2]).unwrap();
        surface.moments().unwrap().texture().unwrap()
    }

    #[test]
    fn crossed_waves_have_their_slopes_and_direction() {
        for degrees in [0.0, 25.0, 90.0, -40.0] {
            let found = crossed(degrees, [0.3, 0.1]);
            assert!((found.ratio().unwrap() / 3.0 - 1.0).abs() < 0.02, "{found:?}");
            assert!((found.slope_across / (0.3 / 2f64.sqrt()) - 1.0).abs() < 0.02, "{found:?}");
            let off = (found.direction - degrees).rem_euclid(180.0);
            assert!(off.min(180.0 - off) < 0.5, "{degrees} {found:?}");
            assert!(found.direction > -90.0 && found.direction <= 90.0);
        }
    }

    #[test]
    fn grooves_have_no_ratio_and_flat_surfaces_no_texture() {
        let groove = |k: usize| (TAU * (k % 32) as f64 / 32.0).sin();
        let grooves = Topography::new((0..1024).map(groove).collect(), 32, [1.0; 2]).unwrap();
        let found = grooves.moments().unwrap().texture().unwrap();
        assert!(found.ratio().is_none() && (found.direction - 90.0).abs() < 1e-9, "{found:?}");
        let texture = |heights: Vec<f64>| {
            Topography::new(heights, 4, [1.0; 2]).unwrap().moments().unwrap().texture()
        };
        assert!(texture(vec![0.0; 16]).is_none());
        assert!(texture(vec![0.0, 1.0, 3.0, 2.0]).is_none());
    }

    #[test]
    fn a_wave_has_the_closed_form_of_its_differences() {
        let n = 96;
        let wave = |k: usize| 3e-7 * (TAU * 4.0 * (k % n) as f64 / n as f64).sin();
        let surface = Topography::new((0..n * n).map(wave).collect(), n, [2e-6, 1e-6]).unwrap();
        for (k, found) in surface.with_periodic(true).scale_dependence().iter().enumerate() {
            assert_eq!(found.step, 1 << k);
            let d = 2e-6 * found.step as f64;
            let gain = 2.0 * (TAU * 4.0 * found.step as f64 / n as f64 / 2.0).sin().abs();
            let rms = 3e-7 / 2f64.sqrt();
            let close = |found: Option<f64>, right: f64| {
                assert!(
                    (found.unwrap() - right).abs() < 1e-9 * (right + 1e-6 * rms / d),
                    "{right}"
                );
            };
            close(found.slope_rows, rms * gain / d);
            close(found.curvature_rows, rms * (gain / d).powi(2));
            close(found.slope_columns, 0.0);
        }
    }

    #[test]
    fn open_surfaces_and_missing_points_leave_differences_out() {
        let profile = vec![0.0, 1.0, f64::NAN, 4.0, 6.0, 9.0];
        let profile = Topography::new(profile, 6, [1.0; 2]).unwrap();
        let one = profile.at_distance(1);
        assert!((one.slope_rows.unwrap().powi(2) - 14.0 / 3.0).abs() < 1e-12);
        assert!((one.curvature_rows.unwrap().powi(2) - 1.0).abs() < 1e-12);
        assert!(one.slope_columns.is_none());
        assert!(profile.at_distance(6).slope_rows.is_none());
    }
}
