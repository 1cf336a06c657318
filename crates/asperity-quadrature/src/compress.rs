//! From many positive point masses to the few nodes of their Gauss rule.

use nalgebra::DMatrix;

/// A Gauss rule: Σ wᵢ f(xᵢ) is exact for polynomials f of degree 2n-1 under its measure.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GaussRule {
    /// Nodes, ascending, inside the support of the measure.
    pub(crate) nodes: Vec<f64>,
    /// Weights, all positive; they sum to the total mass.
    pub(crate) weights: Vec<f64>,
}

/// Coefficients of the orthonormal polynomials of a discrete measure, on an interval mapped to
/// [-1, 1]; rules of every order up to their number follow from them.
#[derive(Debug, Clone)]
pub(crate) struct Recurrence {
    centre: f64,
    half: f64,
    total: f64,
    alpha: Vec<f64>,
    /// `beta[k]` couples polynomials k and k+1.
    beta: Vec<f64>,
}

impl Recurrence {
    /// Stieltjes' procedure, for at most `order` polynomials. The measure must have many more
    /// points than that (a rule of n nodes from n points reproduces the points, not a density).
    pub(crate) fn new(points: &[f64], masses: &[f64], order: usize) -> Self {
        let (low, high) = points
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &x| (l.min(x), h.max(x)));
        let centre = 0.5 * (low + high);
        let half = (0.5 * (high - low)).max(f64::MIN_POSITIVE);
        let total: f64 = masses.iter().sum();
        let x: Vec<f64> = points.iter().map(|p| (p - centre) / half).collect();
        let mut previous = vec![0.0; x.len()];
        let mut current = vec![1.0 / total.sqrt(); x.len()];
        let (mut alpha, mut beta) = (Vec::with_capacity(order), Vec::with_capacity(order));
        let mut coupling = 0.0;
        for _ in 0..order {
            let a: f64 = (0..x.len()).map(|i| masses[i] * x[i] * current[i] * current[i]).sum();
            alpha.push(a);
            let mut norm = 0.0;
            for i in 0..x.len() {
                let next = (x[i] - a) * current[i] - coupling * previous[i];
                previous[i] = next;
                norm += masses[i] * next * next;
            }
            std::mem::swap(&mut previous, &mut current);
            coupling = norm.sqrt();
            // A measure on k points has only k polynomials.
            if coupling < 1e-14 {
                break;
            }
            beta.push(coupling);
            current.iter_mut().for_each(|p| *p /= coupling);
        }
        Self { centre, half, total, alpha, beta }
    }

    /// The rule of `n` nodes (fewer if the measure has fewer points).
    pub(crate) fn rule(&self, n: usize) -> GaussRule {
        let n = n.min(self.alpha.len());
        let matrix = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
            0 => self.alpha[i],
            1 => self.beta[i.min(j)],
            _ => 0.0,
        });
        let mut roots: Vec<f64> = matrix.symmetric_eigenvalues().iter().copied().collect();
        roots.sort_by(f64::total_cmp);
        let mut rule = GaussRule { nodes: Vec::with_capacity(n), weights: Vec::with_capacity(n) };
        for mut x in roots {
            // Eigenvectors would lose the small weights; two Newton steps and Christoffel's
            // formula keep them to rounding.
            let mut christoffel = 0.0;
            for _ in 0..3 {
                let step;
                (step, christoffel) = self.newton(n, x);
                if step.is_finite() {
                    x -= step;
                }
            }
            rule.nodes.push(self.centre + self.half * x);
            rule.weights.push(1.0 / christoffel);
        }
        rule
    }

    /// Newton's step p_n/p_n' at x, and Σ_{k<n} p_k(x)².
    fn newton(&self, n: usize, x: f64) -> (f64, f64) {
        let (mut before, mut now) = (0.0, 1.0 / self.total.sqrt());
        let (mut slope_before, mut slope) = (0.0, 0.0);
        let mut sum = 0.0;
        for k in 0..n {
            sum += now * now;
            let left = if k == 0 { 0.0 } else { self.beta[k - 1] };
            // The last polynomial needs no norm: its roots do not depend on it.
            let right = if k + 1 < n { self.beta[k] } else { 1.0 };
            let next = ((x - self.alpha[k]) * now - left * before) / right;
            let next_slope = (now + (x - self.alpha[k]) * slope - left * slope_before) / right;
            (before, now) = (now, next);
            (slope_before, slope) = (slope, next_slope);
        }
        (now / slope, sum)
    }
}

#[cfg(test)]
mod tests {
    use super::Recurrence;
    use crate::legendre;

    #[test]
    fn compression_keeps_the_moments() {
        // x^1.5 on [0, 1] through x = u².
        let fine = legendre(64);
        let points: Vec<f64> = fine.nodes.iter().map(|u| u * u).collect();
        let masses: Vec<f64> =
            fine.nodes.iter().zip(&fine.weights).map(|(u, w)| 2.0 * w * u.powi(4)).collect();
        for n in [2, 4, 8, 16, 24] {
            let rule = Recurrence::new(&points, &masses, n).rule(n);
            for degree in 0..2 * n as i32 {
                let sum: f64 =
                    rule.nodes.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(degree)).sum();
                let exact = 1.0 / (f64::from(degree) + 2.5);
                assert!((sum / exact - 1.0).abs() < 2e-14, "n {n}, degree {degree}");
            }
        }
    }

    #[test]
    fn a_measure_of_few_points_is_reproduced() {
        let rule = Recurrence::new(&[1.0, 2.0], &[3.0, 4.0], 8).rule(8);
        assert_eq!(rule.nodes.len(), 2);
        assert!((rule.nodes[0] - 1.0).abs() < 1e-15 && (rule.weights[1] - 4.0).abs() < 1e-14);
    }
}
