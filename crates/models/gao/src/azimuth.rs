//! Averages over the azimuth θ, in closed form or by a rule with an error estimate.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_4, SQRT_2};
use std::sync::LazyLock;

use crate::gauss::{Gauss, Sum, bisect, dot, whole_powers};

/// Nodes on a piece of θ between slip limits.
const NODES: usize = 16;

/// The integrand over θ: a function of q and p, the tangential load over the friction limit, at
/// most 1, in two perpendicular directions.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Integrand {
    /// √(`base` + `limit` (t(q)² + t(p)²)), t(q) = 1 - (1-q)^1.5.
    Force { base: f64, limit: f64 },
    /// √(`normal` + `shear` ((1-q) + (1-p))).
    Stiffness { normal: f64, shear: f64 },
}

/// An average over θ, to a relative tolerance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct AzimuthAverage {
    integrand: Integrand,
    tolerance: f64,
    strip: Strip,
    /// f(1, 1), both slipping.
    slipped: f64,
}

/// The integral over the azimuths at which q sticks while p slips, less the integral of gross slip:
/// ∫ (f(q, 1) - f(1, 1))/√(a² - q²) dq from 0 to 1, at nodes that are the same for every a.
#[derive(Debug, Clone, Copy)]
struct Strip {
    /// q².
    squares: [f64; NODES],
    weighted: [f64; NODES],
}

static RULE: LazyLock<Gauss<NODES>> = LazyLock::new(Gauss::new);

impl AzimuthAverage {
    #[inline(always)]
    pub(crate) fn new(integrand: Integrand, tolerance: f64) -> Self {
        let Gauss { nodes, weights, .. } = &*RULE;
        // 1 - q = w² - κ²: half powers at q = 1 are whole ones of w, and so is K_i itself.
        let least = match integrand {
            Integrand::Force { .. } => 0.0,
            Integrand::Stiffness { normal, shear } => (normal / shear).sqrt(),
        };
        let width = 1.0 / (least + (1.0 + least * least).sqrt());
        let (mut q, mut weighted) = ([0.0; NODES], [0.0; NODES]);
        for k in 0..NODES {
            let above = width * nodes[k];
            q[k] = 1.0 - above * (2.0 * least + above);
            weighted[k] = 2.0 * (least + above) * width * weights[k];
        }
        let slipped = integrand.slipped();
        let values = integrand.values(1.0, 1.0, &q, &[1.0; NODES]);
        let mut squares = [0.0; NODES];
        for k in 0..NODES {
            weighted[k] *= values[k] - slipped;
            squares[k] = q[k] * q[k];
        }
        Self { integrand, tolerance, strip: Strip { squares, weighted }, slipped }
    }

    /// The integral over θ from 0 to π/4 with q = `a` sin θ and p = `b` cos θ, and its error.
    #[inline(always)]
    pub(crate) fn octant(&self, a: f64, b: f64) -> Sum {
        let mut sum = Sum::default();
        // q slips beyond one angle, p up to another.
        let p_slips = if b > 1.0 { (1.0 / b).acos().min(FRAC_PI_4) } else { 0.0 };
        if a > SQRT_2 && b > 1.0 && (a * a - 1.0) * (b * b - 1.0) >= 1.0 {
            // p still slips where q begins to slip: the integrand is constant between.
            let mut roots = self.strip.squares;
            for root in &mut roots {
                *root = (a * a - *root).sqrt().recip();
            }
            sum.value = p_slips * self.slipped + dot(&self.strip.weighted, &roots);
            self.add(&mut sum, (a, b), (p_slips, FRAC_PI_4), [true, false]);
            return sum;
        }
        let q_slips = if a > SQRT_2 { (1.0 / a).asin() } else { FRAC_PI_4 };
        self.add(&mut sum, (a, b), (p_slips, q_slips), [b > 0.7, a > 1.2]);
        self.add(&mut sum, (a, b), (p_slips.max(q_slips), FRAC_PI_4), [false; 2]);
        self.add(&mut sum, (a, b), (0.0, p_slips.min(q_slips)), [false, true]);
        sum
    }

    /// Adds the integral over θ between two angles; `half` marks ends with half powers of the
    /// distance.
    #[inline(always)]
    fn add(&self, sum: &mut Sum, (a, b): (f64, f64), (from, to): (f64, f64), half: [bool; 2]) {
        let width = to - from;
        if width <= 0.0 {
            return;
        }
        let rule = &*RULE;
        let [c1, c2, c3] = whole_powers(half);
        bisect(
            #[inline(always)]
            |low, span, last| {
                let (mut theta, mut slope) = ([0.0; NODES], [0.0; NODES]);
                for k in 0..NODES {
                    let v = low + span * rule.nodes[k];
                    theta[k] = from + width * (v * (c1 + v * (c2 + v * c3)));
                    slope[k] = span * width * (c1 + v * (2.0 * c2 + v * 3.0 * c3));
                }
                let (sin, cos) = sines_and_cosines(&theta);
                let mut values = self.integrand.values(a, b, &sin, &cos);
                for k in 0..NODES {
                    values[k] *= slope[k];
                }
                let found = rule.sum(&values);
                let resolved = last || found.error <= self.tolerance * (sum.value + found.value);
                if resolved {
                    sum.value += found.value;
                    sum.error += found.error;
                }
                resolved
            },
        );
    }
}

impl Integrand {
    /// The value where both directions slip.
    #[inline(always)]
    fn slipped(&self) -> f64 {
        match *self {
            Self::Stiffness { normal, .. } => normal.sqrt(),
            Self::Force { base, limit } => (base + 2.0 * limit).sqrt(),
        }
    }

    /// Values at azimuths, in plain loops for vector registers.
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

/// 1 - (1-q)^1.5 without cancellation for small q.
#[inline(always)]
fn cattaneo_mindlin(q: f64) -> f64 {
    let left = 1.0 - q;
    q * (3.0 + q * (q - 3.0)) / (1.0 + left * left.sqrt())
}

/// The mean over θ of √(a sin²θ + b cos²θ), a and b ≥ 0: the perimeter of an ellipse over 2π, by
/// the modified arithmetic-geometric mean (Adlaj 2012); checked against quadrature below.
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
    // Each step squares the difference: a remaining one of 1e-8 is lost in rounding. In further
    // steps z, which doubles, would exceed p and q.
    while (p - q).abs() > 1e-8 * p {
        (x, y) = (0.5 * (x + y), (x * y).sqrt());
        let root = ((p - z) * (q - z)).sqrt();
        (p, q, z) = (0.5 * (p + q), z + root, z - root);
    }
    large.sqrt() * (p + q) / (x + y)
}

/// Coefficients of sin(t)/t and cos(t) in t², highest first: accurate to 2e-16 for t ≤ π/4.
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
    fn the_series_of_sine_and_cosine_are_accurate_to_rounding() {
        for k in 0..=100 {
            let theta = [FRAC_PI_4 * f64::from(k) / 100.0; NODES];
            let (sin, cos) = sines_and_cosines(&theta);
            assert!((sin[0] - theta[0].sin()).abs() < 3e-16);
            assert!((cos[0] - theta[0].cos()).abs() < 3e-16);
        }
    }

    #[test]
    fn the_ellipse_mean_is_accurate_for_all_ratios_of_the_axes() {
        // By the trapezoid rule in θ, exact to rounding for axes as close as these.
        let mean = |ratio: f64| {
            let theta = |k: u32| std::f64::consts::PI * f64::from(k) / 400.0;
            let root = |k| (theta(k).sin().powi(2) + ratio * theta(k).cos().powi(2)).sqrt();
            (0..400).map(root).sum::<f64>() / 400.0
        };
        for k in 0..4000 {
            let ratio = 0.985f64.powi(k);
            let found = ellipse_mean(4.0 * ratio, 4.0) / 2.0;
            assert!(found.is_finite(), "{ratio}: {found}");
            // E(m) next to m = 1: 1 + r/4 (ln(16/r) - 1).
            let flat = FRAC_2_PI * (1.0 + ratio / 4.0 * ((16.0 / ratio).ln() - 1.0));
            let (wanted, allowed) = if ratio > 0.05 {
                (mean(ratio), 3e-15)
            } else {
                (flat, 3e-15 + ratio * ratio * (16.0 / ratio).ln())
            };
            assert!((found / wanted - 1.0).abs() < allowed, "{ratio}: {found} {wanted}");
        }
    }

    #[test]
    fn gross_slip_reaches_the_friction_limit_and_light_loads_stick() {
        assert!((cattaneo_mindlin(1.0) - 1.0).abs() < 1e-15);
        assert!((cattaneo_mindlin(1e-12) / 1.5e-12 - 1.0).abs() < 1e-11);
    }
}
