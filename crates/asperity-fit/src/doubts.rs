//! Doubts about a minimum, as they are found.

use asperity_core::{Finding, Quantity, Severity, short};

use crate::combinations::undetermined;
use crate::distance::{LARGEST_DEVIATIONS, LARGEST_RMS, distance, rms};
use crate::doubt::{
    Doubts, MISFIT, NOT_CONVERGED, NOTES, OTHER_COLUMN, UNDETERMINED, doubt, rounded,
};
use crate::outlier::contradicted_lines;
use crate::problem::squares;
use crate::ranking::bic;
use crate::solution::Solution;
use crate::spread::Spread;
use crate::{FitError, Measured, Observation, Parameter};

/// Residuals beyond this many standard deviations, as a root mean square, deserve a note.
const MANY: f64 = 5.0;
/// Stiffnesses that are taken for each other: on loading, and at the start of unloading.
const STIFFNESSES: [Quantity; 3] =
    [Quantity::Tangent, Quantity::UnloadingStiffness, Quantity::Stiffness];
/// Largest share of the misfit that another stiffness leaves which explains the data: errors of the
/// model itself make smaller differences.
const SHARE_OF_OTHER: f64 = 0.6;
/// Least difference of the Bayesian criterion in favour of a stiffness that explains the data: odds
/// of 150 to 1, which the scatter of a few data does not give.
const CLEAR: f64 = 10.0;
/// Evaluations for each free parameter before the search with another stiffness gives up.
const PATIENCE: usize = 60;

impl Solution<'_> {
    /// All doubts. A reason is not searched for where another one is known: an outlier before a
    /// unit, and another stiffness only of data that are described.
    pub(crate) fn doubts(&self) -> Result<Doubts, FitError> {
        let data = self.problem.data;
        // As many parameters as values: each value is reached, or named as unreachable.
        let is_exact = data.len() == self.problem.parameters.len();
        let limits = self.limits();
        let mut found = self.of_parameters(&limits);
        found.extend_from_slice(&limits);
        found.extend(self.unreachable(is_exact));
        let fitted = (&self.values[..], &self.residuals[..]);
        let outlier = contradicted_lines(self.problem, &self.found.best, fitted)?;
        let misfit = match is_exact {
            true => None,
            false => self.misfit(outlier.as_ref(), &limits),
        };
        if let Some(ratio) = self.deviations().filter(|_| outlier.is_none()) {
            let [shown, chi] = [ratio, ratio * ratio].map(short);
            let text = format!(
                "the residuals are {shown} times the standard deviations (reduced chi squared {chi}); intervals are too narrow; check the standard deviations, or leave them out"
            );
            found.push(doubt(NOTES, "residuals", ratio, text).severity(Severity::Note));
        }
        found.extend(outlier);
        // At a limit a number or unit is wrong, which the law of another stiffness may hide.
        if misfit.is_none() && !is_exact && limits.is_empty() {
            found.extend(self.other_stiffness()?);
        }
        if misfit.is_some() {
            // Where nothing is described, the end of the search means nothing.
            found.retain(|one| one.code != NOT_CONVERGED);
        }
        found.extend(misfit);
        Ok(Doubts::new(found))
    }

    /// Doubts about parameters beside their limits, which explain some of them.
    fn of_parameters(&self, limits: &[Finding]) -> Vec<Finding> {
        let (problem, best) = (self.problem, &self.found.best);
        let note = |field, text| doubt(NOTES, field, f64::NAN, text).severity(Severity::Note);
        let has_intervals = self.freedom > 0 || problem.data.has_std();
        let free = self.spread.as_ref().map(Spread::free_directions);
        let mut found = free.map_or(vec![], |free| undetermined(problem.parameters, &free));
        let is_determined = found.is_empty();
        if has_intervals {
            let known = limits.iter().chain(&found).flat_map(|one| one.field.split(", "));
            let known: Vec<String> = known.map(Into::into).collect();
            for (parameter, estimate) in problem.parameters.iter().zip(&self.estimates) {
                let is_open = estimate.lower.or(estimate.upper).is_none();
                if is_open && !known.contains(&parameter.name) {
                    found.push(without_interval(parameter));
                }
            }
        } else {
            found.push(note(
                "intervals",
                "no intervals: as many parameters as measured values, without standard deviations"
                    .into(),
            ));
        }
        for other in self.found.others.iter().filter(|_| is_determined) {
            let at = self.parameters_at(&other.coordinates, |_| String::new());
            found.push(note("minimum", format!("{at} fits the data as well")));
        }
        if !best.converged {
            let text = "the search did not converge: the values are the best that it found";
            found.push(doubt(NOT_CONVERGED, "", f64::NAN, text.into()));
        }
        found
    }

    /// The parameters at coordinates: `hardness = 2e9 Pa, ..`, each with more behind.
    pub(crate) fn parameters_at(&self, at: &[f64], more: impl Fn(&Parameter) -> String) -> String {
        let each = self.problem.parameters.iter().zip(at);
        let each = each
            .map(|(one, x)| format!("{} = {}{}", one.name, one.shown(one.value(*x)), more(one)));
        each.collect::<Vec<_>>().join(", ")
    }

    /// The ratio of residuals to standard deviations, if it is large.
    fn deviations(&self) -> Option<f64> {
        let ratio = (squares(&self.residuals) / self.freedom as f64).sqrt();
        let is_known = self.freedom > 0 && self.problem.data.has_std();
        (is_known && ratio > MANY && ratio.is_finite()).then_some(ratio)
    }

    /// Data that are not described by the fitted values, with the line that explains them, or else
    /// the limits.
    fn misfit(&self, outlier: Option<&Finding>, limits: &[Finding]) -> Option<Finding> {
        let (data, values) = (self.problem.data, &self.values);
        let far = distance(data, values);
        if far <= 1.0 {
            return None;
        }
        let advice = outlier.map(Finding::message).unwrap_or_else(|| {
            let check = "check the columns and their units, and the other numbers of the scene";
            let limits = limits.iter().map(Finding::message);
            limits.chain([check.into()]).collect::<Vec<_>>().join("; ")
        });
        let size = match rms(data, values) {
            _ if far.is_infinite() => "some fitted values are 0".into(),
            Some(rms) if rms > LARGEST_RMS => {
                let factor = short(rms.exp());
                format!("fitted values deviate by a factor of {factor} (root mean square)")
            }
            _ => {
                let far = short(LARGEST_DEVIATIONS * far);
                format!("fitted values deviate by {far} standard deviations (root mean square)")
            }
        };
        let text = format!("no values within the bounds describe the data: {size}; {advice}");
        Some(doubt(MISFIT, "", far, text))
    }

    /// A column of stiffnesses whose values are rather those of another one.
    fn other_stiffness(&self) -> Result<Option<Finding>, FitError> {
        let (problem, best) = (self.problem, &self.found.best);
        let Some(here) = rms(problem.data, &self.values) else { return Ok(None) };
        let of = |quantity| move |one: &Observation| one.measured == Measured::Quantity(quantity);
        let is_given = |quantity: &Quantity| problem.data.iter().any(of(*quantity));
        let (given, others): (Vec<_>, Vec<_>) = STIFFNESSES.into_iter().partition(is_given);
        let (mut least, mut found) = (SHARE_OF_OTHER * here, None);
        for (column, other) in given.iter().flat_map(|k| others.iter().map(move |o| (*k, *o))) {
            let renamed = |one: &Observation| match of(column)(one) {
                true => Some(Observation { measured: Measured::Quantity(other), ..*one }),
                false => Some(*one),
            };
            let refitted = problem.with(renamed, |problem| -> Result<_, FitError> {
                let minimum = problem.minimise_all(&best.coordinates, PATIENCE)?;
                let values = problem.predicted(&minimum.coordinates).ok();
                Ok(values.and_then(|values| rms(problem.data, &values)).zip(Some(minimum.squares)))
            });
            let Some((rms, squares)) = refitted.transpose()?.flatten() else { continue };
            let [one, two] = [best.squares, squares].map(|sum| bic(problem.data, sum, self.rank));
            if rms < least && one.zip(two).is_some_and(|(one, two)| one - two > CLEAR) {
                (least, found) = (rms, Some([column, other].map(Quantity::column)));
            }
        }
        Ok(found.map(|[column, other]| {
            let [percent, there] = [here, least].map(|rms| rounded(100.0 * rms));
            let text = format!(
                "{column} deviates by {percent} % from the fit (root mean square), and by {there} % if it is {other}; name the column by the stiffness that was measured"
            );
            doubt(OTHER_COLUMN, &column, here, text)
        }))
    }
}

fn without_interval(parameter: &Parameter) -> Finding {
    let (name, [low, high]) = (&parameter.name, parameter.bounds);
    let (from, to) = (short(low), parameter.shown(high));
    let text =
        format!("{name} is not determined: 95 % intervals include all values from {from} to {to}");
    doubt(UNDETERMINED, name, f64::NAN, text)
}
