//! Reading of scene files, and their errors.

use std::path::{Path, PathBuf};

use asperity::{
    Body, Datum, HeightDistribution, Interface, ProfileMoments, SeparationUnit, Surface,
};
use asperity_inputs::{SceneError, SceneFile, parse};

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
    let wanted = "line 10: surface.sq = 1 looks like um; 1 um is 1e-6 m";
    assert_eq!(found[0].message(), wanted);
    let blunt = gradient.replace("\"1 um\"", "1.0");
    assert_eq!(read(&text("", INTERFACE, &blunt)).unwrap().findings()[0].message(), wanted);
    let far = gradient.replace("\"1 um\"", "\"1 m\"");
    let found = read(&text("", INTERFACE, &far)).unwrap().findings();
    assert!(found.iter().any(|one| one.message().starts_with("asperities from sq = 1 m, spd = ")));
    // Degrees or per cent, refused and warned of.
    let angle = |sdq: &str, sq: &str| {
        let surface = gradient.split("sdq = ").next().unwrap().replace("1 um", sq);
        text("", INTERFACE, &format!("{surface}sdq = {sdq}"))
    };
    let hint = "looks like degrees or per cent; 12 deg is 0.2126, 12 % is 0.12";
    assert!(message(&angle("12", "1 um")).contains(&format!("surface.sdq = 12 {hint}")));
    for (given, wanted) in [
        ("\"12 %\"", "surface.sdq = \"12 %\" is a slope; write 0.12 without quotes"),
        ("\"6,5 %\"", "is a slope; write 0.065 without quotes"),
        ("\"0,06\"", "surface.sdq = \"0,06\" has a decimal comma; write 0.06 without quotes"),
        ("90", "surface.sdq = 90 looks like per cent; 90 % is 0.9"),
        (
            "0.7",
            "surface.sdq = 0.7 is too steep: at most 6.598 sq sqrt(spd) = 0.06951 was required",
        ),
    ] {
        let found = message(&angle(given, "1 um"));
        assert!(found.contains(wanted), "{found}");
    }
    let mean = |slope: &str| {
        let surface = "[surface]\nsurface_height_std = 1e-6\nasperity_density = 1.11e8\n";
        message(&text("", INTERFACE, &format!("{surface}mean_slope = {slope}")))
    };
    for (given, wanted) in [
        (
            "7",
            "surface.mean_slope = 7 looks like degrees or per cent; 7 deg is 0.1228, 7 % is 0.07",
        ),
        ("\"7 %\"", "surface.mean_slope = \"7 %\" is a slope; write 0.07 without quotes"),
        (
            "0.7",
            "mean_slope = 0.7 is too steep: at most 3.722 surface_height_std sqrt(asperity_density) = 0.03922 was",
        ),
    ] {
        let found = mean(given);
        assert!(found.contains(wanted), "{found}");
    }
    // Each of two surfaces by its own section and line.
    let pair = angle("12", "1 mm") + "\n[surface.counterface]\nsq = 1e-3\nspd = 1.11e8\nsdq = 7\n";
    let warned = read(&pair).unwrap().warnings;
    for wanted in ["surface.sdq: sdq is 12,", "surface.counterface.sdq: sdq is 7,"] {
        assert!(warned.iter().any(|one| one.to_string().contains(wanted)), "{warned:?}");
    }
    let refused = message(&pair.replace("sq = 1e-3", "sq = 1e-6"));
    assert!(refused.contains("surface.counterface.sdq = 7 looks like degrees"), "{refused}");
    // A curvature in 1/mm.
    let curvature = read(&text("", INTERFACE, &iso.replace("\"2.5 1/mm\"", "2.5"))).unwrap();
    let found = curvature.findings();
    let wanted = "surface.spc = 2.5 looks like 1/mm; 2.5 1/mm is 2500 1/m";
    assert!(found[0].message().ends_with(wanted), "{found:?}");
    let warned = read(&angle("12", "1 mm")).unwrap().warnings;
    assert!(warned.iter().any(|one| one.to_string().contains(hint)), "{warned:?}");
    for (surface, wanted) in [
        (gradient.replace("sdq = ", "sdq = -"), "surface.sdq is -"),
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
        (format!("{SURFACE}mean_slope = 0.1"), "surface_height_std and asperity_density with it"),
        (format!("{iso}\nsdq = 0.1"), "surface.sdq and surface.spc"),
        (format!("{SURFACE}sdq = 0.1"), "sq and spd with it"),
        (gradient.replace("spd = \"111 1/mm2\"", ""), "sq and spd go with spc or sdq"),
        (format!("{iso}\nmean_slope = 0.1"), "surface_height_std and asperity_density with it"),
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
fn equally_hard_bodies_are_told_apart_aloud() {
    let bodies = |ratios: [f64; 2], hardnesses: [f64; 2]| {
        let body = |k: usize| {
            let (nu, hardness) = (ratios[k], hardnesses[k]);
            format!(
                "[[body]]\nyoungs_modulus = 2e11\npoissons_ratio = {nu}\nhardness = {hardness}\n"
            )
        };
        let surface = "[surface]\nasperity_radius = 2e-4\nasperity_density = 2e8\n\
            asperity_height_std = 1e-6\n";
        let text = format!("nominal_area = 1e-4\n{}{}{surface}", body(0), body(1));
        read(&text).unwrap()
    };
    for ratios in [[0.3, 0.45], [0.45, 0.3]] {
        let file = bodies(ratios, [2e9, 2e9]);
        assert!((file.scene.interface.poissons_ratio - 0.3).abs() < 1e-15);
        let found = file.findings();
        assert_eq!(found.iter().map(|found| found.code).collect::<Vec<_>>(), ["equally-hard"]);
    }
    assert!(bodies([0.3, 0.3], [2e9, 2e9]).findings().is_empty());
    assert!(bodies([0.3, 0.45], [2e9, 3e9]).findings().is_empty());
}
