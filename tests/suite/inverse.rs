//! From a load back to the separation, for every model.

use asperity::{HeightDistribution, Model, Quantity, Request, Surface};

use crate::scenes;

#[test]
fn every_model_finds_the_separation_it_came_from() {
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential] {
        let mut scene = scenes::named("at-paper");
        scene.heights = heights;
        for model in Model::all() {
            let compiled = model.compile(&scene, &Request::new([Quantity::Force])).unwrap();
            for s in [-2.0, 0.5, 3.0, 12.0] {
                let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
                if load <= 0.0 {
                    continue;
                }
                let found = compiled.separations_at(load).unwrap();
                // d ln F/ds is at least 1 here, so the rule's 1e-10 moves the root by less.
                assert!(found.iter().any(|d| (d - s).abs() < 1e-9), "{model} {s}: {found:?}");
            }
        }
    }
}

#[test]
fn where_the_printed_force_rises_and_falls_all_crossings_are_given() {
    let mut scene = scenes::named("at-paper");
    scene.surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &scene.interface).unwrap();
    let model: Model = "at".parse().unwrap();
    let compiled = model.compile(&scene, &Request::new([Quantity::Force])).unwrap();
    // Negative around d = 1, positive again in the tail: a small load is met on both sides.
    assert!(compiled.evaluate(Quantity::Force, 1.0).unwrap().value() < 0.0);
    let load = compiled.evaluate(Quantity::Force, 5.0).unwrap().value();
    let found = compiled.separations_at(load).unwrap();
    assert!(found.len() >= 2, "{found:?}");
    for d in found {
        let force = compiled.evaluate(Quantity::Force, d).unwrap().value();
        assert!((force / load - 1.0).abs() < 1e-6, "{d}: {force} {load}");
    }
}
