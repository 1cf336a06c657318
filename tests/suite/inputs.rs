//! Bad inputs are refused by field, value and requirement; odd ones never panic.

use asperity::{
    AngleDensity, At, ContactError, Displacement, Interface, LateralOptions, Model, ProfileMoments,
    Quantity, Request, Scene, Surface, Tolerance,
};

use crate::scenes::{compiled, lateral, model, named, with_index};

/// A function that puts a number into a scene.
pub type Setter = fn(&mut Scene, f64);

/// Every number of a scene, by its name in errors.
pub const FIELDS: [(&str, Setter); 10] = [
    ("equivalent_modulus", |s, v| s.interface.equivalent_modulus = v),
    ("equivalent_shear_modulus", |s, v| s.interface.equivalent_shear_modulus = Some(v)),
    ("poissons_ratio", |s, v| s.interface.poissons_ratio = v),
    ("hardness", |s, v| s.interface.hardness = Some(v)),
    ("yield_strength", |s, v| s.interface.yield_strength = Some(v)),
    ("pressure_factor", |s, v| s.interface.pressure_factor = Some(v)),
    ("asperity_radius", |s, v| s.surface.asperity_radius = v),
    ("asperity_density", |s, v| s.surface.asperity_density = v),
    ("asperity_height_std", |s, v| s.surface.asperity_height_std = v),
    ("nominal_area", |s, v| s.nominal_area = v),
];

fn request() -> Request {
    Request::new([Quantity::Force, Quantity::Area]).within(Tolerance::new(1e-3).unwrap())
}

/// Asserts that the message names the field, its value and the requirement.
#[track_caller]
fn refused<T: std::fmt::Debug>(answer: Result<T, ContactError>, field: &str, value: f64) {
    match answer.unwrap_err() {
        ContactError::OutOfRange { field: named, value: found, required } => {
            assert_eq!((named, found.to_bits()), (field, value.to_bits()));
            assert!(!required.is_empty());
        }
        other => panic!("{field} {value}: {other}"),
    }
}

#[test]
fn every_bad_number_of_a_scene_is_refused_by_every_model() {
    for (field, set) in FIELDS {
        for bad in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            if field == "poissons_ratio" && bad.abs() < 0.5 {
                continue;
            }
            let mut scene = named("mild");
            set(&mut scene, bad);
            for model in Model::of_asperities() {
                refused(model.compile(&scene, &request()), field, bad);
            }
        }
    }
    let mut scene = named("mild");
    scene.interface.poissons_ratio = 0.5 + 1e-15;
    refused(scene.asperity(), "poissons_ratio", 0.5 + 1e-15);
}

#[test]
fn a_hardness_or_yield_strength_is_needed_and_either_is_enough() {
    let mut scene = named("mild");
    scene.interface.hardness = None;
    for model in Model::of_asperities() {
        match model.compile(&scene, &request()) {
            Ok(_) => assert_eq!(model.id(), "gw"),
            Err(ContactError::Missing { field, .. }) => assert_eq!(field, "hardness"),
            Err(other) => panic!("{model}: {other}"),
        }
    }
    scene.interface.yield_strength = Some(2e9 / 2.8);
    assert!((scene.asperity().unwrap().hardness().unwrap() / 2e9 - 1.0).abs() < 1e-15);
}

#[test]
fn only_the_lateral_models_miss_the_shear_modulus() {
    let mut scene = named("mild");
    scene.interface.equivalent_shear_modulus = None;
    for model in Model::of_asperities() {
        let answer = model.compile(&scene, &request());
        if model.validity().angles {
            let field = "equivalent_shear_modulus";
            assert!(
                matches!(answer, Err(ContactError::Missing { field: named, .. }) if named == field)
            );
        } else {
            assert!(answer.is_ok(), "{model}: {:?}", answer.err());
        }
    }
}

#[test]
fn an_asperity_that_never_yields_is_refused_only_where_yielding_matters() {
    let mut scene = named("mild");
    // S H/E large enough for w_c > R, and for JG's and ZMC's own limits.
    scene.interface.hardness = Some(10.0 * scene.interface.equivalent_modulus);
    for model in Model::of_asperities() {
        let answer = model.compile(&scene, &request());
        match model.id() {
            "gw" => assert!(answer.is_ok()),
            "jg" | "jg-cosine" => {
                refused(answer, "yield_strength", 10.0 * scene.interface.equivalent_modulus / 2.8);
            }
            _ => refused(answer, "hardness", 10.0 * scene.interface.equivalent_modulus),
        }
    }
}

#[test]
fn separations_and_tolerances_are_checked() {
    let scene = named("mild");
    let compiled = compiled(&model("ke"), &scene, &[Quantity::Force], 1e-6);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.1e6, 1.1e9] {
        let answer = model("gw").solve(&scene, &request().at([0.0, bad])).unwrap();
        for refused in [
            compiled.evaluate(Quantity::Force, bad).unwrap_err(),
            compiled.shares(Quantity::Force, bad).unwrap_err(),
            answer.values(Quantity::Force).unwrap_err(),
        ] {
            assert!(matches!(refused, ContactError::SeparationOutOfRange { .. }), "{refused}");
        }
    }
    for bad in [0.0, -1e-3, 0.11, 1e-16, f64::NAN, f64::INFINITY] {
        refused(Tolerance::new(bad), "tolerance", bad);
    }
    for bad in [0.0, -1.0, f64::NAN, 1e-320] {
        refused(compiled.separations_at(bad), "load", bad);
        refused(compiled.evaluate(Quantity::Force, At::Pressure(bad)), "pressure", bad);
    }
    for ok in [-1e6, -0.0, 1e9] {
        assert!(compiled.evaluate(Quantity::Force, ok).is_ok(), "{ok}");
    }
}

#[test]
fn quantities_that_were_not_requested_are_refused() {
    let scene = named("mild");
    let answer = model("ke").solve(&scene, &Request::new([Quantity::Area]).at([1.0])).unwrap();
    let error = answer.values(Quantity::Force).unwrap_err();
    assert!(error == ContactError::NotRequested { quantity: Quantity::Force });
    // The tangent comes from the force's law, but must be requested.
    let compiled = compiled(&model("ke"), &scene, &[Quantity::Tangent], 1e-6);
    assert!(compiled.evaluate(Quantity::Force, 0.0).is_err());
    assert!(compiled.shares(Quantity::Stiffness, 0.0).is_err());
    assert!(compiled.evaluate(Quantity::Tangent, 0.0).is_ok());
}

#[test]
fn moments_that_no_surface_has_are_refused() {
    let interface = named("mild").interface;
    // β = η R σ just below 0.02493, and inputs of the wrong sign.
    let beta = 1e8 * 1e-4 * 2.49e-6;
    let product = "asperity_density times asperity_radius times surface_height_std";
    refused(Surface::from_surface_std(1e-4, 1e8, 2.49e-6), product, beta);
    assert!(Surface::from_surface_std(1e-4, 1e8, 2.494e-6).is_ok());
    refused(Surface::from_surface_std(1e-4, 1e8, -1.0), "surface_height_std", -1.0);
    refused(Surface::from_plasticity_index(0.0, 0.04, 1e-6, &interface), "plasticity_index", 0.0);
    refused(
        Surface::from_plasticity_index(1.0, f64::NAN, 1e-6, &interface),
        "roughness_parameter",
        f64::NAN,
    );
    refused(
        Surface::from_plasticity_index(1.0, 0.04, -1e-6, &interface),
        "asperity_height_std",
        -1e-6,
    );
    for (field, m0, m2, m4) in
        [("m0", -1.0, 1.0, 1.0), ("m2", 1.0, -1.0, 1.0), ("m4", 1.0, 1.0, -1.0)]
    {
        refused(Surface::from_moments(&ProfileMoments { m0, m2, m4 }), field, -1.0);
    }
}

#[test]
fn options_of_the_lateral_models_are_checked() {
    let harmonic = |a20, a21, b21| LateralOptions {
        angle_density: AngleDensity::Harmonic { a20, a21, b21 },
        ..LateralOptions::default()
    };
    let given = |zeta, xi| LateralOptions {
        displacement: Displacement::Given { zeta, xi },
        ..LateralOptions::default()
    };
    for id in ["gao", "at", "at-additive", "at-overlap"] {
        let compile = |options| lateral(id, options).compile(&named("mild"), &request());
        for bad in [-1.0 - 1e-12, 2.0 + 1e-12, f64::NAN, f64::INFINITY] {
            refused(compile(harmonic(bad, 0.0, 0.0)), "a20", bad);
        }
        refused(compile(harmonic(0.0, f64::NAN, 0.0)), "a21", f64::NAN);
        refused(compile(harmonic(0.0, 0.0, f64::INFINITY)), "b21", f64::INFINITY);
        for bad in [-1e-9, f64::NAN, f64::INFINITY] {
            refused(compile(given(bad, 0.0)), "zeta", bad);
            refused(compile(given(0.0, bad)), "xi", bad);
        }
        for ok in [harmonic(-1.0, 9.0, -9.0), harmonic(2.0, 0.0, 0.0), given(0.0, 0.3)] {
            let compiled = compile(ok).unwrap();
            assert!(compiled.evaluate(Quantity::Force, 0.0).unwrap().size > 0.0);
        }
    }
}

#[test]
fn unknown_models_are_answered_with_the_nearest_name() {
    for (typed, near) in [("zcm", "zmc"), ("etsoin", "etsion"), ("at-additve", "at-additive")] {
        let message = typed.parse::<Model>().unwrap_err().to_string();
        assert!(message.contains(&format!("{typed:?}")), "{message}");
        assert!(message.contains(&format!("the nearest is {near:?}")), "{message}");
    }
    let far = "archard".parse::<Model>().unwrap_err();
    assert!(matches!(&far, ContactError::UnknownName { near: None, .. }), "{far}");
}

#[test]
fn the_printed_sum_gives_its_negative_values_with_a_warning() {
    let separations = [0.0, 1.0, 30.0, 2.0];
    let asked = request().at(separations);
    let answer = model("at").solve(&with_index(2.0), &asked).unwrap();
    let forces = answer.values(Quantity::Force).unwrap();
    let negative = forces.iter().filter(|f| **f < 0.0).count();
    let force = Some(Quantity::Force);
    let found = answer.warnings.iter().find(|w| w.code.name() == "negative" && w.quantity == force);
    let found = found.map(|w| (w.model.as_deref().unwrap(), w.count, w.at.unwrap(), w.value));
    // At d = 30 the elastic part outweighs the rest: positive, if tiny.
    assert!(negative == 3 && forces[2] >= 0.0, "{forces:?}");
    assert!(found == Some(("at", 3, At::sigmas(0.0), forces[0])), "{found:?}");
    assert_eq!(answer.warnings.len(), 1, "{:?}", answer.warnings);
    let quiet = model("ke").solve(&with_index(2.0), &asked).unwrap();
    assert!(quiet.warnings.is_empty());
}

#[test]
fn odd_numbers_cause_neither_panics_nor_nan() {
    let mut answered = 0;
    let mut odd = vec![];
    // One lateral model with signs represents all four: they share their parts.
    let models =
        Model::of_asperities().into_iter().filter(|m| !m.validity().angles || m.id() == "at");
    for model in models {
        for (field, set) in FIELDS {
            for value in
                [0.0, -0.0, f64::NAN, f64::INFINITY, 1e-320, 1e-200, 1e-30, 1e30, 1e200, 1e308]
            {
                // A test of its own: the_force_of_an_enormous_asperity_is_a_number.
                if field == "asperity_radius" && value >= 1e200 && model.id() == "gw" {
                    continue;
                }
                let mut scene = named("mild");
                set(&mut scene, value);
                let Ok(compiled) = model.compile(&scene, &request()) else { continue };
                for quantity in [Quantity::Force, Quantity::Area] {
                    for separation in [0.0, 2.5] {
                        let Ok(found) = compiled.evaluate(quantity, separation) else { continue };
                        answered += 1;
                        let numbers = [found.value(), found.size, found.error, found.scaled];
                        // A product of 1e200 and more may overflow to infinity, but is never NaN or
                        // negative infinity; products of smaller numbers are finite.
                        let overflown = |x: &f64| value >= 1e200 && *x == f64::INFINITY;
                        if !numbers.iter().all(|x| x.is_finite() || overflown(x)) {
                            odd.push(format!("{model} {field} = {value:e}: {quantity} {found:?}"));
                        }
                    }
                }
            }
        }
    }
    // Some of these scenes are odd but valid: they must have results.
    assert!(answered > 500, "{answered}");
    assert!(odd.is_empty(), "{} of {answered}:\n{}", odd.len(), odd.join("\n"));
}

#[test]
fn the_force_of_an_enormous_asperity_is_a_number() {
    let mut scene = named("mild");
    scene.surface.asperity_radius = 1e200;
    let found = compiled(&model("gw"), &scene, &[Quantity::Force], 1e-6);
    let force = found.evaluate(Quantity::Force, 0.0).unwrap().value();
    // F grows as √R.
    let small = compiled(&model("gw"), &named("mild"), &[Quantity::Force], 1e-6);
    let small = small.evaluate(Quantity::Force, 0.0).unwrap().value();
    let ratio = (1e200 / named("mild").surface.asperity_radius).sqrt();
    assert!((force / small / ratio - 1.0).abs() < 1e-5, "{force}");
}

#[test]
fn odd_moduli_of_bodies_are_refused_too() {
    let good = asperity::Body::new(210e9, 0.3, 2e9);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let body = asperity::Body::new(bad, 0.3, 2e9);
        refused(Interface::between(&good, &body), "youngs_modulus", bad);
        refused(Interface::against_rigid(&body), "youngs_modulus", bad);
    }
    let body = asperity::Body::new(2e11, -1.0, 2e9);
    refused(Interface::between(&body, &good), "poissons_ratio", -1.0);
}
