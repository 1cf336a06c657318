//! Spectral moments of profiles, from differences of neighbouring points.

use asperity_core::ProfileMoments;

use crate::error::refuse;
use crate::{Topography, TopographyError};

/// The spectral moments of a surface: of profiles averaged over all directions, and along the axes.
///
/// ```text
/// m₂ = ½ (⟨z_x²⟩ + ⟨z_y²⟩) = ½ ⟨q²⟩        m₄ = ⅜ (⟨z_xx²⟩ + 2 ⟨z_xy²⟩ + ⟨z_yy²⟩) = ⅜ ⟨q⁴⟩
/// ```
/// of the differences z_x = (z₁ - z₀)/dx of all pairs of measured neighbours, z_xx = (z₂ - 2 z₁ +
/// z₀)/dx² of all triples and z_xy = (z₁₁ - z₁₀ - z₀₁ + z₀₀)/(dx dy) of all squares and pairs of
/// squares. Turning a surface changes neither \[derived\]; those of an isotropic surface are those
/// of each profile, and m₂ and m₄ of a single profile those along it. Sampling reduces the slope of
/// a wave of length L by the factor s = sin(π dx/L)/(π dx/L) and its curvature by s²: by 1.6 % and
/// 3.3 % at ten points per wave.
/// \[derived\] The forward difference is consistent with this second difference; the central one
/// would reduce the slopes of short waves more than their curvatures.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Moments {
    /// m₀, m₂ and m₄ of profiles, averaged over all directions.
    pub profile: ProfileMoments,
    /// ⟨z_x²⟩ and ⟨z_xx²⟩ \[1/m²\] along rows.
    pub along_rows: [f64; 2],
    /// ⟨z_y²⟩ and ⟨z_yy²⟩ \[1/m²\] along columns; a profile has none.
    pub along_columns: Option<[f64; 2]>,
    /// ⟨z_x²⟩, ⟨z_x z_y⟩ and ⟨z_y²⟩ of the slopes in the middle of every square of four measured
    /// points, which have one place for both directions; a profile has none.
    pub slope_tensor: Option<[f64; 3]>,
    /// ⟨z_x² z⟩ \[m\], with z from the mean height, averaged over both directions: above 0 where
    /// peaks are steeper than valleys.
    pub slope_height: f64,
}

impl Moments {
    /// The moments of an isotropic Gaussian surface with these moments of profiles.
    #[must_use]
    pub fn isotropic(profile: ProfileMoments) -> Self {
        let direction = [profile.m2, profile.m4];
        Self {
            profile,
            along_rows: direction,
            along_columns: Some(direction),
            slope_tensor: Some([profile.m2, 0.0, profile.m2]),
            slope_height: 0.0,
        }
    }

    /// The moments of the gap between two independent surfaces: the sums.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        fn add<const N: usize>(a: [f64; N], b: [f64; N]) -> [f64; N] {
            std::array::from_fn(|k| a[k] + b[k])
        }
        Self {
            profile: self.profile.plus(&other.profile),
            along_rows: add(self.along_rows, other.along_rows),
            along_columns: self.along_columns.zip(other.along_columns).map(|(a, b)| add(a, b)),
            slope_tensor: self.slope_tensor.zip(other.slope_tensor).map(|(a, b)| add(a, b)),
            slope_height: self.slope_height + other.slope_height,
        }
    }

    /// The skewness of the surface z = exp(s x), x Gaussian, whose squared slopes are correlated
    /// with its heights as those of this one; 0 for a flat surface. Of a few long waves it scatters
    /// much less about that of the process than Ssk does, since short waves have most slopes.
    ///
    /// With t = exp(s²), ⟨z_x² z⟩/(m₂ √m₀) = (t + 1) √(t - 1), and the skewness is
    /// (t + 2) √(t - 1) \[derived\].
    #[must_use]
    pub fn slope_skewness(&self) -> f64 {
        let ProfileMoments { m0, m2, .. } = self.profile;
        let unit = m2 * m0.sqrt();
        let correlation = if unit > 0.0 { self.slope_height / unit } else { 0.0 };
        // The root of u³ + 2 u = correlation, u = √(t - 1) with the sign of the skewness.
        let wide = (8.0 / 3.0f64).sqrt();
        let root = wide * ((3.0 * correlation / (2.0 * wide)).asinh() / 3.0).sinh();
        correlation + root
    }

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

impl Topography {
    /// The spectral moments of the surface; m₀ is about the mean height.
    ///
    /// # Errors
    /// [`TopographyError::Content`] when a direction has no three measured neighbours in a row.
    pub fn moments(&self) -> Result<Moments, TopographyError> {
        let mean = self.mean();
        let m0 = self.central_moment(mean, 2);
        let of = |axis: usize, what| match self.along(axis, 1, mean) {
            (Some([slope, of_height]), Some(curvature)) => Ok(([slope, curvature], of_height)),
            (slope, _) => {
                Err(refuse(what, 1 + usize::from(slope.is_some()), "at least 3 in a row"))
            }
        };
        let (along_rows, slope_height) = of(0, "measured neighbours along rows")?;
        let [m2, m4] = along_rows;
        let profile = ProfileMoments { m0, m2, m4 };
        let mut found =
            Moments { profile, along_rows, along_columns: None, slope_tensor: None, slope_height };
        if self.is_profile() {
            return Ok(found);
        }
        let (along_columns, of_height) = of(1, "measured neighbours along columns")?;
        let [slope, curvature] = along_columns;
        found.slope_height = 0.5 * (slope_height + of_height);
        // Between holes without two squares side by side, that of an isotropic surface.
        let twist = self.twist().unwrap_or((m4 + curvature) / 6.0);
        found.profile.m2 = 0.5 * (m2 + slope);
        found.profile.m4 = 0.375 * (m4 + 2.0 * twist + curvature);
        let [dx, dy] = self.pixel_size();
        found.along_columns = Some(along_columns);
        found.slope_tensor = self.means(1, |[[a, b], [c, d]]| {
            let [x, y] = [0.5 * (b - a + d - c) / dx, 0.5 * (c - a + d - b) / dy];
            [x * x, x * y, y * y]
        });
        Ok(found)
    }

    /// ⟨z_xy²⟩ = ⅔ ⟨t²⟩ + ⅙ ⟨t t'⟩ + ⅙ ⟨t t"⟩ of the twist t of squares, that t' of the next one
    /// along the row and t" of that along the column: sampling reduces the sum as it does z_xx²,
    /// and of white noise it is a third of that, as of every isotropic surface.
    fn twist(&self) -> Option<f64> {
        let [dx, dy] = self.pixel_size();
        let twist = |a: f64, b: f64, c: f64, d: f64| (d - c - b + a) / (dx * dy);
        let [own] = self.means(1, |[[a, b], [c, d]]| [twist(a, b, c, d).powi(2)])?;
        let [right] =
            self.means(1, |[[a, b, e], [c, d, f]]| [twist(a, b, c, d) * twist(b, e, d, f)])?;
        let [down] =
            self.means(1, |[[a, b], [c, d], [e, f]]| [twist(a, b, c, d) * twist(c, d, e, f)])?;
        Some((4.0 * own + right + down) / 6.0)
    }

    /// ⟨(z - mean)^power⟩ \[m^power\].
    pub(crate) fn central_moment(&self, mean: f64, power: i32) -> f64 {
        let row_sum = |row: &[f64]| {
            let there = row.iter().filter(|height| !height.is_nan());
            there.map(|height| (height - mean).powi(power)).sum::<f64>()
        };
        self.heights().chunks(self.columns()).map(row_sum).sum::<f64>() / self.measured() as f64
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wave_has_the_same_moments_in_every_direction() {
        let n = 256;
        // Of 25 waves on the side: (25, 0), (24, 7), (20, 15), (15, 20).
        for (p, q) in [(25.0, 0.0), (24.0, 7.0), (20.0, 15.0), (15.0, 20.0), (0.0, 25.0)] {
            let turn = std::f64::consts::TAU / f64::from(n);
            let height =
                |k: i32| 1e-7 * (turn * (p * f64::from(k % n) + q * f64::from(k / n))).cos();
            let surface =
                Topography::new((0..n * n).map(height).collect(), 256, [1e-6; 2]).unwrap();
            let ProfileMoments { m2, m4, .. } =
                surface.with_periodic(true).moments().unwrap().profile;
            // A difference of a wave of phase k per pixel is a wave 2 sin(k/2) as high.
            let square = |waves: f64| (2.0 * (0.5 * turn * waves).sin() / 1e-6).powi(2);
            let sum = square(p) + square(q);
            assert!((m2 / (0.25e-14 * sum) - 1.0).abs() < 1e-9, "{p} {q}");
            // Of the product of both, pairs of squares take a twelfth of the sum.
            let twist = 2.0 * square(p) * square(q) * (1.0 - 1e-12 * sum / 12.0);
            let fourth = square(p).powi(2) + square(q).powi(2) + twist;
            assert!((m4 / (0.1875e-14 * fourth) - 1.0).abs() < 1e-9, "{p} {q}");
            // Of 10 pixels per wave differences lose 1.6 to 3.3 % of m2 and 4.7 to 6.4 % of m4.
            let exact = (turn * 25.0 / 1e-6).powi(2);
            assert!((0.967..0.985).contains(&(sum / exact)), "{p} {q} {}", sum / exact);
            let fourth = fourth / (exact * exact);
            assert!((0.935..0.955).contains(&fourth), "{p} {q} {fourth}");
        }
    }

    /// 6 of unit noise on unit pixels along each axis: an isotropic surface with this m4 has it.
    #[test]
    fn white_noise_has_the_m4_of_its_profiles() {
        let mut state = 1u64;
        let mut noise = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1u64 << 53) as f64 * 12f64.sqrt()
        };
        let heights: Vec<f64> = (0..256 * 256).map(|_| noise()).collect();
        for periodic in [false, true] {
            let surface = Topography::new(heights.clone(), 256, [1.0; 2]).unwrap();
            let m4 = surface.with_periodic(periodic).moments().unwrap().profile.m4;
            assert!((m4 / 6.0 - 1.0).abs() < 0.02, "{m4}");
        }
    }

    #[test]
    fn steep_peaks_have_the_skewness_of_an_exponential_of_gaussian_heights() {
        for (t, sign) in [(1.002f64, 1.0), (1.09, -1.0), (1.6, 1.0)] {
            let width = sign * (t - 1.0).sqrt();
            let mut of = Moments::isotropic(ProfileMoments { m0: 4e-14, m2: 1e-3, m4: 1e9 });
            of.slope_height = (t + 1.0) * width * 1e-3 * 2e-7;
            let wanted = (t + 2.0) * width;
            assert!((of.slope_skewness() / wanted - 1.0).abs() < 1e-12, "{of:?}");
        }
        // Pairs with a missing point are left out.
        let steps =
            vec![0.0, 1.0, f64::NAN, f64::NAN, 1.0, 1.0, 1.0, 4.0, -1.0, 1.0, 1.0, f64::NAN];
        let found = Topography::new(steps, 12, [1.0; 2]).unwrap().moments().unwrap();
        let heights = [0.0, 1.0, 1.0, 1.0, 1.0, 4.0, -1.0, 1.0, 1.0];
        let mean = heights.iter().sum::<f64>() / 9.0;
        let pairs =
            [[0.0, 1.0], [1.0, 1.0], [1.0, 1.0], [1.0, 4.0], [4.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
        let wanted = pairs.iter().map(|[a, b]: &[f64; 2]| (b - a).powi(2) * (0.5 * (a + b) - mean));
        let wanted = wanted.sum::<f64>() / 7.0;
        assert!((found.slope_height - wanted).abs() < 1e-12, "{found:?} {wanted}");
    }

    #[test]
    fn two_rows_have_no_curvature() {
        let error = Topography::new(vec![0.0; 8], 4, [1.0; 2]).unwrap().moments().unwrap_err();
        assert!(error.to_string().contains("along columns"), "{error}");
    }
}
