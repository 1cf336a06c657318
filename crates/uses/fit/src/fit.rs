//! A fit of one model: data, free parameters and the search.

use std::cell::RefCell;
use std::ops::ControlFlow;

use asperity_core::ContactModel;
use nalgebra::DVector;

use crate::columns::plural;
use crate::forward::Forward;
use crate::problem::{MakeScene, Minimum, Problem, squares};
use crate::search::{PATIENCE, search};
use crate::solution::Solution;
use crate::spread::Spread;
use crate::{Data, FitError, Fitted, Parameter};

/// The state of a running fit.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub struct Progress {
    /// The model's id.
    pub model: String,
    /// Evaluations of the model for all data so far.
    pub evaluations: usize,
    /// Starts of the search so far.
    pub starts: usize,
}

/// Data and the parameters to fit to them.
///
/// ```
/// use asperity_core::{Datum, Interface, Scene, Surface};
/// use asperity_fit::{Data, Fit, Parameter};
/// use asperity_gw::GreenwoodWilliamson;
///
/// let columns = [("load_N", [10.0, 100.0]), ("area_m2", [4.07e-9, 3.89e-8])];
/// let columns = columns.map(|(name, values)| (name.to_string(), values.map(Some).to_vec()));
/// let data = Data::from_columns(&columns, Datum::AsperityMean)?;
/// let height_std = Parameter::new("asperity_height_std", "m", 2e-6, [1e-7, 1e-5], 1e-6)?;
/// let scene = |numbers: &[f64]| {
///     let surface = Surface::new(2e-4, 2e8, numbers[0]);
///     Ok(Scene::new(Interface::new(115e9, 0.3, 2e9), surface, 1e-4))
/// };
/// let fitted = Fit::new(&data, vec![height_std], &scene)?.run(&GreenwoodWilliamson)?;
/// let found = &fitted.parameters[0];
/// assert!(found.lower < Some(1e-6) && found.upper > Some(1e-6), "{found:?}");
/// # Ok::<(), asperity_fit::FitError>(())
/// ```
pub struct Fit<'f> {
    data: &'f Data,
    parameters: Vec<Parameter>,
    scene: &'f MakeScene<'f>,
    /// Starts of the search beside the one given, 3 by default.
    pub more_starts: usize,
}

impl<'f> Fit<'f> {
    /// A fit of parameters to data; `scene` makes the scene from the values of those that are
    /// numbers of the scene, in their order.
    ///
    /// # Errors
    /// [`FitError::Parameter`] for a parameter that is given twice or for none,
    /// [`FitError::Data`] for too few.
    pub fn new(
        data: &'f Data,
        parameters: Vec<Parameter>,
        scene: &'f MakeScene<'f>,
    ) -> Result<Self, FitError> {
        let refused = |parameter: &str, reason: &str| {
            Err(FitError::Parameter { parameter: parameter.into(), reason: reason.into() })
        };
        if parameters.is_empty() {
            return refused("free parameters", "at least one was required");
        }
        for (place, one) in parameters.iter().enumerate() {
            if parameters[..place].iter().any(|other| other.name == one.name) {
                return refused(&one.name, "it is given twice");
            }
        }
        if data.len() < parameters.len() {
            let (values, free) = (plural(data.len(), "measured value"), parameters.len());
            return Err(FitError::Data(format!(
                "{values} for {free} free parameters: at least as many values as free parameters were required"
            )));
        }
        Ok(Self { data, parameters, scene, more_starts: 3 })
    }

    /// [`run_with`](Self::run_with) without an observer.
    ///
    /// # Errors
    /// The errors of [`run_with`](Self::run_with).
    pub fn run(&self, model: &dyn ContactModel) -> Result<Fitted, FitError> {
        self.run_with(model, &mut |_| ControlFlow::Continue(()))
    }

    /// Fits a model; `progress` is called before every evaluation and may end the fit.
    ///
    /// # Errors
    /// [`FitError::NoStart`] if the model has no value for the data anywhere, and
    /// [`FitError::Interrupted`].
    pub fn run_with(
        &self,
        model: &dyn ContactModel,
        progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Fitted, FitError> {
        let state = Progress { model: model.id().into(), ..Progress::default() };
        let counted = RefCell::new((progress, state));
        let count = |[starts, evaluations]: [usize; 2]| {
            let (progress, state) = &mut *counted.borrow_mut();
            state.starts += starts;
            state.evaluations += evaluations;
            if evaluations > 0 { progress(state) } else { ControlFlow::Continue(()) }
        };
        let (data, parameters, scene) = (self.data, &self.parameters[..], self.scene);
        let forward = Forward::new(model, data)
            .map_err(|reason| FitError::NoStart { model: model.id().into(), reason })?;
        let problem = Problem { model, forward: &forward, data, parameters, scene, count: &count };
        let best = near_the_start(&problem, search(&problem, self.more_starts, PATIENCE)?)?;
        let mut fitted = Solution::new(&problem, &best)?.describe();
        fitted.evaluations = counted.borrow().1.evaluations;
        Ok(fitted)
    }
}

/// The minimum with the least change of combinations that the data do not fix: what the search
/// makes of these is chance.
fn near_the_start(problem: &Problem<'_>, best: Minimum) -> Result<Minimum, FitError> {
    let Some(spread) = Spread::new(problem, &best)? else { return Ok(best) };
    let free = spread.free_directions();
    if free.ncols() == 0 {
        return Ok(best);
    }
    let parameters = problem.parameters.iter();
    let change = parameters.zip(&best.coordinates).map(|(p, x)| x - p.coordinate(p.start));
    let change = DVector::from_iterator(best.coordinates.len(), change);
    let idle = &free * (free.transpose() * change);
    let moved: Vec<f64> = best.coordinates.iter().zip(&idle).map(|(x, idle)| x - idle).collect();
    let inside = |(one, x): (&Parameter, &f64)| (one.range()[0]..=one.range()[1]).contains(x);
    let squares = squares(&problem.residuals(&moved)?);
    let same = squares <= best.squares * (1.0 + 1e-6) + problem.met();
    match same && problem.parameters.iter().zip(&moved).all(inside) {
        true => Ok(Minimum { coordinates: moved, squares, ..best }),
        false => Ok(best),
    }
}
