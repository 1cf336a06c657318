//! Averages over the azimuth θ, in closed form or by a rule whose error is measured.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, SQRT_2};
use std::sync::LazyLock;

use asperity_quadrature::legendre;

/// Nodes on a piece of θ between slip limits.
const NODES: usize = 16;
/// A piece is halved this often at the most, and into this many: beyond there is only rounding.
const DEEPEST: usize = 40;
const MOST: usize = 100;

/// What is averaged, of q = min(1, push along θ / friction limit) and p, the same across.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Pushed {
    /// √(`base` + `limit` (t(q)² + t(p)²)), t(q) = 1 - (1-q)^1.5.
    Force { base: f64, limit: f64 },
    /// √(`normal` + `shear` ((1-q) + (1-p))).
    Stiffness { normal: f64, shear: f64 },
}

/// An average over θ, to a relative tolerance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Azimuths {
    pushed: Pushed,
    tolerance: f64,
    strip: Strip,
}

/// An integral and an estimate of its error.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Sum {
    pub(crate) value: f64,
    pub(crate) error: f64,
}

/// The integral over all azimuths at which q sticks while p slips, ∫ f(q, 1)/√(a² - q²) dq from 0
/// to 1: values and weights at nodes that serve every a.
#[derive(Debug, Clone, Copy)]
struct Strip {
    /// q².
    squares: [f64; NODES],
    weighted: [f64; NODES],
}

/// The Gauss rule on [0, 1], and what turns samples at its nodes into Legendre coefficients of
/// degree 7, 8, 13, 14 and 15.
struct Rule {
    nodes: [f64; NODES],
    weights: [f64; NODES],
    degrees: [[f64; NODES]; 5],
}

static RULE: LazyLock<Rule> = LazyLock::new(|| {
    let rule = legendre(NODES);
    let [nodes, weights] = [&rule.nodes, &rule.weights].map(|v| std::array::from_fn(|k| v[k]));
    let coefficient = |degree: usize, k: usize| {
        let x = 2.0 * rule.nodes[k] - 1.0;
        let (mut before, mut now) = (0.0, 1.0);
        for n in 1..=degree {
            let n = n as f64;
            (before, now) = (now, ((2.0 * n - 1.0) * x * now - (n - 1.0) * before) / n);
        }
        (2.0 * degree as f64 + 1.0) * rule.weights[k] * now
    };
    let degrees = [7, 8, 13, 14, 15].map(|d| std::array::from_fn(|k| coefficient(d, k)));
    Rule { nodes, weights, degrees }
});

impl Azimuths {
    #[inline(always)]
    pub(crate) fn new(pushed: Pushed, tolerance: f64) -> Self {
        let Rule { nodes, weights, .. } = &*RULE;
        // 1 - q = w² - κ²: half powers at q = 1 are whole ones of w, and so is K_i itself.
        let least = match pushed {
            Pushed::Force { .. } => 0.0,
            Pushed::Stiffness { normal, shear } => (normal / shear).sqrt(),
        };
        let width = 1.0 / (least + (1.0 + least * least).sqrt());
        let (mut q, mut weighted) = ([0.0; NODES], [0.0; NODES]);
        for k in 0..NODES {
            let above = width * nodes[k];
            q[k] = 1.0 - above * (2.0 * least + above);
            weighted[k] = 2.0 * (least + above) * width * weights[k];
        }
        let values = pushed.values(1.0, 1.0, &q, &[1.0; NODES]);
        let mut squares = [0.0; NODES];
        for k in 0..NODES {
            weighted[k] *= values[k];
            squares[k] = q[k] * q[k];
        }
        Self { pushed, tolerance, strip: Strip { squares, weighted } }
    }

    /// The integral over θ from 0 to π/4 with q = `a` sin θ, p = `b` cos θ, with its error.
    #[inline(always)]
    pub(crate) fn octant(&self, a: f64, b: f64) -> Sum {
        // q slips beyond the one angle, p up to the other.
        let q_slips = if a > SQRT_2 { (1.0 / a).asin() } else { FRAC_PI_4 };
        let p_slips = if b > 1.0 { (1.0 / b).acos().min(FRAC_PI_4) } else { 0.0 };
        let mut sum = Sum::default();
        if p_slips < q_slips {
            let ends = [b > 0.7, a > 1.2];
            self.add(&mut sum, (a, b), (p_slips, q_slips), ends);
            self.add(&mut sum, (a, b), (q_slips, FRAC_PI_4), [false; 2]);
            self.add(&mut sum, (a, b), (0.0, p_slips), [false, true]);
            return sum;
        }
        // Where both slip nothing depends on θ.
        let slipped = self.pushed.values(1.0, 1.0, &[1.0; NODES], &[1.0; NODES])[0];
        sum.value = (p_slips - q_slips) * slipped;
        self.add(&mut sum, (a, b), (p_slips, FRAC_PI_4), [true, false]);
        if a <= SQRT_2 {
            self.add(&mut sum, (a, b), (0.0, q_slips), [false, true]);
            return sum;
        }
        let mut roots = self.strip.squares;
        for root in &mut roots {
            *root = (a * a - *root).sqrt().recip();
        }
        sum.value += dot(&self.strip.weighted, &roots);
        sum
    }

    /// Adds the integral over θ between two angles. Half powers of the distance to an end become
    /// whole ones of v in 0..1, which is halved until resolved.
    #[inline(always)]
    fn add(
        &self,
        sum: &mut Sum,
        (a, b): (f64, f64),
        (from, to): (f64, f64),
        half_powers: [bool; 2],
    ) {
        let width = to - from;
        if width <= 0.0 {
            return;
        }
        let Rule { nodes, weights, degrees } = &*RULE;
        // θ = from + width (c₁ v + c₂ v² + c₃ v³).
        let [c1, c2, c3] = match half_powers {
            [false, false] => [1.0, 0.0, 0.0],
            [true, false] => [0.0, 1.0, 0.0],
            [false, true] => [2.0, -1.0, 0.0],
            [true, true] => [0.0, 3.0, -2.0],
        };
        // Right ends of what is to be done, the next one last.
        let mut ends = [1.0; DEEPEST + 1];
        let (mut low, mut depth, mut count) = (0.0, 0, 0);
        loop {
            count += 1;
            let span = ends[depth] - low;
            let (mut theta, mut slope) = ([0.0; NODES], [0.0; NODES]);
            for k in 0..NODES {
                let v = low + span * nodes[k];
                theta[k] = from + width * (v * (c1 + v * (c2 + v * c3)));
                slope[k] = span * width * (c1 + v * (2.0 * c2 + v * 3.0 * c3));
            }
            let (sin, cos) = sines_and_cosines(&theta);
            let mut values = self.pushed.values(a, b, &sin, &cos);
            for k in 0..NODES {
                values[k] *= slope[k];
            }
            let value = dot(weights, &values);
            let middle = dot(&degrees[0], &values).abs().max(dot(&degrees[1], &values).abs());
            let mut tail = 0.0f64;
            for row in &degrees[2..] {
                tail = tail.max(dot(row, &values).abs());
            }
            let fall = (tail / middle.max(f64::MIN_POSITIVE)).min(1.0);
            let off = if tail <= 1e-15 * value { 0.0 } else { 10.0 * tail * fall * fall };
            let resolved = off <= self.tolerance * (sum.value + value);
            if resolved || depth == DEEPEST || count >= MOST {
                sum.value += value;
                sum.error += off;
                low = ends[depth];
                if depth == 0 {
                    return;
                }
                depth -= 1;
            } else {
                depth += 1;
                ends[depth] = low + 0.5 * span;
            }
        }
    }
}

impl Pushed {
    /// The integrand, without the mean's factor; plain loops, for vector registers.
    #[inline(always)]
    fn values(&self, a: f64, b: f64, sin: &[f64; NODES], cos: &[f64; NODES]) -> [f64; NODES] {
        let mut out = [0.0; NODES];
        match *self {
            Self::Stiffness { normal, shear } => {
                for k in 0..NODES {
                    let stuck = (1.0 - a * sin[k]).max(0.0) + (1.0 - b * cos[k]).max(0.0);
                    out[k] = (normal + shear * stuck).sqrt();
                }
            }
            Self::Force { base, limit } => {
                for k in 0..NODES {
                    let q = cattaneo_mindlin((a * sin[k]).min(1.0));
                    let p = cattaneo_mindlin((b * cos[k]).min(1.0));
                    out[k] = (base + limit * (q * q + p * p)).sqrt();
                }
            }
        }
        out
    }
}

#[inline(always)]
fn dot(row: &[f64; NODES], values: &[f64; NODES]) -> f64 {
    let mut sums = [0.0; 4];
    for k in 0..NODES {
        sums[k % 4] += row[k] * values[k];
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
}

/// 1 - (1-q)^1.5 without cancellation for small q.
#[inline(always)]
fn cattaneo_mindlin(q: f64) -> f64 {
    let left = 1.0 - q;
    q * (3.0 + q * (q - 3.0)) / (1.0 + left * left.sqrt())
}

/// The mean over θ of √(a sin²θ + b cos²θ), a and b ≥ 0: the perimeter of an ellipse over 2π, by
/// the modified arithmetic-geometric mean (Adlaj 2012). \[derived\]
pub(crate) fn ellipse_mean(a: f64, b: f64) -> f64 {
    let (large, ratio) = (a.max(b), a.min(b) / a.max(b));
    if ratio >= 1.0 || large <= 0.0 {
        return large.sqrt();
    }
    if ratio < 1e-34 {
        return FRAC_2_PI * large.sqrt();
    }
    let (mut x, mut y) = (1.0, ratio.sqrt());
    let (mut p, mut q, mut z) = (1.0f64, ratio, 0.0);
    while (p - q).abs() > 1e-15 * p {
        (x, y) = (0.5 * (x + y), (x * y).sqrt());
        let root = ((p - z) * (q - z)).sqrt();
        (p, q, z) = (0.5 * (p + q), z + root, z - root);
    }
    large.sqrt() * p / (0.5 * (x + y))
}

/// Coefficients of sin(t)/t and cos(t) in t², highest first: good to 2e-16 for t ≤ π/4.
const SINE: [f64; 9] = series([17, 15, 13, 11, 9, 7, 5, 3, 1]);
const COSINE: [f64; 9] = series([16, 14, 12, 10, 8, 6, 4, 2, 0]);

/// ±1/n! for each n, + where n mod 4 is 0 or 1.
const fn series(orders: [u32; 9]) -> [f64; 9] {
    let mut terms = [0.0; 9];
    let mut k = 0;
    while k < 9 {
        let (mut factorial, mut n) = (1.0, orders[k]);
        while n > 1 {
            factorial *= n as f64;
            n -= 1;
        }
        terms[k] = if orders[k] % 4 < 2 { 1.0 / factorial } else { -1.0 / factorial };
        k += 1;
    }
    terms
}

/// Sines and cosines of azimuths in [0, π/4].
#[inline(always)]
fn sines_and_cosines(theta: &[f64; NODES]) -> ([f64; NODES], [f64; NODES]) {
    let (mut sin, mut cos) = ([0.0; NODES], [0.0; NODES]);
    for k in 0..NODES {
        let z = theta[k] * theta[k];
        for term in 0..SINE.len() {
            sin[k] = sin[k] * z + SINE[term];
            cos[k] = cos[k] * z + COSINE[term];
        }
        sin[k] *= theta[k];
    }
    (sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_series_of_sine_and_cosine_are_good_to_rounding() {
        for k in 0..=100 {
            let theta = [FRAC_PI_4 * f64::from(k) / 100.0; NODES];
            let (sin, cos) = sines_and_cosines(&theta);
            assert!((sin[0] - theta[0].sin()).abs() < 3e-16);
            assert!((cos[0] - theta[0].cos()).abs() < 3e-16);
        }
    }

    #[test]
    fn gross_slip_is_friction_and_light_pushes_stick() {
        assert!((cattaneo_mindlin(1.0) - 1.0).abs() < 1e-15);
        assert!((cattaneo_mindlin(1e-12) / 1.5e-12 - 1.0).abs() < 1e-11);
    }
}
