//! The asperities of two rough surfaces, each by itself.

use std::f64::consts::FRAC_1_SQRT_2;

use serde::{Deserialize, Serialize};

use crate::{Scene, Surface};

/// The asperities of two rough surfaces that face each other, each by itself: for models of pairs.
/// Other models use [`Scene::surface`] alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Pair {
    /// Radius, density and height standard deviation of the asperities of each surface.
    pub surfaces: [Surface; 2],
    /// How far the means of the asperity heights lie above the mean planes of their surfaces, both
    /// together \[m\], if measured; by default those of isotropic Gaussian surfaces.
    #[serde(default)]
    pub mean_plane_offset: Option<f64>,
    /// σ \[m\]: the standard deviation of the surface heights of both together, if known; by
    /// default that of isotropic Gaussian surfaces.
    #[serde(default)]
    pub surface_height_std: Option<f64>,
}

impl Pair {
    /// Two surfaces, in either order.
    #[must_use]
    pub fn new(first: Surface, second: Surface) -> Self {
        Self { surfaces: [first, second], mean_plane_offset: None, surface_height_std: None }
    }

    /// The height of both together above their mean planes \[m\], measured or of isotropic
    /// Gaussian surfaces.
    #[must_use]
    pub fn mean_plane_offset(&self) -> f64 {
        let gaussian = || self.surfaces.iter().map(Surface::mean_plane_offset).sum();
        self.mean_plane_offset.unwrap_or_else(gaussian)
    }

    /// σ of both together \[m\], known or of isotropic Gaussian surfaces.
    #[must_use]
    pub fn surface_height_std(&self) -> f64 {
        let gaussian = || self.surfaces.iter().map(|surface| surface.moments().m0).sum::<f64>();
        self.surface_height_std.unwrap_or_else(|| gaussian().sqrt())
    }
}

impl Scene {
    /// The asperities of both surfaces: those given as [`pair`](Self::pair), or two like surfaces
    /// with the radius and density of [`surface`](Self::surface), whose `asperity_height_std` is
    /// that of the sum of both heights.
    #[must_use]
    pub fn both_surfaces(&self) -> Pair {
        self.pair.unwrap_or_else(|| {
            let Surface { asperity_radius, asperity_density, asperity_height_std } = self.surface;
            let std = FRAC_1_SQRT_2 * asperity_height_std;
            let one = Surface::new(asperity_radius, asperity_density, std);
            let mean_plane_offset = self.mean_plane_offset.map(|offset| 2.0 * offset);
            Pair { mean_plane_offset, ..Pair::new(one, one) }
        })
    }
}
