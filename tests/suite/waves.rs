//! Laws that rise and fall more often than any model: every separation that carries a load.

use asperity::{
    Asperity, AsperityModel, ContactError, ContactModel, Formula, HeightDistribution, Interface,
    Law, Quantity, Request, Scene, Surface, Tolerance, WeibullHeights, testkit,
};

use crate::crossings::wrong;
use crate::scenes::described;

described!(Wavy, Endless);

/// A law that rises and falls twice, though declared monotone.
#[derive(Debug)]
struct Wavy;

impl AsperityModel for Wavy {
    fn force(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let wave = |x: f64, at: f64, width: f64| (-((x - at) / width).powi(2)).exp();
        let law =
            move |x: f64| x * wave(x, 6.0, 4.0) + 0.32 * x * x * wave(x, 25.0, 6.0) + 0.01 * x;
        let all = 0.0..f64::INFINITY;
        Ok(Law::in_units(1e-6, 1e-3).elastic(all, Formula::function(law)))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.force(asperity, tolerance)
    }
}

#[test]
fn forces_that_fall_though_declared_monotone_are_searched() {
    let scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-4);
    let contact = Wavy.compile(&scene, &Request::new([Quantity::Force])).unwrap();
    for (load, count) in [(500.0, 5), (5000.0, 3)] {
        assert_eq!(wrong(&*contact, load), None, "{load}");
        assert_eq!(contact.separations_at(load).unwrap().len(), count, "{load}");
        let row = Wavy.solve(&scene, &Request::new([Quantity::Force]).at_loads([load])).unwrap();
        let force = row.values(Quantity::Force).unwrap()[0];
        assert!((force / load - 1.0).abs() < 1e-8, "{load}: {force}");
    }
    let asperity = scene.asperity().unwrap();
    let found = testkit::check(&Wavy, &asperity).unwrap();
    assert!(found.iter().any(|f| f.code.name() == "not-monotone"), "{found:?}");
}

/// A law that waves without end, about a line.
#[derive(Debug)]
struct Endless;

impl AsperityModel for Endless {
    fn force(&self, _: &Asperity, _: Tolerance) -> Result<Law, ContactError> {
        let law = |x: f64| x * (1.0 + 0.9 * (8.0 * x).sin());
        let all = 0.0..f64::INFINITY;
        Ok(Law::in_units(1e-6, 1e-4).elastic(all, Formula::function(law)))
    }

    fn area(&self, asperity: &Asperity, tolerance: Tolerance) -> Result<Law, ContactError> {
        self.force(asperity, tolerance)
    }
}

#[test]
fn a_law_that_waves_without_end_is_followed_as_far_as_a_load_needs() {
    let mut scene = Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 1e-6), 1e-4);
    let weibull = HeightDistribution::Weibull(WeibullHeights::new(1.0).unwrap());
    for heights in [HeightDistribution::Exponential, weibull] {
        scene.heights = heights;
        let contact = Endless.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        for load in [1e-6, 0.1, 1.0] {
            let all = contact.separations_at(load).unwrap();
            let force = contact.evaluate(Quantity::Force, all[0]).unwrap().value();
            assert!(all.len() == 1 && (force / load - 1.0).abs() < 1e-8, "{load}: {all:?}");
            assert_eq!(all[0], contact.separation_at(load).unwrap(), "{load}");
        }
    }
}
