//! The kernel of the average over curvatures, the same for every law, tabulated once.
//!
//! With κ = k/√(m₄/3) and y = κ w/v,
//! ```text
//! G(u, y) = ∫₀^κ* κ^(2-n) exp(κ²/2 - (3/2)(y/κ - u)²) dκ
//! ```
//! where κ* is where k_m = k: κ*²/√2 + u κ* = y.

use std::collections::HashMap;
use std::f64::consts::SQRT_2;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use asperity_quadrature::{Estimate, FunctionTable, TanhSinh};

/// Range of mean curvatures above the smallest one, in √(m₄/3): exp(-16²/4) is negligible.
const BEYOND: f64 = 16.0;
/// Relative tolerance of the tables, a tenth of the laws' tolerance.
const TOLERANCE: f64 = 2e-14;
/// A layer this part of the range is integrated by itself.
const THIN: f64 = 1e-4;
/// Number of tables kept; laws are tabulated at the same few hundred values of u.
const KEPT: usize = 4096;

/// G at one u, as a function of y.
pub(crate) struct Kernel {
    u: f64,
    /// y G exp(κ*²/4), which varies slowly with y.
    table: FunctionTable,
}

impl Kernel {
    /// The kernel of this u and n, computed at first use.
    pub(crate) fn shared(u: f64, power: i32) -> Arc<Self> {
        type Kernels = Mutex<HashMap<(u64, i32), Arc<Kernel>>>;
        static KERNELS: OnceLock<Kernels> = OnceLock::new();
        let mut kernels =
            KERNELS.get_or_init(Kernels::default).lock().unwrap_or_else(PoisonError::into_inner);
        if kernels.len() >= KEPT {
            kernels.clear();
        }
        let new = || {
            let table = FunctionTable::new(Arc::new(move |y| flat(u, y, power)), &[], TOLERANCE);
            Arc::new(Self { u, table })
        };
        kernels.entry((u.to_bits(), power)).or_insert_with(new).clone()
    }

    /// The y beyond which the kernel is negligible, relative to its value at `first`.
    pub(crate) fn last(&self, first: f64) -> f64 {
        let farthest = highest(self.u, first) + BEYOND;
        farthest * (self.u + farthest / SQRT_2)
    }

    /// G at y over exp(-κ*²/4) at y - `above`; NaN for y outside 1e-37 to 1e37.
    pub(crate) fn value(&self, y: f64, above: f64) -> f64 {
        // The difference of the two κ*², without cancellation.
        let [here, there] = [y, y - above].map(|y| highest(self.u, y));
        let roots = root(self.u, y) + root(self.u, y - above);
        let more = 2.0 * above * (here + there) / roots;
        self.table.value(y).map_or(f64::NAN, |flat| flat / y * (-0.25 * more).exp())
    }
}

fn root(u: f64, y: f64) -> f64 {
    (u * u + 2.0 * SQRT_2 * y).sqrt()
}

/// κ*, without cancellation.
pub(crate) fn highest(u: f64, y: f64) -> f64 {
    let root = root(u, y);
    if u <= 0.0 { (root - u) / SQRT_2 } else { 2.0 * y / (u + root) }
}

fn flat(u: f64, y: f64, power: i32) -> Estimate {
    let highest = highest(u, y);
    // Down to where k_m = √2 (y/κ - u) is larger by `BEYOND`.
    let lowest = y / (u + (highest + BEYOND) / SQRT_2);
    let width = highest * BEYOND / (SQRT_2 * u + highest + BEYOND);
    // The exponent is -κ*²/4 at κ* and smaller below; the difference, without cancellation.
    let integrand = |down: f64, up: f64| {
        let k = lowest + up;
        let more = y * down / (k * highest);
        let less = down * (highest - 0.5 * down) + 1.5 * more * (SQRT_2 * highest + more);
        k.powi(2 - power) * (-less).exp()
    };
    // Below u = 0, small κ end in a layer about as thin as `lowest`, which a rule over all of the
    // range may miss by more than the tables allow.
    let layer = if lowest < THIN * highest { (lowest * highest).sqrt() } else { 0.0 };
    let (rules, rest) = (TanhSinh::shared(), width - layer);
    let main = rules.integrate(0.0, rest, 1e-15, 0.0, |p| integrand(p.left, layer + p.right));
    let mut found = main;
    if layer > 0.0 {
        let thin =
            rules.integrate(0.0, layer, 1e-15, main.value, |p| integrand(rest + p.left, p.right));
        found.value += thin.value;
        found.error += thin.error;
        found.evaluations += thin.evaluations;
    }
    Estimate { value: y * found.value, error: y * found.error, ..found }
}

#[cfg(test)]
mod tests {
    use super::*;
    use asperity_quadrature::gauss_kronrod;

    #[test]
    fn tables_are_the_integrals_themselves() {
        for power in [0, 2] {
            for u in [-9.0f64, -2.0, -1e-3, 0.0, 0.4, 7.0, 60.0] {
                let kernel = Kernel::shared(u, power);
                for y in [1e-14f64, 1e-5, 0.03, 0.8, 5.0, 40.0] {
                    let end = highest(u, y);
                    let integrand = |share: f64| {
                        let k = end * share;
                        let away = y / k - u;
                        end * k.powi(2 - power) * (0.5 * k * k - 1.5 * away * away).exp()
                    };
                    let breaks = [0.0, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 0.9, 1.0];
                    let direct = gauss_kronrod(integrand, &breaks, 1e-13, 100_000).unwrap().value;
                    let beside = 0.5 * y;
                    let factor = (-0.25 * highest(u, y - beside).powi(2)).exp();
                    let found = kernel.value(y, beside) * factor;
                    // y/κ - u cancels in the definition.
                    let allowed = 1e-12 + 4e-16 * u * u;
                    assert!((found - direct).abs() <= allowed * direct, "{power} {u} {y}");
                }
            }
        }
    }
}
