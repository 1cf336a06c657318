//! Unloading where heights end steeply, or far from a Gaussian's tail.
#![allow(clippy::unwrap_used, reason = "a test binary: a panic is the failure")]
#![allow(clippy::float_cmp, reason = "0 is meant to be 0")]

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    At, ContactModel, HeightDistribution, Interface, Quantity, Scene, Surface, Tolerance,
    WeibullHeights,
};
use asperity_gw::GreenwoodWilliamson;
use asperity_joints::{Joint, UnloadingLaw};
use asperity_ke::KogutEtsion;

const SIGMA: f64 = 1e-6;

fn joint(model: &dyn ContactModel, skewness: f64) -> Joint {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let mut scene = Scene::new(interface, Surface::new(3.6e-4, 1.1e8, SIGMA), 3e-5);
    scene.heights = HeightDistribution::Weibull(WeibullHeights::new(skewness).unwrap());
    Joint::new(model, &scene, UnloadingLaw::Hertz, Tolerance::default()).unwrap()
}

fn retreats() -> impl Iterator<Item = f64> {
    (0..14).map(|k| SIGMA * 10f64.powf(-4.0 + 0.4 * f64::from(k)))
}

#[test]
fn what_never_yielded_goes_back_on_its_own_curve() {
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
                    // Where both underflow, there is nothing to be off by.
                    let close = error <= bound * wanted || [found, wanted] == [0.0; 2];
                    assert!(close, "{skewness} {closest} {retreat}: {found} {wanted}");
                }
            }
        }
    }
}

#[test]
fn what_has_yielded_opens_until_nothing_is_left() {
    let models: [&dyn ContactModel; 3] = [&AbdoFarhang::default(), &ChangEtsionBogy, &KogutEtsion];
    for skewness in [-0.9, -0.6, 0.6, 1.3] {
        for model in models {
            let joint = joint(model, skewness);
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
