//! The force of a scene to be inverted: its integral, its variation's, and where to look.

use std::sync::OnceLock;

use asperity_quadrature::Moments;

use crate::engine::height_integral::HeightIntegral;
use crate::engine::inverse::interval::Sample;
use crate::engine::inverse::variation::Variation;
use crate::error::integral_failed;
use crate::request::separation::LOWEST;
use crate::{ContactError, HeightDistribution, Law, Quantity, Scene, Tolerance};

/// Tolerance of the variation; bounds include its error.
const ENOUGH: f64 = 1e-8;
/// More breaks of a density than these are not looked at one by one.
const BREAKS: usize = 16;

/// Where a law of the force falls, on one scene.
#[derive(Debug)]
pub(crate) struct Falls {
    /// At this separation and above, no height reaches where the law first falls.
    unseen: f64,
    variation: HeightIntegral,
    /// Where force or slope may have kinks, and between them: descending.
    places: Vec<f64>,
    /// The samples at these places, made once for all loads.
    samples: Vec<OnceLock<Result<Sample, ContactError>>>,
}

impl Falls {
    /// `None` where the force never rises with the separation.
    pub(crate) fn of(law: &Law, scene: &Scene, tolerance: Tolerance) -> Option<Self> {
        let scale = law.interference_unit / scene.surface.asperity_height_std;
        let variation = Variation::new(law, range(scale));
        let first = variation.falls? * scale;
        let heights = marks(&scene.heights, scene.surface.asperity_height_std);
        let mut places = vec![LOWEST, 0.0];
        for k in -2..31 {
            places.extend([2f64.powi(k), -2f64.powi(k)]);
        }
        for knot in &variation.knots {
            let interference = (knot.x + law.onset) * scale;
            places.extend(heights.iter().map(|height| height - interference));
        }
        places.retain(|s| *s >= LOWEST);
        places.sort_by(|a, b| b.total_cmp(a));
        places.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * (1.0 + a.abs()));
        let density = variation.density(law);
        let enough = tolerance.relative().max(ENOUGH);
        let variation = HeightIntegral::new(density, law, scene, enough);
        let unseen =
            farthest(&scene.heights, scene.surface.asperity_height_std) - first - law.onset * scale;
        let samples = places.iter().map(|_| OnceLock::new()).collect();
        Some(Self { unseen, variation, places, samples })
    }
}

impl Falls {
    /// Whether, from this separation on, the heights meet only a rising part of a law.
    pub(crate) fn rises_above(law: &Law, scene: &Scene, s: f64) -> bool {
        let scale = law.interference_unit / scene.surface.asperity_height_std;
        let highest = farthest(&scene.heights, scene.surface.asperity_height_std);
        let met = (highest - s.min(0.0)) / scale - law.onset;
        let (least, most) = range(scale);
        Variation::new(law, (least, most.min(met.max(2.0 * least)))).falls.is_none()
    }

    /// Whether, from this separation on, no height reaches what falls.
    pub(crate) fn hides_above(&self, s: f64) -> bool {
        s.min(0.0) >= self.unseen
    }
}

/// The force of a scene whose law falls somewhere.
pub(crate) struct ForceAt<'c> {
    /// The integral of the force and its slope at a separation.
    pub(crate) guide: &'c dyn Fn(f64) -> Result<Moments, ContactError>,
    pub(crate) falls: &'c Falls,
}

impl ForceAt<'_> {
    pub(crate) fn force(&self, s: f64) -> Result<Moments, ContactError> {
        (self.guide)(s)
    }

    pub(crate) fn variation(&self, s: f64) -> Result<Moments, ContactError> {
        self.falls.variation.guide(s).map_err(integral_failed(Quantity::Force, &s.into()))
    }

    pub(crate) fn sample(&self, s: f64) -> Result<Sample, ContactError> {
        Ok(Sample { s, force: self.force(s)?, variation: self.variation(s)? })
    }

    /// Places to look at first, below one, descending, each with its sample.
    pub(crate) fn places(
        &self,
        below: f64,
    ) -> impl Iterator<Item = (f64, Result<Sample, ContactError>)> {
        let known = self.falls.places.iter().zip(&self.falls.samples);
        known
            .filter(move |(s, _)| **s < below)
            .map(|(s, sample)| (*s, sample.get_or_init(|| self.sample(*s)).clone()))
    }
}

/// The x at which a law is searched for falls, with an interference unit of `scale` σ_z.
fn range(scale: f64) -> (f64, f64) {
    ((1e-3 / scale).min(1e-3), -2.0 * LOWEST / scale)
}

/// Heights [σ_z] at which a density may have kinks, and its middle.
fn marks(heights: &HeightDistribution, height_std: f64) -> Vec<f64> {
    let (other, unit) = match heights {
        HeightDistribution::Gaussian | HeightDistribution::Exponential => return vec![0.0],
        HeightDistribution::Weibull(weibull) => (&weibull.sampled, 1.0),
        HeightDistribution::Other(other) => (other, height_std),
    };
    let (low, high) = other.heights().support();
    let breaks = other.heights().breaks();
    let breaks = if breaks.len() > BREAKS { &[] } else { breaks };
    let all = [0.0, low, high].into_iter().chain(breaks.iter().copied());
    all.filter(|z| z.is_finite()).map(|z| z / unit).collect()
}

/// The height [σ_z] beyond which, seen from its mean, nothing counts.
fn farthest(heights: &HeightDistribution, height_std: f64) -> f64 {
    match heights {
        // exp(-14²/2) is 3e-43, far below the last digit of what lies nearer.
        HeightDistribution::Gaussian => 14.0,
        HeightDistribution::Other(other) => other.heights().support().1 / height_std,
        _ => f64::INFINITY,
    }
}
