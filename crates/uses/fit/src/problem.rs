//! The residuals of a fit, their derivatives, and the least squares from one start.

use std::cell::RefCell;
use std::f64::consts::PI;
use std::ops::ControlFlow;

use asperity_core::{ContactError, ContactModel, Scene};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt, TerminationReason};
use nalgebra::storage::Owned;
use nalgebra::{DMatrix, DVector, Dyn};

use crate::forward::{Forward, Rig};
use crate::{Data, FitError, Observation, Parameter, Role};

/// The coarse tolerance of angles, and of sums of squares, where each scene takes long.
const COARSE: f64 = 1e-4;
/// Least residual that is above the errors of the values.
const MET: f64 = 1e-10;
/// The residual of a value that the model does not have, larger than from any start.
pub(crate) const NO_VALUE: f64 = 1e10;

/// The angle in the middle of the bounds: the solver's first step is a share of the angles, so that
/// a search from angles of 0 would not move.
const MIDDLE: f64 = PI;
/// The largest first step as a share of the angles.
const FIRST_STEP: f64 = 0.3;

/// A function from the values of the parameters with [`Role::Scene`] to the scene.
pub type MakeScene<'f> = dyn Fn(&[f64]) -> Result<Scene, ContactError> + 'f;

/// A model with its data and parameters.
pub(crate) struct Problem<'f> {
    pub(crate) model: &'f dyn ContactModel,
    pub(crate) forward: &'f Forward<'f>,
    pub(crate) data: &'f Data,
    pub(crate) parameters: &'f [Parameter],
    pub(crate) scene: &'f MakeScene<'f>,
    /// Counts starts and evaluations for the caller of a long fit, who may end it.
    pub(crate) count: &'f (dyn Fn([usize; 2]) -> ControlFlow<()> + 'f),
}

/// A minimum of the residuals.
#[derive(Debug, Clone)]
pub(crate) struct Minimum {
    pub(crate) coordinates: Vec<f64>,
    /// Sum of squares.
    pub(crate) squares: f64,
    pub(crate) converged: bool,
}

impl Minimum {
    /// Whether a coordinate differs by more than `distance`.
    pub(crate) fn is_far_from(&self, other: &Self, distance: f64) -> bool {
        let mut both = self.coordinates.iter().zip(&other.coordinates);
        both.any(|(a, b)| (a - b).abs() > distance)
    }
}

impl Problem<'_> {
    /// Relative accuracy of the values.
    pub(crate) fn accuracy(&self) -> f64 {
        self.forward.tolerance
    }

    /// Step of the differences, as a coordinate: errors from the third derivative go with its
    /// square, the errors of the values, mostly a tenth of the accuracy, with its inverse.
    fn step(&self) -> f64 {
        (0.1 * self.accuracy()).cbrt()
    }

    /// Relative error of the derivatives.
    pub(crate) fn slope_error(&self) -> f64 {
        0.1 * self.accuracy() / self.step()
    }

    /// Sum of squares below which the data are met to the accuracy of the values.
    pub(crate) fn met(&self) -> f64 {
        MET.max(10.0 * self.accuracy()).powi(2) * self.data.len() as f64
    }

    /// The coordinates from which the fit starts.
    pub(crate) fn start(&self) -> Vec<f64> {
        self.parameters.iter().map(|one| one.coordinate(one.start)).collect()
    }

    /// The scene and the rig at coordinates.
    fn at(&self, coordinates: &[f64]) -> Result<(Scene, Rig), ContactError> {
        let (mut numbers, mut rig) = (vec![], Rig::default());
        for (parameter, coordinate) in self.parameters.iter().zip(coordinates) {
            let value = parameter.value(*coordinate);
            match parameter.role {
                Role::Scene => numbers.push(value),
                Role::SeparationOffset => rig.separation_offset = value,
                Role::SeriesCompliance => rig.series_compliance = value,
            }
        }
        Ok(((self.scene)(&numbers)?, rig))
    }

    /// The predicted values, or the first reason why one is missing.
    pub(crate) fn predicted(&self, coordinates: &[f64]) -> Result<Vec<f64>, ContactError> {
        let (scene, rig) = self.at(coordinates)?;
        self.forward.predict(&scene, rig).into_iter().collect()
    }

    /// The residuals: differences of logarithms, or differences over the standard deviations.
    pub(crate) fn residuals(&self, coordinates: &[f64]) -> Result<Vec<f64>, FitError> {
        if (self.count)([0, 1]).is_break() {
            return Err(FitError::Interrupted);
        }
        let made = self.at(coordinates);
        let predicted = made.map(|(scene, rig)| self.forward.predict(&scene, rig));
        let Ok(predicted) = predicted else { return Ok(vec![NO_VALUE; self.data.len()]) };
        let residual = |(one, value): (&Observation, Result<f64, ContactError>)| {
            let Ok(value) = value else { return NO_VALUE };
            let found = match one.std {
                Some(std) => (value - one.value) / std,
                None if one.measured.is_difference() => value - one.value,
                None => (value / one.value).ln(),
            };
            if found.is_finite() { found } else { NO_VALUE }
        };
        Ok(self.data.iter().zip(predicted).map(residual).collect())
    }

    /// The derivatives of the residuals by coordinates, one column for each of `free`; one-sided
    /// from the residuals `here`, if they are given, which do for a search.
    pub(crate) fn jacobian(
        &self,
        coordinates: &[f64],
        free: &[usize],
        here: Option<&[f64]>,
    ) -> Result<DMatrix<f64>, FitError> {
        let missing = |residual: &f64| *residual >= NO_VALUE;
        let (step, mut found) = (self.step(), DMatrix::zeros(self.data.len(), free.len()));
        for (column, place) in free.iter().enumerate() {
            let [low, high] = self.parameters[*place].range();
            // Both ends within the bounds.
            let middle = coordinates[*place];
            let ends = [(middle - step).max(low), (middle + step).min(high)];
            let mut moved = coordinates.to_vec();
            let mut at = |end: f64| {
                moved[*place] = end;
                self.residuals(&moved)
            };
            if let Some(here) = here {
                // Errors of the second derivative go with the step.
                let aside = (0.1 * self.accuracy()).sqrt();
                let aside = if middle + aside <= high { aside } else { -aside };
                let there = at(middle + aside)?;
                if !here.iter().chain(&there).any(missing) {
                    for (row, (here, there)) in here.iter().zip(&there).enumerate() {
                        found[(row, column)] = (there - here) / aside;
                    }
                    continue;
                }
            }
            let [below, above] = [at(ends[0])?, at(ends[1])?];
            let is_edge = below.iter().any(missing) != above.iter().any(missing);
            let here = if is_edge { Some(self.residuals(coordinates)?) } else { None };
            for (row, (below, above)) in below.iter().zip(&above).enumerate() {
                // One-sided where values end.
                let here = here.as_ref().and_then(|here| here.get(row)).copied();
                let slope = match (missing(below), missing(above), here) {
                    (true, false, Some(here)) => (above - here) / (ends[1] - middle),
                    (false, true, Some(here)) => (here - below) / (middle - ends[0]),
                    _ => (above - below) / (ends[1] - ends[0]),
                };
                found[(row, column)] = if slope.is_finite() { slope } else { NO_VALUE };
            }
        }
        Ok(found)
    }

    /// The least squares of all parameters from a start.
    pub(crate) fn minimise_all(&self, start: &[f64], patience: usize) -> Result<Minimum, FitError> {
        let all: Vec<usize> = (0..start.len()).collect();
        self.minimise(start, &all, (patience, self.fine()))
    }

    /// The tolerance of a search for a minimum: changes well below the accuracy of the values are
    /// chance.
    pub(crate) fn fine(&self) -> f64 {
        (0.05 * self.accuracy()).max(30.0 * f64::EPSILON)
    }

    /// The tolerance where a minimum is only looked for, or its sum of squares is all that counts.
    pub(crate) fn coarse(&self) -> f64 {
        if self.forward.is_slow() { COARSE } else { self.fine() }
    }

    /// The least squares of the `free` parameters from a start, to a tolerance; the others stay.
    pub(crate) fn minimise(
        &self,
        start: &[f64],
        free: &[usize],
        (patience, tolerance): (usize, f64),
    ) -> Result<Minimum, FitError> {
        if free.is_empty() {
            let squares = squares(&self.residuals(start)?);
            return Ok(Minimum { coordinates: start.to_vec(), squares, converged: true });
        }
        let angles = free.iter().map(|place| self.angle(*place, start[*place]));
        let angles = DVector::from_iterator(free.len(), angles);
        let (ended, last) = (RefCell::new(None), RefCell::new(None));
        let inner = Inner { problem: self, start, free, angles, ended, last };
        let search = LevenbergMarquardt::new().with_patience(patience).with_stepbound(FIRST_STEP);
        let (inner, report) = search.with_tol(tolerance).minimize(inner);
        if let Some(error) = inner.ended.take() {
            return Err(error);
        }
        let converged = matches!(
            report.termination,
            TerminationReason::ResidualsZero
                | TerminationReason::Orthogonal
                | TerminationReason::Converged { .. }
                | TerminationReason::NoImprovementPossible(_)
        );
        let squares = 2.0 * report.objective_function;
        Ok(Minimum { coordinates: inner.coordinates(), squares, converged })
    }

    /// The angle of a coordinate: bounds are at ±π/2 around [`MIDDLE`], and a search passes through
    /// them.
    fn angle(&self, place: usize, coordinate: f64) -> f64 {
        let [low, high] = self.parameters[place].range();
        // At a bound itself the derivative is 0.
        let share = ((coordinate - low) / (high - low)).clamp(1e-4, 1.0 - 1e-4);
        MIDDLE + (2.0 * share - 1.0).asin()
    }
}

pub(crate) fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|residual| residual * residual).sum()
}

/// The problem in the angles of its free coordinates, as the solver has it.
struct Inner<'a, 'f> {
    problem: &'a Problem<'f>,
    start: &'a [f64],
    free: &'a [usize],
    angles: DVector<f64>,
    /// The reason why the caller or the scene ended the search.
    ended: RefCell<Option<FitError>>,
    /// The last residuals with their angles.
    last: RefCell<Option<(DVector<f64>, Vec<f64>)>>,
}

impl Inner<'_, '_> {
    fn coordinates(&self) -> Vec<f64> {
        let mut found = self.start.to_vec();
        for (place, angle) in self.free.iter().zip(&self.angles) {
            let [low, high] = self.problem.parameters[*place].range();
            found[*place] = low + (high - low) * 0.5 * (1.0 + (angle - MIDDLE).sin());
        }
        found
    }

    fn or_end<T>(&self, found: Result<T, FitError>) -> Option<T> {
        found.map_err(|error| *self.ended.borrow_mut() = Some(error)).ok()
    }
}

impl LeastSquaresProblem<f64, Dyn, Dyn> for Inner<'_, '_> {
    type ResidualStorage = Owned<f64, Dyn>;
    type JacobianStorage = Owned<f64, Dyn, Dyn>;
    type ParameterStorage = Owned<f64, Dyn>;

    fn set_params(&mut self, angles: &DVector<f64>) {
        self.angles.copy_from(angles);
    }

    fn params(&self) -> DVector<f64> {
        self.angles.clone()
    }

    fn residuals(&self) -> Option<DVector<f64>> {
        let found = self.or_end(self.problem.residuals(&self.coordinates()))?;
        *self.last.borrow_mut() = Some((self.angles.clone(), found.clone()));
        Some(DVector::from_vec(found))
    }

    fn jacobian(&self) -> Option<DMatrix<f64>> {
        let last = self.last.borrow();
        let is_here = |(angles, _): &&(DVector<f64>, Vec<f64>)| *angles == self.angles;
        let here = last.as_ref().filter(is_here).map(|(_, residuals)| &residuals[..]);
        let here = here.filter(|_| self.problem.forward.is_slow());
        let found = self.problem.jacobian(&self.coordinates(), self.free, here);
        let mut found = self.or_end(found)?;
        for (column, (place, angle)) in self.free.iter().zip(&self.angles).enumerate() {
            let [low, high] = self.problem.parameters[*place].range();
            found.column_mut(column).scale_mut(0.5 * (high - low) * (angle - MIDDLE).cos());
        }
        Some(found)
    }
}
