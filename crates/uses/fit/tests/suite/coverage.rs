//! Intervals hold the truth as often as they say.

use asperity_core::{ContactModel, Quantity};
use asperity_fit::{DataColumn, Fit};
use asperity_gw::GreenwoodWilliamson;
use asperity_ke::KogutEtsion;

use crate::kit::{TRUTH, columns, data, is_long, normal, parameters, varied};

/// Relative standard deviation of the noise.
const NOISE: f64 = 0.03;

/// How many of the draws have the truth in the interval of each parameter.
fn held(
    model: &dyn ContactModel,
    (free, draws): (&[usize], u64),
    clean: &[DataColumn],
    std: bool,
) -> Vec<usize> {
    let mut held = vec![0; free.len()];
    for draw in 0..draws {
        let mut state = 1000 * free.len() as u64 + draw;
        let mut noisy = clean.to_vec();
        for (name, values) in noisy.iter_mut().skip(1).filter(|column| !column.0.ends_with("_std"))
        {
            let _ = name;
            for value in values.iter_mut().flatten() {
                *value *= (NOISE * normal(&mut state)).exp();
            }
        }
        if std {
            let deviation = |(name, values): &DataColumn| {
                let of = |value: &Option<f64>| value.map(|value| NOISE * value);
                (format!("{name}_std"), values.iter().map(of).collect())
            };
            let deviations: Vec<DataColumn> = clean.iter().skip(1).map(deviation).collect();
            noisy.extend(deviations);
        }
        let data = data(&noisy);
        let scene = varied(free);
        let mut fit = Fit::new(&data, parameters(free, 1.2), &scene).unwrap();
        fit.more_starts = 0;
        let fitted = fit.run(model).unwrap();
        assert!(fitted.converged, "{fitted:?}");
        for (place, (estimate, truth)) in
            fitted.parameters.iter().zip(free.iter().map(|place| TRUTH[*place])).enumerate()
        {
            let above = estimate.lower.is_none_or(|lower| lower <= truth);
            let below = estimate.upper.is_none_or(|upper| truth <= upper);
            held[place] += usize::from(above && below);
        }
    }
    held
}

fn assert_covers(model: &dyn ContactModel, free: &[usize], quantities: &[Quantity], std: bool) {
    let clean = columns(model, &[1.0, 5.0, 25.0, 125.0, 625.0], quantities);
    let (draws, hold) = if is_long() { (100, 90..=98) } else { (25, 21..=25) };
    let held = held(model, (free, draws), &clean, std);
    assert!(held.iter().all(|held| hold.contains(held)), "{free:?}: {held:?} of {draws}");
}

#[test]
fn intervals_of_one_parameter_hold_the_truth() {
    assert_covers(&KogutEtsion, &[2], &[Quantity::Tangent], false);
}

#[test]
fn intervals_of_two_parameters_hold_the_truth() {
    let quantities = [Quantity::Area, Quantity::Tangent];
    assert_covers(&KogutEtsion, &[0, 2], &quantities, true);
}

#[test]
fn intervals_of_three_parameters_hold_the_truth() {
    let quantities = [Quantity::Area, Quantity::Tangent];
    assert_covers(&GreenwoodWilliamson, &[0, 1, 2], &quantities, false);
}
