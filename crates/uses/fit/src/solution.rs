//! Values, intervals and residuals of a minimum.

use crate::problem::{Minimum, Problem, squares};
use crate::ranking::{ACCURACY, bic};
use crate::spread::Spread;
use crate::{Data, Estimate, FitError, Fitted, Residual};

/// A minimum with its values.
pub(crate) struct Solution<'s> {
    pub(crate) problem: &'s Problem<'s>,
    pub(crate) best: &'s Minimum,
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
    pub(crate) fn new(problem: &'s Problem<'s>, best: &'s Minimum) -> Result<Self, FitError> {
        let no_start = |reason| FitError::NoStart { model: problem.model.id().into(), reason };
        let values = problem.predicted(&best.coordinates).map_err(no_start)?;
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
        Ok(Self { problem, best, values, residuals, spread, estimates, rank, freedom })
    }

    /// All that is said of a fit, but for the number of evaluations.
    pub(crate) fn describe(self) -> Fitted {
        let (data, findings) = (self.problem.data, self.doubts());
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
        Fitted {
            model: self.problem.model.id().into(),
            converged: self.best.converged,
            rms: rms(data, &self.values).map(|rms| if rms < ACCURACY { 0.0 } else { rms }),
            reduced_chi_squared: Some(chi).filter(|chi| data.has_std() && chi.is_finite()),
            bic: bic(data, sum, self.rank),
            correlation: (0..count).map(correlation).collect(),
            condition: spread.and_then(Spread::condition),
            findings,
            residuals: each.map(residual).collect(),
            evaluations: 0,
            parameters: self.estimates,
        }
    }
}

/// Root mean square of the logarithms of fitted over measured values.
fn rms(data: &Data, values: &[f64]) -> Option<f64> {
    let ratios = data.iter().zip(values).filter(|(one, _)| !one.measured.is_difference());
    let ratios = ratios.map(|(one, value)| (value / one.value).ln());
    let finite: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
    (!finite.is_empty()).then(|| (squares(&finite) / finite.len() as f64).sqrt())
}
