//! Values, intervals and remarks of a minimum.

use asperity_core::short;

use crate::combinations::undetermined;
use crate::deviations::Deviations;
use crate::distance::{distance, rms};
use crate::few_contacts::few_contacts;
use crate::limits::limits;
use crate::misfit::misfit;
use crate::other_stiffness::other_stiffness;
use crate::outlier::outlier;
use crate::problem::{Minimum, Problem, squares};
use crate::ranking::{ACCURACY, bic};
use crate::reach::unreachable;
use crate::remark::{Remark, concerns, sentences};
use crate::search::Found;
use crate::spread::Spread;
use crate::{Data, Estimate, FitError, Fitted, Parameter, Residual};

/// Values, intervals and remarks of a minimum.
pub(crate) fn describe(problem: &Problem<'_>, found: &Found) -> Result<Fitted, FitError> {
    let (data, parameters) = (problem.data, problem.parameters);
    let best = &found.best;
    let no_start = |reason| FitError::NoStart { model: problem.model.id().into(), reason };
    let values = problem.predicted(&best.coordinates).map_err(no_start)?;
    let (scene, _) = problem.at(&best.coordinates).map_err(no_start)?;
    let residuals = problem.residuals(&best.coordinates)?;
    let spread = Spread::new(problem, best)?;
    let mut estimates = vec![];
    for (place, parameter) in parameters.iter().enumerate() {
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
    let count = 0..parameters.len();
    let correlation = |a: usize| {
        let with = |b: usize| spread.as_ref().and_then(|spread| spread.correlation(a, b));
        count.clone().map(with).collect()
    };
    let free = spread.as_ref().map(|spread| undetermined(parameters, &spread.free_directions()));
    let rank = spread.as_ref().map_or(parameters.len(), Spread::rank);
    let freedom = data.len().saturating_sub(rank);
    let chi = squares(&residuals) / freedom as f64;
    let limits = limits(problem, best);
    let mut undetermined = free.unwrap_or_default();
    let others = if undetermined.is_empty() { &found.others[..] } else { &[] };
    let mut notes = notes(problem, others, freedom);
    if freedom > 0 || data.has_std() {
        let open = without_interval(parameters, &estimates, &[&limits[..], &undetermined].concat());
        undetermined.extend(open);
    }
    let rms = rms(data, &values);
    // As many parameters as values: each value is reached, or named as unreachable.
    let is_exact = data.len() == parameters.len();
    let deviations = Deviations::new(data, &values, freedom);
    let outlier = match deviations.as_ref().is_some_and(Deviations::is_in_percent) {
        true => None,
        false => outlier(problem, best, &residuals)?,
    };
    let doubted = outlier.as_deref();
    let misfit = match is_exact {
        true => None,
        false => misfit(problem, &values, doubted, &limits)?,
    };
    let misfit = match misfit {
        None if !is_exact => few_contacts(problem, &best.coordinates, distance(data, &values))?,
        misfit => misfit,
    };
    let misfit = misfit.or_else(|| deviations.as_ref()?.misfit(doubted));
    // At a limit a number or unit is wrong, which the law of another stiffness may hide.
    let other_column = match is_exact || misfit.is_some() || !limits.is_empty() {
        true => None,
        false => other_stiffness(problem, best, &values, rank)?,
    };
    notes.extend(deviations.and_then(|deviations| deviations.note(doubted)));
    Ok(Fitted {
        model: problem.model.id().into(),
        converged: best.converged,
        rms: rms.map(|rms| if rms < ACCURACY { 0.0 } else { rms }),
        outlier,
        other_column,
        misfit,
        reduced_chi_squared: Some(chi).filter(|chi| data.has_std() && chi.is_finite()),
        bic: bic(data, squares(&residuals), rank),
        correlation: count.clone().map(correlation).collect(),
        parameters: estimates,
        condition: spread.as_ref().and_then(Spread::condition),
        undetermined: sentences(undetermined),
        unreachable: unreachable(problem, best, &scene, &values),
        limits: sentences(limits),
        notes,
        residuals: each_residual(data, &values, &residuals),
        evaluations: 0,
    })
}

/// Every measured value beside the fitted one.
fn each_residual(data: &Data, values: &[f64], residuals: &[f64]) -> Vec<Residual> {
    let each = data.iter().zip(values.iter().zip(residuals));
    each.map(|(one, (fitted, residual))| Residual {
        row: one.row,
        column: one.measured.column(),
        measured: one.value,
        fitted: *fitted,
        residual: *residual,
    })
    .collect()
}

/// Remarks on parameters without an interval that no other remark explains.
fn without_interval(
    parameters: &[Parameter],
    estimates: &[Estimate],
    explained: &[Remark],
) -> Vec<Remark> {
    let open = parameters.iter().zip(estimates).enumerate().filter(|(place, (_, found))| {
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
fn notes(problem: &Problem<'_>, others: &[Minimum], freedom: usize) -> Vec<String> {
    let mut notes = vec![];
    if freedom == 0 && !problem.data.has_std() {
        notes.push(
            "no intervals: as many parameters as measured values, without standard deviations"
                .into(),
        );
    }
    let other = |other: &Minimum| {
        let each = problem.parameters.iter().zip(&other.coordinates);
        let each = each.map(|(p, x)| format!("{} = {}", p.name, p.shown(p.value(*x))));
        format!("{} fits the data as well", each.collect::<Vec<_>>().join(", "))
    };
    notes.extend(others.iter().map(other));
    notes
}
