//! A short range of s, and of scales, and the integral sampled there.

use super::weight::{DEEPEST, INV_SQRT_2PI, ROUNDING, Weight, masses};
use crate::chebyshev::extent;
use crate::chebyshev::polynomial::Chebyshev;
use crate::{Density, Goal, PointMasses, QuadratureError};

/// Scales that are summed together.
const LANES: usize = 4;

/// Where an integral is asked for: at s, and at a scale of `ratio` times the scale of the points t.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Argument {
    s: f64,
    ratio: f64,
    /// 1 over the ratio.
    inverse: f64,
}

impl Argument {
    #[inline]
    pub(crate) fn at(s: f64) -> Self {
        Self { s, ratio: 1.0, inverse: 1.0 }
    }

    #[inline]
    pub(crate) fn at_scale(s: f64, ratio: f64, inverse: f64) -> Self {
        Self { s, ratio, inverse }
    }

    /// The place of the weight on t, whatever the ratio r: it is exp(-(key t + r² t²/2)) for
    /// s ≥ 0, exp(-r² (key + t)²/2) below.
    #[inline]
    pub(crate) fn key(self) -> f64 {
        if self.s < 0.0 { self.s * self.inverse } else { self.s * self.ratio }
    }
}

/// The keys and the scales that one polynomial serves.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Patch {
    /// Smallest and largest key, not of opposite sign.
    keys: (f64, f64),
    centre: f64,
    /// Inverse ratios of scales differ from 1 by no more than this.
    stretch: f64,
    /// The largest x.
    half: f64,
    /// How far below the centre the pole is.
    pole: f64,
    /// Factors that make u and v of x and of the inverse ratio.
    slopes: (f64, f64),
}

/// Above 0 integrals fall like powers of key + 3.5, nearly: fewer powers of its inverse are needed.
const POLE: f64 = -3.5;

impl Patch {
    pub(crate) fn new(keys: (f64, f64), stretch: f64) -> Self {
        let (centre, half) = (0.5 * (keys.0 + keys.1), 0.5 * (keys.1 - keys.0));
        // Below 0 there is none: it is as far as not to be seen.
        let (half, pole) = if keys.0 < 0.0 {
            (half / (1.0 - stretch).powi(2), 1e30)
        } else {
            (half, centre - POLE)
        };
        let slopes = (pole / half, if stretch > 0.0 { stretch.recip() } else { 0.0 });
        Self { keys, centre, stretch, half, pole, slopes }
    }

    pub(crate) fn negative(&self) -> bool {
        self.keys.0 < 0.0
    }

    pub(crate) fn lowest(&self) -> f64 {
        self.keys.0
    }

    /// Whether it is for one scale only.
    pub(crate) fn unstretched(&self) -> bool {
        self.stretch <= 0.0
    }

    /// At a key and a ratio r both exponents are those in the middle plus x y + (r² - 1) y²/2, and
    /// x²/(2r²) below 0: x is the difference of keys, times r² below 0, and y is t, or the middle
    /// key plus t.
    #[inline(always)]
    fn x(&self, Argument { s, ratio, .. }: Argument) -> f64 {
        if s < 0.0 { ratio * (s - ratio * self.centre) } else { s * ratio - self.centre }
    }

    /// The variables in [-1, 1], and the factor that was taken out.
    #[inline(always)]
    pub(crate) fn variables(&self, place: Argument, tilt: Option<Tilt>) -> ((f64, f64), f64) {
        let x = self.x(place);
        let factor = tilt.map_or(1.0, |tilt| tilt.factor(x, place.ratio));
        let u = (self.slopes.0 * x + self.half) / (x + self.pole);
        ((u, (place.inverse - 1.0) * self.slopes.1), factor)
    }

    /// The x of a u.
    fn x_of(&self, u: f64) -> f64 {
        (self.pole * u - self.half) / (self.slopes.0 - u)
    }

    fn middle(&self) -> Argument {
        Argument::at(self.centre)
    }

    /// Corners, just inside, so that none changes its sign at 0.
    fn corners(&self) -> Vec<Argument> {
        let (low, high) = self.keys;
        let inset = 1e-9 * (high - low);
        let ratios = if self.unstretched() {
            vec![1.0]
        } else {
            vec![1.0 / (1.0 - self.stretch), 1.0 / (1.0 + self.stretch)]
        };
        let at = |key: f64, ratio: f64| if key < 0.0 { key * ratio } else { key / ratio };
        let along = |ratio: f64| {
            [low + inset, high - inset]
                .map(|key| Argument::at_scale(at(key, ratio), ratio, ratio.recip()))
        };
        ratios.into_iter().flat_map(along).collect()
    }

    /// What the rounding of place and scale does to samples.
    pub(crate) fn rounding(&self, samples: &[f64], tilt: Option<Tilt>) -> f64 {
        let (least, most) = extent(samples.iter().copied());
        let key = self.keys.0.abs().max(self.keys.1.abs());
        // Both are divided by a scale, which is rounded, and s itself is not.
        let (moved, scaled) = if self.unstretched() { (0.0, 0.0) } else { (2.0 * key, 2.0) };
        let tilted = tilt
            .map_or(0.0, |tilt| tilt.depth + (moved + self.half) * tilt.y.abs() + scaled * tilt.y2);
        let varied = moved / self.half + scaled * self.slopes.1;
        f64::EPSILON * (varied * (most - least) + tilted * most.abs().max(least.abs()))
    }
}

/// A factor exp(-(depth + x y + (r² - 1) y2/2)) of an integral.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Tilt {
    depth: f64,
    y: f64,
    y2: f64,
}

impl Tilt {
    #[cold]
    fn factor(self, x: f64, ratio: f64) -> f64 {
        (-(self.depth + x * self.y + 0.5 * (ratio * ratio - 1.0) * self.y2)).exp()
    }
}

/// Point masses under the weight in the middle of a patch.
pub(crate) struct Masses {
    pub(crate) y: Vec<f64>,
    pub(crate) masses: Vec<f64>,
    /// The exponent that was left out of all weights.
    depth: f64,
    /// The relative errors of the integrals, of the density and of the sums.
    pub(crate) error: f64,
    pub(crate) evaluations: usize,
}

/// Integrals of zᵏ, k = 0, 1, 2, at each point of u, for each of v.
pub(crate) type Samples = [Vec<f64>; 3];

impl Masses {
    pub(crate) fn new(
        density: &Density,
        scale: f64,
        patch: &Patch,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let from = scale * density.begin();
        let weight = |place: &Argument| Weight::new(place.s, place.ratio * from);
        // Each in units of its largest value where the density is, with its ratio.
        let corners: Vec<(Weight, f64)> =
            patch.corners().iter().map(|corner| (weight(corner), corner.ratio)).collect();
        let (middle, centre) = (weight(&patch.middle()), patch.centre);
        let mut found = Self {
            y: vec![],
            masses: vec![],
            depth: middle.depth,
            // Far below 0 the points are known no better than key + t is.
            error: ROUNDING + 0.5 * f64::EPSILON * centre.min(0.0).abs(),
            evaluations: 0,
        };
        if corners.iter().all(|(corner, _)| corner.depth > DEEPEST) {
            return Ok(found);
        }
        // Resolved where any corner has weight, not only where the middle has; corners have equal
        // rights, however little there is at some.
        let at = |t: f64| corners.iter().map(move |(corner, ratio)| corner.at(ratio * t));
        let window = |depth: f64| {
            let of = |(corner, ratio): &(Weight, f64)| {
                let (near, far) = corner.window(depth);
                (near / ratio, far / ratio)
            };
            let union = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
            corners.iter().map(of).fold((f64::INFINITY, 0.0), union)
        };
        // Far below 0 slopes are so much smaller than their positive and negative parts.
        let aim = middle.noise().max(0.01 * tolerance / (1.0 - centre.min(0.0)));
        let goal = Goal { aim, refuse: (0.2 * tolerance).max(4.0 * aim) };
        let PointMasses { points, mut masses, error, evaluations } =
            masses(density, scale, (centre, &window), &|t| at(t).sum(), goal)?;
        found.evaluations = evaluations;
        if points.is_empty() {
            return Ok(found);
        }
        let mut integrals = vec![0.0; corners.len()];
        for (mass, t) in masses.iter_mut().zip(&points) {
            let weights: Vec<f64> = at(*t).collect();
            *mass /= weights.iter().sum::<f64>();
            for (integral, weight) in integrals.iter_mut().zip(weights) {
                *integral += mass.abs() * weight;
            }
            *mass *= INV_SQRT_2PI * middle.at(*t);
        }
        let smallest = integrals.into_iter().fold(f64::INFINITY, f64::min);
        let x: Vec<f64> = points.iter().map(|t| t / scale).collect();
        found.error += error / smallest + density.relative_error(&x);
        let origin = if patch.negative() { centre } else { 0.0 };
        found.y = points.iter().map(|t| origin + t).collect();
        found.masses = masses;
        Ok(found)
    }

    /// What to take out of integrals that are small or vary much over the patch.
    pub(crate) fn tilt(&self, patch: &Patch) -> Option<Tilt> {
        let (mut total, mut y, mut y2) = (0.0, 0.0, 0.0);
        for (at, mass) in self.y.iter().zip(&self.masses) {
            total += mass.abs();
            y += mass.abs() * at;
            y2 += mass.abs() * at * at;
        }
        let tilt = Tilt { depth: self.depth, y: y / total, y2: y2 / total };
        let varied = tilt.y.abs() * patch.half > 1.0 || tilt.y2 * patch.stretch > 1.0;
        (varied || self.depth > 0.0).then_some(tilt)
    }

    /// The integrals, each mass seen through `part`.
    pub(crate) fn sample(
        &self,
        part: impl Fn(f64) -> f64,
        patch: &Patch,
        tilt: Option<Tilt>,
        (u, v): (&Chebyshev, &Chebyshev),
    ) -> Samples {
        let tilt = tilt.unwrap_or_default();
        let ratios: Vec<f64> = v.points.iter().map(|v| 1.0 / (1.0 + patch.stretch * v)).collect();
        let (count, rows) = (u.points.len(), ratios.len());
        let of_r = |r: f64, y: &f64| (-0.5 * (r * r - 1.0) * (y * y - tilt.y2)).exp();
        let blocks: Vec<Vec<[f64; LANES]>> = ratios
            .chunks(LANES)
            .map(|ratios| {
                let four =
                    |y: &f64| std::array::from_fn(|k| ratios.get(k).map_or(0.0, |r| of_r(*r, y)));
                self.y.iter().map(four).collect()
            })
            .collect();
        let mut samples: Samples = std::array::from_fn(|_| vec![0.0; count * rows]);
        let mut terms = vec![[0.0; 3]; self.y.len()];
        let mut sums = vec![[[0.0; LANES]; 3]; blocks.len()];
        for (i, u) in u.points.iter().enumerate() {
            let x = patch.x_of(*u);
            for (terms, (y, mass)) in terms.iter_mut().zip(self.y.iter().zip(&self.masses)) {
                let term = part(*mass) * (-x * (y - tilt.y)).exp();
                *terms = [term, term * y, term * y * y];
            }
            for (sums, block) in sums.iter_mut().zip(&blocks) {
                let mut sum = [[0.0; LANES]; 3];
                for (terms, of_r) in terms.iter().zip(block) {
                    for (sum, term) in sum.iter_mut().zip(terms) {
                        sum.iter_mut().zip(of_r).for_each(|(sum, r)| *sum += term * r);
                    }
                }
                *sums = sum;
            }
            for (j, r) in ratios.iter().enumerate() {
                let [a, b, c] = sums[j / LANES].map(|sum| sum[j % LANES]);
                // z = origin + r y, and dt is r times the step of the masses.
                let (origin, factor) = if patch.negative() {
                    (x / r, r * (-0.5 * (x / r) * (x / r)).exp())
                } else {
                    ((patch.centre + x) / r, *r)
                };
                let (b, c) = (r * b, r * r * c);
                let powers = [a, origin * a + b, origin * (origin * a + 2.0 * b) + c];
                for (samples, power) in samples.iter_mut().zip(powers) {
                    samples[j * count + i] = factor * power;
                }
            }
        }
        samples
    }
}
