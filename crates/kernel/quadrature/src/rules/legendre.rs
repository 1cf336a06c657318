//! Gauss-Legendre rules on [0, 1], and the tail of a Legendre series.

use std::sync::OnceLock;

/// An n-point Gauss-Legendre rule on [0, 1], with the rows that estimate the error of samples at
/// its nodes.
#[derive(Debug)]
pub struct Legendre {
    /// Nodes in (0, 1), ascending.
    pub nodes: Vec<f64>,
    /// Weights; they sum to 1.
    pub weights: Vec<f64>,
    /// Row k turns samples into the coefficient of degree n-1-k, for k = 0, 1, 2.
    tail: [Vec<f64>; 3],
    /// The same for degrees n/2+1, n/2, n/2-1.
    middle: [Vec<f64>; 3],
    /// Rows that turn samples into the series' values next to 0 and next to 1.
    ends: [Vec<f64>; 2],
}

/// Distance from the ends of [0, 1] of the two points of `Legendre::at_ends`.
pub(crate) const INSET: f64 = 1e-7;

const LARGEST: usize = 128;

/// The rule of `n` points, 1 ≤ n ≤ 128 (larger requests get 128); made once per process.
///
/// Nodes come from Newton's method on the three-term recurrence; nodes and weights are good to
/// 1e-15 for n ≤ 32.
#[must_use]
pub fn legendre(n: usize) -> &'static Legendre {
    static RULES: [OnceLock<Legendre>; LARGEST] = [const { OnceLock::new() }; LARGEST];
    let n = n.clamp(1, LARGEST);
    RULES[n - 1].get_or_init(|| Legendre::new(n))
}

/// P_0(x) to P_n(x), n ≥ 1.
fn polynomials(n: usize, x: f64) -> Vec<f64> {
    let mut all = Vec::with_capacity(n + 1);
    all.extend([1.0, x]);
    for k in 2..=n {
        let order = k as f64;
        all.push(((2.0 * order - 1.0) * x * all[k - 1] - (order - 1.0) * all[k - 2]) / order);
    }
    all
}

/// P_n(x) and P_n'(x) for |x| < 1.
fn polynomial(n: usize, x: f64) -> (f64, f64) {
    let all = polynomials(n, x);
    (all[n], n as f64 * (all[n - 1] - x * all[n]) / (1.0 - x * x))
}

impl Legendre {
    fn new(n: usize) -> Self {
        let mut nodes = vec![0.5; n];
        let mut weights = vec![1.0; n];
        if n > 1 {
            for i in 0..n.div_ceil(2) {
                let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n as f64 + 0.5)).cos();
                for _ in 0..4 {
                    let (value, slope) = polynomial(n, x);
                    x -= value / slope;
                }
                let slope = polynomial(n, x).1;
                let weight = 1.0 / ((1.0 - x * x) * slope * slope);
                (nodes[i], nodes[n - 1 - i]) = (0.5 - 0.5 * x, 0.5 + 0.5 * x);
                (weights[i], weights[n - 1 - i]) = (weight, weight);
            }
        }
        let at_nodes: Vec<_> = nodes.iter().map(|x| polynomials(n, 2.0 * x - 1.0)).collect();
        let row = |degree: usize| -> Vec<f64> {
            let scale = 2.0 * degree as f64 + 1.0;
            at_nodes.iter().zip(&weights).map(|(p, w)| scale * w * p[degree]).collect()
        };
        let rows = |top: usize| [0, 1, 2].map(|k| row(top.saturating_sub(k)));
        let (tail, middle) = (rows(n - 1), rows(n / 2 + 1));
        let end = |x: f64| -> Vec<f64> {
            let mut sum = row(0);
            for (degree, p) in polynomials(n, 2.0 * x - 1.0).into_iter().enumerate().take(n).skip(1)
            {
                sum.iter_mut().zip(row(degree)).for_each(|(sum, r)| *sum += p * r);
            }
            sum
        };
        let ends = [end(INSET), end(1.0 - INSET)];
        Self { nodes, weights, tail, middle, ends }
    }

    /// The largest of the last three Legendre coefficients of the function with these samples:
    /// large if n points do not resolve it (the rule itself is exact to degree 2n-1).
    #[must_use]
    pub fn tail(&self, samples: &[f64]) -> f64 {
        largest(&self.tail, samples)
    }

    /// The error of the rule, estimated from the fall of the Legendre coefficients between degrees
    /// n/2 and n, which continues beyond n, except at a kink. A tail at the level of rounding means
    /// that the samples are resolved. The rule is exact to degree 2n-1, but the fall counts once
    /// only: beside the kinks of lateral laws it is slower than geometric, by 5e-12.
    pub(crate) fn error(&self, samples: &[f64]) -> f64 {
        let tail = self.tail(samples);
        let size = samples.iter().fold(0.0, |m: f64, f| m.max(f.abs()));
        if tail <= 3e-14 * size {
            return 0.0;
        }
        let middle = largest(&self.middle, samples);
        let fall = if middle > tail { tail / middle } else { 1.0 };
        10.0 * tail * fall
    }

    /// The Legendre series of the function with these samples, 1e-7 inside 0 and 1: a function that
    /// deviates there has a kink beyond the outermost nodes.
    pub(crate) fn at_ends(&self, samples: &[f64]) -> [f64; 2] {
        let at = |row: &Vec<f64>| row.iter().zip(samples).map(|(r, f)| r * f).sum();
        [at(&self.ends[0]), at(&self.ends[1])]
    }
}

fn largest(rows: &[Vec<f64>; 3], samples: &[f64]) -> f64 {
    rows.iter()
        .map(|row| row.iter().zip(samples).map(|(r, f)| r * f).sum::<f64>().abs())
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::legendre;

    #[test]
    fn integrates_polynomials_of_degree_2n_minus_1() {
        for n in [1, 2, 5, 16, 20, 32, 64] {
            let rule = legendre(n);
            for degree in [0, 1, n, 2 * n - 1] {
                let sum: f64 = rule
                    .nodes
                    .iter()
                    .zip(&rule.weights)
                    .map(|(x, w)| w * x.powi(degree as i32))
                    .sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!((sum / exact - 1.0).abs() < 2e-13, "n {n} degree {degree}: {sum} {exact}");
            }
        }
    }

    #[test]
    fn tails_differ_between_resolved_and_unresolved() {
        let rule = legendre(20);
        let sample = |f: fn(f64) -> f64| rule.nodes.iter().map(|&x| f(x)).collect::<Vec<_>>();
        assert!(rule.tail(&sample(f64::exp)) < 1e-14);
        assert!(rule.tail(&sample(|x| (x - 0.4).abs())) > 1e-4);
    }
}
