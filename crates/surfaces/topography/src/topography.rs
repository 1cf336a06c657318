//! Heights on a regular grid.

use std::sync::Arc;

use asperity_core::Finding;

use crate::error::{at_most, out_of_range, refuse};
use crate::{LengthUnit, Outliers, TopographyError};

/// The largest number of points of a surface: 2²⁷, 1 GiB of heights.
pub const MAX_POINTS: usize = 1 << 27;

/// The largest height or pixel \[m\]: a larger number is a broken file or a wrong unit, and its
/// powers would overflow.
const LARGEST: f64 = 1e9;
/// The smallest pixel \[m\].
const SMALLEST_PIXEL: f64 = 1e-15;

/// Heights on a regular grid of points; a profile has one row.
///
/// A point stands for a cell of one pixel, so n points at a distance dx cover a length n·dx: a
/// physical size stated in a file is divided by n, not by n - 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Topography {
    /// \[m\], row by row; NaN where the point is missing.
    pub(crate) heights: Vec<f64>,
    pub(crate) columns: usize,
    pub(crate) pixel_size: [f64; 2],
    pub(crate) periodic: bool,
    pub(crate) missing: usize,
    pub(crate) filled: usize,
    pub(crate) despiked: usize,
    /// Those found before a filter, which spreads them.
    pub(crate) outliers: Option<Arc<Outliers>>,
    /// Choices made in reading.
    pub(crate) notes: Vec<Finding>,
}

impl Topography {
    /// A surface from heights \[m\], row by row, `columns` per row, NaN for missing points, and the
    /// distance of neighbouring points along a row and along a column \[m\].
    ///
    /// A single column is a profile and is turned into a row.
    ///
    /// # Errors
    /// [`TopographyError`] when the heights do not fill whole rows, when a height is beyond ±1e9 m,
    /// when there are none, when there are more than [`MAX_POINTS`], or when a pixel size is not
    /// between 1e-15 m and 1e9 m.
    pub fn new(
        heights: Vec<f64>,
        columns: usize,
        pixel_size: [f64; 2],
    ) -> Result<Self, TopographyError> {
        if heights.is_empty() || columns == 0 || !heights.len().is_multiple_of(columns) {
            let found = format!("{} in rows of {columns}", heights.len());
            return Err(refuse("heights", found, "a whole number of rows, at least one"));
        }
        at_most("the number of points", heights.len() as u64, MAX_POINTS as u64)?;
        for value in pixel_size {
            if !(SMALLEST_PIXEL..=LARGEST).contains(&value) {
                return Err(out_of_range("pixel_size", value, "a length of 1e-15 to 1e9 m"));
            }
        }
        if let Some(index) = heights.iter().position(|height| height.abs() > LARGEST) {
            let place = format!("row {}, column {} (from 0)", index / columns, index % columns);
            let required = "a height of at most 1e9 m in size, or NaN for a missing point";
            return Err(refuse(place, format_args!("{:e} m", heights[index]), required));
        }
        let missing = heights.iter().filter(|height| height.is_nan()).count();
        if missing == heights.len() {
            return Err(refuse("points with a height", 0, "at least 1"));
        }
        let (columns, pixel_size) = match columns {
            1 => (heights.len(), [pixel_size[1]; 2]),
            _ => (columns, pixel_size),
        };
        Ok(Self {
            heights,
            columns,
            pixel_size,
            periodic: false,
            missing,
            filled: 0,
            despiked: 0,
            outliers: None,
            notes: vec![],
        })
    }

    /// [`new`](Self::new), from heights and distances in another unit.
    ///
    /// # Errors
    /// The errors of [`new`](Self::new).
    pub fn in_unit(
        heights: Vec<f64>,
        columns: usize,
        pixel_size: [f64; 2],
        unit: LengthUnit,
    ) -> Result<Self, TopographyError> {
        let metres = heights.into_iter().map(|height| height * unit.metres()).collect();
        Self::new(metres, columns, pixel_size.map(|distance| distance * unit.metres()))
    }

    /// The same surface, continued periodically beyond its edges or not (the default).
    /// A measured surface is not periodic; a generated one often is.
    #[must_use]
    pub fn with_periodic(mut self, periodic: bool) -> Self {
        self.periodic = periodic;
        self
    }

    /// Choices made in reading: which channel of a file, a profile at equal distances.
    #[must_use]
    pub fn notes(&self) -> &[Finding] {
        &self.notes
    }

    /// The heights \[m\], row by row; NaN where a point is missing.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Points along a row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Rows: 1 for a profile.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.heights.len() / self.columns
    }

    /// Whether this is a profile: one row of heights.
    #[must_use]
    pub fn is_profile(&self) -> bool {
        self.rows() == 1
    }

    /// Distance of neighbouring points along a row and along a column \[m\].
    #[must_use]
    pub fn pixel_size(&self) -> [f64; 2] {
        self.pixel_size
    }

    /// Whether the surface continues periodically beyond its edges.
    #[must_use]
    pub fn is_periodic(&self) -> bool {
        self.periodic
    }

    /// Share of the points that are missing, 0 to 1.
    #[must_use]
    pub fn missing_share(&self) -> f64 {
        self.missing as f64 / self.heights.len() as f64
    }

    /// Share of the points that were missing and have been [filled](Self::fill), 0 to 1.
    #[must_use]
    pub fn filled_share(&self) -> f64 {
        self.filled as f64 / self.heights.len() as f64
    }

    /// The surface without these points.
    pub(crate) fn without_points(mut self, points: &[usize]) -> Self {
        for at in points {
            self.missing += usize::from(!self.heights[*at].is_nan());
            self.heights[*at] = f64::NAN;
        }
        self
    }

    /// The surface, about to be filtered, with a record of its outliers.
    pub(crate) fn with_outliers_found(mut self) -> Self {
        if self.outliers.is_none() {
            self.outliers = Some(Arc::new(self.find_outliers()));
        }
        self
    }

    /// The number of points with a height, at least 1.
    #[must_use]
    pub fn measured(&self) -> usize {
        self.heights.len() - self.missing
    }

    /// Mean of the heights without missing points \[m\], summed row by row.
    #[must_use]
    pub fn mean(&self) -> f64 {
        let row_sum = |row: &[f64]| row.iter().filter(|height| !height.is_nan()).sum::<f64>();
        self.heights.chunks(self.columns).map(row_sum).sum::<f64>() / self.measured() as f64
    }
}

/// The least and the largest of numbers; infinite without numbers.
pub(crate) fn extremes<'a>(numbers: impl IntoIterator<Item = &'a f64>) -> [f64; 2] {
    let wider = |[low, high]: [f64; 2], z: &f64| [low.min(*z), high.max(*z)];
    numbers.into_iter().fold([f64::INFINITY, f64::NEG_INFINITY], wider)
}

/// Rows as columns.
pub(crate) fn transposed<T: Copy>(points: &[T], columns: usize) -> Vec<T> {
    let rows = points.len() / columns;
    (0..columns).flat_map(|x| (0..rows).map(move |y| points[y * columns + x])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invalid_surfaces_are_refused() {
        let one = [1e-6; 2];
        let message = |heights: Vec<f64>, columns, pixel_size| {
            Topography::new(heights, columns, pixel_size).unwrap_err().to_string()
        };
        assert!(message(vec![], 1, one).starts_with("heights: 0 in"));
        assert!(message(vec![0.0; 4], 0, one).starts_with("heights: 4 in"));
        assert!(message(vec![0.0; 4], 2, [1.0, 0.0]).starts_with("pixel_size is 0:"));
        assert!(message(vec![0.0; 4], 2, [f64::NAN, 1.0]).starts_with("pixel_size is NaN"));
        assert!(message(vec![0.0, f64::NEG_INFINITY], 2, one).contains("row 0, column 1"));
        assert!(message(vec![f64::NAN; 4], 2, one).starts_with("points with a height: 0"));
    }

    #[test]
    fn missing_points_are_counted_and_kept() {
        let surface = Topography::new(vec![1.0, f64::NAN, 3.0, 4.0], 2, [1.0, 2.0]).unwrap();
        assert!((surface.missing_share() - 0.25).abs() < 1e-15);
        assert!((surface.mean() - 8.0 / 3.0).abs() < 1e-15);
        assert!(surface.heights()[1].is_nan());
        assert_eq!((surface.rows(), surface.columns()), (2, 2));
    }

    #[test]
    fn a_column_is_a_profile() {
        let profile = Topography::new(vec![1.0, 2.0, 3.0], 1, [1.0, 2.0]).unwrap();
        assert!(profile.is_profile());
        assert_eq!((profile.columns(), profile.pixel_size()), (3, [2.0, 2.0]));
    }
}
