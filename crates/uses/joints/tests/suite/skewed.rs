//! Unloading with heights that end steeply or have a tail far from Gaussian.

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{At, ContactModel, HeightDistribution, Quantity, Tolerance, WeibullHeights};
use asperity_gw::GreenwoodWilliamson;
use asperity_joints::{Joint, UnloadingLaw};
use asperity_ke::KogutEtsion;

use crate::is_long;
use crate::scenes::{SIGMA, flat, with_index};

fn joint(model: &dyn ContactModel, skewness: f64) -> Joint {
    let mut scene = with_index(6.0);
    scene.heights = HeightDistribution::Weibull(WeibullHeights::new(skewness).unwrap());
    Joint::new(model, &scene, UnloadingLaw::Hertz, Tolerance::default()).unwrap()
}

fn retreats() -> impl Iterator<Item = f64> {
    (0..14).map(|k| SIGMA * 10f64.powf(-4.0 + 0.4 * f64::from(k)))
}

#[test]
fn elastic_contacts_unload_on_the_loading_curve() {
    for skewness in [-0.9, -0.6, 0.6, 1.3] {
        let joint = joint(&GreenwoodWilliamson, skewness);
        for closest in [-1.0, 0.3, 2.0] {
            let way = joint.unloading(At::sigmas(closest)).unwrap();
            for retreat in retreats() {
                let [found, slope] =
                    [way.force(retreat), way.stiffness(retreat)].map(Result::unwrap);
                let place = At::metres(closest * SIGMA + retreat);
                let of = |quantity| joint.virgin().evaluate(quantity, place).unwrap();
                let (force, tangent) = (of(Quantity::Force), of(Quantity::Tangent));
                for (found, wanted) in [(found, force), (slope, tangent)] {
                    let bound = found.relative_error() + wanted.relative_error() + 1e-12;
                    let (found, wanted) = (found.value(), wanted.value());
                    let error = (found - wanted).abs();
                    // Both may underflow.
                    let close = error <= bound * wanted || found.max(wanted) <= 0.0;
                    assert!(close, "{skewness} {closest} {retreat}: {found} {wanted}");
                }
            }
        }
    }
}

#[test]
fn plastic_contacts_open_to_zero_force() {
    let models: [&dyn ContactModel; 3] = [&AbdoFarhang::default(), &ChangEtsionBogy, &KogutEtsion];
    let skewnesses = [-0.9, 1.3, -0.6, 0.6];
    for skewness in skewnesses.into_iter().take(if is_long() { 4 } else { 1 }) {
        for model in &models[..if is_long() { 3 } else { 1 }] {
            let joint = joint(*model, skewness);
            for closest in [-1.0, 0.3, 2.06, 2.91] {
                let way = joint.unloading(At::sigmas(closest)).unwrap();
                let mut before = f64::INFINITY;
                for retreat in retreats() {
                    let force = way.force(retreat).unwrap().value();
                    assert!(force <= before, "{} {skewness} {closest} {retreat}", model.name());
                    before = force;
                }
                assert!(before < 1e-6, "{} {skewness} {closest}: {before} N", model.name());
            }
            joint.table((0.0, 3.0 * SIGMA), 1e-4).unwrap();
        }
    }
}

#[test]
fn flat_heights_open_up_to_the_last_contact() {
    let scene = flat(6.0);
    let joint = |model: &dyn ContactModel, tolerance| {
        Joint::new(model, &scene, UnloadingLaw::Hertz, Tolerance::new(tolerance).unwrap()).unwrap()
    };
    for closest in [-0.5, 0.0, 0.7] {
        let top = (2.0 - closest) * SIGMA;
        // Heights end at 2 σ_z: a sum of 4/3 E √R w^1.5 over 0 to h is 8/15 E √R h^2.5.
        let way = joint(&GreenwoodWilliamson, 1e-9).unloading(At::metres(closest * SIGMA)).unwrap();
        let (e, radius) = (scene.interface.equivalent_modulus, scene.surface.asperity_radius);
        for h in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6].map(|h| h * top) {
            let found = way.force(top - h).unwrap();
            let hertz = 8.0 / 15.0 * e * radius.sqrt() * h.powf(2.5);
            let wanted = scene.asperities() / (4.0 * SIGMA) * hertz;
            // Rounding errors of the retreat and of the table's end.
            let rounding = 2.5 * 8.0 * f64::EPSILON * top / h;
            let error = (found.value() / wanted - 1.0).abs();
            assert!(
                error <= found.relative_error() + rounding,
                "{closest} {h:e}: {error:e} {found:?}"
            );
        }
        for model in [&ChangEtsionBogy as &dyn ContactModel, &KogutEtsion] {
            let joint = joint(model, 1e-9);
            let way = joint.unloading(At::metres(closest * SIGMA)).unwrap();
            // Bisection to the largest retreat with a force.
            let (mut touches, mut open) = (0.0, 4.0 * SIGMA);
            for _ in 0..80 {
                let middle = 0.5 * (touches + open);
                let force = way.force(middle).unwrap().value();
                *(if force > 0.0 { &mut touches } else { &mut open }) = middle;
            }
            assert!(touches > 0.01 * SIGMA, "{} {closest} {touches}", model.name());
            joint.table((0.0, SIGMA), 1e-5).unwrap();
        }
    }
}
