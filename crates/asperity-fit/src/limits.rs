//! Limits at which parameters stop: bounds, and the ends of the range where values exist.

use asperity_core::{AsWritten, ContactError, Dialect, short};

use crate::Parameter;
use crate::problem::{Minimum, Problem};
use crate::remark::Remark;

/// A coordinate this near a bound, relative to the range, is at the bound.
const AT_BOUND: f64 = 1e-6;
/// A coordinate this near the end of the values, relative to the range, is at the end.
const AT_END: f64 = 1e-5;
/// How far beyond an end the reason is given, as a coordinate: near the end itself, the number and
/// its limit read the same.
const BEYOND: f64 = 0.05;

/// A remark on each parameter at a limit.
pub(crate) fn limits(problem: &Problem<'_>, minimum: &Minimum) -> Vec<Remark> {
    let each = problem.parameters.iter().enumerate();
    let each = each.flat_map(|(place, parameter)| {
        [false, true].map(|upper| {
            let sentence = limit(problem, minimum, place, parameter, upper)?;
            Some(Remark { parameters: vec![place], sentence })
        })
    });
    each.flatten().collect()
}

fn limit(
    problem: &Problem<'_>,
    minimum: &Minimum,
    place: usize,
    parameter: &Parameter,
    upper: bool,
) -> Option<String> {
    let (name, [low, high]) = (&parameter.name, parameter.range());
    let middle = *minimum.coordinates.get(place)?;
    let (bound, value) =
        if upper { (high, parameter.bounds[1]) } else { (low, parameter.bounds[0]) };
    if (middle - bound).abs() < AT_BOUND * (high - low) {
        let word = if upper { "upper" } else { "lower" };
        return Some(format!("{name} is at its {word} bound of {}", parameter.shown(value)));
    }
    let reason = |distance: f64| {
        let mut moved = minimum.coordinates.clone();
        let step = if upper { distance } else { -distance };
        *moved.get_mut(place)? = (middle + step).clamp(low, high);
        problem.predicted(&moved).err()
    };
    let near = reason(AT_END * (high - low))?;
    let far = reason(BEYOND).unwrap_or(near);
    let (here, side) =
        (parameter.shown(parameter.value(middle)), if upper { "above" } else { "below" });
    Some(format!("{name} stops at {here}: {side} it, {}", plain(&far)))
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
