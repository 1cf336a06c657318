//! Height and hybrid parameters of ISO 25178-2.

use crate::topography::extremes;
use crate::{Topography, TopographyError};

/// Height and hybrid parameters of ISO 25178-2, of heights about their mean.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Parameters {
    /// Sq \[m\]: standard deviation.
    pub sq: f64,
    /// Sa \[m\]: mean distance from the mean.
    pub sa: f64,
    /// Sz \[m\]: from the lowest to the highest point.
    pub sz: f64,
    /// Sp \[m\]: the highest point.
    pub sp: f64,
    /// Sv \[m\]: the depth of the lowest point.
    pub sv: f64,
    /// Ssk: ⟨z³⟩/Sq³.
    pub ssk: f64,
    /// Sku: ⟨z⁴⟩/Sq⁴.
    pub sku: f64,
    /// Sdq: the rms gradient, √(⟨z_x²⟩ + ⟨z_y²⟩), of differences between neighbours; along the row
    /// for a profile.
    pub sdq: f64,
    /// Sdr: the developed area over the nominal one, less 1 (0.02 is 2 %), of both pairs of
    /// triangles in every square of four points; of the length for a profile. `None` where no four
    /// neighbours are measured.
    pub sdr: Option<f64>,
}

impl Topography {
    /// The parameters of the surface, which should be [levelled](Self::level) and filtered:
    /// they are those of the surface as it is.
    ///
    /// # Errors
    /// [`TopographyError::Flat`] when all heights are equal; as [`Topography::moments`].
    pub fn parameters(&self) -> Result<Parameters, TopographyError> {
        let mean = self.mean();
        let m0 = self.central_moment(mean, 2);
        if m0 <= 0.0 {
            return Err(TopographyError::Flat { points: self.measured() });
        }
        let moments = self.moments()?;
        let sq = m0.sqrt();
        let measured = || self.heights().iter().filter(|z| !z.is_nan()).map(|z| z - mean);
        let [low, high] = extremes(self.heights());
        let (sp, sv) = (high - mean, mean - low);
        let sa = measured().map(f64::abs).sum::<f64>() / self.measured() as f64;
        let across = moments.along_columns.map_or(0.0, |[m2, _]| m2);
        Ok(Parameters {
            sq,
            sa,
            sz: sp + sv,
            sp,
            sv,
            ssk: self.central_moment(mean, 3) / (m0 * sq),
            sku: self.central_moment(mean, 4) / (m0 * m0),
            sdq: (moments.along_rows[0] + across).sqrt(),
            sdr: self.developed(),
        })
    }

    fn developed(&self) -> Option<f64> {
        let [dx, dy] = self.pixel_size();
        // √(1 + s) - 1 without cancellation.
        let excess = |square: f64| square / (1.0 + (1.0 + square).sqrt());
        let found = match self.is_profile() {
            true => self.means(1, |[[a, b]]| [excess(((b - a) / dx).powi(2))]),
            false => self.means(1, |[[a, b], [c, d]]| {
                let [top, bottom, left, right] =
                    [(b - a) / dx, (d - c) / dx, (c - a) / dy, (d - b) / dy]
                        .map(|slope| slope * slope);
                let corners = [top + left, top + right, bottom + left, bottom + right];
                [0.25 * corners.into_iter().map(excess).sum::<f64>()]
            }),
        };
        found.map(|[mean]| mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flat_surfaces_are_refused_and_missing_points_left_out() {
        assert!(Topography::new(vec![1.0; 9], 3, [1.0; 2]).unwrap().parameters().is_err());
        let heights = vec![0.0, 1.0, 0.0, 1.0, f64::NAN, 1.0, 0.0, 1.0, 0.0, 3.0, 2.0, 0.0];
        let found = Topography::new(heights, 3, [1.0; 2]).unwrap().parameters().unwrap();
        assert!((found.sz - 3.0).abs() < 1e-12);
        let tilted = (0..12).map(|k| 0.75 * f64::from(k % 3)).collect();
        let found = Topography::new(tilted, 3, [1.0; 2]).unwrap().parameters().unwrap();
        // A plane of slope 3/4.
        assert!((found.sdr.unwrap() - 0.25).abs() < 1e-12 && (found.sdq - 0.75).abs() < 1e-12);
    }
}
