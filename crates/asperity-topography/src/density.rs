//! The measured density of asperity heights.

use serde::Serialize;

use crate::{Summits, Topography, TopographyError};

/// A density of heights, linear between its points and 0 outside; its integral is 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct HeightDensity {
    /// Heights \[m\] above the mean of the asperity heights, ascending.
    pub heights_m: Vec<f64>,
    /// Density at these heights \[1/m\]; 0 at the first and the last.
    pub density_per_m: Vec<f64>,
}

impl Topography {
    /// The density of the summits' heights; see [`Summits::height_density`].
    ///
    /// # Errors
    /// As [`Topography::summits`] and [`Summits::height_density`].
    pub fn height_density(&self) -> Result<HeightDensity, TopographyError> {
        self.summits()?.height_density()
    }
}

impl Summits {
    /// The density of the summits' heights about their mean, as a frequency polygon: counts in
    /// bins of equal width, joined by lines from middle to middle. Its integral is 1, its mean 0
    /// and its standard deviation σ_z. The width is 2.15 σ_z n^(-1/5), which makes the mean
    /// squared error of a polygon smallest for n Gaussian heights (Scott 1985). \[recalled\]
    ///
    /// # Errors
    /// [`TopographyError`] as in [`Summits::surface`].
    pub fn height_density(&self) -> Result<HeightDensity, TopographyError> {
        let std = self.surface()?.asperity_height_std;
        let n = self.heights.len() as f64;
        let width = 2.15 * std * n.powf(-0.2);
        let highest = self.heights.iter().copied().fold(f64::MIN, f64::max);
        let lowest = self.heights.iter().copied().fold(f64::MAX, f64::min);
        // No height is further than σ_z √n from the mean, so there are fewer than n bins.
        let bins = ((highest - lowest) / width).floor() as usize + 1;
        let first = 0.5 * (lowest + highest - width * bins as f64);
        let mut counts = vec![0usize; bins + 2];
        for height in &self.heights {
            let bin = ((height - first) / width) as usize;
            counts[1 + bin.min(bins - 1)] += 1;
        }
        let middle = |bin: usize| first + (bin as f64 - 0.5) * width;
        let sum = |term: &dyn Fn(f64) -> f64| {
            counts.iter().enumerate().map(|(i, count)| *count as f64 * term(middle(i))).sum::<f64>()
        };
        let mean = sum(&|z| z) / n;
        // A count stands for a triangle of half-width `width`. Bins and triangles widen the
        // density; scaling the heights restores σ_z.
        let variance = sum(&|z| (z - mean).powi(2)) / n + width * width / 6.0;
        let scale = std / variance.sqrt();
        let heights_m = (0..counts.len()).map(|bin| scale * (middle(bin) - mean)).collect();
        let density_per_m =
            counts.iter().map(|count| *count as f64 / (n * width * scale)).collect();
        Ok(HeightDensity { heights_m, density_per_m })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polygon_has_area_one_mean_zero_and_the_variance_of_its_heights() {
        // Quantiles of an exponential density, whose skewness is exact.
        let heights: Vec<f64> =
            (0..4000).map(|i| -1e-6 * (1.0 - (f64::from(i) + 0.5) / 4000.0).ln()).collect();
        let n = heights.len() as f64;
        let average = heights.iter().sum::<f64>() / n;
        let variance = heights.iter().map(|z| (z - average).powi(2)).sum::<f64>() / n;
        let summits = Summits { curvatures: vec![1.0; heights.len()], heights, area: 1.0 };
        let HeightDensity { heights_m: z, density_per_m: g } = summits.height_density().unwrap();
        assert!(g[0].abs() + g[g.len() - 1].abs() < f64::MIN_POSITIVE);
        let (mut area, mut mean, mut square) = (0.0, 0.0, 0.0);
        for i in 1..z.len() {
            let width = z[i] - z[i - 1];
            assert!(width > 0.0);
            area += 0.5 * width * (g[i] + g[i - 1]);
            // Simpson's rule is exact for cubics.
            let centre = [0.5 * (z[i - 1] + z[i]), 0.5 * (g[i - 1] + g[i])];
            for ([z, g], weight) in
                [[z[i - 1], g[i - 1]], centre, [z[i], g[i]]].iter().zip([1.0, 4.0, 1.0])
            {
                mean += weight * width / 6.0 * g * z;
                square += weight * width / 6.0 * g * z * z;
            }
        }
        assert!((area - 1.0).abs() < 1e-12, "{area}");
        assert!(mean.abs() < 1e-15, "{mean:e}");
        assert!((square / variance - 1.0).abs() < 1e-12, "{square:e} {variance:e}");
        // An exponential density is skewed to the right.
        let highest = g.iter().copied().fold(0.0, f64::max);
        let top = g.iter().position(|density| *density >= highest).unwrap();
        assert!(z[top] < -5e-7 && z[z.len() - 1] > 4e-6);
    }
}
