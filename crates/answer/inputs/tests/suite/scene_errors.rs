//! Errors of scene files name the line, the field and the requirement.

use std::path::Path;

use asperity_inputs::load;

use crate::scene_files::{INTERFACE, SURFACE, directory, message, text};

#[test]
fn every_error_names_line_field_and_requirement() {
    let bodies = "[[body]]\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\nhardness = 2e9\n";
    let two = format!("{bodies}{}", bodies.replace("0.3", "0.7"));
    let with = |line: &str| format!("{SURFACE}{line}\n");
    let cases: Vec<(String, &[&str])> = vec![
        (
            text("", INTERFACE, &SURFACE.replace("asperity_radius", "asperity_radus")),
            &[
                "line 10: surface.asperity_radus is not known",
                "the nearest is \"asperity_radius\"",
                "m4",
            ],
        ),
        (
            text("", &format!("{INTERFACE}nominal_area = 1\n"), SURFACE),
            &["line 8: interface.nominal_area is not known: it belongs to the top of the file"],
        ),
        (
            text("", &format!("{INTERFACE}body_1 = {{ hardness = 1e9 }}\n"), SURFACE),
            &["interface.body_1 is not known: write [[body]] twice instead of [interface]"],
        ),
        (
            text("[grains]", INTERFACE, SURFACE),
            &["line 2: grains is not known: the keys here are nominal_area"],
        ),
        (text("interfaces = 3", INTERFACE, SURFACE), &["the nearest is \"interface\""]),
        (
            text("", INTERFACE, &SURFACE.replace("1e-6", "\"1 parsec\"")),
            &[
                "line 12: surface.asperity_height_std = \"1 parsec\" is not a number in m: write 1um, for example",
            ],
        ),
        (
            text("", INTERFACE, &SURFACE.replace("1e-6", "-1e-6")),
            &[
                "line 12: surface.asperity_height_std is -1e-6: a finite number above 0 was required",
            ],
        ),
        (
            text("", INTERFACE, &SURFACE.replace("1e-6", "nan")),
            &["line 12: surface.asperity_height_std is NaN"],
        ),
        (
            text("", INTERFACE, &SURFACE.replace("1e-6", "1e999")),
            &["line 12: surface.asperity_height_std is inf: a finite number above 0"],
        ),
        (
            text("", &INTERFACE.replace("0.31", "0.6"), SURFACE),
            &["line 6: interface.poissons_ratio is 0.6: a number above -1 and at most 0.5"],
        ),
        (text("", &two, SURFACE), &["line 9: body[2].poissons_ratio is 0.7"]),
        (text("", bodies, SURFACE), &["body[2] is missing", "rigid_counterface = true"]),
        (
            text("rigid_counterface = true", &two.replace("0.7", "0.3"), SURFACE),
            &["line 3: body is a list of 2: two tables [[body]] alone, or one with rigid"],
        ),
        (
            text("rigid_counterface = true", INTERFACE, SURFACE),
            &["line 3: interface and rigid_counterface (line 2) exclude each other"],
        ),
        (
            text("rigid_counterface = 1", bodies, SURFACE),
            &["line 2: rigid_counterface is 1: true or false was required"],
        ),
        (
            text("work_of_adhesion = -0.05", &two.replace("0.7", "0.3"), SURFACE),
            &["line 2: work_of_adhesion is -0.05: a finite number, at least 0 was required"],
        ),
        (
            text("work_of_adhesion = 0.05", INTERFACE, SURFACE),
            &["line 2: work_of_adhesion and interface (line 3) exclude each other"],
        ),
        (
            text("", &format!("{INTERFACE}work_of_adhesion = \"5 J\"\n"), SURFACE),
            &["interface.work_of_adhesion = \"5 J\" is not a number in J/m^2: write"],
        ),
        (text("", &bodies.repeat(3), SURFACE), &["body is a list of 3: two tables [[body]] alone"]),
        (text("body = 3", "", SURFACE), &["line 2: body is 3: a list (two of them"]),
        (
            text("", &format!("{INTERFACE}{bodies}"), SURFACE),
            &["line 3: interface and body (line 8) exclude each other: either [interface]"],
        ),
        (
            text("", "", SURFACE),
            &["interface is missing: either [interface]", "(one with rigid_counterface = true)"],
        ),
        (text("", INTERFACE, ""), &["surface is missing"]),
        (
            text("surface = 3", INTERFACE, ""),
            &["line 2: surface is 3: a table, [surface], was required"],
        ),
        (text("", INTERFACE, "[surface]"), &["line 9: surface is missing: exactly one way"]),
        (
            text("", INTERFACE, &with("plasticity_index = 6")),
            &[
                "line 10: surface.asperity_radius and surface.plasticity_index (line 13) exclude each other: exactly one way",
            ],
        ),
        (
            text("", INTERFACE, "[surface]\nm0 = 1e-12\nm4 = 5e4"),
            &["surface.m2 is missing: m0, m2, m4 go together"],
        ),
        (
            text("", INTERFACE, "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 1.4e4"),
            &["line 9: surface.bandwidth (m0 m4/m2^2) is 1.4", "at least 1.5, as of every"],
        ),
        (
            text("", INTERFACE, "[surface]\nm0 = 1\nm2 = 1\nm4 = 1\nasperity_height_std = 1"),
            &["surface.asperity_height_std and surface.m0 (line 10) exclude each other"],
        ),
        (
            text("", INTERFACE, &with("unit = \"um\"")),
            &[
                "surface.unit and surface.asperity_radius (line 10) exclude each other: a measured file",
            ],
        ),
        (
            text("", INTERFACE, &with("separation_from = \"surfacemean\"")),
            &[
                "the nearest is \"surface-mean\"",
                "\"asperity-mean\" or \"surface-mean\" was required",
            ],
        ),
        (
            text("", INTERFACE, &with("heights = \"gausian\"")),
            &["the nearest is \"gaussian\"", "or { file = \"pdf.csv\" } was required"],
        ),
        (
            text("", INTERFACE, &with("heights = { fil = \"pdf.csv\" }")),
            &[
                "line 13: surface.heights is { fil = \"pdf.csv\" }: ",
                "or { file = \"pdf.csv\" } was",
            ],
        ),
        (text("", INTERFACE, &with("heights = 3")), &["surface.heights is 3: \"gaussian\" or"]),
        (
            text("", INTERFACE, &with("heights = { file = \"absent.csv\" }")),
            &["line 13: surface.heights.file = \"./absent.csv\" cannot be read: "],
        ),
        (
            text("", INTERFACE, &with("[options]\nstick = \"clampd\"")),
            &[
                "line 14: options.stick is \"clampd\" (the nearest is \"clamped\"): \"clamped\" or \"unlimited\"",
            ],
        ),
        (
            text("", INTERFACE, &with("[options]\nangle_density = { a20 = 3, a21 = 0, b21 = 0 }")),
            &["line 14: options.angle_density.a20 is 3.0: from -1 to 2"],
        ),
        (
            text("", INTERFACE, &with("[options]\ndisplacement = { zeta = 1 }")),
            &["line 14: options.displacement is { zeta = 1 }: ", "or { zeta = 0.1, xi = 0.1 }"],
        ),
        (
            text("", INTERFACE, &with("[options]\ndisplacement = { zeta = 1, xi = -1 }")),
            &["line 14: options.displacement.xi is -1.0: a finite number, at least 0"],
        ),
        (
            text("", INTERFACE, &with("[options]\ndisplacement = { zeta = 1, xi = 1, eta = 1 }")),
            &["line 14: options.displacement is { zeta = 1, xi = 1, eta = 1 }: "],
        ),
        (
            text("", INTERFACE, &with("[options.displacement]\nzeta = 1\n")),
            &["line 13: options.displacement is [options.displacement]: \"vertical\" or \"none\""],
        ),
        (
            text("surface = { m0 = 1, \"m 2\" = 3 }", INTERFACE, ""),
            &["line 2: surface.m 2 is not known (the nearest is \"m2\")"],
        ),
        (
            text("", "[interface]\nequivalent_modulus = 1e9", SURFACE),
            &["line 3: interface.poissons_ratio is missing: a number (of the softer body"],
        ),
        (
            text("", INTERFACE, &with("[options]\nforce = 3")),
            &["options.force is 3: a name in quotes"],
        ),
        (text("", INTERFACE, &with("[options]\nstik = 3")), &["the nearest is \"stick\""]),
        (
            text("", INTERFACE, &with("asperity_radius = 1")),
            &["line 13: TOML: duplicate key: \"asperity_radius = 1\" was found"],
        ),
        ("nominal_area = ".into(), &["line 1: TOML: "]),
        (
            String::new(),
            &["line 1: nominal_area is missing: a number (m^2, the apparent area of contact"],
        ),
        (
            format!("{INTERFACE}{SURFACE}"),
            &["line 1: nominal_area is missing: a number (m^2, the app"],
        ),
        ("[surface]\nm0 = 1".into(), &["line 1: nominal_area is missing"]),
        ("nominal_area = 1".into(), &["line 1: interface is missing: either"]),
        (
            text("", INTERFACE, SURFACE).replace("3e-5", "0"),
            &["line 1: nominal_area is 0.0: a finite number above 0"],
        ),
    ];
    let mut failures = String::new();
    for (text, parts) in cases {
        let message = message(&text);
        for part in parts.iter().filter(|part| !message.contains(**part) || message.contains('\n'))
        {
            failures += &format!("{message}\n  lacks: {part}\n");
        }
    }
    assert!(failures.is_empty(), "{failures}");
}

#[test]
fn errors_of_files_name_the_file() {
    let directory = directory("names");
    let path = directory.join("scene.toml");
    std::fs::write(&path, text("", INTERFACE, &SURFACE.replace("1e-6", "0"))).unwrap();
    let message = load(&path).unwrap_err().to_string();
    let wanted = format!("{}:12: surface.asperity_height_std is 0.0: ", path.display());
    assert!(message.starts_with(&wanted), "{message}");
    for (name, bytes) in [("utf16.toml", &b"\xff\xfe\x00"[..]), ("big.toml", &[b'#'; 1_100_000])] {
        let path = directory.join(name);
        std::fs::write(&path, bytes).unwrap();
        let message = load(&path).unwrap_err().to_string();
        assert!(message.contains(name) && message.contains("cannot be read"), "{message}");
    }
    assert!(load(&directory).unwrap_err().to_string().contains("cannot be read"));
    assert!(load(Path::new("absent.toml")).unwrap_err().to_string().starts_with("absent.toml: "));
}

#[test]
fn a_key_of_the_top_below_the_options_is_misplaced_and_not_missing() {
    let template = asperity_inputs::template();
    let moved = template.replacen("nominal_area = 1e-4", "", 1) + "nominal_area = 1e-4\n";
    let refused = asperity_inputs::parse(&moved, std::path::Path::new(".")).unwrap_err();
    let message = refused.to_string();
    assert!(
        message.contains("options.nominal_area is not known: it belongs to the top"),
        "{message}"
    );
}
