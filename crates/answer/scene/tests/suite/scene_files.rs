//! Reading of scene files, and their errors.

use std::path::{Path, PathBuf};

use asperity::{
    Body, Datum, HeightDistribution, Interface, ProfileMoments, SeparationUnit, Surface,
};
use asperity_scene::{SceneError, SceneFile, parse};

pub const INTERFACE: &str = include_str!("scenes/interface.toml");
pub const SURFACE: &str = include_str!("scenes/surface.toml");

const SOFT: &str =
    "[[body]]\nyoungs_modulus = 70e9\npoissons_ratio = 0.33\nyield_strength = 300e6\n";

pub fn text(top: &str, interface: &str, surface: &str) -> String {
    format!("nominal_area = 3e-5\n{top}\n{interface}\n{surface}\n")
}

pub fn read(text: &str) -> Result<SceneFile, SceneError> {
    parse(text, Path::new("."))
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
    assert_eq!((file.spec.separation_from, file.warnings.len()), (Datum::AsperityMean, 0));
    let integers = text("", &INTERFACE.replace("116e9", "116_000_000_000"), SURFACE);
    assert_eq!(read(&integers).unwrap().scene.interface, interface);
}

#[test]
fn two_bodies_and_a_rigid_counterface_give_the_interfaces_of_the_library() {
    let hard = &format!("{SOFT}hardness = 7e9\n").replace("70e9", "210e9").replace("0.33", "0.3");
    let (soft, hard) = (SOFT, &hard.replace("300e6", "2e9"));
    let a = Body::yielding(70e9, 0.33, 300e6);
    let mut b = Body::new(210e9, 0.3, 7e9);
    b.yield_strength = Some(2e9);
    let both = read(&text("", &format!("{soft}{hard}"), SURFACE)).unwrap();
    assert_eq!(both.spec.bodies.interface().unwrap(), Interface::between(&a, &b).unwrap());
    // The hardness of the softer body is known within a range, that of the harder one given.
    let [one] = &both.unknowns()[..] else { panic!("one unknown") };
    assert_eq!((&*one.name, one.ends), ("body1_hardness", [3.3 * 300e6, 7.8 * 300e6]));
    assert_eq!(both.scene.interface.hardness, Some(one.middle()));
    assert_eq!(both.spec.bodies.interface().unwrap().yield_strength, Some(300e6));
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
}
