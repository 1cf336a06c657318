//! The anisotropy of a surface, from the second moments of its slopes.

use crate::Moments;

/// Principal slopes and the direction of the lay.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Texture {
    /// Rms slope along the lay, the least of all directions.
    pub slope_along: f64,
    /// Rms slope across the lay, the largest.
    pub slope_across: f64,
    /// Direction of the lay \[degrees\], above -90 to 90, from the rows (x) towards the columns
    /// (y). Without meaning where the ratio is near 1.
    pub direction: f64,
}

impl Texture {
    /// Rms slope across the lay over that along it, at least 1: 1 for an isotropic surface;
    /// `None` for grooves, which have no slope along the lay.
    #[must_use]
    pub fn ratio(&self) -> Option<f64> {
        (self.slope_along > 0.0).then(|| self.slope_across / self.slope_along)
    }
}

impl Moments {
    /// The principal axes of the [tensor of the slopes](Self::slope_tensor); `None` for a profile
    /// and without slopes.
    #[must_use]
    pub fn texture(&self) -> Option<Texture> {
        let [xx, xy, yy] = self.slope_tensor?;
        let (mean, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        let across = mean + half;
        // The difference would cancel.
        let along = (xx * yy - xy * xy).max(0.0) / across;
        let turned = 0.5 * xy.atan2(0.5 * (xx - yy)).to_degrees();
        let direction = if turned > 0.0 { turned - 90.0 } else { turned + 90.0 };
        let found = Texture { slope_along: along.sqrt(), slope_across: across.sqrt(), direction };
        (across > 0.0).then_some(found)
    }
}
