//! The doubts about a fit, and refused input.

use std::ops::ControlFlow;

use asperity_core::{Code, ContactModel, Quantity};
use asperity_fit::{Fit, FitError, Fitted, Parameter};
use asperity_gw::GreenwoodWilliamson;
use asperity_ke::KogutEtsion;

use crate::kit::{LOADS, NAMES, TRUTH, columns, data, parameters, varied};

/// The codes and parameters of the doubts.
fn doubts(fitted: &Fitted) -> Vec<(Code, &str)> {
    fitted.findings.iter().map(|one| (one.code, &*one.field)).collect()
}

#[test]
fn stiffness_against_load_fixes_one_group_of_gw() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[0, 1]);
    let fit = Fit::new(&data, parameters(&[0, 1], 1.7), &scene).unwrap();
    let fitted = fit.run(&GreenwoodWilliamson).unwrap();
    assert_eq!(doubts(&fitted), [0, 1].map(|k| (Code::Undetermined, NAMES[k])));
    assert!(fitted.condition.is_none() && fitted.converged, "{fitted:?}");
    assert_eq!(fitted.correlation[0][1], None);
    let [radius, density] = [0, 1].map(|k| fitted.parameters[k].value);
    let group = density * radius.sqrt() / (TRUTH[1] * TRUTH[0].sqrt());
    assert!((group - 1.0).abs() < 1e-8, "{group}");
    assert!(fitted.parameters.iter().all(|p| p.lower.is_none() && p.upper.is_none()));
    // Of the values that fit, those nearest to the start: 1.7 times the truth, less the part that
    // the data do not allow, which is shared by the exponents 1/2 and 1.
    let excess = 1.7f64.ln() * 1.5 / 1.25;
    for (found, exponent) in [(radius / TRUTH[0], 0.5), (density / TRUTH[1], 1.0)] {
        let wanted = 1.7 * (-excess * exponent).exp();
        assert!((found / wanted - 1.0).abs() < 1e-5, "{found} {wanted}");
    }
}

#[test]
fn a_number_without_effect_is_named() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2, 3]);
    let fit = Fit::new(&data, parameters(&[2, 3], 1.7), &scene).unwrap();
    let fitted = fit.run(&GreenwoodWilliamson).unwrap();
    assert_eq!(doubts(&fitted), [(Code::Undetermined, NAMES[3])]);
    let std = fitted.parameters[0].value;
    assert!((std / TRUTH[2] - 1.0).abs() < 1e-8, "{std}");
}

fn inverse(value: f64, model: &dyn ContactModel, free: &[usize]) -> Fitted {
    let columns = [("pressure_Pa", 5e6), ("area_fraction", value)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    let data = data(&columns);
    let scene = varied(free);
    Fit::new(&data, parameters(free, 1.0), &scene).unwrap().run(model).unwrap()
}

#[test]
fn a_value_that_is_not_reached_leaves_the_parameter_at_a_bound() {
    // Contacts of KE carry at most the hardness; GW has none.
    for (value, model) in [(0.001, &KogutEtsion as &dyn ContactModel), (0.9, &GreenwoodWilliamson)]
    {
        let found = inverse(value, model, &[2]);
        assert_eq!(doubts(&found), [(Code::Limits, NAMES[2])], "{found:?}");
        assert!(found.rms > Some(0.1), "{found:?}");
    }
    // The bound of a free hardness counts.
    let found = inverse(0.002, &KogutEtsion, &[3]);
    let hardness = found.parameters[0].value;
    assert!(found.rms < Some(1e-9) && hardness > 2.5e9 && hardness < 60e9, "{hardness:e}");
}

#[test]
fn one_value_and_one_parameter_answer_the_inverse_question() {
    let found = inverse(0.004, &KogutEtsion, &[2]);
    assert!(found.findings.is_empty(), "{found:?}");
    assert!((found.residuals[0].fitted / 0.004 - 1.0).abs() < 1e-9, "{found:?}");
    assert_eq!((found.bic, found.parameters[0].lower), (None, None));
}

#[test]
fn loads_and_pressures_of_a_row_must_agree() {
    let columns = [("load_N", 100.0), ("pressure_Pa", 1e6), ("area_m2", 4e-8)];
    let columns = columns.map(|(name, value)| (name.to_string(), vec![Some(value)]));
    let data = data(&columns);
    assert_eq!(data.check_loads(1e-4), Ok(()));
    assert_eq!(data.check_loads(1.004e-4), Ok(()), "rounded");
    insta::assert_snapshot!(data.check_loads(5e-5).unwrap_err());
}

#[test]
fn a_fit_ends_where_its_caller_says() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS, &[Quantity::Tangent]));
    let scene = varied(&[2]);
    let fit = Fit::new(&data, parameters(&[2], 1.7), &scene).unwrap();
    let mut last = 0;
    let ended = fit.run_with(&GreenwoodWilliamson, &mut |progress| {
        last = progress.evaluations;
        if last < 7 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    assert_eq!((ended, last), (Err(FitError::Interrupted), 7));
}

#[test]
fn parameters_and_data_that_make_no_fit_are_refused() {
    let data = data(&columns(&GreenwoodWilliamson, &LOADS[..2], &[Quantity::Tangent]));
    let scene = varied(&[0, 1, 2]);
    let refused = |free: Vec<Parameter>| Fit::new(&data, free, &scene).err().unwrap().to_string();
    let refused = [vec![], parameters(&[1, 1], 1.0), parameters(&[0, 1, 2], 1.0)].map(refused);
    insta::assert_snapshot!(refused.join("\n"));
    for (bounds, scale) in [([2.0, 1.0], 1.0), ([1.0, f64::NAN], 1.0), ([-1.0, 1.0], 0.0)] {
        assert!(Parameter::new(NAMES[0], "m", 1.0, bounds, scale).is_err(), "{bounds:?}");
    }
    assert!(Parameter::new("series_compliance", "m/N", 0.0, [-1e-9, 1e-9], 1e-9).is_err());
}
