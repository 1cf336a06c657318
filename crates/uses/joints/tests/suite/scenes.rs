//! The scenes of these tests.

use asperity_core::{HeightDistribution, Interface, Scene, Surface, TabulatedHeights, Tolerance};

/// σ_z of [`with_index`] \[m\].
pub const SIGMA: f64 = 1e-6;

/// A scene of `tests/reference/models_scenes.csv`.
pub fn named(case: &str) -> Scene {
    let table = include_str!("../../../../../tests/reference/models_scenes.csv");
    let row = table.lines().find(|line| line.starts_with(&format!("{case},"))).unwrap();
    let mut numbers = row.split(',').skip(1).map(|field| field.parse::<f64>().unwrap());
    let mut next = || numbers.next().unwrap();
    let mut interface = Interface::new(next(), 0.0, 0.0);
    interface.equivalent_shear_modulus = Some(next());
    interface.poissons_ratio = next();
    interface.hardness = Some(next());
    interface.pressure_factor = Some(next());
    Scene::new(interface, Surface::new(next(), next(), next()), next())
}

/// The materials of the AT paper, with a radius that makes this plasticity index.
pub fn with_index(plasticity_index: f64) -> Scene {
    let mut interface = Interface::new(116e9, 0.31, 1.12e9);
    interface.pressure_factor = Some(0.58);
    let surface =
        Surface::from_plasticity_index(plasticity_index, 0.04, SIGMA, &interface).unwrap();
    Scene::new(interface, surface, 3e-5)
}

/// The scene of [`with_index`] with uniform heights from -2 to 2 σ_z.
pub fn flat(plasticity_index: f64) -> Scene {
    let points = [(-2.0 * SIGMA, 0.25 / SIGMA), (2.0 * SIGMA, 0.25 / SIGMA)];
    let heights = TabulatedHeights::new("flat", &points).unwrap();
    let mut scene = with_index(plasticity_index);
    scene.heights = HeightDistribution::other(heights);
    scene
}

/// A tolerance below every comparison's.
pub fn tight() -> Tolerance {
    Tolerance::new(1e-12).unwrap()
}
