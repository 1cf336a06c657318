//! Unloading where heights end steeply, or far from a Gaussian's tail.

use asperity_af::AbdoFarhang;
use asperity_ceb::ChangEtsionBogy;
use asperity_core::{
    At, ContactModel, HeightDistribution, Interface, Quantity, Scene, Surface, TabulatedHeights,
    Tolerance, WeibullHeights,
};
use asperity_gw::GreenwoodWilliamson;
use asperity_joints::{Joint, UnloadingLaw};
use asperity_ke::KogutEtsion;

const SIGMA: f64 = 1e-6;

fn scene() -> Scene {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    Scene::new(interface, Surface::new(3.6e-4, 1.1e8, SIGMA), 3e-5)
}

fn joint(model: &dyn ContactModel, skewness: f64) -> Joint {
    let mut scene = scene();
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
                    let close = error <= bound * wanted || found.max(wanted) <= 0.0;
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

#[test]
fn flat_heights_open_up_to_the_last_contact() {
    let points: Vec<(f64, f64)> = [-1.5, 1.5].map(|s| (s * SIGMA, 1.0 / (3.0 * SIGMA))).into();
    let heights = TabulatedHeights::new("flat", &points).unwrap();
    let models: [&dyn ContactModel; 3] = [&GreenwoodWilliamson, &ChangEtsionBogy, &KogutEtsion];
    for model in models {
        let mut scene = scene();
        scene.heights = HeightDistribution::other(heights.clone());
        scene.surface.asperity_height_std = heights.standard_deviation();
        let tolerance = Tolerance::new(1e-9).unwrap();
        let joint = Joint::new(model, &scene, UnloadingLaw::Hertz, tolerance).unwrap();
        for closest in [-0.5, 0.0, 0.7] {
            let way = joint.unloading(At::metres(closest * SIGMA)).unwrap();
            // To the last double at which anything touches.
            let (mut touches, mut open) = (0.0, 3.0 * SIGMA);
            for _ in 0..80 {
                let middle = 0.5 * (touches + open);
                let force = way.force(middle).unwrap().value();
                *(if force > 0.0 { &mut touches } else { &mut open }) = middle;
            }
            assert!(touches > 0.01 * SIGMA, "{} {closest} {touches}", model.name());
        }
        joint.table((0.0, SIGMA), 1e-5).unwrap();
    }
}
