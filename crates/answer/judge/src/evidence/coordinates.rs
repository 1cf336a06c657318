//! Where a scene under a load lies among the solved cases.

use serde::Serialize;

use crate::evidence::Evidence;
use crate::evidence::case::EvidenceCase;
use asperity_core::{
    ContactError, HeightDistribution, Interface, ProfileMoments, Scene, Surface, positive, short,
};

/// Scenes farther than this factor beyond the solved range have no interval, and values at this
/// limit. The intervals hold the values of single scans with an alpha of 2.71, where 3.117 is
/// solved.
const BEYOND: f64 = 1.16;
/// ... and plasticity indices, which determine how much yields, beyond this one.
const BEYOND_INDEX: f64 = 1.05;
/// Intervals are kept down to loads lighter by this factor than the lightest solved one: below,
/// models differ in how they change.
const LIGHTER: f64 = 30.0;
/// Skewnesses farther than this beyond the solved ones have no interval.
const BEYOND_SKEWNESS: f64 = 0.2;
/// Asperities in contact for each patch of at least 12 pixels: 1.6 to 2.6 at α of 45 to 2.8.
const CONTACTS_PER_PATCH: f64 = 2.0;
/// Hurst exponents from which stiffness and gap are as on the solved surfaces.
pub(crate) const LEAST_HURST: f64 = 0.6;
/// Ratio of slopes below which a surface counts as isotropic.
const ISOTROPIC: f64 = 1.25;
/// Skewness below which heights count as Gaussian.
const GAUSSIAN: f64 = 0.2;

/// What advice needs to know of a surface and a [`Scene`] does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SurfaceShape {
    /// Ssk: skewness of the heights.
    pub skewness: f64,
    /// Skewness of the solved surface whose slopes depend on the height as here, which the area
    /// follows; stiffness and gap follow Ssk. They differ on a scan of few long waves.
    pub slope_skewness: f64,
    /// Rms slope across the lay over that along it, at least 1.
    pub slope_ratio: f64,
    /// Hurst exponent of the spectrum, if it follows a power law and is known. Stiffnesses and gaps
    /// of broad spectra have no interval where it is far from 0.8, which the solved surfaces have.
    pub hurst: Option<f64>,
}

impl Default for SurfaceShape {
    /// Isotropic and Gaussian.
    fn default() -> Self {
        Self { skewness: 0.0, slope_skewness: 0.0, slope_ratio: 1.0, hurst: None }
    }
}

impl SurfaceShape {
    /// The shape with this skewness, and rms slopes in two directions, in either order.
    #[must_use]
    pub fn new(skewness: f64, slopes: [f64; 2]) -> Self {
        let ratio = slopes[0] / slopes[1];
        let slope_ratio = ratio.max(ratio.recip());
        Self { skewness, slope_skewness: skewness, slope_ratio, hurst: None }
    }

    /// How it differs from an isotropic Gaussian surface: `skewness -1`, `slopes 2:1`.
    pub(crate) fn differences(self) -> Vec<String> {
        let short = |x: f64| ((10.0 * x).round() / 10.0).to_string();
        let skewness = (self.skewness != 0.0).then(|| format!("skewness {}", short(self.skewness)));
        let own = (self.skewness - self.slope_skewness).abs() > GAUSSIAN;
        let slope_skewness =
            own.then(|| format!("skewness of the slopes {}", short(self.slope_skewness)));
        let slopes =
            (self.slope_ratio > 1.0).then(|| format!("slopes {}:1", short(self.slope_ratio)));
        skewness.into_iter().chain(slope_skewness).chain(slopes).collect()
    }

    /// The shape with a small skewness replaced by 0 and a ratio of slopes near 1 by 1: single
    /// surfaces of a Gaussian, isotropic family differ by as much.
    fn rounded(self) -> Self {
        let rounded = |skewness: f64| if skewness.abs() < GAUSSIAN { 0.0 } else { skewness };
        Self {
            skewness: rounded(self.skewness),
            slope_skewness: rounded(self.slope_skewness),
            slope_ratio: if self.slope_ratio < ISOTROPIC { 1.0 } else { self.slope_ratio },
            // Places of the table do not differ in it.
            hurst: None,
        }
    }
}

/// What is known of a spectrum beyond its bandwidth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Spectrum {
    /// A power law with a Hurst exponent near 0.8, which the solved surfaces have.
    Like,
    /// A power law with another exponent, or of no scan.
    Unlike,
    /// That of a scan, which follows no power law.
    Irregular,
}

impl Spectrum {
    fn of(shape: Option<SurfaceShape>) -> Self {
        match shape.map(|shape| shape.hurst) {
            Some(Some(hurst)) if hurst >= LEAST_HURST => Self::Like,
            Some(None) => Self::Irregular,
            _ => Self::Unlike,
        }
    }
}

/// A surface, a material and a load in the coordinates of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Coordinates {
    /// m₀ m₄/m₂².
    pub(crate) alpha: f64,
    pub(crate) shape: SurfaceShape,
    pub(crate) spectrum: Spectrum,
    /// ψ; 0 without a hardness.
    pub(crate) index: f64,
    /// E g/H; 0 without a hardness. It decides how much yields: ψ holds the bandwidth, too.
    pub(crate) strain: f64,
    /// p/(E g).
    pub(crate) load: f64,
    /// Contacts of a surface; infinite if unknown, as on a surface of many.
    pub(crate) contacts: f64,
    /// Surfaces whose mean is expected.
    pub(crate) surfaces: f64,
}

/// The ends of five ranges, and two largest values.
pub(crate) type Ranges = ([[f64; 2]; 5], [f64; 2]);

impl Coordinates {
    /// The place of a scene at a mean pressure \[Pa\]; without a shape heights must be Gaussian.
    pub(crate) fn of_scene(
        scene: &Scene,
        shape: Option<SurfaceShape>,
        pressure: f64,
    ) -> Result<Self, ContactError> {
        if shape.is_none() && !matches!(scene.heights, HeightDistribution::Gaussian) {
            let reason = "the heights are not Gaussian, and the skewness of the surface is unknown";
            return Err(ContactError::NoEvidence { property: "skewness", reason: reason.into() });
        }
        if scene.adhesion_parameter().is_some_and(|theta| theta < Scene::HIDES_ADHESION) {
            let reason = "the surfaces adhere, the solved surfaces do not";
            return Err(ContactError::NoEvidence { property: "adhesion", reason: reason.into() });
        }
        let asperity = scene.asperity()?;
        let moments = scene.surface.moments();
        let unit = asperity.equivalent_modulus * gradient(&moments);
        let index = asperity.hardness.map(|_| scene.plasticity_index()).transpose()?;
        Ok(Self {
            alpha: moments.bandwidth(),
            shape: shape.unwrap_or_default().rounded(),
            spectrum: Spectrum::of(shape),
            index: index.unwrap_or(0.0),
            strain: asperity.hardness.map_or(0.0, |hardness| unit / hardness),
            load: positive("pressure", pressure)? / unit,
            contacts: f64::INFINITY,
            surfaces: 1.0,
        })
    }

    /// The place of a solved case.
    pub(crate) fn of_case(case: &EvidenceCase) -> Result<Self, ContactError> {
        let EvidenceCase { alpha, skewness, slope_ratio, plasticity_index: index, .. } = *case;
        let surfaces = case.surfaces.max(1) as f64;
        let contacts = CONTACTS_PER_PATCH * case.patches.max(1) as f64 / surfaces;
        let shape = SurfaceShape::new(skewness, [slope_ratio, 1.0]);
        let (strain, load) = (strain(alpha, index)?, case.load);
        let spectrum = Spectrum::Unlike;
        Ok(Self { alpha, shape, spectrum, index, strain, load, contacts, surfaces })
    }

    pub(crate) fn same_family(&self, other: &Self) -> bool {
        self.alpha.total_cmp(&other.alpha).is_eq() && self.shape == other.shape
    }

    /// Whether the surface is isotropic and Gaussian.
    fn is_plain(&self) -> bool {
        self.shape == SurfaceShape::default()
    }

    /// Ranges of the solved places: of alpha, the load, p/H, the ratio of slopes and the skewness,
    /// and the largest plasticity indices of all surfaces and of those that are not plain.
    pub(crate) fn ranges(all: &[Self]) -> Ranges {
        let range = |of: fn(&Self) -> f64| {
            let none = [f64::INFINITY, f64::NEG_INFINITY];
            all.iter().map(of).fold(none, |[a, b], x| [a.min(x), b.max(x)])
        };
        let index = [false, true].map(|plain| {
            let of = all.iter().filter(|place| !(plain && place.is_plain()));
            of.map(|place| place.index).fold(0.0, f64::max)
        });
        let of: [fn(&Self) -> f64; 5] = [
            |place| place.alpha,
            |place| place.load,
            Self::of_hardness,
            |place| place.shape.slope_ratio,
            |place| place.shape.skewness,
        ];
        (of.map(range), index)
    }

    /// Pressure over hardness.
    pub(crate) fn of_hardness(&self) -> f64 {
        self.load * self.strain
    }
}

/// The property of a place that is outside of the solved ones, and the solved range.
pub(crate) type Outside = (&'static str, String);

/// What is nearest to a place among the solved ones.
#[derive(Debug, Clone)]
pub(crate) struct Nearest {
    /// With each coordinate that is outside of the solved range at its end.
    pub(crate) place: Coordinates,
    /// The nearest load, p/(E g), on the surface itself.
    pub(crate) load: f64,
    /// H over its hardness: softer bodies touch as plastic ones do, by p/H alone.
    pub(crate) hardness: f64,
    /// The first coordinate that is outside.
    pub(crate) outside: Option<Outside>,
}

impl Evidence {
    /// The nearest of the solved places.
    pub(crate) fn nearest(&self, place: &Coordinates) -> Nearest {
        let ([alpha, [lightest, load], [_, hardness], slopes, skewnesses], [index, of_others]) =
            self.ranges;
        // Of skewed surfaces and those with a lay, fewer materials are solved.
        let index = if place.is_plain() { index } else { of_others };
        let of_shape = match place.is_plain() {
            true => String::new(),
            false => format!(" of a surface with {}", place.shape.differences().join(" and ")),
        };
        let SurfaceShape { skewness, slope_skewness, slope_ratio, .. } = place.shape;
        let too_light = (place.load * LIGHTER < lightest).then(|| {
            let reason = format!(
                "p/(E g) = {:.1e}; solved from {lightest:.0e}, with intervals from {:.1e}",
                place.load,
                lightest / LIGHTER
            );
            ("p/(E g)", reason)
        });
        let ranges = [
            ("alpha (m0 m4/m2^2)", "", place.alpha, alpha, BEYOND),
            // Smaller indices are nearly elastic, and lighter loads have constant ratios.
            ("plasticity_index", &of_shape, place.index, [0.0, index], BEYOND_INDEX),
            ("p/(E g)", "", place.load, [0.0, load], BEYOND),
            ("p/H", "", place.of_hardness(), [0.0, hardness], BEYOND),
            ("the ratio of slopes", "", slope_ratio, slopes, BEYOND),
        ];
        let [low, high] = [skewnesses[0] - BEYOND_SKEWNESS, skewnesses[1] + BEYOND_SKEWNESS];
        let named = [("skewness", skewness), ("skewness of the slopes", slope_skewness)];
        let skewed = || {
            let outside = named.into_iter().find(|(_, skewness)| !(low..=high).contains(skewness));
            let [low, high] = skewnesses;
            outside
                .map(|(name, x)| (name, format!("{name} = {x:.1}; solved range {low} to {high}")))
        };
        let outside = too_light.or_else(|| ranges.into_iter().find_map(outside)).or_else(skewed);
        let heaviest = (load * BEYOND).min(hardness * BEYOND / place.strain);
        let load = place.load.min(heaviest).max(lightest);
        let hardness = (index * BEYOND_INDEX / place.index).min(1.0);
        let shape = SurfaceShape {
            skewness: skewness.clamp(low, high),
            slope_skewness: slope_skewness.clamp(low, high),
            slope_ratio: slope_ratio.min(slopes[1] * BEYOND),
            ..place.shape
        };
        let alpha = place.alpha.clamp(alpha[0] / BEYOND, alpha[1] * BEYOND);
        let strain = place.strain * hardness;
        let place = Coordinates { alpha, load: load / hardness, strain, shape, ..*place };
        Nearest { place, load, hardness, outside }
    }
}

/// g, the root mean square gradient.
pub(crate) fn gradient(moments: &ProfileMoments) -> f64 {
    (2.0 * moments.m2).sqrt()
}

/// The property and the reason why a value above 0 of some surfaces has no evidence, outside a
/// range by more than this factor.
fn outside(
    (property, of, value, [low, high], beyond): (&'static str, &str, f64, [f64; 2], f64),
) -> Option<(&'static str, String)> {
    let (least, most) = (low / beyond, high * beyond);
    if value <= 0.0 || (least..=most).contains(&value) {
        return None;
    }
    let [value, low, high] = [value, low, high].map(|x| match x {
        small if small < 0.1 => format!("{small:.1e}"),
        below_one if below_one < 1.0 => format!("{below_one:.2}"),
        large if large >= 1e4 => short(large),
        usual => format!("{usual:.1}"),
    });
    let reason = match least > 0.0 {
        true => format!("{property}{of} = {value}; solved range {low} to {high}"),
        false => format!("{property}{of} = {value}; solved up to {high}"),
    };
    Some((property, reason))
}

/// E g/H of a solved surface: its material has ν = 0.3, on which ψ depends through S.
fn strain(alpha: f64, index: f64) -> Result<f64, ContactError> {
    if index <= 0.0 {
        return Ok(0.0);
    }
    let (m2, modulus, hardness) = (1e-4, 1e11, 1e9);
    let moments = ProfileMoments { m0: 1e-12, m2, m4: alpha * m2 * m2 / 1e-12 };
    let mut scene =
        Scene::new(Interface::elastic(modulus, 0.3), Surface::from_moments(&moments)?, 1e-6);
    scene.interface.hardness = Some(hardness);
    // ψ is inversely proportional to the hardness.
    Ok(modulus * gradient(&moments) / hardness * index / scene.plasticity_index()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strain_of_a_case_is_that_of_its_scene() {
        // ψ = (2E/(π S H)) √(σ_z/R) with S = 0.577, σ_z² = (1 - 0.8968/α) m₀, R = (3/8) √(π/m₄).
        for (alpha, index) in [(3.117f64, 4.0), (29.51, 2.0)] {
            let ratio = 8.0 / (3.0 * std::f64::consts::PI.sqrt()) * (alpha - 0.8968).sqrt();
            let wanted = index * std::f64::consts::PI * 0.577 / (2.0 * ratio.sqrt()) * 2f64.sqrt();
            let found = strain(alpha, index).unwrap();
            assert!((found / wanted - 1.0).abs() < 1e-4, "{found} {wanted}");
        }
        assert_eq!(strain(3.0, 0.0), Ok(0.0));
    }

    #[test]
    fn nearly_isotropic_and_nearly_gaussian_count_as_such() {
        let shape = SurfaceShape::new(0.15, [0.1, 0.11]);
        assert_eq!(shape.rounded(), SurfaceShape::default());
        let ground = SurfaceShape::new(-0.7, [0.05, 0.2]);
        let wanted = SurfaceShape::new(-0.7, [4.0, 1.0]);
        assert_eq!(SurfaceShape { hurst: Some(0.5), ..ground }.rounded(), wanted);
    }
}
