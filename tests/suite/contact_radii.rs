//! Sums of contact radii against `reference/engineering.csv`, and the quantities derived from them
//! against sums over asperities without the engine.

use std::f64::consts::PI;

use asperity::{ContactError, HeightDistribution, Model, Quantity, Request, Tolerance};

use crate::scenes;

const FOLLOW: [Quantity; 6] = [
    Quantity::UnloadingStiffness,
    Quantity::TangentialStiffness,
    Quantity::ThermalConductance,
    Quantity::ElectricalConductance,
    Quantity::ThermalConductancePerArea,
    Quantity::ElectricalConductancePerArea,
];

fn scene(case: &str) -> asperity::Scene {
    let mut scene = scenes::named(case);
    scene.interface.thermal_conductivity = Some(50.0);
    scene.interface.electrical_resistivity = Some(1.7e-7);
    scene
}

#[test]
fn every_sum_and_number_of_the_reference_is_met_within_the_bound() {
    let rows = include_str!("../reference/engineering.csv").lines().skip(1);
    let mut count = 0;
    for line in rows.filter(|line| line.contains(",,,")) {
        let fields: Vec<&str> = line.split(',').collect();
        let [case, id, separation, _, _, quantity, value] = fields[..] else { panic!("{line}") };
        let (separation, value): (f64, f64) = (separation.parse().unwrap(), value.parse().unwrap());
        let quantity: Quantity = quantity.parse().unwrap();
        let model = scenes::model(id);
        // Compiled, and by a request of one row, which takes another path.
        let compiled = scenes::compiled(&model, &scene(case), &[quantity], 1e-12);
        let request = Request::new([quantity]).within(Tolerance::new(1e-12).unwrap());
        let few = model.solve(&scene(case), &request.at([separation])).unwrap();
        let found = compiled.evaluate(quantity, separation).unwrap();
        let few = few.values(quantity).unwrap()[0];
        for found in [found.value(), few] {
            let error = (found / value - 1.0).abs();
            assert!(error < 3e-12, "{line}: {error:.1e}");
        }
        assert!(found.relative_error() < 3e-12, "{line}");
        count += 1;
    }
    assert_eq!(count, 84);
}

/// Σ √(A/π) over a fine grid of exponential heights, straight from the law of the area.
#[test]
fn quantities_derived_from_radii_are_sums_over_asperities() {
    let mut scene = scene("severe");
    scene.heights = HeightDistribution::Exponential;
    let (asperity, tolerance) = (scene.asperity().unwrap(), Tolerance::new(1e-12).unwrap());
    let sigma = scene.surface.asperity_height_std;
    for model in scenes::upright() {
        let area = model.law(&asperity, Quantity::Area, tolerance).unwrap();
        let unit = area.interference_unit;
        // Between kinks, with w = low + (high - low) v², so that the root at 0 is smooth; Simpson.
        let mut ends = vec![0.0];
        ends.extend(area.kinks().iter().map(|kink| kink * unit).filter(|w| *w < 45.0 * sigma));
        ends.push(45.0 * sigma);
        let mut sum = 0.0;
        for pair in ends.windows(2) {
            const STEPS: i32 = 40_000;
            let (low, length) = (pair[0], pair[1] - pair[0]);
            for k in 0..=STEPS {
                let v = f64::from(k) / f64::from(STEPS);
                let weight = if k == 0 || k == STEPS { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                // Just inside: at a jump the formula of this side applies.
                let w = low + length * (v * v).clamp(1e-15, 1.0 - 1e-15);
                let radius = (area.value(w).unwrap() / PI).sqrt();
                let share = weight / f64::from(3 * STEPS) * 2.0 * v * length;
                sum += share * radius * (-w / sigma).exp() / sigma;
            }
        }
        let sum = scene.asperities() * (-1.0_f64).exp() * sum;
        let asked: Vec<Quantity> = FOLLOW.into_iter().chain([Quantity::ContactRadiusSum]).collect();
        let contact = scenes::compiled(&model, &scene, &asked, 1e-12);
        let interface = scene.interface;
        let (e, g) = (interface.equivalent_modulus, interface.equivalent_shear_modulus.unwrap());
        let (k, rho, nominal) = (2.0 * 50.0, 2.0 / 1.7e-7, scene.nominal_area);
        let factors = [2.0 * e, 8.0 * g, k, rho, k / nominal, rho / nominal, 1.0];
        for (quantity, factor) in asked.into_iter().zip(factors) {
            let found = scenes::value(&contact, quantity, 1.0);
            let error = (found / (factor * sum) - 1.0).abs();
            assert!(error < 1e-9, "{} {quantity}: {error:.1e}", model.id());
        }
    }
}

#[test]
fn elastic_asperities_unload_with_the_tangent() {
    let asked = [Quantity::Tangent, Quantity::UnloadingStiffness];
    for (id, same) in [("gw", true), ("ke", false)] {
        let contact = scenes::compiled(&scenes::model(id), &scene("severe"), &asked, 1e-12);
        let [tangent, unloading] = asked.map(|q| scenes::value(&contact, q, 1.0));
        assert_eq!((unloading / tangent - 1.0).abs() < 1e-11, same, "{id}: {unloading} {tangent}");
        assert!(unloading > tangent * (1.0 - 1e-11));
    }
}

#[test]
fn inclined_contacts_and_missing_inputs_are_refused_by_name() {
    let lateral = Model::of_asperities().into_iter().filter(|model| model.validity().angles);
    for model in lateral {
        for quantity in FOLLOW {
            let asked = Request::new([quantity]).at([1.0]);
            let refused = model.solve(&scene("mild"), &asked).unwrap_err();
            assert!(matches!(refused, ContactError::Unsupported { .. }), "{refused}");
            let message = refused.to_string();
            let begins = format!("{} cannot give contact radii: ", model.id());
            assert!(message.starts_with(&begins) && message.contains("inclined"), "{message}");
        }
    }
    let fields = [
        None,
        Some("equivalent_shear_modulus"),
        Some("thermal_conductivity"),
        Some("electrical_resistivity"),
        Some("thermal_conductivity"),
        Some("electrical_resistivity"),
    ];
    let mut bare = scenes::named("mild");
    bare.interface.equivalent_shear_modulus = None;
    for (quantity, field) in FOLLOW.into_iter().zip(fields) {
        let asked = Request::new([quantity]).at([1.0]);
        let answer = scenes::model("ke").solve(&bare, &asked);
        let error = answer.err().map(|error| error.to_string());
        let begins = field.map(|field| format!("{field} is missing: {quantity}"));
        match (&error, &begins) {
            (Some(error), Some(begins)) => assert!(error.starts_with(begins), "{error}"),
            _ => assert!(error.is_none() && begins.is_none(), "{error:?}"),
        }
    }
}
