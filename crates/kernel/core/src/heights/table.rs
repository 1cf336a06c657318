//! A measured density of heights: a table with linear interpolation.

use crate::error::{positive, require};
use crate::{ContactError, Heights};

/// A density given at heights in metres: linear between the points, zero outside them, normalised.
///
/// Two points at the same height make a step. Heights are in metres about the mean of the table,
/// from which separations are measured. The scene's `asperity_height_std` is only the unit of
/// separations; the table's standard deviation is the natural choice.
///
/// ```
/// use asperity_core::{HeightDistribution, Interface, Scene, Surface, TabulatedHeights};
///
/// let measured = [(-2e-6, 0.0), (0.0, 3e5), (0.5e-6, 3.5e5), (1.5e-6, 0.0)]; // m, 1/m
/// let heights = TabulatedHeights::new("measured", &measured)?;
/// let surface = Surface::new(3.6e-4, 1.1e8, heights.standard_deviation());
/// let mut scene = Scene::new(Interface::new(116e9, 0.31, 1.12e9), surface, 3e-5);
/// scene.heights = HeightDistribution::other(heights);
/// # Ok::<(), asperity_core::ContactError>(())
/// ```
#[derive(Debug, Clone)]
pub struct TabulatedHeights {
    name: String,
    /// As given.
    points: Vec<(f64, f64)>,
    /// Heights above the mean \[m\].
    heights: Vec<f64>,
    /// Normalised densities \[1/m\].
    densities: Vec<f64>,
    mean: f64,
    std: f64,
    /// The heights above the mean, without the first and the last.
    breaks: Vec<f64>,
}

impl TabulatedHeights {
    /// Points (height \[m\], density \[1/m\]), ascending; the density is normalised.
    ///
    /// # Errors
    /// [`ContactError::InTable`] for a point that is not finite, not ascending or negative;
    /// [`ContactError::OutOfRange`] for fewer than two points, and for an integral or standard
    /// deviation that is not finite and above 0.
    pub fn new(name: impl Into<String>, points: &[(f64, f64)]) -> Result<Self, ContactError> {
        check(points)?;
        let segments = || points.windows(2).map(|pair| (pair[0], pair[1]));
        let first = points.first().map_or(0.0, |point| point.0);
        let area = |((a, f), (b, g)): (_, _)| 0.5 * (b - a) * (f + g);
        let integral = positive("integral of density_per_m", segments().map(area).sum())?;
        // Moments of each linear piece, about the first height and then about the mean.
        let lever = |((a, f), (b, g)): ((f64, f64), (f64, f64))| {
            let (a, b) = (a - first, b - first);
            (b - a) * (f * (2.0 * a + b) + g * (a + 2.0 * b)) / 6.0
        };
        let mean = first + segments().map(lever).sum::<f64>() / integral;
        let square = |((a, f), (b, g)): ((f64, f64), (f64, f64))| {
            let (a, b) = (a - mean, b - mean);
            let (aa, ab, bb) = (a * a, a * b, b * b);
            (b - a) * (f * (3.0 * aa + 2.0 * ab + bb) + g * (aa + 2.0 * ab + 3.0 * bb)) / 12.0
        };
        let variance = segments().map(square).sum::<f64>() / integral;
        let std = positive("standard deviation of height_m", variance.sqrt())?;
        let heights: Vec<f64> = points.iter().map(|point| point.0 - mean).collect();
        let ends = (heights[0], heights[heights.len() - 1]);
        let mut breaks = heights.clone();
        breaks.retain(|z| *z > ends.0 && *z < ends.1);
        breaks.dedup();
        Ok(Self {
            name: name.into(),
            points: points.to_vec(),
            heights,
            densities: points.iter().map(|point| point.1 / integral).collect(),
            mean,
            std,
            breaks,
        })
    }

    /// The points as given: height \[m\] and density \[1/m\], not normalised.
    #[must_use]
    pub fn points(&self) -> &[(f64, f64)] {
        &self.points
    }

    /// Mean of the heights \[m\] in the table's own coordinate: the datum of separations.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Standard deviation of the heights \[m\].
    #[must_use]
    pub fn standard_deviation(&self) -> f64 {
        self.std
    }

    /// Distances \[m\] and densities of the two points around a height above the mean \[m\]; `None`
    /// outside the table.
    fn piece(&self, z: f64) -> Option<[(f64, f64); 2]> {
        let count = self.heights.len();
        let after = self.heights.partition_point(|height| *height <= z);
        // The last height belongs to the last piece.
        let last = || self.heights.partition_point(|height| *height < z).min(count - 1);
        let right = if after == count { last() } else { after };
        let left = right.checked_sub(1)?;
        let (a, b) = (z - self.heights[left], self.heights[right] - z);
        (a >= 0.0 && b >= 0.0).then_some([(a, self.densities[left]), (b, self.densities[right])])
    }
}

fn check(points: &[(f64, f64)]) -> Result<(), ContactError> {
    require(points.len() >= 2, "number of points", points.len() as f64, "at least 2")?;
    let refused = |row, field, value, required| {
        Err(ContactError::InTable { row: row + 1, field, value, required })
    };
    for (row, (height, density)) in points.iter().copied().enumerate() {
        if !height.is_finite() {
            return refused(row, "height_m", height, "a finite number");
        }
        if !(density.is_finite() && density >= 0.0) {
            return refused(row, "density_per_m", density, "a finite number, at least 0,");
        }
        if row > 0 && height < points[row - 1].0 {
            return refused(row, "height_m", height, "a height not below the one before");
        }
        if row > 1 && height <= points[row - 2].0 {
            return refused(row, "height_m", height, "no more than two densities for one height");
        }
    }
    Ok(())
}

impl Heights for TabulatedHeights {
    fn name(&self) -> &str {
        &self.name
    }

    fn ln_density(&self, z: f64) -> f64 {
        // Weights by both distances are accurate close to an end with density 0.
        self.piece(z).map_or(f64::NEG_INFINITY, |[(a, f), (b, g)]| ((f * b + g * a) / (a + b)).ln())
    }

    fn support(&self) -> (f64, f64) {
        let end = |z: Option<&f64>| z.copied().unwrap_or(0.0);
        (end(self.heights.first()), end(self.heights.last()))
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_and_standard_deviation_equal_closed_forms() {
        // Triangular on a, c, b: (a+b+c)/3 and (a²+b²+c²-ab-ac-bc)/18.
        let (a, c, b) = (1e-6, 2e-6, 5e-6);
        let triangle = TabulatedHeights::new("t", &[(a, 0.0), (c, 7.0), (b, 0.0)]).unwrap();
        assert!((triangle.mean() / ((a + b + c) / 3.0) - 1.0).abs() < 1e-14);
        let variance = (a * a + b * b + c * c - a * b - a * c - b * c) / 18.0;
        assert!((triangle.standard_deviation() / variance.sqrt() - 1.0).abs() < 1e-14);
        // A uniform density of width 1 far from zero.
        let uniform = TabulatedHeights::new("u", &[(1000.0, 3.0), (1001.0, 3.0)]).unwrap();
        assert!((uniform.standard_deviation() * 12f64.sqrt() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn density_is_normalised_about_its_mean() {
        let points = [(-1e-6, 0.0), (0.0, 1.0), (0.0, 3.0), (1e-6, 3.0), (2e-6, 0.0), (3e-6, 0.0)];
        let table = TabulatedHeights::new("steps", &points).unwrap();
        let (low, high) = table.support();
        let count = 100_000;
        let step = (high - low) / f64::from(count);
        let z = |k: i32| low + step * (f64::from(k) + 0.5);
        let area: f64 = (0..count).map(|k| step * table.ln_density(z(k)).exp()).sum();
        assert!((area - 1.0).abs() < 1e-4, "{area}");
        let mean: f64 = (0..count).map(|k| step * z(k) * table.ln_density(z(k)).exp()).sum();
        assert!(mean.abs() < 1e-10, "{mean}");
        assert_eq!(table.breaks().len(), 3);
        for z in [low - 1e-9, high + 1e-9, high - 0.5e-6] {
            assert!(table.ln_density(z) == f64::NEG_INFINITY);
        }
    }

    #[test]
    fn invalid_tables_are_refused_with_row_and_value() {
        let bad: [(&[(f64, f64)], &str); 8] = [
            (&[], "number of points"),
            (&[(0.0, 1.0)], "number of points"),
            (&[(0.0, 1.0), (f64::NAN, 1.0)], "row 2: height_m is NaN"),
            (&[(0.0, -1.0), (1.0, 1.0)], "row 1: density_per_m is -1"),
            (&[(0.0, 1.0), (1.0, 1.0), (0.5, 1.0)], "row 3: height_m is 0.5"),
            (&[(0.0, 1.0), (0.0, 2.0), (0.0, 3.0)], "row 3: height_m is 0"),
            (&[(0.0, 0.0), (1.0, 0.0)], "integral of density_per_m"),
            (&[(-1e308, 1.0), (1e308, 1e10)], "integral of density_per_m"),
        ];
        for (points, wanted) in bad {
            let message = TabulatedHeights::new("bad", points).unwrap_err().to_string();
            assert!(message.starts_with(wanted), "{message}");
        }
    }
}
