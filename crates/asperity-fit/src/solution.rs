//! Values, intervals and residuals of a minimum.

use asperity_core::{Findings, Scene};

use crate::distance::rms;
use crate::problem::{Problem, squares};
use crate::ranking::{ACCURACY, bic};
use crate::search::Found;
use crate::spread::Spread;
use crate::{Estimate, FitError, Fitted, Residual};

/// A minimum with its values, of which there may be doubts.
pub(crate) struct Solution<'s> {
    pub(crate) problem: &'s Problem<'s>,
    pub(crate) found: &'s Found,
    pub(crate) scene: Scene,
    /// The fitted values.
    pub(crate) values: Vec<f64>,
    pub(crate) residuals: Vec<f64>,
    /// `None` where derivatives are not finite.
    pub(crate) spread: Option<Spread>,
    pub(crate) estimates: Vec<Estimate>,
    /// Combinations of parameters that the data fix, and the values beyond these.
    pub(crate) rank: usize,
    pub(crate) freedom: usize,
}

impl<'s> Solution<'s> {
    pub(crate) fn new(problem: &'s Problem<'s>, found: &'s Found) -> Result<Self, FitError> {
        let best = &found.best;
        let no_start = |reason| FitError::NoStart { model: problem.model.id().into(), reason };
        let values = problem.predicted(&best.coordinates).map_err(no_start)?;
        let (scene, _) = problem.at(&best.coordinates).map_err(no_start)?;
        let residuals = problem.residuals(&best.coordinates)?;
        let spread = Spread::new(problem, best)?;
        let mut estimates = vec![];
        for (place, parameter) in problem.parameters.iter().enumerate() {
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
        let rank = spread.as_ref().map_or(problem.parameters.len(), Spread::rank);
        let freedom = problem.data.len().saturating_sub(rank);
        Ok(Self { problem, found, scene, values, residuals, spread, estimates, rank, freedom })
    }

    /// All that is said of a fit, but for the number of evaluations.
    pub(crate) fn describe(self) -> Result<Fitted, FitError> {
        let (data, best, doubts) = (self.problem.data, &self.found.best, self.doubts()?);
        let (spread, count) = (self.spread.as_ref(), self.estimates.len());
        let correlation = |a: usize| {
            (0..count).map(|b| spread.and_then(|spread| spread.correlation(a, b))).collect()
        };
        let sum = squares(&self.residuals);
        let chi = sum / self.freedom as f64;
        let each = data.iter().zip(self.values.iter().zip(&self.residuals));
        let residual = |(one, (fitted, residual)): (&crate::Observation, (&f64, &f64))| Residual {
            row: one.row,
            column: one.measured.column(),
            measured: one.value,
            fitted: *fitted,
            residual: *residual,
        };
        Ok(Fitted {
            model: self.problem.model.id().into(),
            converged: best.converged,
            rms: rms(data, &self.values).map(|rms| if rms < ACCURACY { 0.0 } else { rms }),
            reduced_chi_squared: Some(chi).filter(|chi| data.has_std() && chi.is_finite()),
            bic: bic(data, sum, self.rank),
            correlation: (0..count).map(correlation).collect(),
            condition: spread.and_then(Spread::condition),
            doubts,
            residuals: each.map(residual).collect(),
            same_as: None,
            unusual: Findings::default(),
            is_elastic: self.problem.model.validity().holds_to.is_some_and(|to| to <= 1.0),
            evaluations: 0,
            parameters: self.estimates,
        })
    }
}
