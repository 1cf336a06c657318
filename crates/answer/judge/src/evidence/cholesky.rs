//! A triangular factor of a covariance, fast enough to be made at every start of the program.

/// The lower triangle L of a matrix L Lᵀ, row by row.
#[derive(Debug, Clone)]
pub(crate) struct Factor(Vec<Vec<f64>>);

impl Factor {
    /// Of a symmetric matrix with these entries, asked for at i ≥ j; `None` unless it is positive
    /// definite.
    pub(crate) fn new(size: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Self> {
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
    pub(crate) fn half_solve(&self, mut b: Vec<f64>) -> Vec<f64> {
        for (i, row) in self.0.iter().enumerate() {
            b[i] = (b[i] - dot(&row[..i], &b[..i])) / row[i];
        }
        b
    }

    /// (L Lᵀ)⁻¹ b.
    pub(crate) fn solve(&self, b: Vec<f64>) -> Vec<f64> {
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
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
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
