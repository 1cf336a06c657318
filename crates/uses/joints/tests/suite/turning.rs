//! Laws with a recovered interference δ that decreases with the interference.

use std::f64::consts::PI;

use asperity_core::{AsperityModel, At, Interface, Scene, Surface, Tolerance};
use asperity_jg::{GeometricHardness, JacksonGreen};
use asperity_joints::{Unloading, UnloadingLaw};

#[test]
fn shallow_contacts_may_last_longer_than_deep_ones() {
    let model = JacksonGreen { hardness: GeometricHardness::Cosine };
    let interface = Interface::new(55.8e9, 0.33, 8.5e8);
    let scene = Scene::new(interface, Surface::new(6e-5, 3e8, 2e-6), 6.1e-4);
    let asperity = scene.asperity().unwrap();
    let tolerance = Tolerance::default();
    let force = model.force(&asperity, tolerance).unwrap();
    let area = model.area(&asperity, tolerance).unwrap();
    let delta = |w: f64| {
        let radius = (area.value(w).unwrap() / PI).sqrt();
        0.75 * force.value(w).unwrap() / (asperity.equivalent_modulus * radius)
    };
    // δ has a maximum.
    let places = || (1..2000).map(|k| 1e-8 * f64::from(k));
    let highest = places().fold(0.0, |m: f64, w| m.max(delta(w)));
    assert!(delta(2e-5) < 0.95 * highest);

    let closest = 0.0;
    let way = Unloading::new(&model, &scene, At::sigmas(closest), UnloadingLaw::Hertz, tolerance)
        .unwrap();
    for share in [0.3, 0.9, 0.97, 0.99, 0.999] {
        let u = share * highest;
        // A sum over asperities, by the midpoint rule.
        let (steps, top) = (400_000, 7.0 * 2e-6);
        let step = top / f64::from(steps);
        let sum: f64 = (0..steps)
            .map(|k| {
                let w = (f64::from(k) + 0.5) * step;
                let left = (1.0 - u / delta(w)).max(0.0);
                let zeta = closest + w / 2e-6;
                force.value(w).unwrap() * left.powf(1.5) * (-0.5 * zeta * zeta).exp()
            })
            .sum();
        let wanted = sum * step / 2e-6 / (2.0 * PI).sqrt() * scene.asperities();
        let found = way.force(u).unwrap().value();
        // The midpoint rule has an error of about 4e-11.
        assert!((found / wanted - 1.0).abs() < 2e-10, "{share}: {found} {wanted}");
    }
    assert!(way.force(1.001 * highest).unwrap().value() < 1e-20);
}
