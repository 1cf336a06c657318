//! The scenes of `reference/models_scenes.csv`, and ways to make others.

use asperity::{Interface, Scene, Surface};

/// The scene of this name.
pub fn named(name: &str) -> Scene {
    let table = include_str!("../reference/models_scenes.csv");
    let row = table.lines().find(|line| line.starts_with(&format!("{name},"))).unwrap();
    let mut numbers = row.split(',').skip(1).map(|field| field.parse::<f64>().unwrap());
    let mut next = || numbers.next().unwrap();
    let mut interface = Interface::new(next(), 0.0, 0.0);
    interface.equivalent_shear_modulus = Some(next());
    interface.poissons_ratio = next();
    interface.hardness = Some(next());
    interface.pressure_factor = Some(next());
    let surface = Surface::new(next(), next(), next());
    Scene::new(interface, surface, next())
}
