//! Fourier transforms of maps.

use asperity_fft::Complex64;

/// The transform of a map of rows, column by column: wave (i, j), i down a column and j along a
/// row, stands at `j * rows + i`. Not scaled.
pub(crate) fn forward(values: Vec<Complex64>, [rows, columns]: [usize; 2]) -> Vec<Complex64> {
    both(values, [rows, columns], asperity_fft::forward)
}

/// The map of rows of waves from [`forward`], rows * columns times too large.
pub(crate) fn inverse(waves: Vec<Complex64>, [rows, columns]: [usize; 2]) -> Vec<Complex64> {
    both(waves, [columns, rows], asperity_fft::inverse)
}

fn both(
    mut values: Vec<Complex64>,
    [rows, columns]: [usize; 2],
    plan: fn(usize) -> std::sync::Arc<dyn asperity_fft::Fft<f64>>,
) -> Vec<Complex64> {
    plan(columns).process(&mut values);
    let mut turned = vec![Complex64::ZERO; values.len()];
    for (i, row) in values.chunks(columns).enumerate() {
        row.iter().enumerate().for_each(|(j, value)| turned[j * rows + i] = *value);
    }
    plan(rows).process(&mut turned);
    turned
}

/// The wave number of wave k of n, with its sign, in waves on the whole length.
pub(crate) fn signed((k, n): (usize, usize)) -> f64 {
    if 2 * k > n { k as f64 - n as f64 } else { k as f64 }
}
