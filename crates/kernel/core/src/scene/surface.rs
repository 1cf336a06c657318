//! The equivalent rough surface, and the ways to arrive at it.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use crate::error::{positive, require};
use crate::{Asperity, ContactError, Interface};

/// σ_z² = σ² - SUMMIT_VARIANCE/(ηR)² for an isotropic Gaussian surface. \[seen, derived\]
const SUMMIT_VARIANCE: f64 = BANDWIDTH_LOSS / (768.0 * PI);
/// Mean of the asperity heights above the surface's mean plane, times ηR: 1/(4√3 π). \[seen,
/// derived\]
const SUMMIT_MEAN: f64 = 0.045_944_074_618_482_67;
/// σ_z² = (1 - `BANDWIDTH_LOSS`/α) m₀. \[derived\]
const BANDWIDTH_LOSS: f64 = 1.0 - 3.0 * SQRT_3 + 16.0 / PI;
const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Asperities of one radius on a nominally flat surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[non_exhaustive]
pub struct Surface {
    /// R \[m\], > 0: 1/R = 1/R₁ + 1/R₂ of the two surfaces' asperities.
    pub asperity_radius: f64,
    /// η \[1/m²\], > 0.
    pub asperity_density: f64,
    /// σ_z \[m\], > 0: standard deviation of the asperity heights (not of the surface heights).
    pub asperity_height_std: f64,
}

/// Spectral moments of profiles: averages over the profile of z², z'² and z''².
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProfileMoments {
    /// ⟨z²⟩ \[m²\].
    pub m0: f64,
    /// ⟨z'²⟩.
    pub m2: f64,
    /// ⟨z''²⟩ \[1/m²\].
    pub m4: f64,
}

impl ProfileMoments {
    /// Bandwidth α = m₀ m₄/m₂².
    #[must_use]
    pub fn bandwidth(&self) -> f64 {
        self.m0 * (self.m4 / self.m2) / self.m2
    }

    /// The moments of the gap between this surface and an independent second one.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self { m0: self.m0 + other.m0, m2: self.m2 + other.m2, m4: self.m4 + other.m4 }
    }
}

impl Surface {
    /// From the three numbers the models use.
    #[must_use]
    pub fn new(asperity_radius: f64, asperity_density: f64, asperity_height_std: f64) -> Self {
        Self { asperity_radius, asperity_density, asperity_height_std }
    }

    /// From the plasticity index ψ = (2E/(πSH)) √(σ_z/R), the roughness parameter β_z = η R σ_z
    /// and σ_z \[m\]: the radius follows from ψ, the density from β_z.
    ///
    /// # Errors
    /// [`ContactError`] naming the input that is not positive, or a field of the interface.
    pub fn from_plasticity_index(
        plasticity_index: f64,
        roughness_parameter: f64,
        asperity_height_std: f64,
        interface: &Interface,
    ) -> Result<Self, ContactError> {
        positive("plasticity_index", plasticity_index)?;
        positive("roughness_parameter", roughness_parameter)?;
        positive("asperity_height_std", asperity_height_std)?;
        let asperity = Asperity::new(interface, 1.0)?;
        let (hardness, factor) = (asperity.hardness()?, asperity.pressure_factor);
        // ψ² = σ_z/w_c and w_c = (strain)² R.
        let strain =
            std::f64::consts::PI * factor * hardness / (2.0 * interface.equivalent_modulus);
        let asperity_radius = asperity_height_std / (plasticity_index * strain).powi(2);
        let asperity_density = roughness_parameter / (asperity_radius * asperity_height_std);
        Ok(Self { asperity_radius, asperity_density, asperity_height_std })
    }

    /// From the spectral moments of profiles of an isotropic Gaussian surface:
    /// η = m₄/(6√3 π m₂), R = (3/8) √(π/m₄), σ_z² = (1 - 0.8968/α) m₀. \[derived\]
    ///
    /// # Errors
    /// [`ContactError`] when a moment is not positive, or when α < 1.5 (β = ηRσ < 0.02493):
    /// no isotropic Gaussian surface has such moments.
    pub fn from_moments(moments: &ProfileMoments) -> Result<Self, ContactError> {
        let ProfileMoments { m0, m2, m4 } = *moments;
        positive("m0", m0)?;
        positive("m2", m2)?;
        positive("m4", m4)?;
        let bandwidth = moments.bandwidth();
        // β of 0.02493, and σ_z² is 0.402 σ² there.
        let required = "at least 1.5, as of every isotropic Gaussian surface (asperity_density times asperity_radius times asperity_height_std of at least 0.0158),";
        require(bandwidth >= 1.5, "bandwidth (m0 m4/m2^2)", bandwidth, required)?;
        Ok(Self {
            asperity_radius: 0.375 * (std::f64::consts::PI / m4).sqrt(),
            asperity_density: m4 / (6.0 * 3f64.sqrt() * std::f64::consts::PI * m2),
            asperity_height_std: ((1.0 - BANDWIDTH_LOSS / bandwidth) * m0).sqrt(),
        })
    }

    /// From radius \[m\], density \[1/m²\] and the standard deviation of the surface heights σ
    /// \[m\] (not of the asperities): σ_z² = σ² - 3.717e-4/(ηR)². \[seen, derived\]
    ///
    /// # Errors
    /// [`ContactError`] when an input is not positive, or when β = ηRσ < 0.02493.
    pub fn from_surface_std(
        asperity_radius: f64,
        asperity_density: f64,
        surface_height_std: f64,
    ) -> Result<Self, ContactError> {
        positive("asperity_radius", asperity_radius)?;
        positive("asperity_density", asperity_density)?;
        positive("surface_height_std", surface_height_std)?;
        let per_length = asperity_density * asperity_radius;
        let beta = per_length * surface_height_std;
        let field = "asperity_density times asperity_radius times surface_height_std";
        let required = "at least 0.02493, as of every isotropic Gaussian surface,";
        require(beta >= 0.024_93, field, beta, required)?;
        let share = 1.0 - SUMMIT_VARIANCE / (beta * beta);
        let asperity_height_std = surface_height_std * share.sqrt();
        Ok(Self { asperity_radius, asperity_density, asperity_height_std })
    }

    /// From the numbers that correlations of conductance use, and the density of the summits: the
    /// standard deviation of the surface heights σ \[m\], the mean absolute slope of profiles m and
    /// η \[1/m²\] of an isotropic Gaussian surface: m₀ = σ², m₂ = π m²/2, m₄ = 6√3 π η m₂.
    /// \[derived\]
    ///
    /// # Errors
    /// [`ContactError`] when an input is not positive; the errors of
    /// [`from_moments`](Self::from_moments).
    pub fn from_mean_slope(
        surface_height_std: f64,
        mean_slope: f64,
        asperity_density: f64,
    ) -> Result<Self, ContactError> {
        let m0 = positive("surface_height_std", surface_height_std)?.powi(2);
        let m2 = 0.5 * std::f64::consts::PI * positive("mean_slope", mean_slope)?.powi(2);
        let density = positive("asperity_density", asperity_density)?;
        let m4 = 6.0 * 3f64.sqrt() * std::f64::consts::PI * density * m2;
        Self::from_moments(&ProfileMoments { m0, m2, m4 })
    }

    /// The moments of the profiles of an isotropic Gaussian surface with these asperities: what
    /// [`from_moments`](Self::from_moments) inverts.
    #[must_use]
    pub fn moments(&self) -> ProfileMoments {
        let m4 = (0.375 / self.asperity_radius).powi(2) * std::f64::consts::PI;
        let m2 = m4 / (6.0 * 3f64.sqrt() * std::f64::consts::PI * self.asperity_density);
        let m0 = self.asperity_height_std.powi(2) + BANDWIDTH_LOSS * m2 * (m2 / m4);
        ProfileMoments { m0, m2, m4 }
    }

    /// The range of β = η R σ, with the standard deviation σ of all heights, where rough surfaces
    /// are found: β = 0.0204 √α of isotropic Gaussian surfaces, from the narrowest spectrum
    /// (α = 1.5) to α = 24 \[derived\]; Greenwood & Williamson (1966) give 0.03 to 0.05
    /// \[recalled\].
    pub const USUAL_ROUGHNESS: [f64; 2] = [0.02, 0.1];

    /// The same range of β_z = √(1 - 0.8968/α) β, with the standard deviation of the asperity
    /// heights: 0.0158 to 0.098 \[derived\].
    pub const USUAL_ASPERITY_ROUGHNESS: [f64; 2] = [0.0158, 0.1];

    /// √(2 m₂) of an isotropic Gaussian surface with these asperities: its rms gradient.
    #[must_use]
    pub fn rms_gradient(&self) -> f64 {
        (2.0 * self.moments().m2).sqrt()
    }

    /// β_z = η R σ_z; usually in [`USUAL_ASPERITY_ROUGHNESS`](Self::USUAL_ASPERITY_ROUGHNESS).
    #[must_use]
    pub fn roughness_parameter(&self) -> f64 {
        self.asperity_density * self.asperity_radius * self.asperity_height_std
    }

    /// y_s \[m\]: how far the mean of the asperity heights lies above the mean plane of an
    /// isotropic Gaussian surface. A separation h from that plane is d = h - y_s here.
    #[must_use]
    pub fn mean_plane_offset(&self) -> f64 {
        SUMMIT_MEAN / (self.asperity_density * self.asperity_radius)
    }

    /// # Errors
    /// [`ContactError`] naming the field that is not finite and positive.
    pub fn check(&self) -> Result<(), ContactError> {
        positive("asperity_radius", self.asperity_radius)?;
        positive("asperity_density", self.asperity_density)?;
        positive("asperity_height_std", self.asperity_height_std)?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_papers_surface_has_the_radius_of_its_plasticity_index() {
        let mut interface = Interface::new(116e9, 0.31, 1.12e9);
        interface.pressure_factor = Some(0.58);
        let surface = Surface::from_plasticity_index(6.0, 0.04, 1e-6, &interface).unwrap();
        assert!((surface.asperity_radius / 3.589_894_5e-4 - 1.0).abs() < 1e-7);
        assert!((surface.asperity_density / 1.114_238_86e8 - 1.0).abs() < 1e-7);
        assert!((surface.roughness_parameter() - 0.04).abs() < 1e-15);
    }

    #[test]
    fn a_mean_slope_leads_to_the_moments_of_gaussian_profiles() {
        let surface = Surface::from_mean_slope(1.5e-6, 0.1, 2e9).unwrap();
        let moments = surface.moments();
        // The mean of |x| of a normal x is √(2/π) standard deviations.
        let slope = (2.0 * moments.m2 / std::f64::consts::PI).sqrt();
        for (found, given) in
            [(slope, 0.1), (moments.m0.sqrt(), 1.5e-6), (surface.asperity_density, 2e9)]
        {
            assert!((found / given - 1.0).abs() < 1e-14, "{found}");
        }
        let refused = Surface::from_mean_slope(1.5e-6, 0.0, 2e9).unwrap_err().to_string();
        assert!(refused.starts_with("mean_slope is 0"), "{refused}");
    }

    #[test]
    fn moments_agree_with_the_route_over_surface_heights() {
        // α = 768 π β², and both routes give the same σ_z. [derived]
        let moments = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 5e4 };
        let a = Surface::from_moments(&moments).unwrap();
        let b = Surface::from_surface_std(a.asperity_radius, a.asperity_density, 1e-6).unwrap();
        assert!((a.asperity_height_std / b.asperity_height_std - 1.0).abs() < 1e-6);
        let beta = a.asperity_density * a.asperity_radius * 1e-6;
        assert!(
            (moments.bandwidth() / (768.0 * std::f64::consts::PI * beta * beta) - 1.0).abs()
                < 1e-12
        );
        let back = a.moments();
        for (found, given) in [(back.m0, moments.m0), (back.m2, moments.m2), (back.m4, moments.m4)]
        {
            assert!((found / given - 1.0).abs() < 1e-14, "{back:?}");
        }
        let offset = 4.0 * (moments.m0 / (std::f64::consts::PI * moments.bandwidth())).sqrt();
        assert!((a.mean_plane_offset() / offset - 1.0).abs() < 1e-6);
    }

    #[test]
    fn the_narrowest_surface_has_the_roughness_that_a_refusal_names() {
        let narrow = ProfileMoments { m0: 1e-12, m2: 1e-4, m4: 1.4e4 };
        let refused = Surface::from_moments(&narrow);
        assert!(matches!(refused, Err(ContactError::OutOfRange { value: 1.4, .. })), "{refused:?}");
        let narrowest = ProfileMoments { m4: 1.500_001e4, ..narrow };
        let least = Surface::from_moments(&narrowest).unwrap().roughness_parameter();
        assert!((least - 0.0158).abs() < 5e-5, "{least}");
    }
}
