//! The solver: one contact, or a list of them.

use std::ops::ControlFlow;

use asperity_core::Finding;

use crate::half_space::HalfSpace;
use crate::height_map::positive;
use crate::iteration::{Goal, Iteration, Problem, Reached, Watch};
use crate::solution::{Fields, LoadCase, Solution};
use crate::{BemError, Boundary, HeightMap, note};

/// Trials for a gap.
const MOST_TRIALS: usize = 60;
/// Largest mean pressure over the modulus: beyond, heights are lost in the rounding of deflections.
const HIGHEST: f64 = 1e6;
/// Error of a gap, in tolerances of the residual times Sq.
const GAP_ERROR: f64 = 10.0;

/// The progress of a list of contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// Place in the list of the contact that is being solved.
    pub index: usize,
    /// How many contacts of the list are done.
    pub done: usize,
    /// Iterations made for this one.
    pub iterations: usize,
    /// Its residual so far.
    pub residual: f64,
}

/// A rigid rough surface above an elastic half-space, with the settings of the solver.
///
/// With the feature `rayon`, runs on the threads of its current pool; the digits do not depend on
/// their number.
#[derive(Debug, Clone, PartialEq)]
pub struct BoundaryElements {
    pub(crate) map: HeightMap,
    pub(crate) modulus: f64,
    /// Periodic, if not declared.
    boundary: Option<Boundary>,
    hardness: Option<f64>,
    tolerance: f64,
    most_iterations: usize,
}

impl BoundaryElements {
    /// An elastic, periodic contact of `map` with a half-space of the equivalent modulus
    /// `modulus` \[Pa\], E/(1 - ν²) when only one of the bodies deforms.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when the modulus is not a positive number.
    pub fn new(map: HeightMap, modulus: f64) -> Result<Self, BemError> {
        Ok(Self {
            map,
            modulus: positive("equivalent modulus", modulus)?,
            boundary: None,
            hardness: None,
            tolerance: 1e-8,
            most_iterations: 1000,
        })
    }

    /// Declares the boundary; otherwise the map is periodic, with a warning where its edges do not
    /// match.
    #[must_use]
    pub fn boundary(mut self, boundary: Boundary) -> Self {
        self.boundary = Some(boundary);
        self
    }

    /// Limits the pressure to `hardness` \[Pa\].
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when it is not a positive number.
    pub fn hardness(mut self, hardness: f64) -> Result<Self, BemError> {
        self.hardness = Some(positive("hardness", hardness)?);
        Ok(self)
    }

    /// Largest [residual](Solution::residual), 1e-8 by default, which leaves about 1e-8 of its
    /// scale in the gap.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] outside 1e-13 to 0.1.
    pub fn tolerance(mut self, tolerance: f64) -> Result<Self, BemError> {
        if !(1e-13..=0.1).contains(&tolerance) {
            let required = "a number from 1e-13 to 0.1";
            return Err(BemError::OutOfRange { field: "tolerance", found: tolerance, required });
        }
        self.tolerance = tolerance;
        Ok(self)
    }

    /// Largest number of iterations for one load; 1000 by default, 15 to 60 are usual.
    #[must_use]
    pub fn most_iterations(mut self, most_iterations: usize) -> Self {
        self.most_iterations = most_iterations;
        self
    }

    /// The hardness \[Pa\]; `None` if the contact is elastic.
    #[must_use]
    pub fn limit(&self) -> Option<f64> {
        self.hardness
    }

    pub(crate) fn cap(&self) -> f64 {
        self.hardness.unwrap_or(f64::INFINITY)
    }

    /// Unit of the residual \[m\]: Sq or, where that is less, about the deflection of one pixel
    /// that carries all of the load, the scale of gaps under light loads and on a flat map.
    pub(crate) fn scale(&self, pressure: f64, rms_height: f64) -> f64 {
        let [dy, dx] = self.map.pixel();
        let pressed_in = pressure * self.map.area() / (self.modulus * dx.min(dy));
        if rms_height > 0.0 { rms_height.min(pressed_in) } else { pressed_in }
    }

    pub(crate) fn goal(&self, scale: f64) -> Goal {
        Goal { scale, tolerance: self.tolerance, most_iterations: self.most_iterations }
    }

    pub(crate) fn boundary_condition(&self) -> Boundary {
        self.boundary.unwrap_or_default()
    }

    /// Solves one contact.
    ///
    /// # Errors
    /// [`BemError::OutOfRange`] when the load or gap is not a positive number,
    /// [`BemError::CannotBeCarried`] above the hardness, [`BemError::NothingTouches`] above the
    /// highest point, [`BemError::NotConverged`] when the tolerance was not reached.
    pub fn solve(&self, given: LoadCase) -> Result<Solution, BemError> {
        let mut solutions = self.solve_all(&[given], |_| ControlFlow::Continue(()));
        solutions.pop().unwrap_or(Err(BemError::Cancelled))
    }

    /// Solves a list: each contact starts at the pressures of the one before it, from the greatest
    /// load down, and the answers are in the order of the list. `progress` is called at every
    /// iteration and may stop the run: solved contacts are kept, the others are
    /// [`BemError::Cancelled`]. A failed contact does not change the others.
    pub fn solve_all(
        &self,
        given: &[LoadCase],
        progress: impl FnMut(&Progress) -> ControlFlow<()>,
    ) -> Vec<Result<Solution, BemError>> {
        let mut solutions: Vec<_> = given.iter().map(|_| Err(BemError::Cancelled)).collect();
        self.solve_each(given, progress, |index, solution| solutions[index] = solution);
        solutions
    }

    /// As [`BoundaryElements::solve_all`], but every answer is passed on as soon as it is solved,
    /// with its place in the list: for lists whose maps would fill the memory, and for runs that
    /// may be killed.
    pub fn solve_each(
        &self,
        given: &[LoadCase],
        mut progress: impl FnMut(&Progress) -> ControlFlow<()>,
        mut solved: impl FnMut(usize, Result<Solution, BemError>),
    ) {
        let mut run = Run::new(self);
        let mut order: Vec<(usize, LoadCase)> = given.iter().copied().enumerate().collect();
        order.sort_by(|(_, a), (_, b)| self.lightness(*a).total_cmp(&self.lightness(*b)));
        let mut stopped = false;
        for (done, &(index, given)) in order.iter().enumerate() {
            let solution = if stopped {
                Err(BemError::Cancelled)
            } else {
                run.solve(given, &mut |iterations, residual| {
                    progress(&Progress { index, done, iterations, residual })
                })
            };
            stopped = matches!(solution, Err(BemError::Cancelled));
            solved(index, solution);
        }
    }

    /// Grows as loads fall; all loads come before all gaps.
    fn lightness(&self, given: LoadCase) -> f64 {
        match given {
            LoadCase::MeanPressure(pressure) => -pressure,
            LoadCase::Load(load) => -load / self.map.area(),
            LoadCase::MeanGap(gap) | LoadCase::Separation(gap) => gap,
        }
    }
}

/// A list being solved.
pub(crate) struct Run<'a> {
    setup: &'a BoundaryElements,
    space: HalfSpace,
    rms_height: f64,
    resolution: Vec<Finding>,
    /// Pressures of the last contact, and their mean.
    last: Option<(Vec<f64>, f64)>,
}

impl<'a> Run<'a> {
    pub(crate) fn new(setup: &'a BoundaryElements) -> Self {
        let mut space = HalfSpace::new(&setup.map, setup.modulus, setup.boundary_condition());
        let resolution = note::of_map(&setup.map, setup.boundary, &mut space);
        Self { setup, space, rms_height: setup.map.rms_height(), resolution, last: None }
    }

    /// Goes on from the pressures of a solution of this map.
    pub(crate) fn after(setup: &'a BoundaryElements, solution: &Solution) -> Self {
        let last = Some((solution.pressures.clone(), solution.mean_pressure));
        Self { last, ..Self::new(setup) }
    }

    pub(crate) fn solve(
        &mut self,
        given: LoadCase,
        watch: Watch<'_>,
    ) -> Result<Solution, BemError> {
        let area = self.setup.map.area();
        let fields = match given {
            LoadCase::MeanPressure(pressure) => {
                self.press(positive("mean pressure", pressure)?, watch)
            }
            LoadCase::Load(load) => self.press(positive("load", load)? / area, watch),
            LoadCase::MeanGap(gap) => {
                self.approach(positive("mean gap", gap)?, Fields::mean_gap, watch)
            }
            LoadCase::Separation(separation) if separation.is_finite() => {
                self.approach(separation, |fields| fields.separation, watch)
            }
            LoadCase::Separation(found) => {
                let required = "a finite number";
                Err(BemError::OutOfRange { field: "separation", found, required })
            }
        }?;
        let of = (&self.setup.map, self.setup.boundary_condition(), self.setup.cap());
        Ok(Solution::new(given, of, fields, self.resolution.clone()))
    }

    /// Contact at a mean pressure.
    pub(crate) fn press(&mut self, pressure: f64, watch: Watch<'_>) -> Result<Fields, BemError> {
        let map = &self.setup.map;
        let (cap, heights) = (self.setup.cap(), map.heights());
        if pressure >= cap {
            return Err(BemError::CannotBeCarried { pressure, hardness: cap });
        }
        if pressure > HIGHEST * self.setup.modulus {
            let (field, required) = ("mean pressure", "at most 1e6 times the equivalent modulus");
            return Err(BemError::OutOfRange { field, found: pressure, required });
        }
        let pixels = heights.len() as f64;
        let highest = map.highest();
        let problem = Problem { heights, highest, cap, load: pressure * pixels };
        let scale = self.setup.scale(pressure, self.rms_height);
        let cold = self.last.is_none();
        let start = match self.last.take() {
            // Lighter loads follow: the projection lowers all pressures evenly.
            Some((pressures, last)) if pressure <= last => pressures,
            Some((pressures, last)) => pressures.iter().map(|p| p * pressure / last).collect(),
            None => vec![pressure; heights.len()],
        };
        let goal = self.setup.goal(scale);
        let (iteration, Reached { offset, residual, iterations }) =
            Iteration::run(problem, start, cold, goal, &mut self.space, watch)?;
        let (pressures, mut gaps) = iteration.into_maps();
        for (gap, height) in gaps.iter_mut().zip(heights) {
            *gap = problem.distance(*gap, *height) - offset;
        }
        self.last = Some((pressures.clone(), pressure));
        let separation = match self.setup.boundary_condition() {
            Boundary::Periodic => gaps.iter().sum::<f64>() / pixels,
            Boundary::Free => highest - offset,
        };
        Ok(Fields { pressures, gaps, separation, residual, iterations })
    }

    /// Contact at a mean gap or separation: a secant on the logarithm of the pressure, kept between
    /// bounds.
    fn approach(
        &mut self,
        target: f64,
        measure: fn(&Fields) -> f64,
        watch: Watch<'_>,
    ) -> Result<Fields, BemError> {
        let BoundaryElements { map, modulus, tolerance, .. } = self.setup;
        let highest = map.highest();
        if target >= highest {
            return Err(BemError::NothingTouches { gap: target, highest });
        }
        let close = GAP_ERROR * tolerance * self.rms_height;
        let most = self.setup.cap();
        let guess = modulus * self.rms_height / map.area().sqrt();
        let mut logarithm = guess.min(most / 2.0).ln();
        // Light loads have the stiffness p/(Sq/2), about.
        let mut slope = -0.5 * self.rms_height;
        let (mut light, mut heavy) = (f64::NEG_INFINITY, most.ln());
        let mut before: Option<(f64, f64)> = None;
        let mut iterations = 0;
        for _ in 0..MOST_TRIALS {
            let mut fields =
                self.press(logarithm.exp(), &mut |i, residual| watch(iterations + i, residual))?;
            iterations += fields.iterations;
            let excess = measure(&fields) - target;
            if excess.abs() <= close {
                fields.iterations = iterations;
                return Ok(fields);
            }
            if excess > 0.0 {
                light = logarithm
            } else {
                heavy = logarithm
            }
            if let Some((other, other_excess)) = before {
                let secant = (excess - other_excess) / (logarithm - other);
                if secant < 0.0 {
                    slope = secant;
                }
            }
            before = Some((logarithm, excess));
            let next = logarithm - excess / slope;
            logarithm = if next > light && next < heavy {
                next.clamp(logarithm - 5.0, logarithm + 5.0)
            } else if light.is_finite() && heavy.is_finite() {
                0.5 * (light + heavy)
            } else {
                logarithm + if excess > 0.0 { 1.0 } else { -1.0 }
            };
        }
        Err(BemError::GapNotFound { gap: target, trials: MOST_TRIALS })
    }
}
