//! Gaussian-process regression on the solved cases (Rasmussen & Williams 2006, algorithm 2.1
//! \[recalled\]): interpolates the means of the solved cases and gives the standard deviation of
//! the interpolation.

use crate::evidence::coordinates::Coordinates;

/// Standard deviation of the constant.
const CONSTANT: f64 = 2.0;
/// Lengths over which results change: ln p/(E g), ln α, ln E g/H beyond yielding, skewness, ln of
/// the ratio of slopes.
const LENGTHS: [f64; 5] = [2.0, 4.0, 0.35, 1.2, 2.0];
/// Standard deviation per unit of the logarithm of the ratio of slopes.
const PER_SLOPES: f64 = 0.06;
/// Standard deviation between families of the narrowest spectra.
const FAMILY: f64 = 0.01;
/// α of a single wave, the least.
pub(crate) const NARROWEST: f64 = 1.5;
/// Standard deviation of a single row.
const ROW: f64 = 0.005;

/// Where A E g/p passes from elastic contact, 2.4, to fully plastic contact, E g/H.
pub(crate) const ELASTIC: f64 = 2.4;

/// A place as coordinates of the kernel.
type Input = [f64; 5];

/// A value at a place of the table with its standard error.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SolvedValue {
    pub(crate) place: Coordinates,
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// Standard deviations of a quantity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spread {
    /// Of the change with load, bandwidth and hardness.
    pub(crate) amplitude: f64,
    /// Per unit of skewness.
    pub(crate) skewness: f64,
    /// Between spectra of one bandwidth with the Hurst exponent of the solved ones, per unit of
    /// ln α: the broader they are, the more they can differ.
    pub(crate) spectrum: f64,
}

impl Spread {
    /// Between families of the bandwidth of this place.
    fn of_family(self, place: &Coordinates) -> f64 {
        FAMILY.hypot(self.spectrum * (place.alpha / NARROWEST).ln())
    }
}

/// The smooth surface.
#[derive(Debug, Clone)]
pub(crate) struct Process {
    spread: Spread,
    inputs: Vec<Input>,
    factor: Factor,
    weights: Vec<f64>,
}

impl Process {
    /// The surface through these values; `None` if there are none.
    pub(crate) fn through(solved: &[SolvedValue], spread: Spread) -> Option<Self> {
        let inputs: Vec<Input> = solved.iter().map(|solved| input(&solved.place)).collect();
        let factor = Factor::new(solved.len(), |i, j| {
            covariance(&inputs[i], &inputs[j], spread)
                + noise([&solved[i], &solved[j]], spread, i == j)
        });
        let factor = factor.filter(|_| !solved.is_empty())?;
        let weights = factor.solve(solved.iter().map(|solved| solved.value).collect());
        Some(Self { spread, inputs, factor, weights })
    }

    /// The value at a place and its standard deviation, as the mean of all surfaces there.
    pub(crate) fn at(&self, place: &Coordinates) -> [f64; 2] {
        let here = input(place);
        let of = |input: &Input| covariance(&here, input, self.spread);
        let shared: Vec<f64> = self.inputs.iter().map(of).collect();
        let value = dot(&shared, &self.weights);
        let explained = self.factor.half_solve(shared);
        let variance = of(&here) - dot(&explained, &explained);
        [value, variance.max(0.0).sqrt()]
    }
}

fn input(place: &Coordinates) -> Input {
    // 0, elastic, and the logarithm of E g/H where contacts are fully plastic.
    let plastic = 0.25 * (place.strain / ELASTIC).powi(4).ln_1p();
    [place.load.ln(), place.alpha.ln(), plastic, place.shape.skewness, place.shape.slope_ratio.ln()]
}

/// Isotropic Gaussian surfaces change with load, bandwidth and hardness; the effect of a skewness
/// or a lay adds to that, in proportion to it for small ones.
fn covariance(a: &Input, b: &Input, spread: Spread) -> f64 {
    let square = |k: usize| -0.5 * ((a[k] - b[k]) / LENGTHS[k]).powi(2);
    let effect = |k: usize, unit: f64| match a[k] * b[k] {
        0.0 => 0.0,
        both => unit * unit * both * square(k).exp(),
    };
    let parts = spread.amplitude.powi(2) * square(1).exp()
        + effect(3, spread.skewness)
        + effect(4, PER_SLOPES);
    CONSTANT * CONSTANT + (square(0) + square(2)).exp() * parts
}

/// The same surfaces stand behind all materials of a family, and partly behind its next loads.
fn noise([a, b]: [&SolvedValue; 2], spread: Spread, same: bool) -> f64 {
    if !a.place.same_family(&b.place) {
        return 0.0;
    }
    let shared = a.error * b.error * (-(a.place.load / b.place.load).ln().abs()).exp();
    let row = if same { ROW * ROW } else { 0.0 };
    spread.of_family(&a.place).powi(2) + shared + row
}

/// The lower triangle L of a matrix L Lᵀ, row by row.
#[derive(Debug, Clone)]
struct Factor(Vec<Vec<f64>>);

impl Factor {
    /// Of a symmetric matrix with these entries, asked for at i ≥ j; `None` unless it is positive
    /// definite.
    fn new(size: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Self> {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(size);
        for i in 0..size {
            let mut row = Vec::with_capacity(i + 1);
            for (j, above) in rows.iter().enumerate() {
                row.push((entry(i, j) - dot(&row, &above[..j])) / above[j]);
            }
            let rest = entry(i, i) - dot(&row, &row);
            row.push(Some(rest.sqrt()).filter(|_| rest > 0.0)?);
            rows.push(row);
        }
        Some(Self(rows))
    }

    /// L⁻¹ b.
    fn half_solve(&self, mut b: Vec<f64>) -> Vec<f64> {
        for (i, row) in self.0.iter().enumerate() {
            b[i] = (b[i] - dot(&row[..i], &b[..i])) / row[i];
        }
        b
    }

    /// (L Lᵀ)⁻¹ b.
    fn solve(&self, b: Vec<f64>) -> Vec<f64> {
        let mut x = self.half_solve(b);
        for (i, row) in self.0.iter().enumerate().rev() {
            x[i] /= row[i];
            let (known, last) = x.split_at_mut(i);
            known.iter_mut().zip(row).for_each(|(x, l)| *x -= l * last[0]);
        }
        x
    }
}

/// The scalar product, in eight sums that a processor adds at once.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (chunks, others) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest = chunks.remainder().iter().zip(others.remainder());
    let rest: f64 = rest.map(|(a, b)| a * b).sum();
    for (a, b) in chunks.zip(others) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SurfaceShape;
    use crate::evidence::coordinates::Spectrum;

    fn solved_value(alpha: f64, load: f64, value: f64) -> SolvedValue {
        let shape = SurfaceShape::default();
        let (contacts, surfaces) = (100.0, 4.0);
        let place = Coordinates {
            alpha,
            shape,
            spectrum: Spectrum::Unlike,
            index: 0.0,
            strain: 0.0,
            load,
            contacts,
            surfaces,
        };
        SolvedValue { place, value, error: 0.01 }
    }

    #[test]
    fn a_plane_is_met_between_its_points_and_unknown_far_away() {
        let plane = |alpha: f64, load: f64| 0.9 + 0.1 * alpha.ln() - 0.05 * load.ln();
        let loads = [1e-4, 1e-3, 1e-2, 1e-1];
        let all: Vec<SolvedValue> = [3.0, 10.0, 30.0]
            .into_iter()
            .flat_map(|alpha| loads.map(|load| solved_value(alpha, load, plane(alpha, load))))
            .collect();
        let spread = Spread { amplitude: 0.5, skewness: 0.6, spectrum: 0.01 };
        let process = Process::through(&all, spread).unwrap();
        let [value, deviation] = process.at(&solved_value(17.0, 3e-3, 0.0).place);
        assert!((value - plane(17.0, 3e-3)).abs() < 0.01, "{value}");
        assert!((0.02..0.09).contains(&deviation), "{deviation}");
        let [_, far] = process.at(&solved_value(3000.0, 3e-3, 0.0).place);
        assert!(far > 3.0 * deviation, "{far}");
        let mut skewed = solved_value(17.0, 3e-3, 0.0).place;
        skewed.shape.skewness = -1.0;
        let [same, unknown] = process.at(&skewed);
        assert!((same - value).abs() < 1e-9 && unknown > 0.55, "{unknown}");
        // The broader the spectra, the more surfaces of one bandwidth differ.
        let broad = Spread { amplitude: 0.5, skewness: 0.6, spectrum: 0.03 };
        let [little, much] =
            [3.0, 17.0].map(|a| broad.of_family(&solved_value(a, 3e-3, 0.0).place));
        assert!(much > 3.0 * little && little > 0.02, "{little} {much}");
        assert!(Process::through(&[], spread).is_none());
    }

    #[test]
    fn a_system_is_solved_and_an_indefinite_one_is_refused() {
        let entry =
            |i: usize, j: usize| 1.0 / (1.0 + (i as f64 - j as f64).abs()) + f64::from(i == j);
        let x: Vec<f64> = (0..21).map(|k| f64::from(k).sin()).collect();
        let b = (0..21).map(|i| (0..21).map(|j| entry(i, j) * x[j]).sum()).collect();
        let found = Factor::new(21, entry).unwrap().solve(b);
        assert!(found.iter().zip(&x).all(|(a, b)| (a - b).abs() < 1e-13));
        assert!(Factor::new(2, |i, j| if i == j { 1.0 } else { 2.0 }).is_none());
    }
}
