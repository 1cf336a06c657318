//! Compliances \[m/Pa\] of the waves of a half-space. They are even in both directions, so that a
//! quarter of the plane is held: all of the first half of the columns, in each the first half of
//! the rows.

use std::f64::consts::{PI, TAU};

use asperity_fft::Complex64;

use crate::parallel;

/// On a periodic half-space, 2/(E |q|); the mean has none.
pub(crate) fn waves([rows, columns]: [usize; 2], [dy, dx]: [f64; 2], modulus: f64) -> Vec<f64> {
    let [q_row, q_column] = [TAU / (rows as f64 * dy), TAU / (columns as f64 * dx)];
    let quarter = rows / 2 + 1;
    let mut compliance = vec![0.0; (columns / 2 + 1) * quarter];
    parallel::map(
        compliance.chunks_mut(quarter).enumerate(),
        || (),
        |(), (j, column)| {
            for (i, compliance) in column.iter_mut().enumerate() {
                let q = (q_row * i as f64).hypot(q_column * j as f64);
                *compliance = if i + j == 0 { 0.0 } else { 2.0 / (modulus * q) };
            }
        },
    );
    compliance
}

/// On a free half-space: the transform of the deflections about one pixel that carries the pressure
/// 1; twice as many pixels as the map has keep its images away.
pub(crate) fn rectangles(
    [rows, columns]: [usize; 2],
    [dy, dx]: [f64; 2],
    modulus: f64,
) -> Vec<f64> {
    let (half, quarter) = (columns / 2 + 1, rows / 2 + 1);
    let along_rows = asperity_fft::real_forward(columns);
    let mut by_rows = vec![0.0; quarter * half];
    parallel::map(
        by_rows.chunks_mut(half).enumerate(),
        || (),
        |(), (i, row)| {
            let y = i as f64 * dy;
            let mut line: Vec<f64> = (0..columns)
                .map(|j| j.min(columns - j) as f64 * dx)
                .map(|x| rectangle(x, y, dx, dy) / (PI * modulus))
                .collect();
            let mut spectrum = along_rows.make_output_vec();
            // It fails only for wrong lengths.
            let _ = along_rows.process(&mut line, &mut spectrum);
            for (number, wave) in row.iter_mut().zip(spectrum) {
                *number = wave.re;
            }
        },
    );
    let along_columns = asperity_fft::forward(rows);
    let mut compliance = vec![0.0; half * quarter];
    parallel::map(
        compliance.chunks_mut(quarter).enumerate(),
        || (),
        |(), (j, column)| {
            let mut line: Vec<Complex64> =
                (0..rows).map(|i| by_rows[i.min(rows - i) * half + j].into()).collect();
            along_columns.process(&mut line);
            for (compliance, wave) in column.iter_mut().zip(line) {
                *compliance = wave.re;
            }
        },
    );
    compliance
}

/// Deflection at (x, y) under the pressure 1 on the rectangle dx x dy about the origin, times π E:
/// the closed form of Love (1929). \[recalled\]
pub(crate) fn rectangle(x: f64, y: f64, dx: f64, dy: f64) -> f64 {
    let corner = |x: f64, y: f64| x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh();
    let (left, right) = (x - dx / 2.0, x + dx / 2.0);
    let (low, high) = (y - dy / 2.0, y + dy / 2.0);
    corner(right, high) - corner(left, high) - corner(right, low) + corner(left, low)
}
