//! Cycles between tangential forces instead of shifts.

use asperity_core::{At, HeightDistribution, Scene, TabulatedHeights, Tolerance};
use asperity_gw::GreenwoodWilliamson;
use asperity_joints::{PartialSlip, Unloading, UnloadingLaw};
use asperity_ke::KogutEtsion;

use crate::scenes::{SIGMA, tight, with_index};

const FRICTION: f64 = 0.2;

fn sheared(scene: &Scene, at: At) -> PartialSlip {
    let joint = Unloading::new(&GreenwoodWilliamson, scene, at, UnloadingLaw::Hertz, tight());
    PartialSlip::new(&joint.unwrap(), FRICTION).unwrap()
}

fn with_shear(index: f64) -> Scene {
    let mut scene = with_index(index);
    scene.interface.equivalent_shear_modulus = Some(41e9);
    scene
}

/// μ E/(4 G): the shift over the retreat.
fn shift_per_retreat(scene: &Scene) -> f64 {
    let interface = scene.interface;
    FRICTION * interface.equivalent_modulus / (4.0 * interface.equivalent_shear_modulus.unwrap())
}

#[test]
fn a_sphere_is_that_of_cattaneo_and_mindlin() {
    let mut scene = with_shear(1.0);
    // Heights that differ by 1e-5 of the interference: of the second order in the sum.
    let (interference, width) = (SIGMA, 1e-5 * SIGMA);
    let points = [(-width, 0.5 / width), (width, 0.5 / width)];
    scene.heights = HeightDistribution::other(TabulatedHeights::new("one", &points).unwrap());
    let slip = sheared(&scene, At::metres(-interference));
    let limit = slip.limit().unwrap();
    for share in [1e-6, 0.01, 0.3, 0.9, 0.999] {
        let found = slip.amplitude_at(share * limit).unwrap();
        let retreat = interference * (1.0 - (1.0 - share).powf(2.0 / 3.0));
        let wanted = shift_per_retreat(&scene) * retreat;
        assert!((found / wanted - 1.0).abs() < 1e-8, "{share}: {found:e} {wanted:e}");
    }
}

#[test]
fn exponential_heights_have_a_closed_form() {
    let mut scene = with_shear(1.0);
    scene.heights = HeightDistribution::Exponential;
    let slip = sheared(&scene, At::from(1.0));
    let limit = slip.limit().unwrap();
    for share in [1e-6, 0.01, 0.3, 0.9, 0.999] {
        let found = slip.amplitude_at(share * limit).unwrap();
        let wanted = -shift_per_retreat(&scene) * SIGMA * (-share).ln_1p();
        assert!((found / wanted - 1.0).abs() < 1e-11, "{share}: {found:e} {wanted:e}");
    }
}

#[test]
fn the_force_at_the_amplitude_is_the_one_asked_for() {
    let scene = with_shear(6.0);
    let joint = Unloading::new(&KogutEtsion, &scene, At::Load(100.0), UnloadingLaw::Hertz, tight());
    let yielding = PartialSlip::new(&joint.unwrap(), FRICTION).unwrap();
    for slip in [sheared(&scene, At::Load(100.0)), yielding] {
        let limit = slip.limit().unwrap();
        assert!((limit / 20.0 - 1.0).abs() < 1e-11, "{limit}");
        for share in [1e-8, 1e-3, 0.1, 0.5, 0.99, 1.0 - 1e-6] {
            let force = share * limit;
            let back = slip.force(slip.amplitude_at(force).unwrap()).unwrap().value();
            assert!((back / force - 1.0).abs() < 1e-12, "{share}: {back:e} of {force:e}");
        }
    }
}

#[test]
fn small_cycles_dissipate_with_the_cube_of_the_force() {
    let slip = sheared(&with_shear(1.0), At::Load(100.0));
    let limit = slip.limit().unwrap();
    let loss = |share: f64| slip.loss(slip.amplitude_at(share * limit).unwrap()).unwrap().value();
    for (share, off) in [(1e-2, 2e-2), (1e-3, 2e-3), (1e-4, 2e-4)] {
        let exponent = (loss(2.0 * share) / loss(share)).log2();
        assert!((exponent - 3.0).abs() < off, "{share}: {exponent}");
    }
}

/// Rounding of the load decides on which side of mu F these forces are.
#[test]
fn a_force_within_the_tolerance_of_friction_slides_at_every_preload() {
    let mut scene = with_shear(1.0);
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential] {
        scene.heights = heights;
        for load in [1.0, 50.0, 100.0, 500.0, 2000.0] {
            let (at, law) = (At::Load(load), UnloadingLaw::Hertz);
            let tolerance = Tolerance::default();
            let joint = Unloading::new(&GreenwoodWilliamson, &scene, at, law, tolerance).unwrap();
            let slip = PartialSlip::new(&joint, FRICTION).unwrap();
            for share in [1.0, 1.0 - 1e-15, 1.0 - 1e-12, 1.0 - 1e-10, 1.0 - 1e-8] {
                let force = FRICTION * load * share;
                let refused = slip.amplitude_at(force).unwrap_err().to_string();
                assert!(refused.contains("joint slides"), "{refused}");
            }
        }
        // An amplitude that is given is good to the tolerance: the amplitude of a force 1e-15 away
        // is as near.
        let slip = sheared(&scene, At::Load(100.0));
        for share in [0.5, 0.99, 1.0 - 1e-4] {
            let near = |force: f64| slip.amplitude_at(share * 20.0 * force).unwrap();
            assert!((near(1.0 + 1e-15) / near(1.0) - 1.0).abs() < 1e-10, "{share}");
        }
    }
}

#[test]
fn what_exceeds_friction_slides() {
    let slip = sheared(&with_shear(1.0), At::Load(100.0));
    for force in [20.000_001, 1e30, 0.0, -1.0, f64::NAN] {
        let refused = slip.amplitude_at(force).unwrap_err().to_string();
        assert!(refused.starts_with("tangential_force is "), "{refused}");
        let slides = refused.contains("joint slides");
        assert_eq!(slides, force > 20.0, "{refused}");
    }
}
