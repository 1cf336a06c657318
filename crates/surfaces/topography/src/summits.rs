//! Summits, points above their eight neighbours, and the density of their heights.

use asperity_core::Surface;
use nalgebra::{Matrix2, Vector2};
use serde::Serialize;

use crate::error::refuse;
use crate::topography::extremes;
use crate::{Topography, TopographyError};

/// The least number of summits for a meaningful standard deviation.
const FEWEST: usize = 10;
/// The largest distance of a summit from the top of its quadric, along rows and columns \[points\].
const FARTHEST: f64 = 1.0;

/// The summits of a surface.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Summits {
    /// Heights \[m\] in the surface.
    pub heights: Vec<f64>,
    /// Mean of the two principal curvatures at each \[1/m\], positive for a peak.
    pub curvatures: Vec<f64>,
    /// The area searched \[m²\]: a cell for each point with all its neighbours.
    pub area: f64,
}

impl Summits {
    /// The asperities of these summits: η is their number per area, R one over their mean
    /// curvature, and σ_z the standard deviation of their heights.
    ///
    /// # Errors
    /// [`TopographyError::Content`] for fewer than 10 summits; [`TopographyError::Contact`] when
    /// their heights are all equal or their mean curvature is not positive.
    pub fn surface(&self) -> Result<Surface, TopographyError> {
        let found = self.heights.len();
        if found < FEWEST {
            return Err(refuse("summits", found, format_args!("at least {FEWEST}")));
        }
        let n = found as f64;
        let mean = self.mean();
        let variance = self.heights.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n;
        let curvature = self.curvatures.iter().sum::<f64>() / n;
        let surface = Surface::new(1.0 / curvature, n / self.area, variance.sqrt());
        surface.check()?;
        Ok(surface)
    }

    /// Mean of the heights \[m\]; NaN without summits.
    #[must_use]
    pub fn mean(&self) -> f64 {
        self.heights.iter().sum::<f64>() / self.heights.len() as f64
    }

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
        let [lowest, highest] = extremes(&self.heights);
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

impl Topography {
    /// The summits: points above their eight neighbours; of equal neighbours, the last in reading
    /// order. The least-squares quadric through the nine points has its top within one point of
    /// them along rows and columns: a ridge askew to the rows has more points above their
    /// neighbours than summits. The curvature is that of the quadric: for asperities of few points,
    /// it is smaller than the second difference of [`Topography::moments`]. Points at the edge or
    /// next to a missing one are not searched.
    ///
    /// # Errors
    /// [`TopographyError::SummitsOfProfile`] for a profile.
    pub fn summits(&self) -> Result<Summits, TopographyError> {
        if self.is_profile() {
            return Err(TopographyError::SummitsOfProfile);
        }
        let [dx, dy] = self.pixel_size();
        let (mut heights, mut curvatures) = (Vec::new(), Vec::new());
        let searched = self.search(1, |lines| {
            let columns = [0, 1, 2].map(|i| lines.map(|line| line[i]));
            let mean = |of: [[f64; 3]; 3], weights: [f64; 3]| {
                of.iter().flatten().zip(weights.iter().cycle()).map(|(z, w)| z * w / 3.0).sum()
            };
            let [xx, yy]: [f64; 2] = [lines, columns].map(|of| mean(of, [1.0, -2.0, 1.0]));
            let [x, y] = [lines, columns].map(|of| mean(of, [-0.5, 0.0, 0.5]));
            let [up, _, down] = lines;
            let xy = 0.25 * (up[0] - up[2] - down[0] + down[2]);
            let bend = Matrix2::new(-xx, -xy, -xy, -yy).cholesky();
            if bend.is_some_and(|bend| bend.solve(&Vector2::new(x, y)).amax() <= FARTHEST) {
                heights.push(lines[1][1]);
                curvatures.push(-0.5 * (xx / (dx * dx) + yy / (dy * dy)));
            }
        });
        Ok(Summits { heights, curvatures, area: searched as f64 * dx * dy })
    }

    /// Summits per area \[1/m²\] of points `step` apart, averaged over all grids of such points.
    pub(crate) fn summit_density(&self, step: usize) -> Option<f64> {
        let [dx, dy] = self.pixel_size();
        let mut found = 0usize;
        let searched = self.search(step, |_| found += 1);
        let cell = (step * step) as f64 * dx * dy;
        (searched > 0).then(|| found as f64 / (searched as f64 * cell))
    }

    /// Calls `found` with each summit and its neighbours `step` away; returns the number of points
    /// with all their neighbours.
    fn search(&self, step: usize, mut found: impl FnMut([[f64; 3]; 3])) -> usize {
        let mut searched = 0;
        let measured = |nine: &[[f64; 3]; 3]| !nine.iter().flatten().any(|z| z.is_nan());
        for nine in self.windows(step).flatten().filter(measured) {
            searched += 1;
            let [[p, q, r], [s, z, t], [u, v, w]] = nine;
            let above_earlier = z >= p && z >= q && z >= r && z >= s;
            if above_earlier && z > t && z > u && z > v && z > w {
                found(nine);
            }
        }
        searched
    }
}

/// A density of heights, linear between its points and 0 outside; its integral is 1.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct HeightDensity {
    /// Heights \[m\] above the mean of the asperity heights, ascending.
    pub heights_m: Vec<f64>,
    /// Density at these heights \[1/m\]; 0 at the first and the last.
    pub density_per_m: Vec<f64>,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos x + cos y with `waves` periods each way over n × n points of 1 µm: waves² peaks.
    fn egg_box(n: usize, waves: f64, height: f64) -> Topography {
        let turn = std::f64::consts::TAU * waves / n as f64;
        let z = |i: usize| height * ((turn * (i % n) as f64).cos() + (turn * (i / n) as f64).cos());
        Topography::new((0..n * n).map(z).collect(), n, [1e-6; 2]).unwrap().with_periodic(true)
    }

    #[test]
    fn the_peaks_of_an_egg_box_are_found() {
        let summits = egg_box(120, 6.0, 1e-7).summits().unwrap();
        assert_eq!(summits.heights.len(), 36);
        assert!(summits.heights.iter().all(|z| (z / 2e-7 - 1.0).abs() < 1e-12));
        // The quadric through nine points of two cosines has their second differences: averaging
        // over three lines does not change that of either wave.
        let (k, dx) = (std::f64::consts::TAU / 20.0, 1e-6);
        let expected = 1e-7 * 2.0 * (1.0 - k.cos()) / (dx * dx);
        assert!(summits.curvatures.iter().all(|c| (c / expected - 1.0).abs() < 1e-9));
        assert!((summits.area / 14400e-12 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_plateau_is_one_summit_and_a_flat_surface_has_none() {
        let mut heights = vec![0.0; 49];
        assert!(
            Topography::new(heights.clone(), 7, [1.0; 2])
                .unwrap()
                .summits()
                .unwrap()
                .heights
                .is_empty()
        );
        for i in [24, 25, 31, 32] {
            heights[i] = 1.0;
        }
        let summits = Topography::new(heights.clone(), 7, [1.0; 2]).unwrap().summits().unwrap();
        assert_eq!(summits.heights, [1.0]);
        heights[33] = f64::NAN;
        let surface = Topography::new(heights, 7, [1.0; 2]).unwrap();
        let summits = surface.summits().unwrap();
        assert!(summits.heights.is_empty());
        assert!((summits.area - 19.0).abs() < 1e-12, "{}", summits.area);
    }

    #[test]
    fn few_summits_and_profiles_are_refused() {
        let few = egg_box(40, 2.0, 1.0).summits().unwrap().surface();
        assert_eq!(few.unwrap_err().to_string(), "summits: 4; required: at least 10");
        let profile = Topography::new(vec![0.0, 1.0, 0.0], 3, [1.0; 2]).unwrap();
        assert!(matches!(profile.summits(), Err(TopographyError::SummitsOfProfile)));
    }

    #[test]
    fn noise_has_a_summit_in_nine_points_at_any_sampling() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) as f64 * 1e-9
        };
        let noise = (0..90_000).map(|_| next()).collect();
        let noise = Topography::new(noise, 300, [1.0; 2]).unwrap().with_periodic(true);
        let fine = noise.summit_density(1).unwrap();
        assert!((fine * 9.0 - 1.0).abs() < 0.02, "{fine}");
        assert!((noise.summit_density(2).unwrap() * 36.0 - 1.0).abs() < 0.02);
    }

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
