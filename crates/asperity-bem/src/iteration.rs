//! The iteration: projected, preconditioned conjugate gradients.
//!
//! Minimises the energy Σ p (u/2 - h) over 0 <= p <= H with Σ p given. As Polonsky & Keer (1999) it
//! walks along conjugate gradients among the pixels that may move; unlike theirs,
//!
//! - the gradient is multiplied by the inverse of the compliance of every wave (Vollebregt 2014
//!   does so in a fixed contact \[recalled\]), which leaves 15 to 60 iterations on any grid;
//! - what ends below 0 or above H is put back by the nearest admissible pressures with the same
//!   sum, not by clipping and scaling: both bounds are treated alike, and nothing stalls;
//! - directions stay conjugate while the contact changes (the lesser of Polak & Ribière's and
//!   Fletcher & Reeves' factors), so that nothing is restarted (as Bugnicourt and others 2018
//!   \[recalled\]).
//!
//! Where almost all of the contact flows, too few pixels are left to say where the rigid surface
//! stands. There, at a cold start and after a step that raised the energy, a step is made along
//! the plain gradient of ALL pixels and shortened to the least energy.

use crate::half_space::{Filter, HalfSpace};
use crate::parallel::{reduce, sum, update};
use crate::projection::Projection;

/// Least share of a contact that must lie between the bounds for a conjugate step.
const LEAST_FREE: f64 = 0.01;
/// Relative rise of the energy that is more than rounding.
const RISE: f64 = 1e-10;

/// What is to be solved.
#[derive(Clone, Copy)]
pub(crate) struct Problem<'a> {
    /// Heights about their mean \[m\].
    pub(crate) heights: &'a [f64],
    /// Largest pressure \[Pa\]: the hardness, or infinity.
    pub(crate) cap: f64,
    /// Sum of the pressures of all pixels \[Pa\].
    pub(crate) load: f64,
}

impl Problem<'_> {
    /// Whether a pixel may move when its gap is `gap`.
    fn moves(&self, pressure: f64, gap: f64) -> bool {
        (pressure > 0.0 || gap < 0.0) && (pressure < self.cap || gap > 0.0)
    }
}

/// How far an iteration has come.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Standing {
    /// Where the rigid surface stands \[m\]: gap = deflection - height - offset.
    pub(crate) offset: f64,
    /// Upper bound of the energy that can still be gained, per load \[m\]: 0 at the solution.
    pub(crate) remainder: f64,
    energy: f64,
    /// Mean gap of the pixels that may move.
    moving_gap: f64,
    /// Share of the contact that is between the bounds.
    free: f64,
}

/// Pressures, their deflections, and what the iteration remembers: six maps.
pub(crate) struct Iteration<'a> {
    problem: Problem<'a>,
    pressures: Vec<f64>,
    deflections: Vec<f64>,
    direction: Vec<f64>,
    gradient: Vec<f64>,
    previous: Vec<f64>,
    /// Gradient times preconditioned gradient of the step before; none: start anew.
    product: Option<f64>,
    energy: f64,
    plain: bool,
}

impl<'a> Iteration<'a> {
    /// Starts at the admissible pressures nearest to `pressures`.
    pub(crate) fn new(
        problem: Problem<'a>,
        mut pressures: Vec<f64>,
        space: &mut HalfSpace,
    ) -> Self {
        let len = pressures.len();
        let all = vec![1.0; len];
        Projection::new(&pressures, &all, 0.0, problem.cap, problem.load)
            .step(&mut pressures, &all);
        let mut this = Self {
            problem,
            deflections: vec![0.0; len],
            direction: all,
            gradient: vec![0.0; len],
            previous: vec![0.0; len],
            product: None,
            energy: f64::INFINITY,
            plain: false,
            pressures,
        };
        this.deflect(space);
        this
    }

    /// Pressures and deflections.
    pub(crate) fn into_maps(self) -> (Vec<f64>, Vec<f64>) {
        (self.pressures, self.deflections)
    }

    fn deflect(&mut self, space: &mut HalfSpace) {
        self.deflections.copy_from_slice(&self.pressures);
        space.apply(Filter::Deflect, &mut self.deflections);
    }

    /// Where the rigid surface stands, and how much is left to gain.
    pub(crate) fn standing(&self) -> Standing {
        let Problem { heights, cap, load } = self.problem;
        let (pressures, deflections) = (&self.pressures, &self.deflections);
        let distance = |i: usize| deflections[i] - heights[i];
        let [free, free_distance, touching] = sum(heights.len(), |i| {
            let touches = pressures[i] > 0.0;
            if touches && pressures[i] < cap {
                [1.0, distance(i), 1.0]
            } else {
                [0.0, 0.0, f64::from(u8::from(touches))]
            }
        });
        let offset = if free > 0.0 { free_distance / free } else { self.offset_between_bounds() };
        let part = |range: std::ops::Range<usize>| {
            let mut least = f64::INFINITY;
            let mut sums = [0.0; 5];
            for i in range {
                let (pressure, gap) = (pressures[i], distance(i) - offset);
                least = least.min(gap);
                if self.problem.moves(pressure, gap) {
                    sums[0] += 1.0;
                    sums[1] += gap;
                }
                sums[2] += pressure * gap;
                // Only where there is a hardness: infinity times 0 is not a number.
                sums[3] += if gap < 0.0 { (pressure - cap) * gap } else { pressure * gap };
                sums[4] += pressure * (0.5 * deflections[i] - heights[i]);
            }
            (least, sums)
        };
        let join = |a: (f64, [f64; 5]), b: (f64, [f64; 5])| {
            (a.0.min(b.0), std::array::from_fn(|k| a.1[k] + b.1[k]))
        };
        let (least, [moving, gaps, open, beyond, energy]) =
            reduce(heights.len(), part, join).unwrap_or((0.0, [0.0; 5]));
        Standing {
            offset,
            remainder: if cap.is_finite() { beyond / load } else { open / load - least },
            energy,
            moving_gap: if moving > 0.0 { gaps / moving } else { 0.0 },
            free: if touching > 0.0 { free / touching } else { 0.0 },
        }
    }

    /// The offset when every pixel of the contact flows: half-way between the flowing pixel that
    /// is pressed in least and the lowest of the others.
    fn offset_between_bounds(&self) -> f64 {
        let Problem { heights, .. } = self.problem;
        let bounds = |range: std::ops::Range<usize>| {
            range.fold([f64::NEG_INFINITY, f64::INFINITY], |[flowing, open], i| {
                let distance = self.deflections[i] - heights[i];
                if self.pressures[i] > 0.0 {
                    [flowing.max(distance), open]
                } else {
                    [flowing, open.min(distance)]
                }
            })
        };
        let join = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        match reduce(heights.len(), bounds, join) {
            Some([flowing, open]) if open.is_finite() => 0.5 * (flowing + open),
            Some([flowing, _]) => flowing,
            None => 0.0,
        }
    }

    /// One step from where the iteration stands; false when no direction leads down any more.
    pub(crate) fn advance(
        &mut self,
        standing: Standing,
        cold: bool,
        space: &mut HalfSpace,
    ) -> bool {
        let rose = standing.energy > self.energy + RISE * self.energy.abs();
        self.energy = standing.energy;
        // Never two plain steps in a row: they converge slowly.
        self.plain = cold || !self.plain && (rose || standing.free < LEAST_FREE);
        if !self.plain && self.conjugate_step(standing, space) {
            return true;
        }
        self.plain = true;
        self.plain_step(space)
    }

    fn conjugate_step(&mut self, standing: Standing, space: &mut HalfSpace) -> bool {
        let Standing { offset, moving_gap, .. } = standing;
        let problem = self.problem;
        let (pressures, deflections) = (&self.pressures, &self.deflections);
        // Gap about the mean of the pixels that move; none of the others.
        let slope = |i: usize| {
            let gap = deflections[i] - problem.heights[i] - offset;
            problem.moves(pressures[i], gap).then_some(gap - moving_gap)
        };
        update(&mut self.gradient, |i, gradient| {
            *gradient = slope(i).unwrap_or(0.0);
            []
        });
        space.apply(Filter::Undo, &mut self.gradient);

        let (gradient, previous, old) = (&self.gradient, &self.previous, &self.direction);
        let [moving, product, overlap, gradients, directions] =
            sum(pressures.len(), |i| match slope(i) {
                Some(slope) => [1.0, slope * gradient[i], slope * previous[i], gradient[i], old[i]],
                None => [0.0; 5],
            });
        let turn = match self.product {
            Some(before) => ((product - overlap) / before).min(product / before).max(0.0),
            None => 0.0,
        };
        let mean = (gradients + turn * directions) / moving;
        let [descent] = update(&mut self.direction, |i, direction| match slope(i) {
            Some(slope) => {
                *direction = gradient[i] + turn * *direction - mean;
                [slope * *direction]
            }
            None => {
                *direction = 0.0;
                [0.0]
            }
        });
        std::mem::swap(&mut self.gradient, &mut self.previous);
        let response = &mut self.gradient;
        response.copy_from_slice(&self.direction);
        space.apply(Filter::Deflect, response);
        let (direction, response) = (&self.direction, &self.gradient);
        let [curvature] = sum(direction.len(), |i| [direction[i] * response[i]]);
        let length = descent / curvature;
        if !(descent > 0.0 && curvature > 0.0 && length.is_finite()) {
            return false;
        }
        self.product = Some(product);
        let step = Projection::new(&self.pressures, direction, length, problem.cap, problem.load);
        step.step(&mut self.pressures, direction);
        if step.cut {
            self.deflect(space);
        } else {
            update(&mut self.deflections, |i, deflection| {
                *deflection -= length * response[i];
                []
            });
        }
        true
    }

    fn plain_step(&mut self, space: &mut HalfSpace) -> bool {
        let Problem { heights, cap, load } = self.problem;
        let len = heights.len();
        self.product = None;
        let deflections = &self.deflections;
        let [distances] = sum(len, |i| [deflections[i] - heights[i]]);
        let mean = distances / len as f64;
        let [descent] = update(&mut self.gradient, |i, gradient| {
            *gradient = deflections[i] - heights[i] - mean;
            [gradient.powi(2)]
        });
        self.previous.copy_from_slice(&self.gradient);
        space.apply(Filter::Deflect, &mut self.previous);
        let (gradient, response) = (&self.gradient, &self.previous);
        let [curvature] = sum(len, |i| [gradient[i] * response[i]]);
        let length = descent / curvature;
        if !(length > 0.0 && length.is_finite()) {
            return false;
        }
        let step = Projection::new(&self.pressures, gradient, length, cap, load);
        let pressures = &self.pressures;
        update(&mut self.direction, |i, end| {
            *end = step.of(pressures[i], gradient[i]);
            []
        });
        self.previous.copy_from_slice(&self.direction);
        space.apply(Filter::Deflect, &mut self.previous);
        let (ends, responses) = (&self.direction, &self.previous);
        let [descent, curvature] = sum(len, |i| {
            let change = ends[i] - pressures[i];
            [-gradient[i] * change, change * (responses[i] - deflections[i])]
        });
        let length = if descent < curvature { descent / curvature } else { 1.0 };
        if !(descent > 0.0 && length > 0.0) {
            return false;
        }
        update(&mut self.pressures, |i, pressure| {
            *pressure =
                if length < 1.0 { *pressure + length * (ends[i] - *pressure) } else { ends[i] };
            []
        });
        update(&mut self.deflections, |i, deflection| {
            *deflection += length * (responses[i] - *deflection);
            []
        });
        true
    }
}
