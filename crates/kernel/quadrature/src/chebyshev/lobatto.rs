//! Chebyshev's points on [0, 1], ends included: interpolation, its derivative and its error.

use std::sync::OnceLock;

use super::extremes;
use crate::rules::legendre::{INSET, legendre};

/// Points on an interval.
pub(crate) const NODES: usize = 20;
/// A value at each point.
pub(crate) type Samples = [f64; NODES];

/// Interpolation between the points, for the interval [0, 1].
#[derive(Debug)]
pub(crate) struct Lobatto {
    /// Ascending; the outermost lie just inside, on the interval's side of a kink at an end.
    pub(crate) nodes: Samples,
    /// Row i turns samples into the derivative at node i.
    slope: Box<[Samples; NODES]>,
    /// Rows that turn samples into the three coefficients of highest degree but one.
    tail: [Samples; 3],
    /// ∫ (1-t) ℓⱼ(t) dt and ∫ t ℓⱼ(t) dt of Lagrange's polynomials ℓⱼ.
    pub(crate) linear: [Samples; 2],
}

/// The points, made once per process.
pub(crate) fn lobatto() -> &'static Lobatto {
    static RULE: OnceLock<Lobatto> = OnceLock::new();
    RULE.get_or_init(Lobatto::new)
}

/// Angle of point i: its place in [-1, 1] is minus the cosine.
fn angle(i: usize) -> f64 {
    std::f64::consts::PI * i as f64 / (NODES - 1) as f64
}

/// Half at both ends, 1 between them.
fn trapezoid(i: usize) -> f64 {
    if i == 0 || i == NODES - 1 { 0.5 } else { 1.0 }
}

/// The Chebyshev coefficients of samples at the points.
pub(crate) fn coefficients(samples: &Samples) -> Samples {
    let table = cosines();
    std::array::from_fn(|degree| table[degree].iter().zip(samples).map(|(c, f)| c * f).sum())
}

fn cosines() -> &'static [Samples; NODES] {
    static TABLE: OnceLock<Box<[Samples; NODES]>> = OnceLock::new();
    TABLE.get_or_init(|| {
        // The points ascend, the extremes descend.
        let (_, rows) = extremes(NODES);
        let entry = |degree: usize, i: usize| rows[degree][NODES - 1 - i];
        Box::new(std::array::from_fn(|degree| std::array::from_fn(|i| entry(degree, i))))
    })
}

/// The variable of the coefficients, in [-1, 1], of a place in [0, 1].
pub(crate) fn centred(v: f64) -> f64 {
    (2.0 * v - 1.0) / (1.0 - 2.0 * INSET)
}

impl Lobatto {
    fn new() -> Self {
        let nodes: Samples =
            std::array::from_fn(|i| 0.5 - 0.5 * (1.0 - 2.0 * INSET) * angle(i).cos());
        let mut rule = Self {
            nodes,
            slope: Box::new([[0.0; NODES]; NODES]),
            tail: [NODES - 2, NODES - 3, NODES - 4].map(|degree| cosines()[degree]),
            linear: [[0.0; NODES]; 2],
        };
        for i in 0..NODES {
            for j in (0..NODES).filter(|j| *j != i) {
                rule.slope[i][j] = sign(j) / sign(i) / (nodes[i] - nodes[j]);
            }
            rule.slope[i][i] = -rule.slope[i].iter().sum::<f64>();
        }
        let gauss = legendre(NODES);
        for (v, w) in gauss.nodes.iter().zip(&gauss.weights) {
            let basis = rule.basis(*v);
            for (row, share) in rule.linear.iter_mut().zip([1.0 - v, *v]) {
                row.iter_mut().zip(&basis).for_each(|(row, b)| *row += w * share * b);
            }
        }
        rule
    }

    /// Lagrange's polynomials at v.
    pub(crate) fn basis(&self, v: f64) -> Samples {
        let mut basis = [0.0; NODES];
        let mut sum = 0.0;
        for (j, (basis, node)) in basis.iter_mut().zip(&self.nodes).enumerate() {
            let distance = v - node;
            if distance == 0.0 {
                return std::array::from_fn(|k| f64::from(u8::from(k == j)));
            }
            *basis = sign(j) / distance;
            sum += *basis;
        }
        basis.iter_mut().for_each(|b| *b /= sum);
        basis
    }

    /// The derivative at the points.
    pub(crate) fn derivative(&self, samples: &Samples) -> Samples {
        std::array::from_fn(|i| dot(&self.slope[i], samples))
    }

    /// The largest of three coefficients near the highest degree.
    pub(crate) fn tail(&self, samples: &Samples) -> f64 {
        self.tail.iter().fold(0.0, |most, row| dot(row, samples).abs().max(most))
    }
}

/// Barycentric weight of point j.
fn sign(j: usize) -> f64 {
    if j.is_multiple_of(2) { trapezoid(j) } else { -trapezoid(j) }
}

pub(crate) fn dot(a: &Samples, b: &Samples) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chebyshev::chebyshev_sum;

    #[test]
    fn polynomials_are_interpolated_differentiated_and_integrated() {
        let rule = lobatto();
        let f = |v: f64| (3.0 * v).sin() + v;
        let samples = rule.nodes.map(f);
        for v in [0.0, 1e-3, 0.3, rule.nodes[7], 1.0] {
            assert!((dot(&rule.basis(v), &samples) - f(v)).abs() < 1e-14, "{v}");
            let series = chebyshev_sum(&coefficients(&samples), centred(v));
            assert!((series - f(v)).abs() < 1e-14, "{v}");
        }
        for (v, slope) in rule.nodes.iter().zip(rule.derivative(&samples)) {
            assert!((slope - 3.0 * (3.0 * v).cos() - 1.0).abs() < 1e-12, "{v}");
        }
        let [below, above] = rule.linear.map(|row| dot(&row, &samples));
        assert!((below + above - (1.0 - 3f64.cos()) / 3.0 - 0.5).abs() < 1e-15);
        let lever = (3f64.sin() - 3.0 * 3f64.cos()) / 9.0 + 1.0 / 3.0;
        assert!((above - lever).abs() < 1e-15, "{above} {lever}");
        assert!(rule.tail(&samples) < 1e-15, "{:e}", rule.tail(&samples));
        assert!(rule.tail(&rule.nodes.map(|v| (v - 0.4).abs())) > 1e-4);
    }
}
