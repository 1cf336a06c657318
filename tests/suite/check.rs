//! Findings of `check`: mistakes are reported, unusual scenes are not.

use asperity::{
    At, Body, Check, Code, Finding, HeightDistribution, Interface, Plausible, Scene, Severity,
    Surface,
};

use crate::inputs::FIELDS;
use crate::scenes::{model, named};

type Change = (&'static str, fn(&mut Scene, f64));

/// Every input of a scene, with a function that multiplies it.
const INPUTS: [Change; 9] = [
    ("equivalent_modulus", |s, f| s.interface.equivalent_modulus *= f),
    ("equivalent_shear_modulus", |s, f| {
        s.interface.equivalent_shear_modulus = s.interface.equivalent_shear_modulus.map(|g| g * f);
    }),
    ("hardness", |s, f| s.interface.hardness = s.interface.hardness.map(|h| h * f)),
    ("yield_strength", |s, f| {
        let from_hardness = s.interface.hardness.map(|h| h / 2.8);
        s.interface.yield_strength = s.interface.yield_strength.or(from_hardness).map(|y| y * f);
    }),
    ("pressure_factor", |s, f| s.interface.pressure_factor = Some(0.577 * f)),
    ("asperity_radius", |s, f| s.surface.asperity_radius *= f),
    ("asperity_density", |s, f| s.surface.asperity_density *= f),
    ("asperity_height_std", |s, f| s.surface.asperity_height_std *= f),
    ("nominal_area", |s, f| s.nominal_area *= f),
];

/// Scenes without findings: machined metals as in the papers and the examples.
fn machined() -> Vec<(&'static str, Scene)> {
    let steel = Body::new(210e9, 0.3, 2e9);
    let aluminium = Body::yielding(69e9, 0.33, 275e6);
    let between = |a: &Body, b: &Body| Interface::between(a, b).unwrap();
    let rail = between(&Body::new(210e9, 0.3, 2.75e9), &Body::new(210e9, 0.3, 2.45e9));
    vec![
        ("template", Scene::new(between(&steel, &steel), Surface::new(2e-4, 2e8, 1e-6), 1e-4)),
        ("bolt", Scene::new(between(&aluminium, &steel), Surface::new(6e-5, 3e8, 2e-6), 6.1e-4)),
        ("rail", Scene::new(rail, Surface::new(3e-5, 1.53e9, 9e-7), 1.2e-4)),
        ("paper", named("at-paper")),
    ]
}

/// Unusual but correct scenes.
fn unusual() -> Vec<(&'static str, Scene)> {
    let scene = |interface, radius, density, std, area| {
        Scene::new(interface, Surface::new(radius, density, std), area)
    };
    let rigid = |body: &Body| Interface::against_rigid(body).unwrap();
    let rubber = rigid(&Body::elastic(2e6, 0.5));
    let filled = Interface::elastic(1.2e7, 0.49);
    // As in files that must name a hardness.
    let with_hardness = Interface::new(2.7e6, 0.5, 2e6);
    let silicon = Body::new(165e9, 0.22, 12e9);
    let polysilicon = Interface::between(&silicon, &silicon).unwrap();
    let gold = Interface::against_rigid(&Body::new(78e9, 0.42, 1e9)).unwrap();
    let steel = Interface::between(&Body::new(210e9, 0.3, 2e9), &Body::new(210e9, 0.3, 2e9));
    let steel = steel.unwrap();
    let plastic = rigid(&Body::new(0.8e9, 0.46, 5e7));
    let indium = rigid(&Body::new(11e9, 0.45, 9e6));
    let diamond = Interface::new(570e9, 0.07, 90e9);
    let ceramic = rigid(&Body::new(310e9, 0.22, 22e9));
    vec![
        ("silicone on ground glass", scene(rubber, 1e-4, 4e8, 1e-6, 1e-4)),
        ("tyre on asphalt's texture", scene(filled, 2e-3, 2e5, 1.5e-4, 1e-2)),
        ("rubber on coarse asphalt", scene(filled, 2e-3, 1e5, 3e-4, 1e-2)),
        ("a scan of Sq 0.46 mm", scene(filled, 5e-3, 2e4, 4.6e-4, 2e-2)),
        ("rubber with a hardness", scene(with_hardness, 1e-4, 4e8, 1e-6, 1e-4)),
        ("polysilicon micro-machine", scene(polysilicon, 5e-7, 1e13, 1e-8, 1e-8)),
        ("gold microswitch", scene(gold, 1e-7, 1e14, 5e-9, 2.5e-11)),
        ("blasted steel", scene(steel, 4e-5, 3e7, 3e-5, 1e-3)),
        ("lapped gauge blocks", scene(steel, 5e-5, 8e10, 1e-8, 3e-4)),
        ("flange", scene(steel, 5e-5, 3e8, 3e-6, 2.5e-2)),
        ("polyethylene cup", scene(plastic, 5e-5, 1e9, 1e-6, 4e-4)),
        ("indium seal", scene(indium, 5e-5, 1e9, 1e-6, 1e-4)),
        ("diamond coating", scene(diamond, 1e-6, 1e12, 5e-8, 1e-6)),
        ("alumina", scene(ceramic, 5e-6, 1e10, 5e-7, 1e-4)),
    ]
}

fn messages(findings: &[Finding]) -> Vec<String> {
    findings.iter().map(|f| format!("{}: {f}", f.severity)).collect()
}

#[test]
fn factors_of_a_thousand_a_million_and_a_billion_are_reported() {
    let mut missed = vec![];
    let mut count = 0;
    for (name, right) in machined() {
        for (input, multiply) in INPUTS {
            for factor in [1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9] {
                let mut scene = right.clone();
                multiply(&mut scene, factor);
                if right.interface.hardness.is_none() && input == "hardness" {
                    continue;
                }
                count += 1;
                let found = scene.findings();
                // A thousand times the area of a small joint makes a large one: a note.
                let enough = match (input, factor) {
                    // A thousandth of it still holds some hundred asperities.
                    ("nominal_area", 1e3 | 1e-3) => Severity::Note,
                    _ => Severity::Warning,
                };
                if !found.iter().any(|finding| finding.severity <= enough) {
                    missed.push(format!("{name}: {input} * {factor:e}: {:?}", messages(&found)));
                }
            }
        }
    }
    assert!(count > 180, "{count}");
    assert!(missed.is_empty(), "{} of {count}:\n{}", missed.len(), missed.join("\n"));
}

#[test]
fn good_scenes_have_no_findings() {
    for (name, scene) in machined().into_iter().chain(unusual()) {
        let found = scene.findings();
        // Indium, and gold in small asperities, yield at interferences below the size of an atom.
        let atomic =
            ["gold microswitch", "indium seal"].contains(&name) && found[0].code.name() == "atomic";
        assert!(found.is_empty() || atomic && found.len() == 1, "{name}: {:?}", messages(&found));
        Check::of(&scene).unwrap();
    }
    for name in ["at-paper", "mild", "severe"] {
        assert!(named(name).findings().is_empty(), "{name}");
    }
}

/// Observed mistakes of users: the inputs, their numbers, and parts of the messages.
#[test]
fn mistakes_of_users_are_reported_with_the_unit() {
    for line in include_str!("mistakes.csv").lines().skip(1) {
        let (name, words) = line.split_once("; ").unwrap();
        let mut scene = machined().swap_remove(0).1;
        for input in name.split(", ") {
            let (field, number) = input.split_once(' ').unwrap();
            match FIELDS.iter().find(|(known, _)| *known == field) {
                Some((_, set)) => set(&mut scene, number.parse().unwrap()),
                None => scene.interface.equivalent_shear_modulus = None,
            }
        }
        let found = messages(&scene.findings());
        let all = found.join("\n");
        assert!(words.split(", ").all(|word| all.contains(word)), "{name}: {found:#?}");
        assert!(found.len() <= 3, "{name}: {found:#?}");
        assert!(scene.findings().are_implausible(), "{name}: {found:#?}");
    }
}

#[test]
fn derived_numbers_equal_their_formulas() {
    let scene = named("at-paper");
    let check = Check::of(&scene).unwrap();
    let number = |name| check.number(name).unwrap();
    let surface = scene.surface;
    let beta = surface.asperity_density * surface.asperity_radius * surface.asperity_height_std;
    for (name, value) in [
        ("plasticity_index", scene.plasticity_index().unwrap()),
        ("roughness_parameter", beta),
        ("asperities", scene.nominal_area * surface.asperity_density),
        ("hardness_over_modulus", 1.12e9 / 116e9),
    ] {
        assert!((number(name) / value - 1.0).abs() < 1e-12, "{name}");
    }
    // From moments and back.
    let other = Surface::from_moments(&surface.moments()).unwrap();
    assert!((other.asperity_height_std / surface.asperity_height_std - 1.0).abs() < 1e-12);
    assert!((number("rms_gradient").powi(2) / (2.0 * surface.moments().m2) - 1.0).abs() < 1e-12);
}

#[test]
fn findings_at_a_load_report_depth_and_crowding() {
    let scene = named("at-paper");
    let codes = |check: &Check| check.findings.iter().map(|f| f.code.name()).collect::<Vec<_>>();
    let at = |id: &str, at: At| Check::at(&model(id), &scene, at).unwrap();
    // psi = 6: yielding asperities carry nearly all of the load, which GW ignores.
    let gw = at("gw", At::from(2.0));
    assert_eq!(codes(&gw), ["yields"]);
    let advised = gw.findings[0].worded("", |advice| format!("[{advice}]"));
    assert!(advised.ends_with("[use ke or jg]"), "{advised}");
    assert!(gw.number("yielding_share").unwrap() > 0.9);
    assert!(at("ke", At::from(2.5)).findings.is_empty());
    assert_eq!(codes(&at("ke", At::from(-1.0)))[0], "crowded");
    let light = at("ke", At::Load(0.01));
    assert_eq!(codes(&light), ["few-contacts"]);
    assert!(light.number("contacts").unwrap() < 30.0);
    // The message contains the requested load.
    assert!((light.number("load").unwrap() / 0.01 - 1.0).abs() < 1e-5);
    // With many places, the closest and the lightest are checked, and findings are reported once.
    let places = [At::Load(0.01), At::Load(1.0), At::Load(30.0)];
    let found = Check::answers(&model("gw"), &scene, None, &places);
    let found: Vec<_> = found.iter().map(|f| f.code.name()).collect();
    assert_eq!(found, ["yields", "few-contacts"]);
    // Units count: -1 σ_z is closer than 4e-6 m, though a smaller number.
    let places = [At::from(-1.0), At::metres(4e-6)];
    let found = Check::answers(&model("ke"), &scene, None, &places);
    assert_eq!(found.first().map(|f| f.code), Some(Code::Crowded));
}

#[test]
fn depths_follow_from_the_law() {
    // Exponential heights, GW: the force per depth is w^1.5 exp(-w/sigma) at every separation; the
    // share beyond w is the upper incomplete gamma function of 2.5, Q(2.5, 2) = 0.5494.
    let mut scene = named("at-paper");
    scene.heights = asperity::HeightDistribution::Exponential;
    let critical = scene.asperity().unwrap().critical_interference().unwrap();
    scene.surface.asperity_height_std = 0.5 * critical;
    let check = Check::at(&model("gw"), &scene, At::from(2.0)).unwrap();
    let share = check.number("yielding_share").unwrap();
    assert!((share - 0.549_416).abs() < 5e-3, "{share}");
    // Q(2.5, 7.543) = 0.01.
    let deep = check.number("interference").unwrap() / scene.surface.asperity_height_std;
    assert!((deep / 7.543 - 1.0).abs() < 0.02, "{deep}");
}

#[test]
fn one_range_of_beta_z_is_usual_everywhere() {
    let [least, most] = Surface::USUAL_ASPERITY_ROUGHNESS;
    let beta = |beta: f64| {
        let mut scene = machined().swap_remove(0).1;
        scene.surface.asperity_density = beta / (2e-4 * 1e-6);
        let found = scene.findings();
        found.iter().map(|f| (f.field.to_string(), f.severity, f.usual)).collect::<Vec<_>>()
    };
    assert!(beta(1.01 * least).is_empty() && beta(0.99 * most).is_empty());
    for value in [0.9 * least, 1.1 * most] {
        let field = "roughness_parameter".to_string();
        assert_eq!(beta(value), [(field, Severity::Note, [least, most])], "{value}");
    }
}

#[test]
fn separations_on_exponential_heights_are_from_the_lowest_asperity() {
    let mut scene = named("at-paper");
    for (heights, plane) in [
        (HeightDistribution::Exponential, "the lowest asperity"),
        (HeightDistribution::Gaussian, "the mean of the asperity heights"),
    ] {
        scene.heights = heights;
        let check = Check::at(&model("ke"), &scene, At::Load(1.0)).unwrap();
        let of = check.numbers.iter().find(|number| number.name == "separation").unwrap();
        assert!(of.meaning.ends_with(plane), "{}", of.meaning);
    }
}

#[test]
fn a_work_of_adhesion_in_another_unit_is_named_and_tabors_parameter_is_derived() {
    // E = 1e9 Pa, R = 1e-4 m, σ_z = 1e-7 m.
    let check = |work: f64| {
        let mut interface = Interface::elastic(1e9, 0.3);
        interface.work_of_adhesion = Some(work);
        Check::of(&Scene::new(interface, Surface::new(1e-4, 1e9, 1e-7), 1e-5)).unwrap()
    };
    let of_work = |check: &Check| -> Vec<Finding> {
        check.findings.iter().filter(|f| f.field == "work_of_adhesion").cloned().collect()
    };
    let found = of_work(&check(50.0));
    let [finding] = &found[..] else { panic!("{found:?}") };
    assert_eq!((finding.code, finding.severity), (Code::UnusualSize, Severity::Warning));
    let unit = finding.likely_unit.as_deref();
    assert_eq!(unit, Some("50 looks like mJ/m2; 50 mJ/m2 is 0.05 J/m2"));
    let usual = check(0.05);
    assert!(of_work(&usual).is_empty(), "{:?}", usual.findings);
    // (1e-4 · 0.0025/(1e18 · 2.7e-29))^(1/3), and 1e9 · 1e-10.5/(0.05 · 0.01).
    let number = |name| usual.number(name).unwrap();
    assert!((number("tabor_parameter") / 9_259.259_259_259_26f64.cbrt() - 1.0).abs() < 1e-12);
    assert!((number("adhesion_parameter") / 63.245_553_203_367_6 - 1.0).abs() < 1e-12);
    let none = check(0.0);
    assert_eq!(
        (none.number("tabor_parameter"), none.number("adhesion_parameter")),
        (Some(0.0), None)
    );
}

#[test]
fn a_known_defect_is_found_where_it_matters() {
    // ψ = 2: w about 4 w_c. ψ = 0.5: all elastic. ψ = 12: w about 100 w_c.
    for (index, expected) in [(2.0, true), (0.5, false), (12.0, false)] {
        let interface = Interface::new(116e9, 0.31, 1.12e9);
        let surface = Surface::from_plasticity_index(index, 0.04, 1e-6, &interface).unwrap();
        let scene = Scene::new(interface, surface, 3e-5);
        let check = Check::at(&model("etsion"), &scene, At::Pressure(2e6)).unwrap();
        let found = check.findings.iter().find(|finding| finding.code.name() == "fit-misses");
        let severity = found.map(|found| found.severity);
        assert_eq!(severity, expected.then_some(Severity::Warning), "{index}: {found:?}");
    }
}
