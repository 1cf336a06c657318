//! The surfaces, materials and loads of the truth report.

use anyhow::Result;
use asperity::bem::{Bem, Continuation, RandomSurface};
use asperity::{Interface, Model, Persson, PerssonVariance, Scene, Surface};

/// The extent of the evidence.
#[derive(Debug, Clone, Copy)]
pub struct Scope {
    /// Pixels per side.
    pub pixels: usize,
    /// For each surface the longest waves and the roll-off, in waves per side.
    pub waves: &'static [[f64; 2]],
    /// Number of surfaces with the same moments.
    pub seeds: u64,
    /// Plasticity indices; 0 for no hardness.
    pub indices: &'static [f64],
    /// Pressures over E g.
    pub loads: &'static [f64],
}

/// The committed evidence: narrow, medium and broad spectra.
pub const FULL: Scope = Scope {
    pixels: 512,
    waves: &[[14.0, 14.0], [4.0, 8.0], [2.0, 2.4]],
    seeds: 4,
    indices: &[0.0, 1.0, 2.0, 4.0],
    loads: &[1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2],
};

/// The small case, which tests solve again.
pub const SMALL: Scope = Scope {
    pixels: 128,
    waves: &[[3.0, 4.0]],
    seeds: 2,
    indices: &[0.0, 2.0],
    loads: &[0.02, 0.1],
};

/// Pixels per shortest wave.
pub const PIXELS_PER_WAVE: usize = 8;
/// Root mean square gradient. E g is the unit of pressures, so that neither E nor g changes a
/// result.
pub const GRADIENT: f64 = 0.05;
/// E \[Pa\].
pub const MODULUS: f64 = 1e11;
const POISSON: f64 = 0.3;

/// The surface with these waves; a seed determines its heights.
pub fn surface(scope: &Scope, [longest, roll_off]: [f64; 2]) -> Result<RandomSurface> {
    let shortest = (scope.pixels / PIXELS_PER_WAVE) as f64;
    Ok(RandomSurface::new(longest, roll_off, shortest)?.side(1e-4)?.gradient(GRADIENT)?)
}

/// The scene of a surface and a plasticity index, which determines the hardness: steel on steel.
pub fn scene(surface: &RandomSurface, index: f64) -> Result<Scene> {
    let mut interface = Interface::elastic(MODULUS, POISSON);
    // Two equal materials.
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

/// The boundary elements of one surface.
pub fn bem(scope: &Scope, surface: RandomSurface, seed: u64) -> Result<Bem> {
    let map = surface.seed(seed).heights(scope.pixels)?;
    Ok(Bem::new(map, Some(Continuation::Periodic), false))
}

/// Every model that is compared with boundary elements. Persson's spectrum is a power law, as that
/// of the solved surfaces beyond their roll-off.
#[must_use]
pub fn models() -> Vec<Model> {
    let hurst_exponent = Some(RandomSurface::HURST);
    let whole = PerssonVariance::ALL
        .map(|variance| Model::known(Persson { variance, hurst_exponent, spectrum: None }));
    [Model::all(), Model::all_random(), whole.to_vec()].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn surfaces_and_materials_have_the_bandwidths_and_indices_of_the_evidence() -> Result<()> {
        let mut cases = asperity::Evidence::committed()?.cases().iter();
        // Independent numbers, because the evidence was made by the function under test.
        for (waves, alpha) in FULL.waves.iter().zip([3.0, 7.5, 29.0]) {
            let found = surface(&FULL, *waves)?.moments().bandwidth();
            assert!((found / alpha - 1.0).abs() < 0.05, "{found} {alpha}");
            let listed = cases.find(|case| (case.alpha / found - 1.0).abs() < 1e-6);
            assert!(listed.is_some(), "{found}");
        }
        for index in [1.0, 2.0, 4.0] {
            let found = scene(&surface(&FULL, FULL.waves[1])?, index)?.plasticity_index()?;
            assert!((found / index - 1.0).abs() < 1e-12, "{found}");
        }
        Ok(())
    }
}
