//! The Gaussian filter of ISO 16610-21 (profiles) and 16610-61 (areal). \[recalled\]

use std::sync::Arc;

use asperity_core::short;
use asperity_fft::{Complex64, Fft};

use crate::error::out_of_range;
use crate::topography::transposed;
use crate::{Topography, TopographyError};

/// Distance from the centre \[cut-offs\] beyond which the weight is below 1e-16 of its maximum.
const REACH: f64 = 1.63;

impl Topography {
    /// The roughness: the surface without its Gaussian mean surface. Waves much longer than
    /// `cutoff` \[m\] are removed, waves of that length are halved, and shorter ones stay.
    ///
    /// The weight is exp(-π (x/(α λ))²)/(α λ) with α = √(ln 2/π), along rows and along columns
    /// (along the row, for a profile); at edges (unless the surface is periodic) and missing points
    /// the remaining weights are scaled to the sum 1.
    ///
    /// # Errors
    /// [`TopographyError::OutOfRange`] when the cut-off is below two pixels or above the size of
    /// the surface.
    pub fn filter(self, cutoff: f64) -> Result<Self, TopographyError> {
        self.with_mean("filter", cutoff, |height, mean| height - mean)
    }

    /// The Gaussian mean surface, which [`Topography::filter`] removes. Waves much shorter than
    /// `cutoff` \[m\], mostly noise, are removed.
    ///
    /// # Errors
    /// As [`Topography::filter`].
    pub fn smooth(self, cutoff: f64) -> Result<Self, TopographyError> {
        self.with_mean("smooth", cutoff, |height, mean| if height.is_nan() { height } else { mean })
    }

    /// The surface with other heights, from its own and the Gaussian mean.
    fn with_mean(
        mut self,
        field: &'static str,
        cutoff: f64,
        height: fn(f64, f64) -> f64,
    ) -> Result<Self, TopographyError> {
        let mean = self.gaussian_mean(field, cutoff)?;
        self = self.with_outliers_found();
        self.heights.iter_mut().zip(mean).for_each(|(z, mean)| *z = height(*z, mean));
        Ok(self)
    }

    /// The weighted mean about every point \[m\]; undefined where no measured point is in reach.
    /// `field` is the name of the cut-off in errors.
    fn gaussian_mean(
        &self,
        field: &'static str,
        cutoff: f64,
    ) -> Result<impl Iterator<Item = f64> + use<>, TopographyError> {
        let [dx, dy] = self.pixel_size();
        let (columns, rows) = (self.columns(), self.rows());
        let along = |n: usize, step: f64| {
            let (least, largest) = (2.0 * step, n as f64 * step);
            match (least..=largest).contains(&cutoff) {
                true => Ok(Line::new(n, cutoff / step, self.is_periodic())),
                false => {
                    let required = format!(
                        "at least two pixels ({} m) and at most the size of the surface ({} m), in m or with a unit (8um),",
                        short(least),
                        short(largest)
                    );
                    Err(out_of_range(field, cutoff, &required))
                }
            }
        };
        let mean = self.mean();
        // Heights and their weights are real: one complex number holds both. Rounding is relative
        // to the larger part, so heights are scaled by a power of 2, which is exact.
        let largest = self.heights().iter().filter(|height| !height.is_nan());
        let largest = largest.fold(0.0, |largest, z| f64::max(largest, (z - mean).abs()));
        let scale = if largest > f64::MIN_POSITIVE { largest.log2().floor().exp2() } else { 1.0 };
        let there = |height: &f64| match height.is_nan() {
            true => Complex64::new(0.0, 0.0),
            false => Complex64::new((height - mean) / scale, 1.0),
        };
        let mut along_rows = along(columns, dx)?;
        let mut points: Vec<Complex64> = self.heights().iter().map(there).collect();
        points.chunks_mut(columns).for_each(|row| along_rows.convolve(row));
        if !self.is_profile() {
            let mut along_columns = along(rows, dy)?;
            points = transposed(&points, columns);
            points.chunks_mut(rows).for_each(|column| along_columns.convolve(column));
            points = transposed(&points, rows);
        }
        Ok(points.into_iter().map(move |point| mean + scale * (point.re / point.im)))
    }
}

/// Convolution of lines of n points with the Gaussian weight, by FFT.
struct Line {
    forward: Arc<dyn Fft<f64>>,
    inverse: Arc<dyn Fft<f64>>,
    /// Transform of the weight over the length; real, as the weight is even.
    spectrum: Vec<f64>,
    buffer: Vec<Complex64>,
}

impl Line {
    /// The weight of a cut-off in points.
    fn new(n: usize, cutoff: f64, periodic: bool) -> Self {
        let reach = (REACH * cutoff).ceil() as usize;
        // Zeros beyond the line, as far as the weight reaches, keep its ends apart.
        let length = if periodic { n } else { (n + reach.min(n)).next_power_of_two() };
        let (forward, inverse) = (asperity_fft::forward(length), asperity_fft::inverse(length));
        let mut weights = vec![Complex64::default(); length];
        for i in 0..=reach {
            // exp(-π (i/(α λ))²) with π/α² = π²/ln 2.
            let width = std::f64::consts::PI * i as f64 / cutoff;
            let weight = (-width * width / std::f64::consts::LN_2).exp();
            if periodic || i < n {
                weights[i % length] += weight;
                if i > 0 {
                    weights[(length - i % length) % length] += weight;
                }
            }
        }
        forward.process(&mut weights);
        let spectrum = weights.iter().map(|weight| weight.re).collect();
        Self { forward, inverse, spectrum, buffer: vec![Complex64::default(); length] }
    }

    /// Sums over the line, not yet divided by the sum of the weights: the quotient of the two
    /// components is independent of that scale and of the length of the unnormalised transform.
    fn convolve(&mut self, line: &mut [Complex64]) {
        let (points, zeros) = self.buffer.split_at_mut(line.len());
        points.copy_from_slice(line);
        zeros.fill(Complex64::default());
        self.forward.process(&mut self.buffer);
        for (value, weight) in self.buffer.iter_mut().zip(&self.spectrum) {
            *value *= weight;
        }
        self.inverse.process(&mut self.buffer);
        line.copy_from_slice(&self.buffer[..line.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wave_of_the_cutoff_is_halved() {
        let n = 240;
        for (waves, left) in [(12.0_f64, 0.5), (6.0, 1.0 - 0.5f64.powf(0.25)), (24.0, 0.9375)] {
            let turn = std::f64::consts::TAU * waves / n as f64;
            let heights: Vec<f64> = (0..n).map(|x| (turn * x as f64).sin()).collect();
            let profile = Topography::new(heights.clone(), n, [1e-6; 2]).unwrap();
            let rough = profile.with_periodic(true).filter(20e-6).unwrap();
            for (after, before) in rough.heights().iter().zip(&heights) {
                assert!((after - left * before).abs() < 1e-12, "{waves}: {after} {before}");
            }
        }
    }

    #[test]
    fn weights_are_renormalised_at_edges_and_holes() {
        let (columns, rows, cutoff) = (37, 29, 9.0);
        let height = |i: usize| {
            let (x, y) = ((i % columns) as f64, (i / columns) as f64);
            5.0 + (0.3 * x).sin() * (0.2 * y).cos() + 0.1 * x
        };
        let mut heights: Vec<f64> = (0..columns * rows).map(height).collect();
        for hole in [0, 40, 41, 78, 500, columns * rows - 1] {
            heights[hole] = f64::NAN;
        }
        let surface = Topography::new(heights.clone(), columns, [1.0, 1.5]).unwrap();
        let smooth = surface.clone().smooth(cutoff).unwrap();
        let rough = surface.filter(cutoff).unwrap();
        let alpha = (std::f64::consts::LN_2 / std::f64::consts::PI).sqrt();
        for (i, before) in heights.iter().enumerate() {
            let (mut sum, mut weights) = (0.0, 0.0);
            for (j, z) in heights.iter().enumerate().filter(|(_, z)| !z.is_nan()) {
                let x = (i % columns) as f64 - (j % columns) as f64;
                let y = 1.5 * ((i / columns) as f64 - (j / columns) as f64);
                let r2 = (x * x + y * y) / (alpha * cutoff).powi(2);
                let weight = (-std::f64::consts::PI * r2).exp();
                sum += weight * z;
                weights += weight;
            }
            assert_eq!(before.is_nan(), smooth.heights()[i].is_nan());
            if !before.is_nan() {
                assert!((smooth.heights()[i] - sum / weights).abs() < 1e-12);
                assert!((rough.heights()[i] - (before - sum / weights)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn cutoffs_out_of_range_are_refused() {
        let surface = Topography::new(vec![0.0; 100], 10, [1.0; 2]).unwrap();
        for cutoff in [f64::NAN, -1.0, 0.0, 1.9, 10.1, f64::INFINITY] {
            let error = surface.clone().filter(cutoff).unwrap_err().to_string();
            assert!(error.starts_with("filter is") && error.contains("two pixels"), "{error}");
            let error = surface.clone().smooth(cutoff).unwrap_err().to_string();
            assert!(error.starts_with("smooth is"), "{error}");
        }
    }
}
