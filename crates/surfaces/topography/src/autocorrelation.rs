//! The autocorrelation of the heights: Sal and Str of ISO 25178-2.

use asperity_fft::{Complex64, forward, inverse, transform};
use nalgebra::{Matrix3, Vector3};

use crate::Topography;
use crate::topography::extremes;

/// The value of the autocorrelation to which lengths are measured, as ISO 25178-3 sets it.
/// \[recalled\]
const DECAYED: f64 = 0.2;
/// That of the correlation lengths of Peklenik. \[recalled\]
const HALF: f64 = 0.5;
/// The most points of a map that is transformed: 1 GiB of waves, as every side is doubled.
const MOST: usize = 1 << 24;

/// Lengths over which the autocorrelation of the heights decays to 0.2, along the directions in
/// which it does so first and last.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Decay {
    /// Sal \[m\]: the shortest of these lengths.
    pub sal: f64,
    /// Str: the shortest over the longest, 1 for an isotropic surface; `None` for a profile and
    /// where the autocorrelation decays only beyond the edge of the scan along some direction.
    pub str: Option<f64>,
}

/// Correlation lengths of the heights along and across the lay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lay {
    /// \[m\] Along the principal axis that is nearer to the rows, and across it: their ratio is
    /// the Peklenik number.
    pub lengths: [f64; 2],
    /// The angle of this axis \[degrees\], -45 to 45, from the rows (x) towards the columns (y).
    pub degrees: f64,
}

impl Topography {
    /// Sal and Str of ISO 25178-2. Pairs of points with a missing one are left out, and every lag
    /// is averaged over its own pairs. The contour of 0.2 about lag 0 is interpolated linearly
    /// between neighbouring lags along rows and columns.
    ///
    /// `None` where the autocorrelation decays along no direction, and above 2²⁴ points.
    #[must_use]
    pub fn decay(&self) -> Option<Decay> {
        let (contour, touches_edge) = self.contour(DECAYED)?;
        let lengths: Vec<f64> = contour.iter().map(|[x, y]| x.hypot(*y)).collect();
        let [sal, longest] = extremes(&lengths);
        let str = (!touches_edge && !self.is_profile()).then(|| sal / longest);
        sal.is_finite().then_some(Decay { sal, str })
    }

    /// The lengths over which the autocorrelation falls to a half, as Peklenik's ratio takes them:
    /// the semi-axes of the ellipse that fits its contour best. \[derived\] Those of a scan that is
    /// turned are the same, and the axis is turned with it.
    ///
    /// `None` for a profile, where it does not fall so far within the scan, and above 2²⁴ points.
    #[must_use]
    pub fn lay(&self) -> Option<Lay> {
        let (contour, touches_edge) = self.contour(HALF)?;
        if touches_edge || self.is_profile() {
            return None;
        }
        // a x² + 2 b x y + c y² = 1 by least squares.
        let of = |[x, y]: &[f64; 2]| Vector3::new(x * x, 2.0 * x * y, y * y);
        let square =
            contour.iter().map(|point| of(point) * of(point).transpose()).sum::<Matrix3<_>>();
        let form = square.cholesky()?.solve(&contour.iter().map(of).sum());
        let [a, b, c] = form.into();
        let turned = 0.5 * (2.0 * b).atan2(a - c).to_degrees();
        let degrees = turned - 90.0 * (turned / 90.0).round();
        let along = |degrees: f64| {
            let (y, x) = degrees.to_radians().sin_cos();
            of(&[x, y]).dot(&form).powf(-0.5)
        };
        let lengths = [along(degrees), along(degrees + 90.0)];
        lengths.iter().all(|length| length.is_finite()).then_some(Lay { lengths, degrees })
    }

    /// The contour of a value of the autocorrelation about lag 0 \[m\], along rows and columns, and
    /// whether it reaches the largest lags; `None` above 2²⁴ points.
    fn contour(&self, value: f64) -> Option<(Vec<[f64; 2]>, bool)> {
        if self.heights().len() > MOST {
            return None;
        }
        let lags = Lags::of(self)?;
        let [dx, dy] = self.pixel_size();
        let (mut contour, mut touches_edge) = (vec![], false);
        for (v, u) in lags.inside(value) {
            let here = lags.at(v, u)?;
            for (along, down) in [(1, 0), (-1, 0), (0, 1), (0, -1)] {
                let Some(next) = lags.at(v + down, u + along) else {
                    touches_edge |= !(self.is_profile() && down != 0);
                    continue;
                };
                if next > value {
                    continue;
                }
                let part = (here - value) / (here - next);
                let x = (u as f64 + part * along as f64) * dx;
                contour.push([x, (v as f64 + part * down as f64) * dy]);
            }
        }
        Some((contour, touches_edge))
    }
}

/// The autocorrelation at lags of whole points, 1 at lag 0.
struct Lags {
    values: Vec<f64>,
    /// Rows and columns of `values`, which are periodic.
    shape: [usize; 2],
    /// The largest lag along a column and along a row.
    most: [isize; 2],
}

impl Lags {
    fn of(surface: &Topography) -> Option<Self> {
        let (rows, columns) = (surface.rows(), surface.columns());
        // Zeros beyond the edges, or the surface itself.
        let padded = |n: usize| if surface.is_periodic() || n == 1 { n } else { 2 * n };
        let shape = [padded(rows), padded(columns)];
        let most = |n: usize| if surface.is_periodic() { n / 2 } else { n - 1 };
        let most = [rows, columns].map(|n| most(n) as isize);
        let mean = surface.mean();
        let sq = surface.central_moment(mean, 2).sqrt();
        if sq <= 0.0 {
            return None;
        }
        let mut waves = vec![Complex64::ZERO; shape[0] * shape[1]];
        // Heights are the real part, and whether they are there the imaginary one, of one size.
        for (row, line) in surface.heights().chunks(columns).zip(waves.chunks_mut(shape[1])) {
            let there = row.iter().zip(line).filter(|(height, _)| !height.is_nan());
            there.for_each(|(height, point)| *point = Complex64::new((height - mean) / sq, 1.0));
        }
        transform(&mut waves, shape, forward);
        let opposite = |at: usize| {
            let (j, i) = (at / shape[0], at % shape[0]);
            (shape[1] - j) % shape[1] * shape[0] + (shape[0] - i) % shape[0]
        };
        for at in 0..waves.len() {
            let other = opposite(at);
            if other < at {
                continue;
            }
            let [one, two] = [waves[at], waves[other].conj()];
            let [heights, there] = [0.5 * (one + two), 0.5 * (one - two)];
            let square = Complex64::new(heights.norm_sqr(), there.norm_sqr());
            (waves[at], waves[other]) = (square, square);
        }
        transform(&mut waves, [shape[1], shape[0]], inverse);
        let sums = waves;
        // Counts of pairs are whole numbers times the number of points transformed.
        let one = shape[0] as f64 * shape[1] as f64;
        let mean = |sum: &Complex64| if sum.im > 0.5 * one { sum.re / sum.im } else { 0.0 };
        let square = mean(sums.first()?);
        let values = sums.iter().map(|sum| mean(sum) / square).collect();
        (square > 0.0).then_some(Self { values, shape, most })
    }

    /// The value at a lag along a column and along a row; `None` beyond the largest one.
    fn at(&self, v: isize, u: isize) -> Option<f64> {
        if v.abs() > self.most[0] || u.abs() > self.most[1] {
            return None;
        }
        let place = |lag: isize, n: usize| lag.rem_euclid(n as isize) as usize;
        Some(self.values[place(v, self.shape[0]) * self.shape[1] + place(u, self.shape[1])])
    }

    /// The lags about 0 at which the autocorrelation has not decayed to this value.
    fn inside(&self, least: f64) -> Vec<(isize, isize)> {
        let width = (2 * self.most[1] + 1) as usize;
        let mut seen = vec![false; (2 * self.most[0] + 1) as usize * width];
        let index =
            |v: isize, u: isize| (v + self.most[0]) as usize * width + (u + self.most[1]) as usize;
        let (mut points, mut next) = (vec![(0, 0)], 0);
        seen[index(0, 0)] = true;
        while let Some(&(v, u)) = points.get(next) {
            next += 1;
            for (v, u) in [(v, u + 1), (v, u - 1), (v + 1, u), (v - 1, u)] {
                if self.at(v, u).is_some_and(|value| value > least) && !seen[index(v, u)] {
                    seen[index(v, u)] = true;
                    points.push((v, u));
                }
            }
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn a_periodic_wave_decays_as_its_cosine() {
        // cos(2π x/40) + cos(2π y/100): the autocorrelation is the mean of the two cosines.
        let height = |k: usize| {
            let (x, y) = ((k % 200) as f64, (k / 200) as f64);
            (TAU * x / 40.0).cos() + (TAU * y / 100.0).cos()
        };
        let heights = (0..200 * 200).map(height).collect();
        let surface = Topography::new(heights, 200, [1e-6; 2]).unwrap().with_periodic(true);
        let found = surface.decay().unwrap();
        // (cos(2π x/40) + 1)/2 = 0.2 along rows; along columns likewise, which is the slowest.
        let length = (-0.6_f64).acos() / TAU;
        assert!((found.sal / (40e-6 * length) - 1.0).abs() < 2e-3, "{found:?}");
        assert!((found.str.unwrap() - 0.4).abs() < 2e-3, "{found:?}");
    }

    #[test]
    fn a_turned_lay_keeps_its_correlation_lengths() {
        // Waves of lengths 40 and 100 as above, of which another part is measured.
        let wave = |turned: f64| {
            let (sin, cos) = turned.to_radians().sin_cos();
            let height = |k: usize| {
                let (x, y) = ((k % 400) as f64, (k / 400) as f64);
                let (u, v) = (cos * x + sin * y, cos * y - sin * x);
                (TAU * u / 40.0).cos() + (TAU * v / 100.0).cos()
            };
            let heights = (0..400 * 400).map(height).collect();
            Topography::new(heights, 400, [1e-6; 2]).unwrap().lay().unwrap()
        };
        let straight = wave(0.0).lengths;
        assert!((straight[1] / straight[0] - 2.5).abs() < 0.1, "{straight:?}");
        for turned in [15.0, 40.0, 60.0, 90.0] {
            let Lay { lengths: [mut along, mut across], degrees } = wave(turned);
            let off = degrees - turned + if turned > 45.0 { 90.0 } else { 0.0 };
            if turned > 45.0 {
                (along, across) = (across, along);
            }
            for (found, wanted) in [(along, straight[0]), (across, straight[1])] {
                assert!((found / wanted - 1.0).abs() < 0.04, "{turned} {found} {wanted}");
            }
            assert!(off.abs() < 0.3, "{turned} {off}");
        }
        let groove = |k: usize| (TAU * (k % 128) as f64 / 32.0).cos();
        let grooves = Topography::new((0..128 * 64).map(groove).collect(), 128, [1e-6; 2]);
        assert_eq!(grooves.unwrap().lay(), None);
    }

    #[test]
    fn grooves_have_no_longest_length_and_missing_points_do_not_matter() {
        let groove = |k: usize| (TAU * (k % 128) as f64 / 32.0).cos();
        let mut heights: Vec<f64> = (0..128 * 64).map(groove).collect();
        let whole = Topography::new(heights.clone(), 128, [1e-6; 2]).unwrap().decay().unwrap();
        assert!(whole.str.is_none());
        // Sums over the pairs themselves.
        let lag = |u: usize| {
            let pairs = (0..128 - u).map(|x| groove(x) * groove(x + u)).sum::<f64>();
            pairs / (128 - u) as f64 / (0..128).map(|x| groove(x).powi(2) / 128.0).sum::<f64>()
        };
        let past = (0..128).find(|u| lag(*u) < 0.2).unwrap();
        let part = (lag(past - 1) - 0.2) / (lag(past - 1) - lag(past));
        let expected = 1e-6 * (past as f64 - 1.0 + part);
        assert!((whole.sal / expected - 1.0).abs() < 1e-9, "{whole:?} {expected}");
        for k in (0..heights.len()).step_by(7) {
            heights[k] = f64::NAN;
        }
        let holed = Topography::new(heights, 128, [1e-6; 2]).unwrap().decay().unwrap();
        assert!((holed.sal / whole.sal - 1.0).abs() < 0.01, "{holed:?}");
    }

    #[test]
    fn flat_surfaces_have_none_and_profiles_a_length() {
        assert!(Topography::new(vec![1.0; 64], 8, [1.0; 2]).unwrap().decay().is_none());
        let wave = (0..400).map(|x| (TAU * f64::from(x) / 50.0).sin()).collect();
        let profile = Topography::new(wave, 400, [1e-6; 2]).unwrap().with_periodic(true);
        let found = profile.decay().unwrap();
        assert!((found.sal / (50e-6 * 0.2_f64.acos() / TAU) - 1.0).abs() < 1e-3, "{found:?}");
        assert!(found.str.is_none());
    }
}
