//! The waves of a real map.

use asperity_fft::Complex64;

use crate::parallel;

/// Complex amplitudes of the waves of a real map: j = 0 to columns/2 along a row, each with all i
/// down a column.
#[derive(Clone)]
pub(super) struct Waves {
    shape: [usize; 2],
    values: Vec<Complex64>,
}

impl Waves {
    pub(super) fn none(shape: [usize; 2]) -> Self {
        let [rows, columns] = shape;
        Self { shape, values: vec![Complex64::ZERO; (columns / 2 + 1) * rows] }
    }

    /// Sets wave (i, j), with i > 0 where j = 0.
    pub(super) fn set(&mut self, i: i64, j: i64, value: Complex64) {
        let rows = self.shape[0];
        self.values[j as usize * rows + i.rem_euclid(rows as i64) as usize] = value;
        if j == 0 {
            self.values[rows - i as usize] = value.conj();
        }
    }

    /// The waves of heights.
    pub(super) fn of(heights: &[f64], shape: [usize; 2]) -> Self {
        let [rows, columns] = shape;
        let half = columns / 2 + 1;
        let along = asperity_fft::real_forward(columns);
        let each = parallel::map(
            heights.chunks(columns),
            || (),
            |(), row| {
                let (mut row, mut waves) = (row.to_vec(), vec![Complex64::ZERO; half]);
                // It fails only for wrong lengths.
                let _ = along.process(&mut row, &mut waves);
                waves
            },
        );
        let mut values = vec![Complex64::ZERO; half * rows];
        for (a, waves) in each.iter().enumerate() {
            waves.iter().enumerate().for_each(|(j, wave)| values[j * rows + a] = *wave);
        }
        let down = asperity_fft::forward(rows);
        parallel::map(values.chunks_mut(rows), || (), |(), column| down.process(column));
        Self { shape, values }
    }

    /// The heights.
    pub(super) fn heights(&self) -> Vec<f64> {
        let [rows, columns] = self.shape;
        let mut values = self.values.clone();
        let down = asperity_fft::inverse(rows);
        parallel::map(values.chunks_mut(rows), || (), |(), column| down.process(column));
        let along = asperity_fft::real_inverse(columns);
        let mut heights = vec![0.0; rows * columns];
        parallel::map(
            heights.chunks_mut(columns).enumerate(),
            || (),
            |(), (a, row)| {
                let half = 0..columns / 2 + 1;
                let mut waves: Vec<Complex64> = half.map(|j| values[j * rows + a]).collect();
                // Imaginary parts are rounding, which the transform refuses.
                waves[0].im = 0.0;
                // It fails only for wrong lengths and for these.
                let _ = along.process(&mut waves, row);
            },
        );
        heights
    }

    /// The same amplitudes with the phases of the waves of other heights.
    pub(super) fn with_phases_of(&self, heights: &[f64]) -> Self {
        let mut other = Self::of(heights, self.shape);
        for (value, own) in other.values.iter_mut().zip(&self.values) {
            let (size, found) = (own.norm(), value.norm());
            *value = match (size > 0.0, found > 0.0) {
                (false, _) => Complex64::ZERO,
                (true, false) => *own,
                (true, true) => *value * (size / found),
            };
        }
        other
    }
}
