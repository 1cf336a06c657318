//! A fit of one model: search, spread, and what to say about them.

use std::cell::RefCell;
use std::ops::ControlFlow;

use asperity_core::{ContactModel, short};
use nalgebra::DVector;

use crate::combinations::undetermined;
use crate::deviations::Deviations;
use crate::forward::Forward;
use crate::likely_unit::likely_unit;
use crate::limits::limits;
use crate::misfit::{misfit, rms};
use crate::other_stiffness::other_stiffness;
use crate::outlier::outlier;
use crate::problem::{MakeScene, Minimum, Problem, Watch, squares};
use crate::reach::unreachable;
use crate::remark::{Remark, concerns, sentences};
use crate::search::{Found, search};
use crate::spread::Spread;
use crate::{Data, Estimate, FitError, Fitted, Parameter, Residual};

/// Residuals below this, relative, are errors of the values: they read 0 and rank no model.
const ACCURACY: f64 = 1e-12;

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
    /// [`FitError::TooFew`] data.
    pub fn new(
        data: &'f Data,
        parameters: Vec<Parameter>,
        scene: &'f MakeScene<'f>,
    ) -> Result<Self, FitError> {
        if parameters.is_empty() {
            let (parameter, reason) =
                ("free parameters".into(), "at least one was required".into());
            return Err(FitError::Parameter { parameter, reason });
        }
        for (place, one) in parameters.iter().enumerate() {
            if parameters[..place].iter().any(|other| other.name == one.name) {
                let (parameter, reason) = (one.name.clone(), "it is given twice".into());
                return Err(FitError::Parameter { parameter, reason });
            }
        }
        if data.len() < parameters.len() {
            return Err(FitError::TooFew { data: data.len(), parameters: parameters.len() });
        }
        Ok(Self { data, parameters, scene, more_starts: 3 })
    }

    /// [`run_with`](Self::run_with) without an observer.
    ///
    /// # Errors
    /// Those of [`run_with`](Self::run_with).
    pub fn run(&self, model: &dyn ContactModel) -> Result<Fitted, FitError> {
        self.run_with(model, &mut |_| ControlFlow::Continue(()))
    }

    /// Fits a model; `progress` is called before every evaluation and may end the fit.
    ///
    /// # Errors
    /// [`FitError::NoStart`] if the model has no value for the data anywhere, [`FitError::Unit`] if
    /// it has them in another unit of a column, and [`FitError::Interrupted`].
    pub fn run_with(
        &self,
        model: &dyn ContactModel,
        progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
    ) -> Result<Fitted, FitError> {
        let state = Progress { model: model.id().into(), ..Progress::default() };
        let watch = Watch { progress: RefCell::new(progress), state: RefCell::new(state) };
        let (data, parameters, scene) = (self.data, &self.parameters[..], self.scene);
        let forward = Forward::new(model, data)
            .map_err(|reason| FitError::NoStart { model: model.id().into(), reason })?;
        let forward = &forward;
        let problem = Problem { model, forward, data, parameters, scene, watch: &watch };
        let mut found = match search(&problem, self.more_starts) {
            Err(error @ FitError::NoStart { .. }) => {
                let unit = likely_unit(&problem, f64::INFINITY)?;
                let unlike = |likely| FitError::Unit { model: model.id().into(), likely };
                return Err(unit.map_or(error, unlike));
            }
            found => found?,
        };
        found.best = near_the_start(&problem, found.best)?;
        let mut fitted = self.describe(&problem, &found)?;
        fitted.evaluations = watch.state.borrow().evaluations;
        Ok(fitted)
    }

    fn describe(&self, problem: &Problem<'_>, found: &Found) -> Result<Fitted, FitError> {
        let best = &found.best;
        let no_start = |reason| FitError::NoStart { model: problem.model.id().into(), reason };
        let values = problem.predicted(&best.coordinates).map_err(no_start)?;
        let (scene, _) = problem.at(&best.coordinates).map_err(no_start)?;
        let residuals = problem.residuals(&best.coordinates)?;
        let spread = Spread::new(problem, best)?;
        let mut estimates = vec![];
        for (place, parameter) in self.parameters.iter().enumerate() {
            let interval = match &spread {
                Some(spread) => spread.interval(problem, best, place)?,
                None => [None, None],
            };
            let [lower, upper] = interval.map(|end| end.map(|end| parameter.value(end)));
            estimates.push(Estimate {
                name: parameter.name.clone(),
                value: parameter.value(best.coordinates[place]),
                lower,
                upper,
                unit: parameter.unit.clone(),
                bounds: parameter.bounds,
            });
        }
        let count = 0..self.parameters.len();
        let correlation = |a: usize| {
            let with = |b: usize| spread.as_ref().and_then(|spread| spread.correlation(a, b));
            count.clone().map(with).collect()
        };
        let free =
            spread.as_ref().map(|spread| undetermined(&self.parameters, &spread.free_directions()));
        let rank = spread.as_ref().map_or(self.parameters.len(), Spread::rank);
        let freedom = self.data.len().saturating_sub(rank);
        let chi = squares(&residuals) / freedom as f64;
        let limits = limits(problem, best);
        let mut undetermined = free.unwrap_or_default();
        let others = if undetermined.is_empty() { &found.others[..] } else { &[] };
        let mut notes = self.notes(others, freedom);
        if freedom > 0 || self.data.has_std() {
            let open = self.without_interval(&estimates, &[&limits[..], &undetermined].concat());
            undetermined.extend(open);
        }
        let rms = rms(self.data, &values);
        // As many parameters as values: each value is reached, or named as unreachable.
        let is_exact = self.data.len() == self.parameters.len();
        let deviations = Deviations::new(self.data, &values, freedom);
        let outlier = match deviations.as_ref().is_some_and(Deviations::is_in_percent) {
            true => None,
            false => outlier(problem, best, &residuals)?,
        };
        let doubted = outlier.as_deref();
        let misfit = match is_exact {
            true => None,
            false => misfit(problem, &values, doubted, &limits)?,
        };
        let misfit = misfit.or_else(|| deviations.as_ref()?.misfit(doubted));
        let other_column = match is_exact || outlier.is_some() || misfit.is_some() {
            true => None,
            false => other_stiffness(problem, best, &values)?,
        };
        notes.extend(deviations.and_then(|deviations| deviations.note(doubted)));
        Ok(Fitted {
            model: problem.model.id().into(),
            converged: best.converged,
            rms: rms.map(|rms| if rms < ACCURACY { 0.0 } else { rms }),
            outlier,
            other_column,
            misfit,
            reduced_chi_squared: Some(chi).filter(|chi| self.data.has_std() && chi.is_finite()),
            bic: self.bic(squares(&residuals), rank),
            correlation: count.clone().map(correlation).collect(),
            parameters: estimates,
            condition: spread.as_ref().and_then(Spread::condition),
            undetermined: sentences(undetermined),
            unreachable: unreachable(problem, best, &scene, &values),
            limits: sentences(limits),
            notes,
            residuals: self.residuals(&values, &residuals),
            evaluations: 0,
        })
    }

    fn residuals(&self, values: &[f64], residuals: &[f64]) -> Vec<Residual> {
        let each = self.data.iter().zip(values.iter().zip(residuals));
        each.map(|(one, (fitted, residual))| Residual {
            row: one.row,
            column: one.measured.column(),
            measured: one.value,
            fitted: *fitted,
            residual: *residual,
        })
        .collect()
    }

    /// The Bayesian information criterion, for normal residuals of known or unknown deviation.
    fn bic(&self, squares: f64, rank: usize) -> Option<f64> {
        let count = self.data.len() as f64;
        // One value ranks no model, also where no parameter changes it.
        if self.data.len() <= rank.max(1) {
            return None;
        }
        let misfit = match self.data.has_std() {
            true => squares,
            false => count * (squares / count).max(ACCURACY * ACCURACY).ln(),
        };
        Some(misfit + rank as f64 * count.ln())
    }

    /// Remarks on parameters without an interval that no other remark explains.
    fn without_interval(&self, estimates: &[Estimate], explained: &[Remark]) -> Vec<Remark> {
        let open =
            self.parameters.iter().zip(estimates).enumerate().filter(|(place, (_, found))| {
                found.lower.is_none() && found.upper.is_none() && !concerns(explained, *place)
            });
        let remark = |(place, (parameter, _)): (usize, (&Parameter, &Estimate))| Remark {
            parameters: vec![place],
            sentence: format!(
                "{} is not determined: 95 % intervals include all values from {} to {}",
                parameter.name,
                short(parameter.bounds[0]),
                parameter.shown(parameter.bounds[1])
            ),
        };
        open.map(remark).collect()
    }

    /// Notes on missing intervals, and on other minima.
    fn notes(&self, others: &[Minimum], freedom: usize) -> Vec<String> {
        let mut notes = vec![];
        if freedom == 0 && !self.data.has_std() {
            notes.push(
                "no intervals: as many parameters as measured values, without standard deviations"
                    .into(),
            );
        }
        let other = |other: &Minimum| {
            let each = self.parameters.iter().zip(&other.coordinates);
            let each = each.map(|(p, x)| format!("{} = {}", p.name, p.shown(p.value(*x))));
            format!("{} fits the data as well", each.collect::<Vec<_>>().join(", "))
        };
        notes.extend(others.iter().map(other));
        notes
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
    let inside = |(parameter, x): (&Parameter, &f64)| {
        let [low, high] = parameter.range();
        (low..=high).contains(x)
    };
    let squares = squares(&problem.residuals(&moved)?);
    let same = squares <= best.squares * (1.0 + 1e-6) + 1e-20 * problem.data.len() as f64;
    match same && problem.parameters.iter().zip(&moved).all(inside) {
        true => Ok(Minimum { coordinates: moved, squares, ..best }),
        false => Ok(best),
    }
}
