//! Data that no value of the parameters reaches, and the reason.

use asperity_core::{ContactModel, Quantity, Scene, Tolerance, short};

use crate::problem::{Minimum, Problem};
use crate::{Data, Measured, Observation};

/// Averages of laws reach the hardness within this share.
const MARGIN: f64 = 0.02;
/// A value that is farther away than this, relative, is not reached.
const REACHED: f64 = 1e-6;

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

/// The largest hardness within the bounds, for a model whose contacts carry at most the hardness.
fn largest_hardness(problem: &Problem<'_>, scene: &Scene) -> Option<f64> {
    let own = |key: &str| problem.parameters.iter().find(|parameter| parameter.name.ends_with(key));
    let hardness = scene.asperity().ok()?.hardness?;
    if own("yield_strength").is_some() || !is_limited(problem.model, scene, hardness) {
        return None;
    }
    Some(own("hardness").map_or(hardness, |parameter| parameter.bounds[1]))
}

/// Whether the mean pressure of an asperity stays below the hardness, which elastic laws exceed.
fn is_limited(model: &dyn ContactModel, scene: &Scene, hardness: f64) -> bool {
    let law = |quantity| {
        let asperity = scene.asperity().ok()?;
        model.law(&asperity, quantity, Tolerance::default()).ok().zip(Some(asperity))
    };
    let Some(((force, asperity), (area, _))) = law(Quantity::Force).zip(law(Quantity::Area)) else {
        return false;
    };
    let Ok(critical) = asperity.critical_interference() else { return false };
    (0..=20).all(|k| {
        let interference = critical * 10f64.powf(0.25 * f64::from(k));
        let values = force.value(interference).ok().zip(area.value(interference).ok());
        values.is_some_and(|(force, area)| force <= (1.0 + MARGIN) * hardness * area)
    })
}

/// The reason why an area is too small for its load, where contacts carry at most the hardness.
fn below_hardness(one: &Observation, scene: &Scene, hardness: f64) -> Option<String> {
    let pressure = one.at.pressure(scene)?;
    let Measured::Quantity(quantity) = one.measured else { return None };
    let load = pressure * scene.nominal_area;
    let (mean_pressure, bound): (fn(f64, f64) -> f64, _) = match quantity {
        Quantity::AreaFraction => (
            |carried, value| carried / value,
            format!("at least p/H = {}", short(pressure / hardness)),
        ),
        Quantity::Area => (
            |carried, value| carried / value,
            format!("at least F/H = {} m2", short(load / hardness)),
        ),
        Quantity::MeanPressure => (|_, value| value, format!("at most {} Pa", short(hardness))),
        _ => return None,
    };
    let carried = if quantity == Quantity::Area { load } else { pressure };
    let needed = mean_pressure(carried, one.value);
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
        "{} cannot be reached within the bounds: the nearest is {} at {}",
        described(one),
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
