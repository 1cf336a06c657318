//! Weibull heights by their skewness, against exponential ones and against mpmath
//! (`tests/reference/weibull.py`).

use std::f64::consts::{LN_10, PI};

use asperity::{
    At, Case, HeightDistribution, Quantity, Request, Surface, Sweep, Tolerance, WeibullHeights,
};

use super::{ASKED, densities::scene};
use crate::scenes::{compiled, model};

const SEPARATIONS: [f64; 6] = [-6.0, -2.0, -0.3, 0.5, 2.0, 6.0];

fn skewed(skewness: f64) -> HeightDistribution {
    HeightDistribution::Weibull(WeibullHeights::new(skewness).unwrap())
}

#[test]
fn a_skewness_of_two_is_exponential() {
    let (weibull, exponential) = (scene(skewed(2.0)), scene(HeightDistribution::Exponential));
    for id in ["gw", "ceb", "ke", "jg", "af"] {
        let model = model(id);
        let [weibull, exponential] =
            [&weibull, &exponential].map(|scene| compiled(&model, scene, &ASKED, 1e-10));
        for d in SEPARATIONS {
            for quantity in ASKED {
                // The mean is one standard deviation above the lowest.
                let found = weibull.evaluate(quantity, d).unwrap();
                let wanted = exponential.evaluate(quantity, d + 1.0).unwrap();
                let error = (found.value() / wanted.value() - 1.0).abs();
                let bound = found.relative_error() + wanted.relative_error();
                // The excess over the bound is the error of the skewness, 1e-13 of 1/k.
                assert!(error < bound + 1e-12, "{id} {quantity} {d}: {error:e} {bound:e}");
            }
        }
    }
}

#[test]
fn force_area_and_tangent_are_those_of_mpmath() {
    let mut count = 0;
    for line in include_str!("../../reference/weibull.csv").lines().skip(1) {
        // Some underflow f64, so the values are mantissas and exponents.
        let ln = |text: &str| {
            let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
            mantissa.parse::<f64>().unwrap().ln() + LN_10 * exponent.parse::<f64>().unwrap()
        };
        let fields: Vec<&str> = line.split(',').collect();
        let [skewness, s] = [0, 1].map(|k| fields[k].parse::<f64>().unwrap());
        let scene = scene(skewed(skewness));
        let Surface { asperity_radius: radius, asperity_height_std: sigma, .. } = scene.surface;
        let elastic = 4.0 / 3.0 * scene.interface.equivalent_modulus * radius.sqrt();
        let factors =
            [elastic * sigma.powf(1.5), PI * radius * sigma, 1.5 * elastic * sigma.sqrt()];
        let gw = compiled(&model("gw"), &scene, &ASKED, 1e-11);
        // The skewness has an error of 1e-12, which matters far in the tail.
        let beside = compiled(&model("gw"), &self::scene(skewed(skewness + 1e-4)), &ASKED, 1e-11);
        for ((quantity, factor), column) in ASKED.into_iter().zip(factors).zip([3, 2, 4]) {
            let found = gw.evaluate(quantity, s).unwrap();
            let wanted = ln(fields[column]) + (factor * scene.asperities()).ln();
            // Values that underflow f64 have logarithms of some 1700, rounded to an ulp.
            let rounding = 4.0 * f64::EPSILON * (4.0 + wanted.abs());
            let beside = beside.evaluate(quantity, s).unwrap().ln_value();
            let felt = 1e-12 * (beside - found.ln_value()).abs() / 1e-4;
            let error = (found.ln_value() - wanted).abs();
            // Values that underflow f64 have a relative error through their logarithm only.
            let bound = if wanted < -700.0 { 1e-11 } else { found.relative_error() };
            assert!(
                error < bound + rounding + felt,
                "{line}: {quantity} {found:?} {wanted} {bound:e} {felt:e}"
            );
            assert!(bound <= 1e-11, "{line}: {quantity} {bound:e}");
            count += 1;
        }
    }
    assert_eq!(count, 90);
}

#[test]
fn far_out_every_row_has_its_logarithm() {
    for line in include_str!("../../reference/weibull_far.csv").lines().skip(1) {
        let [skewness, shape, s, wanted] =
            std::array::from_fn(|k| line.split(',').nth(k).unwrap().parse::<f64>().unwrap());
        let heights = WeibullHeights::new(skewness).unwrap();
        assert_eq!(heights.shape().to_bits(), shape.to_bits(), "{line}");
        let scene = scene(HeightDistribution::Weibull(heights));
        let Surface { asperity_radius: radius, asperity_height_std: sigma, .. } = scene.surface;
        let elastic = 4.0 / 3.0 * scene.interface.equivalent_modulus * radius.sqrt();
        let wanted = wanted + (elastic * sigma.powf(1.5) * scene.asperities()).ln();
        let gw = compiled(&model("gw"), &scene, &[Quantity::LnForce], 1e-10);
        let found = gw.evaluate(Quantity::LnForce, s).unwrap();
        let (error, bound) = ((found.value() - wanted).abs(), found.bound(Quantity::LnForce));
        assert!(error <= bound, "{line}: {error:e} {bound:e}");
        // The digits that a logarithm of this size has; beyond 1e13 there are none.
        let rounding = 200.0 * f64::EPSILON * wanted.abs();
        assert!(bound <= 1e-10 + rounding || rounding > 0.5, "{line}: {bound:e}");
    }
    // No row between these is refused.
    for skewness in [-1.0, -0.95, -0.87, -0.5] {
        let gw = compiled(&model("gw"), &scene(skewed(skewness)), &[Quantity::LnForce], 1e-10);
        for k in 0..160 {
            let s = 8.0 + 0.2 * f64::from(k);
            assert!(gw.evaluate(Quantity::LnForce, s).is_ok(), "{skewness} {s}");
        }
    }
}

#[test]
fn the_lowest_asperities_are_counted_at_any_slope_of_the_density() {
    // Below all of them, everything is in contact: π R η A_n σ_z (m - d), for any density.
    let gw = model("gw");
    for step in 0..=120 {
        let skewness = -1.0 + 0.025 * f64::from(step);
        let scene = scene(skewed(skewness.min(2.0)));
        let contact = compiled(&gw, &scene, &[Quantity::Area], 1e-10);
        let Surface { asperity_radius: radius, asperity_height_std: sigma, .. } = scene.surface;
        let found = contact.evaluate(Quantity::Area, -50.0).unwrap();
        let wanted = PI * radius * scene.asperities() * sigma * 50.0;
        let error = (found.value() / wanted - 1.0).abs();
        assert!(error <= found.relative_error(), "{skewness}: {error:e} {found:?}");
    }
}

#[test]
fn heights_stretch_with_the_standard_deviation() {
    let (model, first) = (model("ke"), scene(skewed(-0.5)));
    let tolerance = Tolerance::new(1e-10).unwrap();
    let mut second = first.clone();
    second.surface.asperity_height_std *= 2.5;
    // The laws do not depend on σ_z, so the compiled scene can be moved.
    let anew = compiled(&model, &second, &ASKED, 1e-10);
    let moved = compiled(&model, &first, &ASKED, 1e-10).on(&second).unwrap();
    let sweep = Sweep::new(&*model, &ASKED, tolerance);
    for d in [-1.0, 1.0, 2.5] {
        let swept = sweep.evaluate(&Case::new(second.clone(), d)).unwrap();
        let few = Request::new(ASKED).at([At::sigmas(d)]).within(tolerance);
        let few = model.solve(&second, &few).unwrap();
        for (k, quantity) in ASKED.into_iter().enumerate() {
            let wanted = anew.evaluate(quantity, d).unwrap().value();
            let others = [
                moved.evaluate(quantity, d).unwrap().value(),
                swept[k].value(),
                few.columns[k].rows[0].as_ref().unwrap().value(),
            ];
            for found in others {
                assert!((found / wanted - 1.0).abs() < 2e-10, "{quantity} {d}: {found} {wanted}");
            }
        }
    }
}
