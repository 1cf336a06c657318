//! A quantity of one asperity after a retreat, as a law that the engine integrates over heights.

use std::sync::Arc;

use asperity_core::{
    Asperity, AsperityModel, Citation, ContactError, Described, Formula, Law, QuadratureError,
    Quantity, Sampler, Tolerance,
};
use asperity_quadrature::chebyshev_roots;

use crate::asperity_laws::{AsperityLaws, UnloadingQuantity, refused};
use crate::contact_range::contact_range;

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

/// A quantity of one asperity after a retreat, as the force law of a model.
#[derive(Debug)]
pub(crate) struct RetreatModel<'u> {
    pub(crate) source: &'u Citation,
    pub(crate) name: &'u str,
    /// The smallest interference \[m\] that contributes, the onset of the law.
    pub(crate) first: f64,
    law: Law,
}

impl<'u> RetreatModel<'u> {
    pub(crate) fn new(
        (source, name): (&'u Citation, &'u str),
        loading: &Arc<AsperityLaws>,
        quantity: UnloadingQuantity,
        u: f64,
    ) -> Result<Self, ContactError> {
        let (unit, value_unit) = (loading.force.interference_unit, loading.force.value_unit);
        let value_unit = match quantity {
            UnloadingQuantity::Area => loading.area.value_unit,
            UnloadingQuantity::Contacts => 1.0,
            UnloadingQuantity::Stiffness => value_unit / unit,
            UnloadingQuantity::Loss | UnloadingQuantity::Returned => value_unit * unit,
            UnloadingQuantity::Force | UnloadingQuantity::Released => value_unit,
        };
        let failed = |source: QuadratureError| refused(name, "retreat", u, &source);
        let whole = quantity.sums_up();
        let mut ranges = vec![];
        for pair in loading.breaks().windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let found = contact_range(&|w| loading.recovered(w), [low, high], u).map_err(failed)?;
            match found {
                Some([from, to]) if !whole => ranges.push((from, to)),
                // Asperities out of contact have released their whole force.
                Some([from, to]) => ranges.extend([(low, from), (from, to), (to, high)]),
                None if whole => ranges.push((low, high)),
                None => {}
            }
        }
        ranges.retain(|(low, high)| high > low);
        // x starts at the first remaining contact, which may be far beyond the heights integrated
        // at the closest approach.
        let first = ranges.first().map_or(0.0, |(low, _)| *low);
        let mut law = Law::in_units(unit, value_unit).with_onset(first / unit);
        for (low, high) in ranges {
            // At a kink, δ of the first remaining contact may exceed u.
            let near = match u > 0.0 && low <= first && !whole {
                true => RemainingFraction::new([low, high], u, |w| loading.recovered(w))
                    .map_err(failed)?,
                false => None,
            };
            let loading = loading.clone();
            let sample = move |x: &[f64], out: &mut [f64]| {
                for (out, x) in out.iter_mut().zip(x) {
                    let left = near.as_ref().and_then(|near| near.at(x * unit));
                    *out = loading.answer(first + x * unit, u, left, quantity)? / value_unit;
                }
                Ok(())
            };
            let sampler: Arc<dyn Sampler> = Arc::new(sample);
            law =
                law.elastic((low - first) / unit..(high - first) / unit, Formula::sampled(sampler));
        }
        let law = match loading.sum {
            Some(sum) => sum(law, &loading.asperity)?,
            None => law,
        };
        Ok(Self { source, name, first, law })
    }
}

impl Described for RetreatModel<'_> {
    fn citation(&self) -> &Citation {
        self.source
    }

    fn name(&self) -> &str {
        self.name
    }
}

impl AsperityModel for RetreatModel<'_> {
    fn force(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        Ok(self.law.clone())
    }

    fn area(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        // Only forces are asked of this model.
        Err(ContactError::NoLaw { model: self.name.into(), quantity: Quantity::Area })
    }
}

/// 1 - u/δ(w) for w beyond the interference with δ = u.
///
/// δ/u = (w/first)^p with nearly constant p: 1 - (w/first)⁻ᵖ avoids the cancellation of 1 - u/δ
/// close to 0, where most of the force arises far in the tail of the heights.
#[derive(Debug, Clone)]
struct RemainingFraction {
    first: f64,
    span: f64,
    /// p at the nodes.
    exponents: [f64; NODES],
}

impl RemainingFraction {
    /// Interpolates from `first`, where δ reaches u, to `high` at most; `None` where δ jumps beyond
    /// u or is not smooth.
    fn new(
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
    fn at(&self, beyond: f64) -> Option<f64> {
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
