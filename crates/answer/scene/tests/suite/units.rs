//! Numbers with units, and synonyms of keys.

use asperity::{Findings, Severity};

use crate::scene_files::{INTERFACE, SURFACE, read, text};

#[test]
fn numbers_may_have_a_unit() {
    let plain = read(&text("", INTERFACE, SURFACE)).unwrap().scene;
    let with_units = text("", INTERFACE, SURFACE)
        .replace("116e9", "\"116 GPa\"")
        .replace("1.12e9", "\"1120 MPa\"")
        .replace("3.59e-4", "\"0.359 mm\"")
        .replace("1.11e8", "\"\"\"111\n 1/mm2\"\"\"")
        .replace("1e-6", "\"1 \u{b5}m\"")
        .replace("3e-5", "\"30 mm^2\"");
    let found = read(&with_units).unwrap().scene;
    assert_eq!((found.interface, found.surface), (plain.interface, plain.surface));
    assert!((found.nominal_area - plain.nominal_area).abs() < 1e-20);
    // Line numbers stay the same after a text of two lines.
    let odd = read(&with_units.replace("\"1 \u{b5}m\"", "-1")).unwrap_err();
    assert_eq!(odd.place().unwrap().line, Some(13));
}

#[test]
fn a_finding_about_a_body_hides_no_other() {
    let steel = "youngs_modulus = 210e9\npoissons_ratio = 0.3\nhardness = 2e9\n";
    let bodies =
        |more: &str| format!("[[body]]\n{steel}{more}[[body]]\n{steel}thermal_conductivity = 50\n");
    let fields = |top: &str, more: &str| {
        let text = text("", &bodies(more), SURFACE).replace("nominal_area = 3e-5", top);
        let file = read(&text).unwrap();
        let of = |found: &[asperity::Finding]| -> Vec<String> {
            found.iter().map(|found| found.field.to_string()).collect()
        };
        let fields = of(&file.findings());
        assert_eq!(of(&file.check(None).unwrap().findings), fields);
        fields
    };
    let found = fields("nominal_area = 100\nwork_of_adhesion = 50", "thermal_conductivity = 5e4\n");
    for field in ["body[1].thermal_conductivity", "nominal_area", "work_of_adhesion"] {
        assert!(found.iter().any(|name| name == field), "{field}: {found:?}");
    }
    // One mistake is text once.
    assert!(!found.iter().any(|field| field == "thermal_conductivity"), "{found:?}");
    let stiff = steel.replace("210e9", "210");
    let text = text("", &bodies(""), SURFACE).replacen(steel, &stiff, 1);
    let found = read(&text).unwrap().findings();
    let fields: Vec<&str> = found.iter().map(|found| &*found.field).collect();
    assert_eq!(fields, ["body[1].youngs_modulus"]);
}

#[test]
fn two_bodies_of_one_material_have_one_finding() {
    let bodies = |second: &str| {
        let text =
            asperity_scene::template().replace("youngs_modulus = 210e9", "youngs_modulus = 210");
        let (first, rest) = text.rsplit_once("youngs_modulus = 210").unwrap();
        let text = format!("{first}youngs_modulus = {second}{rest}");
        let file = asperity_scene::parse(&text, std::path::Path::new(".")).unwrap();
        let found = file.findings();
        found.iter().filter(|one| one.field.ends_with(".youngs_modulus")).count()
    };
    assert_eq!([bodies("210"), bodies("209")], [1, 2]);
}

#[test]
fn accepted_codes_are_silent() {
    let body = |modulus: &str| {
        let steel = format!("youngs_modulus = {modulus}\npoissons_ratio = 0.3\nhardness = 2e9\n");
        format!("rigid_counterface = true\n[[body]]\n{steel}thermal_conductivity = 5e4\n")
    };
    let found = |top: &str, modulus: &str| {
        let file = read(&text(top, &body(modulus), SURFACE)).unwrap();
        let fields = |found: asperity::Findings| -> Vec<String> {
            found.iter().map(|found| found.field.to_string()).collect()
        };
        (fields(file.findings()), fields(file.check(None).unwrap().findings))
    };
    let conductivity = || vec!["body[1].thermal_conductivity".to_string()];
    assert_eq!(found("", "210e9"), (conductivity(), conductivity()));
    let accept = "accept = [\"unusual-size\"]\n";
    assert_eq!(found(accept, "210e9"), (vec![], vec![]));
    assert_eq!(found(accept, "210"), (vec![], vec![]));
}

/// The findings of a scene with two bodies of steel.
fn findings(body: &str, area: &str, surface: &str) -> Findings {
    let steel = "poissons_ratio = 0.3\nyield_strength = \"400 MPa\"\n";
    let second = format!("[[body]]\nyoungs_modulus = \"210 GPa\"\n{steel}");
    let scene =
        format!("nominal_area = {area}\n[[body]]\n{body}\n{steel}{second}[surface]\n{surface}\n");
    read(&scene).unwrap().findings()
}

const STEEL: &str = "youngs_modulus = \"210 GPa\"";
const GROUND: &str = "asperity_radius = \"50 um\"
asperity_density = \"2000 1/mm2\"
asperity_height_std = \"1 um\"";

#[test]
fn a_unit_that_was_given_is_never_reinterpreted() {
    assert!(findings(STEEL, "1e-4", GROUND).is_empty());
    for (body, surface) in
        [("youngs_modulus = \"210 kPa\"", GROUND), (STEEL, &*GROUND.replace("50 um", "50 m"))]
    {
        let odd = findings(body, "1e-4", surface);
        assert!(!odd.is_empty() && odd.iter().all(|one| one.likely_unit.is_none()), "{odd:?}");
    }
    // Guideways are that large.
    for area in ["\"0.05 m2\"", "\"2500 cm2\""] {
        assert!(findings(STEEL, area, GROUND).is_empty(), "{area}");
    }
    // Annealed copper.
    let copper = asperity::Body::new(120e9, 0.34, 400e6);
    assert!(asperity::Plausible::findings(&copper).is_empty());
}

#[test]
fn an_area_without_its_unit_is_a_warning_and_one_with_it_none() {
    let warned = |area: &str| {
        let found = findings(STEEL, area, GROUND);
        found.iter().map(|one| (one.field.to_string(), one.severity)).collect::<Vec<_>>()
    };
    assert_eq!(warned("1"), [("nominal_area".to_string(), Severity::Warning)]);
    assert_eq!(warned("\"1 m2\""), []);
}

#[test]
fn what_is_to_be_written_instead_of_a_tolerance_is_taken() {
    for (given, ends) in
        [("\"2 GPa +- 10 %\"", [1.8e9, 2.2e9]), ("\"2.5 \u{b1} 0.5 GPa\"", [2e9, 3e9])]
    {
        let with =
            |hardness: &str| read(&text("", &INTERFACE.replace("1.12e9", hardness), SURFACE));
        let refused = with(given).unwrap_err();
        assert_eq!(refused.place().unwrap().field, "interface.hardness");
        let reason = refused.reason();
        let file = with(&reason[reason.find('[').unwrap()..]).unwrap();
        assert_eq!(file.unknowns()[0].ends.map(f64::to_bits), ends.map(f64::to_bits));
    }
}

#[test]
fn units_that_are_not_decimal_are_taken() {
    let scene = text("", &INTERFACE.replace("1.12e9", "\"200 HV\""), SURFACE);
    let file = read(&scene.replace("3e-5", "\"1 in2\"")).unwrap();
    assert!((file.scene.nominal_area - 645.16e-6).abs() < 1e-12);
    let hardness = file.scene.interface.hardness.unwrap();
    assert!((hardness / 2.1153e9 - 1.0).abs() < 1e-4, "{hardness}");
}
