//! Fourier transforms of `f64`, planned by rustfft and realfft.
//!
//! Both are generic in the number: whoever plans with them compiles every algorithm they have,
//! some 40 s of it. Here that is done once for the workspace; what is handed out are trait
//! objects. Neither direction is scaled: there and back is n times what it was.
//!
//! ```
//! use asperity_fft::Complex64;
//!
//! let mut wave = vec![Complex64::ONE; 12];
//! asperity_fft::forward(12).process(&mut wave);
//! assert!((wave[0].re - 12.0).abs() < 1e-14 && wave[1].norm() < 1e-14);
//! ```

use std::sync::Arc;

pub use realfft::{ComplexToReal, RealToComplex};
pub use rustfft::Fft;
pub use rustfft::num_complex::Complex64;

/// The transform with exp(-2πi jk/n) of rows of `n` complex numbers.
#[must_use]
pub fn forward(n: usize) -> Arc<dyn Fft<f64>> {
    rustfft::FftPlanner::new().plan_fft_forward(n)
}

/// The transform with exp(2πi jk/n) of rows of `n` complex numbers.
#[must_use]
pub fn inverse(n: usize) -> Arc<dyn Fft<f64>> {
    rustfft::FftPlanner::new().plan_fft_inverse(n)
}

/// The least product of 2, 3 and 5 that is not below `length`, whose transforms are fast.
#[must_use]
pub fn fast_length(length: usize) -> usize {
    let smooth = |mut n: usize| {
        for factor in [2, 3, 5] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    (length..).find(|&n| smooth(n)).unwrap_or(length)
}

/// [`forward`] of `n` real numbers: the first n/2 + 1 of its waves.
#[must_use]
pub fn real_forward(n: usize) -> Arc<dyn RealToComplex<f64>> {
    realfft::RealFftPlanner::new().plan_fft_forward(n)
}

/// `n` real numbers from the first n/2 + 1 of their waves.
#[must_use]
pub fn real_inverse(n: usize) -> Arc<dyn ComplexToReal<f64>> {
    realfft::RealFftPlanner::new().plan_fft_inverse(n)
}

/// Transforms the rows of a map, then its columns, by [`forward`] or [`inverse`], and transposes
/// it: row i, column j becomes row j, column i.
pub fn transform(
    map: &mut Vec<Complex64>,
    [rows, columns]: [usize; 2],
    direction: fn(usize) -> Arc<dyn Fft<f64>>,
) {
    direction(columns).process(map);
    let turned = (0..columns).flat_map(|j| (0..rows).map(move |i| i * columns + j));
    *map = turned.map(|at| map[at]).collect();
    direction(rows).process(map);
}

#[cfg(test)]
mod tests {
    use super::fast_length;

    #[test]
    fn lengths_are_products_of_small_primes() {
        assert_eq!([1, 2, 7, 11, 97, 128, 1021].map(fast_length), [1, 2, 8, 12, 100, 128, 1024]);
    }
}
