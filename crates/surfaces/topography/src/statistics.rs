//! Statistics of a surface: heights, moments, outliers, asperities.

use asperity_core::{Code, Finding, ProfileMoments, Surface};
use serde::ser::{SerializeMap, Serializer};
use serde::{Deserialize, Serialize};

use crate::error::named;
use crate::{Moments, Outliers, Summits, Topography, TopographyError, warning};

/// Range of rms slopes of scans, from polished to blasted surfaces.
const SLOPE: [f64; 2] = [5e-4, 1.0];
/// Kurtosis above which a few points dominate: exponential heights have 9, honed ones up to 20.
const FAT: f64 = 30.0;

/// How asperities are found in a measured surface.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Estimator {
    /// From the spectral moments of profiles, after McCool:
    /// [`Surface::from_moments`].
    #[default]
    Moments,
    /// From the summits of the surface: [`Topography::summits`](Topography::summits).
    Summits,
}

named!(Estimator, "estimator");

/// Statistics of a surface, in SI units.
///
/// Serialisation has the [numbers](Self::numbers) up to `beta_z`, `missing_share`, `despiked` and
/// `outliers`; those of asperities are null where the estimator finds none: a sphere, a wave or a
/// step has heights and moments all the same.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Statistics {
    /// Sq \[m\]: standard deviation of the heights about their mean.
    pub sq: f64,
    /// Ssk: skewness of the heights.
    pub ssk: f64,
    /// Sku: kurtosis of the heights, 3 for a Gaussian surface.
    pub sku: f64,
    /// The moments of profiles, by direction, and the areal ones.
    pub moments: Moments,
    /// Share of the points that are missing or were filled, 0 to 1.
    pub missing_share: f64,
    /// The number of outliers that were replaced.
    pub despiked: usize,
    /// The outliers that remain: of the surface or, of two surfaces, together.
    pub outliers: Outliers,
    /// Height of the mean of the asperities above the mean plane \[m\], of the summits found or of
    /// a Gaussian surface with these moments.
    pub mean_plane_offset: Option<f64>,
    /// The estimator of the asperities.
    pub estimator: Estimator,
    /// The asperities, or the reason why the estimator finds none.
    pub(crate) asperities: Result<Surface, String>,
    /// Findings of these numbers.
    pub warnings: Vec<Finding>,
}

impl Serialize for Statistics {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let [numbers @ .., _despiked, _count, _largest, _share] = self.numbers();
        for number in numbers {
            map.serialize_entry(number.name, &number.value)?;
        }
        map.serialize_entry("despiked", &self.despiked)?;
        map.serialize_entry("outliers", &self.outliers)?;
        map.end()
    }
}

impl Topography {
    /// Heights, moments and asperities of the surface, which should be
    /// [levelled](Topography::level). A surface may have no asperities, by this estimator or by the
    /// other one: that is a [`Finding`], and an error of [`Statistics::surface`].
    ///
    /// Where [outliers](Topography::outliers) matter, the first warning is about them, and no other
    /// one is drawn from heights that they determine.
    ///
    /// # Errors
    /// As [`Topography::moments`]; [`TopographyError::Flat`] when all heights are equal.
    pub fn statistics(&self, estimator: Estimator) -> Result<Statistics, TopographyError> {
        let moments = self.moments()?;
        let mean = self.mean();
        let m0 = moments.profile.m0;
        if m0 <= 0.0 {
            return Err(TopographyError::Flat { points: self.measured() });
        }
        let ssk = self.central_moment(mean, 3) / m0.powf(1.5);
        let sku = self.central_moment(mean, 4) / (m0 * m0);
        let by_moments = Surface::from_moments(&moments.profile).map_err(TopographyError::Moments);
        let summits = self.summits();
        let by_summits = summits.as_ref().map_err(|_| TopographyError::SummitsOfProfile);
        let by_summits = by_summits.and_then(Summits::surface);
        let disagree = match (&by_moments, &by_summits) {
            (Ok(moments), Ok(summits)) => warning::estimators_disagree(moments, summits),
            _ => None,
        };
        let measured = || Some(summits.as_ref().ok()?.mean() - mean);
        let (primary, other) = match estimator {
            Estimator::Moments => (by_moments, by_summits),
            Estimator::Summits => (by_summits, by_moments),
        };
        let primary = primary.map_err(|reason| reason.to_string());
        let mut statistics = Statistics::new([ssk, sku], moments, estimator, primary);
        if estimator == Estimator::Summits {
            statistics.mean_plane_offset = statistics.mean_plane_offset.and_then(|_| measured());
        }
        statistics.missing_share = self.missing_share() + self.filled_share();
        statistics.despiked = self.despiked;
        statistics.outliers = self.outliers();
        let notes = self.notes().iter().cloned().chain(warning::filled(self.filled_share()));
        if let Some(found) = warning::outliers(&statistics.outliers) {
            let clean = self.clone().without_points(&statistics.outliers.points);
            let anisotropic = clean.moments().ok().and_then(|of| warning::anisotropic(&of));
            statistics.warnings = [Some(found), anisotropic].into_iter().flatten().collect();
            statistics.warnings.extend(notes);
            return Ok(statistics);
        }
        // Without a warning for a profile: summits need 8 neighbours.
        let single = match (&statistics.asperities, other) {
            (Ok(_), Err(error)) if !self.is_profile() => Some(warning::no_second_estimator(&error)),
            _ => None,
        };
        statistics.warnings.extend(notes.chain(self.sampling()).chain(disagree).chain(single));
        Ok(statistics)
    }

    /// A warning if the sampling determines the asperities.
    fn sampling(&self) -> Option<Finding> {
        if self.is_profile() {
            // Noise has 16 times the m4 at half the pixel size, a smooth profile the same.
            let m4 = |step| Some(self.at_distance(step)[1][0]?.powi(2));
            let of = (Code::CurvatureFollowsSampling, "m4");
            return warning::follows_sampling(of, [m4(1)?, m4(2)?], 4.0);
        }
        // Noise has 4 times the summits at half the pixel size, a smooth surface the same.
        let densities = [self.summit_density(1)?, self.summit_density(2)?];
        warning::follows_sampling((Code::SummitsFollowSampling, "summit_density"), densities, 2.0)
    }
}

impl Statistics {
    /// Statistics of one surface, or of the gap of two, without missing points, outliers or a
    /// second estimator.
    fn new(
        [ssk, sku]: [f64; 2],
        moments: Moments,
        estimator: Estimator,
        asperities: Result<Surface, String>,
    ) -> Self {
        let without = asperities.as_ref().err().map(|reason| warning::no_asperities(reason));
        let mut statistics = Self {
            sq: moments.profile.m0.sqrt(),
            ssk,
            sku,
            moments,
            missing_share: 0.0,
            despiked: 0,
            outliers: Outliers::default(),
            mean_plane_offset: asperities.as_ref().ok().map(Surface::mean_plane_offset),
            estimator,
            asperities,
            warnings: vec![],
        };
        let beta = statistics.beta().and_then(warning::roughness_parameter);
        let found = [without, beta, warning::anisotropic(&moments)];
        statistics.warnings = found.into_iter().flatten().collect();
        statistics
    }

    /// β = η R Sq.
    pub(crate) fn beta(&self) -> Option<f64> {
        let surface = self.asperities.as_ref().ok()?;
        Some(surface.asperity_density * surface.asperity_radius * self.sq)
    }

    /// The asperities as a surface for a scene.
    ///
    /// # Errors
    /// [`TopographyError::NoAsperities`] with the reason why the estimator finds none: that of
    /// [`Summits::surface`](crate::Summits::surface), or [`TopographyError::Moments`] where no
    /// isotropic Gaussian surface has such moments.
    pub fn surface(&self) -> Result<Surface, TopographyError> {
        self.asperities.clone().map_err(TopographyError::NoAsperities)
    }

    /// The statistics of an isotropic Gaussian surface with these moments of profiles, to
    /// [combine](Self::combined) with those of a scan.
    #[must_use]
    pub fn gaussian(moments: ProfileMoments) -> Self {
        let surface = Surface::from_moments(&moments).map_err(|reason| reason.to_string());
        Self::new([0.0, 3.0], Moments::isotropic(moments), Estimator::Moments, surface)
    }

    /// The statistics of the gap of two rough surfaces in contact, as one rough surface.
    /// The surfaces are independent, with heights positive away from the body: moments and
    /// cumulants add. The asperities follow from the summed moments. `missing_share` is the share
    /// of pairs of points with a missing one.
    ///
    /// # Errors
    /// [`TopographyError::SummitsOfTwo`] when one of the two has the estimator `Summits`, as
    /// summits do not add.
    pub fn combined(first: &Self, second: &Self) -> Result<Self, TopographyError> {
        if [first, second].iter().any(|of| of.estimator == Estimator::Summits) {
            return Err(TopographyError::SummitsOfTwo);
        }
        let moments = first.moments.plus(&second.moments);
        let surface = Surface::from_moments(&moments.profile);
        let surface = surface.map_err(|reason| TopographyError::Moments(reason).to_string());
        let ProfileMoments { m0, m4, .. } = moments.profile;
        let third = |of: &Self| of.ssk * (of.moments.profile.m0 / m0).powf(1.5);
        let fourth = |of: &Self| (of.sku - 3.0) * (of.moments.profile.m0 / m0).powi(2);
        let shape = [third(first) + third(second), 3.0 + fourth(first) + fourth(second)];
        let mut combined = Self::new(shape, moments, Estimator::Moments, surface);
        combined.missing_share = 1.0 - (1.0 - first.missing_share) * (1.0 - second.missing_share);
        combined.despiked = first.despiked + second.despiked;
        combined.outliers = first.outliers.plus(&second.outliers, first.moments.profile.m4 / m4);
        if let Some(found) = warning::outliers(&combined.outliers) {
            combined.warnings = vec![found];
        }
        Ok(combined)
    }

    /// An unusual rms slope of a scan with this pixel size \[m\], most often by a wrong unit.
    #[must_use]
    pub fn unusual_slope(&self, pixel_size: f64) -> Option<Finding> {
        let slope = (2.0 * self.moments.profile.m2).sqrt();
        let found = Finding::warning(Code::UnusualSize, "measured_slope", slope)
            .implausible(slope > SLOPE[1])
            .usual(SLOPE)
            .advice(format!("check unit and pixel_size ({pixel_size:e} m)"));
        (!(SLOPE[0]..=SLOPE[1]).contains(&slope)).then_some(found)
    }

    /// A kurtosis that a few points far from the others make, where these are no outliers of
    /// single points.
    #[must_use]
    pub fn unusual_kurtosis(&self) -> Option<Finding> {
        let found = Finding::warning(Code::NotGaussian, "sku", self.sku).usual([0.0, FAT]);
        let found = found.advice(
            "a few points far from the others dominate sq and sku, in groups that despike leaves as features; mark them as missing in the file",
        );
        (self.sku > FAT && !self.outliers.matter()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip() {
        for estimator in [Estimator::Moments, Estimator::Summits] {
            assert_eq!(estimator.to_string().parse::<Estimator>().unwrap(), estimator);
            let json = serde_json::to_string(&estimator).unwrap();
            assert_eq!(json, format!("\"{estimator}\""));
        }
        assert!("peaks".parse::<Estimator>().is_err());
    }
}
