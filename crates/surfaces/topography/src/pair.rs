//! The gap of two aligned scans, point by point.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::error::{named, refuse};
use crate::{Topography, TopographyError};

/// Pixel sizes of aligned scans agree to this share: text files round them.
const SAME_PIXEL: f64 = 1e-6;

/// Which points of two scans meet. The heights of each scan are positive away from its body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Alignment {
    /// Points of equal row and column: the second scan is stated in the coordinates of the first.
    AsRead,
    /// The second scan was taken from above, as the first, and is turned over about the direction
    /// of its columns: each of its rows is reversed.
    Mirrored,
}

named!(Alignment, "aligned");

impl Topography {
    /// The rough surface whose gap to a flat is the gap between this surface and `other`: the sum
    /// of their heights, with a point missing where either has none. It is periodic if both are.
    ///
    /// # Errors
    /// [`TopographyError::Content`] if numbers of points or pixel sizes differ.
    pub fn facing(&self, other: &Self, alignment: Alignment) -> Result<Self, TopographyError> {
        let grid = |of: &Self| {
            let [dx, dy] = of.pixel_size();
            format!("{} x {} points of {dx:e} x {dy:e} m", of.rows(), of.columns())
        };
        let [one, two] = [self.pixel_size(), other.pixel_size()];
        let apart = |(a, b): (&f64, f64)| (a - b).abs() > SAME_PIXEL * a;
        let shape = |of: &Self| [of.rows(), of.columns()];
        if shape(self) != shape(other) || one.iter().zip(two).any(apart) {
            let required = format!("{}, as of the first scan", grid(self));
            return Err(refuse("second scan", grid(other), required));
        }
        let columns = self.columns();
        let rows = self.heights().chunks(columns).zip(other.heights().chunks(columns));
        let heights = rows.flat_map(|(one, two)| {
            (0..columns).map(move |k| match alignment {
                Alignment::AsRead => one[k] + two[k],
                Alignment::Mirrored => one[k] + two[columns - 1 - k],
            })
        });
        let both = Self::new(heights.collect(), columns, one)?;
        let outliers = match (&self.outliers, &other.outliers) {
            (None, None) => None,
            // A filter has spread them.
            _ => {
                let [a, b] = [self, other].map(|of| of.moments().map(|moments| moments.profile.m4));
                let (a, b) = (a?, b?);
                let weight = if a + b > 0.0 { a / (a + b) } else { 0.5 };
                Some(Arc::new(self.outliers().plus(&other.outliers(), weight)))
            }
        };
        Ok(Self {
            periodic: self.periodic && other.periodic,
            filled: (self.filled + other.filled).min(both.measured()),
            despiked: self.despiked + other.despiked,
            outliers,
            notes: [&self.notes[..], &other.notes].concat(),
            ..both
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PIXEL: [f64; 2] = [1e-6, 2e-6];

    fn scan(heights: &[f64]) -> Topography {
        Topography::new(heights.to_vec(), 3, PIXEL).unwrap()
    }

    #[test]
    fn heights_add_point_by_point_or_mirrored_and_missing_points_stay() {
        let one = scan(&[1.0, 2.0, 3.0, 4.0, f64::NAN, 6.0]).with_periodic(true);
        let two = scan(&[10.0, 20.0, 30.0, 40.0, 50.0, f64::NAN]);
        let sum = one.facing(&two, Alignment::AsRead).unwrap();
        assert_eq!(sum.heights()[..4], [11.0, 22.0, 33.0, 44.0]);
        assert!(sum.heights()[4..].iter().all(|z| z.is_nan()) && !sum.is_periodic());
        let turned = one.facing(&two, Alignment::Mirrored).unwrap();
        assert_eq!(turned.heights()[..3], [31.0, 22.0, 13.0]);
        assert_eq!(turned.heights()[5..], [46.0]);
        assert!(turned.heights()[3].is_nan() && turned.heights()[4].is_nan());
        assert!(one.facing(&one, Alignment::AsRead).unwrap().is_periodic());
    }

    #[test]
    fn scans_of_different_points_or_pixels_are_refused() {
        let one = scan(&[0.0, 1.0, 2.0, 0.0, 1.0, 0.0]);
        let narrow = Topography::new(one.heights().to_vec(), 2, PIXEL).unwrap();
        let coarse = Topography::new(one.heights().to_vec(), 3, [1.1e-6, 2e-6]).unwrap();
        assert!(one.facing(&narrow, Alignment::AsRead).is_err());
        assert!(one.facing(&coarse, Alignment::AsRead).is_err());
        let rounded = Topography::new(one.heights().to_vec(), 3, [1.000_000_4e-6, 2e-6]).unwrap();
        assert!(one.facing(&rounded, Alignment::AsRead).is_ok());
    }
}
