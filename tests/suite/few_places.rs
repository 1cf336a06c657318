//! A contact for a few places answers as the compiled one does.

use asperity::{
    At, ContactModel, Evaluation, HeightDistribution, Interface, Model, Quantity, Request, Scene,
    Separation, Surface,
};

use crate::scenes::{named, with_index};

const QUANTITIES: [Quantity; 7] = [
    Quantity::Force,
    Quantity::Area,
    Quantity::Stiffness,
    Quantity::Tangent,
    Quantity::Contacts,
    Quantity::MeanPressure,
    Quantity::UnloadingStiffness,
];

fn places(scene: &Scene) -> Vec<At> {
    let loads = [-1.0, 0.0, 1e-30, 1e-3, 10.0, 1e4, 1e9, f64::NAN].map(At::Load);
    let pressures = [1e6 / scene.nominal_area, 1e5].map(At::Pressure);
    let separations = [-3.0, 0.0, 2.5, 12.0, 300.0, f64::INFINITY].map(At::sigmas);
    [&loads[..], &pressures[..], &separations[..]].concat()
}

/// An error without its numbers, which another method may give.
fn words(error: &impl ToString) -> String {
    error.to_string().replace(|c: char| c.is_ascii_digit(), "")
}

/// The error is the same, or two values differ by less than their bounds.
fn agree<E: ToString>(a: &Result<Evaluation, E>, b: &Result<Evaluation, E>) -> bool {
    match (a, b) {
        (Ok(a), Ok(b)) => {
            let bound = |e: &Evaluation| e.error * e.size * e.ln_scale.exp();
            (a.value() - b.value()).abs() <= bound(a) + bound(b)
        }
        (Err(a), Err(b)) => words(a) == words(b),
        _ => false,
    }
}

#[test]
fn a_contact_for_few_places_answers_as_the_compiled_one() {
    let mut exponential = named("mild");
    exponential.heights = HeightDistribution::Exponential;
    for (scene, shown) in [
        (named("mild"), "mild"),
        (with_index(6.0), "index 6"),
        (with_index(0.3), "index 0.3"),
        (exponential, "exponential"),
    ] {
        for model in Model::of_asperities() {
            for at in places(&scene) {
                let request = Request::new(QUANTITIES).at([at]);
                let [few, many] =
                    [model.contact(&scene, &request), model.compile(&scene, &request)];
                let (few, many) = match (few, many) {
                    (Ok(few), Ok(many)) => (few, many),
                    (Err(few), Err(many)) => {
                        assert_eq!(few.to_string(), many.to_string(), "{shown} {model} {at:?}");
                        continue;
                    }
                    (few, many) => panic!("{shown} {model} {at:?}: {few:?} {many:?}"),
                };
                let name = |what: &str| format!("{shown} {model} {at:?}: {what}");
                let answers = [few.respond(&request), many.respond(&request)];
                for (k, q) in QUANTITIES.into_iter().enumerate() {
                    let [a, b] = [0, 1].map(|side: usize| &answers[side].columns[k].rows[0]);
                    assert!(agree(a, b), "{} {a:?} {b:?}", name(&q.to_string()));
                    let [a, b] = [&few, &many].map(|contact| contact.evaluate(q, at));
                    assert!(agree(&a, &b), "{} {a:?} {b:?}", name(&q.to_string()));
                }
                let [a, b] = [&few, &many].map(|contact| contact.separation(at));
                match (a, b) {
                    (Ok(a), Ok(b)) => {
                        let close = (a.value - b.value).abs() < 1e-9 * (1.0 + b.value.abs());
                        assert!(a == b || close, "{} {a:?} {b:?}", name("separation"));
                    }
                    (a, b) => assert_eq!(
                        a.map_err(|e| e.to_string()),
                        b.map_err(|e| e.to_string()),
                        "{}",
                        name("separation")
                    ),
                }
                let [a, b] = [&few, &many].map(|contact| {
                    contact.shares_at(Quantity::Force, at).map_err(|error| error.to_string())
                });
                match (a, b) {
                    (Ok(a), Ok(b)) => assert!(
                        a.iter().zip(&b).all(|(a, b)| (a.share - b.share).abs() < 1e-8),
                        "{} {a:?} {b:?}",
                        name("shares")
                    ),
                    (a, b) => assert_eq!(a, b, "{}", name("shares")),
                }
                if let At::Load(load) = at {
                    let [a, b] = [&few, &many].map(|contact| {
                        let found = contact.separations_at(load).map_err(|e| e.to_string());
                        found.map(|all| all.len())
                    });
                    assert_eq!(a, b, "{}", name("separations"));
                }
            }
        }
    }
}

/// A scene and a separation from -1e5 to 20 σ_z: multiples of irrational numbers fill [0, 1)
/// evenly, and repeat for every run.
fn drawn(k: u32) -> (Scene, f64) {
    let share = |step: f64| (f64::from(k) * step).fract();
    let log = |low: f64, high: f64, step: f64| low * (high / low).powf(share(step));
    let modulus = log(1e9, 3e11, 0.414_214);
    let hardness = modulus * log(2e-4, 3e-2, 0.732_051);
    let mut interface = Interface::new(modulus, 0.45 * share(0.236_068), hardness);
    interface.equivalent_shear_modulus = Some(modulus * log(0.05, 0.6, 0.645_751));
    interface.work_of_adhesion = Some(0.01);
    let std = log(1e-8, 1e-5, 0.162_278);
    let radius = std * log(10.0, 2000.0, 0.605_551);
    let scene = Scene::new(interface, Surface::new(radius, 0.04 / (radius * std), std), 1e-4);
    (scene, if k.is_multiple_of(3) { log(0.1, 20.0, 0.872_983) } else { -log(0.1, 1e5, 0.872_983) })
}

#[test]
fn at_any_depth_a_force_is_that_of_a_list_and_its_load_leads_back() {
    let models: Vec<Model> = Model::of_asperities().into_iter().chain(Model::adhesive()).collect();
    for (k, model) in models.iter().cycle().take(60).enumerate() {
        let (scene, s) = drawn(k as u32);
        let request = Request::new([Quantity::Force]).at([At::sigmas(s)]);
        let contacts = [model.contact(&scene, &request), model.compile(&scene, &request)];
        let [few, many] = contacts.map(Result::unwrap);
        let [a, b] = [&few, &many].map(|contact| contact.evaluate(Quantity::Force, s));
        assert!(agree(&a, &b), "{k} {model} {s}: {a:?} {b:?}");
        let Ok(force) = a else { continue };
        // At -1e5 rounding takes what is left of the tolerance.
        assert!(force.error < 1e-10 * (1.0 + 1e-5 * s.abs()), "{k} {model} {s}: {force:?}");
        if force.value() < 1e-200 {
            continue;
        }
        for contact in [&few, &many] {
            let found: Separation = contact.separation_at(force.value()).unwrap();
            let again = contact.evaluate(Quantity::Force, At::Separation(found)).unwrap();
            let error = (again.value() / force.value() - 1.0).abs();
            let allowed = 2.0 * again.relative_error() + 1e-15 * s.abs() + 1e-13;
            assert!(error < allowed, "{k} {model} {s}: back at {found:?}, {error:e} off");
        }
    }
}

/// The separation of a load is as uncertain as its force, which far below 0 is a power of it.
#[test]
fn a_load_far_below_0_has_a_bound_within_the_tolerance() {
    let mut scene = named("at-paper");
    scene.interface.equivalent_shear_modulus = Some(41e9);
    for id in ["gw", "ke", "gao", "at-additive"] {
        let request = Request::new([Quantity::Force, Quantity::Area]);
        let contact = id.parse::<Model>().unwrap().contact(&scene, &request).unwrap();
        let load = contact.evaluate(Quantity::Force, -1000.0).unwrap().value();
        for quantity in [Quantity::Force, Quantity::Area] {
            let found = contact.evaluate(quantity, At::Load(load)).unwrap();
            let alone = contact.evaluate(quantity, -1000.0).unwrap();
            let (error, bound) =
                ((found.value() / alone.value() - 1.0).abs(), found.relative_error());
            assert!(bound < 1e-10 && error <= bound, "{id} {quantity}: {error:e} of {bound:e}");
        }
    }
}
