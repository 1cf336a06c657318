//! The half-space: deflections from pressures by Fourier transforms, and an approximate inverse.

use std::sync::Arc;

use crate::HeightMap;
use crate::compliance::{rectangles, waves};
use crate::parallel;
use asperity_fft::{Complex64, ComplexToReal, Fft, RealToComplex, fast_length};

/// Rows and columns that move together between the layouts: 8 complex numbers are two cache lines.
const BLOCK: usize = 8;

/// Boundary condition at the edges of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Boundary {
    /// Periodic repetition of the map, with the steps of edges that do not match.
    #[default]
    Periodic,
    /// A free half-space outside the map, for scans with edges that do not match and for single
    /// bodies. Four times the cost of transforms.
    Free,
}

/// The operation of [`HalfSpace::apply`] on a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Filter {
    /// Pressures to deflections.
    Deflect,
    /// The inverse of the compliance of every wave: exact in full contact, and otherwise a
    /// preconditioner that makes iterations nearly independent of the number of pixels.
    Undo,
}

/// A linear map from the pressures of some pixels to their deflections.
pub(crate) trait Compliance {
    /// Filters `map` in place.
    fn apply(&mut self, filter: Filter, map: &mut [f64]);
}

/// The linear map from the pressures of n x m pixels to their deflections.
///
/// Real transforms of the rows, a transposition in blocks, complex transforms of the columns with
/// the filter between, and back: three passes over memory.
pub struct HalfSpace {
    rows: usize,
    columns: usize,
    padded_rows: usize,
    padded_columns: usize,
    /// Of the waves \[m/Pa\], a quarter of the plane.
    compliance: Vec<f64>,
    row_forward: Arc<dyn RealToComplex<f64>>,
    row_backward: Arc<dyn ComplexToReal<f64>>,
    column_forward: Arc<dyn Fft<f64>>,
    column_backward: Arc<dyn Fft<f64>>,
    by_rows: Vec<Complex64>,
    by_columns: Vec<Complex64>,
}

impl HalfSpace {
    pub(crate) fn new(map: &HeightMap, modulus: f64, boundary: Boundary) -> Self {
        let (shape, pixel) = (map.shape(), map.pixel());
        match boundary {
            Boundary::Periodic => Self::of_waves(shape, shape, waves(shape, pixel, modulus)),
            Boundary::Free => {
                let padded = shape.map(|n| 2 * fast_length(n));
                Self::of_waves(shape, padded, rectangles(padded, pixel, modulus))
            }
        }
    }

    /// From the `compliance` \[m/Pa\] of the waves on `padded` = \[rows, columns\] pixels, of which
    /// a map has the first of both; that of wave i down a column and j along a row stands at
    /// `j * (rows / 2 + 1) + i`, up to half of rows and columns.
    #[must_use]
    pub fn of_waves(
        [rows, columns]: [usize; 2],
        [padded_rows, padded_columns]: [usize; 2],
        compliance: Vec<f64>,
    ) -> Self {
        let half = padded_columns / 2 + 1;
        Self {
            rows,
            columns,
            padded_rows,
            padded_columns,
            compliance,
            row_forward: asperity_fft::real_forward(padded_columns),
            row_backward: asperity_fft::real_inverse(padded_columns),
            column_forward: asperity_fft::forward(padded_rows),
            column_backward: asperity_fft::inverse(padded_rows),
            by_rows: vec![Complex64::ZERO; rows * half],
            by_columns: vec![Complex64::ZERO; half * padded_rows],
        }
    }

    /// The deflections \[m\] under these pressures \[Pa\], row after row.
    pub fn deflect(&mut self, pressures: &[f64], deflections: &mut [f64]) {
        deflections.copy_from_slice(pressures);
        parallel::inside(|| self.apply(Filter::Deflect, deflections));
    }

    /// Squares of the amplitudes of `map`'s waves: `each` gets them with the frequencies of the
    /// wave along rows and columns \[waves per pixel\]; the results are summed by columns.
    pub(crate) fn spectrum<T: Send>(
        &mut self,
        map: &[f64],
        zero: impl Fn() -> T + Sync,
        each: impl Fn(&mut T, [f64; 2], f64) + Sync,
    ) -> Vec<T> {
        self.transform_rows(map);
        let [rows, columns] = [self.padded_rows, self.padded_columns];
        self.each_column(|j, column, _| {
            let mut sum = zero();
            // The other half of the plane is the same again, but for the columns on its edge.
            let weight = if j == 0 || 2 * j == columns { 1.0 } else { 2.0 };
            for (i, wave) in column.iter().enumerate() {
                let frequency = [i.min(rows - i) as f64 / rows as f64, j as f64 / columns as f64];
                each(&mut sum, frequency, weight * wave.norm_sqr());
            }
            sum
        })
    }

    fn transform_rows(&mut self, map: &[f64]) {
        let half = self.padded_columns / 2 + 1;
        let forward = &self.row_forward;
        let rows = map.chunks(BLOCK * self.columns);
        parallel::map(
            self.by_rows.chunks_mut(BLOCK * half).zip(rows),
            || (forward.make_input_vec(), forward.make_scratch_vec()),
            |(line, scratch), (spectra, rows)| {
                for (spectrum, row) in spectra.chunks_mut(half).zip(rows.chunks(self.columns)) {
                    line[..row.len()].copy_from_slice(row);
                    line[row.len()..].fill(0.0);
                    // It fails only for wrong lengths.
                    let _ = forward.process_with_scratch(line, spectrum, scratch);
                }
            },
        );
    }

    /// Transforms the columns; `each` gets the number of a column, its waves, and scratch.
    fn each_column<T: Send>(
        &mut self,
        each: impl Fn(usize, &mut [Complex64], &mut [Complex64]) -> T + Sync,
    ) -> Vec<T> {
        let half = self.padded_columns / 2 + 1;
        let (forward, backward) = (&self.column_forward, &self.column_backward);
        let scratch = forward.get_inplace_scratch_len().max(backward.get_inplace_scratch_len());
        let all = parallel::map(
            self.by_columns.chunks_mut(BLOCK * self.padded_rows).enumerate(),
            || vec![Complex64::ZERO; scratch],
            |scratch, (block, columns)| {
                let first = block * BLOCK;
                let count = columns.len() / self.padded_rows;
                for (i, row) in self.by_rows.chunks(half).enumerate() {
                    for (j, &wave) in row[first..first + count].iter().enumerate() {
                        columns[j * self.padded_rows + i] = wave;
                    }
                }
                let columns = columns.chunks_mut(self.padded_rows).enumerate();
                let each = columns.map(|(j, column)| {
                    column[self.rows..].fill(Complex64::ZERO);
                    forward.process_with_scratch(column, scratch);
                    each(first + j, column, scratch)
                });
                each.collect::<Vec<T>>()
            },
        );
        all.into_iter().flatten().collect()
    }

    fn transform_rows_back(&mut self, map: &mut [f64]) {
        let half = self.padded_columns / 2 + 1;
        let backward = &self.row_backward;
        let rows = map.chunks_mut(BLOCK * self.columns);
        parallel::map(
            self.by_rows.chunks_mut(BLOCK * half).zip(rows).enumerate(),
            || (backward.make_output_vec(), backward.make_scratch_vec()),
            |(line, scratch), (block, (spectra, rows))| {
                let first = block * BLOCK;
                let count = spectra.len() / half;
                for (j, column) in self.by_columns.chunks(self.padded_rows).enumerate() {
                    for (i, &wave) in column[first..first + count].iter().enumerate() {
                        spectra[i * half + j] = wave;
                    }
                }
                for (spectrum, row) in spectra.chunks_mut(half).zip(rows.chunks_mut(self.columns)) {
                    // Rounding leaves small imaginary parts, which the transform refuses.
                    spectrum[0].im = 0.0;
                    if self.padded_columns.is_multiple_of(2) {
                        spectrum[half - 1].im = 0.0;
                    }
                    let _ = backward.process_with_scratch(spectrum, line, scratch);
                    row.copy_from_slice(&line[..row.len()]);
                }
            },
        );
    }
}

impl Compliance for HalfSpace {
    fn apply(&mut self, filter: Filter, map: &mut [f64]) {
        self.transform_rows(map);
        let backward = Arc::clone(&self.column_backward);
        let compliance = std::mem::take(&mut self.compliance);
        let quarter = self.padded_rows / 2 + 1;
        // rustfft scales neither way.
        let scale = 1.0 / (self.padded_rows as f64 * self.padded_columns as f64);
        let factor = |compliance: f64| match filter {
            Filter::Deflect => compliance * scale,
            Filter::Undo if compliance > 0.0 => scale / compliance,
            Filter::Undo => 0.0,
        };
        self.each_column(|j, column, scratch| {
            let compliance = &compliance[j * quarter..][..quarter];
            let (head, tail) = column.split_at_mut(quarter);
            for (wave, &compliance) in head.iter_mut().zip(compliance) {
                *wave *= factor(compliance);
            }
            for (wave, &compliance) in tail.iter_mut().rev().zip(&compliance[1..]) {
                *wave *= factor(compliance);
            }
            backward.process_with_scratch(column, scratch);
        });
        self.compliance = compliance;
        self.transform_rows_back(map);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::compliance::rectangle;

    /// Every size, odd and even, against the sum over the pixels.
    #[test]
    fn deflections_are_sums_over_all_pixels() {
        for shape @ [rows, columns] in [[2, 2], [3, 5], [9, 8], [17, 4]] {
            let pixel @ [dy, dx] = [2.0, 3.0];
            let map = HeightMap::new(vec![0.0; rows * columns], shape, pixel).unwrap();
            let pressures: Vec<f64> = (0..rows * columns).map(|i| (i as f64).sin()).collect();
            for boundary in [Boundary::Periodic, Boundary::Free] {
                let mut space = HalfSpace::new(&map, 5.0, boundary);
                let mut found = pressures.clone();
                space.apply(Filter::Deflect, &mut found);
                for (at, found) in found.iter().enumerate() {
                    let required: f64 = (0..rows * columns)
                        .map(|from| {
                            let (i, j) = (at / columns, at % columns);
                            let (k, l) = (from / columns, from % columns);
                            let (a, b) = (i as f64 - k as f64, j as f64 - l as f64);
                            pressures[from]
                                * match boundary {
                                    Boundary::Free => {
                                        rectangle(b * dx, a * dy, dx, dy) / (PI * 5.0)
                                    }
                                    Boundary::Periodic => sum_of_waves(shape, pixel, a, b) / 5.0,
                                }
                        })
                        .sum();
                    assert!((found - required).abs() < 1e-13, "{shape:?} {boundary:?}");
                }
            }
        }
    }

    /// Sum of all waves at the distance of a rows and b columns.
    fn sum_of_waves([rows, columns]: [usize; 2], [dy, dx]: [f64; 2], a: f64, b: f64) -> f64 {
        let mut sum = 0.0;
        for (i, j) in (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j))).skip(1) {
            let (k, l) = (i.min(rows - i) as f64, j.min(columns - j) as f64);
            let q = TAU * (k / (rows as f64 * dy)).hypot(l / (columns as f64 * dx));
            let phase = i as f64 * a / rows as f64 + j as f64 * b / columns as f64;
            sum += 2.0 / q * (TAU * phase).cos();
        }
        sum / (rows * columns) as f64
    }
}
