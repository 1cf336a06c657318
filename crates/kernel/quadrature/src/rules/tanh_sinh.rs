//! Tanh-sinh quadrature: for integrands with branch points at, or just outside, both ends.

use std::sync::OnceLock;

use crate::Estimate;

/// A point of an interval, with its distances from both ends free of cancellation.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    /// The point.
    pub x: f64,
    /// x minus the left end.
    pub left: f64,
    /// The right end minus x.
    pub right: f64,
}

/// A ladder of tanh-sinh rules, each with half the step of the one before.
#[derive(Debug)]
pub struct TanhSinh {
    /// For each level, the nodes it adds: distance from the nearer end as a share of the width
    /// (negative: from the right), and weight.
    levels: Vec<Vec<(f64, f64)>>,
}

/// Coarsest step of the double exponential variable.
const STEP: f64 = 0.5;
const LEVELS: i32 = 7;
/// Beyond this the distance to the end is below 1e-18 of the width.
const LAST: f64 = 3.25;

impl TanhSinh {
    /// The rules, made once per process.
    #[must_use]
    pub fn shared() -> &'static Self {
        static RULES: OnceLock<TanhSinh> = OnceLock::new();
        RULES.get_or_init(|| Self { levels: (0..LEVELS).map(level).collect() })
    }

    /// The integral of `f` from `low` to `high`. The step is halved until two sums in a row agree
    /// so well that the next one, with twice the digits, is within the `tolerance`, relative to the
    /// larger of this integral and `beside`, the size of another term of the same sum. The error is
    /// an estimate, which may exceed the tolerance.
    pub fn integrate(
        &self,
        low: f64,
        high: f64,
        tolerance: f64,
        beside: f64,
        mut f: impl FnMut(Point) -> f64,
    ) -> Estimate {
        let width = high - low;
        let (mut sum, mut size) = (0.0, 0.0);
        let mut best = Estimate { value: 0.0, error: f64::INFINITY, evaluations: 0 };
        let mut step = STEP;
        for (k, nodes) in self.levels.iter().enumerate() {
            for &(share, weight) in nodes {
                let near = share.abs() * width;
                let point = if share > 0.0 {
                    Point { x: low + near, left: near, right: width - near }
                } else {
                    Point { x: high - near, left: width - near, right: near }
                };
                let term = weight * f(point);
                sum += term;
                size += term.abs();
            }
            best.evaluations += nodes.len();
            let value = sum * step * width;
            let difference = (value - best.value).abs();
            best.value = value;
            let scale = (size * step * width.abs()).max(beside);
            if k > 0 {
                // Digits double from level to level while the integrand is analytic inside.
                let relative = if scale > 0.0 { difference / scale } else { 0.0 };
                best.error = scale * (10.0 * relative * relative.sqrt().sqrt()).min(relative);
                if best.error <= tolerance * scale || relative < 1e-15 {
                    break;
                }
            }
            step *= 0.5;
        }
        best
    }
}

fn level(k: i32) -> Vec<(f64, f64)> {
    let step = STEP * 0.5f64.powi(k);
    let mut nodes = Vec::new();
    let mut index = if k == 0 { 0 } else { 1 };
    let stride = if k == 0 { 1 } else { 2 };
    while f64::from(index) * step < LAST {
        let t = f64::from(index) * step;
        let u = std::f64::consts::PI * t.sinh();
        let share = 1.0 / (1.0 + u.exp());
        let weight = std::f64::consts::PI * t.cosh() * share * (1.0 - share);
        nodes.push((-share, weight));
        if index > 0 {
            nodes.push((share, weight));
        }
        index += stride;
    }
    nodes
}

#[cfg(test)]
mod tests {
    use super::TanhSinh;

    #[test]
    fn branch_points_at_both_ends() {
        let rules = TanhSinh::shared();
        let beta = rules.integrate(0.0, 1.0, 1e-12, 0.0, |p| (p.left * p.right).sqrt());
        assert!((beta.value / (std::f64::consts::PI / 8.0) - 1.0).abs() < 1e-12);
        assert!(beta.evaluations < 120);
        let shifted =
            rules.integrate(2.0, 6.0, 1e-12, 0.0, |p| p.left.powf(0.27) * p.right.powf(1.5));
        let exact = 4f64.powf(2.77) * 0.264_893_454_034_914; // B(1.27, 2.5)
        assert!((shifted.value / exact - 1.0).abs() < 1e-11, "{}", shifted.value / exact);
    }
}
