//! The force of a scene to be inverted: its integral, its variation's, and where to look.

use std::sync::{Arc, OnceLock};

use asperity_quadrature::{Density, Moments};

use crate::engine::height_integral::HeightIntegral;
use crate::engine::inverse::interval::{Level, Sample};
use crate::engine::inverse::variation::Variation;
use crate::error::integral_failed;
use crate::scene::place::LOWEST;
use crate::{ContactError, HeightDistribution, Law, Quantity, Scene, Tolerance};

/// Tolerance of the variation; bounds include its error.
const ENOUGH: f64 = 1e-8;
/// Tolerance of integrals that show where force and variation rise, where their slopes miss the
/// tolerance of the values: densities with kinks that were not declared.
const ROUGH: f64 = 1e-3;
/// More breaks of a density than these are not looked at one by one.
const BREAKS: usize = 16;

/// Where a law of the force falls, on one scene.
#[derive(Debug)]
pub(crate) struct Falls {
    /// At this separation and above, no height reaches where the law first falls.
    unseen: f64,
    variation: HeightIntegral,
    /// Number of turns of the law; series between as many kinks are not worth preparing.
    turns: usize,
    /// The integral of the force, for scenes that have not prepared it otherwise.
    force: HeightIntegral,
    /// Force and variation to less, for their slopes.
    rough: [HeightIntegral; 2],
    /// Where force or slope may have kinks, and between them: descending.
    landmarks: Vec<Landmark>,
}

/// A separation to look at first, and the sample there, made once for all loads.
#[derive(Debug)]
pub(crate) struct Landmark {
    pub(crate) s: f64,
    sample: OnceLock<Result<Sample, ContactError>>,
    /// ln of what the integral of the force exceeds here and everywhere below, if it is positive.
    ln_floor: Option<f64>,
}

impl Falls {
    /// `None` where the force never rises with the separation.
    pub(crate) fn of(
        law: &Law,
        variation: &Variation,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Option<Self> {
        let scale = law.interference_unit / scene.surface.asperity_height_std;
        let first = variation.falls? * scale;
        let heights = Marks::new(scene);
        let mut places = vec![LOWEST, 0.0];
        for k in -2..31 {
            places.extend([2f64.powi(k), -2f64.powi(k)]);
        }
        let knots = variation.followed();
        for knot in knots {
            let interference = (knot.x + law.onset) * scale;
            places.extend(heights.kinks.iter().map(|height| height - interference));
        }
        // Farther down, heights meet turns of the law that are not known.
        let lowest = heights.high.min(HEAVIEST) - (variation.resolved + law.onset) * scale;
        places.retain(|s| *s >= LOWEST.max(lowest));
        places.sort_by(|a, b| b.total_cmp(a));
        places.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * (1.0 + a.abs()));
        let floor = |s: f64| {
            let x = (heights.low - s) / scale - law.onset;
            let least = if x > 0.0 { variation.least_from(law, x) } else { None };
            least.filter(|least| *least > 0.0).map(f64::ln)
        };
        let landmark = |s: f64| Landmark { s, sample: OnceLock::new(), ln_floor: floor(s) };
        let landmarks = places.into_iter().map(landmark).collect();
        let unseen = heights.high - first - law.onset * scale;
        let (turns, enough) = (knots.len(), tolerance.relative().max(ENOUGH));
        let [of_force, of_variation] = [law.density(), variation.density(law)];
        let integral =
            |of: &Density, tolerance| HeightIntegral::new(of.clone(), law, scene, tolerance);
        let rough = [&of_force, &of_variation].map(|of| integral(of, ROUGH));
        let variation = integral(&of_variation, enough);
        let force = integral(&of_force, tolerance.relative());
        Some(Self { unseen, variation, turns, force, rough, landmarks })
    }

    /// The integral of the force, with its slope also where that misses the tolerance.
    pub(crate) fn force(&self, s: f64) -> Result<Moments, ContactError> {
        self.force.guide(s, true).map_err(integral_failed(Quantity::Force, &s.into()))
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

/// An integral at s, with the slope of a rougher one if it has none of its own.
fn with_slope(found: Moments, rough: &HeightIntegral, s: f64) -> Moments {
    if !found.slope.is_nan() {
        return found;
    }
    let Ok(Moments { slope, sizes, ln_scale, error, .. }) = rough.guide(s, true) else {
        return found;
    };
    let unit = (ln_scale - found.ln_scale).exp();
    Moments {
        slope: slope * unit,
        sizes: [found.sizes[0], sizes[1] * unit],
        error: found.error.max(error),
        ..found
    }
}

impl Landmark {
    pub(crate) fn sample(&self, force: &ForceAt<'_>) -> Result<Sample, ContactError> {
        self.sample.get_or_init(|| force.sample(self.s)).clone()
    }

    /// Whether the force is above the level here and everywhere below: all heights are pressed by
    /// so much that no single one carries less.
    pub(crate) fn stays_above(&self, level: Level) -> bool {
        // The law is known between its samples only nearly.
        self.ln_floor.is_some_and(|floor| level.sign <= 0.0 || floor > level.ln + 0.01)
    }
}

impl ForceAt<'_> {
    pub(crate) fn force(&self, s: f64) -> Result<Moments, ContactError> {
        Ok(with_slope((self.guide)(s)?, &self.falls.rough[0], s))
    }

    pub(crate) fn variation(&self, s: f64) -> Result<Moments, ContactError> {
        let Falls { variation, turns, .. } = self.falls;
        let found = variation.guide(s, *turns <= BREAKS);
        let found = found.map_err(integral_failed(Quantity::Force, &s.into()))?;
        Ok(with_slope(found, &self.falls.rough[1], s))
    }

    pub(crate) fn sample(&self, s: f64) -> Result<Sample, ContactError> {
        Ok(Sample { s, force: self.force(s)?, variation: self.variation(s)? })
    }

    /// Landmarks below a separation, descending.
    pub(crate) fn landmarks(&self, below: f64) -> impl Iterator<Item = &Landmark> {
        self.falls.landmarks.iter().filter(move |landmark| landmark.s < below)
    }
}

/// The x at which a law is searched for falls, with an interference unit of `scale` σ_z, and which
/// of them are met from a separation on.
pub(crate) fn range(law: &Law, scene: &Scene, above: f64) -> (f64, f64) {
    let scale = law.interference_unit / scene.surface.asperity_height_std;
    let (least, most) = ((1e-3 / scale).min(1e-3), -2.0 * LOWEST / scale);
    let met = (ends(scene)[1] - above.min(0.0)) / scale - law.onset;
    (least, most.min(met.max(2.0 * least)))
}

/// Beyond so many σ_z, heights with the tail of an exponential add less than [`ENOUGH`].
const HEAVIEST: f64 = 24.0;

/// The heights \[σ_z\] below and above which nothing counts.
fn ends(scene: &Scene) -> [f64; 2] {
    let std = scene.surface.asperity_height_std;
    let (low, high) = scene.heights.support(std);
    match scene.heights {
        HeightDistribution::Gaussian => [-GAUSSIAN, GAUSSIAN],
        _ => [low / std, high / std],
    }
}

/// exp(-14²/2) is 3e-43, far below the last digit of what lies nearer.
const GAUSSIAN: f64 = 14.0;

/// Where heights begin, end and may have kinks \[σ_z\].
struct Marks {
    low: f64,
    high: f64,
    /// Kinks, and the middle.
    kinks: Vec<f64>,
}

impl Marks {
    fn new(scene: &Scene) -> Self {
        let [low, high] = ends(scene);
        let Some((other, unit)) = scene.heights.sampled(scene.surface.asperity_height_std) else {
            return Self { low, high, kinks: vec![0.0] };
        };
        let (first, last) = other.heights().support();
        // Those that were declared, and those that were found.
        let weight = other.weight().ok();
        let breaks = weight.as_ref().map_or(other.heights().breaks(), |weight| weight.breaks());
        let breaks = if breaks.len() > BREAKS { &[] } else { breaks };
        let all = [0.0, first, last].into_iter().chain(breaks.iter().copied());
        let kinks = all.filter(|z| z.is_finite()).map(|z| z / unit).collect();
        Self { low, high, kinks }
    }
}

/// Where the law of a force falls, kept for other loads and scenes.
#[derive(Debug, Default)]
pub(crate) struct CachedFalls {
    /// The range that was searched, and what was found there.
    variation: Option<((f64, f64), Arc<Variation>)>,
    /// Those on the last scene.
    on_scene: Option<(Scene, Option<Arc<Falls>>)>,
}

impl CachedFalls {
    /// The variation of the law on a range, at least.
    fn variation(&mut self, law: &Law, (least, most): (f64, f64)) -> Arc<Variation> {
        let serves = |(range, _): &&((f64, f64), _)| range.0 <= least && range.1 >= most;
        if let Some((_, cached)) = self.variation.as_ref().filter(serves) {
            return cached.clone();
        }
        // Whole octaves serve the loads and scenes nearby as well.
        let least = self.variation.as_ref().map_or(least, |(range, _)| range.0.min(least));
        let range = (least.log2().floor().exp2(), (most.log2().ceil() + 1.0).exp2());
        let found = Arc::new(Variation::new(law, range));
        self.variation = Some((range, found.clone()));
        found
    }

    /// Whether, from a separation on, the heights meet only a rising part of the law.
    pub(crate) fn rises_above(&mut self, law: &Law, scene: &Scene, s: f64) -> bool {
        let range = range(law, scene, s);
        self.variation(law, range).falls.is_none_or(|x| x >= range.1)
    }

    /// Where it falls on a scene.
    pub(crate) fn on(
        &mut self,
        law: &Law,
        scene: &Scene,
        tolerance: Tolerance,
    ) -> Option<Arc<Falls>> {
        if let Some((known, falls)) = &self.on_scene
            && same_heights(known, scene)
        {
            return falls.clone();
        }
        let variation = self.variation(law, range(law, scene, f64::NEG_INFINITY));
        let falls = Falls::of(law, &variation, scene, tolerance).map(Arc::new);
        self.on_scene = Some((scene.clone(), falls.clone()));
        falls
    }
}

/// Whether the heights of two scenes are the same.
fn same_heights(a: &Scene, b: &Scene) -> bool {
    let std = |scene: &Scene| scene.surface.asperity_height_std.to_bits();
    std(a) == std(b)
        && match (&a.heights, &b.heights) {
            // Scenes of one range have heights of their own.
            (HeightDistribution::Weibull(a), HeightDistribution::Weibull(b)) => {
                a.shape().to_bits() == b.shape().to_bits()
            }
            (HeightDistribution::Other(a), HeightDistribution::Other(b)) => Arc::ptr_eq(a, b),
            (HeightDistribution::Gaussian, HeightDistribution::Gaussian)
            | (HeightDistribution::Exponential, HeightDistribution::Exponential) => true,
            _ => false,
        }
}
