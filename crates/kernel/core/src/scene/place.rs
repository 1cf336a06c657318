//! Separations and loads on a scene.

use crate::{At, ContactError, Datum, HeightDistribution, Scene, Separation, SeparationUnit};

impl SeparationUnit {
    /// Its length on a scene \[m\].
    fn length(self, scene: &Scene) -> f64 {
        match self {
            Self::Sigma => scene.surface.asperity_height_std,
            Self::Metres => 1.0,
            Self::SurfaceStd => scene.surface_height_std(),
        }
    }
}

impl Datum {
    /// Its name beside these heights.
    #[must_use]
    pub fn name(self, heights: &HeightDistribution) -> &'static str {
        match (self, heights) {
            (Self::AsperityMean, HeightDistribution::Exponential) => "the lowest asperity",
            (Self::AsperityMean, _) => "the mean of the asperity heights",
            (Self::SurfaceMean, _) => "the mean plane of the surface",
        }
    }
}

impl Separation {
    /// The same separation in another unit, from another plane.
    ///
    /// # Errors
    /// [`ContactError::NoMeanPlane`] if one of the planes is the surface's and the heights are
    /// exponential or Weibull without a `mean_plane_offset`.
    pub fn measured_in(
        self,
        unit: SeparationUnit,
        from: Datum,
        scene: &Scene,
    ) -> Result<Self, ContactError> {
        let shift = match (self.from, from) {
            (Datum::SurfaceMean, Datum::AsperityMean) => -mean_plane_offset(scene)?,
            (Datum::AsperityMean, Datum::SurfaceMean) => mean_plane_offset(scene)?,
            _ => 0.0,
        };
        // In the unit given; exact if neither unit nor plane changes.
        let length = self.unit.length(scene);
        let value = if shift == 0.0 { self.value } else { self.value + shift / length };
        let value = if self.unit == unit { value } else { value * length / unit.length(scene) };
        Ok(Self { value, unit, from })
    }

    /// d/σ_z from the mean of the asperity heights, with the rounding of the conversion.
    #[inline]
    pub(crate) fn in_sigma(self, scene: &Scene) -> Result<SeparationInSigma, ContactError> {
        let mut place = SeparationInSigma { s: self.value, rounding: 0.0 };
        if (self.unit, self.from) != (SeparationUnit::Sigma, Datum::AsperityMean) {
            place = self.converted(scene)?;
        }
        if (LOWEST..=HIGHEST).contains(&place.s) {
            Ok(place)
        } else {
            Err(ContactError::SeparationOutOfRange { separation: self, over_sigma: place.s })
        }
    }

    #[inline(never)]
    fn converted(self, scene: &Scene) -> Result<SeparationInSigma, ContactError> {
        let sigma = scene.surface.asperity_height_std;
        let s = self.measured_in(SeparationUnit::Sigma, Datum::AsperityMean, scene)?.value;
        let by_surface = self.unit == SeparationUnit::SurfaceStd;
        let mut rounding = f64::EPSILON * s.abs() * if by_surface { 3.0 } else { 1.0 };
        if self.from == Datum::SurfaceMean {
            // Either number may be larger than their difference.
            rounding += 2.0 * f64::EPSILON * (mean_plane_offset(scene)? / sigma).abs();
        }
        Ok(SeparationInSigma { s, rounding })
    }
}

/// The smallest and the largest d/σ_z that can be evaluated.
pub(crate) const LOWEST: f64 = -1e6;
pub(crate) const HIGHEST: f64 = 1e9;

fn mean_plane_offset(scene: &Scene) -> Result<f64, ContactError> {
    let without_mean_plane =
        matches!(scene.heights, HeightDistribution::Exponential | HeightDistribution::Weibull(_));
    if scene.mean_plane_offset.is_none() && without_mean_plane {
        return Err(ContactError::NoMeanPlane);
    }
    Ok(scene.mean_plane_offset())
}

/// d/σ_z from the mean of the asperity heights, with its rounding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeparationInSigma {
    pub(crate) s: f64,
    /// Bound on the absolute error of `s`.
    pub(crate) rounding: f64,
}

impl At {
    /// The load \[N\] on a scene; `None` for a separation.
    #[must_use]
    pub fn load(self, scene: &Scene) -> Option<f64> {
        match self {
            Self::Separation(_) => None,
            Self::Load(load) => Some(load),
            Self::Pressure(pressure) => Some(pressure * scene.nominal_area),
        }
    }

    /// The mean pressure \[Pa\] on the nominal area of a scene; `None` for a separation.
    #[must_use]
    pub fn pressure(self, scene: &Scene) -> Option<f64> {
        match self {
            Self::Separation(_) => None,
            Self::Load(load) => Some(load / scene.nominal_area),
            Self::Pressure(pressure) => Some(pressure),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interface, Surface};

    fn scene() -> Scene {
        Scene::new(Interface::new(1e11, 0.3, 1e9), Surface::new(1e-4, 1e9, 0.5e-6), 1e-5)
    }

    #[test]
    fn units_and_planes_lead_there_and_back() {
        let scene = scene();
        let offset = scene.surface.mean_plane_offset();
        for (unit, from) in [
            (SeparationUnit::Metres, Datum::AsperityMean),
            (SeparationUnit::Metres, Datum::SurfaceMean),
            (SeparationUnit::Sigma, Datum::SurfaceMean),
            (SeparationUnit::SurfaceStd, Datum::SurfaceMean),
        ] {
            let there = Separation::sigmas(1.7).measured_in(unit, from, &scene).unwrap();
            let place = there.in_sigma(&scene).unwrap();
            assert!((place.s - 1.7).abs() <= place.rounding && place.rounding < 3e-15);
        }
        let gap = Separation::metres(1e-6 + offset).from_surface_mean();
        assert!((gap.in_sigma(&scene).unwrap().s - 2.0).abs() < 1e-14);
        // Of an isotropic Gaussian surface, σ is the standard deviation of all heights.
        let sigma = scene.surface.moments().m0.sqrt();
        let ratio = Separation::film_ratio((1e-6 + offset) / sigma);
        assert!((ratio.in_sigma(&scene).unwrap().s - 2.0).abs() < 1e-14);
        let measured = Scene { surface_height_std: Some(2.0 * sigma), ..scene.clone() };
        let half =
            ratio.measured_in(SeparationUnit::Metres, Datum::SurfaceMean, &measured).unwrap();
        assert!((half.value / (2e-6 + 2.0 * offset) - 1.0).abs() < 1e-15);
        // A measured offset takes precedence over the isotropic Gaussian surface's.
        let measured = Scene { mean_plane_offset: Some(0.25e-6), ..scene };
        let gap = Separation::metres(1e-6).from_surface_mean();
        assert!((gap.in_sigma(&measured).unwrap().s - 1.5).abs() < 1e-14);
    }

    #[test]
    fn loads_are_pressures_on_the_nominal_area() {
        let scene = scene();
        assert_eq!(At::Pressure(2e6).load(&scene), Some(20.0));
        let pressure = At::Load(20.0).pressure(&scene).unwrap();
        assert!((pressure / 2e6 - 1.0).abs() < 1e-15);
        assert_eq!((At::Load(0.1).load(&scene), At::sigmas(1.0).load(&scene)), (Some(0.1), None));
    }

    #[test]
    fn multiples_of_sigma_are_exact_and_missing_planes_are_refused() {
        let mut scene = scene();
        let place = Separation::sigmas(0.1).in_sigma(&scene).unwrap();
        assert!(place.s.to_bits() == 0.1f64.to_bits() && place.rounding == 0.0);
        scene.heights = HeightDistribution::Exponential;
        let refused = Separation::sigmas(1.0).from_surface_mean().in_sigma(&scene).unwrap_err();
        assert_eq!(refused, ContactError::NoMeanPlane);
        for bad in [f64::NAN, 2e9, -2e6] {
            let message = Separation::sigmas(bad).in_sigma(&scene).unwrap_err().to_string();
            assert!(message.starts_with("separation is"), "{message}");
        }
        let message = Separation::metres(-1.0).in_sigma(&scene).unwrap_err().to_string();
        assert!(message.contains("-1e0 m (-2e6 asperity_height_std)"), "{message}");
    }
}
