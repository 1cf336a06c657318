//! A height map: the rigid rough surface.

use crate::BemError;

/// The least map.
const TWO: &str = "a surface of at least 2 x 2 pixels (a profile is one row)";

/// Heights of a surface on a grid of pixels, about their mean plane.
///
/// Heights grow towards the half-space: the highest pixel touches first.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    heights: Vec<f64>,
    shape: [usize; 2],
    pixel: [f64; 2],
}

impl HeightMap {
    /// A map of `shape` = \[rows, columns\], row after row, in metres; `pixel` is the distance of
    /// the rows and of the columns \[m\]. The mean is removed.
    ///
    /// Any sizes from 2 on, odd ones and oblongs too; products of small primes are quickest.
    ///
    /// # Errors
    /// [`BemError::Size`] below 2 rows or columns, [`BemError::Count`] when there are too few or
    /// too many heights, [`BemError::Height`] for a NaN or an infinite height,
    /// [`BemError::OutOfRange`] for a pixel without a positive length.
    pub fn new(
        mut heights: Vec<f64>,
        shape: [usize; 2],
        pixel: [f64; 2],
    ) -> Result<Self, BemError> {
        let [rows, columns] = shape;
        for (field, found) in [("rows", rows), ("columns", columns)] {
            if found < 2 {
                return Err(BemError::Size { field, found, required: TWO });
            }
        }
        let found = heights.len();
        if rows.checked_mul(columns) != Some(found) {
            return Err(BemError::Count { found, rows, columns });
        }
        for (field, found) in
            [("distance of the rows", pixel[0]), ("distance of the columns", pixel[1])]
        {
            positive(field, found)?;
        }
        if let Some(at) = heights.iter().position(|height| !height.is_finite()) {
            return Err(BemError::Height {
                row: at / columns,
                column: at % columns,
                found: heights[at],
            });
        }
        // Relative to the first one, so that equal heights are exactly 0.
        let first = heights[0];
        let mean: f64 = heights.iter().map(|height| (height - first) / found as f64).sum();
        for height in &mut heights {
            *height = *height - first - mean;
        }
        if let Some(&found) = heights.iter().find(|height| !height.is_finite()) {
            let required = "a range of heights that is a finite number";
            return Err(BemError::OutOfRange { field: "height", found, required });
        }
        Ok(Self { heights, shape, pixel })
    }

    /// Heights about their mean \[m\], row after row.
    #[must_use]
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Number of rows and of columns.
    #[must_use]
    pub fn shape(&self) -> [usize; 2] {
        self.shape
    }

    /// Distance of the rows and of the columns \[m\].
    #[must_use]
    pub fn pixel(&self) -> [f64; 2] {
        self.pixel
    }

    /// Area of the map \[m²\].
    #[must_use]
    pub fn area(&self) -> f64 {
        self.heights.len() as f64 * self.pixel[0] * self.pixel[1]
    }

    /// Root mean square height Sq \[m\].
    #[must_use]
    pub fn rms_height(&self) -> f64 {
        let scale = self.highest().max(-self.lowest());
        if scale > 0.0 {
            let squares: f64 = self.heights.iter().map(|height| (height / scale).powi(2)).sum();
            scale * (squares / self.heights.len() as f64).sqrt()
        } else {
            0.0
        }
    }

    /// Height of the highest pixel above the mean \[m\].
    #[must_use]
    pub fn highest(&self) -> f64 {
        self.heights.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same grid with these heights, whose mean is 0.
    pub(crate) fn with_heights(&self, heights: Vec<f64>) -> Self {
        Self { heights, ..*self }
    }

    fn lowest(&self) -> f64 {
        self.heights.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Every second pixel of every second row, on pixels twice as long: solved beside the whole
    /// map it shows how much the answer depends on the grid.
    ///
    /// # Errors
    /// [`BemError::Size`] when a size is odd (its period would change) or below 4.
    pub fn half_grid(&self) -> Result<Self, BemError> {
        let [rows, columns] = self.shape;
        for (field, found) in [("rows", rows), ("columns", columns)] {
            if found < 4 || found % 2 == 1 {
                return Err(BemError::Size {
                    field,
                    found,
                    required: "an even number, at least 4",
                });
            }
        }
        let second_rows = self.heights.chunks(columns).step_by(2);
        let heights = second_rows.flat_map(|row| row.iter().step_by(2).copied()).collect();
        Self::new(heights, [rows / 2, columns / 2], self.pixel.map(|length| 2.0 * length))
    }
}

pub(crate) fn positive(field: &'static str, found: f64) -> Result<f64, BemError> {
    if found > 0.0 && found.is_finite() {
        return Ok(found);
    }
    Err(BemError::OutOfRange { field, found, required: "a positive, finite number" })
}
