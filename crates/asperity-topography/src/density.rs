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
    /// bins of equal width, joined by lines from middle to middle. Its integral is 1 and its mean
    /// 0. The width is 2.15 σ_z n^(-1/5), which makes the mean squared error of a polygon smallest
    /// for n Gaussian heights (Scott 1985). \[recalled\]
    ///
    /// # Errors
    /// [`TopographyError`] as in [`Summits::surface`].
    pub fn height_density(&self) -> Result<HeightDensity, TopographyError> {
        let std = self.surface()?.asperity_height_std;
        let n = self.heights.len() as f64;
        let width = 2.15 * std * n.powf(-0.2);
        let highest = self.heights.iter().copied().fold(f64::MIN, f64::max);
        let lowest = self.heights.iter().copied().fold(f64::MAX, f64::min);
        // By Chebyshev no height is further than σ_z √n from the mean: at most n bins, about.
        let bins = ((highest - lowest) / width).floor() as usize + 1;
        let first = 0.5 * (lowest + highest - width * bins as f64);
        let mut counts = vec![0usize; bins + 2];
        for height in &self.heights {
            let bin = ((height - first) / width) as usize;
            counts[1 + bin.min(bins - 1)] += 1;
        }
        let density_per_m: Vec<f64> =
            counts.iter().map(|count| *count as f64 / (n * width)).collect();
        // Counts stand at the middles of their bins; the mean of the polygon is theirs.
        let middle = |bin: usize| first + (bin as f64 - 0.5) * width;
        let binned = (0..counts.len()).map(|bin| middle(bin) * counts[bin] as f64).sum::<f64>() / n;
        let heights_m = (0..counts.len()).map(|bin| middle(bin) - binned).collect();
        Ok(HeightDensity { heights_m, density_per_m })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_polygon_has_area_one_mean_zero_and_the_spread_of_its_heights() {
        // Quantiles of an exponential density: skew, and known.
        let heights: Vec<f64> =
            (0..4000).map(|i| -1e-6 * (1.0 - (f64::from(i) + 0.5) / 4000.0).ln()).collect();
        let summits = Summits { curvatures: vec![1.0; heights.len()], heights, area: 1.0 };
        let HeightDensity { heights_m: z, density_per_m: g } = summits.height_density().unwrap();
        assert!(g[0].abs() + g[g.len() - 1].abs() < f64::MIN_POSITIVE);
        let (mut area, mut mean, mut square) = (0.0, 0.0, 0.0);
        for i in 1..z.len() {
            let width = z[i] - z[i - 1];
            assert!(width > 0.0);
            area += 0.5 * width * (g[i] + g[i - 1]);
            // Exact for a linear density between two heights.
            let (a, b) = (z[i - 1], z[i]);
            mean += width / 6.0 * (g[i - 1] * (2.0 * a + b) + g[i] * (a + 2.0 * b));
            let cubic = |f: f64, h: f64| f * h * h;
            let centre = cubic(0.5 * (g[i] + g[i - 1]), 0.5 * (a + b));
            square += width / 6.0 * (cubic(g[i - 1], a) + 4.0 * centre + cubic(g[i], b));
        }
        assert!((area - 1.0).abs() < 1e-12, "{area}");
        assert!(mean.abs() < 1e-15, "{mean:e}");
        // Binning widens a density by a quarter of a bin width squared at most.
        assert!((square.sqrt() / 1e-6 - 1.0).abs() < 0.05, "{:e}", square.sqrt());
    }
}
