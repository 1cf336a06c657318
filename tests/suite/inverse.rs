//! The separation of a load, for every model.

use asperity::{
    At, Case, Contact, HeightDistribution, Interface, Model, Quantity, Request, Scene, Surface,
    Sweep, Tolerance,
};

use crate::scenes;

#[test]
fn every_model_recovers_the_separation_from_the_load() {
    for heights in [HeightDistribution::Gaussian, HeightDistribution::Exponential] {
        let mut scene = scenes::named("at-paper");
        scene.heights = heights;
        for model in Model::of_asperities() {
            let compiled = model.compile(&scene, &Request::new([Quantity::Force])).unwrap();
            for s in [-63.0, -2.0, 0.5, 3.0, 12.0, 36.0] {
                let load = compiled.evaluate(Quantity::Force, s).unwrap().value();
                if load <= 0.0 {
                    continue;
                }
                let found =
                    compiled.separations_at(load).unwrap_or_else(|e| panic!("{model} {s} {e}"));
                // d ln F/ds is at least 1 here, so the rule's 1e-10 moves the root by less; the
                // rules of upright models err by a hundredth of that.
                let within = if model.validity().angles { 1e-9 } else { 1e-11 };
                let found = found.iter().any(|d| (d.value - s).abs() < within * (1.0 + s.abs()));
                assert!(found, "{model} {s}");
            }
        }
    }
}

#[test]
fn all_crossings_of_the_printed_force_are_found() {
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

/// Crossings from a fine scan: no feature of the force is narrower than a standard deviation.
fn seen(contact: &impl AsRef<dyn Contact>, load: f64) -> Vec<f64> {
    let contact = contact.as_ref();
    let force = |s: f64| contact.evaluate(Quantity::Force, s).unwrap().value() - load;
    let grid: Vec<f64> = (0..8000).map(|k| -60.0 + 0.01 * f64::from(k)).collect();
    grid.windows(2).filter(|p| force(p[0]) * force(p[1]) <= 0.0).map(|p| p[0]).collect()
}

#[test]
fn no_crossing_of_a_printed_sum_is_missed() {
    // A load for which only -4.336 was once found.
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    interface.pressure_factor = Some(0.58);
    let at: Model = "at".parse().unwrap();
    let request = Request::new([Quantity::Force]).within(Tolerance::new(1e-8).unwrap());
    let on = |index: f64| {
        let surface = Surface::from_plasticity_index(index, 0.04, 1e-6, &interface).unwrap();
        at.compile(&Scene::new(interface, surface, 3e-5), &request).unwrap()
    };
    let found = on(1.423_518_176_927_779_4).separations_at(2.702_940_175_421_448).unwrap();
    let found: Vec<f64> = found.iter().map(|d| d.value).collect();
    assert!(found.len() == 3, "{found:?}");
    for (found, wanted) in found.iter().zip([-4.336, 1.053, 1.9895]) {
        assert!((found - wanted).abs() < 6e-4, "{found} {wanted}");
    }
    let (mut several, mut singly) = (0, 0);
    for (k, index) in [1.1, 1.35, 1.5, 2.0, 2.6, 3.3].into_iter().enumerate() {
        let contact = on(index);
        for j in 0..12 {
            let load = 10f64.powf(-8.0 + 0.9 * f64::from(j) + 0.13 * k as f64);
            let wanted = seen(&contact, load);
            match contact.separations_at(load) {
                Ok(found) => {
                    let near = |s: f64| found.iter().any(|d| d.value >= s && d.value <= s + 0.01);
                    let inside = found.iter().filter(|d| d.value > -60.0).count();
                    assert!(
                        wanted.iter().all(|s| near(*s)) && inside == wanted.len(),
                        "{index} {load}: {found:?} {wanted:?}"
                    );
                    let largest = contact.separation_at(load).unwrap();
                    assert_eq!(Some(&largest), found.last(), "{index} {load}");
                    if (j as usize + k).is_multiple_of(4) {
                        // Asked alone, nothing is tabulated: another search, the same separation.
                        let alone = at.contact(contact.scene(), &request.clone().at_loads([load]));
                        let alone = alone.unwrap().separation_at(load).unwrap().value;
                        let off = (alone - largest.value).abs();
                        // Twice the tolerance of the force, over the least slope of its logarithm.
                        assert!(off < 1e-6 * (1.0 + alone.abs()), "{load}: {alone} {largest:?}");
                        singly += usize::from(found.len() > 1);
                    }
                    several += usize::from(found.len() > 1);
                }
                Err(error) => assert!(wanted.is_empty(), "{index} {load}: {error}"),
            }
        }
    }
    assert!(several > 10 && singly > 2, "{several} {singly}");
}

#[test]
fn loads_of_many_scenes_have_the_separations_of_each_single_scene() {
    for id in ["gw", "ke", "jg", "af", "etsion", "at"] {
        let model: Model = id.parse().unwrap();
        let count = if id == "at" { 3 } else { 40 };
        let cases: Vec<Case> = (0..count)
            .map(|k| {
                let mut scene = scenes::named("mild");
                let share = (f64::from(k) * 0.618_034).fract();
                scene.interface.equivalent_modulus *= 0.5 + share;
                scene.surface.asperity_height_std *= 0.3 + 2.0 * share;
                Case::new(scene, asperity::At::Load(10f64.powf(6.0 * share - 3.0)))
            })
            .collect();
        let found = Sweep::new(&model, &[], Tolerance::default()).separations(&cases);
        for (case, found) in cases.iter().zip(found) {
            let alone = model.compile(&case.scene, &Request::new([Quantity::Force])).unwrap();
            let asperity::At::Load(load) = case.at else { panic!() };
            let wanted = alone.separation_at(load).unwrap().value;
            // Two integrals of the force, 1e-10 each, whose logarithm falls by 1 and more.
            let found = found.unwrap();
            assert!(
                (found - wanted).abs() < 3e-10 * (1.0 + wanted.abs()),
                "{id}: {found} {wanted}"
            );
        }
    }
}

#[test]
fn loads_of_unrelated_scenes_are_met_within_their_bounds() {
    let steel = asperity::Body::new(210e9, 0.3, 2e9);
    let interface = Interface::between(&steel, &steel).unwrap();
    let scene = Scene::new(interface, Surface::new(2e-4, 2e8, 1e-6), 1e-4);
    for id in ["zmc", "jg", "jg-cosine", "etsion"] {
        let model: Model = id.parse().unwrap();
        let sweep = Sweep::new(&model, &[Quantity::Force], Tolerance::default());
        let mut cases = vec![];
        for k in 0..60 {
            let mut scene = scene.clone();
            scene.interface.hardness = Some(1.5e9 + 2e7 * f64::from(k));
            cases.push(Case::new(scene, At::Load(10f64.powf(0.1 * f64::from(k) - 3.0))));
        }
        for (case, found) in cases.iter().zip(sweep.evaluate_all(&cases)) {
            let (At::Load(load), force) = (case.at, found.unwrap()[0]) else { unreachable!() };
            let error = (force.value() / load - 1.0).abs();
            assert!(error <= force.relative_error(), "{id} {load}: {error:e}");
            assert!(force.relative_error() < 1e-8, "{id} {load}: {force:?}");
        }
    }
}

#[test]
fn heavy_tails_and_single_asperities_are_not_confused_with_crossings_elsewhere() {
    use crate::heights::standardised::StandardisedHeights;
    let heavy = statrs::distribution::StudentsT::new(0.0, 1.0, 3.0).unwrap();
    let mut scene = scenes::named("mild");
    let heights = StandardisedHeights::new("t3", heavy, scene.surface.asperity_height_std);
    scene.heights = HeightDistribution::other(heights);
    let contact =
        "gw".parse::<Model>().unwrap().compile(&scene, &Request::new([Quantity::Force])).unwrap();
    let message = contact.separation_at(1e-12).unwrap_err().to_string();
    assert!(message.contains("at least 4.77") && message.contains("1000000000"), "{message}");
    for load in [1e-9, 1e-6, 1.0] {
        let d = contact.separation_at(load).unwrap();
        let force = contact.evaluate(Quantity::Force, d).unwrap().value();
        assert!((force / load - 1.0).abs() < 1e-6, "{load}: {d} {force}");
    }
}

#[test]
fn separations_of_a_random_surface_carry_the_requested_load() {
    use asperity::{Interface, ProfileMoments, Quantity, Request, Scene, Surface};
    let surface = Surface::from_moments(&ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 5e4 }).unwrap();
    let scene = Scene::new(Interface::new(115e9, 0.3, 2e9), surface, 1e-4);
    for id in ["ke-random", "jg-random", "jg-cosine-random", "etsion-random", "zmc-random"] {
        let model: asperity::Model = id.parse().unwrap();
        let contact = model.compile(&scene, &Request::new([Quantity::Force])).unwrap();
        for load in [1.0, 10.0, 1000.0] {
            let largest = contact.separation_at(load).unwrap().value;
            let all = contact.separations_at(load).unwrap();
            assert!((all.last().unwrap().value - largest).abs() < 1e-9, "{id}: {all:?} {largest}");
            for at in all {
                let force = contact.evaluate(Quantity::Force, at).unwrap().value();
                assert!((force / load - 1.0).abs() < 1e-9, "{id} {load}: {force}");
            }
        }
    }
}
