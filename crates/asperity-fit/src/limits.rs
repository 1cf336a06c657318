//! Limits: parameters at the ends of their ranges, and values that none of them reach.

use asperity_core::{AsWritten, ContactError, Dialect, Finding, Quantity, Tolerance, short};

use crate::doubt::{LIMITS, UNREACHABLE, doubt, with_unit};
use crate::solution::Solution;
use crate::{Measured, Observation, Parameter};

/// Averages of laws reach the hardness within this share.
const MARGIN: f64 = 0.02;
/// A value that is farther away than this, relative, is not reached.
const REACHED: f64 = 1e-6;
/// A coordinate this near a bound, or the end of the values, relative to the range, is there.
const AT_BOUND: f64 = 1e-6;
const AT_END: f64 = 1e-5;
/// How far beyond an end the reason is given, as a coordinate: near the end itself, the number and
/// its limit read the same.
const BEYOND: f64 = 0.05;

impl Solution<'_> {
    /// A parameter at a bound, or at the end of the range where values exist.
    pub(crate) fn limits(&self) -> Vec<Finding> {
        let at = &self.found.best.coordinates;
        let mut found = vec![];
        for (place, parameter) in self.problem.parameters.iter().enumerate() {
            let ([low, high], name, middle) = (parameter.range(), &parameter.name, at[place]);
            let shown = |coordinate: f64| parameter.shown(parameter.value(coordinate));
            for (bound, kind, side) in [(low, "lower", "below"), (high, "upper", "above")] {
                let beyond = |distance: f64| {
                    let mut moved = at.clone();
                    let step = if bound > middle { distance } else { -distance };
                    moved[place] = (middle + step).clamp(low, high);
                    self.problem.predicted(&moved).err()
                };
                let text = if (middle - bound).abs() < AT_BOUND * (high - low) {
                    format!("{name} is at its {kind} bound of {}", shown(bound))
                } else if let Some(near) = beyond(AT_END * (high - low)) {
                    let reason = plain(&beyond(BEYOND).unwrap_or(near));
                    format!("{name} stops at {}: {side} it, {reason}", shown(middle))
                } else {
                    continue;
                };
                found.push(doubt(LIMITS, name, parameter.value(middle), text));
            }
        }
        found
    }

    /// Measured values that no parameters reach.
    pub(crate) fn unreachable(&self, is_exact: bool) -> Vec<Finding> {
        let hardness = self.largest_hardness();
        let bounds = |one: &Parameter| {
            let [low, high] = one.bounds;
            format!(" (from {} to {})", short(low), one.shown(high))
        };
        let mut found = vec![];
        for (one, nearest) in self.problem.data.iter().zip(&self.values) {
            let is_far = || is_exact && !is_reached(one, *nearest);
            let reason = match hardness.and_then(|hardness| self.above(one, hardness)) {
                Some(reason) => format!(": {reason}"),
                None if is_far() => format!(
                    " within the bounds: the nearest is {} at {}",
                    with_unit(*nearest, one.measured.unit()),
                    self.parameters_at(&self.found.best.coordinates, bounds)
                ),
                None => continue,
            };
            let (column, value) = (one.measured.column(), short(one.value));
            let text = format!("{column} = {value} at {} cannot be reached{reason}", one.at);
            found.push(doubt(UNREACHABLE, &column, one.value, text));
        }
        found
    }

    /// The largest hardness within the bounds, for a model whose contacts carry at most the
    /// hardness: the mean pressure of an asperity stays below it, which elastic laws exceed.
    fn largest_hardness(&self) -> Option<f64> {
        let free = |key| self.problem.parameters.iter().find(|one| one.name.ends_with(key));
        let asperity = self.scene.asperity().ok()?;
        let hardness = asperity.hardness.filter(|_| free("yield_strength").is_none())?;
        let law = |quantity| self.problem.model.law(&asperity, quantity, Tolerance::default()).ok();
        let (force, area) = law(Quantity::Force).zip(law(Quantity::Area))?;
        let critical = asperity.critical_interference().ok()?;
        let is_limited = (0..=20).all(|k| {
            let interference = critical * 10f64.powf(0.25 * f64::from(k));
            let values = force.value(interference).ok().zip(area.value(interference).ok());
            values.is_some_and(|(force, area)| force <= (1.0 + MARGIN) * hardness * area)
        });
        is_limited.then(|| free("hardness").map_or(hardness, |one| one.bounds[1]))
    }

    /// The reason why a value is out of reach where contacts carry at most the hardness.
    fn above(&self, one: &Observation, hardness: f64) -> Option<String> {
        let Measured::Quantity(quantity) = one.measured else { return None };
        let pressure = one.at.pressure(&self.scene)?;
        let load = pressure * self.scene.nominal_area;
        let (needed, bound) = match quantity {
            Quantity::AreaFraction => {
                (pressure / one.value, format!("at least p/H = {}", short(pressure / hardness)))
            }
            Quantity::Area => {
                (load / one.value, format!("at least F/H = {} m2", short(load / hardness)))
            }
            Quantity::MeanPressure => (one.value, format!("at most {} Pa", short(hardness))),
            _ => return None,
        };
        let reason = format!(
            "contacts carry at most the hardness, so it is {bound}; the hardness would have to be at least {} Pa",
            short(needed)
        );
        (needed > (1.0 + MARGIN) * hardness).then_some(reason)
    }
}

/// A reason with a number of few digits.
fn plain(reason: &ContactError) -> String {
    match reason {
        ContactError::OutOfRange { field, value, required } => {
            let required = AsWritten.say(required);
            format!("{field} would be {}: {required} is required", short(*value))
        }
        other => other.to_string(),
    }
}

fn is_reached(one: &Observation, fitted: f64) -> bool {
    let scale = if one.measured.is_difference() { one.std.unwrap_or(1.0) } else { one.value.abs() };
    (fitted - one.value).abs() <= REACHED * scale
}
