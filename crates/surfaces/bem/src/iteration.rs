//! The iteration: projected, preconditioned conjugate gradients.
//!
//! Minimises the energy Σ p (u/2 - h) over 0 <= p <= H with Σ p given. As Polonsky & Keer (1999) it
//! walks along conjugate gradients among the pixels that may move; unlike theirs,
//!
//! - the gradient is multiplied by the inverse of the compliance of every wave (Vollebregt 2014
//!   does so in a fixed contact \[recalled\]), so that 15 to 60 iterations suffice on any grid;
//! - pressures below 0 or above H are projected on the nearest admissible pressures with the same
//!   sum, not clipped and scaled: both bounds are treated alike, and nothing stalls;
//! - directions stay conjugate while the contact changes (the lesser of Polak & Ribière's and
//!   Fletcher & Reeves' factors), so that nothing is restarted (as Bugnicourt and others 2018
//!   \[recalled\]).
//!
//! Where almost all of the contact is plastic, too few elastic pixels remain to locate the rigid
//! surface. There, at a cold start and after a step that raised the energy, the next step follows
//! the unpreconditioned gradient of all pixels and is shortened to the least energy.

use std::ops::ControlFlow;

use crate::BemError;
use crate::half_space::{Compliance, Filter};
use crate::parallel::{inside, number, reduce, sum, update};
use crate::projection::Projection;

/// Least share of a contact that must lie between the bounds for a conjugate step.
const LEAST_FREE: f64 = 0.01;
/// Relative rise of the energy that is more than rounding.
const RISE: f64 = 1e-10;

/// The problem: heights, bounds of the pressure, and load.
#[derive(Clone, Copy)]
pub(crate) struct Problem<'a> {
    /// Heights about their mean \[m\].
    pub(crate) heights: &'a [f64],
    /// The greatest of them \[m\]. Gaps are measured from it: under light loads deflections are
    /// below the rounding of the heights themselves.
    pub(crate) highest: f64,
    /// Largest pressure \[Pa\]: the hardness, or infinity.
    pub(crate) cap: f64,
    /// Sum of the pressures of all pixels \[Pa\].
    pub(crate) load: f64,
}

impl Problem<'_> {
    /// Distance from the undeformed half-space to the deflected one less that to the rigid surface,
    /// when this touches with its highest pixel \[m\].
    pub(crate) fn distance(&self, deflection: f64, height: f64) -> f64 {
        deflection + (self.highest - height)
    }

    /// Whether a pixel may move when its gap is `gap`.
    fn moves(&self, pressure: f64, gap: f64) -> bool {
        ((pressure > 0.0) | (gap < 0.0)) & ((pressure < self.cap) | (gap > 0.0))
    }
}

/// The state of an iteration.
#[derive(Debug, Clone, Copy)]
struct Standing {
    /// Position of the rigid surface \[m\]: gap = distance - offset.
    offset: f64,
    /// Upper bound of the energy that can still be gained, per load \[m\]: 0 at the solution.
    remainder: f64,
    energy: f64,
    /// Mean gap of the pixels that may move.
    moving_gap: f64,
    /// Share of the contact that is between the bounds.
    free: f64,
}

/// Pressures, their deflections, and directions and gradients of the last step: six maps.
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

/// Called with the number of iterations and the residual.
pub(crate) type Watch<'a> = &'a mut dyn FnMut(usize, f64) -> ControlFlow<()>;

/// When an iteration ends.
#[derive(Clone, Copy)]
pub(crate) struct Goal {
    /// Unit of the residual \[m\].
    pub(crate) scale: f64,
    pub(crate) tolerance: f64,
    pub(crate) most_iterations: usize,
}

/// The state at which an iteration ended.
pub(crate) struct Reached {
    pub(crate) offset: f64,
    pub(crate) residual: f64,
    pub(crate) iterations: usize,
}

impl<'a> Iteration<'a> {
    /// Iterates from `start` to the goal; `cold` where the contact of `start` is not a guess.
    pub(crate) fn run(
        problem: Problem<'a>,
        start: Vec<f64>,
        cold: bool,
        goal: Goal,
        space: &mut (impl Compliance + Send),
        watch: Watch<'_>,
    ) -> Result<(Self, Reached), BemError> {
        let mut iteration = inside(|| Self::new(problem, start, space));
        let mut iterations = 0;
        loop {
            let standing = inside(|| iteration.standing());
            let residual = (standing.remainder / goal.scale).max(0.0);
            if residual <= goal.tolerance {
                let offset = standing.offset;
                return Ok((iteration, Reached { offset, residual, iterations }));
            }
            if watch(iterations, residual).is_break() {
                return Err(BemError::Cancelled);
            }
            let first = cold && iterations == 0;
            if iterations >= goal.most_iterations
                || !inside(|| iteration.advance(standing, first, space))
            {
                let required = goal.tolerance;
                return Err(BemError::NotConverged { residual, iterations, required });
            }
            iterations += 1;
        }
    }

    /// Starts at the admissible pressures nearest to `pressures`.
    fn new(problem: Problem<'a>, mut pressures: Vec<f64>, space: &mut impl Compliance) -> Self {
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

    fn deflect(&mut self, space: &mut impl Compliance) {
        self.deflections.copy_from_slice(&self.pressures);
        space.apply(Filter::Deflect, &mut self.deflections);
    }

    /// The position of the rigid surface, and the energy still to be gained.
    fn standing(&self) -> Standing {
        let problem = self.problem;
        let Problem { heights, cap, load, .. } = problem;
        let maps = [&self.pressures, &self.deflections, heights];
        let [free, free_distance, touching] = sum(maps, |[pressure, deflection, height]| {
            let touches = number(pressure > 0.0);
            let free = touches * number(pressure < cap);
            [free, free * problem.distance(deflection, height), touches]
        });
        let offset = if free > 0.0 { free_distance / free } else { self.offset_between_bounds() };
        let zero = (f64::INFINITY, [0.0; 5]);
        let fold = |(least, [moving, gaps, open, beyond, energy]): (f64, [f64; 5]),
                    [pressure, deflection, height]: [f64; 3]| {
            let distance = problem.distance(deflection, height);
            let gap = distance - offset;
            let moves = number(problem.moves(pressure, gap));
            let closed = if gap < 0.0 { pressure - cap } else { pressure };
            let sums = [
                moving + moves,
                gaps + moves * gap,
                open + pressure * gap,
                beyond + closed * gap,
                energy + pressure * (distance - 0.5 * deflection),
            ];
            (f64::min(least, gap), sums)
        };
        let join = |a: (f64, [f64; 5]), b: (f64, [f64; 5])| {
            (a.0.min(b.0), std::array::from_fn(|k| a.1[k] + b.1[k]))
        };
        let (least, [moving, gaps, open, beyond, energy]) = reduce(maps, zero, fold, join);
        Standing {
            offset,
            remainder: if cap.is_finite() { beyond / load } else { open / load - least },
            energy,
            moving_gap: if moving > 0.0 { gaps / moving } else { 0.0 },
            free: if touching > 0.0 { free / touching } else { 0.0 },
        }
    }

    /// The offset when every pixel of the contact is plastic: half-way between the plastic pixel
    /// that is pressed in least and the lowest of the others.
    fn offset_between_bounds(&self) -> f64 {
        let problem = self.problem;
        let maps = [&self.pressures, &self.deflections, problem.heights];
        let fold = |[plastic, open]: [f64; 2], [pressure, deflection, height]: [f64; 3]| {
            let distance = problem.distance(deflection, height);
            if pressure > 0.0 {
                [f64::max(plastic, distance), open]
            } else {
                [plastic, f64::min(open, distance)]
            }
        };
        let join = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
        let [plastic, open] = reduce(maps, [f64::NEG_INFINITY, f64::INFINITY], fold, join);
        if open.is_finite() { 0.5 * (plastic + open) } else { plastic }
    }

    /// One step; false when no direction lowers the energy.
    fn advance(&mut self, standing: Standing, cold: bool, space: &mut impl Compliance) -> bool {
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

    fn conjugate_step(&mut self, standing: Standing, space: &mut impl Compliance) -> bool {
        let Standing { offset, moving_gap, .. } = standing;
        let problem = self.problem;
        let maps = [&self.pressures[..], &self.deflections, problem.heights];
        // Whether a pixel moves, and its gap about the mean of those that do.
        let slope = |[pressure, deflection, height]: [f64; 3]| {
            let gap = problem.distance(deflection, height) - offset;
            let moves = number(problem.moves(pressure, gap));
            (moves, moves * (gap - moving_gap))
        };
        update(&mut self.gradient, maps, |gradient, here| {
            *gradient = slope(here).1;
            []
        });
        space.apply(Filter::Undo, &mut self.gradient);

        let [p, u, h] = maps;
        let all = [p, u, h, &self.gradient, &self.previous, &self.direction];
        let [moving, product, overlap, gradients, directions] =
            sum(all, |[p, u, h, gradient, previous, direction]| {
                let (moves, slope) = slope([p, u, h]);
                let products = [slope * gradient, slope * previous];
                [moves, products[0], products[1], moves * gradient, moves * direction]
            });
        let turn = match self.product {
            Some(before) => ((product - overlap) / before).min(product / before).max(0.0),
            None => 0.0,
        };
        let mean = (gradients + turn * directions) / moving;
        let others = [p, u, h, &self.gradient];
        let [descent] = update(&mut self.direction, others, |direction, [p, u, h, gradient]| {
            let (moves, slope) = slope([p, u, h]);
            *direction = moves * (gradient + turn * *direction - mean);
            [slope * *direction]
        });
        std::mem::swap(&mut self.gradient, &mut self.previous);
        let response = &mut self.gradient;
        response.copy_from_slice(&self.direction);
        space.apply(Filter::Deflect, response);
        let (direction, response) = (&self.direction, &self.gradient);
        let [curvature] =
            sum([direction, response], |[direction, response]| [direction * response]);
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
            update(&mut self.deflections, [response], |deflection, [response]| {
                *deflection -= length * response;
                []
            });
        }
        true
    }

    fn plain_step(&mut self, space: &mut impl Compliance) -> bool {
        let problem = self.problem;
        let Problem { heights, cap, load, .. } = problem;
        self.product = None;
        let maps = [&self.deflections, heights];
        let [distances] = sum(maps, |[deflection, height]| [problem.distance(deflection, height)]);
        let mean = distances / heights.len() as f64;
        let [descent] = update(&mut self.gradient, maps, |gradient, [deflection, height]| {
            *gradient = problem.distance(deflection, height) - mean;
            [gradient.powi(2)]
        });
        self.previous.copy_from_slice(&self.gradient);
        space.apply(Filter::Deflect, &mut self.previous);
        let gradients = [&self.gradient[..], &self.previous];
        let [curvature] = sum(gradients, |[gradient, response]| [gradient * response]);
        let length = descent / curvature;
        if !(length > 0.0 && length.is_finite()) {
            return false;
        }
        let step = Projection::new(&self.pressures, &self.gradient, length, cap, load);
        self.direction.copy_from_slice(&self.pressures);
        step.step(&mut self.direction, &self.gradient);
        self.previous.copy_from_slice(&self.direction);
        space.apply(Filter::Deflect, &mut self.previous);
        let all = [
            &self.pressures[..],
            &self.direction,
            &self.gradient,
            &self.deflections,
            &self.previous,
        ];
        let [descent, curvature] = sum(all, |[pressure, end, gradient, deflection, response]| {
            let change = end - pressure;
            [-gradient * change, change * (response - deflection)]
        });
        let length = if descent < curvature { descent / curvature } else { 1.0 };
        if !(descent > 0.0 && length > 0.0) {
            return false;
        }
        update(&mut self.pressures, [&self.direction], |pressure, [end]| {
            *pressure = if length < 1.0 { *pressure + length * (end - *pressure) } else { end };
            []
        });
        update(&mut self.deflections, [&self.previous], |deflection, [response]| {
            *deflection += length * (response - *deflection);
            []
        });
        true
    }
}
