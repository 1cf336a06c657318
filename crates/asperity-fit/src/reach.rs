//! Data that no value of the parameters reaches, and the reason.

use asperity_core::{Quantity, Scene, short};

use crate::problem::{Minimum, Problem};
use crate::{Data, Measured, Observation};

/// Laws with a hardness of their own (JG) exceed the hardness of the scene by up to 1.4 %.
const MARGIN: f64 = 0.02;
/// A value that is farther away than this, relative, is not reached.
const REACHED: f64 = 1e-6;
/// The key of the hardness.
const HARDNESS: &str = "hardness";

/// A sentence for each measured value that is out of reach.
pub(crate) fn unreachable(
    problem: &Problem<'_>,
    minimum: &Minimum,
    scene: &Scene,
    fitted: &[f64],
) -> Vec<String> {
    let mut found = vec![];
    let hardness = largest_hardness(problem, scene);
    for (one, fitted) in problem.data.iter().zip(fitted) {
        let limit = hardness.and_then(|hardness| below_hardness(one, scene, hardness));
        if let Some(reason) = limit {
            found.push(reason);
        } else if is_exact(problem.data, problem.parameters.len()) && !is_reached(one, *fitted) {
            found.push(nearest(problem, minimum, one, *fitted));
        }
    }
    found
}

/// Whether as many parameters as values should reach every value.
fn is_exact(data: &Data, parameters: usize) -> bool {
    data.len() == parameters
}

fn is_reached(one: &Observation, fitted: f64) -> bool {
    let scale = if one.measured.is_difference() { one.std.unwrap_or(1.0) } else { one.value.abs() };
    (fitted - one.value).abs() <= REACHED * scale
}

/// The largest hardness that a scene may have, for a model that yields; with whether it is free.
fn largest_hardness(problem: &Problem<'_>, scene: &Scene) -> Option<f64> {
    if problem.model.validity().holds_to == Some(1.0) || problem.model.validity().adhesive {
        return None;
    }
    let free = problem.parameters.iter().find(|parameter| parameter.name.ends_with(HARDNESS));
    let yields = problem.parameters.iter().any(|p| p.name.ends_with("yield_strength"));
    if yields {
        return None;
    }
    match free {
        Some(parameter) => Some(parameter.bounds[1]),
        None => scene.asperity().ok()?.hardness,
    }
}

/// The reason why an area is too small for its load: contacts carry at most the hardness.
fn below_hardness(one: &Observation, scene: &Scene, hardness: f64) -> Option<String> {
    let pressure = one.at.pressure(scene)?;
    let Measured::Quantity(quantity) = one.measured else { return None };
    let area = scene.nominal_area;
    let (needed, bound) = match quantity {
        Quantity::AreaFraction => {
            (pressure / one.value, format!("at least p/H = {}", short(pressure / hardness)))
        }
        Quantity::Area => {
            let least = pressure * area / hardness;
            (pressure * area / one.value, format!("at least F/H = {} m2", short(least)))
        }
        Quantity::MeanPressure => (one.value, format!("at most {} Pa", short(hardness))),
        _ => return None,
    };
    (needed > (1.0 + MARGIN) * hardness).then(|| {
        format!(
            "{} cannot be reached: contacts carry at most the hardness, so it is {bound}; the hardness would have to be at least {} Pa",
            described(one),
            short(needed)
        )
    })
}

/// The nearest value within the bounds.
fn nearest(problem: &Problem<'_>, minimum: &Minimum, one: &Observation, fitted: f64) -> String {
    let at = problem.parameters.iter().zip(&minimum.coordinates);
    let each = |(parameter, coordinate): (&crate::Parameter, &f64)| {
        let [low, high] = parameter.bounds;
        let value = parameter.value(*coordinate);
        format!(
            "{} = {} (from {} to {})",
            parameter.name,
            parameter.shown(value),
            short(low),
            parameter.shown(high)
        )
    };
    let at: Vec<String> = at.map(each).collect();
    format!(
        "{} cannot be reached within the bounds by {}: the nearest is {} at {}",
        described(one),
        problem.model.id(),
        value(one, fitted),
        at.join(", ")
    )
}

/// A measured value and its place.
fn described(one: &Observation) -> String {
    let name = match one.measured {
        Measured::Quantity(quantity) => quantity.to_string().replace('-', " "),
        Measured::Separation => "separation".into(),
    };
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
    format!("{article} {name} of {} at {}", value(one, one.value), one.at)
}

fn value(one: &Observation, value: f64) -> String {
    let unit = match one.measured {
        Measured::Quantity(quantity) => quantity.unit(),
        Measured::Separation => "m",
    };
    let gap = if unit.is_empty() { "" } else { " " };
    format!("{}{gap}{unit}", short(value))
}
