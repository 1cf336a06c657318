//! The deflection of the half spaces under pressures on a regular grid, to spectral accuracy.
//!
//! The kernel, 1/(π E r) or (2/(π E)) ln(L/|x|), is cut off at the diagonal of the grid, beyond
//! which no two points lie, and transformed exactly: the method of Vico, Greengard and Ferrando
//! (2016) \[recalled\]. The pressures are padded by that diagonal.

use std::f64::consts::PI;

use asperity_bem::HalfSpace;
use asperity_fft::fast_length;
use asperity_quadrature::{Legendre, legendre};

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

/// By 4 points, which err by 1e-12 of the functions here over a length of 1/2.
fn gauss(of: fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let Legendre { nodes, weights, .. } = legendre(4);
    let each =
        nodes.iter().zip(weights).map(|(node, weight)| weight * of(from + (to - from) * node));
    (to - from) * each.sum::<f64>()
}

/// sin(x)/x.
fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-8 { 1.0 } else { x.sin() / x }
}

/// An even number of points at least `n` with small prime factors.
pub(crate) fn quick(n: usize) -> usize {
    2 * fast_length(n.div_ceil(2).max(1))
}

/// Of a grid of n x n points with these distances \[m\].
pub(crate) fn of_area(n: usize, [dx, dy]: [f64; 2], modulus: f64) -> HalfSpace {
    let [width, height] = [n as f64 * dx, n as f64 * dy];
    let cut = width.hypot(height);
    let [nx, ny] = [dx, dy].map(|step| quick(n + (cut / step).ceil() as usize + 1));
    let [qx, qy] = [2.0 * PI / (nx as f64 * dx), 2.0 * PI / (ny as f64 * dy)];
    let largest = cut * (0.5 * qx * nx as f64).hypot(0.5 * qy * ny as f64);
    let bessel = Primitive::new(libm::j0, largest);
    half_space([n, n], [ny, nx], |i, j| {
        let q = (qx * i as f64).hypot(qy * j as f64);
        2.0 / modulus * if q > 0.0 { bessel.at(q * cut) / q } else { cut }
    })
}

/// Of a line of n points, per length, with ln(L/|x|) and L = `reference` \[m\].
pub(crate) fn of_line(n: usize, dx: f64, modulus: f64, reference: f64) -> HalfSpace {
    let cut = n as f64 * dx;
    let nx = quick(2 * n + 2);
    let qx = 2.0 * PI / (nx as f64 * dx);
    let sine = Primitive::new(sinc, PI * cut / dx);
    let logarithm = (reference / cut).ln();
    half_space([1, n], [1, nx], |i, _| {
        let x = qx * i as f64 * cut;
        let whole = if i == 0 { 1.0 } else { sine.at(x) / x };
        4.0 * cut / (PI * modulus) * (logarithm * sinc(x) + whole)
    })
}

/// From the transform of the kernel at waves along a row and down a column.
fn half_space(
    shape: [usize; 2],
    padded: [usize; 2],
    transform: impl Fn(usize, usize) -> f64,
) -> HalfSpace {
    let [quarter, half] = padded.map(|n| n / 2 + 1);
    let waves = (0..half * quarter).map(|k| transform(k / quarter, k % quarter));
    HalfSpace::of_waves(shape, padded, waves.collect())
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
        of_area(n, step, 2.0).deflect(&pressures, &mut found);
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
        of_line(n, step, 2.0, 30.0).deflect(&pressures, &mut found);
        let euler = 0.577_215_664_901_532_9;
        let right = s / PI.sqrt() * ((30.0 / s).ln() + 0.5 * euler + 2.0_f64.ln());
        assert!((found[32] / right - 1.0).abs() < 1e-12, "{} {right}", found[32]);
    }
}
