//! The scene: interface, surface, nominal area and heights.

pub(crate) mod asperity;
pub(crate) mod hardness;
pub(crate) mod material;
pub(crate) mod pair;
pub(crate) mod place;
pub(crate) mod surface;

use serde::{Deserialize, Serialize};

use crate::error::{positive, require};
use crate::{Asperity, ContactError, HeightDistribution, Interface, Pair, Surface};

/// Two bodies, their rough surface and its nominal area.
///
/// Models of one rough surface press `surface` on a flat. Models of pairs press two surfaces on
/// each other: those of `pair`, or two like `surface`; [`of_contacts`](Self::of_contacts) has the
/// numbers of both together.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Scene {
    /// The two bodies.
    pub interface: Interface,
    /// One rough surface; where `pair` has two, the surface that is equivalent to both.
    pub surface: Surface,
    /// A_n \[m²\], > 0.
    pub nominal_area: f64,
    /// Distribution of the asperity heights; Gaussian by default.
    #[serde(default)]
    pub heights: HeightDistribution,
    /// Measured height of the mean of the asperities above the mean plane of `surface` \[m\]; by
    /// default that of an isotropic Gaussian surface.
    #[serde(default)]
    pub mean_plane_offset: Option<f64>,
    /// Measured or given standard deviation of the heights of `surface` \[m\]; by default that of
    /// an isotropic Gaussian surface.
    #[serde(default)]
    pub surface_height_std: Option<f64>,
    /// The two rough surfaces in contact, each by itself; only models of pairs use them. By default
    /// both are like `surface`.
    #[serde(default)]
    pub pair: Option<Pair>,
}

/// Distance of two atoms \[m\]: asperities with a smaller w_c are plastic from the onset of
/// contact, and smaller gaps are closed.
pub const ATOMIC_DISTANCE: f64 = 3e-10;

impl Scene {
    /// The [adhesion parameter](Self::adhesion_parameter) above which roughness hides adhesion.
    /// \[recalled\]
    pub const HIDES_ADHESION: f64 = 10.0;

    /// A scene with Gaussian heights.
    #[must_use]
    pub fn new(interface: Interface, surface: Surface, nominal_area: f64) -> Self {
        let heights = HeightDistribution::Gaussian;
        Self {
            interface,
            surface,
            nominal_area,
            heights,
            mean_plane_offset: None,
            surface_height_std: None,
            pair: None,
        }
    }

    /// Checks every field; returns one asperity of the surface.
    ///
    /// # Errors
    /// [`ContactError`] naming the field, the value and what was required.
    pub fn asperity(&self) -> Result<Asperity, ContactError> {
        self.surface.check()?;
        positive("nominal_area", self.nominal_area)?;
        let offset = self.mean_plane_offset.unwrap_or(0.0);
        require(offset.is_finite(), "mean_plane_offset", offset, "a finite number")?;
        let one = Asperity::new(&self.interface, self.surface.asperity_radius)?;
        Ok(Asperity { density: Some(self.surface.asperity_density), ..one })
    }

    /// Height of the mean of the asperities above the mean plane of `surface` \[m\].
    #[must_use]
    pub fn mean_plane_offset(&self) -> f64 {
        self.mean_plane_offset.unwrap_or_else(|| self.surface.mean_plane_offset())
    }

    /// σ \[m\]: the standard deviation of the heights of `surface` (not of its asperities); films
    /// are measured in it.
    #[must_use]
    pub fn surface_height_std(&self) -> f64 {
        self.surface_height_std.unwrap_or_else(|| self.surface.moments().m0.sqrt())
    }

    /// η A_n, the number of asperities.
    #[must_use]
    pub fn asperities(&self) -> f64 {
        self.surface.asperity_density * self.nominal_area
    }

    /// θ = E σ_z^1.5/(w_a √R), Fuller & Tabor's adhesion parameter: above
    /// [`HIDES_ADHESION`](Self::HIDES_ADHESION), roughness hides adhesion. `None` without a work of
    /// adhesion above 0. \[recalled\]
    #[must_use]
    pub fn adhesion_parameter(&self) -> Option<f64> {
        let Surface { asperity_radius: radius, asperity_height_std: sigma, .. } = self.surface;
        let work = self.interface.work_of_adhesion.filter(|work| *work > 0.0)?;
        Some(self.interface.equivalent_modulus * sigma / work * (sigma / radius).sqrt())
    }

    /// ψ = √(σ_z/w_c), the plasticity index.
    ///
    /// # Errors
    /// The errors of [`asperity`](Self::asperity) and [`Asperity::critical_interference`].
    pub fn plasticity_index(&self) -> Result<f64, ContactError> {
        let critical = self.asperity()?.critical_interference()?;
        Ok((self.surface.asperity_height_std / critical).sqrt())
    }
}
