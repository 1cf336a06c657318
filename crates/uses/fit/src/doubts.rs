//! Doubts about a fit, as findings: it did not converge, a parameter is at a bound, the data do not
//! determine a parameter.

use asperity_core::{Code, ContactError, Finding, Findings, short};

use crate::solution::Solution;

/// A coordinate this near a bound, or the end of the values, relative to the range, is there.
const AT_BOUND: f64 = 1e-6;
const AT_END: f64 = 1e-5;
/// How far beyond an end the reason is given, as a coordinate: near the end itself, the number and
/// its limit read the same.
const BEYOND: f64 = 0.05;

impl Solution<'_> {
    /// The doubts `not-converged`, `limits` and `undetermined`; the last two have the parameter and
    /// its value.
    pub(crate) fn doubts(&self) -> Findings {
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
                let reason = plain(&beyond(BEYOND).unwrap_or(near));
                Some(format!("{name} stops at {}: {side} it, {reason}", shown(middle)))
            },
        )
    }
}

/// A reason with a number of few digits.
fn plain(reason: &ContactError) -> String {
    match reason {
        ContactError::OutOfRange { field, value, required } => {
            format!("{field} would be {}: {required} is required", short(*value))
        }
        other => other.to_string(),
    }
}
