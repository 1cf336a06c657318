//! Recommendations of models, with their evidence.

use asperity::{
    At, Code, Compared, ContactError, Described, Interface, Model, Quantity, Recommendation,
    Request, Scene, Surface, linspace, recommend, recommend_among,
};

fn advice(plasticity_index: f64, within: f64) -> Recommendation {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(plasticity_index, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let request = Request::new([Quantity::Force, Quantity::Area]).at(linspace(0.0, 3.0, 7));
    recommend(&scene, &request, &"ke".parse().unwrap(), within).unwrap()
}

/// What is said about models: the summary, then a line for each that was compared.
fn said(advice: &Recommendation) -> String {
    [advice.summary(), advice.expectations()].concat().join("\n") + "\n"
}

#[test]
fn the_simplest_model_that_is_near_enough_is_named() {
    let simplest = |advice: &Recommendation| advice.simplest.as_ref().unwrap().id().to_string();
    assert_eq!(simplest(&advice(0.3, 0.05)), "gw");
    assert_eq!(simplest(&advice(6.0, 1e-6)), "ke");
    // At psi = 6 two-part laws are off by more than 1 %, three-part ones by more than 5 %.
    let rough = advice(6.0, 0.05);
    assert!(!["gw", "ceb", "af"].contains(&&*simplest(&rough)), "{rough}");
}

#[test]
fn the_error_of_a_model_stands_beside_it() {
    let rough = advice(6.0, 0.05);
    let ke = rough.comparisons.iter().find(|c| c.model.id() == "ke").unwrap();
    assert!(ke.off(Compared::Area).is_some_and(|[off, _]| off.abs() < 1.0), "{ke:?}");
    assert!(ke.off(Compared::Stiffness).is_some(), "{ke:?}");
}

#[test]
fn no_model_is_the_simplest_where_it_does_not_hold() {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(0.8, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let request = Request::new([Quantity::Force]).at([0.0]);
    // Yielding asperities carry a third of the load, and the deviation is only a few per cent.
    let ask = |reference: &str, models: &[&str]| {
        let models = models.iter().map(|id| id.parse::<Model>().unwrap()).collect();
        recommend_among(models, &scene, None, &request, &reference.parse().unwrap(), 0.3).unwrap()
    };
    let advice = ask("ke", &["gw", "ke", "zmc"]);
    let gw = &advice.comparisons[0];
    assert!(gw.model.id() == "gw" && gw.largest() < 0.3, "{advice}");
    assert_eq!(gw.outside.as_ref().map(|finding| finding.code), Some(Code::Yields));
    assert_eq!(advice.simplest.as_ref().map(|m| m.id()), Some("zmc"), "{advice}");
    let valid = ask("ke", &["gw", "zmc"]);
    assert_eq!(ask("ke", &["gw"]).simplest.map(|m| m.id().to_string()).as_deref(), Some("ke"));
    let none = ask("gw", &["gw"]);
    assert!(none.simplest.is_none());
    let first = [valid, none].map(|one| one.to_string().lines().next().map(str::to_owned));
    insta::assert_snapshot!(first.map(Option::unwrap).join("\n"));
}

#[test]
fn each_load_has_its_own_evidence_and_the_models_named_were_compared() {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let unit = 116e9 * surface.rms_gradient();
    let pressures = [1e-14, 2e-14, 1e-2, 1.05e-2, 5e-2].map(|p| At::Pressure(p * unit));
    let asked = [Quantity::Force, Quantity::Area, Quantity::Tangent];
    let request = Request::new(asked).at(pressures);
    let ke: Model = "ke".parse().unwrap();
    let models = vec![ke.clone(), "jg".parse().unwrap()];
    let advice = recommend_among(models, &scene, None, &request, &ke, 0.1).unwrap();
    let there: Vec<bool> = advice.evidence.iter().map(|place| place.expected.is_ok()).collect();
    assert_eq!(there, [false, false, true, true, true]);
    assert_eq!(advice.summary().len(), 3, "{advice}");
    // One line for a model.
    let lines = advice.expectations();
    assert!(lines.len() <= 2 && lines.iter().all(|line| line.matches("the area").count() == 1));
    assert!(advice.comparisons.iter().all(|comparison| !comparison.off.is_empty()));
    insta::assert_snapshot!(said(&advice));
}

#[test]
fn sentences_are_about_the_quantities_asked_for() {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let text = |asked: Quantity| {
        let request = Request::new([asked]).at([At::Pressure(1e8)]);
        let advice = recommend(&scene, &request, &"ke".parse().unwrap(), 0.05).unwrap();
        [advice.summary(), advice.expectations()].concat().join("\n")
    };
    let named = |text: &str| {
        ["the area", "of first loading", "unloading stiffness", "the mean gap"]
            .map(|quantity| text.contains(quantity))
    };
    let area = text(Quantity::Area);
    assert_eq!(named(&area), [true, false, false, false], "{area}");
    assert!(area.contains("in area") && !area.contains("in stiffness"), "{area}");
    let tangent = text(Quantity::Tangent);
    assert_eq!(named(&tangent), [false, true, false, false], "{tangent}");
    assert!(tangent.contains("in stiffness") && !tangent.contains("in area"), "{tangent}");
    assert_eq!(named(&text(Quantity::UnloadingStiffness)), [false, false, true, false]);
    assert_eq!(named(&text(Quantity::Force)), [false, false, false, true]);
    // Contacts are not compared: all notes are shown.
    assert_eq!(named(&text(Quantity::Contacts)), [true; 4]);
}

#[test]
fn what_the_solved_surfaces_do_not_determine_is_named_alone() {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(2.0, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let ke: Model = "ke".parse().unwrap();
    let ask = |asked: Quantity, shares: &[f64]| {
        let places = shares.iter().map(|share| At::Pressure(share * 1.12e9));
        recommend(&scene, &Request::new([asked]).at(places), &ke, 0.05).unwrap()
    };
    let heavy = ask(Quantity::Tangent, &[0.39]);
    assert!(heavy.expectations().is_empty(), "{heavy}");
    // Others are ranked where they have a value.
    let some = ask(Quantity::Tangent, &[0.1, 0.12, 0.39, 0.4]);
    let unloading = ask(Quantity::UnloadingStiffness, &[0.1]);
    let ke = unloading.comparisons.iter().find(|c| c.model.id() == "ke").unwrap();
    let found = unloading.evidence[0].ratio("ke", Compared::UnloadingStiffness).unwrap();
    let [off, _] = ke.off(Compared::UnloadingStiffness).unwrap();
    assert!((off - (found.ratio - 1.0)).abs() < 1e-15);
    let heavier = ask(Quantity::UnloadingStiffness, &[0.39]);
    insta::assert_snapshot!([heavy, some, unloading, heavier].map(|one| said(&one)).join("\n"));
}

#[test]
fn a_surface_unlike_the_solved_ones_has_no_evidence() {
    let known = advice(2.0, 0.05);
    assert!(known.evidence.iter().any(|place| place.expected.is_ok()), "{known}");
    let without = known.clone().without_evidence(&ContactError::NoEvidence {
        property: "kurtosis",
        reason: "a kurtosis of 175".into(),
    });
    let [reason] = &without.summary()[..] else { panic!("{without}") };
    assert!(reason.ends_with("a kurtosis of 175"), "{reason}");
    assert!(without.comparisons.iter().all(|found| found.off.is_empty()));
    let ids = |all: &Recommendation| all.simplest.as_ref().map(|m| m.id().to_string());
    assert_eq!(ids(&without), ids(&known));
}

#[test]
fn scenes_outside_the_solved_range_have_no_evidence() {
    let interface = Interface::new(116e9, 0.31, 1.12e9);
    let surface = Surface::from_plasticity_index(30.0, 0.04, 1e-6, &interface).unwrap();
    let scene = Scene::new(interface, surface, 3e-5);
    let request = Request::new([Quantity::Area]).at_loads([100.0]);
    let advice = recommend(&scene, &request, &"ke".parse().unwrap(), 0.1).unwrap();
    assert!(advice.comparisons.iter().all(|comparison| comparison.off.is_empty()));
    let at = |request: &Request| recommend(&scene, request, &"ke".parse().unwrap(), 0.1).unwrap();
    let force = || Request::new([Quantity::Force]);
    let each = [force().at([2.0, 30.0]), force().at([30.0]), force().at_loads([1e-9])];
    let each = each.map(|request| said(&at(&request)));
    insta::assert_snapshot!(said(&advice) + "\n" + &each.join("\n"));
    let refused = recommend(&scene, &request, &"ke".parse().unwrap(), 5.0).unwrap_err();
    assert!(matches!(refused, ContactError::OutOfRange { field: "within", .. }), "{refused}");
}
