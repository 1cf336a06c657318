//! The integral on a short range of s, and of scales: sampled once, then a polynomial.

use super::patch::{Argument, Masses, Patch, Tilt};
use crate::chebyshev::extent;
use crate::chebyshev::polynomial::{Chebyshev, Series};
use crate::{Density, QuadratureError};

/// The integral for all s and scales of a patch.
#[derive(Debug)]
pub(crate) struct Segment {
    pub(crate) patch: Patch,
    /// ∫ zᵏ, k = 0 and 1, without the factor that was taken out.
    pub(crate) power: [Series; 2],
    /// ∫ zᵏ, k = 0 and 1, of the absolute value, where it is another.
    pub(crate) size: Option<[Series; 2]>,
    /// A bound on the size for k = 1 over that for 0, below 0: z has both signs.
    pub(crate) growth: Option<f64>,
    /// The largest ratio of the sizes for k = 1 and 0.
    pub(crate) steepness: f64,
    /// What has been taken out.
    pub(crate) tilt: Option<Tilt>,
    /// The error relative to the sizes.
    pub(crate) error: f64,
    pub(crate) evaluations: usize,
}

impl Segment {
    pub(crate) fn new(
        density: &Density,
        scale: f64,
        patch: Patch,
        tolerance: f64,
    ) -> Result<Self, QuadratureError> {
        let masses = Masses::new(density, scale, &patch, tolerance)?;
        let ladder = Chebyshev::ladder();
        let digits = -tolerance.log10();
        // What laws of contact need, as a rule; more is found out.
        let (mut u, mut v) = (step(6.5 + 0.65 * digits), step(4.0 + 0.6 * digits));
        loop {
            let points =
                (&ladder[u], if patch.unstretched() { Chebyshev::single() } else { &ladder[v] });
            let (segment, resolved) = Self::through(&masses, patch, tolerance, points);
            if resolved == [true; 2] {
                return Ok(segment);
            }
            u += usize::from(!resolved[0]);
            v += usize::from(!resolved[1]);
            if u.max(v) == ladder.len() {
                return Err(QuadratureError::missed(segment.error, tolerance, masses.evaluations));
            }
        }
    }

    /// Through the integrals at Chebyshev's points, and whether those were enough.
    fn through(
        masses: &Masses,
        patch: Patch,
        tolerance: f64,
        points: (&Chebyshev, &Chebyshev),
    ) -> (Self, [bool; 2]) {
        let Masses { evaluations, .. } = *masses;
        let mut segment = Self {
            patch,
            power: Default::default(),
            size: None,
            growth: None,
            steepness: 0.0,
            tilt: None,
            error: 0.0,
            evaluations,
        };
        if masses.y.is_empty() {
            return (segment, [true; 2]);
        }
        let tilt = masses.tilt(&patch);
        segment.tilt = tilt;
        let power = masses.sample(|m| m, &patch, tilt, points);
        let signed = masses.masses.iter().any(|m| *m < 0.0);
        let size = signed.then(|| masses.sample(f64::abs, &patch, tilt, points));
        let sizes = size.as_ref().unwrap_or(&power);
        segment.growth = patch.negative().then(|| {
            // |z| is no more than the root of the mean square.
            let squares = sizes[0].iter().zip(&sizes[2]).map(|(size, square)| square / size);
            squares.fold(0.0, f64::max).sqrt()
        });
        segment.steepness = segment.growth.unwrap_or_else(|| {
            sizes[1].iter().zip(&sizes[0]).map(|(slope, size)| slope / size).fold(0.0, f64::max)
        });
        let extents = [0, 1].map(|k| match segment.growth {
            Some(growth) if k > 0 => {
                let (least, most) = extent(sizes[0].iter().copied());
                (growth * least, growth * most)
            }
            _ => extent(sizes[k].iter().copied()),
        });
        let base = extents.map(|(least, _)| least);
        // Far below 0 the slope is much smaller than its size, and is wanted as well.
        let share = |(value, slope): (&f64, &f64)| {
            slope.abs().max(value / (1.0 - patch.lowest())) * base[0] / (base[1] * value)
        };
        let shares = power[0].iter().zip(&power[1]).map(share);
        let share = if signed || !patch.negative() { 1.0 } else { shares.fold(1.0, f64::min) };
        // For one scale three digits more cost next to nothing.
        let aim = if patch.unstretched() { 1e-3 } else { 0.25 } * tolerance * share;
        let (mut resolved, mut left) = ([true; 2], 0.0f64);
        for (k, samples) in power[..2].iter().enumerate() {
            let fit = Series::fit(points, samples, aim * base[k], extents[k].1);
            (0..2).for_each(|axis| resolved[axis] &= fit.resolved[axis]);
            left = left.max((fit.left + patch.rounding(samples, tilt)) / base[k]);
            segment.power[k] = fit.series;
        }
        segment.size = size.map(|size| {
            // As good as the values, which none exceeds.
            std::array::from_fn(|k| Series::fit(points, &size[k], aim * base[k], 0.0).series)
        });
        segment.error = left + masses.error;
        (segment, resolved)
    }

    /// Coefficients of the polynomial for the value.
    pub(crate) fn terms(&self) -> usize {
        self.power[0].coefficients()
    }

    /// The value and its size.
    #[inline(always)]
    pub(crate) fn value(&self, place: Argument) -> (f64, f64) {
        let (at, factor) = self.patch.variables(place, self.tilt);
        let value = factor * self.power[0].at(at);
        let size = self.size.as_ref().map_or(value, |size| factor * size[0].at(at));
        (value, size.max(value.abs()))
    }

    /// The value and the slope, each with its size.
    #[inline(always)]
    pub(crate) fn with_slope(&self, place: Argument) -> [(f64, f64); 2] {
        let (at, factor) = self.patch.variables(place, self.tilt);
        let of = |series: &Series| factor * series.at(at);
        let (value, slope) = (of(&self.power[0]), of(&self.power[1]));
        let (size, of_slope) = match &self.size {
            Some(size) => (of(&size[0]), of(&size[1])),
            None => (value, slope),
        };
        let of_slope = self.growth.map_or(of_slope, |growth| growth * size);
        [(value, size.max(value.abs())), (slope, of_slope)]
    }
}

/// The first step of the ladder with this number of points, or the last.
fn step(points: f64) -> usize {
    let ladder = Chebyshev::ladder();
    let enough = |step: &Chebyshev| step.points.len() as f64 >= points;
    ladder.iter().position(enough).unwrap_or(ladder.len() - 1)
}
