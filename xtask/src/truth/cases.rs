//! The surfaces, materials and loads of the truth report.

use anyhow::Result;
use asperity::bem::{Bem, Boundary, RandomSurface};
use asperity::{Interface, Scene, Surface};

/// How much is solved.
#[derive(Debug, Clone, Copy)]
pub struct Scope {
    /// Pixels per side.
    pub pixels: usize,
    /// The longest waves, per side, and where the power law begins; one surface each.
    pub waves: &'static [[f64; 2]],
    /// So many surfaces with the same moments.
    pub seeds: u64,
    /// Plasticity indices; 0 for no hardness.
    pub indices: &'static [f64],
    /// Pressures over E g.
    pub loads: &'static [f64],
}

/// What is committed: narrow, medium and broad spectra.
pub const FULL: Scope = Scope {
    pixels: 512,
    waves: &[[14.0, 14.0], [4.0, 8.0], [2.0, 2.4]],
    seeds: 4,
    indices: &[0.0, 1.0, 2.0, 4.0],
    loads: &[1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2],
};

/// What tests solve again.
pub const SMALL: Scope = Scope {
    pixels: 128,
    waves: &[[3.0, 4.0]],
    seeds: 2,
    indices: &[0.0, 2.0],
    loads: &[0.02, 0.1],
};

/// Pixels per wave of the shortest.
pub const PIXELS_PER_WAVE: usize = 8;
/// Root mean square gradient; E g is the unit of pressures, so that it matters no more than E.
pub const GRADIENT: f64 = 0.05;
/// E \[Pa\].
pub const MODULUS: f64 = 1e11;
const POISSON: f64 = 0.3;

/// The surface of these waves; its heights are those of a seed.
pub fn surface(scope: &Scope, [longest, roll_off]: [f64; 2]) -> Result<RandomSurface> {
    let shortest = (scope.pixels / PIXELS_PER_WAVE) as f64;
    Ok(RandomSurface::new(longest, roll_off, shortest)?.side(1e-4)?.gradient(GRADIENT)?)
}

/// The scene of a surface and a plasticity index: steel on steel but for the hardness.
pub fn scene(surface: &RandomSurface, index: f64) -> Result<Scene> {
    let mut interface = Interface::elastic(MODULUS, POISSON);
    // Of two equal materials.
    interface.equivalent_shear_modulus = Some(MODULUS * (1.0 - POISSON) / (2.0 * (2.0 - POISSON)));
    let surface = Surface::from_moments(&surface.moments())?;
    let mut scene = Scene::new(interface, surface, 1e-8);
    if index > 0.0 {
        // ψ is inversely proportional to the hardness.
        scene.interface.hardness = Some(1e9);
        scene.interface.hardness = Some(1e9 * scene.plasticity_index()? / index);
    }
    Ok(scene)
}

/// One of the surfaces, to be pressed.
pub fn bem(scope: &Scope, surface: RandomSurface, seed: u64) -> Result<Bem> {
    let map = surface.seed(seed).heights(scope.pixels)?;
    Ok(Bem::new(map, Boundary::Periodic, false))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_are_as_broad_and_materials_as_hard_as_is_said() -> Result<()> {
        let mut cases = asperity::Evidence::committed()?.cases().iter();
        // Numbers of their own, as the evidence was made by the function that is tested here.
        for (waves, alpha) in FULL.waves.iter().zip([3.0, 7.5, 29.0]) {
            let found = surface(&FULL, *waves)?.moments().bandwidth();
            assert!((found / alpha - 1.0).abs() < 0.05, "{found} {alpha}");
            let known = cases.find(|case| (case.alpha / found - 1.0).abs() < 1e-6);
            assert!(known.is_some(), "{found}");
        }
        for index in [1.0, 2.0, 4.0] {
            let found = scene(&surface(&FULL, FULL.waves[1])?, index)?.plasticity_index()?;
            assert!((found / index - 1.0).abs() < 1e-12, "{found}");
        }
        Ok(())
    }
}
