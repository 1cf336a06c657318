//! Values, intervals and residuals of a minimum, and what makes them doubtful.

use asperity_core::{Code, ContactError, Finding, Findings, short};

use crate::problem::{Minimum, Problem, squares};
use crate::spread::Spread;
use crate::{Data, Estimate, FitError, Fitted, Residual};

/// Residuals below this, relative, are errors of the values: they read 0 and rank no model.
const ACCURACY: f64 = 1e-12;
/// A coordinate this near a bound, or the end of the values, relative to the range, is there.
const AT_BOUND: f64 = 1e-6;
const AT_END: f64 = 1e-5;
/// How far beyond an end the reason is given, as a coordinate: near the end itself, the number and
/// its limit read the same.
const BEYOND: f64 = 0.05;

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

    /// The doubts `not-converged`, `limits` and `undetermined`; the last two have the parameter and
    /// its value.
    fn doubts(&self) -> Findings {
        let mut found = Findings::default();
        if !self.best.converged {
            let text = "the search did not converge: the values are the best that it found";
            found.push(Finding::warning(Code::NotConverged, "", f64::NAN).fact(text));
        }
        let has_intervals = self.freedom > 0 || self.problem.data.has_std();
        for (place, (parameter, estimate)) in
            self.problem.parameters.iter().zip(&self.estimates).enumerate()
        {
            let (name, [low, high]) = (parameter.name.clone(), parameter.bounds);
            let is_fixed = self.spread.as_ref().is_none_or(|spread| spread.fixes(place));
            let is_open = has_intervals && estimate.lower.or(estimate.upper).is_none();
            let limit = self.limit(place);
            let is_determined = is_fixed && (limit.is_some() || !is_open);
            if let Some(text) = limit {
                found.push(Finding::warning(Code::Limits, name.clone(), estimate.value).fact(text));
            }
            if !is_determined {
                let [from, to] = [short(low), parameter.shown(high)];
                let text = format!(
                    "{name} is not determined: the data fit as well with other values from {from} to {to}"
                );
                found.push(Finding::warning(Code::Undetermined, name, estimate.value).fact(text));
            }
        }
        found.into_iter().map(|one| one.of_model(self.problem.model.id())).collect()
    }

    /// The bound at which a parameter is, or the end of the range where values exist.
    fn limit(&self, place: usize) -> Option<String> {
        let (parameter, at) = (&self.problem.parameters[place], &self.best.coordinates);
        let ([low, high], name, middle) = (parameter.range(), &parameter.name, at[place]);
        let shown = |coordinate: f64| parameter.shown(parameter.value(coordinate));
        [(low, "lower", "below"), (high, "upper", "above")].into_iter().find_map(
            |(bound, kind, side)| {
                if (middle - bound).abs() < AT_BOUND * (high - low) {
                    return Some(format!("{name} is at its {kind} bound of {}", shown(bound)));
                }
                let beyond = |distance: f64| {
                    let mut moved = at.clone();
                    let step = if bound > middle { distance } else { -distance };
                    moved[place] = (middle + step).clamp(low, high);
                    self.problem.predicted(&moved).err()
                };
                let near = beyond(AT_END * (high - low))?;
                let reason = match beyond(BEYOND).unwrap_or(near) {
                    ContactError::OutOfRange { field, value, required } => {
                        format!("{field} would be {}: {required} is required", short(value))
                    }
                    other => other.to_string(),
                };
                Some(format!("{name} stops at {}: {side} it, {reason}", shown(middle)))
            },
        )
    }
}

/// Root mean square of the logarithms of fitted over measured values.
fn rms(data: &Data, values: &[f64]) -> Option<f64> {
    let ratios = data.iter().zip(values).filter(|(one, _)| !one.measured.is_difference());
    let ratios = ratios.map(|(one, value)| (value / one.value).ln());
    let finite: Vec<f64> = ratios.filter(|ratio| ratio.is_finite()).collect();
    (!finite.is_empty()).then(|| (squares(&finite) / finite.len() as f64).sqrt())
}

/// The Bayesian information criterion, for normal residuals of known or unknown deviation.
fn bic(data: &Data, squares: f64, rank: usize) -> Option<f64> {
    let count = data.len() as f64;
    // One value ranks no model, also where no parameter changes it.
    if data.len() <= rank.max(1) {
        return None;
    }
    let misfit = match data.has_std() {
        true => squares,
        false => count * (squares / count).max(ACCURACY * ACCURACY).ln(),
    };
    Some(misfit + rank as f64 * count.ln())
}
