//! Numbers with units, and synonyms of keys.

use crate::scene_files::{INTERFACE, SURFACE, message, read, text};

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
    let odd = with_units.replace("\"1 \u{b5}m\"", "-1");
    assert!(
        message(&odd).contains("line 13: surface.asperity_height_std is -1"),
        "{}",
        message(&odd)
    );
    for (from, to, wanted) in [
        (
            "116e9",
            "\"116 mm\"",
            "interface.equivalent_modulus = \"116 mm\" is not a number in Pa: write 115GPa, for example (units: GPa, MPa,",
        ),
        (
            "116e9",
            "\"116\"",
            "interface.equivalent_modulus = \"116\" has no unit; write \"116 GPa\", for example",
        ),
        (
            "1.11e8",
            "\"111 mm2\"",
            "surface.asperity_density = \"111 mm2\" is not a number in 1/m^2",
        ),
        (
            "0.31",
            "\"0.31\"",
            "interface.poissons_ratio = \"0.31\" is a number in quotes; remove these",
        ),
    ] {
        let found = message(&text("", INTERFACE, SURFACE).replace(from, to));
        assert!(found.contains(wanted), "{found}");
    }
}

#[test]
fn conductivities_may_have_a_unit() {
    let conducting = format!(
        "{INTERFACE}thermal_conductivity = \"0.5 W/(cm K)\"\nelectrical_resistivity = \"17 uohm cm\"\n"
    );
    let found = read(&text("", &conducting, SURFACE)).unwrap();
    let interface = found.scene.interface;
    assert_eq!(interface.thermal_conductivity.map(f64::to_bits), Some(50f64.to_bits()));
    assert_eq!(interface.electrical_resistivity.map(f64::to_bits), Some(17e-8f64.to_bits()));
    assert!(found.findings().is_empty(), "{:?}", found.findings());
    // Copper has 1.7 uohm cm.
    let plain = conducting.replace("\"17 uohm cm\"", "1.7");
    let odd = read(&text("", &plain, SURFACE)).unwrap().findings();
    assert!(
        odd[0].message().contains("looks like uohm cm; 1.7 uohm cm is 1.7e-8 ohm m"),
        "{odd:?}"
    );
}

#[test]
fn synonyms_of_a_key_suggest_it() {
    let with = |key: &str| message(&text("", &format!("{INTERFACE}{key} = 1.0\n"), SURFACE));
    let refused = with("electrical_conductivity");
    assert!(refused.contains("the nearest is \"electrical_resistivity\""), "{refused}");
    assert!(refused.contains("it is 1/conductivity, in ohm m"), "{refused}");
    for name in ["adhesion", "surface_energy"] {
        let refused = with(name);
        assert!(refused.contains("the nearest is \"work_of_adhesion\""), "{refused}");
        let refused = message(&text("", INTERFACE, &format!("{SURFACE}{name} = 0.05\n")));
        assert!(
            refused.contains("work_of_adhesion\"): it belongs to the top of the file"),
            "{refused}"
        );
    }
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
            asperity_inputs::template().replace("youngs_modulus = 210e9", "youngs_modulus = 210");
        let (first, rest) = text.rsplit_once("youngs_modulus = 210").unwrap();
        let text = format!("{first}youngs_modulus = {second}{rest}");
        let file = asperity_inputs::parse(&text, std::path::Path::new(".")).unwrap();
        let found = file.findings();
        found.iter().filter(|one| one.field.ends_with(".youngs_modulus")).count()
    };
    assert_eq!([bodies("210"), bodies("209")], [1, 2]);
}

#[test]
fn accepted_codes_are_silent() {
    let body = |modulus: &str| {
        format!(
            "rigid_counterface = true\n[[body]]\nyoungs_modulus = {modulus}\npoissons_ratio = 0.3\nhardness = 2e9\nthermal_conductivity = 5e4\n"
        )
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

/// The texts of the errors, warnings and notes of a scene with two bodies of steel.
fn findings(body: &str, area: &str, surface: &str) -> Vec<String> {
    let steel = "poissons_ratio = 0.3\nyield_strength = \"400 MPa\"\n";
    let second = format!("[[body]]\nyoungs_modulus = \"210 GPa\"\n{steel}");
    let scene =
        format!("nominal_area = {area}\n[[body]]\n{body}\n{steel}{second}[surface]\n{surface}\n");
    let file = match read(&scene) {
        Ok(file) => file,
        Err(error) => return vec![error.to_string()],
    };
    file.findings().iter().map(ToString::to_string).collect()
}

const STEEL: &str = "youngs_modulus = \"210 GPa\"";
const GROUND: &str = "asperity_radius = \"50 um\"
asperity_density = \"2000 1/mm2\"
asperity_height_std = \"1 um\"";

#[test]
fn a_unit_that_was_given_is_never_reinterpreted() {
    assert!(findings(STEEL, "1e-4", GROUND).is_empty());
    let odd = findings("youngs_modulus = \"210 MPa\"", "1e-4", GROUND);
    assert!(odd[0].ends_with("check the number and its unit"), "{odd:?}");
    let odd = findings(STEEL, "1e-4", &GROUND.replace("50 um", "50 m"));
    assert!(odd[0].ends_with("check the number and its unit"), "{odd:?}");
    // Guideways are that large.
    for area in ["\"0.05 m2\"", "\"2500 cm2\""] {
        assert!(findings(STEEL, area, GROUND).is_empty(), "{area}");
    }
}

#[test]
fn a_likely_unit_is_within_the_usual_range_beside_it() {
    let wanted = "body[1].youngs_modulus is 2.1e5 Pa: 2.1e5 looks like MPa; 2.1e5 MPa is 2.1e11 Pa";
    assert_eq!(findings("youngs_modulus = 210000", "1e-4", GROUND), [wanted]);
    let surface = "asperity_radius = 50\nasperity_density = 2000\nasperity_height_std = 1";
    let wanted = ["; 1 um is 1e-6 m", "50 um is 5e-5 m", "2000 1/mm2 is 2e9 1/m2"];
    let found = findings(STEEL, "1e-4", surface);
    assert!(found.iter().zip(wanted).all(|(found, end)| found.ends_with(end)), "{found:?}");
    assert_eq!(found.len(), 3);
    let surface = "sq = \"1 um\"\nspd = 2000\nspc = 50";
    let found = findings(STEEL, "1e-4", surface);
    assert!(
        found[0].contains(
            "spd = 2000 looks like 1/mm2; 2000 1/mm2 is 2e9 1/m2; spc = 50 looks like 1/mm"
        ),
        "{found:?}"
    );
}

#[test]
fn a_hardness_without_a_unit_looks_like_vickers_or_megapascals() {
    let body = |hardness: &str| format!("{STEEL}\nhardness = {hardness}");
    let found = findings(&body("200"), "1e-4", GROUND);
    let wanted = "200 looks like HV; 200 HV is 2.115e9 Pa";
    assert!(found.len() == 1 && found[0].ends_with(wanted), "{found:?}");
    // 2 HV is softer than any steel.
    let found = findings(&body("2"), "1e-4", GROUND);
    assert!(found.len() == 1 && found[0].ends_with("2 looks like GPa; 2 GPa is 2e9 Pa"));
    let found = findings(&body("\"200 MPa\""), "1e-4", GROUND);
    let wanted = "hardness over modulus is 9.524e-4, where 0.0015 to 0.3 is usual; check the number and its unit";
    assert!(found.len() == 1 && found[0].ends_with(wanted), "{found:?}");
    // Annealed copper.
    assert!(asperity::Body::new(120e9, 0.34, 400e6).findings().is_empty());
}

#[test]
fn right_numbers_in_si_units_are_not_taken_for_centimetres() {
    for surface in [
        "sq = 0.9e-6\nspd = 8e8\nspc = 1.3e6",
        "asperity_radius = \"0.1 mm\"\nasperity_density = 1e8\nsurface_height_std = 1e-7",
        "sq = 1e-7\nspd = 1e9\nspc = 1e5",
        "m0 = 1e-14\nm2 = 0.05\nm4 = 1e9",
        "sq = 0.9\nspd = 8e8\nsdq = 0.31",
    ] {
        let found = findings(STEEL, "1e-4", surface).join("\n");
        assert!(!found.contains("like cm") && !found.contains("like 1/cm"), "{found}");
    }
}

#[test]
fn a_number_with_its_unit_is_not_suspected() {
    const ISO: &str = "sq = \"0.9 um\"\nspd = \"800 1/mm2\"\n";
    let found = findings(STEEL, "1e-4", &format!("{ISO}spc = 13"));
    let wanted = "surface.spc = 13 looks like 1/mm; 13 1/mm is 13000 1/m";
    assert!(found.len() == 1 && found[0].contains(wanted), "{found:?}");
    assert!(found[0].starts_with("line "), "{found:?}");
}

#[test]
fn numbers_in_other_units_than_si_are_named_with_their_line() {
    for (surface, wanted) in [
        ("sq = 9\nspd = 8e8\nspc = 1.3e4", "line 11: surface.sq = 9 looks like um; 9 um is 9e-6 m"),
        ("sq = 0.05\nspd = \"80000 1/mm2\"\nspc = 1.3e4", "surface.sq = 0.05 looks like um;"),
        (
            "sq = 20\nspd = 800\nspc = 13",
            "sq = 20 looks like um; 20 um is 2e-5 m; spd = 800 looks like 1/mm2; 800 1/mm2 is 8e8 1/m2; spc = 13 looks like 1/mm",
        ),
        (
            "sq = \"0.9 um\"\nspd = \"8e4 1/m2\"\nspc = \"13000 1/m\"",
            "surface.sq (times spd/spc) is 5.538",
        ),
    ] {
        let found = findings(STEEL, "1e-4", surface);
        assert!(found.len() == 1 && found[0].contains(wanted), "{surface}: {found:?}");
    }
}

#[test]
fn numbers_of_a_surface_are_named_as_they_were_given() {
    for (surface, wanted) in [
        ("sq = 1.1\nspd = 2e8\nspc = 5e3", "sq = 1.1 looks like um; 1.1 um is 1.1e-6 m"),
        ("sq = 1.1e-6\nspd = 2e8\nspc = 5", "spc = 5 looks like 1/mm; 5 1/mm is 5000 1/m"),
        (
            "sq = 1.1\nspd = 2e8\nspc = 5",
            "sq = 1.1 looks like um; 1.1 um is 1.1e-6 m; spc = 5 looks like 1/mm; 5 1/mm is 5000 1/m",
        ),
        (
            "sq = 1.1\nspd = 200\nspc = 5",
            "sq = 1.1 looks like um; 1.1 um is 1.1e-6 m; spd = 200 looks like 1/mm2; 200 1/mm2 is 2e8 1/m2; spc = 5 looks like 1/mm; 5 1/mm is 5000 1/m",
        ),
        ("sq = 1.1\nspd = 2e8\nsdq = 0.058", "sq = 1.1 looks like um; 1.1 um is 1.1e-6 m"),
        (
            "asperity_radius = 2e-4\nasperity_density = 2e8\nsurface_height_std = 1.1",
            "surface_height_std = 1.1 looks like um; 1.1 um is 1.1e-6 m",
        ),
        (
            "sq = 1.1e-6\nspd = 200\nsdq = 0.058",
            "spd = 200 looks like 1/mm2; 200 1/mm2 is 2e8 1/m2",
        ),
    ] {
        let found = findings(STEEL, "1e-4", surface);
        assert!(found.len() == 1 && found[0].ends_with(wanted), "{surface}: {found:?}");
    }
}

#[test]
fn commas_brackets_and_other_units_are_explained() {
    for (from, to, wanted) in [
        ("0.3", "0,31", "0,31 has a decimal comma; write 0.31; "),
        (
            "\"400 MPa\"",
            "\"0,4 GPa\"",
            "yield_strength = \"0,4 GPa\" has a decimal comma; write 0.4 GPa",
        ),
        ("\"400 MPa\"", "\u{201c}400 MPa\u{201d}", "write straight quotes"),
        ("\"400 MPa\"", "\"4,0e8\"", "= \"4,0e8\" has a decimal comma; write 4.0e8 without quotes"),
        (
            "\"400 MPa\"",
            "\"120 HV\"",
            "= \"120 HV\" is a hardness, not a yield strength: give hardness",
        ),
    ] {
        let body = format!("{STEEL}\npoissons_ratio = 0.3\nyield_strength = \"400 MPa\"");
        let scene = format!(
            "nominal_area = 1e-4\nrigid_counterface = true\n[[body]]\n{body}\n[surface]\n{GROUND}\n"
        );
        let found = message(&scene.replacen(from, to, 1));
        assert!(found.contains(wanted), "{found}");
        let twice =
            scene.replacen("[surface]", "[body]\n[surface]", 1).replace("[[body]]", "[body]");
        assert!(message(&twice).contains("each of two bodies is written [[body]]; "));
        let found = message(&scene.replace("[[body]]", "[body]"));
        assert!(found.contains("each written [[body]]"), "{found}");
    }
}

#[test]
fn units_that_are_not_decimal_are_taken_and_converted_at_their_key() {
    let scene = format!(
        "nominal_area = \"1 in2\"\nrigid_counterface = true\n[[body]]\n{STEEL}\npoissons_ratio = 0.3\n\
         hardness = \"200 HV\"\n[surface]\n{GROUND}\n"
    );
    let file = asperity_inputs::parse(&scene, std::path::Path::new(".")).unwrap();
    assert!((file.scene.nominal_area - 645.16e-6).abs() < 1e-12);
    let hardness = file.scene.interface.hardness.unwrap();
    assert!((hardness / 2.1153e9 - 1.0).abs() < 1e-4, "{hardness}");
    let wanted =
        [("body[1].hardness", "200 HV is 2.115 GPa"), ("nominal_area", "1 in2 is 645.2 mm2")];
    assert_eq!(file.converted, wanted.map(|(key, text)| (key.to_string(), text.to_string())));
}

#[test]
fn a_hardness_by_another_test_is_taken_with_its_table_and_a_bare_one_is_none_in_gpa() {
    let scene = |hardness: &str| {
        let text = format!(
            "nominal_area = 1e-4\nrigid_counterface = true\n[[body]]\n{STEEL}\npoissons_ratio = 0.3\n\
             hardness = {hardness}\n[surface]\n{GROUND}\n"
        );
        asperity_inputs::parse(&text, std::path::Path::new("."))
    };
    // 653 and 200 HV, in kgf/mm² over sin 68°.
    for (text, pascals) in [("58 HRC", 6.9067e9), ("190 HB", 2.1154e9)] {
        let file = scene(&format!("\"{text}\"")).unwrap();
        let found = file.scene.interface.hardness.unwrap();
        assert!((found / pascals - 1.0).abs() < 1e-4, "{text}: {found}");
        let [(key, conversion)] = &file.converted[..] else { panic!("{:?}", file.converted) };
        assert!(key == "body[1].hardness" && conversion.contains(" for steel"), "{conversion}");
    }
    for (text, units) in [
        ("58", "write \"58 HRC\" or \"58 HV\", for example"),
        ("200", "write \"200 HV\", for example"),
        ("2", "write \"2 GPa\", for example"),
    ] {
        let refused = scene(&format!("\"{text}\"")).unwrap_err().to_string();
        assert!(refused.contains(units), "{refused}");
    }
    // A bare number is in Pa: the warning has the unit that steel is tested in.
    let found = scene("58").unwrap().findings();
    let bare = found.iter().find(|found| found.field == "body[1].hardness").unwrap().to_string();
    assert!(bare.ends_with("58 looks like HRC; 58 HRC is 6.907e9 Pa"), "{bare}");
}
