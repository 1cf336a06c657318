//! Two rough surfaces that face each other: the numbers of each and of both together.

use std::f64::consts::FRAC_1_SQRT_2;

use serde::{Deserialize, Serialize};

use crate::error::require;
use crate::{ContactError, HeightDistribution, ProfileMoments, Scene, Surface};

/// One of two rough surfaces that face each other.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct RoughSurface {
    /// Its asperities.
    pub asperities: Surface,
    /// How far their mean lies above the mean plane of this surface \[m\], if known; by default as
    /// on an isotropic Gaussian surface.
    #[serde(default)]
    pub mean_plane_offset: Option<f64>,
    /// The standard deviation of the heights of this surface \[m\], if known; by default that of an
    /// isotropic Gaussian surface.
    #[serde(default)]
    pub surface_height_std: Option<f64>,
}

impl From<Surface> for RoughSurface {
    fn from(asperities: Surface) -> Self {
        Self { asperities, mean_plane_offset: None, surface_height_std: None }
    }
}

impl RoughSurface {
    /// The height of the mean of the asperities above the mean plane \[m\].
    #[must_use]
    pub fn mean_plane_offset(&self) -> f64 {
        self.mean_plane_offset.unwrap_or_else(|| self.asperities.mean_plane_offset())
    }

    /// The standard deviation of the heights \[m\].
    #[must_use]
    pub fn surface_height_std(&self) -> f64 {
        self.surface_height_std.unwrap_or_else(|| self.asperities.moments().m0.sqrt())
    }
}

/// Two rough surfaces that face each other, for models of pairs; other models use
/// [`Scene::surface`] alone.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Pair {
    /// Each surface by itself.
    pub surfaces: [RoughSurface; 2],
}

impl Pair {
    /// Two surfaces, in either order.
    #[must_use]
    pub fn new(first: impl Into<RoughSurface>, second: impl Into<RoughSurface>) -> Self {
        Self { surfaces: [first.into(), second.into()] }
    }

    /// How far the means of the asperities lie above the mean planes of their surfaces, both
    /// together \[m\].
    #[must_use]
    pub fn mean_plane_offset(&self) -> f64 {
        self.surfaces.iter().map(RoughSurface::mean_plane_offset).sum()
    }

    /// The standard deviation of the sum of the heights of two asperities \[m\]: the unit of
    /// separations.
    #[must_use]
    pub fn asperity_height_std(&self) -> f64 {
        let [first, second] = self.surfaces.map(|one| one.asperities.asperity_height_std);
        first.hypot(second)
    }

    /// σ \[m\]: the standard deviation of the sum of the surface heights, in which films are
    /// measured.
    #[must_use]
    pub fn surface_height_std(&self) -> f64 {
        let [first, second] = self.surfaces.map(|one| one.surface_height_std());
        first.hypot(second)
    }

    /// (σ₂/σ)²: the share of the second surface in the mean square of all heights.
    #[must_use]
    pub fn share_of_second(&self) -> f64 {
        let [first, second] = self.surfaces.map(|one| one.surface_height_std().powi(2));
        second / (first + second)
    }

    /// The moments of the profiles of both surfaces together.
    #[must_use]
    pub fn moments(&self) -> ProfileMoments {
        let [first, second] = self.surfaces.map(|one| one.asperities.moments());
        ProfileMoments { m0: self.surface_height_std().powi(2), ..first.plus(&second) }
    }
}

impl Scene {
    /// Both rough surfaces: those of [`pair`](Self::pair), or two like [`surface`](Self::surface),
    /// each with the offset and the standard deviation of the heights of this scene.
    #[must_use]
    pub fn both_surfaces(&self) -> Pair {
        let Self { mean_plane_offset, surface_height_std, .. } = *self;
        let one = RoughSurface { mean_plane_offset, surface_height_std, ..self.surface.into() };
        self.pair.unwrap_or(Pair::new(one, one))
    }

    /// The scene of the contacts between [both surfaces](Self::both_surfaces), from which models of
    /// pairs and the factors of flow between two surfaces have every length: the radius R of the
    /// contacts, the density of two like surfaces with as many contacts, √(η₁ η₂ (β₁ + β₂)/(4R)),
    /// the standard deviations of the sums, and the offset of both mean planes. Of such a scene it
    /// is the same scene again.
    ///
    /// # Errors
    /// [`ContactError::OutOfRange`] for a number of either surface that is out of range.
    pub fn of_contacts(&self) -> Result<Self, ContactError> {
        let pair = self.both_surfaces();
        let [first, second] = pair.surfaces.map(|one| one.asperities);
        first.check()?;
        second.check()?;
        let radii = first.asperity_radius + second.asperity_radius;
        let radius = first.asperity_radius * (second.asperity_radius / radii);
        let densities = first.asperity_density.sqrt() * second.asperity_density.sqrt();
        let density = densities * (radii / (4.0 * radius)).sqrt();
        let std = pair.asperity_height_std();
        let offset = pair.mean_plane_offset();
        require(offset.is_finite(), "mean_plane_offset", offset, "a finite number")?;
        let like = RoughSurface {
            asperities: Surface::new(2.0 * radius, density, FRAC_1_SQRT_2 * std),
            mean_plane_offset: Some(0.5 * offset),
            surface_height_std: Some(FRAC_1_SQRT_2 * pair.surface_height_std()),
        };
        let gaussian = matches!(self.heights, HeightDistribution::Gaussian);
        Ok(Self {
            heights: self.heights.clone(),
            // Other heights may have none, which stays unknown.
            mean_plane_offset: Some(offset)
                .filter(|_| gaussian || self.mean_plane_offset.is_some()),
            surface_height_std: Some(pair.surface_height_std()),
            pair: Some(Pair::new(like, like)),
            ..Self::new(self.interface, Surface::new(radius, density, std), self.nominal_area)
        })
    }
}
