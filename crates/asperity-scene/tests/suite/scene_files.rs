//! Reading of scene files, and their errors.

use std::path::{Path, PathBuf};

use asperity::{
    Body, Datum, HeightDistribution, Interface, ProfileMoments, SeparationUnit, Surface,
};
use asperity_scene::{SceneError, SceneFile, load, parse};

pub const INTERFACE: &str = "[interface]
equivalent_modulus = 116e9
equivalent_shear_modulus = 41e9
poissons_ratio = 0.31
hardness = 1.12e9
";
pub const SURFACE: &str = "[surface]
asperity_radius = 3.59e-4
asperity_density = 1.11e8
asperity_height_std = 1e-6
";

pub fn text(top: &str, interface: &str, surface: &str) -> String {
    format!("nominal_area = 3e-5\n{top}\n{interface}\n{surface}\n")
}

pub fn read(text: &str) -> Result<SceneFile, SceneError> {
    parse(text, Path::new("."))
}

pub fn message(text: &str) -> String {
    read(text).unwrap_err().to_string()
}

/// A fresh directory for the files of one test.
pub fn directory(name: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&directory).unwrap();
    directory
}

#[test]
fn the_scene_of_the_manual_is_read() {
    let file = read(&text("", INTERFACE, SURFACE)).unwrap();
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.equivalent_shear_modulus = Some(41e9);
    assert_eq!(file.scene.interface, interface);
    assert_eq!(file.scene.surface, Surface::new(3.59e-4, 1.11e8, 1e-6));
    assert!(matches!(file.scene.heights, HeightDistribution::Gaussian));
    assert_eq!((file.separation_from, file.warnings.len()), (Datum::AsperityMean, 0));
    let integers = text("", &INTERFACE.replace("116e9", "116_000_000_000"), SURFACE);
    assert_eq!(read(&integers).unwrap().scene.interface, interface);
}

#[test]
fn two_bodies_and_a_rigid_counterface_give_the_interfaces_of_the_library() {
    let soft = "[[body]]\nyoungs_modulus = 70e9\npoissons_ratio = 0.33\nyield_strength = 300e6\n";
    let hard = "[[body]]\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\nhardness = 7e9\nyield_strength = 2e9\n";
    let a = Body::yielding(70e9, 0.33, 300e6);
    let mut b = Body::new(210e9, 0.3, 7e9);
    b.yield_strength = Some(2e9);
    let both = read(&text("", &format!("{soft}{hard}"), SURFACE)).unwrap();
    assert_eq!(both.scene.interface, Interface::between(&a, &b).unwrap());
    assert_eq!(both.scene.interface.yield_strength, Some(300e6), "of the softer body");
    let rigid = read(&text("rigid_counterface = true", hard, SURFACE)).unwrap();
    assert_eq!(rigid.scene.interface, Interface::against_rigid(&b).unwrap());
    let sticky = format!("work_of_adhesion = \"50 mJ/m2\"\n[[body]]{}{hard}", &soft[8..]);
    let sticky = read(&text("", &sticky, SURFACE)).unwrap().scene.interface;
    assert_eq!(sticky.work_of_adhesion, Some(0.05));
    let false_is_two = read(&text("rigid_counterface = false", &format!("{soft}{hard}"), SURFACE));
    assert_eq!(false_is_two.unwrap().scene.interface, both.scene.interface);
}

#[test]
fn every_way_gives_the_surface_of_the_library() {
    let interface = read(&text("", INTERFACE, SURFACE)).unwrap().scene.interface;
    let index =
        "[surface]\nplasticity_index = 6\nroughness_parameter = 0.04\nasperity_height_std = 1e-6";
    assert_eq!(
        read(&text("", INTERFACE, index)).unwrap().scene.surface,
        Surface::from_plasticity_index(6.0, 0.04, 1e-6, &interface).unwrap()
    );
    let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 5e4 };
    assert_eq!(
        read(&text("", INTERFACE, "[surface]\nm0 = 1e-12\nm2 = 1e-4\nm4 = 5e4"))
            .unwrap()
            .scene
            .surface,
        Surface::from_moments(&moments).unwrap()
    );
    let of_surface = SURFACE.replace("asperity_height_std", "surface_height_std");
    let wanted = Surface::from_surface_std(3.59e-4, 1.11e8, 1e-6).unwrap();
    assert_eq!(read(&text("", INTERFACE, &of_surface)).unwrap().scene.surface, wanted);
    let slope = "[surface]\nsurface_height_std = 1e-6\nmean_slope = 0.1\nasperity_density = 2e9";
    let wanted = Surface::from_mean_slope(1e-6, 0.1, 2e9).unwrap();
    assert_eq!(read(&text("", INTERFACE, slope)).unwrap().scene.surface, wanted);
    // Parameters in the units of the instrument.
    let iso = "[surface]\nsq = \"1 um\"\nspd = \"111 1/mm2\"\nspc = \"2.5 1/mm\"";
    let wanted = Surface::from_surface_std(1.0 / 2500.0, 1.11e8, 1e-6).unwrap();
    assert_eq!(read(&text("", INTERFACE, iso)).unwrap().scene.surface, wanted);
    // The rms gradient of the same Gaussian surface: sqrt(2 m2), from spc and spd in closed form.
    let pi = std::f64::consts::PI;
    let m2 = 9.0 * pi * 2500f64.powi(2) / 64.0 / (6.0 * 3f64.sqrt() * pi * 1.11e8);
    let gradient = iso.replace("spc = \"2.5 1/mm\"", &format!("sdq = {:e}", (2.0 * m2).sqrt()));
    let found = read(&text("", INTERFACE, &gradient)).unwrap().scene.surface;
    let off = |a: f64, b: f64| (a / b - 1.0).abs();
    assert!(off(found.asperity_radius, wanted.asperity_radius) < 1e-12, "{found:?}");
    // The constants of the variance of summits have seven digits.
    assert!(off(found.asperity_height_std, wanted.asperity_height_std) < 1e-7, "{found:?}");
    assert!(off(found.asperity_density, 1.11e8) < 1e-12, "{found:?}");
    // Findings name the keys of the file.
    let found = read(&text("", INTERFACE, &iso.replace("\"1 um\"", "1.0"))).unwrap().findings();
    let (whole, keys) = (found[0].message(), "asperities from sq, spd, spc: ");
    assert!(whole.contains("looks like um") && whole.starts_with(keys), "{whole}");
    for (surface, wanted) in [
        (iso.replace("2.5 1/mm", "-2.5 1/mm"), "surface.spc is -2500.0: a finite number above 0"),
        (format!("{iso}\nm2 = 1e-2"), "exclude each other"),
        (
            format!("{SURFACE}surface_height_std = 1e-6"),
            "surface.surface_height_std and surface.asperity_height_std",
        ),
        (
            format!("{iso}\nsurface_height_std = 1e-6"),
            "asperity_radius and asperity_density with it",
        ),
        (
            format!("{SURFACE}heights = \"measured\""),
            "a measured file, from which the heights are taken",
        ),
        (
            slope.replace("surface_height_std = 1e-6\n", ""),
            "surface_height_std, mean_slope, asperity_density go together",
        ),
        (format!("{SURFACE}mean_slope = 0.1"), "asperity_density and surface_height_std with it"),
        (format!("{iso}\nsdq = 0.1"), "surface.sdq and surface.spc"),
        (format!("{SURFACE}sdq = 0.1"), "sq and spd with it"),
        (gradient.replace("spd = \"111 1/mm2\"", ""), "sq and spd go with spc or sdq"),
        (format!("{iso}\nmean_slope = 0.1"), "asperity_density and surface_height_std with it"),
        // Too little roughness for so many peaks.
        (iso.replace("1 um", "1 nm"), "sq (times spd/spc) is 4.44e-5"),
    ] {
        let found = message(&text("", INTERFACE, &surface));
        assert!(found.contains(wanted), "{found}");
    }
}

#[test]
fn separations_from_the_mean_plane_are_shifted_by_its_offset() {
    let from = format!("{SURFACE}separation_from = \"surface-mean\"\n");
    let file = read(&text("", INTERFACE, &from)).unwrap();
    let offset = file.scene.surface.mean_plane_offset();
    assert!((file.scene.mean_plane_offset() - offset).abs() < 1e-20 && offset > 1e-6);
    let given = file.separation(3.0, SeparationUnit::Sigma);
    assert_eq!(given.from, Datum::SurfaceMean);
    let inner = given.measured_in(SeparationUnit::Sigma, Datum::AsperityMean, &file.scene).unwrap();
    assert!((inner.value - (3.0 - offset / 1e-6)).abs() < 1e-12);
    let exponential = message(&text("", INTERFACE, &format!("{from}heights = \"exponential\"\n")));
    assert!(exponential.contains("surface.separation_from and surface.heights"), "{exponential}");
}

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
            text("[grains]", INTERFACE, SURFACE),
            &["line 2: grains is not known: the keys here are nominal_area"],
        ),
        (text("interfaces = 3", INTERFACE, SURFACE), &["the nearest is \"interface\""]),
        (
            text("", INTERFACE, &SURFACE.replace("1e-6", "\"1 parsec\"")),
            &[
                "line 12: surface.asperity_height_std is \"1 parsec\": a number in m without quotes, or with a unit, for example",
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
            &["line 12: surface.asperity_height_std is 1e999: a number of at most 1.8e308"],
        ),
        (
            text("", &INTERFACE.replace("0.31", "0.6"), SURFACE),
            &["line 6: interface.poissons_ratio is 0.6: a number above -1 and at most 0.5"],
        ),
        (text("", &two, SURFACE), &["line 9: body[2].poissons_ratio is 0.7"]),
        (text("", bodies, SURFACE), &["body[2] is missing", "rigid_counterface = true"]),
        (
            text("rigid_counterface = true", &two.replace("0.7", "0.3"), SURFACE),
            &["line 2: rigid_counterface and body (line 3) exclude each other: one [[body]]"],
        ),
        (
            text("rigid_counterface = true", INTERFACE, SURFACE),
            &["line 2: rigid_counterface and interface (line 3) exclude each other"],
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
            &["interface.work_of_adhesion is \"5 J\": a number in J/m^2 without quotes"],
        ),
        (text("", &bodies.repeat(3), SURFACE), &["body is a list of 3: two tables [[body]]"]),
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
                "line 13: surface.heights is { fil = \"pdf.csv\" } (the nearest is \"file\"): ",
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
            &["line 3: interface.poissons_ratio is missing: of the softer body"],
        ),
        (
            text("", INTERFACE, &with("[options]\nforce = 3")),
            &["options.force is 3: a name in quotes"],
        ),
        (
            text("", INTERFACE, &with("[options]\nat_readin = 3")),
            &["the nearest is \"at_reading\""],
        ),
        (
            text("", INTERFACE, &with("asperity_radius = 1")),
            &["line 13: TOML: duplicate key: \"asperity_radius = 1\" was found"],
        ),
        ("nominal_area = ".into(), &["line 1: TOML: "]),
        (String::new(), &["line 1: nominal_area is missing: m^2, the apparent area of contact"]),
        (format!("{INTERFACE}{SURFACE}"), &["line 1: nominal_area is missing: m^2, the app"]),
        ("[surface]\nm0 = 1".into(), &["line 1: nominal_area is missing"]),
        ("nominal_area = 1".into(), &["line 1: surface is missing: the rough surface, in exactly"]),
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
