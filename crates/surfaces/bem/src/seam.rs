//! The seam of a periodic map: its step, and the periodic component of a map without the step.

use std::f64::consts::TAU;
use std::ops::Range;

use asperity_fft::{Complex64, transform};

use crate::HeightMap;

/// Edges match where the step at the seam is less than this many steps between neighbours.
pub(crate) const LARGEST_STEP: f64 = 3.0;
/// Slopes match where they change at the seam by less than this many changes between neighbours.
pub(crate) const LARGEST_KINK: f64 = 5.0;

impl HeightMap {
    /// Root mean square step over the seam, relative to that between neighbours inside, along rows
    /// or along columns, whichever is larger: about 1 where the map is periodic.
    #[must_use]
    pub fn seam_step(&self) -> f64 {
        self.at_seam(1, |[here, next, _]| next - here)
    }

    /// The same of the change of slope: large where a single body, such as a sphere, fills the map.
    #[must_use]
    pub fn seam_kink(&self) -> f64 {
        self.at_seam(2, |[here, next, second]| here - 2.0 * next + second)
    }

    /// Root mean square of a difference of heights that follow each other, over the seam relative
    /// to inside. The difference at the last `over` lines goes over the seam.
    fn at_seam(&self, over: usize, difference: impl Fn([f64; 3]) -> f64) -> f64 {
        let [rows, columns] = self.shape();
        let height = |i: usize, j: usize| self.heights()[(i % rows) * columns + j % columns];
        let ratio = |n: usize, along: usize, height: &dyn Fn(usize, usize) -> f64| {
            let square = |k: usize, l: usize| {
                difference([height(k, l), height(k + 1, l), height(k + 2, l)]).powi(2)
            };
            let lines = |lines: Range<usize>| {
                let count = lines.len() as f64;
                lines
                    .flat_map(|k| (0..along).map(move |l| (k, l)))
                    .map(|(k, l)| square(k, l))
                    .sum::<f64>()
                    / count
            };
            let inner = n.saturating_sub(over);
            let seam = lines(inner..n);
            if seam > 0.0 { (seam / lines(0..inner)).sqrt() } else { 0.0 }
        };
        let down = ratio(rows, columns, &height);
        let across = ratio(columns, rows, &|j, i| height(i, j));
        down.max(across)
    }

    /// Whether the map can be repeated without steps at its seam: a [step](Self::seam_step) of
    /// less than 3.
    #[must_use]
    pub fn edges_meet(&self) -> bool {
        self.seam_step() < LARGEST_STEP
    }

    /// The periodic component of the map: less the smoothest surface that has its steps at the
    /// seam (Moisan 2011 \[recalled\]), so that the inside keeps its shape.
    ///
    /// ```text
    /// v = the steps over the seam, on the pixels beside it
    /// s^(i, j) = v^(i, j)/(2 cos(2π i/n) + 2 cos(2π j/m) - 4),  s^(0, 0) = 0,  p = h - s
    /// ```
    #[must_use]
    pub fn periodic_part(&self) -> Self {
        let [rows, columns] = self.shape();
        let height = |i: usize, j: usize| self.heights()[i * columns + j];
        let mut steps = vec![Complex64::ZERO; rows * columns];
        for j in 0..columns {
            let step = height(rows - 1, j) - height(0, j);
            steps[j] += step;
            steps[(rows - 1) * columns + j] -= step;
        }
        for i in 0..rows {
            let step = height(i, columns - 1) - height(i, 0);
            steps[i * columns] += step;
            steps[i * columns + columns - 1] -= step;
        }
        transform(&mut steps, [rows, columns], asperity_fft::forward);
        let cosine = |k: usize, n: usize| 2.0 * (TAU * k as f64 / n as f64).cos() - 2.0;
        // Back in the layout that the transform leaves: columns first.
        for (j, column) in steps.chunks_mut(rows).enumerate() {
            for (i, wave) in column.iter_mut().enumerate() {
                let factor = cosine(i, rows) + cosine(j, columns);
                let scale = if i + j == 0 { 0.0 } else { 1.0 / (factor * (rows * columns) as f64) };
                *wave *= scale;
            }
        }
        transform(&mut steps, [columns, rows], asperity_fft::inverse);
        let heights = self.heights().iter().zip(&steps).map(|(h, s)| h - s.re);
        self.with_heights(heights.collect())
    }

    /// The waves of the map as it is repeated: wave numbers \[1/m\] above 0, and mean square
    /// heights \[m²\], which add up to Sq².
    #[must_use]
    pub fn waves(&self) -> Vec<(f64, f64)> {
        let ([rows, columns], pixel) = (self.shape(), self.pixel());
        let mut waves: Vec<Complex64> =
            self.heights().iter().map(|height| Complex64::new(*height, 0.0)).collect();
        transform(&mut waves, [rows, columns], asperity_fft::forward);
        let per_length =
            |k: usize, n: usize, pixel: f64| TAU * k.min(n - k) as f64 / (n as f64 * pixel);
        let points = (rows * columns) as f64;
        let wave = |(index, amplitude): (usize, &Complex64)| {
            // Columns first.
            let (j, i) = (index / rows, index % rows);
            let q = per_length(i, rows, pixel[0]).hypot(per_length(j, columns, pixel[1]));
            (q, (amplitude / points).norm_sqr())
        };
        waves.iter().enumerate().skip(1).map(wave).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RandomSurface;

    fn wide() -> HeightMap {
        RandomSurface::new(1.0, 2.0, 12.0).unwrap().seed(3).heights(192).unwrap()
    }

    /// A part of a map: its edges do not meet.
    fn part(map: &HeightMap, [rows, columns]: [usize; 2]) -> HeightMap {
        let all = map.heights().chunks(map.shape()[1]).take(rows);
        let heights = all.flat_map(|row| row[..columns].to_vec()).collect();
        HeightMap::new(heights, [rows, columns], map.pixel()).unwrap()
    }

    #[test]
    fn waves_carry_the_square_height_at_their_wave_numbers() {
        let turn = |k: usize, n: usize| TAU * k as f64 / n as f64;
        let height = |k: usize| 3.0 * turn(2 * (k / 15), 12).cos() + turn(4 * (k % 15), 15).sin();
        let map = HeightMap::new((0..180).map(height).collect(), [12, 15], [0.5, 0.2]).unwrap();
        let waves = map.waves();
        let sum: f64 = waves.iter().map(|(_, square)| square).sum();
        assert!((sum - 5.0).abs() < 1e-12 && (sum / map.rms_height().powi(2) - 1.0).abs() < 1e-12);
        for (waves_in, length, square) in [(2.0, 6.0, 4.5), (4.0, 3.0, 0.5)] {
            let near = |q: f64| (q / (TAU * waves_in / length) - 1.0).abs() < 1e-12;
            let found: f64 = waves.iter().filter(|(q, _)| near(*q)).map(|(_, s)| s).sum();
            assert!((found - square).abs() < 1e-12, "{found}");
        }
    }

    #[test]
    fn steps_are_those_of_neighbours_where_a_map_is_periodic() {
        assert!((0.5..2.0).contains(&wide().seam_step()) && wide().edges_meet());
        let part = part(&wide(), [100, 121]);
        assert!(part.seam_step() > 5.0 && !part.edges_meet());
        let flat = HeightMap::new(vec![1.0; 12], [3, 4], [1.0; 2]).unwrap();
        assert!(flat.seam_step() <= 0.0 && flat.edges_meet());
        // A sphere's edges match, its slopes do not.
        assert!((0.5..2.0).contains(&wide().seam_kink()), "{}", wide().seam_kink());
        let at = |k: usize| (k as f64 - 32.0).powi(2);
        let sphere = (0..65 * 65).map(|k| -at(k / 65) - at(k % 65)).collect();
        let sphere = HeightMap::new(sphere, [65, 65], [1.0; 2]).unwrap();
        assert!(sphere.edges_meet() && sphere.seam_kink() > 30.0, "{}", sphere.seam_kink());
    }

    #[test]
    fn the_seam_goes_and_what_is_inside_stays() {
        let part = part(&wide(), [100, 121]);
        let periodic = part.periodic_part();
        assert!(periodic.edges_meet(), "{}", periodic.seam_step());
        // The difference is smooth: harmonic except at the edges.
        let taken: Vec<f64> =
            part.heights().iter().zip(periodic.heights()).map(|(a, b)| a - b).collect();
        for (i, j) in [(1, 1), (50, 60), (98, 119), (20, 100)] {
            let at = i * 121 + j;
            let around = taken[at - 1] + taken[at + 1] + taken[at - 121] + taken[at + 121];
            assert!((around - 4.0 * taken[at]).abs() < 1e-10 * part.rms_height(), "{i} {j}");
        }
        // A map whose edges match changes little.
        let (whole, less) = (wide(), wide().periodic_part());
        let taken = whole.heights().iter().zip(less.heights()).map(|(a, b)| (a - b).abs());
        assert!(taken.fold(0.0, f64::max) < 0.2 * whole.rms_height());
    }
}
