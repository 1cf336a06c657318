//! The waves of a real map, and maps with other phases or another skewness made of them.

use asperity_fft::Complex64;

use crate::parallel::{self, sum};
use crate::{BemError, HeightMap};

/// Heights and waves are made those of the map by turns, so often.
const TURNS: usize = 10;
/// The largest bend c of exp(c g), beyond which the skewness hardly grows.
const MOST_BENT: f64 = 4.0;
/// More than false position takes, about 10.
const TRIALS: usize = 60;
/// Accepted deviation of the skewness, relative to the larger of it and a tenth.
const TOLERANCE: f64 = 1e-4;

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

impl HeightMap {
    /// Another surface like this periodic one, by the seed: with all of its spectrum, and nearly
    /// its distribution of heights, but random phases (Schreiber & Schmitz 1996 \[recalled\]).
    #[must_use]
    pub fn another(&self, seed: u64) -> Self {
        let count = self.heights().len();
        let waves = Waves::of(self.heights(), self.shape());
        let mut sorted = self.heights().to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let key = mix(seed);
        let mut heights: Vec<f64> = (0..count).map(|k| mix(key ^ k as u64) as f64).collect();
        let mut order: Vec<usize> = (0..count).collect();
        for _ in 0..TURNS {
            order.sort_unstable_by(|a, b| heights[*a].total_cmp(&heights[*b]));
            order.iter().zip(&sorted).for_each(|(at, height)| heights[*at] = *height);
            heights = waves.with_phases_of(&heights).heights();
        }
        heights.iter_mut().for_each(|height| *height /= count as f64);
        self.with_heights(heights)
    }
}

/// Heights with these waves' amplitudes and a skewness.
pub(super) fn skewed(waves: &Waves, skewness: f64) -> Result<Vec<f64>, BemError> {
    let gaussian = waves.heights();
    let [square] = sum([&gaussian], |[h]| [h * h]);
    let sq = (square / gaussian.len() as f64).sqrt();
    let bent = |c: f64| {
        let bent: Vec<f64> = gaussian.iter().map(|h| (c * h / sq).exp_m1() / c).collect();
        let heights = waves.with_phases_of(&bent).heights();
        let [cube] = sum([&heights], |[h]| [(h / sq).powi(3)]);
        (cube / heights.len() as f64 - skewness, heights)
    };
    let [cube] = sum([&gaussian], |[h]| [(h / sq).powi(3)]);
    let tolerance = TOLERANCE * skewness.abs().max(0.1);
    let natural = cube / gaussian.len() as f64 - skewness;
    if natural.abs() <= tolerance {
        return Ok(gaussian);
    }
    // Doubled until the skewness is passed, then by false position (Illinois).
    let side = -natural.signum();
    let (mut low, mut high) = ((0.0, natural), None);
    let mut c = 0.25 * side;
    for _ in 0..TRIALS {
        let (off, heights) = bent(c);
        if off.abs() <= tolerance {
            return Ok(heights);
        }
        let passed = off * side > 0.0;
        match &mut high {
            None if !passed => (low, c) = ((c, off), 2.0 * c),
            None => high = Some((c, off)),
            Some(high) if passed => (*high, low.1) = ((c, off), 0.5 * low.1),
            Some(high) => (low, high.1) = ((c, off), 0.5 * high.1),
        }
        match high {
            Some(high) => c = (low.0 * high.1 - high.0 * low.1) / (high.1 - low.1),
            None if c.abs() > MOST_BENT => break,
            None => {}
        }
    }
    let required = "a skewness that these waves can have (nearer 0, or with more waves)";
    Err(BemError::OutOfRange { field: "skewness", found: skewness, required })
}

/// The next number of SplitMix64 after the state z.
pub(super) fn mix(z: u64) -> u64 {
    let z = z.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
