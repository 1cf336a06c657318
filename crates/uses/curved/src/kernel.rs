//! The deflection of the half spaces under pressures on a regular grid, to spectral accuracy.
//!
//! The kernel, 1/(π E r) or (2/(π E)) ln(L/|x|), is cut off at the diagonal of the grid, beyond
//! which no two points lie, and transformed exactly: the method of Vico, Greengard and Ferrando
//! (2016) \[recalled\]. The pressures are padded by that diagonal.

use std::f64::consts::PI;
use std::sync::Arc;

use asperity_fft::{
    Complex64, ComplexToReal, Fft, RealToComplex, fast_length, forward, inverse, real_forward,
    real_inverse,
};

/// Nodes and weights of the Gauss-Legendre rule with 4 points on -1 to 1, right half: over a length
/// of 1/2 they err by 1e-12 of the functions here.
const GAUSS: [[f64; 2]; 2] = [
    [0.339_981_043_584_856_26, 0.652_145_154_862_546_1],
    [0.861_136_311_594_052_6, 0.347_854_845_137_453_85],
];

/// The integral of a function from 0, between multiples of 1/2 by a rule of Gauss.
struct Primitive {
    of: fn(f64) -> f64,
    at_halves: Vec<f64>,
}

impl Primitive {
    /// For arguments up to `largest`; the function varies slowly over a length of 1.
    fn new(of: fn(f64) -> f64, largest: f64) -> Self {
        let mut at_halves = vec![0.0];
        let mut sum = 0.0;
        for k in 0..2 * (largest as usize + 1) {
            sum += gauss(of, 0.5 * k as f64, 0.5 * (k as f64 + 1.0));
            at_halves.push(sum);
        }
        Self { of, at_halves }
    }

    fn at(&self, x: f64) -> f64 {
        let half = ((2.0 * x) as usize).min(self.at_halves.len() - 1);
        self.at_halves[half] + gauss(self.of, 0.5 * half as f64, x)
    }
}

fn gauss(of: fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let pair =
        |[node, weight]: [f64; 2]| weight * (of(middle - half * node) + of(middle + half * node));
    half * GAUSS.into_iter().map(pair).sum::<f64>()
}

/// sin(x)/x.
fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-8 { 1.0 } else { x.sin() / x }
}

/// The product with the kernel, on a grid of n points a side, or of n points of a line.
pub(crate) struct Deflection {
    /// Points along a row.
    n: usize,
    /// The transform of the kernel on the padded grid, over the number of its points.
    spectrum: Vec<f64>,
    rows: Arc<dyn RealToComplex<f64>>,
    back: Arc<dyn ComplexToReal<f64>>,
    columns: [Arc<dyn Fft<f64>>; 2],
    complex: Vec<Complex64>,
    column: Vec<Complex64>,
    row: Vec<f64>,
}

/// An even number of points at least `n` with small prime factors.
pub(crate) fn quick(n: usize) -> usize {
    2 * fast_length(n.div_ceil(2).max(1))
}

impl Deflection {
    /// Of a grid of n x n points with these distances \[m\].
    pub(crate) fn of_area(n: usize, [dx, dy]: [f64; 2], modulus: f64) -> Self {
        let [width, height] = [n as f64 * dx, n as f64 * dy];
        let cut = width.hypot(height);
        let [nx, ny] = [dx, dy].map(|step| quick(n + (cut / step).ceil() as usize + 1));
        let [qx, qy] = [2.0 * PI / (nx as f64 * dx), 2.0 * PI / (ny as f64 * dy)];
        let largest = cut * (0.5 * qx * nx as f64).hypot(0.5 * qy * ny as f64);
        let bessel = Primitive::new(libm::j0, largest);
        Self::new(n, [nx, ny], |i, j| {
            let q = (qx * i as f64).hypot(qy * j as f64);
            2.0 / modulus * if q > 0.0 { bessel.at(q * cut) / q } else { cut }
        })
    }

    /// Of a line of n points, per length, with ln(L/|x|) and L = `reference` \[m\].
    pub(crate) fn of_line(n: usize, dx: f64, modulus: f64, reference: f64) -> Self {
        let cut = n as f64 * dx;
        let nx = quick(2 * n + 2);
        let qx = 2.0 * PI / (nx as f64 * dx);
        let sine = Primitive::new(sinc, PI * cut / dx);
        let logarithm = (reference / cut).ln();
        Self::new(n, [nx, 1], |i, _| {
            let x = qx * i as f64 * cut;
            let whole = if i == 0 { 1.0 } else { sine.at(x) / x };
            4.0 * cut / (PI * modulus) * (logarithm * sinc(x) + whole)
        })
    }

    /// Of `n` points a row on a padded grid of `size`, from the transform of the kernel at
    /// multiples of the least waves, which is even along both axes.
    fn new(n: usize, size: [usize; 2], transform: impl Fn(usize, usize) -> f64) -> Self {
        let [columns, rows] = size;
        let half = columns / 2 + 1;
        let points = (columns * rows) as f64;
        let wave = |k: usize| transform(k % half, (k / half).min(rows - k / half)) / points;
        Self {
            n,
            spectrum: (0..half * rows).map(wave).collect(),
            rows: real_forward(columns),
            back: real_inverse(columns),
            columns: [forward(rows), inverse(rows)],
            complex: vec![Complex64::default(); half * rows],
            column: vec![Complex64::default(); rows],
            row: vec![0.0; columns],
        }
    }

    fn half(&self) -> usize {
        self.row.len() / 2 + 1
    }

    fn forward_row(&mut self, j: usize) {
        let half = self.half();
        let into = &mut self.complex[j * half..(j + 1) * half];
        // The lengths are the plan's.
        let _ = self.rows.process(&mut self.row, into);
    }

    fn along_columns(&mut self, direction: usize) {
        let (half, rows) = (self.half(), self.column.len());
        if rows == 1 {
            return;
        }
        for i in 0..half {
            for j in 0..rows {
                self.column[j] = self.complex[j * half + i];
            }
            self.columns[direction].process(&mut self.column);
            for j in 0..rows {
                self.complex[j * half + i] = self.column[j];
            }
        }
    }

    /// The deflections \[m\] under these pressures \[Pa\].
    pub(crate) fn product(&mut self, pressures: &[f64], deflections: &mut [f64]) {
        let (nx, half) = (self.n, self.half());
        self.complex.fill(Complex64::default());
        for (j, pressures) in pressures.chunks(nx).enumerate() {
            self.row[..nx].copy_from_slice(pressures);
            self.row[nx..].fill(0.0);
            self.forward_row(j);
        }
        self.along_columns(0);
        for (value, factor) in self.complex.iter_mut().zip(&self.spectrum) {
            *value *= *factor;
        }
        self.along_columns(1);
        for (j, deflections) in deflections.chunks_mut(nx).enumerate() {
            let from = &mut self.complex[j * half..(j + 1) * half];
            // Ends of real rows are real.
            from[0].im = 0.0;
            from[half - 1].im = 0.0;
            let _ = self.back.process(from, &mut self.row);
            deflections.copy_from_slice(&self.row[..nx]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gaussian_pressure_on_an_area_has_its_closed_deflection() {
        // Under p₀ exp(-r²/s²) the centre sinks by √π p₀ s/E.
        let (n, s) = (64, 1.0);
        let step = [14.0 * s / n as f64, 18.0 * s / n as f64];
        let pressure = |k: usize| {
            let [x, y] = [(k % n, step[0]), (k / n, step[1])].map(|(i, h)| (i as f64 - 32.0) * h);
            (-(x * x + y * y) / (s * s)).exp()
        };
        let pressures: Vec<f64> = (0..n * n).map(pressure).collect();
        let mut found = vec![0.0; n * n];
        Deflection::of_area(n, step, 2.0).product(&pressures, &mut found);
        let right = 0.5 * PI.sqrt() * s;
        assert!((found[32 * n + 32] / right - 1.0).abs() < 1e-12, "{}", found[32 * n + 32]);
    }

    #[test]
    fn a_gaussian_pressure_on_a_line_has_its_closed_deflection() {
        // (2/(π E)) ∫ exp(-x²/s²) ln(L/|x|) dx = (2 s/(√π E)) (ln(L/s) + γ/2 + ln 2).
        let (n, s) = (64, 1.0_f64);
        let step = 14.0 * s / n as f64;
        let pressures: Vec<f64> =
            (0..n).map(|i| (-((i as f64 - 32.0) * step / s).powi(2)).exp()).collect();
        let mut found = vec![0.0; n];
        Deflection::of_line(n, step, 2.0, 30.0).product(&pressures, &mut found);
        let euler = 0.577_215_664_901_532_9;
        let right = s / PI.sqrt() * ((30.0 / s).ln() + 0.5 * euler + 2.0_f64.ln());
        assert!((found[32] / right - 1.0).abs() < 1e-12, "{} {right}", found[32]);
    }
}
