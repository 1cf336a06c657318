//! Levelling: removes the mean, the least-squares plane or quadric.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use serde::{Deserialize, Serialize};

use crate::error::{named, refuse};
use crate::{Topography, TopographyError};

/// The form removed before statistics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Level {
    /// Nothing.
    None,
    /// The mean height.
    Mean,
    /// The least-squares plane (a line, for a profile).
    Plane,
    /// The least-squares quadric z = a + bx + cy + dx² + exy + fy² (a parabola, for a profile).
    Quadratic,
}

named!(Level, "level");

impl Level {
    /// The default: the plane, which is the tilt in the instrument; for a periodic surface the
    /// mean, because a fitted plane would tilt the surface and its edges would no longer match.
    #[must_use]
    pub fn usual(periodic: bool) -> Self {
        if periodic { Self::Mean } else { Self::Plane }
    }

    /// Powers (a, b) of the terms u^a v^b that are fitted.
    fn terms(self, profile: bool) -> Vec<[usize; 2]> {
        const ALL: [[usize; 2]; 6] = [[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2]];
        let count = [0, 1, 3, 6][self as usize];
        ALL.into_iter().take(count).filter(|[_, b]| !profile || *b == 0).collect()
    }
}

/// Below this ratio of eigenvalues the points do not determine the fit. With coordinates from -1
/// to 1 a full grid of three by three points has 0.02.
const DETERMINED: f64 = 1e-9;

/// Residuals below this share of the largest height are rounding of the fit, with about three
/// roundings per height.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Topography {
    /// The surface [levelled](Self::level) by `level`, by default the [usual](Level::usual) one.
    ///
    /// # Errors
    /// The errors of [`level`](Self::level).
    pub fn levelled(self, level: Option<Level>) -> Result<Self, TopographyError> {
        let level = level.unwrap_or(Level::usual(self.is_periodic()));
        self.level(level)
    }

    /// The surface without its mean, its least-squares plane or quadric; missing points stay
    /// missing.
    ///
    /// # Errors
    /// [`TopographyError::Content`] when the points do not determine the fit: all on one line, for
    /// example.
    pub fn level(self, level: Level) -> Result<Self, TopographyError> {
        if level == Level::None {
            return Ok(self);
        }
        let largest = self.largest();
        let form = self.form(level)?;
        let mut levelled = self.without(&form);
        if levelled.largest() <= ROUNDING * largest {
            // The rounding of an exact plane would have summits.
            let there = levelled.heights.iter_mut().filter(|height| !height.is_nan());
            there.for_each(|height| *height = 0.0);
        }
        Ok(levelled)
    }

    /// The least-squares form.
    pub(crate) fn form(&self, level: Level) -> Result<Form, TopographyError> {
        let terms = level.terms(self.is_profile());
        let (columns, rows) = (self.columns(), self.rows());
        let along: Vec<f64> = (0..columns).map(|x| scaled(x, columns)).collect();
        let mean = self.mean();
        let mut normal = DMatrix::<f64>::zeros(terms.len(), terms.len());
        let mut right = DVector::<f64>::zeros(terms.len());
        for (y, row) in self.heights().chunks(columns).enumerate() {
            let v = scaled(y, rows);
            let (powers, heights) = row_sums(row, &along, mean);
            for (i, [a, b]) in terms.iter().enumerate() {
                right[i] += v.powi(*b as i32) * heights[*a];
                for (j, [c, d]) in terms.iter().enumerate() {
                    normal[(i, j)] += v.powi((b + d) as i32) * powers[a + c];
                }
            }
        }
        let eigen = SymmetricEigen::new(normal);
        if eigen.eigenvalues.min() <= DETERMINED * eigen.eigenvalues.max() {
            let found = format!("{} points with a height", self.measured());
            let required = "points in at least two (plane) or three (quadratic) rows and columns";
            return Err(refuse(format!("level {level}"), found, required));
        }
        let weights = eigen.eigenvectors.tr_mul(&right).component_div(&eigen.eigenvalues);
        let fit = eigen.eigenvectors * weights;
        let terms = terms.into_iter().zip(fit.iter().copied()).collect();
        Ok(Form { mean, terms, shape: [rows, columns] })
    }

    /// The surface without a form.
    pub(crate) fn without(mut self, form: &Form) -> Self {
        let columns = self.columns();
        for (y, row) in self.heights.chunks_mut(columns).enumerate() {
            let form = form.along_row(y);
            for (x, height) in row.iter_mut().enumerate() {
                *height -= form(x);
            }
        }
        self
    }

    /// The largest absolute height \[m\].
    pub(crate) fn largest(&self) -> f64 {
        self.heights().iter().fold(0.0, |largest, height| f64::max(largest, height.abs()))
    }
}

/// A least-squares form of a surface: its mean, and coefficients of powers u^a v^b.
pub(crate) struct Form {
    mean: f64,
    terms: Vec<([usize; 2], f64)>,
    shape: [usize; 2],
}

impl Form {
    /// The heights of row `y` by column, a polynomial in u alone.
    pub(crate) fn along_row(&self, y: usize) -> impl Fn(usize) -> f64 {
        let [rows, columns] = self.shape;
        let mut polynomial = [self.mean, 0.0, 0.0];
        for ([a, b], coefficient) in &self.terms {
            polynomial[*a] += coefficient * scaled(y, rows).powi(*b as i32);
        }
        let [c0, c1, c2] = polynomial;
        move |x| {
            let u = scaled(x, columns);
            c0 + u * (c1 + u * c2)
        }
    }
}

/// The coordinate of a point among n, from -1 to 1, so that sums of its powers are well scaled.
fn scaled(index: usize, n: usize) -> f64 {
    if n < 2 { 0.0 } else { (2 * index) as f64 / (n - 1) as f64 - 1.0 }
}

/// Sums of u^k, k = 0..4, and of (z - mean) u^k, k = 0..2, over the points with a height.
fn row_sums(row: &[f64], along: &[f64], mean: f64) -> ([f64; 5], [f64; 3]) {
    let (mut powers, mut heights) = ([0.0; 5], [0.0; 3]);
    for (height, u) in row.iter().zip(along).filter(|(height, _)| !height.is_nan()) {
        let (z, u2) = (height - mean, u * u);
        for (sum, power) in powers.iter_mut().zip([1.0, *u, u2, u2 * u, u2 * u2]) {
            *sum += power;
        }
        for (sum, power) in heights.iter_mut().zip([z, z * u, z * u2]) {
            *sum += power;
        }
    }
    (powers, heights)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bumps on a quadric, optionally with a hole; and the bumps alone.
    fn quadric(missing: bool) -> (Topography, Vec<f64>) {
        let (columns, rows) = (40, 30);
        let mut heights = Vec::new();
        for index in 0..columns * rows {
            let (x, y) = ((index % columns) as f64, (index / columns) as f64);
            let form = 3e-6 + 2e-8 * x - 1e-8 * y + 4e-9 * x * x - 2e-9 * x * y + 1e-9 * y * y;
            let hole = missing && (10.0..14.0).contains(&x) && y > 20.0;
            heights.push(if hole { f64::NAN } else { form });
        }
        let surface = Topography::new(heights.clone(), columns, [1e-6, 2e-6]).unwrap();
        (surface, heights)
    }

    #[test]
    fn a_quadric_levels_to_nothing_and_holes_stay() {
        for missing in [false, true] {
            let (surface, before) = quadric(missing);
            let levelled = surface.level(Level::Quadratic).unwrap();
            for (after, before) in levelled.heights().iter().zip(&before) {
                assert_eq!(after.is_nan(), before.is_nan());
                assert!(after.is_nan() || after.abs() < 1e-19, "{after:e}");
            }
        }
    }

    #[test]
    fn an_exact_plane_has_no_asperities_from_rounding() {
        let plane = |rough: f64| {
            let height = |i: i32| {
                let (x, y) = (f64::from(i % 50), f64::from(i / 50));
                0.1 * x + 0.3 * y + rough * (7.0 * x * x + 3.0 * y * x).sin()
            };
            let surface = Topography::new((0..2500).map(height).collect(), 50, [1.0; 2]).unwrap();
            surface.level(Level::Plane).unwrap()
        };
        let flat = plane(0.0).statistics(crate::Estimator::Moments);
        assert!(matches!(flat, Err(TopographyError::Flat { points: 2500 })));
        let sq = plane(1e-12).moments().unwrap().profile.m0.sqrt();
        assert!((0.5e-12..1e-12).contains(&sq), "{sq:e}");
    }

    #[test]
    fn residuals_are_orthogonal_to_the_plane() {
        let (surface, before) = quadric(true);
        let untouched = surface.clone().level(Level::None).unwrap();
        assert_eq!(untouched.heights()[0].to_bits(), before[0].to_bits());
        let levelled = surface.level(Level::Plane).unwrap();
        let mut sums = [0.0; 4];
        for (index, z) in levelled.heights().iter().enumerate().filter(|(_, z)| !z.is_nan()) {
            let (x, y) = ((index % 40) as f64, (index / 40) as f64);
            for (sum, term) in sums.iter_mut().zip([*z, z * x, z * y, z * z]) {
                *sum += term;
            }
        }
        let scale = (sums[3] * 1200.0).sqrt();
        assert!(sums[0].abs() < 1e-12 * scale, "{sums:?}");
        assert!(sums[1].abs() < 1e-11 * scale && sums[2].abs() < 1e-11 * scale, "{sums:?}");
    }

    #[test]
    fn a_periodic_surface_keeps_its_slopes_by_default() {
        let turn = std::f64::consts::TAU / 48.0;
        // A plane fitted to a sine is not level.
        let height = |i: i32| 1e-7 * (turn * f64::from(i % 48)).sin() + 3e-6;
        let wave = Topography::new((0..48 * 48).map(height).collect(), 48, [1e-6; 2]).unwrap();
        let slopes = |surface: &Topography| surface.moments().unwrap().along_rows;
        let periodic = wave.clone().with_periodic(true);
        let usual = periodic.clone().levelled(None).unwrap();
        assert!(usual.mean().abs() < 1e-20);
        let [kept, levelled] = [slopes(&periodic), slopes(&usual)];
        assert!(
            (0..2).all(|k| (levelled[k] / kept[k] - 1.0).abs() < 1e-9),
            "{kept:?} {levelled:?}"
        );
        let tilted = periodic.clone().levelled(Some(Level::Plane)).unwrap();
        assert!(slopes(&tilted)[1] > 1.5 * kept[1]);
        assert_eq!(Level::Plane.tilts(true).unwrap().code.name(), "level");
        assert!(Level::Plane.tilts(false).is_none() && Level::Mean.tilts(true).is_none());
        // A surface that is not periodic has the tilt of the instrument.
        let level = wave.clone().level(Level::Plane).unwrap();
        assert_eq!(wave.levelled(None).unwrap(), level);
    }

    #[test]
    fn profiles_have_lines_and_parabolas() {
        let heights: Vec<f64> = (0..50).map(|x| 1e-6 * f64::from(x * x - 3 * x)).collect();
        let profile = Topography::new(heights, 50, [1e-6; 2]).unwrap();
        let levelled = profile.level(Level::Quadratic).unwrap();
        assert!(levelled.heights().iter().all(|z| z.abs() < 1e-16));
    }
}
