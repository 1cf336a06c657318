//! Slopes and curvatures of profiles against the distance over which they are taken, and the
//! anisotropy of a surface, from the second moments of its slopes.

use std::array::from_fn;

use crate::Topography;

impl Topography {
    /// The heights of all windows of R x C points `step` apart, by lines; around the edges of a
    /// periodic surface. Windows of no side longer than the surface.
    pub(crate) fn windows<const R: usize, const C: usize>(
        &self,
        step: usize,
    ) -> impl Iterator<Item = impl Iterator<Item = [[f64; C]; R]> + '_> + '_ {
        let (rows, columns) = (self.rows(), self.columns());
        let count = |n: usize, side: usize| match n.checked_sub((side - 1) * step) {
            None | Some(0) => 0,
            Some(_) if self.is_periodic() => n,
            Some(inside) => inside,
        };
        let [down, along] = [count(rows, R), count(columns, C)];
        let around = |at: usize, n: usize| if at < n { at } else { at - n };
        (0..down).map(move |y| {
            let lines: [&[f64]; R] =
                from_fn(|r| &self.heights()[around(y + r * step, rows) * columns..][..columns]);
            (0..along).map(move |x| {
                let at: [usize; C] = from_fn(|c| around(x + c * step, columns));
                lines.map(|line| at.map(|x| line[x]))
            })
        })
    }

    /// The means of N numbers of all windows, without those with a missing point; summed by lines.
    /// `None` if there is no window.
    pub(crate) fn means<const R: usize, const C: usize, const N: usize>(
        &self,
        step: usize,
        of: impl Fn([[f64; C]; R]) -> [f64; N],
    ) -> Option<[f64; N]> {
        let (mut sums, mut count) = ([0.0; N], 0_usize);
        for line in self.windows(step) {
            let mut sum = [0.0; N];
            for numbers in line.map(&of).filter(|numbers| !numbers[0].is_nan()) {
                sum = from_fn(|k| sum[k] + numbers[k]);
                count += 1;
            }
            sums = from_fn(|k| sums[k] + sum[k]);
        }
        (count > 0).then(|| sums.map(|sum| sum / count as f64))
    }

    /// The mean square slope over a distance of `step` points, along rows or along columns, and the
    /// mean of its square times the height above `base`; the mean square curvature.
    pub(crate) fn along(
        &self,
        axis: usize,
        step: usize,
        base: f64,
    ) -> (Option<[f64; 2]>, Option<f64>) {
        let distance = step as f64 * self.pixel_size()[axis];
        let slope = |[a, b]: [f64; 2]| {
            let square = ((b - a) / distance).powi(2);
            [square, square * (0.5 * (a + b) - base)]
        };
        let curvature = |[a, b, c]: [f64; 3]| [((a - 2.0 * b + c) / (distance * distance)).powi(2)];
        let (slopes, [curvatures]) = match axis {
            0 => (self.means(step, |[row]| slope(row)), [self.means(step, |[row]| curvature(row))]),
            _ => (
                self.means(step, |rows: [[f64; 1]; 2]| slope(rows.map(|[z]| z))),
                [self.means(step, |rows: [[f64; 1]; 3]| curvature(rows.map(|[z]| z)))],
            ),
        };
        (slopes, curvatures.map(|[mean]| mean))
    }

    /// Root mean square slopes (z(x + d) - z(x))/d over distances d of 1, 2, 4, ... pixels, up to a
    /// quarter of the longer side, each along rows and columns, and curvatures
    /// (z(x + d) - 2 z(x) + z(x - d))/d² \[1/m\]; `None` beyond the scan. Differences with a
    /// missing point are left out; a periodic surface continues beyond its edges.
    pub(crate) fn scale_dependence(&self) -> impl Iterator<Item = (usize, [[Option<f64>; 2]; 2])> {
        let most = (self.columns().max(self.rows()) / 4).max(1);
        let steps = std::iter::successors(Some(1_usize), |step| Some(2 * step));
        steps.take_while(move |step| *step <= most).map(|step| (step, self.at_distance(step)))
    }

    /// Root mean square slopes over a distance of whole pixels, along rows and columns, and
    /// curvatures \[1/m\].
    pub(crate) fn at_distance(&self, step: usize) -> [[Option<f64>; 2]; 2] {
        let of = [0, 1].map(|axis| self.along(axis, step, 0.0));
        let slopes = of.map(|(slope, _)| slope.map(|[square, _]| square.sqrt()));
        [slopes, of.map(|(_, curvature)| curvature.map(f64::sqrt))]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::Texture;

    /// Two waves at right angles, the second along the direction of the lay.
    fn crossed(degrees: f64, [across, along]: [f64; 2]) -> Texture {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let n = 400;
        let height = |k: usize| {
            let (x, y) = (0.2 * (k % n) as f64, 0.2 * (k / n) as f64);
            across * (y * cos - x * sin).cos() + along * (x * cos + y * sin).cos()
        };
        let surface = Topography::new((0..n * n).map(height).collect(), n, [0.2, 0.2]).unwrap();
        surface.moments().unwrap().texture().unwrap()
    }

    #[test]
    fn crossed_waves_have_their_slopes_and_direction() {
        for degrees in [0.0, 25.0, 90.0, -40.0] {
            let found = crossed(degrees, [0.3, 0.1]);
            assert!((found.ratio().unwrap() / 3.0 - 1.0).abs() < 0.02, "{found:?}");
            assert!((found.slope_across / (0.3 / 2f64.sqrt()) - 1.0).abs() < 0.02, "{found:?}");
            let off = (found.direction - degrees).rem_euclid(180.0);
            assert!(off.min(180.0 - off) < 0.5, "{degrees} {found:?}");
            assert!(found.direction > -90.0 && found.direction <= 90.0);
        }
    }

    #[test]
    fn grooves_have_no_ratio_and_flat_surfaces_no_texture() {
        let groove = |k: usize| (TAU * (k % 32) as f64 / 32.0).sin();
        let grooves = Topography::new((0..1024).map(groove).collect(), 32, [1.0; 2]).unwrap();
        let found = grooves.moments().unwrap().texture().unwrap();
        assert!(found.ratio().is_none() && (found.direction - 90.0).abs() < 1e-9, "{found:?}");
        let texture = |heights: Vec<f64>| {
            Topography::new(heights, 4, [1.0; 2]).unwrap().moments().unwrap().texture()
        };
        assert!(texture(vec![0.0; 16]).is_none());
        assert!(texture(vec![0.0, 1.0, 3.0, 2.0]).is_none());
    }

    #[test]
    fn a_wave_has_the_closed_form_of_its_differences() {
        let n = 96;
        let wave = |k: usize| 3e-7 * (TAU * 4.0 * (k % n) as f64 / n as f64).sin();
        let surface = Topography::new((0..n * n).map(wave).collect(), n, [2e-6, 1e-6]).unwrap();
        let surface = surface.with_periodic(true);
        for (k, (step, [slopes, curvatures])) in surface.scale_dependence().enumerate() {
            assert_eq!(step, 1 << k);
            let d = 2e-6 * step as f64;
            let gain = 2.0 * (TAU * 4.0 * step as f64 / n as f64 / 2.0).sin().abs();
            let rms = 3e-7 / 2f64.sqrt();
            let close = |found: Option<f64>, right: f64| {
                assert!(
                    (found.unwrap() - right).abs() < 1e-9 * (right + 1e-6 * rms / d),
                    "{right}"
                );
            };
            close(slopes[0], rms * gain / d);
            close(curvatures[0], rms * (gain / d).powi(2));
            close(slopes[1], 0.0);
        }
    }

    #[test]
    fn open_surfaces_and_missing_points_leave_differences_out() {
        let profile = vec![0.0, 1.0, f64::NAN, 4.0, 6.0, 9.0];
        let profile = Topography::new(profile, 6, [1.0; 2]).unwrap();
        let [slopes, curvatures] = profile.at_distance(1);
        assert!((slopes[0].unwrap().powi(2) - 14.0 / 3.0).abs() < 1e-12);
        assert!((curvatures[0].unwrap().powi(2) - 1.0).abs() < 1e-12);
        assert!(slopes[1].is_none());
        assert!(profile.at_distance(6)[0][0].is_none());
    }
}
