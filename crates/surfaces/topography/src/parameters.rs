//! Height and hybrid parameters of ISO 25178-2, and of a profile Rz and RSm of ISO 21920-2.

use crate::topography::extremes;
use crate::{Topography, TopographyError};

/// Sections of a profile over which Rz is averaged.
const SECTIONS: usize = 5;
/// The least height of a hill above the mean line, and depth of a dale below it, over Rz.
const LEAST_HEIGHT: f64 = 0.1;
/// The least width of a hill or dale, over the length of a section.
const LEAST_WIDTH: f64 = 0.01;

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

    /// Rz \[m\], the mean over five sections of the height from the lowest to the highest point,
    /// and RSm \[m\], the mean width of the elements, each a hill and a dale \[recalled: from
    /// general knowledge of the standard\]. Hills and dales below 10 % of Rz or 1 % of a section
    /// belong to those before.
    ///
    /// `None` for a surface of several rows, for missing points and for fewer than two points to a
    /// section; no RSm for fewer than two hills.
    pub(crate) fn profile_elements(&self) -> [Option<f64>; 2] {
        let n = self.columns();
        if !self.is_profile() || self.measured() < n || n < 2 * SECTIONS {
            return [None; 2];
        }
        let mean = self.mean();
        let z: Vec<f64> = self.heights().iter().map(|z| z - mean).collect();
        let height = |k: usize| {
            let section = &z[k * n / SECTIONS..(k + 1) * n / SECTIONS];
            let [low, high] = extremes(section);
            high - low
        };
        let rz = (0..SECTIONS).map(height).sum::<f64>() / SECTIONS as f64;
        let starts: Vec<f64> =
            parts(&z, rz).into_iter().filter(|(_, is_hill)| *is_hill).map(|(at, _)| at).collect();
        let rsm = match starts[..] {
            [first, .., last] => {
                Some((last - first) / (starts.len() - 1) as f64 * self.pixel_size()[0])
            }
            _ => None,
        };
        [Some(rz), rsm]
    }
}

/// Hills and dales in turn, small ones with those before, by where they begin, in points, and
/// whether they are hills; the first may have begun earlier and is left out.
fn parts(z: &[f64], rz: f64) -> Vec<(f64, bool)> {
    let width = LEAST_WIDTH * (z.len() / SECTIONS) as f64;
    let crossings = (1..z.len()).filter(|k| (z[k - 1] > 0.0) != (z[*k] > 0.0));
    let crossings: Vec<usize> = crossings.collect();
    let ends = crossings.iter().skip(1).copied().chain([z.len()]);
    let mut parts: Vec<(f64, bool)> = vec![];
    for (start, end) in crossings.iter().copied().zip(ends) {
        let extreme = z[start..end].iter().fold(0.0, |most: f64, z| most.max(z.abs()));
        let is_hill = z[start] > 0.0;
        let is_same = parts.last().is_some_and(|(_, before)| *before == is_hill);
        let at = |k: usize| k as f64 - z[k] / (z[k] - z[k - 1]);
        let is_large = extreme >= LEAST_HEIGHT * rz && (end - start) as f64 >= width;
        if is_large && !is_same {
            parts.push((at(start), is_hill));
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

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

    fn profile(height: impl Fn(f64) -> f64) -> Topography {
        let heights: Vec<f64> = (0..4000).map(|k| 1e-6 * height(f64::from(k))).collect();
        Topography::new(heights, 4000, [0.5e-6; 2]).unwrap()
    }

    #[test]
    fn a_wave_has_its_length_and_height_with_and_without_ripples() {
        let wave = |x: f64| (TAU * (x + 0.3) / 100.0).sin();
        for ripple in [0.0, 0.05] {
            let rough = profile(|x| wave(x) + ripple * (TAU * x / 7.3).sin());
            let [rz, rsm] = rough.profile_elements().map(Option::unwrap);
            let slack = 1e-3 + 0.5 * ripple;
            assert!((rsm / 50e-6 - 1.0).abs() < slack, "{ripple}: {rsm:e}");
            assert!((rz / 2e-6 - 1.0).abs() < 1e-3 + 1.1 * ripple, "{ripple}: {rz:e}");
        }
    }

    #[test]
    fn one_hill_and_surfaces_have_no_width() {
        let step = profile(|x| if (x - 2000.0).abs() < 300.0 { 1.0 } else { 0.0 });
        assert_eq!(step.profile_elements()[1], None);
        let surface = Topography::new(vec![0.0; 100], 10, [1e-6; 2]).unwrap();
        assert_eq!(surface.profile_elements(), [None; 2]);
    }
}
