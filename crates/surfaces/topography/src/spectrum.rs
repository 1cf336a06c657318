//! Power spectra of the heights: radial, along rows and along columns.

use std::borrow::Cow;
use std::f64::consts::{PI, TAU};

use asperity_fft::Complex64;

use crate::error::{at_most, refuse};
use crate::topography::transposed;
use crate::{Topography, TopographyError};

/// Bins in an octave of wave numbers.
const BINS: f64 = 4.0;
/// The most points of a map that is transformed: 256 MiB of waves.
const MOST: usize = 1 << 24;
/// Power below this share of the largest is rounding.
const ROUNDING: f64 = 1e-24;

/// A power spectrum, averaged over bins of a quarter of an octave; bins without power are left out.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct PowerSpectrum {
    /// Wave numbers \[rad/m\], ascending: the mean of those in a bin.
    pub wave_number: Vec<f64>,
    /// Power spectral density, \[m³\] along a direction and \[m⁴\] radially.
    pub density: Vec<f64>,
    /// The wave number \[rad/m\] above which no wave is left; `None` where waves reach down to two
    /// pixels.
    pub end: Option<f64>,
}

/// The spectra of a surface.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Spectra {
    /// C(q) \[m⁴\], averaged over directions, up to π over the larger pixel; Sq² = ∫ C d²q/4π².
    /// `None` for a profile.
    pub radial: Option<PowerSpectrum>,
    /// C(q) \[m³\] of profiles along rows; Sq² = ∫ C dq/π over q > 0.
    pub along_rows: PowerSpectrum,
    /// The same along columns; `None` for a profile.
    pub along_columns: Option<PowerSpectrum>,
    /// The wavelength \[m\] above which half of Sq² lies.
    pub median_wavelength: f64,
}

impl Topography {
    /// Power spectra of the heights about their mean, which should be [levelled](Self::level).
    ///
    /// ```text
    /// C(q) = |Σ w h exp(-i q·x)|² Δx Δy/(n m ⟨w²⟩)         along rows |Σ w h exp(-i q x)|² Δx/(n ⟨w²⟩)
    /// ```
    ///
    /// w is Hann's window, along rows and along columns; 1 for a periodic surface. The definitions
    /// are those of Jacobs, Junge & Pastewka (2017) as SurfaceTopography has them \[seen\], but for
    /// its round window. Missing points are [filled](Self::fill) first.
    ///
    /// # Errors
    /// The errors of [`fill`](Self::fill); [`TopographyError::Content`] above 2²⁴ points;
    /// [`TopographyError::Flat`] when all heights are equal; [`TopographyError::Content`] below
    /// four points along a row, or along a column.
    pub fn spectra(&self) -> Result<Spectra, TopographyError> {
        let (rows, columns) = (self.rows(), self.columns());
        let size = self.heights().len() as u64;
        at_most("the number of points of a spectrum", size, MOST as u64)?;
        let least = if rows > 1 { rows.min(columns) } else { columns };
        if least < 4 {
            return Err(refuse("points along a side", least, "at least 4"));
        }
        let whole = match self.missing_share() > 0.0 {
            true => Cow::Owned(self.clone().fill()?),
            false => Cow::Borrowed(self),
        };
        let [dx, dy] = self.pixel_size();
        let mean = whole.mean();
        let [along, down] = [columns, rows].map(|n| self.window(n));
        let lines = |heights: &[f64], window: &[f64]| {
            let n = window.len();
            let (plan, mut power) = (asperity_fft::forward(n), vec![0.0; n / 2 + 1]);
            for line in heights.chunks(n) {
                let windowed =
                    line.iter().zip(window).map(|(z, w)| Complex64::from(w * (z - mean)));
                let mut line: Vec<_> = windowed.collect();
                plan.process(&mut line);
                power.iter_mut().zip(&line).for_each(|(sum, wave)| *sum += wave.norm_sqr());
            }
            power.iter_mut().for_each(|sum| *sum /= (heights.len() / n) as f64);
            power
        };
        let heights = whole.heights();
        let rows_power = lines(heights, &along);
        let along_rows = profile(&rows_power, columns, dx);
        if along_rows.density.is_empty() {
            return Err(TopographyError::Flat { points: self.measured() });
        }
        if self.is_profile() {
            let waves = rows_power.iter().enumerate().skip(1).map(|(k, p)| (k as f64, *p));
            let median_wavelength = median(waves, columns as f64 * dx);
            let (radial, along_columns) = (None, None);
            return Ok(Spectra { radial, along_rows, along_columns, median_wavelength });
        }
        let columns_power = lines(&transposed(heights, columns), &down);
        let along_columns = Some(profile(&columns_power, rows, dy));
        let point = |(k, h): (usize, &f64)| {
            Complex64::from(along[k % columns] * down[k / columns] * (h - mean))
        };
        // Wave (i, j), i down a column and j along a row, stands at `j * rows + i`.
        let mut waves: Vec<_> = heights.iter().enumerate().map(point).collect();
        asperity_fft::transform(&mut waves, [rows, columns], asperity_fft::forward);
        let [width, height] = [columns as f64 * dx, rows as f64 * dy];
        let each = || {
            waves.iter().enumerate().skip(1).map(|(at, wave)| {
                let [i, j] = [(at % rows, rows), (at / rows, columns)].map(signed);
                (TAU * (i / height).hypot(j / width), wave.norm_sqr())
            })
        };
        let scale = dx * dy / (rows * columns) as f64;
        let largest = PI / dx.max(dy);
        let longest = width.max(height);
        let radial = binned(each().map(|(q, p)| (q, p * scale)), TAU / longest, largest);
        let median_wavelength = median(each().map(|(q, p)| (q * longest / TAU, p)), longest);
        Ok(Spectra { radial: Some(radial), along_rows, along_columns, median_wavelength })
    }

    /// A window of mean square 1.
    fn window(&self, n: usize) -> Vec<f64> {
        let hann = |k: usize| (PI * (k as f64 + 0.5) / n as f64).sin().powi(2) / 0.375_f64.sqrt();
        (0..n).map(|k| if self.is_periodic() { 1.0 } else { hann(k) }).collect()
    }
}

fn profile(power: &[f64], n: usize, step: f64) -> PowerSpectrum {
    let lowest = TAU / (n as f64 * step);
    let scale = step / n as f64;
    let each = power.iter().enumerate().skip(1).map(|(k, p)| (k as f64 * lowest, p * scale));
    binned(each, lowest, PI / step)
}

/// Averages over bins of equal ratios.
fn binned(waves: impl Iterator<Item = (f64, f64)>, lowest: f64, largest: f64) -> PowerSpectrum {
    let mut bins: Vec<[f64; 3]> = vec![];
    let (mut end, mut highest) = (0.0_f64, 0.0_f64);
    for (q, density) in waves.filter(|(q, _)| *q <= largest * (1.0 + 1e-9)) {
        // The lowest wave is in the middle of its bin.
        let bin = ((q / lowest).log2() * BINS + 0.5).max(0.0) as usize;
        if bin >= bins.len() {
            bins.resize(bin + 1, [0.0; 3]);
        }
        highest = highest.max(density);
        if density > ROUNDING * highest {
            end = end.max(q);
        }
        let bin = &mut bins[bin];
        *bin = [bin[0] + q, bin[1] + density, bin[2] + 1.0];
    }
    let top = bins.iter().map(|bin| bin[1] / bin[2].max(1.0)).fold(0.0, f64::max);
    bins.retain(|[_, density, n]| *n > 0.0 && density / n > ROUNDING * top);
    let mean = |term: usize| bins.iter().map(|bin| bin[term] / bin[2]).collect();
    let end = Some(end).filter(|end| *end < 0.9 * largest);
    PowerSpectrum { wave_number: mean(0), density: mean(1), end }
}

/// The wavelength of which half the power is above, from wave numbers on a length.
fn median(waves: impl Iterator<Item = (f64, f64)>, length: f64) -> f64 {
    // Quarters of a wave.
    let mut sums: Vec<f64> = vec![];
    for (k, power) in waves {
        let bin = (4.0 * k).round() as usize;
        if bin >= sums.len() {
            sums.resize(bin + 1, 0.0);
        }
        sums[bin] += power;
    }
    let half = 0.5 * sums.iter().sum::<f64>();
    let mut sum = 0.0;
    for (bin, power) in sums.iter().enumerate() {
        if sum + power >= half && *power > 0.0 {
            let part = (half - sum) / power;
            return 4.0 * length / (bin as f64 - 0.5 + part);
        }
        sum += power;
    }
    length
}

/// The wave number of wave k of n, with its sign, in waves on the whole length.
fn signed((k, n): (usize, usize)) -> f64 {
    if 2 * k > n { k as f64 - n as f64 } else { k as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// a cos(2π p x/n) + b cos(2π q y/m) on n x m points.
    fn waves(periodic: bool) -> Topography {
        let (n, m) = (128, 96);
        let height = |k: usize| {
            let (x, y) = ((k % n) as f64 / n as f64, (k / n) as f64 / m as f64);
            2e-7 * (TAU * 8.0 * x).cos() + 1e-7 * (TAU * 24.0 * y + 0.3).cos()
        };
        Topography::new((0..n * m).map(height).collect(), n, [1e-6, 0.5e-6])
            .unwrap()
            .with_periodic(periodic)
    }

    fn integral(spectrum: &PowerSpectrum, near: f64, step: f64) -> f64 {
        let each = spectrum.wave_number.iter().zip(&spectrum.density);
        each.filter(|(q, _)| (*q / near).log2().abs() < 0.5).map(|(_, c)| c * step).sum()
    }

    #[test]
    fn waves_have_their_mean_square_at_their_wave_number() {
        let spectra = waves(true).spectra().unwrap();
        let q = TAU * 8.0 / 128e-6;
        // One bin of several waves holds a²/2 in one of them.
        let rows = &spectra.along_rows;
        assert_eq!(rows.density.len(), 1, "{rows:?}");
        // 8 waves: the bin from 8 2^(-1/8) to 8 2^(1/8) holds this one alone.
        assert!((rows.wave_number[0] / q - 1.0).abs() < 1e-12);
        let step = TAU / 128e-6;
        assert!((integral(rows, q, step / PI) / (0.5 * 4e-14) - 1.0).abs() < 1e-9);
        let columns = spectra.along_columns.as_ref().unwrap();
        let bin = columns.wave_number[0] / (TAU / 48e-6);
        assert!((bin - 24.0).abs() < 2.0, "{bin}");
        // Four fifths of the power are in the longer wave.
        assert!((spectra.median_wavelength / 16e-6 - 1.0).abs() < 0.05, "{spectra:?}");
        assert_eq!(spectra.radial.unwrap().density.len(), 2);
    }

    #[test]
    fn the_window_keeps_the_mean_square() {
        let wave = |x: u32| 2e-7 * (TAU * 4.0 * f64::from(x) / 128.0 + 0.7).cos();
        let profile = Topography::new((0..128).map(wave).collect(), 128, [1e-6; 2]).unwrap();
        let PowerSpectrum { wave_number, density, .. } = profile.spectra().unwrap().along_rows;
        // Hann's window spreads a wave over its neighbours, 1/6, 2/3 and 1/6 of the power; up to 8
        // waves each bin has one.
        for (k, part) in [(3.0, 1.0 / 6.0), (4.0, 2.0 / 3.0), (5.0, 1.0 / 6.0)] {
            let q = TAU * k / 128e-6;
            let at = wave_number.iter().position(|found| (found / q - 1.0).abs() < 1e-9).unwrap();
            let square = density[at] * TAU / 128e-6 / PI;
            assert!((square / (part * 0.5 * 4e-14) - 1.0).abs() < 1e-9, "{k} {square:e}");
        }
    }

    #[test]
    fn missing_points_are_filled_and_tiny_or_flat_maps_refused() {
        let mut heights = waves(true).heights().to_vec();
        heights[500] = f64::NAN;
        let holed = Topography::new(heights.clone(), 128, [1e-6, 0.5e-6]).unwrap();
        assert!(holed.spectra().is_ok());
        heights.iter_mut().step_by(3).for_each(|height| *height = f64::NAN);
        let holed = Topography::new(heights, 128, [1e-6, 0.5e-6]).unwrap();
        assert!(holed.spectra().is_err());
        let made = |n: usize| Topography::new(vec![1.0; n * n], n, [1.0; 2]).unwrap().spectra();
        assert!(made(3).unwrap_err().to_string().contains("at least 4"));
        assert!(made(8).is_err());
    }
}
