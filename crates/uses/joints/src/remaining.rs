//! Remaining fraction 1 - u/δ of a contact close to the interference at which it is lost, without
//! cancellation.

use asperity_core::QuadratureError;
use asperity_quadrature::chebyshev_roots;

/// Samples of the exponent.
const NODES: usize = 12;
/// Length of the interpolated range in ln w.
const SPAN: f64 = 0.25;
/// Largest number of times that the range is divided by 8 where a kink is close.
const MAX_SHORTENINGS: i32 = 5;
/// Rounding error of δ, in units of the last place.
const ROUNDING_ULPS: f64 = 8.0;
/// Largest relative difference of δ and u at the first remaining contact, unless δ jumps there.
const ONSET_ROUNDING: f64 = 1e-12;

/// 1 - u/δ(w) for w beyond the interference with δ = u.
///
/// δ/u = (w/first)^p with nearly constant p: 1 - (w/first)⁻ᵖ avoids the cancellation of 1 - u/δ
/// close to 0, where most of the force arises far in the tail of the heights.
#[derive(Debug, Clone)]
pub(crate) struct RemainingFraction {
    first: f64,
    span: f64,
    /// p at the nodes.
    exponents: [f64; NODES],
}

impl RemainingFraction {
    /// Interpolates from `first`, where δ reaches u, to `high` at most; `None` where δ jumps beyond
    /// u or is not smooth.
    pub(crate) fn new(
        [first, high]: [f64; 2],
        u: f64,
        recovered: impl Fn(f64) -> Result<f64, QuadratureError>,
    ) -> Result<Option<Self>, QuadratureError> {
        if (recovered(first)? / u - 1.0).abs() > ONSET_ROUNDING {
            return Ok(None);
        }
        let ln = |s: f64| Ok::<_, QuadratureError>((recovered(first * s.exp())? / u).ln());
        for shorter in 0..MAX_SHORTENINGS {
            let span = (high / first).ln().min(SPAN) / 8f64.powi(shorter);
            let mut left = Self { first, span, exponents: [0.0; NODES] };
            for (exponent, node) in left.exponents.iter_mut().zip(nodes()) {
                *exponent = ln(span * node)? / (span * node);
            }
            let mut off: f64 = 0.0;
            for v in [0.2, 0.4, 0.6, 0.8, 0.97] {
                let s = span * v;
                off = off.max((ln(s)? - s * left.exponent(v)).abs());
            }
            if off <= ROUNDING_ULPS * f64::EPSILON {
                return Ok(Some(left));
            }
        }
        Ok(None)
    }

    /// The fraction at an interference `beyond` \[m\] above the first; `None` outside the range.
    pub(crate) fn at(&self, beyond: f64) -> Option<f64> {
        let s = (beyond / self.first).ln_1p();
        (s <= self.span).then(|| -(-s * self.exponent(s / self.span)).exp_m1())
    }

    /// The exponent p by barycentric interpolation; v from 0 to 1.
    fn exponent(&self, v: f64) -> f64 {
        let (mut above, mut below) = (0.0, 0.0);
        for (k, (node, exponent)) in nodes().zip(self.exponents).enumerate() {
            if v.total_cmp(&node).is_eq() {
                return exponent;
            }
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = sign * (node * (1.0 - node)).sqrt() / (v - node);
            above += weight * exponent;
            below += weight;
        }
        above / below
    }
}

/// Chebyshev points of the open interval from 0 to 1.
fn nodes() -> impl Iterator<Item = f64> {
    chebyshev_roots(NODES).map(|v| 0.5 + 0.5 * v)
}

#[cfg(test)]
mod tests {
    use super::RemainingFraction;

    #[test]
    fn small_remaining_fractions_keep_full_relative_accuracy() {
        // δ = √w + w/10 from w = 2 on: δ - u in closed form.
        let delta = |w: f64| w.sqrt() + 0.1 * w;
        let u = delta(2.0);
        let left =
            RemainingFraction::new([2.0, f64::INFINITY], u, |w| Ok(delta(w))).unwrap().unwrap();
        for beyond in [1e-18, 1e-12, 1e-6, 1e-3, 0.1, 0.5] {
            let grown = beyond / ((2.0_f64 + beyond).sqrt() + 2f64.sqrt()) + 0.1 * beyond;
            let (found, wanted) = (left.at(beyond).unwrap(), grown / (u + grown));
            assert!((found / wanted - 1.0).abs() < 3e-13, "{beyond}: {found} {wanted}");
        }
        assert!(left.at(1.0).is_none(), "outside the range");
        let jumps = RemainingFraction::new([2.0, 3.0], 0.9 * u, |w| Ok(delta(w))).unwrap();
        assert!(jumps.is_none());
    }
}
