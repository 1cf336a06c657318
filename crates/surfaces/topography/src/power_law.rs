//! A self-affine law fitted to a radial power spectrum.

use nalgebra::{Matrix3, Vector3};

use crate::PowerSpectrum;

/// The least number of points and of octaves of a power law.
const POINTS: usize = 8;
const OCTAVES: f64 = 2.0;
/// A break is kept where it lowers the mean square of the residuals by this share.
const WORTH: f64 = 0.2;
/// ... and only where the rms residual of ln C without it is above this.
const SCATTER: f64 = 0.02;
/// The largest rms residual of ln C between the breaks: a factor of 1.4.
const LOOSE: f64 = 0.35;

/// C(q) ∝ q^(-2-2H) between two wave numbers, constant below them.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PowerLaw {
    /// Hurst exponent H, from 0 to 1.
    pub hurst: f64,
    /// The wavelength \[m\] above which the spectrum is flat; `None` without a roll-off within
    /// the scan.
    pub roll_off: Option<f64>,
    /// The wavelength \[m\] below which the spectrum leaves the power law; `None` if it holds down
    /// to two pixels.
    pub cut_off: Option<f64>,
    /// The wave numbers \[rad/m\] between which it holds.
    pub range: [f64; 2],
    /// log C at the first of them, C in m⁴.
    ln_density: f64,
}

impl PowerLaw {
    /// The law fitted by least squares to ln C over ln q: flat, then of slope -2 - 2H, then of
    /// another slope, with breaks where the residuals are least and only where they are worth it.
    ///
    /// # Errors
    /// The reason: below two octaves or eight points, and where no such law is near: H outside
    /// 0 to 1, or a scatter of ln C about it above 0.35.
    pub fn fit(spectrum: &PowerSpectrum) -> Result<Self, String> {
        let x: Vec<f64> = spectrum.wave_number.iter().map(|q| q.ln()).collect();
        let y: Vec<f64> = spectrum.density.iter().map(|c| c.ln()).collect();
        let n = x.len();
        let octaves = |from: usize, to: usize| (x[to] - x[from]) / std::f64::consts::LN_2;
        let last = n.saturating_sub(1);
        let all = if n > 0 { octaves(0, last) } else { 0.0 };
        if n < POINTS || all < OCTAVES {
            return Err(format!(
                "the radial spectrum has {n} points over {all:.1} octaves: at least {POINTS} over {OCTAVES} octaves were required"
            ));
        }
        let try_fit = |from: usize, to: usize| -> Option<PowerLawFit> {
            (octaves(from, to) >= OCTAVES).then(|| PowerLawFit::new(&x, &y, from, to)).flatten()
        };
        let best = |from: std::ops::Range<usize>, to: std::ops::RangeInclusive<usize>| {
            let pairs = from.flat_map(|a| to.clone().map(move |b| (a, b)));
            let fits = pairs
                .filter_map(|(a, b)| try_fit(a, b))
                .filter(|fit| (0.0..=1.0).contains(&fit.hurst()));
            fits.min_by(|one, other| one.squares.total_cmp(&other.squares))
        };
        let mut found = best(0..1, last..=last);

        let worth = |fit: &PowerLawFit, found: &Option<PowerLawFit>| {
            let least = found.as_ref().map_or(f64::INFINITY, |found| found.squares);
            fit.squares < (1.0 - WORTH) * least && least > n as f64 * SCATTER * SCATTER
        };
        // A break next to an end would fit one point.
        for other in
            [best(2..last, last..=last), best(0..1, 2..=last - 2), best(2..last, 2..=last - 2)]
        {
            if let Some(fit) = other.filter(|fit| worth(fit, &found)) {
                found = Some(fit);
            }
        }
        let Some(found) = found else {
            let hurst = PowerLawFit::new(&x, &y, 0, last).map_or(f64::NAN, |fit| fit.hurst());
            return Err(format!(
                "no two octaves of the radial spectrum have a Hurst exponent from 0 to 1 (of the whole: {hurst:.2})"
            ));
        };
        let PowerLawFit { from, to, level, scatter, .. } = found;
        if scatter.is_nan() || scatter >= LOOSE {
            return Err(format!(
                "the radial spectrum scatters by {scatter:.2} in ln C about its best power law: at most {LOOSE} was required"
            ));
        }
        let q = &spectrum.wave_number;
        let wavelength = |k: usize| std::f64::consts::TAU / q[k];
        Ok(Self {
            hurst: found.hurst(),
            roll_off: (from > 0).then(|| wavelength(from)),
            // A spectrum that ends near the break has a partly empty bin behind it.
            cut_off: match spectrum.end {
                Some(end) if to + 2 >= last => Some(std::f64::consts::TAU / end),
                _ => (to < last).then(|| wavelength(to)),
            },
            range: [q[from], q[to]],
            ln_density: level,
        })
    }

    /// C(q) \[m⁴\] of the law, also beyond its range.
    #[must_use]
    pub fn density(&self, wave_number: f64) -> f64 {
        let over = (wave_number / self.range[0]).ln();
        (self.ln_density - 2.0 * (1.0 + self.hurst) * over).exp()
    }
}

/// A continuous line of three parts.
struct PowerLawFit {
    from: usize,
    to: usize,
    level: f64,
    slope: f64,
    squares: f64,
    /// Rms residual between the breaks.
    scatter: f64,
}

impl PowerLawFit {
    fn hurst(&self) -> f64 {
        -0.5 * self.slope - 1.0
    }

    fn new(x: &[f64], y: &[f64], from: usize, to: usize) -> Option<Self> {
        let (a, b) = (x[from], x[to]);
        let terms = |x: f64| Vector3::new(1.0, x.clamp(a, b) - a, (x - b).max(0.0));
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for (x, y) in x.iter().zip(y) {
            let terms = terms(*x);
            normal += terms * terms.transpose();
            right += *y * terms;
        }
        if to + 1 == x.len() {
            normal[(2, 2)] = 1.0;
        }
        let fit = normal.cholesky()?.solve(&right);
        let sum = |from: usize, to: usize| -> f64 {
            let each = x[from..=to].iter().zip(&y[from..=to]);
            each.map(|(x, y)| (y - fit.dot(&terms(*x))).powi(2)).sum()
        };
        let scatter = (sum(from, to) / (to - from + 1) as f64).sqrt();
        let squares = sum(0, x.len() - 1);
        Some(Self { from, to, level: fit[0], slope: fit[1], squares, scatter })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spectrum(density: impl Fn(f64) -> f64) -> PowerSpectrum {
        let wave_number: Vec<f64> = (0..32).map(|k| 1e5 * 2f64.powf(f64::from(k) / 4.0)).collect();
        let density = wave_number.iter().map(|q| density(q / 1e5)).collect();
        PowerSpectrum { wave_number, density, end: None }
    }

    #[test]
    fn exact_laws_are_found_with_and_without_breaks() {
        let pure = PowerLaw::fit(&spectrum(|q| 1e-20 * q.powf(-3.4))).unwrap();
        assert!((pure.hurst - 0.7).abs() < 1e-9 && pure.roll_off.is_none(), "{pure:?}");
        assert!(pure.cut_off.is_none());
        assert!((pure.density(8e5) / (1e-20 * 8f64.powf(-3.4)) - 1.0).abs() < 1e-9);
        let broken = |q: f64| (q / 4.0).clamp(1.0, 16.0).powf(-3.0) * (64.0 / q.max(64.0)).powi(9);
        let found = PowerLaw::fit(&spectrum(broken)).unwrap();
        assert!((found.hurst - 0.5).abs() < 1e-6, "{found:?}");
        let wavelength = |q: f64| std::f64::consts::TAU / (1e5 * q);
        assert!((found.roll_off.unwrap() / wavelength(4.0) - 1.0).abs() < 1e-9);
        assert!((found.cut_off.unwrap() / wavelength(64.0) - 1.0).abs() < 1e-9);
        // Without waves above a wave number within its last bin.
        let mut ending = spectrum(|q| 1e-20 * q.powf(-3.4));
        ending.wave_number.truncate(20);
        ending.density.truncate(20);
        ending.density[19] *= 0.1;
        ending.end = Some(26.0e5);
        let found = PowerLaw::fit(&ending).unwrap();
        // The partly empty bin tilts the law.
        assert!((found.hurst - 0.7).abs() < 0.03, "{found:?}");
        assert!((found.cut_off.unwrap() / wavelength(26.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_noise_floor_is_a_cut_off_and_few_points_or_other_laws_are_none() {
        let reason = |spectrum| PowerLaw::fit(&spectrum).unwrap_err();
        let steep = reason(spectrum(|q| q.powf(-6.0)));
        assert!(steep.ends_with("(of the whole: 2.00)"), "{steep}");
        let comb = |q: f64| if (4.0 * q.log2()).round() % 2.0 > 0.5 { 1e3 } else { 1.0 };
        let combed = reason(spectrum(|q| comb(q) * q.powf(-3.0)));
        assert!(combed.contains("scatters by 3.4"), "{combed}");
        let floor = PowerLaw::fit(&spectrum(|q| q.powf(-3.6) + 32f64.powf(-3.6))).unwrap();
        assert!((floor.hurst - 0.8).abs() < 0.08 && floor.roll_off.is_none(), "{floor:?}");
        let cut = std::f64::consts::TAU / (1e5 * floor.cut_off.unwrap());
        assert!((16.0..64.0).contains(&cut), "{cut}");
        let few = spectrum(|q| 1.0 / q);
        let few = PowerSpectrum {
            wave_number: few.wave_number[..7].to_vec(),
            density: few.density[..7].to_vec(),
            end: None,
        };
        let few = reason(few);
        assert!(few.contains("7 points over 1.5 octaves"), "{few}");
        let none = reason(PowerSpectrum { wave_number: vec![], density: vec![], end: None });
        assert!(none.contains("0 points"), "{none}");
    }
}
