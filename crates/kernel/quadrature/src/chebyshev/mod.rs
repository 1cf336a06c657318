//! Chebyshev series: roots, coefficients, and sum.

pub(crate) mod lobatto;
pub(crate) mod polynomial;

use std::f64::consts::PI;

/// The roots of Tₙ, descending from 1 to -1.
pub fn chebyshev_roots(n: usize) -> impl Iterator<Item = f64> {
    (0..n).map(move |k| angle(k, n).cos())
}

/// The coefficients of the polynomial of degree n - 1 through n numbers at the roots of Tₙ.
#[must_use]
pub fn chebyshev_terms(samples: &[f64]) -> Vec<f64> {
    let n = samples.len();
    let term = |j: usize| {
        let along = |(k, sample): (usize, &f64)| sample * (j as f64 * angle(k, n)).cos();
        let sum: f64 = samples.iter().enumerate().map(along).sum();
        sum * if j == 0 { 1.0 } else { 2.0 } / n as f64
    };
    (0..n).map(term).collect()
}

/// The n extremes of Tₙ₋₁, descending from 1 to -1, and the rows that turn samples there into the
/// coefficients of degree 0 to n - 1.
pub(crate) fn extremes(n: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
    let last = n - 1;
    // Whole turns are subtracted, as multiples of π are rounded.
    let at = |k: usize, i: usize| (PI * (k * i % (2 * last)) as f64 / last as f64).cos();
    let half = |k: usize| if k.is_multiple_of(last) { 0.5 } else { 1.0 };
    let row = |k: usize| {
        let weight = |i: usize| 2.0 * half(k) * half(i) / last as f64;
        (0..n).map(|i| weight(i) * at(k, i)).collect()
    };
    ((0..n).map(|i| at(1, i)).collect(), (0..n).map(row).collect())
}

/// A series at y from -1 to 1, by Clenshaw's sum; 0 without terms.
#[inline]
pub(crate) fn chebyshev_sum(terms: &[f64], y: f64) -> f64 {
    let Some((first, rest)) = terms.split_first() else { return 0.0 };
    let (mut now, mut before) = (0.0, 0.0);
    for term in rest.iter().rev() {
        (now, before) = (2.0 * y * now - before + term, now);
    }
    y * now - before + first
}

/// The smallest and the largest of some samples.
pub(crate) fn extent(samples: impl Iterator<Item = f64>) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    samples.fold(none, |(least, most), f| (least.min(f), most.max(f)))
}

fn angle(k: usize, n: usize) -> f64 {
    PI * (k as f64 + 0.5) / n as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_reproduced() {
        let f = |y: f64| 3.0 - y + 0.5 * y.powi(5);
        let samples: Vec<f64> = chebyshev_roots(8).map(f).collect();
        let terms = chebyshev_terms(&samples);
        // y⁵ = (10 T₁ + 5 T₃ + T₅)/16.
        for (term, wanted) in terms.iter().zip([3.0, -1.0 + 5.0 / 16.0, 0.0, 2.5 / 16.0, 0.0]) {
            assert!((term - wanted).abs() < 1e-15, "{terms:?}");
        }
        for y in [-1.0, -0.3, 0.0, 0.77, 1.0] {
            assert!((chebyshev_sum(&terms, y) - f(y)).abs() < 1e-14, "{y}");
        }
    }
}
