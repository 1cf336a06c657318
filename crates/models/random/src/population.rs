//! The constants of the summit density for a scene, and the scene of the averaged law.

use asperity_core::{ContactError, HeightDistribution, Scene, Surface};

/// Distance below u = 0 of the origin of interferences, in standard deviations of μ k_m.
pub(crate) const BEGIN: f64 = 11.5;
/// Start of the averaged law on that scale, in the first cell of its tables. At a separation of
/// [`FARTHEST`](crate::FARTHEST) √m₀ and a correlation ρ of height and curvature, contacts come
/// from 6ρ ± 8√(1-ρ²), at most 10 below u = 0.
pub(crate) const FIRST: f64 = 1.0;

/// The constants of the summit density of a scene's surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Population {
    /// √m₀ \[m\].
    pub(crate) surface_std: f64,
    /// √(m₄/3) \[1/m\], the unit of curvatures.
    pub(crate) curvature: f64,
    /// v = μ √(2 m₄/3) \[m\], the standard deviation of μ k_m: the unit of interferences.
    pub(crate) unit: f64,
    /// σ_c \[m\].
    pub(crate) height_std: f64,
}

impl Population {
    pub(crate) fn new(scene: &Scene) -> Result<Self, ContactError> {
        scene.asperity()?;
        let moments = scene.surface.moments();
        // Refuses bandwidths below 1.5.
        Surface::from_moments(&moments)?;
        let curvature = (moments.m4 / 3.0).sqrt();
        let unit = 1.5 * moments.m2 / moments.m4 * std::f64::consts::SQRT_2 * curvature;
        // v² = (3/2) m₂²/m₄ is the part of m₀ that is correlated with the curvature.
        let height_std = (moments.m0 - unit * unit).max(0.0).sqrt();
        Ok(Self { surface_std: moments.m0.sqrt(), curvature, unit, height_std })
    }

    /// Asperities of the radius 1/√(m₄/3), under heights independent of the curvature.
    pub(crate) fn scene(&self, scene: &Scene) -> Scene {
        let density = scene.surface.asperity_density;
        let surface = Surface::new(1.0 / self.curvature, density, self.height_std);
        let mut own = Scene::new(scene.interface, surface, scene.nominal_area);
        own.heights = HeightDistribution::Gaussian;
        own
    }

    /// The separation from the mean plane of the surface, less that from the mean of those heights,
    /// at the same place \[m\].
    pub(crate) fn begin(&self) -> f64 {
        BEGIN * self.unit
    }
}
