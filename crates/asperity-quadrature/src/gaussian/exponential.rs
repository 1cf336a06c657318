//! The exponential function without a branch: the same digits on every processor, and quick where
//! it is taken of many numbers side by side.

use fearless_simd::{Bytes, Simd, SimdBase, f64x8, u64x8};

/// Exponents below this are taken for it: their exponentials are next to no normal numbers.
pub(crate) const LEAST: f64 = -700.0;
/// And those above this, which are next to infinity.
const MOST: f64 = 700.0;
/// Adding 1.5 · 2⁵² rounds to a whole number, in the lowest bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// ln 2 as a number of 33 bits and the rest.
const LN2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// eˣ within a unit of the last place for x from -700 to 700.
#[inline(always)]
pub(crate) fn exp<S: Simd>(simd: S, x: f64x8<S>) -> f64x8<S> {
    let splat = |value: f64| f64x8::splat(simd, value);
    let x = x.max(splat(LEAST)).min(splat(MOST));
    let shifted = x * std::f64::consts::LOG2_E + WHOLE;
    let whole = shifted - WHOLE;
    let r = (x - whole * LN2[0]) - whole * LN2[1];
    // 1/k!, by pairs, fours and eights: no product waits for long.
    let (r2, pair) = (r * r, |low: f64, high: f64| r * high + low);
    let r4 = r2 * r2;
    let low = pair(1.0 / 2.0, 1.0 / 6.0) + pair(1.0 / 24.0, 1.0 / 120.0) * r2;
    let middle = pair(1.0 / 720.0, 1.0 / 5_040.0) + pair(1.0 / 40_320.0, 1.0 / 362_880.0) * r2;
    let high = pair(1.0 / 3_628_800.0, 1.0 / 39_916_800.0)
        + pair(1.0 / 479_001_600.0, 1.0 / 6_227_020_800.0) * r2;
    let sum = (r + r2 * (low + r4 * (middle + r4 * high))) + 1.0;
    // 2 to the whole number: added to the exponent's bits.
    let bits = sum.bitcast::<u64x8<S>>() + (shifted.bitcast::<u64x8<S>>() << 52);
    bits.bitcast()
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::*;

    #[inline(always)]
    fn eight<S: Simd>(simd: S, x: [f64; 8]) -> [f64; 8] {
        exp(simd, f64x8::from_slice(simd, &x)).into()
    }

    #[test]
    fn exponentials_err_by_less_than_a_unit_of_the_last_place() {
        for k in -10_000..=10_000 {
            let x = [0, 1, 2, 3, 4, 5, 6, 7].map(|j| 0.07 * f64::from(k) + 0.00917 * f64::from(j));
            let found = dispatch!(Level::new(), simd => eight(simd, x));
            for (x, found) in x.iter().zip(found) {
                let wanted = x.clamp(LEAST, MOST).exp();
                assert!((found / wanted - 1.0).abs() <= f64::EPSILON, "{x}");
            }
        }
        let ends =
            dispatch!(Level::new(), simd => eight(simd, [0.0, -1e9, 1e9, 0., 0., 0., 0., 0.]));
        assert!(ends[0].to_bits() == 1f64.to_bits() && ends[1] < 1e-300 && ends[2] > 1e300);
    }
}
