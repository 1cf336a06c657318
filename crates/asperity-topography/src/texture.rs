//! The anisotropy of a surface, from the second moments of its slopes.

use crate::Topography;

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

impl Topography {
    /// The principal axes of the tensor ⟨z_x z_x⟩, ⟨z_x z_y⟩, ⟨z_y z_y⟩ of the slopes in the middle
    /// of every square of four measured points; `None` without such squares or slopes.
    #[must_use]
    pub fn texture(&self) -> Option<Texture> {
        let [mut xx, mut xy, mut yy, mut n] = [0.0; 4];
        let [dx, dy] = self.pixel_size();
        self.squares(|[[a, b], [c, d]]| {
            let x = 0.5 * (b - a + d - c) / dx;
            let y = 0.5 * (c - a + d - b) / dy;
            xx += x * x;
            xy += x * y;
            yy += y * y;
            n += 1.0;
        });
        let (mean, half) = (0.5 * (xx + yy) / n, (0.5 * (xx - yy)).hypot(xy) / n);
        let across = mean + half;
        // The difference would cancel.
        let along = (xx * yy - xy * xy).max(0.0) / (n * n) / across;
        let turned = 0.5 * xy.atan2(0.5 * (xx - yy)).to_degrees();
        let direction = if turned > 0.0 { turned - 90.0 } else { turned + 90.0 };
        let found = Texture { slope_along: along.sqrt(), slope_across: across.sqrt(), direction };
        (across > 0.0).then_some(found)
    }

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

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    /// Two waves at right angles, the second along the direction of the lay.
    fn crossed(degrees: f64, [across, along]: [f64; 2]) -> Texture {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let n = 400;
        let height = |k: usize| {
            let (x, y) = (0.2 * (k % n) as f64, 0.2 * (k / n) as f64);
            across * (y * cos - x * sin).cos() + along * (x * cos + y * sin).cos()
        };
        let surface = Topography::new((0..n * n).map(height).collect(), n, [0.2, 0.2]).unwrap();
        surface.texture().unwrap()
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
        let found = grooves.texture().unwrap();
        assert!(found.ratio().is_none() && (found.direction - 90.0).abs() < 1e-9, "{found:?}");
        assert!(Topography::new(vec![0.0; 16], 4, [1.0; 2]).unwrap().texture().is_none());
        assert!(Topography::new(vec![0.0, 1.0], 2, [1.0; 2]).unwrap().texture().is_none());
    }
}
